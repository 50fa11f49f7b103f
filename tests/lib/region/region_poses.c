/*
 * Drawn poses of every built-in arm, held against the bounds of a region: no error of any of them, by
 * armtol_tool_matrix, which shares nothing with the bound but the arm, is above it.
 *
 *    region_poses N      N poses an arm, with errors along the base's axes, and N along the tool's
 *
 * Prints what it found, a line an arm. Exit status: 1 where a pose is above a bound, or bounds are further apart than
 * asked.
 */

#include "armtol/region.h"
#include "armtol/tool_matrix.h"
#include "support/random.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { MOST_JOINTS = 16, MOST_COLUMNS = 64 };
static const double gap = 0.05;

typedef struct drawn {
    const armtol_arm *arm;
    double low[MOST_JOINTS], high[MOST_JOINTS], tolerances[MOST_COLUMNS];
    size_t n_joints, n_columns;
    armtol_tool_point tool;
} drawn;

/* 60 degrees of each joint, or what its limits leave of them, and all of a slide. */
static void draw_ranges(drawn *drawn, random_source *source)
{
    const armtol_arm *arm = drawn->arm;
    drawn->n_joints = 0;
    for (size_t i = 0; i < arm->n_links; i++) {
        if (armtol_arm_is_driven(arm, i)) {
            const size_t j = drawn->n_joints++;
            const double low = fmax(arm->drives[i].low, -3), high = fmin(arm->drives[i].high, 3);
            const double middle = random_between(source, low, high);
            const bool turns = arm->links[i].joint == ARMTOL_REVOLUTE;
            drawn->low[j] = turns ? fmax(low, middle - 0.52) : fmax(arm->drives[i].low, -300);
            drawn->high[j] = turns ? fmin(high, middle + 0.52) : fmin(arm->drives[i].high, 1000);
        }
    }
}

static void draw_tolerances(drawn *drawn, random_source *source)
{
    armtol_column columns[MOST_COLUMNS];
    drawn->n_columns = armtol_column_count(drawn->arm->links, drawn->arm->n_links);
    armtol_columns(drawn->arm->links, drawn->arm->n_links, columns, drawn->n_columns);
    for (size_t k = 0; k < drawn->n_columns; k++) {
        const double most = armtol_parameter_is_length(columns[k].parameter) ? 0.1 : 0.001;
        drawn->tolerances[k] = random_between(source, 0, most);
    }
}

/* Half of the poses have some joints at an end, where errors are often largest. */
static void draw_pose(const drawn *drawn, random_source *source, double q[])
{
    for (size_t j = 0; j < drawn->n_joints; j++) {
        const double at = random_between(source, -0.2, 1.2);
        q[j] = drawn->low[j] + fmax(0, fmin(1, at)) * (drawn->high[j] - drawn->low[j]);
    }
}

static void take_errors(const drawn *drawn, const double q[], double errors[6])
{
    armtol_link placed[MOST_JOINTS];
    double matrix[6 * MOST_COLUMNS];
    armtol_arm_place(drawn->arm, q, drawn->n_joints, placed);
    armtol_tool_matrix(placed, drawn->arm->n_links, &drawn->tool, matrix, drawn->n_columns);
    for (size_t i = 0; i < 6; i++) {
        double sum = 0;
        for (size_t k = 0; k < drawn->n_columns; k++) {
            sum += fabs(matrix[i * drawn->n_columns + k]) * drawn->tolerances[k];
        }
        errors[i] = fmax(errors[i], sum);
    }
}

/* What of the bounds the poses reach, the least and the most of the six; false where a bound is wrong. */
static bool compare(const armtol_region_answer *answer, const double errors[6], const char *arm, armtol_frame frame)
{
    double least = 9, most = 0, widest = 0;
    for (size_t i = 0; i < 6; i++) {
        const armtol_enclosure *found = &answer->enclosures[i];
        const double part = errors[i] / found->high;
        least = fmin(least, part);
        most = fmax(most, part);
        widest = fmax(widest, found->high / found->low - 1);
    }
    printf("%-15s %s: drawn errors are %.4f to %.4f of the bounds, gap %.4f\n", arm, frame == ARMTOL_TOOL_FRAME
           ? "tool" : "base",
           least, most, widest);
    return most <= 1 && widest <= gap * (1 + 1e-12);
}

static bool try_arm(const armtol_arm *arm, armtol_frame frame, unsigned long n, random_source *source)
{
    drawn drawn = {.arm = arm, .tool = {{20, -10, 100}, frame}};
    double errors[6] = {0}, q[MOST_JOINTS];
    armtol_region_answer *answer;
    draw_ranges(&drawn, source);
    draw_tolerances(&drawn, source);
    const armtol_region region = {.low = drawn.low, .high = drawn.high};
    const armtol_question question = {.arm = arm, .tolerances = drawn.tolerances, .tool = drawn.tool};
    const armtol_enclosing how = {.gap = gap};
    if (armtol_region_answer_create(&question, &region, &how, &answer, NULL, NULL) != ARMTOL_OK) {
        printf("%s: no answer\n", arm->name);
        return false;
    }
    for (unsigned long i = 0; i < n; i++) {
        draw_pose(&drawn, source, q);
        take_errors(&drawn, q, errors);
    }
    const bool fine = compare(answer, errors, arm->name, frame);
    armtol_region_answer_destroy(answer);
    return fine;
}

int main(int argc, char *argv[])
{
    const unsigned long n = argc == 2 ? strtoul(argv[1], NULL, 10) : 0;
    random_source source = {1987};
    bool fine = n > 0;
    for (size_t i = 0; i < armtol_arm_count() && fine; i++) {
        fine = try_arm(armtol_arm_at(i), ARMTOL_BASE_FRAME, n, &source) && try_arm(armtol_arm_at(i),
                                                                                   ARMTOL_TOOL_FRAME, n, &source);
    }
    return fine ? EXIT_SUCCESS : EXIT_FAILURE;
}
