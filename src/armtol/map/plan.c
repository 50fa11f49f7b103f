#include "armtol/map/plan.h"

#include "armtol/answer.h"
#include "armtol/ask/named.h"
#include "armtol/ask/number_list.h"
#include "armtol/conventions.h"
#include "armtol/error_matrix.h"
#include "armtol/euler.h"
#include "armtol/link_transform.h"
#include "console/exit_code.h"
#include "console/message.h"
#include "console/number.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- the plane and its points ---- */

const char *map_axis_name(size_t axis)
{
    static const char *const names[] = {"x", "y", "z"};
    return names[axis];
}

static bool take_plane(map_plan *plan, const char *text)
{
    static const struct {
        const char *name;
        size_t right, up, third;
    } planes[] = {{"xy", 0, 1, 2}, {"xz", 0, 2, 1}, {"yz", 1, 2, 0}};
    for (size_t i = 0; i < sizeof planes / sizeof planes[0]; i++) {
        if (strcmp(text, planes[i].name) == 0) {
            plan->right = planes[i].right;
            plan->up = planes[i].up;
            plan->third = planes[i].third;
            return true;
        }
    }
    message("--plane: unknown plane %s; expected xy, xz or yz", message_quote(text, &(quoted){""}));
    return false;
}

static bool wrong_range(const char *text, const char *why)
{
    message("--range: %s %s; expected A0..A1,B0..B1, each from its least to its largest",
            message_quote(text, &(quoted){""}),
            why);
    return false;
}

/* "LEAST..LARGEST" of so many characters */
static bool take_ends(const char *whole, const char *text, size_t length, double *least, double *largest)
{
    char part[64];
    if (length >= sizeof part) {
        return wrong_range(whole, "is too long");
    }
    memcpy(part, text, length);
    part[length] = '\0';
    char *dots = strstr(part, "..");
    if (dots == NULL) {
        return wrong_range(whole, "is not two ranges");
    }
    *dots = '\0';
    if (number_parse(part, least) != NUMBER_FINE || number_parse(dots + 2, largest) != NUMBER_FINE) {
        return wrong_range(whole, "has an end that is not a number");
    }
    return *least < *largest || wrong_range(whole, "is empty, or runs backwards");
}

static bool take_range(map_plan *plan, const char *text)
{
    const units *units = &plan->request->units;
    const char *comma = strchr(text, ',');
    if (comma == NULL || strchr(comma + 1, ',') != NULL) {
        return wrong_range(text, "is not two ranges");
    }
    if (!take_ends(text, text, (size_t)(comma - text), &plan->first[0], &plan->last[0]) ||
        !take_ends(text, comma + 1, strlen(comma + 1), &plan->first[1], &plan->last[1])) {
        return false;
    }
    bool fine = true;
    for (int d = 0; d < 2; d++) {
        plan->first[d] = units_taken(units, true, plan->first[d]);
        plan->last[d] = units_taken(units, true, plan->last[d]);
        fine = fine && isfinite(plan->last[d] - plan->first[d]) && plan->last[d] > plan->first[d];
    }
    return fine || wrong_range(text, "is too large, or too small,");
}

static bool too_many(const char *option, const char *text, size_t most, const char *why)
{
    message("%s: %s is more than %zu points%s", option, message_quote(text, &(quoted){""}), most, why);
    return false;
}

static bool take_grid(map_plan *plan, const char *text)
{
    char part[24] = "";
    uint64_t n[2];
    const char *comma = strchr(text, ',');
    if (comma != NULL && (size_t)(comma - text) < sizeof part) {
        memcpy(part, text, (size_t)(comma - text));
    }
    if (comma == NULL || !whole_number_of(part, 2, MAP_MOST_POINTS, &n[0]) ||
        !whole_number_of(comma + 1, 2, MAP_MOST_POINTS, &n[1])) {
        message("--grid: %s is wrong; expected NA,NB, the points to each side, 2 to %d",
                message_quote(text, &(quoted){""}), MAP_MOST_POINTS);
        return false;
    }
    plan->n[0] = (size_t)n[0];
    plan->n[1] = (size_t)n[1];
    return n[0] * n[1] <= MAP_MOST_POINTS || too_many("--grid", text, MAP_MOST_POINTS, "");
}

