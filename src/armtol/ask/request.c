#include "armtol/ask/request.h"

#include "armtol/ask/given.h"
#include "armtol/ask/nothing_left.h"
#include "armtol/ask/number_list.h"
#include "armtol/ask/weights.h"
#include "armtol/drawing/drawn.h"
#include "armtol/lists/lists.h"
#include "armtol/names/joint_values.h"
#include "armtol/names/link_name.h"
#include "armtol/wish/accuracy.h"
#include "console/exit_code.h"
#include "console/input_file.h"
#include "console/message.h"
#include "console/number.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define RIGHT_ANGLE 1.57079632679489661923

/* ---- poses ---- */

static double size_of_end(double end)
{
    return isinf(end) ? 0 : fabs(end);
}

/* Who moves: a joint, or a link that follows one. */
static const char *mover_text(const armtol_arm *arm, size_t link, char *text, size_t room)
{
    link_text leader;
    if (armtol_arm_is_driven(arm, link)) {
        const char *name = link_name(arm, link);
        snprintf(text, room, name != NULL ? "joint %zu (%s)" : "joint %zu", armtol_arm_joint_of(arm, link) + 1,
                 name);
    } else {
        link_words(arm, arm->motions[link].follows, &leader);
        snprintf(text, room, "%s, which follows %s", link_words(arm, link, &(link_text){""}), leader.text);
    }
    return text;
}

static void say_limits(const units *units, const armtol_arm *arm, size_t link, size_t pose, double value)
{
    const armtol_drive *drive = &arm->drives[link];
    const bool none = drive->low == 0 && drive->high == 0;
    char mover[2 * sizeof(link_text) + 20];
    message("pose %zu, %s: %s is beyond its limits; expected %s to %s %s (%s--ignore-limits sets limits aside)",
            pose + 1, mover_text(arm, link, mover, sizeof mover),
            units_joint_text(units, &arm->links[link], value, &(number_text){""}),
            units_joint_text(units, &arm->links[link], drive->low, &(number_text){""}),
            units_joint_text(units, &arm->links[link], drive->high, &(number_text){""}),
            units_name(units, arm->links[link].joint == ARMTOL_PRISMATIC),
            none ? "limits of 0 and 0 often mean that none are known: " : "");
}

bool request_within_limits(const armtol_drive *drive, double value)
{
    const double slack = 1e-9 * fmax(size_of_end(drive->low), size_of_end(drive->high)); /* limits are rounded too */
    return value >= drive->low - slack && value <= drive->high + slack;
}

static bool check_limits(const units *units, const armtol_arm *arm, size_t link, size_t pose, double value)
{
    const bool fine = request_within_limits(&arm->drives[link], value);
    if (!fine) {
        say_limits(units, arm, link, pose, value);
    }
    return fine;
}

static bool check_pose(const units *units, const armtol_arm *arm, size_t pose, const double q[])
{
    bool fine = true;
    for (size_t i = 0; i < arm->n_links && fine; i++) {
        fine = arm->links[i].joint == ARMTOL_FIXED ||
               check_limits(units, arm, i, pose, armtol_arm_joint_value(arm, q, i));
    }
    return fine;
}

static bool read_poses(const char *path, size_t n_joints, double **poses, size_t *n_poses)
{
    FILE *stream = input_file_open("--poses: ", path, "");
    if (stream == NULL) {
        return false;
    }
    const bool fine = poses_read(stream, path, n_joints, poses, n_poses);
    fclose(stream);
    return fine;
}

static bool parse_joints(const char *text, const armtol_arm *arm, size_t n_joints, double **poses, size_t *n_poses)
{
    char what[64];
    *n_poses = 1;
    *poses = calloc(n_joints + 1, sizeof **poses);
    if (*poses == NULL) {
        out_of_memory();
        return false;
    }
    if (joint_values_are_named(text)) {
        return joint_values_parse(text, arm, *poses);
    }
    snprintf(what, sizeof what, "a value for each joint of %.20s", arm->name);
    return number_list_parse("--joints", text, what, false, n_joints, *poses);
}

