#include "armtol/tell/output.h"

#include "armtol/tell/laying.h"
#include "armtol/tell/text_tables.h"

#include <math.h>
#include <stdio.h>

enum { MOST_POSES = 5 };

static void print_pose(const findings *findings, size_t pose)
{
    const armtol_answer *answer = findings->answer;
    const units *units = &findings->request->units;
    const double *q = findings->request->q + pose * answer->n_joints;
    double point[3];
    size_t joint = 0;
    armtol_answer_tool(answer, pose * answer->n_loads, point);
    printf("  joints");
    for (size_t i = 0; i < answer->n_links; i++) {
        const armtol_joint moved = answer->links[i].joint;
        if (moved != ARMTOL_FIXED) {
            printf(" %.6g", units_shown(units, moved == ARMTOL_PRISMATIC, q[joint++]));
        }
    }
    printf(", tool point");
    for (int i = 0; i < 3; i++) {
        printf(" %.6g", units_shown(units, true, point[i]));
    }
    printf("\n");
}

static void print_poses(const findings *findings)
{
    const size_t n_poses = findings->request->question.n_poses;
    for (size_t pose = 0; pose < n_poses && pose < MOST_POSES; pose++) {
        print_pose(findings, pose);
    }
    if (n_poses > MOST_POSES) {
        printf("  and %zu more poses\n", n_poses - MOST_POSES);
    }
}

static void print_method(const findings *findings)
{
    const request *request = findings->request;
    const cli_options *options = request->options;
    if (request->tolerances != NULL) {
        printf("The tolerances of %s, and the accuracy that they give.\n", options->tolerances);
        return;
    }
    switch (options->method) {
    case ARMTOL_METHOD_RSS:
        printf("The largest tolerances with which %g standard deviations of every component are within its accuracy.\n",
               options->sigma);
        break;
    case ARMTOL_METHOD_SPHERE:
        printf("Tolerances by the bounds of 1987, corrected: distance %.6g, angle %.6g, delta %.6g.\n",
               findings_shown(findings, 0, findings->answer->bounds.distance),
               findings_shown(findings, 3, findings->answer->bounds.angle),
               findings_shown(findings, 0, findings->answer->delta));
        break;
    default:
        printf("The largest tolerances that guarantee the accuracy.\n");
        break;
    }
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
        printf("The drives are NOT in these errors (--wish motors): the table of parts says whether they are good enough.\n");
        return;
    }
    printf("The drives of %zu of %zu joints are known, and are in all errors.\n", known, findings->answer->n_joints);
}

/* Parameters that no wish depends on, or that are given without a bound. */
static void print_unbounded(const findings *findings)
{
    const char *what = findings->request->tolerances != NULL ? "Without a bound:"
                                                             : "Not seen here, and so without a bound:";
    const armtol_answer *answer = findings->answer;
    bool any = false;
    for (size_t k = 0; k < answer->n_columns; k++) {
        if (isinf(findings->answer->tolerances[k])) {
            const parameter_row row = findings_parameter(findings, k);
            printf("%s%s %s of link %zu", any ? "" : "\n", any ? "," : what, row.parameter, row.link);
            any = true;
        }
    }
    printf(any ? "\n" : "");
}

static void print_heading(const findings *findings)
{
    const request *request = findings->request;
    const units *units = &request->units;
    printf("%s, in %s and %s\n", request->question.arm->title, units_name(units, true), units_name(units, false));
    laying_print(request->laying, units, "");
    print_poses(findings);
    print_method(findings);
    print_drives(findings);
}

bool output_text(const findings *findings)
{
    print_heading(findings);
    const bool fine = text_parameters(findings);
    print_unbounded(findings);
    return fine && text_parts(findings) && text_components(findings) && text_loads(findings) &&
           (findings->budget == NULL || text_budget(findings)) &&
           (findings->verification == NULL || text_verification(findings));
}
