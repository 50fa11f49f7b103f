#include "armtol/tell/output.h"

#include "armtol/armtol.h"
#include "armtol/names/link_name.h"
#include "armtol/tell/grades.h"
#include "armtol/tell/json_arms.h"
#include "armtol/tell/laying.h"

#include <math.h>
#include <stdio.h>

/* docs/json.md describes what is written here; names and meanings stay, new ones may come. */

static void write_arm(json *json, const findings *findings)
{
    const armtol_arm *arm = findings->request->question.arm;
    json_open_object(json, "arm");
    json_arm_texts(json, arm);
    json_count(json, "links", arm->n_links);
    json_count(json, "joints", findings->answer->n_joints);
    json_joint_names(json, arm);
    json_close_object(json);
    json_units(json, &findings->request->units);
}

static void write_frame(json *json, const findings *findings, size_t pose)
{
    const units *units = &findings->request->units;
    armtol_transform frame;
    double as_pose[6];
    armtol_answer_frame(findings->answer, pose * findings->answer->n_loads, &frame);
    armtol_transform_to_pose(&frame, &armtol_errata_none, as_pose);
    json_open_array(json, "matrix");
    for (int i = 0; i < 3; i++) {
        frame.m[i][3] = units_shown(units, true, frame.m[i][3]);
        json_numbers(json, NULL, frame.m[i], 4);
    }
    json_close_array(json);
    for (int i = 3; i < 6; i++) {
        as_pose[i] = units_shown(units, false, as_pose[i]);
    }
    json_numbers(json, "zyx", (const double[]){as_pose[5], as_pose[4], as_pose[3]}, 3);
}

/* Of a pose that was asked for by its position: the first of so many branches, and how far off it is. */
static void write_taken(json *json, const findings *findings, size_t pose)
{
    const at_taken *taken = &findings->request->taken[pose];
    json_count(json, "branch", 1);
    json_count(json, "branches", taken->n_branches);
    json_text(json, "inverse", taken->own ? "own" : "search");
    json_number(json, "distance", units_shown(&findings->request->units, true, taken->distance));
    json_number(json, "angle", units_shown(&findings->request->units, false, taken->angle));
}

static void write_poses(json *json, const findings *findings)
{
    const armtol_answer *answer = findings->answer;
    const units *units = &findings->request->units;
    json_open_array(json, "poses");
    for (size_t pose = 0; pose < findings->request->question.n_poses; pose++) {
        const double *q = findings->request->q + pose * answer->n_joints;
        double point[3];
        size_t joint = 0;
        armtol_answer_tool(answer, pose * answer->n_loads, point);
        json_open_object(json, NULL);
        json_open_array(json, "joints");
        for (size_t i = 0; i < answer->n_links; i++) {
            const armtol_joint moved = answer->links[i].joint;
            if (armtol_arm_is_driven(findings->request->question.arm, i)) {
                json_number(json, NULL, units_typed(units, moved == ARMTOL_PRISMATIC, q[joint++]));
            }
        }
        json_close_array(json);
        for (int i = 0; i < 3; i++) {
            point[i] = units_shown(units, true, point[i]);
        }
        json_numbers(json, "tool", point, 3);
        if (findings->request->taken != NULL) {
            write_taken(json, findings, pose);
        }
        if (findings->request->options->tool_pose) {
            write_frame(json, findings, pose);
        }
        json_close_object(json);
    }
    json_close_array(json);
}

static void write_method(json *json, const findings *findings)
{
    const cli_options *options = findings->request->options;
    const armtol_answer *answer = findings->answer;
    if (findings->request->tolerances != NULL) {
        json_text(json, "method", "given");
        return;
    }
    json_text(json, "method", armtol_method_name(options->method));
    if (options->method == ARMTOL_METHOD_RSS) {
        json_number(json, "sigma", options->sigma);
    }
    if (options->method == ARMTOL_METHOD_SPHERE) {
        json_number(json, "delta", units_shown(&findings->request->units, true, answer->delta));
        json_number(json, "distance_bound", units_shown(&findings->request->units, true, answer->bounds.distance));
        json_number(json, "angle_bound", units_shown(&findings->request->units, false, answer->bounds.angle));
    }
}

/* What does not exist is left out. */
static void write_grades(json *json, const char *name, const grades_held *held)
{
    json_open_object(json, name);
    json_text_if(json, "iso_286", held->iso_286);
    json_text_if(json, "iso_2768", held->iso_2768);
    json_known(json, "side", held->side);
    json_close_object(json);
}

static void write_grades_of_parameter(json *json, const findings *findings, size_t column)
{
    const grades_held held = grades_of_parameter(findings, column);
    write_grades(json, "grades", &held);
}

