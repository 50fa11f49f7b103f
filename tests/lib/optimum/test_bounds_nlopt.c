/*
 * The optimum between bounds, as the engine answers it, held against that of a general solver (told_to_nlopt.h): arms
 * drawn at random, in one pose or several, with tolerances that are given, have a least, a largest or both. The problem
 * that the solver gets is made of A, the accuracy and the bounds alone.
 *
 *   test_bounds_nlopt [ARMS [SEED]]
 */

#include "armtol/answer.h"
#include "armtol/corners.h"
#include "armtol/error_matrix.h"
#include "armtol/link.h"

#include "lib/optimum/told_to_nlopt.h"
#include "support/check.h"
#include "support/random.h"
#include "unity.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { MOST_LINKS = 8, MOST_POSES = MOST_ROWS / 6 };

static unsigned long arms = 100, seed = 12;

void setUp(void)
{
}

void tearDown(void)
{
}

/* A question about an arm that is drawn. */
typedef struct drawn {
    armtol_link links[MOST_LINKS];
    armtol_drive drives[MOST_LINKS];
    armtol_arm arm;
    double q[MOST_POSES * MOST_LINKS], accuracy[6], weights[MOST_COLUMNS], least[MOST_COLUMNS], largest[MOST_COLUMNS];
    armtol_question question;
} drawn;

/* What is compared, and how it came out. */
typedef struct tally {
    unsigned long compared, given, at_least, at_largest, nothing_left, short_of_it;
    double worst;
} tally;

static bool chance(random_source *source, double share)
{
    return random_between(source, 0, 1) < share;
}

static void draw_links(random_source *source, drawn *drawn, size_t n_links)
{
    for (size_t i = 0; i < n_links; i++) {
        const armtol_kind kind = (armtol_kind)random_between(source, 0, ARMTOL_KIND_COUNT);
        drawn->drives[i] = armtol_drive_unknown;
        drawn->links[i] = (armtol_link){
            .kind = kind,
            .joint = kind == ARMTOL_NPP || kind == ARMTOL_PPP ? ARMTOL_PRISMATIC : ARMTOL_REVOLUTE,
            .a = random_between(source, -400, 400),
            .alpha = random_between(source, -2, 2),
            .d = random_between(source, -400, 400),
            .theta = random_between(source, -3, 3),
            .beta = random_between(source, -0.1, 0.1),
        };
    }
}

static void draw_wish(random_source *source, drawn *drawn)
{
    for (size_t i = 0; i < 6; i++) {
        drawn->accuracy[i] =
            chance(source, 0.15) ? (double)INFINITY : random_between(source, 0.5, 2) * (i < 3 ? 1 : 0.003);
    }
    drawn->accuracy[(size_t)random_between(source, 0, 3)] = 1;
    for (size_t k = 0; k < MOST_COLUMNS; k++) {
        drawn->weights[k] = random_between(source, 0.2, 5);
    }
}

static void draw(random_source *source, drawn *drawn)
{
    const size_t n_links = (size_t)random_between(source, 2, MOST_LINKS + 1);
    draw_links(source, drawn, n_links);
    draw_wish(source, drawn);
    drawn->arm = (armtol_arm){.name = "drawn", .title = "drawn", .source = "the test", .n_links = n_links,
                              .links = drawn->links, .drives = drawn->drives};
    drawn->question = (armtol_question){
        .arm = &drawn->arm,
        .q = drawn->q,
        .n_poses = chance(source, 0.5) ? 1 : (size_t)random_between(source, 2, MOST_POSES + 1),
        .accuracy = drawn->accuracy,
        .method = chance(source, 0.5) ? ARMTOL_METHOD_RSS : ARMTOL_METHOD_WORST,
        .sigma = 3,
        .weights = drawn->weights,
    };
    for (size_t i = 0; i < MOST_POSES * MOST_LINKS; i++) {
        drawn->q[i] = random_between(source, -1.5, 1.5);
    }
}

