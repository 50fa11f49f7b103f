#include "armtol/map/found.h"

#include "armtol/answer.h"
#include "console/exit_code.h"
#include "console/interrupt.h"
#include "console/message.h"
#include "console/progress.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* So many points are asked about at a time: between them an interrupt is looked for. */
enum { AT_ONCE = 512 };

static size_t joints_of(const map_plan *plan)
{
    return armtol_arm_joint_count(&plan->request->arm);
}

static bool get_memory(const map_plan *plan, map_found *found)
{
    const size_t count = map_plan_count(plan);
    *found = (map_found){.q = calloc(count, (joints_of(plan) + 1) * sizeof *found->q)};
    found->marks = calloc(count, sizeof *found->marks);
    found->values = calloc(count, sizeof *found->values);
    return found->q != NULL && found->marks != NULL && found->values != NULL;
}

void map_found_free(map_found *found)
{
    free(found->q);
    free(found->marks);
    free(found->values);
}

bool map_is_reached(const map_found *found, size_t point)
{
    return (found->marks[point] & ARMTOL_MAP_REACHED) != 0;
}

/* ---- joint values ---- */

static bool look_on(void *context, size_t done, size_t total)
{
    (void)total;
    progress_show(context, done);
    return !interrupt_came();
}

static armtol_map_plane plane_of(const map_plan *plan)
{
    armtol_map_plane plane = {.n_across = plan->n[0], .n_up = plan->n[1], .axes = armtol_transform_identity(),
                              .point_only = !plan->keeps_axes};
    map_plan_point(plan, 0, plane.first);
    plane.across[plan->right] = (plan->last[0] - plan->first[0]) / (double)(plan->n[0] - 1);
    plane.up[plan->up] = (plan->last[1] - plan->first[1]) / (double)(plan->n[1] - 1);
    for (int i = 0; i < 3 && plan->keeps_axes; i++) {
        memcpy(plane.axes.m[i], plan->axes[i], sizeof plan->axes[i]);
    }
    return plane;
}

static int interrupted(void)
{
    message("interrupted; nothing is written");
    return EXIT_FAILED;
}

/* The posture to begin with. Where --at left the branch to the arm's own inverse kinematics, so does the map. */
static const double *near_of(const request *request)
{
    const bool own = request->taken != NULL && request->taken[0].own;
    return request->question.n_poses > 0 && !own ? request->q : NULL;
}

static armtol_status find_poses(const armtol_inverse_setup *setup, const armtol_map_plane *plane,
                                const map_share *share, progress *bar, map_found *found)
{
    if (share == NULL) {
        return armtol_map_poses(setup, plane, look_on, bar, found->q, found->marks);
    }
    const armtol_map_search search = {share->first, share->count, share->searched,
                                      share->known != NULL ? share->known->q : NULL};
    return armtol_map_poses_in_parts(setup, plane, &search, look_on, bar, found->q, found->marks);
}

static int reach_points(const map_plan *plan, const map_share *share, progress *bar, map_found *found)
{
    const request *request = plan->request;
    const armtol_map_plane plane = plane_of(plan);
    armtol_inverse_setup setup = {.arm = &request->arm, .ignore_limits = request->options->ignore_limits,
                                  .near = near_of(request)};
    memcpy(setup.offset, request->question.tool.offset, sizeof setup.offset);
    progress_start(bar, "points reached for", map_plan_count(plan));
    const armtol_status status = find_poses(&setup, &plane, share, bar, found);
    progress_end(bar);
    if (status == ARMTOL_NO_MEMORY) {
        out_of_memory();
        return EXIT_FAILED;
    }
    if (status != ARMTOL_OK) {
        message("%s: %s", request->arm.name, armtol_status_text(status));
        return EXIT_WRONG;
    }
    return interrupt_came() ? interrupted() : EXIT_OK;
}

/* ---- values ---- */

/*
 * What the parts may be off by after an answer. That of a motor whose drive is known is left to the drive, which is
 * asked about anew in each point, unless --given says more.
 */
static double tolerance_of(const armtol_answer *answer, const request *request, size_t k)
{
    const double least = request->least[k], largest = request->largest[k];
    return !answer->given[k] ? answer->tolerances[k] : least == largest ? least : 0;
}

/* The tolerances that the pose or poses of the command line ask for. */
static int ask_tolerances(const request *request, double **tolerances)
{
    armtol_answer *answer;
    *tolerances = calloc(request->n_columns, sizeof **tolerances);
    if (*tolerances == NULL) {
        out_of_memory();
        return EXIT_FAILED;
    }
    const int code = request_answer(request, &answer);
    for (size_t k = 0; k < request->n_columns && code == EXIT_OK; k++) {
        (*tolerances)[k] = tolerance_of(answer, request, k);
    }
    if (code == EXIT_OK) {
        armtol_answer_destroy(answer);
    }
    return code;
}

static bool is_known(const map_plan *plan, const tally_rows *known, const map_found *found, size_t point)
{
    const size_t n = joints_of(plan);
    return !map_is_reached(found, point) ||
           ((known->points[point] & ROWS_REACHED) != 0 &&
            memcmp(known->q + point * n, found->q + point * n, n * sizeof *found->q) == 0);
}