/* In inside units. The poses are to be freed, also after a message. */
static bool get_poses(request *request)
{
    const cli_options *options = request->options;
    const armtol_arm *arm = request->question.arm;
    const size_t n_joints = armtol_arm_joint_count(arm);
    size_t *n_poses = &request->question.n_poses;
    if (at_is_asked(options)) {
        return at_find_poses(options, &request->units, arm, &request->q, &request->taken, n_poses);
    }
    if (options->joints == NULL && options->poses == NULL) { /* a map can do without */
        return true;
    }
    const bool fine = options->poses != NULL ? read_poses(options->poses, n_joints, &request->q, n_poses)
                                             : parse_joints(options->joints, arm, n_joints, &request->q, n_poses);
    for (size_t pose = 0; fine && pose < *n_poses; pose++) {
        units_take_joints(&request->units, arm, request->q + pose * n_joints);
    }
    return fine;
}

bool request_tool(const cli_options *options, const units *units, armtol_tool_point *tool)
{
    *tool = (armtol_tool_point){{0, 0, 0}, options->frame};
    if (options->tool_offset != NULL &&
        !number_list_parse("--tool-offset", options->tool_offset, "x,y,z", false, 3, tool->offset)) {
        return false;
    }
    for (int i = 0; i < 3; i++) {
        tool->offset[i] = units_taken(units, true, tool->offset[i]);
    }
    return true;
}

static bool take_poses(request *request)
{
    const armtol_arm *arm = request->question.arm;
    const size_t n_joints = armtol_arm_joint_count(arm);
    bool fine = request_tool(request->options, &request->units, &request->question.tool);
    if (fine && request->options->region != NULL) { /* the region finds them */
        return true;
    }
    fine = fine && get_poses(request);
    for (size_t pose = 0; fine && pose < request->question.n_poses; pose++) {
        fine = request->options->ignore_limits ||
               check_pose(&request->units, arm, pose, request->q + pose * n_joints);
    }
    request->question.q = request->q;
    return fine;
}

/* ---- loads ---- */

/* "M" or "M,x,y,z" */
static bool take_payload(const units *units, const char *text, armtol_mass *payload)
{
    double values[4] = {0, 0, 0, 0};
    const bool placed = strchr(text, ',') != NULL;
    if (!number_list_parse("--payload", text, placed ? "kg,x,y,z" : "kg, or kg,x,y,z", false, placed ? 4 : 1, values)) {
        return false;
    }
    if (values[0] < 0) {
        message("--payload: %s: a mass is not negative", message_quote(text, &(quoted){""}));
        return false;
    }
    *payload = (armtol_mass){.mass = values[0]};
    for (int i = 0; i < 3; i++) {
        payload->center[i] = units_taken(units, true, values[i + 1]);
    }
    return true;
}

static bool take_vector(const char *option, const char *text, double values[3])
{
    return text == NULL || number_list_parse(option, text, "x,y,z", false, 3, values);
}

static bool take_loads(request *request)
{
    const cli_options *options = request->options;
    armtol_loading *loading = &request->loading;
    *loading = armtol_loading_standard;
    loading->compensated = options->compensated;
    loading->payloads = request->payloads;
    loading->n_payloads = options->n_payloads;
    request->question.loading = loading;
    request->question.drives_apart = options->wish_motors;
    bool fine = take_vector("--gravity", options->gravity, loading->gravity) &&
                take_vector("--force", options->force, loading->force);
    for (size_t i = 0; i < options->n_payloads && fine; i++) {
        fine = take_payload(&request->units, options->payloads[i], &request->payloads[i]);
    }
    return fine;
}

/* The model's drives, and what --drives says of them. */
static bool take_drives(request *request)
{
    const armtol_arm *arm = &request->arm;
    request->drives = calloc(arm->n_links, sizeof *request->drives);
    if (request->drives == NULL) {
        out_of_memory();
        return false;
    }
    memcpy(request->drives, arm->drives, arm->n_links * sizeof *request->drives);
    request->arm.drives = request->drives;
    return given_drives_parse(request->options->drives, arm, &request->units, request->drives);
}

/* ---- wishes ---- */

/* From the user's units to inside ones; false where no double holds a finite value there. */
static bool take_value(const units *units, bool is_length, double *value)
{
    const double given = *value;
    *value = units_taken(units, is_length, given);
    return isinf(given) || !isinf(*value);
}