/* From the first end on; the last point is where the step brings it. */
static bool take_step(map_plan *plan, const char *text)
{
    double step;
    if (!number_option_positive("--step", text, &step)) {
        return false;
    }
    step = units_taken(&plan->request->units, true, step);
    for (int d = 0; d < 2; d++) {
        const double steps = floor((plan->last[d] - plan->first[d]) / step + 1e-9);
        if (!(steps < MAP_MOST_POINTS)) {
            return too_many("--step", text, MAP_MOST_POINTS, "");
        }
        if (steps < 1) {
            message("--step: %s is more than the range; expected two points or more to each side",
                    message_quote(text, &(quoted){""}));
            return false;
        }
        plan->n[d] = (size_t)steps + 1;
        plan->last[d] = plan->first[d] + steps * step;
    }
    return map_plan_count(plan) <= MAP_MOST_POINTS || too_many("--step", text, MAP_MOST_POINTS, "");
}

/* How many steps a range is, if it is a whole number of them; else 0. */
static double whole_steps(const map_plan *plan, int d, double step)
{
    const double steps = (plan->last[d] - plan->first[d]) / step, whole = floor(steps + 0.5);
    return fabs(steps - whole) <= 1e-9 * whole ? whole : 0;
}

/*
 * Squares, up to 60 of them along the longer side: of the shortest of some round sides that both ranges are a whole
 * number of, in the user's lengths. Where there is none, 60, and the others as nearly squares as can be.
 */
static void take_usual_grid(map_plan *plan)
{
    enum { USUAL = 60, FEWEST = 24 };
    static const double digits[] = {1, 1.5, 2, 2.5, 3, 4, 5, 6, 8};
    const double longer = fmax(plan->last[0] - plan->first[0], plan->last[1] - plan->first[1]);
    const double decade = units_taken(&plan->request->units, true, 1);
    double power = decade;
    while (power * 10 * USUAL <= longer) {
        power *= 10;
    }
    while (power * USUAL > longer) {
        power /= 10;
    }
    for (size_t i = 0; i < 18; i++) {
        const double step = digits[i % 9] * power * (i < 9 ? 1 : 10);
        const double a = whole_steps(plan, 0, step), b = whole_steps(plan, 1, step);
        if (fmax(a, b) <= USUAL && fmax(a, b) >= FEWEST && a > 0 && b > 0) {
            plan->n[0] = (size_t)a + 1;
            plan->n[1] = (size_t)b + 1;
            return;
        }
    }
    for (int d = 0; d < 2; d++) {
        plan->n[d] = 1 + (size_t)fmax(floor(USUAL * (plan->last[d] - plan->first[d]) / longer + 0.5), 1);
    }
}

static bool take_points(map_plan *plan, const cli_options *options)
{
    const map_texts *texts = &options->map;
    if (!take_plane(plan, texts->plane) || !take_range(plan, texts->range)) {
        return false;
    }
    if (texts->offset != NULL && !number_option_parse("--offset", texts->offset, &plan->offset)) {
        return false;
    }
    plan->offset = units_taken(&plan->request->units, true, plan->offset);
    if (texts->grid != NULL ? !take_grid(plan, texts->grid) : texts->step != NULL && !take_step(plan, texts->step)) {
        return false;
    }
    if (texts->grid == NULL && texts->step == NULL) {
        take_usual_grid(plan);
    }
    if (options->svg != NULL && map_plan_count(plan) > MAP_MOST_DRAWN) {
        message("--svg: %zu x %zu points are more than %d, which a picture can have; expected fewer, or --tsv",
                plan->n[0], plan->n[1], MAP_MOST_DRAWN);
        return false;
    }
    return true;
}

size_t map_plan_count(const map_plan *plan)
{
    return plan->n[0] * plan->n[1];
}

static double place_of(const map_plan *plan, int d, size_t i)
{
    const double share = (double)i / (double)(plan->n[d] - 1);
    return i + 1 == plan->n[d] ? plan->last[d] : plan->first[d] + share * (plan->last[d] - plan->first[d]);
}