static void write_grades_of_part(json *json, const findings *findings, size_t link)
{
    const double angle = findings->answer->parts[link].angle;
    if (grades_has_distance(findings, link)) {
        const grades_held held = grades_of_distance(findings, link);
        write_grades(json, "distance_grades", &held);
    }
    if (!isnan(angle)) {
        const grades_held held = grades_of_angle(angle);
        write_grades(json, "angle_grades", &held);
    }
}

static void write_parameters(json *json, const findings *findings)
{
    json_open_array(json, "parameters");
    for (size_t k = 0; k < findings->answer->n_columns; k++) {
        const parameter_row row = findings_parameter(findings, k);
        json_open_object(json, NULL);
        json_count(json, "link", row.link);
        json_text_if(json, "name", row.name);
        json_text(json, "kind", row.kind);
        json_text(json, "parameter", row.parameter);
        json_text(json, "role", row.role);
        json_text(json, "unit", row.unit);
        json_number(json, "nominal", row.nominal);
        json_number(json, "tolerance", row.tolerance);
        json_text(json, "set_by", row.drawn      ? "drawing"
                                  : row.given    ? "given"
                                  : row.held > 0 ? "largest"
                                  : row.held < 0 ? "least"
                                                 : "accuracy");
        json_number(json, "held", fabs(row.held));
        if (findings_are_spread(findings)) {
            json_text(json, "distribution", row.distribution.text);
            json_number(json, "shift", row.shift);
            json_text_if(json, "group", row.group[0] != '\0' ? row.group : NULL);
        }
        json_text_if(json, "within", row.in_disc ? "disc" : NULL);
        if (findings->request->options->grades && grades_has_parameter(findings, k)) {
            write_grades_of_parameter(json, findings, k);
        }
        json_close_object(json);
    }
    json_close_array(json);
}

static void write_drawing(json *json, const findings *findings)
{
    const request *request = findings->request;
    json_open_array(json, "drawing");
    for (size_t i = 0; i < request->drawing.n_rows; i++) {
        const drawing_row *row = &request->drawing.rows[i];
        json_open_object(json, NULL);
        json_count(json, "link", row->link);
        json_text_if(json, "name", link_name(request->question.arm, row->link));
        json_known(json, "distance", units_typed(&request->units, true, row->distance));
        json_known(json, "angle", units_typed(&request->units, false, row->angle));
        json_text_if(json, "split", isnan(row->distance) ? NULL : drawing_split_name(row->split));
        json_known(json, "side", units_typed(&request->units, true, row->side));
        json_known(json, "seat", units_typed(&request->units, true, row->seat));
        json_known(json, "position", units_typed(&request->units, true, row->position));
        json_known(json, "play", units_typed(&request->units, true, row->play));
        json_close_object(json);
    }
    json_close_array(json);
}

static void write_parts(json *json, const findings *findings)
{
    const armtol_answer *answer = findings->answer;
    const units *units = &findings->request->units;
    json_open_array(json, "parts");
    for (size_t i = 0; i < answer->n_links; i++) {
        const armtol_part *part = &findings->answer->parts[i];
        const bool slides = answer->links[i].joint == ARMTOL_PRISMATIC;
        json_open_object(json, NULL);
        json_count(json, "link", i);
        json_text_if(json, "name", link_name(findings->request->question.arm, i));
        json_known(json, "distance", units_shown(units, true, part->distance));
        json_known(json, "angle", units_shown(units, false, part->angle));
        json_known(json, "motor", units_shown(units, slides, part->motor));
        json_known(json, "drive", units_shown(units, slides, part->drive));
        if (findings->request->options->grades) {
            write_grades_of_part(json, findings, i);
        }
        json_close_object(json);
    }
    json_close_array(json);
}

/* What components and norms have alike. */
static void write_predicted(json *json, const findings *findings, size_t i)
{
    const armtol_predicted *of = findings_predicted(findings, i);
    json_text(json, "name", findings_name(findings, i));
    json_known(json, "accuracy", findings_shown(findings, i, findings_accuracy(findings, i)));
    json_number(json, "worst_case", findings_shown(findings, i, of->worst));
    json_number(json, "standard_deviation", findings_shown(findings, i, of->deviation));
    json_number(json, "remainder", findings_shown(findings, i, of->remainder));
    json_number(json, "rounding", findings_shown(findings, i, of->rounding));
    json_number(json, "binds", of->binds);
    json_number(json, "load", findings_shown(findings, i, of->shift));
    json_count(json, "pose", findings_pose(findings, i) + 1);
}

static void write_components(json *json, const findings *findings)
{
    json_open_array(json, "components");
    for (size_t i = 0; i < 6; i++) {
        json_open_object(json, NULL);
        write_predicted(json, findings, i);
        json_close_object(json);
    }
    json_close_array(json);
}