/* Six numbers, without names. */
static bool take_components(request *request, const char *text)
{
    bool bounded = false;
    if (!number_list_parse("--accuracy", text, "dx,dy,dz,wx,wy,wz, or NAME=NUMBER,... as in r=2,w=0.01", true, 6,
                           request->accuracy)) {
        return false;
    }
    for (int i = 0; i < 6; i++) {
        const bool positive = request->accuracy[i] > 0;
        bounded = bounded || isfinite(request->accuracy[i]);
        if (!positive || !take_value(&request->units, i < 3, &request->accuracy[i])) {
            message("--accuracy: component %d is %s; expected six values > 0, or - for free ones", i + 1,
                    positive ? "too large" : "not greater than zero");
            return false;
        }
    }
    if (!bounded) {
        message("--accuracy: all components are free; expected at least one number");
    }
    return bounded;
}

static bool take_named_value(const units *units, const char *name, bool is_length, double *value)
{
    const bool fine = take_value(units, is_length, value) && *value > 0;
    if (!fine) {
        message("--accuracy: %s is too %s", name, *value > 0 ? "large" : "small");
    }
    return fine;
}

/* What speaks against a wish for arrivals; NULL where nothing does. */
static const char *fault_of_arrivals(const request *request, const named_accuracy *accuracy)
{
    const cli_options *options = request->options;
    if ((accuracy->ap || isfinite(accuracy->repeatability)) && options->method != ARMTOL_METHOD_RSS) {
        return "--accuracy: ap and rp are about standard deviations; expected --method rss with them";
    }
    if (isinf(accuracy->repeatability)) {
        return NULL;
    }
    return options->region != NULL || options->action == CLI_MAP
               ? "--accuracy: rp is for poses that are listed; expected none with --region and maps"
           : options->wish_motors
               ? "--wish motors leaves the drives out, and rp in --accuracy is about them; expected one of the two"
           : options->format == OUTPUT_CSV
               ? "--csv writes tolerances only; expected --json, or nothing, with rp in --accuracy"
               : NULL;
}

/* What has nothing to tell where all tolerances are free. */
static bool asks_of_parts(const cli_options *options)
{
    return options->budget || options->grades || options->write_drawing != NULL ||
           (options->verify != 0 && options->cycles == 0);
}

/* Before it the components and norms are taken. */
static bool take_arrivals(request *request, named_accuracy *accuracy)
{
    const char *fault = fault_of_arrivals(request, accuracy);
    bool alone = accuracy->n_norms == 0;
    request->as_ap = accuracy->ap;
    if (fault != NULL) {
        message("%s", fault);
        return false;
    }
    if (isinf(accuracy->repeatability)) {
        return true;
    }
    for (size_t i = 0; i < 6; i++) {
        alone = alone && isinf(request->accuracy[i]);
    }
    request->repeatability_alone = alone && request->tolerances == NULL;
    if (request->repeatability_alone && asks_of_parts(request->options)) {
        message("--accuracy: rp alone asks nothing of parts; expected ap or another name beside it with --budget, "
                "--grades, --write-drawing, and --verify without --iso9283");
        return false;
    }
    if (alone && request->tolerances != NULL) {
        request->question.accuracy = NULL; /* nothing is asked of the parts */
    }
    request->repeatability = accuracy->repeatability;
    return take_named_value(&request->units, "rp", true, &request->repeatability);
}

static bool take_named_accuracy(request *request, const char *text)
{
    named_accuracy accuracy;
    bool fine = accuracy_parse(text, &accuracy);
    for (size_t i = 0; i < 6 && fine; i++) {
        fine = take_named_value(&request->units, armtol_component_name(i), i < 3, &accuracy.components[i]);
        request->accuracy[i] = accuracy.components[i];
    }
    for (size_t i = 0; i < accuracy.n_norms && fine; i++) {
        const unsigned components = accuracy.norms[i].components;
        fine = take_named_value(&request->units, armtol_norm_name(components), armtol_norm_is_length(components),
                                &accuracy.norms[i].limit);
        request->norms[i] = accuracy.norms[i];
    }
    request->question.norms = request->norms;
    request->question.n_norms = accuracy.n_norms;
    const bool sphere = request->options->method == ARMTOL_METHOD_SPHERE && request->tolerances == NULL;
    if (fine && accuracy.n_norms > 0 && sphere && !accuracy.ap) {
        message("--method sphere keeps to components alone; expected no %s in --accuracy, or another method",
                armtol_norm_name(accuracy.norms[0].components));
        return false;
    }
    return fine && take_arrivals(request, &accuracy);
}

