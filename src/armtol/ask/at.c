#include "armtol/ask/at.h"

#include "armtol/ask/number_list.h"
#include "armtol/ask/request.h"
#include "armtol/euler.h"
#include "console/exit_code.h"
#include "console/input_file.h"
#include "console/message.h"
#include "console/number.h"
#include "console/progress.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/*
 * How near is there, as a share of the arm's size and in radians: a position that was printed with six decimals, of an
 * arm that cannot take any direction, leaves as much.
 */
#define WITHIN 2e-6

/* Below this it is not told of. */
#define EXACT 1e-9

bool at_is_asked(const cli_options *options)
{
    return options->n_at > 0 || options->at_file != NULL;
}

/* ---- what is asked ---- */

static size_t count_words(const char *text)
{
    static const char separators[] = " \t\n,";
    size_t count = 0;
    for (text += strspn(text, separators); *text != '\0'; text += strspn(text, separators)) {
        text += strcspn(text, separators);
        count++;
    }
    return count;
}

static bool parse_wish(const char *text, typed_wish *wish)
{
    *wish = (typed_wish){.n = count_words(text) == 3 ? 3 : 6};
    const char *what = wish->n == 3 ? "x,y,z" : "x,y,z,gamma,beta,alpha, or 3: x,y,z";
    return number_list_parse("--at", text, what, false, wish->n, wish->value);
}

static bool read_file(const char *path, typed_wish **wishes, size_t *n)
{
    FILE *stream = input_file_open("--at-file: ", path, "");
    if (stream == NULL) {
        return false;
    }
    const bool fine = wishes_read(stream, path, wishes, n);
    fclose(stream);
    return fine;
}

/* Those of the command line, then those of the file. */
static bool read_wishes(at_wishes *at, const cli_options *options)
{
    typed_wish *listed = NULL;
    size_t n_listed = 0;
    bool fine = options->at_file == NULL || read_file(options->at_file, &listed, &n_listed);
    at->n = options->n_at + n_listed;
    at->wishes = fine ? calloc(at->n, sizeof *at->wishes) : NULL;
    if (fine && at->wishes == NULL) {
        out_of_memory();
        fine = false;
    }
    for (size_t i = 0; i < options->n_at && fine; i++) {
        fine = parse_wish(options->at[i], &at->wishes[i]);
    }
    if (fine && n_listed > 0) {
        memcpy(at->wishes + options->n_at, listed, n_listed * sizeof *listed);
    }
    free(listed);
    return fine;
}

/* *near is to be freed, also after a message. */
static bool read_near(const cli_options *options, const units *units, const armtol_arm *arm, double **near)
{
    const size_t n_joints = armtol_arm_joint_count(arm);
    *near = NULL;
    if (options->near == NULL) {
        return true;
    }
    *near = calloc(n_joints + 1, sizeof **near);
    if (*near == NULL) {
        out_of_memory();
        return false;
    }
    const bool fine = number_list_parse("--near", options->near, "a value for each joint", false, n_joints, *near);
    units_take_joints(units, arm, *near);
    return fine;
}

static bool make_inverse(at_wishes *at, const cli_options *options, const double near[])
{
    armtol_tool_point tool;
    armtol_inverse_setup setup = {
        .arm = at->arm, .near = near, .ignore_limits = options->ignore_limits, .within = WITHIN};
    if (!request_tool(options, at->units, &tool)) {
        return false;
    }
    memcpy(setup.offset, tool.offset, sizeof setup.offset);
    const armtol_status status = armtol_inverse_create(&setup, &at->inverse);
    if (status == ARMTOL_NO_MEMORY) {
        out_of_memory();
    } else if (status != ARMTOL_OK) {
        message("%s: no joint values: %s", at->arm->name, armtol_status_text(status));
    }
    return status == ARMTOL_OK;
}

bool at_make(at_wishes *at, const cli_options *options, const units *units, const armtol_arm *arm)
{
    double *near;
    *at = (at_wishes){.units = units, .arm = arm, .limited = !options->ignore_limits};
    bool fine = read_near(options, units, arm, &near);
    fine = fine && read_wishes(at, options) && make_inverse(at, options, near);
    free(near);
    if (!fine) {
        at_free(at);
    }
    return fine;
}

