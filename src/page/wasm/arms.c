/* Arms as the page draws them: where their frames are, and what arms made to tolerances do. */

#include "1987/analysis.h"
#include "1987/program.h"
#include "armtol/armtol.h"
#include "armtol/ask/arm_source.h"
#include "console/exit_code.h"
#include "lab/yield/arm_draws.h"
#include "lab/yield/column_tolerances.h"
#include "page/wasm/page.h"
#include "page/wasm/told.h"

#include <stdlib.h>

static const char *const joint_names[ARMTOL_JOINT_COUNT] = {"fixed", "revolute", "prismatic"};

static void tell_joints(json *json, const armtol_arm *arm)
{
    json_open_array(json, "joints");
    for (size_t i = 0; i < arm->n_links; i++) {
        if (armtol_arm_is_driven(arm, i)) {
            json_open_object(json, NULL);
            json_text(json, "kind", joint_names[arm->links[i].joint]);
            json_number(json, "low", arm->drives[i].low);
            json_number(json, "high", arm->drives[i].high);
            json_close_object(json);
        }
    }
    json_close_array(json);
}

const char *page_arms(void)
{
    json *json = told_begin();
    if (json == NULL) {
        return "{}";
    }
    json_open_array(json, "arms");
    for (size_t i = 0; i < armtol_arm_count(); i++) {
        const armtol_arm *arm = armtol_arm_at(i);
        json_open_object(json, NULL);
        json_text(json, "name", arm->name);
        json_text(json, "title", arm->title);
        tell_joints(json, arm);
        json_close_object(json);
    }
    json_close_array(json);
    return told_end();
}

/* The first three rows of the base, and of the frame behind each link. */
static void tell_frames(json *json, const armtol_link links[], size_t n_links)
{
    json_open_array(json, "frames");
    for (size_t n = 0; n <= n_links; n++) {
        const armtol_transform frame = armtol_chain_transform(links, n, &armtol_errata_none);
        json_numbers(json, NULL, &frame.m[0][0], 12);
    }
    json_close_array(json);
}

static const char *frames_of(const armtol_arm *arm, const double q[], size_t n_joints)
{
    armtol_link *placed = calloc(arm->n_links, sizeof *placed);
    double *rest = calloc(arm->n_links, sizeof *rest);
    const char *told = "{}";
    if (placed == NULL || rest == NULL) {
        out_of_memory();
    } else {
        const size_t n = q == NULL ? armtol_arm_joint_count(arm) : n_joints;
        const armtol_status status = armtol_arm_place(arm, q == NULL ? rest : q, n, placed);
        json *json = status == ARMTOL_OK ? told_begin() : NULL;
        if (json != NULL) {
            json_text(json, "title", arm->title);
            json_text(json, "unit", armtol_length_unit_name(arm->unit));
            tell_joints(json, arm);
            tell_frames(json, placed, arm->n_links);
            told = told_end();
        } else {
            told = told_error(armtol_status_text(status));
        }
    }
    free(placed);
    free(rest);
    return told;
}

const char *page_frames(const char *arm, const double q[], int n_joints)
{
    arm_model model;
    const cli_options options = {.arm = arm};
    if (arm_source_read(&options, &model) != EXIT_OK) {
        return told_error("no such arm");
    }
    const char *told = frames_of(&model.arm, q, (size_t)n_joints);
    arm_model_free(&model);
    return told;
}

const char *page_reach(const char *name, const double wish[])
{
    double q[6];
    armtol_reach reach;
    const program *program = program_named(name);
    const armtol_status status = program->robot->inverse(wish, &armtol_errata_none, q, &reach);
    if (status != ARMTOL_OK) {
        return told_error(armtol_status_text(status));
    }
    json *json = told_begin();
    if (json == NULL) {
        return "{}";
    }
    json_numbers(json, "q", q, program->robot->n_joints);
    return told_end();
}

/* Arms made to the tolerances of `made`, which are drawn in `drawn`. */
static bool tell_arms(json *json, const char *name, const analysis *drawn, const analysis *made, size_t count,
                      uint64_t seed)
{
    const drawn_arm arm = {drawn->links, drawn->robot->n_links, drawn->columns, drawn->n_columns};
    double *tolerances = calloc(arm.n_columns, 2 * sizeof *tolerances);
    if (tolerances == NULL) {
        out_of_memory();
        return false;
    }
    size_t within = 0;
    column_tolerances(made, LENGTHS_SHARE, tolerances);
    json_open_object(json, name);
    json_open_array(json, "errors");
    for (size_t i = 0; i < count; i++) {
        double *errors = tolerances + arm.n_columns, error[6];
        arm_draws_errors(&arm, tolerances, seed, i, errors);
        drawn_arm_error(&arm, errors, error);
        within += error_is_within(error, drawn->tolerances);
        json_numbers(json, NULL, error, 6);
    }
    json_close_array(json);
    json_count(json, "within", within);
    json_number(json, "length", made->shares.distance);
    json_number(json, "angle", made->shares.angle);
    json_close_object(json);
    free(tolerances);
    return true;
}

static const char *cloud_of(analysis *published, analysis *corrected, const double wish[], const double given[7],
                            size_t count, uint64_t seed)
{
    armtol_status status = analysis_run(published, wish, NULL, given, given[6]);
    if (status == ARMTOL_OK) {
        status = analysis_run(corrected, wish, NULL, given, given[6]);
    }
    if (status != ARMTOL_OK) {
        return told_error(armtol_status_text(status));
    }
    json *json = told_begin();
    if (json == NULL || !tell_arms(json, "published", corrected, published, count, seed) ||
        !tell_arms(json, "corrected", corrected, corrected, count, seed)) {
        return "{}";
    }
    return told_end();
}

const char *page_cloud(const char *name, const double wish[], const double given[7], int count, int seed)
{
    analysis published, corrected;
    const armtol_robot *robot = program_named(name)->robot;
    if (!analysis_start(&published, robot, &armtol_errata_1987)) {
        out_of_memory();
        return "{}";
    }
    const char *told = "{}";
    if (analysis_start(&corrected, robot, &armtol_errata_none)) {
        told = cloud_of(&published, &corrected, wish, given, (size_t)count, (uint64_t)seed);
        analysis_free(&corrected);
    } else {
        out_of_memory();
    }
    analysis_free(&published);
    return told;
}
