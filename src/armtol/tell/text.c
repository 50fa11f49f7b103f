#include "armtol/tell/output.h"

#include "armtol/euler.h"
#include "armtol/names/link_name.h"
#include "armtol/tell/laying.h"
#include "armtol/tell/text_tables.h"
#include "armtol/forms/wrap.h"

#include <math.h>
#include <stdio.h>

enum { MOST_POSES = 5 };

/* Without the sign of a 0 that rounding left. */
static double plain(double value)
{
    return fabs(value) < 5e-10 ? 0 : value;
}

/* Three rows of the matrix, and below them the angles. */
static void print_frame(const findings *findings, size_t pose)
{
    const units *units = &findings->request->units;
    armtol_transform frame;
    double as_pose[6];
    armtol_answer_frame(findings->answer, pose * findings->answer->n_loads, &frame);
    armtol_transform_to_pose(&frame, &armtol_errata_none, as_pose);
    for (int i = 0; i < 3; i++) {
        printf("    % .9f  % .9f  % .9f  %14.6f\n", plain(frame.m[i][0]), plain(frame.m[i][1]), plain(frame.m[i][2]),
               plain(units_shown(units, true, frame.m[i][3])));
    }
    printf("    zyx");
    for (size_t i = 5; i >= 3; i--) {
        printf(" %.6f", plain(units_shown(units, false, as_pose[i])));
    }
    printf("\n");
}

/* Of a pose that was asked for by its position. */
static void say_branch(const findings *findings, size_t pose, wrap *wrap)
{
    const at_taken *taken = &findings->request->taken[pose];
    const units *units = &findings->request->units;
    wrap_say(wrap, "branch 1 of %zu%s%s", taken->n_branches, taken->own ? ", by the arm's own inverse kinematics" : "",
             taken->exact ? "" : ",");
    if (!taken->exact) {
        wrap_say(wrap, "off the position by %.3g %s and %.3g %s", units_shown(units, true, taken->distance),
                 units_name(units, true), units_shown(units, false, taken->angle), units_name(units, false));
    }
}

static void print_pose(const findings *findings, size_t pose)
{
    const armtol_answer *answer = findings->answer;
    const units *units = &findings->request->units;
    const double *q = findings->request->q + pose * answer->n_joints;
    double point[3];
    size_t joint = 0;
    wrap wrap;
    armtol_answer_tool(answer, pose * answer->n_loads, point);
    wrap_start(&wrap, stdout, 2, 4);
    wrap_say(&wrap, findings->request->question.n_poses > 1 ? "pose %zu: joints" : "joints", pose + 1);
    for (size_t i = 0; i < answer->n_links; i++) {
        const armtol_joint moved = answer->links[i].joint;
        if (armtol_arm_is_driven(findings->request->question.arm, i)) {
            const bool last = ++joint == answer->n_joints;
            wrap_say(&wrap, "%.6g%s", units_shown(units, moved == ARMTOL_PRISMATIC, q[joint - 1]), last ? "," : "");
        }
    }
    wrap_say(&wrap, "tool point");
    for (int i = 0; i < 3; i++) {
        const bool more = i == 2 && findings->request->taken != NULL;
        wrap_say(&wrap, "%.6g%s", units_shown(units, true, point[i]), more ? "," : "");
    }
    if (findings->request->taken != NULL) {
        say_branch(findings, pose, &wrap);
    }
    wrap_end(&wrap);
    if (findings->request->options->tool_pose) {
        print_frame(findings, pose);
    }
}

static void print_region_poses(const findings *findings)
{
    const armtol_region_answer *region = findings->region;
    wrap wrap;
    wrap_start(&wrap, stdout, 0, 0);
    wrap_say(&wrap, "%zu poses of the region %s: the worst that were found and, from %zu on, others.", region->n_poses,
             findings->request->options->region, region->n_worst + 1);
    wrap_end(&wrap);
}

static void print_poses(const findings *findings)
{
    const size_t n_poses = findings->request->question.n_poses;
    const size_t most = findings->request->options->tool_pose || findings->region != NULL ? n_poses : MOST_POSES;
    if (findings->region != NULL) {
        print_region_poses(findings);
    }
    for (size_t pose = 0; pose < n_poses && pose < most; pose++) {
        print_pose(findings, pose);
    }
    if (n_poses > most) {
        printf("  and %zu more poses\n", n_poses - most);
    }
}