/* Some are given, 0 among them, others have a range, about what they are without. */
static void draw_bounds(random_source *source, drawn *drawn, const armtol_answer *without)
{
    for (size_t k = 0; k < without->n_columns; k++) {
        const double t = isfinite(without->tolerances[k]) ? without->tolerances[k] : 1e-3;
        drawn->least[k] = chance(source, 0.3) ? t * random_between(source, 0.1, 1.2) : 0;
        drawn->largest[k] = chance(source, 0.3) ? t * random_between(source, 0.3, 3) : (double)INFINITY;
        drawn->largest[k] = fmax(drawn->largest[k], drawn->least[k]);
        if (chance(source, 0.15)) {
            drawn->least[k] = drawn->largest[k] = chance(source, 0.3) ? 0 : t * random_between(source, 0.1, 0.8);
        }
    }
    drawn->question.least = drawn->least;
    drawn->question.largest = drawn->largest;
}

/* ---- the same problem ---- */

static bool is_free(const drawn *drawn, const armtol_answer *answer, size_t k)
{
    return drawn->least[k] < drawn->largest[k] && isfinite(answer->tolerances[k]);
}

/* What the given ones leave of a row. */
static double left_of(const drawn *drawn, const armtol_answer *answer, size_t row)
{
    const bool rss = answer->method == ARMTOL_METHOD_RSS;
    const double limit = drawn->accuracy[row % 6] * (rss ? sqrt(3) / 3 : 1);
    double left = rss ? limit * limit : limit;
    for (size_t k = 0; k < answer->n_columns; k++) {
        const double part = drawn->least[k] < drawn->largest[k]
                                ? 0
                                : fabs(answer->matrices[row * answer->n_columns + k]) * drawn->least[k];
        left -= rss ? part * part : part;
    }
    return rss ? sqrt(left) : left;
}

/* Only rows that are bounded and see a free column; free[] says which column of A each one of the problem is. */
static void tell(const drawn *drawn, const armtol_answer *answer, problem *problem, size_t free[])
{
    size_t n = 0;
    for (size_t k = 0; k < answer->n_columns; k++) {
        if (is_free(drawn, answer, k)) {
            problem->weights[n] = drawn->weights[k];
            problem->least[n] = drawn->least[k];
            problem->largest[n] = isfinite(drawn->largest[k]) ? drawn->largest[k] : 0;
            free[n++] = k;
        }
    }
    problem->sum = answer->method == ARMTOL_METHOD_RSS ? ARMTOL_ROOT_SUM_SQUARES : ARMTOL_WORST_CASE;
    problem->n_columns = n;
    problem->n_rows = 0;
    for (size_t row = 0; row < 6 * answer->n_poses; row++) {
        double *const packed = problem->matrix + problem->n_rows * n, largest = 0;
        for (size_t j = 0; j < n; j++) {
            packed[j] = answer->matrices[row * answer->n_columns + free[j]];
            largest = fmax(largest, fabs(packed[j]));
        }
        if (isfinite(drawn->accuracy[row % 6]) && largest > 0) {
            problem->limits[problem->n_rows++] = left_of(drawn, answer, row);
        }
    }
}

/* ---- the comparison ---- */

static void check_kept(const problem *problem, const double t[], unsigned long arm)
{
    const double order = problem->sum == ARMTOL_ROOT_SUM_SQUARES ? 2 : 1;
    for (size_t i = 0; i < problem->n_rows; i++) {
        double used = 0;
        for (size_t k = 0; k < problem->n_columns; k++) {
            used += pow(fabs(problem->matrix[i * problem->n_columns + k]) * t[k] / problem->limits[i], order);
        }
        check_within(1, 0, used - 1e-9, "arm %lu, row %zu", arm, i);
    }
}

/*
 * The same tolerances. SLSQP stops short of an optimum at times: what it found is then no larger a product. The problem
 * is strictly convex, so that what keeps to all limits and has the larger product is nearer to the optimum.
 */
