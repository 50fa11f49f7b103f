/*
 * Drawn poses of every built-in arm whose drives give way and have play under masses, payloads, a force and gravity
 * along any direction, held against the bounds of a region: no error of any of them, as armtol_answer_create has it in
 * that pose, is above. The engine finds moments and shifts pose by pose (moments.c, drives.c) and shares nothing with
 * the bound but the arm and what a drive is.
 *
 *    region_loads N      N poses an arm, frame and method, in one or two load cases
 *
 * Prints what it found, a line each. Exit status: 1 where a pose is above a bound, bounds are further apart than asked,
 * or `low` is not the engine's own error in its pose.
 */

#include "armtol/corners.h"
#include "armtol/region.h"
#include "support/random.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { MOST_LINKS = 16, MOST_COLUMNS = 64, CASES = 2, BATCH = 200 };
static const double gap = 0.15;

typedef struct drawn {
    armtol_arm arm;
    armtol_drive drives[MOST_LINKS];
    armtol_mass masses[MOST_LINKS], payloads[CASES];
    armtol_loading loading;
    double low[MOST_LINKS], high[MOST_LINKS], tolerances[MOST_COLUMNS];
    size_t n_joints, n_columns;
    armtol_question question;
} drawn;

static const armtol_norm norms[] = {{3, (double)INFINITY}, {7, (double)INFINITY}, {070, (double)INFINITY}};
enum { NORMS = sizeof norms / sizeof norms[0], MEASURES = 6 + NORMS };

/* 23 degrees of each joint, or what its limits leave of them, and some of a slide. */
static void draw_ranges(drawn *drawn, random_source *source)
{
    drawn->n_joints = 0;
    for (size_t i = 0; i < drawn->arm.n_links; i++) {
        if (armtol_arm_is_driven(&drawn->arm, i)) {
            const size_t j = drawn->n_joints++;
            const bool turns = drawn->arm.links[i].joint == ARMTOL_REVOLUTE;
            const double low = fmax(drawn->drives[i].low, turns ? -3 : -300);
            const double high = fmin(drawn->drives[i].high, turns ? 3 : 1000), half = turns ? 0.2 : 100;
            const double middle = random_between(source, low, high);
            drawn->low[j] = fmax(low, middle - half);
            drawn->high[j] = fmin(high, middle + half);
        }
    }
}

/* Some drives are stiff, some have no play; where masses are not known some bear a typed moment too. */
static void draw_drives(drawn *drawn, random_source *source, bool masses)
{
    for (size_t i = 0; i < drawn->arm.n_links; i++) {
        armtol_drive *drive = &drawn->drives[i];
        *drive = drawn->arm.drives[i];
        const bool turns = drawn->arm.links[i].joint == ARMTOL_REVOLUTE;
        const double size = turns ? 1 : 300;
        drive->compliance = random_between(source, 0, 1) < 0.2 ? 0 : random_between(source, 0, size * 4e-5);
        drive->backlash = random_between(source, 0, 1) < 0.5 ? 0 : random_between(source, 0, size * 3e-4);
        drive->resolution = random_between(source, 0, size * 1e-4);
        drive->moment = masses ? 0 : random_between(source, 0, 2);
        drive->friction = random_between(source, 0, 1) < 0.5 ? 0 : random_between(source, 0, 5);
        for (int k = 0; k < 3; k++) {
            drawn->masses[i].center[k] = random_between(source, -150, 150);
        }
        drawn->masses[i].mass = random_between(source, 0, 6);
    }
    drawn->arm.drives = drawn->drives;
    drawn->arm.masses = masses ? drawn->masses : NULL;
}

static void draw_loading(drawn *drawn, random_source *source, bool tilted)
{
    drawn->loading = armtol_loading_standard;
    for (int k = 0; k < 3 && tilted; k++) {
        drawn->loading.gravity[k] = random_between(source, -8, 8);
        drawn->loading.force[k] = random_between(source, -30, 30);
    }
    for (int i = 0; i < CASES; i++) {
        drawn->payloads[i].mass = random_between(source, 0, 6);
        for (int k = 0; k < 3; k++) {
            drawn->payloads[i].center[k] = random_between(source, -60, 60);
        }
    }
    drawn->loading.compensated = tilted ? 0.25 : 0;
    drawn->loading.payloads = drawn->payloads;
    drawn->loading.n_payloads = tilted ? CASES : 1;
}

static void draw_tolerances(drawn *drawn, random_source *source)
{
    armtol_column columns[MOST_COLUMNS];
    drawn->n_columns = armtol_column_count(drawn->arm.links, drawn->arm.n_links);
    armtol_columns(drawn->arm.links, drawn->arm.n_links, columns, drawn->n_columns);
    for (size_t k = 0; k < drawn->n_columns; k++) {
        const double most = armtol_parameter_is_length(columns[k].parameter) ? 0.1 : 4e-4;
        drawn->tolerances[k] = random_between(source, 0, most);
    }
}

static void draw(drawn *drawn, const armtol_arm *arm, armtol_frame frame, armtol_method method, random_source *source)
{
    const bool tilted = random_between(source, 0, 1) < 0.5, masses = random_between(source, 0, 1) < 0.5;
    drawn->arm = *arm;
    draw_drives(drawn, source, masses);
    draw_loading(drawn, source, tilted);
    draw_ranges(drawn, source);
    draw_tolerances(drawn, source);
    drawn->question = (armtol_question){.arm = &drawn->arm, .tolerances = drawn->tolerances, .method = method,
                                        .sigma = 3, .tool = {{20, -10, 100}, frame}, .norms = norms,
                                        .n_norms = NORMS, .loading = &drawn->loading};
}