/* What an answer holds for. */
static void say_where(const findings *findings, wrap *wrap)
{
    const size_t n_poses = findings->request->question.n_poses;
    if (findings->region != NULL) {
        const bool asked = findings->request->tolerances == NULL && findings->region->ended == ARMTOL_ENDED_GAP;
        wrap_say(wrap, asked ? "everywhere in the region %s." : "in the region %s.",
                 findings->request->options->region);
    } else if (n_poses == 1) {
        wrap_say(wrap, "in this pose; elsewhere is unknown.");
    } else {
        wrap_say(wrap, "in these %zu poses; elsewhere is unknown.", n_poses);
    }
}

/* Two links that one motor moves; docs/arm-files.md. */
static void print_followers(const findings *findings)
{
    const armtol_arm *arm = findings->request->question.arm;
    for (size_t i = 0; i < arm->n_links; i++) {
        if (arm->links[i].joint != ARMTOL_FIXED && !armtol_arm_is_driven(arm, i)) {
            const size_t leader = arm->motions[i].follows;
            wrap wrap;
            wrap_start(&wrap, stdout, 0, 0);
            link_text room, of_leader;
            wrap_say(&wrap, "Link %s follows link %s, and each may be off by itself. What their motor is off by is in "
                            "link %zu %.6g times.",
                     link_cell(arm, i, &room), link_cell(arm, leader, &of_leader), i, arm->motions[i].multiplier);
            wrap_end(&wrap);
        }
    }
}

static void say_given(const cli_options *options, wrap *wrap)
{
    if (options->drawing == NULL) {
        wrap_say(wrap, "The tolerances of %s, and the accuracy that they give", options->tolerances);
        return;
    }
    wrap_say(wrap, "The drawing %s,", options->drawing);
    if (options->tolerances != NULL) {
        wrap_say(wrap, "with the tolerances of %s,", options->tolerances);
    }
    wrap_say(wrap, "and the accuracy that %s", options->tolerances != NULL ? "they give" : "it gives");
}

static void print_method(const findings *findings)
{
    const request *request = findings->request;
    const cli_options *options = request->options;
    wrap wrap;
    wrap_start(&wrap, stdout, 0, 0);
    if (request->tolerances != NULL) {
        say_given(options, &wrap);
    } else if (options->method == ARMTOL_METHOD_RSS) {
        wrap_say(&wrap,
                 "The largest tolerances with which %g standard deviations of every component%s are within its "
                 "accuracy",
                 options->sigma, findings->answer->n_norms > 0 ? ", and of norms in every direction," : "");
    } else if (options->method == ARMTOL_METHOD_SPHERE) {
        wrap_say(&wrap, "Tolerances by the bounds of 1987, corrected: distance %.6g, angle %.6g, delta %.6g,",
                 findings_shown(findings, 0, findings->answer->bounds.distance),
                 findings_shown(findings, 3, findings->answer->bounds.angle),
                 findings_shown(findings, 0, findings->answer->delta));
    } else {
        wrap_say(&wrap, "The largest tolerances that guarantee the accuracy");
    }
    say_where(findings, &wrap);
    wrap_end(&wrap);
}

/* What of Eq. (4.20) is in the errors, or is not. */
static void print_drives(const findings *findings)
{
    const request *request = findings->request;
    size_t known = 0;
    for (size_t i = 0; i < request->arm.n_links; i++) {
        known += request->arm.links[i].joint != ARMTOL_FIXED && armtol_drive_is_known(&request->arm.drives[i]);
    }
    if (known == 0) {
        return;
    }
    if (request->question.drives_apart) {
        printf("The drives are NOT in these errors (--wish motors): the table of parts says\n"
               "whether they are good enough.\n");
        return;
    }
    printf("The drives of %zu of %zu joints are known, and are in all errors.\n", known, findings->answer->n_joints);
}