static bool take_accuracy(request *request)
{
    const char *text = request->options->accuracy;
    if (text == NULL) {
        return true;
    }
    request->question.accuracy = request->accuracy;
    return accuracy_is_named(text) ? take_named_accuracy(request, text) : take_components(request, text);
}

static bool take_delta(request *request)
{
    const char *text = request->options->delta;
    double *delta = &request->question.delta;
    if (text == NULL) {
        return true;
    }
    const bool fine = number_option_positive("--delta", text, delta);
    *delta = units_taken(&request->units, true, *delta);
    if (fine && *delta == 0) { /* in inside units no double holds it, and 0 is one to be chosen */
        message("no tolerances: %s", armtol_status_text(ARMTOL_BAD_DELTA));
    }
    return fine && *delta != 0;
}

static bool take_tolerances(request *request, const char *path)
{
    for (size_t k = 0; k < request->n_columns; k++) {
        const armtol_column *column = &request->columns[k];
        const bool is_length = armtol_parameter_is_length(column->parameter);
        if (!take_value(&request->units, is_length, &request->tolerances[k]) ||
            !take_value(&request->units, is_length, &request->means[k])) {
            message("--tolerances: %s: %s of %s: the tolerance is too large", path,
                    armtol_parameter_name(column->parameter),
                    link_words(&request->arm, column->link, &(link_text){""}));
            return false;
        }
    }
    return true;
}

bool request_read_parameters(const request *request, const char *before, const char *path, parameter_table table,
                             double values[])
{
    FILE *stream = input_file_open(before, path, "");
    if (stream == NULL) {
        return false;
    }
    table.arm = request->question.arm;
    table.columns = request->columns;
    table.n_columns = request->n_columns;
    table.length_unit = units_name(&request->units, true);
    table.angle_unit = units_name(&request->units, false);
    const bool fine = parameters_read(stream, path, &table, table.zero_allowed, values);
    fclose(stream);
    return fine;
}

static bool read_tolerances(request *request)
{
    const char *path = request->options->tolerances;
    if (strchr(path, '=') != NULL) {
        const named_columns of = {request->question.arm, request->columns, request->n_columns};
        return given_tolerances_parse(path, &of, &request->units, request->tolerances);
    }
    const parameter_table table = {.value = "tolerance", .zero_allowed = true, .means = request->means};
    return request_read_parameters(request, "--tolerances: ", path, table, request->tolerances) &&
           take_tolerances(request, path);
}

static bool take_spreads(request *request, const named_columns *of)
{
    const char *text = request->options->spread;
    request->question.spreads = text != NULL ? request->spreads : NULL;
    return given_spreads_parse(text, of, &request->units, request->spreads, request->groups);
}

/* ---- drawings ---- */

/* With an accuracy, and tolerances of nothing else, a drawing gives some tolerances; else what it does is asked. */
static bool gives_all(const cli_options *options)
{
    return options->tolerances != NULL || (options->drawing != NULL && options->accuracy == NULL);
}

static bool take_rows(request *request, const char *path)
{
    for (size_t i = 0; i < request->drawing.n_rows; i++) {
        drawing_row *row = &request->drawing.rows[i];
        if (!take_value(&request->units, true, &row->distance)) {
            message("--drawing: %s: the distance of %s is too large", path,
                    link_words(&request->arm, row->link, &(link_text){""}));
            return false;
        }
        row->angle = units_taken(&request->units, false, row->angle);
        row->side = units_taken(&request->units, true, row->side);
        row->seat = units_taken(&request->units, true, row->seat);
        row->position = units_taken(&request->units, true, row->position);
        row->play = units_taken(&request->units, true, row->play);
    }
    return true;
}

static bool read_drawing(request *request, const char *path)
{
    FILE *stream = input_file_open("--drawing: ", path, "");
    if (stream == NULL) {
        return false;
    }
    const drawing_view view = {
        .arm = request->question.arm,
        .length_unit = units_name(&request->units, true),
        .angle_unit = units_name(&request->units, false),
        .right_angle = units_typed(&request->units, false, RIGHT_ANGLE),
        .length = request->units.length,
    };
    const bool fine = drawing_read(stream, path, &view, &request->drawing);
    fclose(stream);
    return fine && take_rows(request, path);
}