/* |A s| + |A| t, or sigma standard deviations in the place of the second. */
static double error_of(const armtol_answer *answer, size_t pose, size_t component)
{
    const double *matrix = armtol_answer_matrix(answer, pose), *bounded = armtol_answer_bounded(answer, pose);
    const double shift = fabs(armtol_answer_shift(answer, pose, component));
    const double worst = armtol_worst_error(matrix, answer->n_columns, component, bounded);
    const double spread = armtol_rss_error(matrix, answer->n_columns, component, bounded) / sqrt(3) * answer->sigma;
    return shift + (answer->method == ARMTOL_METHOD_RSS ? spread : worst);
}

/* The largest of each measure in some poses, by the engine. */
static bool take_errors(const drawn *drawn, const double q[], size_t n_poses, double errors[MEASURES])
{
    armtol_question question = drawn->question;
    armtol_answer *answer;
    question.q = q;
    question.n_poses = n_poses;
    if (armtol_answer_create(&question, &answer, NULL) != ARMTOL_OK) {
        return false;
    }
    for (size_t pose = 0; pose < answer->n_poses; pose++) {
        for (size_t i = 0; i < 6; i++) {
            errors[i] = fmax(errors[i], error_of(answer, pose, i));
        }
    }
    for (size_t i = 0; i < NORMS; i++) {
        const armtol_predicted_norm *norm = &answer->norms[i];
        errors[6 + i] = fmax(errors[6 + i], question.method == ARMTOL_METHOD_RSS ? norm->spread : norm->of.worst);
    }
    armtol_answer_destroy(answer);
    return true;
}

static bool draw_errors(const drawn *drawn, unsigned long n, random_source *source, double errors[MEASURES])
{
    double q[BATCH * MOST_LINKS];
    bool fine = true;
    for (unsigned long i = 0; i < n && fine; i += BATCH) {
        for (size_t k = 0; k < BATCH * drawn->n_joints; k++) {
            const size_t j = k % drawn->n_joints;
            const double at = random_between(source, -0.2, 1.2);
            q[k] = drawn->low[j] + fmax(0, fmin(1, at)) * (drawn->high[j] - drawn->low[j]);
        }
        fine = take_errors(drawn, q, BATCH, errors);
    }
    return fine;
}

/* The engine's own error in the pose of `low`, of norms no more than that: theirs is along a direction found. */
static bool is_found(const drawn *drawn, const armtol_region_answer *answer, size_t i)
{
    const armtol_enclosure *found = &answer->enclosures[i];
    double errors[MEASURES] = {0};
    return take_errors(drawn, answer->q + found->pose * drawn->n_joints, 1, errors) &&
           found->low <= errors[i] * (1 + 1e-9) && found->low >= errors[i] * (i < 6 ? 1 - 1e-9 : 0.9);
}

static bool compare(const drawn *drawn, const armtol_region_answer *answer, const double errors[MEASURES])
{
    double least = 9, most = 0, widest = 0;
    uint64_t boxes = 0;
    bool found = true;
    for (size_t i = 0; i < MEASURES; i++) {
        const armtol_enclosure *enclosure = &answer->enclosures[i];
        least = fmin(least, errors[i] / enclosure->high);
        most = fmax(most, errors[i] / enclosure->high);
        widest = fmax(widest, enclosure->high / enclosure->low - 1);
        boxes = enclosure->boxes > boxes ? enclosure->boxes : boxes;
        found = found && is_found(drawn, answer, i);
    }
    printf("%-15s %s %-5s: drawn errors are %.4f to %.4f of the bounds, gap %.4f, boxes %llu%s\n", drawn->arm.name,
           drawn->question.tool.frame == ARMTOL_TOOL_FRAME ? "tool" : "base",
           armtol_method_name(drawn->question.method), least, most, widest, (unsigned long long)boxes,
           found ? "" : ", low is not the engine's");
    return most <= 1 && widest <= gap * (1 + 1e-12) && found;
}

static bool try_arm(const armtol_arm *arm, armtol_frame frame, armtol_method method, unsigned long n,
                    random_source *source)
{
    drawn drawn;
    double errors[MEASURES] = {0};
    armtol_region_answer *answer;
    draw(&drawn, arm, frame, method, source);
    const armtol_region region = {.low = drawn.low, .high = drawn.high};
    const armtol_enclosing how = {.gap = gap, .most = 20000};
    armtol_question question = drawn.question;
    const double accuracy[6] = {1e9, 1e9, 1e9, 1e9, 1e9, 1e9};
    question.accuracy = accuracy;
    if (armtol_region_answer_create(&question, &region, &how, &answer, NULL, NULL) != ARMTOL_OK) {
        printf("%s: no answer\n", arm->name);
        return false;
    }
    const bool fine = draw_errors(&drawn, n, source, errors) && compare(&drawn, answer, errors);
    armtol_region_answer_destroy(answer);
    return fine;
}

int main(int argc, char *argv[])
{
    const unsigned long n = argc == 2 ? strtoul(argv[1], NULL, 10) : 0;
    random_source source = {1987};
    bool fine = n > 0;
    for (size_t i = 0; i < 4 * armtol_arm_count() && fine; i++) {
        fine = try_arm(armtol_arm_at(i / 4), i % 2 == 0 ? ARMTOL_BASE_FRAME : ARMTOL_TOOL_FRAME,
                       i / 2 % 2 == 0 ? ARMTOL_METHOD_WORST : ARMTOL_METHOD_RSS, n, &source);
    }
    return fine ? EXIT_SUCCESS : EXIT_FAILURE;
}