static void write_held(json *json, const findings *findings, size_t norm)
{
    const armtol_answer *answer = findings->answer;
    json_open_array(json, "held");
    for (size_t i = 0; i < answer->n_held; i++) {
        const armtol_held_direction *held = &answer->held_directions[i];
        if (held->norm == norm) {
            json_open_object(json, NULL);
            json_count(json, "pose", held->pose / answer->n_loads + 1);
            json_numbers(json, "direction", held->direction, 6);
            json_number(json, "binds", held->share);
            json_close_object(json);
        }
    }
    json_close_array(json);
}

static void write_norms(json *json, const findings *findings)
{
    json_open_array(json, "norms");
    for (size_t i = 0; i < findings->answer->n_norms; i++) {
        const armtol_predicted_norm *norm = &findings->answer->norms[i];
        json_open_object(json, NULL);
        write_predicted(json, findings, 6 + i);
        json_text_if(json, "asked_as", findings_is_ap(findings, i) ? "ap" : NULL);
        json_number(json, "sigmas", findings_shown(findings, 6 + i, norm->spread));
        if (isfinite(norm->of.worst)) {
            json_numbers(json, "worst_direction", norm->worst_direction, 6);
            json_numbers(json, "sigmas_direction", norm->spread_direction, 6);
        }
        write_held(json, findings, i);
        json_close_object(json);
    }
    json_close_array(json);
}

/* What moments do, one pose and load after the other: of every joint, and where it takes the tool. */
static void write_load(json *json, const findings *findings, size_t place)
{
    const armtol_answer *answer = findings->answer;
    double droop[6];
    json_open_object(json, NULL);
    json_count(json, "pose", place / answer->n_loads + 1);
    json_count(json, "load", place % answer->n_loads + 1);
    json_open_array(json, "joints");
    for (size_t k = 0; k < answer->n_columns; k++) {
        const armtol_column *at = &answer->columns[k];
        const armtol_joint joint = answer->links[at->link].joint;
        if (armtol_joint_moves(joint, at->parameter)) {
            json_open_object(json, NULL);
            json_count(json, "link", at->link);
            json_text_if(json, "name", link_name(findings->request->question.arm, at->link));
            json_number(json, "moment", answer->moments[place * answer->n_links + at->link]);
            json_number(json, "shift", units_shown(&findings->request->units, joint == ARMTOL_PRISMATIC,
                                                   armtol_answer_shifts(answer, place)[k] - answer->spreads[k].shift));
            json_number(json, "half_width", units_shown(&findings->request->units, joint == ARMTOL_PRISMATIC,
                                                        armtol_answer_bounded(answer, place)[k]));
            json_close_object(json);
        }
    }
    json_close_array(json);
    for (size_t i = 0; i < 6; i++) {
        droop[i] = findings_shown(findings, i, answer->droops[6 * place + i]);
    }
    json_numbers(json, "droop", droop, 6);
    json_close_object(json);
}

static void write_loads(json *json, const findings *findings)
{
    const armtol_answer *answer = findings->answer;
    json_open_array(json, "loads");
    for (size_t place = 0; place < answer->n_poses; place++) {
        write_load(json, findings, place);
    }
    json_close_array(json);
    json_open_array(json, "load_differences");
    for (size_t pose = 0; pose < findings->request->question.n_poses && answer->n_loads > 1; pose++) {
        double difference[6];
        findings_load_difference(findings, pose, difference);
        json_numbers(json, NULL, difference, 6);
    }
    json_close_array(json);
}

static void write_budget(json *json, const armtol_arm *arm, const armtol_budget *budget, size_t n_norms)
{
    json_open_array(json, "budget");
    for (size_t i = 0; i < budget->n_rows; i++) {
        const armtol_budget_row *row = &budget->rows[i];
        json_open_object(json, NULL);
        json_count(json, "link", row->link);
        json_text_if(json, "name", link_name(arm, row->link));
        json_text(json, "role", armtol_role_name(row->role));
        json_numbers(json, "shares", row->shares, 6);
        if (n_norms > 0) {
            json_numbers(json, "norm_shares", row->norm_shares, n_norms);
        }
        json_close_object(json);
    }
    json_close_array(json);
}