static void compare(const problem *problem, const double expected[], const double t[], unsigned long arm, tally *tally)
{
    double worst = 0;
    for (size_t k = 0; k < problem->n_columns; k++) {
        worst = fmax(worst, fabs(t[k] - expected[k]) / expected[k]);
    }
    if (worst > 1e-5 && log_product(problem, expected) < log_product(problem, t)) {
        tally->short_of_it++;
        return;
    }
    check_within(1e-5, 0, worst, "arm %lu: relative difference", arm);
    tally->worst = fmax(tally->worst, worst);
}

static void count_held(const drawn *drawn, const armtol_answer *answer, tally *tally)
{
    for (size_t k = 0; k < answer->n_columns; k++) {
        tally->given += drawn->least[k] == drawn->largest[k];
        tally->at_least += answer->held[k] < 0;
        tally->at_largest += answer->held[k] > 0;
    }
    tally->compared++;
}

static void compare_answers(const drawn *drawn, const armtol_answer *answer, unsigned long arm, tally *tally)
{
    static problem problem;
    size_t free[MOST_COLUMNS];
    tell(drawn, answer, &problem, free);
    for (size_t k = 0; k < answer->n_columns; k++) {
        const double found = answer->tolerances[k];
        TEST_ASSERT_TRUE(isinf(found) || (found >= drawn->least[k] && found <= drawn->largest[k] * (1 + 1e-12)));
    }
    if (problem.n_columns > 0 && problem.n_rows > 0) {
        double expected[MOST_COLUMNS] = {0}, t[MOST_COLUMNS] = {0};
        for (size_t j = 0; j < problem.n_columns; j++) {
            t[j] = answer->tolerances[free[j]];
        }
        check_kept(&problem, t, arm);
        solve_with_nlopt(&problem, expected);
        compare(&problem, expected, t, arm, tally);
        count_held(drawn, answer, tally);
    }
}

static void compare_arm(random_source *source, unsigned long arm, tally *tally)
{
    static drawn drawn;
    armtol_answer *without, *answer;
    armtol_fault fault;
    draw(source, &drawn);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_answer_create(&drawn.question, &without, NULL));
    draw_bounds(source, &drawn, without);
    armtol_answer_destroy(without);
    const armtol_status status = armtol_answer_create(&drawn.question, &answer, &fault);
    tally->nothing_left += status == ARMTOL_NOTHING_LEFT;
    if (status == ARMTOL_OK) {
        compare_answers(&drawn, answer, arm, tally);
        armtol_answer_destroy(answer);
    } else {
        TEST_ASSERT_EQUAL_INT(ARMTOL_NOTHING_LEFT, status);
    }
}

static void test_random_arms_between_bounds(void)
{
    random_source source = {seed};
    tally tally = {.compared = 0};
    for (unsigned long arm = 0; arm < arms; arm++) {
        compare_arm(&source, arm, &tally);
    }
    printf("%lu arms: %lu compared, largest relative difference %.1e; nothing left for %lu; SLSQP short of the "
           "optimum %lu "
           "times\n%lu tolerances given, %lu held by their least, %lu by their largest\n",
           arms, tally.compared, tally.worst, tally.nothing_left, tally.short_of_it, tally.given, tally.at_least,
           tally.at_largest);
    TEST_ASSERT_TRUE(tally.compared > arms / 3 && tally.at_least > 0 && tally.at_largest > 0 && tally.given > 0);
    TEST_ASSERT_TRUE(tally.short_of_it <= arms / 20);
}

int main(int argc, char *argv[])
{
    arms = argc > 1 ? strtoul(argv[1], NULL, 10) : arms;
    seed = argc > 2 ? strtoul(argv[2], NULL, 10) : seed;
    UNITY_BEGIN();
    RUN_TEST(test_random_arms_between_bounds);
    return UNITY_END();
}