/* Two angles whose tolerance is that of both together. */
static void print_discs(const findings *findings)
{
    size_t left = 0;
    wrap wrap;
    for (size_t k = 0; k < findings->answer->n_columns; k++) {
        left += findings->answer->discs[k];
    }
    if (left == 0) {
        return;
    }
    printf("\n");
    wrap_start(&wrap, stdout, 0, 0);
    wrap_say(&wrap, "alpha and beta are off by no more than that together, in a disc:");
    for (size_t k = 0; k < findings->answer->n_columns; k++) {
        if (findings->answer->discs[k]) {
            wrap_say(&wrap, "%s%s", link_words(findings->request->question.arm, findings->answer->columns[k].link,
                                               &(link_text){""}), --left > 0 ? "," : "");
        }
    }
    wrap_end(&wrap);
}

/* Parameters that no wish depends on, or that are given without a bound. */
static void print_unbounded(const findings *findings)
{
    const char *what = findings->request->tolerances != NULL ? "Without a bound:"
                                                             : "Not seen here, and so without a bound:";
    const armtol_answer *answer = findings->answer;
    size_t left = 0;
    wrap wrap;
    for (size_t k = 0; k < answer->n_columns; k++) {
        left += isinf(answer->tolerances[k]) != 0;
    }
    if (left == 0) {
        return;
    }
    printf("\n");
    wrap_start(&wrap, stdout, 0, 0);
    wrap_say(&wrap, "%s", what);
    for (size_t k = 0; k < answer->n_columns; k++) {
        if (isinf(answer->tolerances[k])) {
            const parameter_row row = findings_parameter(findings, k);
            wrap_say(&wrap, "%s of %s%s", row.parameter,
                     link_words(findings->request->question.arm, row.link, &(link_text){""}), --left > 0 ? "," : "");
        }
    }
    wrap_end(&wrap);
}

/* Whose errors are one. */
static void print_group(const findings *findings, size_t group)
{
    const armtol_answer *answer = findings->answer;
    size_t left = 0;
    wrap wrap;
    for (size_t k = 0; k < answer->n_columns; k++) {
        left += answer->spreads[k].group == group;
    }
    wrap_start(&wrap, stdout, 0, 0);
    wrap_say(&wrap, "Group %s, of one draw:", findings->request->groups[group - 1].text);
    for (size_t k = 0; k < answer->n_columns; k++) {
        if (answer->spreads[k].group == group) {
            const parameter_row row = findings_parameter(findings, k);
            wrap_say(&wrap, "%s of %s%s", row.parameter,
                     link_words(findings->request->question.arm, row.link, &(link_text){""}), --left > 0 ? "," : "");
        }
    }
    wrap_end(&wrap);
}

static void print_groups(const findings *findings)
{
    const request *request = findings->request;
    for (size_t i = 0; i < request->n_columns && request->groups[i].text[0] != '\0'; i++) {
        fputs(i == 0 ? "\n" : "", stdout);
        print_group(findings, i + 1);
    }
}

static void print_heading(const findings *findings)
{
    const request *request = findings->request;
    const units *units = &request->units;
    wrap wrap;
    wrap_start(&wrap, stdout, 0, 0);
    wrap_say(&wrap, "%s, in %s and %s", request->question.arm->title, units_name(units, true),
             units_name(units, false));
    wrap_end(&wrap);
    laying_print(request->laying, units, "");
    print_poses(findings);
    print_followers(findings);
    if (!request->repeatability_alone) {
        print_method(findings);
    }
    print_drives(findings);
}

/* What parts have to be, and what follows for the tool. */
static bool print_tolerances(const findings *findings)
{
    const bool fine = text_parameters(findings);
    print_discs(findings);
    print_unbounded(findings);
    print_groups(findings);
    return fine && text_parts(findings) && (!findings->request->options->grades || text_grades(findings)) &&
           text_components(findings);
}

bool output_text(const findings *findings)
{
    print_heading(findings);
    return (findings->request->repeatability_alone || print_tolerances(findings)) &&
           (findings->region == NULL || text_region(findings)) && text_loads(findings) &&
           (findings->budget == NULL || text_budget(findings)) &&
           (findings->verification == NULL || findings->request->repeatability_alone || text_verification(findings)) &&
           (findings->noises == NULL || text_noises(findings)) &&
           (findings->arrivals == NULL || text_arrivals(findings));
}