void at_free(at_wishes *at)
{
    free(at->wishes);
    armtol_inverse_destroy(at->inverse);
}

/* ---- what is found ---- */

static armtol_wish inside_wish(const at_wishes *at, const typed_wish *typed)
{
    double pose[6];
    for (size_t i = 0; i < 6; i++) {
        pose[i] = units_taken(at->units, i < 3, typed->value[i]);
    }
    return (armtol_wish){armtol_pose_to_transform(pose, &armtol_errata_none), typed->n == 3};
}

/* The least sum of squares is flat: what it leaves of a 0 is the root of what rounding does. */
static double plain(double value, double unit)
{
    return value < 1e-7 * unit ? 0 : value;
}

static void say_out_of_reach(const at_wishes *at, size_t number, const armtol_branch *best)
{
    const typed_wish *wish = &at->wishes[number];
    const size_t n_joints = armtol_arm_joint_count(at->arm);
    char angle[80] = "", hint[120] = "";
    if (wish->n == 6) {
        snprintf(angle, sizeof angle, " and %.6g %s", units_shown(at->units, false, plain(best->angle, 1)),
                 units_name(at->units, false));
    }
    if (wish->n == 6 && n_joints < 6) {
        snprintf(hint, sizeof hint, "; an arm of %zu joint%s cannot take any direction: x,y,z alone leave it free",
                 n_joints, n_joints == 1 ? "" : "s");
    }
    message("pose %zu: the position is out of reach of %.40s%s: the nearest found is %.6g %s%s off%s", number + 1,
            at->arm->name, at->limited ? " within its limits" : "",
            units_shown(at->units, true, plain(best->distance, armtol_inverse_size(at->inverse))),
            units_name(at->units, true), angle, hint);
}

bool at_find(const at_wishes *at, size_t number, armtol_branches *branches)
{
    const armtol_wish wish = inside_wish(at, &at->wishes[number]);
    const armtol_status status = armtol_inverse_find(at->inverse, &wish, branches);
    if (status == ARMTOL_OUT_OF_REACH) {
        say_out_of_reach(at, number, &branches->best);
    } else if (status != ARMTOL_OK) {
        message("pose %zu: the position is too far off to be measured", number + 1);
    }
    return status == ARMTOL_OK;
}

static bool take_first(const at_wishes *at, size_t number, double q[], at_taken *taken)
{
    armtol_branches branches;
    if (!at_find(at, number, &branches)) {
        return false;
    }
    const armtol_branch *first = &branches.branch[0];
    memcpy(q, first->q, armtol_arm_joint_count(at->arm) * sizeof *q);
    *taken = (at_taken){
        .n_branches = branches.count,
        .distance = first->distance,
        .angle = first->angle,
        .exact = first->distance <= EXACT * armtol_inverse_size(at->inverse) && first->angle <= EXACT,
        .own = first->own,
    };
    return true;
}

static bool take_all(const at_wishes *at, double poses[], at_taken taken[])
{
    const size_t n_joints = armtol_arm_joint_count(at->arm);
    bool fine = true;
    progress bar;
    progress_start(&bar, "poses", at->n);
    for (size_t i = 0; i < at->n && fine; i++) {
        progress_show(&bar, i);
        fine = take_first(at, i, poses + i * n_joints, &taken[i]);
    }
    progress_end(&bar);
    return fine;
}

bool at_find_poses(const cli_options *options, const units *units, const armtol_arm *arm, double **poses,
                   at_taken **taken, size_t *n_poses)
{
    at_wishes at;
    if (!at_make(&at, options, units, arm)) {
        return false;
    }
    *n_poses = at.n;
    *poses = calloc(at.n, (armtol_arm_joint_count(arm) + 1) * sizeof **poses);
    *taken = calloc(at.n, sizeof **taken);
    const bool fine = enough_memory(*poses != NULL && *taken != NULL) && take_all(&at, *poses, *taken);
    at_free(&at);
    return fine;
}