/* What the drawing says holds, whatever else says something of the same parameters. */
static bool take_drawing(request *request)
{
    const char *path = request->options->drawing;
    double *const tolerances = request->tolerances != NULL ? request->tolerances : request->least;
    const drawn into = {tolerances, request->drawn, request->discs};
    if (path == NULL) {
        return true;
    }
    if (!read_drawing(request, path)) {
        return false;
    }
    request->question.discs = request->discs;
    drawn_take(&request->drawing, request->question.arm, request->columns, request->n_columns, &into);
    for (size_t k = 0; k < request->n_columns; k++) {
        if (request->drawn[k] && request->tolerances == NULL) {
            request->largest[k] = request->least[k];
        }
        if (isinf(tolerances[k]) && request->drawn[k]) {
            message("--drawing: %s: the distance of %s is too large", path,
                    link_words(&request->arm, request->columns[k].link, &(link_text){""}));
            return false;
        }
    }
    return true;
}

/* ---- means ---- */

/*
 * Of errors from a lower to an upper end the middles are shifts, which only poses that are listed know. Where the
 * drawing holds they go with the tolerance.
 */
static bool take_means(request *request)
{
    bool any = false;
    for (size_t k = 0; k < request->n_columns; k++) {
        const double mean = request->drawn[k] ? 0 : request->means[k];
        request->spreads[k].shift += mean;
        any = any || mean != 0;
    }
    if (any && (request->options->region != NULL || request->options->action == CLI_MAP)) {
        message("--tolerances: %s: upper and lower are for poses that are listed; expected a column tolerance with "
                "--region and maps", request->options->tolerances);
        return false;
    }
    request->question.spreads = any ? request->spreads : request->question.spreads;
    return true;
}

/* What a drawing says is the same to both sides of what is on paper. */
static bool check_written(const request *request)
{
    for (size_t k = 0; k < request->n_columns && request->options->write_drawing != NULL; k++) {
        const armtol_column *column = &request->columns[k];
        const armtol_link *link = &request->arm.links[column->link];
        if (request->spreads[k].shift != 0 && column->parameter != ARMTOL_THETA &&
            !armtol_joint_moves(link->joint, column->parameter)) {
            message("--write-drawing: the mean of %s of %s is not 0, and a drawing says the same to both sides; "
                    "expected no shift, and no upper and lower that differ", armtol_parameter_name(column->parameter),
                    link_words(&request->arm, column->link, &(link_text){""}));
            return false;
        }
    }
    return true;
}

static bool get_memory(request *request)
{
    const armtol_arm *arm = request->question.arm;
    const size_t n = armtol_column_count(arm->links, arm->n_links);
    request->n_columns = n;
    request->columns = calloc(n, sizeof *request->columns);
    request->weights = calloc(n, sizeof *request->weights);
    request->least = calloc(n, sizeof *request->least);
    request->largest = calloc(n, sizeof *request->largest);
    request->means = calloc(n, sizeof *request->means);
    request->spreads = calloc(n, sizeof *request->spreads);
    request->groups = calloc(n, sizeof *request->groups);
    request->drawn = calloc(n, sizeof *request->drawn);
    request->discs = calloc(n, sizeof *request->discs);
    if (gives_all(request->options)) {
        request->tolerances = calloc(n, sizeof *request->tolerances);
    }
    return enough_memory(request->columns != NULL && request->weights != NULL && request->least != NULL &&
                         request->largest != NULL && request->drawn != NULL && request->discs != NULL &&
                         request->means != NULL && request->spreads != NULL && request->groups != NULL &&
                         (!gives_all(request->options) || request->tolerances != NULL));
}