void map_plan_point(const map_plan *plan, size_t k, double point[3])
{
    point[plan->right] = place_of(plan, 0, k % plan->n[0]);
    point[plan->up] = place_of(plan, 1, k / plan->n[0]);
    point[plan->third] = plan->offset;
}

/* ---- what is asked of each point ---- */

static bool take_what(map_plan *plan, const char *text)
{
    for (size_t i = 0; i < ARMTOL_MAP_VALUE_COUNT; i++) {
        if (text == NULL || strcmp(text, armtol_map_value_name((armtol_map_value)i)) == 0) {
            plan->map.value = (armtol_map_value)i;
            return true;
        }
    }
    message("--what: unknown value %s; expected worst, droop, repeatability or tolerance",
            message_quote(text, &(quoted){""}));
    return false;
}

static bool take_component(map_plan *plan, const char *text)
{
    plan->of = text != NULL ? text : "position";
    for (size_t i = 0; i < ARMTOL_MAP_COMPONENT_COUNT; i++) {
        const char *name = i == ARMTOL_MAP_POSITION ? "position"
                           : i == ARMTOL_MAP_ROTATION ? "rotation" : armtol_component_name(i);
        if (strcmp(plan->of, name) == 0) {
            plan->map.component = i;
            plan->is_length = i < 3 || i == ARMTOL_MAP_POSITION;
            return true;
        }
    }
    message("--of: unknown component %s; expected position, rotation, dx, dy, dz, wx, wy or wz",
            message_quote(text, &(quoted){""}));
    return false;
}

/* What --of names of tolerances, with the names of --weights. */
typedef struct naming {
    map_plan *plan;
    named_columns of;
    size_t n_lengths, n_angles;
} naming;

static bool take_name(const named_item *item, void *context)
{
    naming *naming = context;
    if (item->sign[0] != '\0') {
        message("--of: %s: expected names alone, as those of --weights", message_quote(item->whole, &(quoted){""}));
        return false;
    }
    if (!named_any_column(&naming->of, item)) {
        return false;
    }
    for (size_t k = 0; k < naming->of.n_columns; k++) {
        if (named_column(&naming->of, item, k) && !naming->plan->columns[k]) {
            const bool length = armtol_parameter_is_length(naming->of.columns[k].parameter);
            naming->plan->columns[k] = true;
            naming->n_lengths += length;
            naming->n_angles += !length;
        }
    }
    return true;
}

static bool take_columns(map_plan *plan, const char *text)
{
    const request *request = plan->request;
    naming naming = {plan, {request->question.arm, request->columns, request->n_columns}, 0, 0};
    plan->of = text != NULL ? text : "lengths";
    plan->columns = calloc(request->n_columns, sizeof *plan->columns);
    if (plan->columns == NULL) {
        out_of_memory();
        return false;
    }
    plan->map.columns = plan->columns;
    if (!named_each("--of", plan->of, request->question.arm, take_name, &naming)) {
        return false;
    }
    plan->is_length = naming.n_lengths > 0;
    if (naming.n_lengths > 0 && naming.n_angles > 0) {
        message("--of: %s has lengths and angles, and of those there is no least; expected the one or the other",
                message_quote(plan->of, &(quoted){""}));
        return false;
    }
    return true;
}

/* The accuracy that the component is to keep to; of a norm and of tolerances there is none. */
static double accuracy_of(const map_plan *plan)
{
    const double *accuracy = plan->request->question.accuracy;
    const size_t component = plan->map.component;
    const bool one = plan->map.value != ARMTOL_MAP_TOLERANCE && accuracy != NULL && component < 6;
    return one && isfinite(accuracy[component]) ? accuracy[component] : (double)NAN;
}

static bool take_contour(map_plan *plan, const char *text)
{
    plan->wish = accuracy_of(plan);
    if (text == NULL) {
        return true;
    }
    const bool fine = number_option_positive("--contour", text, &plan->wish);
    plan->wish = units_taken(&plan->request->units, plan->is_length, plan->wish);
    return fine;
}

static bool take_values(map_plan *plan, const map_texts *texts)
{
    return take_what(plan, texts->what) &&
           (plan->map.value == ARMTOL_MAP_TOLERANCE ? take_columns(plan, texts->of)
            : take_component(plan, texts->of)) &&
           take_contour(plan, texts->contour);
}