/*
 * Values that others found: of every point that is reached, at the very joint values that it has here. False where one
 * is missing. An arm without joints has the same value in all points.
 */
static bool take_known(const map_plan *plan, const map_share *share, size_t first, size_t count, map_found *found)
{
    bool known = share != NULL && share->known != NULL && joints_of(plan) > 0;
    for (size_t k = first; k < first + count && known; k++) {
        known = is_known(plan, share->known, found, k);
        found->values[k] = map_is_reached(found, k) ? share->known->values[k] : (double)NAN;
    }
    return known;
}

static bool find_some(const map_plan *plan, armtol_question *question, size_t first, map_found *found,
                      armtol_fault *fault)
{
    question->q = found->q + first * joints_of(plan);
    return armtol_map_values(question, &plan->map, found->values + first, fault) == ARMTOL_OK;
}

static int find_values(const map_plan *plan, const map_share *share, const armtol_question *asked, progress *bar,
                       map_found *found)
{
    const size_t begin = share != NULL ? share->first : 0, count = share != NULL ? share->count : map_plan_count(plan);
    armtol_question question = *asked;
    progress_start(bar, "points", count);
    for (size_t done = 0; done < count; done += question.n_poses) {
        const size_t first = begin + done;
        armtol_fault fault;
        question.n_poses = count - done < AT_ONCE ? count - done : AT_ONCE;
        if (!take_known(plan, share, first, question.n_poses, found) &&
            !find_some(plan, &question, first, found, &fault)) {
            progress_end(bar);
            return request_failed(plan->request, &fault);
        }
        progress_show(bar, done + question.n_poses);
        if (interrupt_came()) {
            progress_end(bar);
            return interrupted();
        }
    }
    progress_end(bar);
    return EXIT_OK;
}

static int ask_values(const map_plan *plan, const map_share *share, progress *bar, map_found *found)
{
    armtol_question question = plan->request->question;
    double *tolerances = NULL;
    int code = EXIT_OK;
    if (plan->map.value == ARMTOL_MAP_WORST && question.tolerances == NULL) {
        code = ask_tolerances(plan->request, &tolerances);
        question.tolerances = tolerances;
        question.least = question.largest = NULL;
    }
    if (code == EXIT_OK) {
        code = find_values(plan, share, &question, bar, found);
    }
    free(tolerances);
    return code;
}

static bool is_seam(const map_found *found, size_t point, size_t neighbour, int joined)
{
    return map_is_reached(found, point) && map_is_reached(found, neighbour) && (found->marks[point] & joined) == 0;
}

bool map_is_seam_next(const map_plan *plan, const map_found *found, size_t point)
{
    return point % plan->n[0] + 1 < plan->n[0] && is_seam(found, point, point + 1, ARMTOL_MAP_JOINS_NEXT);
}

bool map_is_seam_above(const map_plan *plan, const map_found *found, size_t point)
{
    return point / plan->n[0] + 1 < plan->n[1] && is_seam(found, point, point + plan->n[0], ARMTOL_MAP_JOINS_ABOVE);
}

static void sum_up(const map_plan *plan, map_found *found)
{
    for (size_t k = 0; k < map_plan_count(plan); k++) {
        const double value = found->values[k];
        found->n_reached += map_is_reached(found, k);
        found->n_seams += (size_t)map_is_seam_next(plan, found, k) + (size_t)map_is_seam_above(plan, found, k);
        if (isfinite(value)) {
            found->least = found->n_values == 0 || value < found->values[found->least] ? k : found->least;
            found->most = found->n_values == 0 || value > found->values[found->most] ? k : found->most;
            found->n_values++;
        }
    }
}

static int find(const map_plan *plan, const map_share *share, map_found *found)
{
    progress bar;
    if (!get_memory(plan, found)) {
        out_of_memory();
        return EXIT_FAILED;
    }
    int code = reach_points(plan, share, &bar, found);
    if (code == EXIT_OK) {
        code = ask_values(plan, share, &bar, found);
    }
    if (code == EXIT_OK) {
        sum_up(plan, found);
    }
    return code;
}

int map_find(const map_plan *plan, const map_share *share, map_found *found)
{
    struct sigaction before;
    interrupt_watch(&before);
    const int code = find(plan, share, found);
    interrupt_restore(&before);
    if (code != EXIT_OK) {
        map_found_free(found);
    }
    return code;
}

/* ---- looking at it ---- */

double map_joint_shown(const map_plan *plan, const map_found *found, size_t point, size_t joint)
{
    const armtol_arm *arm = &plan->request->arm;
    const size_t n = joints_of(plan);
    const bool slides = arm->links[armtol_arm_link_of(arm, joint)].joint == ARMTOL_PRISMATIC;
    return units_shown(&plan->request->units, slides, found->q[point * n + joint]);
}

bool map_is_of_tolerances(const map_plan *plan)
{
    return plan->map.value == ARMTOL_MAP_TOLERANCE;
}

size_t map_worst_point(const map_plan *plan, const map_found *found)
{
    return map_is_of_tolerances(plan) ? found->least : found->most;
}