static bool take_values(request *request)
{
    const armtol_arm *arm = request->question.arm;
    armtol_columns(arm->links, arm->n_links, request->columns, request->n_columns);
    request->question.weights = request->weights;
    request->question.tolerances = request->tolerances;
    request->question.least = request->least;
    request->question.largest = request->largest;
    const named_columns of = {arm, request->columns, request->n_columns};
    return given_parse(request->options->given, &of, &request->units, request->least, request->largest) &&
           take_spreads(request, &of) && take_accuracy(request) && take_delta(request) &&
           weights_parse(request->options->weights, arm, request->columns, request->n_columns, request->weights) &&
           (request->options->tolerances == NULL || read_tolerances(request)) && take_drawing(request) &&
           take_means(request) && check_written(request);
}

int request_make(request *request, const cli_options *options, const arm_model *model)
{
    *request = (struct request){
        .options = options,
        .units = units_chosen(options, model),
        .laying = &model->laying,
        .arm = model->arm,
        .question = {.arm = &request->arm, .method = options->method, .sigma = options->sigma},
    };
    const bool fine = take_drives(request) && take_poses(request) && take_loads(request) && get_memory(request) &&
                      take_values(request);
    if (!fine) {
        request_free(request);
    }
    return fine ? EXIT_OK : EXIT_WRONG;
}

void request_free(request *request)
{
    free(request->q);
    free(request->taken);
    free(request->columns);
    free(request->weights);
    free(request->tolerances);
    free(request->least);
    free(request->largest);
    free(request->means);
    drawing_free(&request->drawing);
    free(request->drawn);
    free(request->discs);
    free(request->spreads);
    free(request->groups);
    free(request->drives);
}

/* ---- the answer ---- */

/* A component, or a norm, that has to keep to an accuracy. */
static void say_unbounded(const request *request, const armtol_fault *fault)
{
    const bool is_norm = fault->about == ARMTOL_ABOUT_NORM;
    const char *name = is_norm ? armtol_norm_name(request->norms[fault->number].components)
                               : armtol_component_name(fault->number);
    message("--verify: the tolerances leave %s without a bound; expected finite ones for all that %s depends on, or %s "
            "in --accuracy",
            name, name, is_norm ? "none for it" : "- in its place");
}

/* All else that is wrong with them was found when they were read. */
static void say_spread(const request *request, size_t column)
{
    if (request->discs[column] || (column > 0 && request->discs[column - 1])) {
        message("--spread: %s of %s is in a disc; expected uniform, and no group",
                armtol_parameter_name(request->columns[column].parameter),
                link_words(&request->arm, request->columns[column].link, &(link_text){""}));
        return;
    }
    message("--method rss shares nothing out within a group, and %s of %s is in group %s; expected --tolerances, "
            "--given for all of the group, or --method worst",
            armtol_parameter_name(request->columns[column].parameter),
            link_words(&request->arm, request->columns[column].link, &(link_text){""}),
            request->groups[request->spreads[column].group - 1].text);
}

int request_failed(const request *request, const armtol_fault *fault)
{
    const char *text = armtol_status_text(fault->status);
    if (fault->status == ARMTOL_NO_MEMORY) {
        out_of_memory();
        return EXIT_FAILED;
    }
    if (fault->status == ARMTOL_NOTHING_LEFT) {
        return nothing_left(request, fault);
    }
    if (fault->status == ARMTOL_UNBOUNDED) {
        say_unbounded(request, fault);
        return EXIT_WRONG;
    }
    if (fault->about == ARMTOL_ABOUT_SPREADS) {
        say_spread(request, fault->number);
        return EXIT_WRONG;
    }
    if (fault->about == ARMTOL_ABOUT_DRIVES) {
        message("the drive of %s: nothing says what loads its compliance; expected masses in the arm's table, "
                "--payload, --force, or a moment beside the compliance",
                link_words(&request->arm, fault->number, &(link_text){""}));
        return EXIT_WRONG;
    }
    if (fault->about == ARMTOL_ABOUT_ARM || fault->about == ARMTOL_ABOUT_POSE) {
        message("%s in these poses: %s", request->question.arm->name, text);
        return EXIT_WRONG;
    }
    message("no tolerances: %s", text);
    return fault->status == ARMTOL_NOT_SOLVED ? EXIT_FAILED : EXIT_WRONG;
}

int request_answer(const request *request, armtol_answer **answer)
{
    armtol_fault fault;
    const armtol_status status = armtol_answer_create(&request->question, answer, &fault);
    return status == ARMTOL_OK ? EXIT_OK : request_failed(request, &fault);
}