/* Whether what the map is of can be told from what is given. */
static bool is_known(const map_plan *plan)
{
    const armtol_question *question = &plan->request->question;
    const bool accuracy = question->accuracy != NULL || question->n_norms > 0;
    const bool tolerances = question->tolerances != NULL;
    if (plan->map.value == ARMTOL_MAP_WORST && !tolerances && !(accuracy && question->n_poses > 0)) {
        message("--what worst: what the tolerances are is missing; expected --tolerances, or --accuracy with the "
                "pose or poses that it is asked for");
        return false;
    }
    if (plan->map.value == ARMTOL_MAP_TOLERANCE && (!accuracy || tolerances)) {
        message("--what tolerance: expected --accuracy, and no --tolerances");
        return false;
    }
    return true;
}

/* ---- the tool's axes ---- */

/* Those that the tool has in the first pose. */
static bool take_axes_of_pose(map_plan *plan)
{
    const request *request = plan->request;
    const armtol_arm *arm = &request->arm;
    armtol_link *links = calloc(arm->n_links, sizeof *links);
    if (links == NULL) {
        out_of_memory();
        return false;
    }
    const armtol_status status = armtol_arm_place(arm, request->q, armtol_arm_joint_count(arm), links);
    if (status == ARMTOL_OK) {
        const armtol_transform last = armtol_chain_transform(links, arm->n_links, &armtol_errata_none);
        for (int i = 0; i < 3; i++) {
            memcpy(plan->axes[i], last.m[i], sizeof plan->axes[i]);
        }
    } else {
        message("%s in this pose: %s", arm->name, armtol_status_text(status));
    }
    free(links);
    return status == ARMTOL_OK;
}

static bool take_angles(map_plan *plan, const char *text)
{
    double pose[6] = {0};
    if (!number_list_parse("--orientation", text, "gamma,beta,alpha", false, 3, pose + 3)) {
        return false;
    }
    for (int i = 3; i < 6; i++) {
        pose[i] = units_taken(&plan->request->units, false, pose[i]);
    }
    const armtol_transform frame = armtol_pose_to_transform(pose, &armtol_errata_none);
    for (int i = 0; i < 3; i++) {
        memcpy(plan->axes[i], frame.m[i], sizeof plan->axes[i]);
    }
    return true;
}

/* Where nothing is said: those of the pose, where there is one and the arm has joints enough to keep some of them. */
static bool take_axes(map_plan *plan, const char *text)
{
    enum { JOINTS_OF_A_POINT = 3 };
    const request *request = plan->request;
    const bool is_free = text != NULL && strcmp(text, "free") == 0;
    if (text != NULL && !is_free) {
        plan->keeps_axes = true;
        return take_angles(plan, text);
    }
    plan->keeps_axes = !is_free && request->question.n_poses > 0 &&
                       armtol_arm_joint_count(&request->arm) > JOINTS_OF_A_POINT;
    return !plan->keeps_axes || take_axes_of_pose(plan);
}

int map_plan_make(map_plan *plan, const request *request)
{
    const map_texts *texts = &request->options->map;
    *plan = (struct map_plan){.request = request};
    if (!take_points(plan, request->options) || !take_values(plan, texts) || !is_known(plan) ||
        !take_axes(plan, texts->orientation)) {
        map_plan_free(plan);
        return EXIT_WRONG;
    }
    return EXIT_OK;
}

void map_plan_free(map_plan *plan)
{
    free(plan->columns);
}

/* ---- as shown ---- */

double map_value_shown(const map_plan *plan, double value)
{
    return units_shown(&plan->request->units, plan->is_length, value);
}

double map_place_shown(const map_plan *plan, double place)
{
    return units_typed(&plan->request->units, true, place);
}

const char *map_title_of(const map_plan *plan, map_title *title)
{
    static const char *const names[ARMTOL_MAP_VALUE_COUNT] = {
        "worst-case error", "droop under load", "repeatability", "least tolerance"};
    snprintf(title->text, sizeof title->text, "%s of %s%.40s", names[plan->map.value],
             plan->map.component >= 6 && plan->map.value != ARMTOL_MAP_TOLERANCE ? "the " : "", plan->of);
    return title->text;
}