static void write_verified(json *json, const findings *findings, size_t i)
{
    const armtol_verified *component = findings_verified(findings, i);
    const armtol_predicted *predicted = findings_predicted(findings, i);
    double quantiles[ARMTOL_QUANTILES];
    for (int j = 0; j < ARMTOL_QUANTILES; j++) {
        quantiles[j] = findings_shown(findings, i, component->quantiles[j]);
    }
    json_open_object(json, NULL);
    json_text(json, "name", findings_name(findings, i));
    json_number(json, "prediction", findings_shown(findings, i, predicted->worst));
    json_number(json, "remainder", findings_shown(findings, i, predicted->remainder));
    json_numbers(json, "quantiles", quantiles, ARMTOL_QUANTILES);
    json_number(json, "worst_drawn", findings_shown(findings, i, component->worst_drawn));
    if (!isnan(component->worst_drawn)) {
        json_count(json, "worst_arm", component->worst_arm);
    }
    json_number(json, "worst_corner", findings_shown(findings, i, component->worst_corner));
    json_close_object(json);
}

static void write_verification(json *json, const findings *findings)
{
    const armtol_verification *found = findings->verification;
    const cli_options *options = findings->request->options;
    json_open_object(json, "verification");
    json_count(json, "asked", options->verify);
    json_count(json, "drawn", found->drawn);
    json_count(json, "seed", options->seed);
    json_count(json, "within", found->within);
    json_count(json, "beyond", found->beyond);
    if (found->drawn > 0) {
        json_numbers(json, "share_95", (const double[]){found->share_low, found->share_high}, 2);
    }
    json_numbers(json, "probabilities", found->probabilities, ARMTOL_QUANTILES);
    json_open_array(json, "components");
    for (size_t i = 0; i < 6; i++) {
        write_verified(json, findings, i);
    }
    json_close_array(json);
    if (findings->answer->n_norms > 0) {
        json_open_array(json, "norms");
        for (size_t i = 6; i < findings_measures(findings); i++) {
            write_verified(json, findings, i);
        }
        json_close_array(json);
    }
    json_close_object(json);
}

static void write_enclosure(json *json, const findings *findings, const armtol_enclosure *enclosure)
{
    static const char *const ends[ARMTOL_ENDED_COUNT] = {"gap", "most", "interrupt"};
    const units *units = &findings->request->units;
    const bool is_length = findings_enclosure_is_length(enclosure);
    json_open_object(json, NULL);
    json_text(json, "name", findings_enclosure_name(enclosure));
    json_number(json, "accuracy", units_shown(units, is_length, enclosure->accuracy));
    json_number(json, "found", units_shown(units, is_length, enclosure->low));
    json_number(json, "bound", units_shown(units, is_length, enclosure->high));
    json_number(json, "gap", findings_gap(enclosure));
    json_count(json, "pose", enclosure->pose);
    json_count(json, "boxes", enclosure->boxes);
    json_text(json, "ended_by", ends[enclosure->ended]);
    json_close_object(json);
}

static void write_region(json *json, const findings *findings)
{
    const armtol_region_answer *region = findings->region;
    const units *units = &findings->request->units;
    const double remainder[2] = {units_shown(units, true, region->remainder[0]),
                                 units_shown(units, false, region->remainder[1])};
    json_open_object(json, "region");
    json_text(json, "asked", findings->request->options->region);
    json_number(json, "gap", findings->request->options->gap);
    json_count(json, "worst_poses", region->n_worst);
    json_open_array(json, "errors");
    for (size_t i = 0; i < region->n_enclosures; i++) {
        write_enclosure(json, findings, &region->enclosures[i]);
    }
    json_close_array(json);
    json_numbers(json, "remainder", remainder, 2);
    json_close_object(json);
}

bool output_json(const findings *findings)
{
    const cli_options *options = findings->request->options;
    json json;
    json_start(&json, stdout);
    json_text(&json, "armtol", armtol_version());
    write_arm(&json, findings);
    laying_write(&json, findings->request->laying, &findings->request->units);
    write_method(&json, findings);
    json_text(&json, "drives", options->wish_motors ? "apart" : "in");
    json_text(&json, "frame", options->frame == ARMTOL_TOOL_FRAME ? "tool" : "base");
    write_poses(&json, findings);
    write_parameters(&json, findings);
    if (options->drawing != NULL) {
        write_drawing(&json, findings);
    }
    write_parts(&json, findings);
    write_components(&json, findings);
    if (findings->answer->n_norms > 0) {
        write_norms(&json, findings);
    }
    if (findings->region != NULL) {
        write_region(&json, findings);
    }
    if (findings->answer->loaded) {
        write_loads(&json, findings);
    }
    if (findings->budget != NULL) {
        write_budget(&json, findings->request->question.arm, findings->budget, findings->answer->n_norms);
    }
    if (findings->verification != NULL) {
        write_verification(&json, findings);
    }
    if (findings->noises != NULL) {
        json_noises(&json, findings);
    }
    if (findings->arrivals != NULL) {
        json_arrivals(&json, findings);
    }
    json_end(&json);
    return true;
}
