/*
 * Tolerances for a ball and a disc against those of a general solver, NLopt's SLSQP, which is told another problem: by
 * worst case the length at each of 2^n corners, by deviations a fan of 128 directions, which asks for a little less
 * than all. Of an arm seven columns are
 * asked for, and the others are exact.
 */

#include "armtol/answer.h"
#include "support/check.h"
#include "support/random.h"
#include "unity.h"

#include <math.h>
#include <nlopt.h>

enum { COLUMNS = 40, ASKED = 7, CORNERS = 1 << (ASKED - 1), FAN = 128, ROUNDS = 4, ARMS = 24 };

static const double pi = 3.14159265358979323846;

void setUp(void)
{
}

void tearDown(void)
{
}

typedef struct problem {
    bool rss, disc;
    double columns[ASKED][3]; /* by units, in limits */
    double units[ASKED];
} problem;

/* t_k = unit_k e^(x_k) */
static double objective(unsigned n, const double x[], double gradient[], void *data)
{
    (void)data;
    double sum = 0;
    for (unsigned k = 0; k < n; k++) {
        sum -= x[k];
        if (gradient != NULL) {
            gradient[k] = -1;
        }
    }
    return sum;
}

/* |sum of signed columns|^2 - 1, of half of all corners. */
static void corner(const problem *problem, unsigned signs, const double x[], double *result, double gradient[])
{
    double sum[3] = {0, 0, 0};
    for (unsigned k = 0; k < ASKED; k++) {
        for (int i = 0; i < 3; i++) {
            sum[i] += (signs >> k & 1 ? -1 : 1) * exp(x[k]) * problem->columns[k][i];
        }
    }
    *result = sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2] - 1;
    for (unsigned k = 0; k < ASKED && gradient != NULL; k++) {
        gradient[k] = 0;
        for (int i = 0; i < 3; i++) {
            gradient[k] += 2 * sum[i] * (signs >> k & 1 ? -1 : 1) * exp(x[k]) * problem->columns[k][i];
        }
    }
}

static void corners(unsigned m, double result[], unsigned n, const double x[], double gradient[], void *data)
{
    for (unsigned signs = 0; signs < m; signs++) {
        corner(data, signs, x, &result[signs], gradient != NULL ? gradient + signs * n : NULL);
    }
}

/* Of a disc: u'Cu <= 1, C in squares of the limit by K, of a fan of directions. */
static void directions(unsigned m, double result[], unsigned n, const double x[], double gradient[], void *data)
{
    const problem *problem = data;
    for (unsigned i = 0; i < m; i++) {
        const double angle = pi * i / m;
        result[i] = -1;
        for (unsigned k = 0; k < n; k++) {
            const double *a = problem->columns[k], across = cos(angle) * a[0] + sin(angle) * a[1];
            const double square = exp(2 * x[k]) * across * across;
            result[i] += square;
            if (gradient != NULL) {
                gradient[i * n + k] = 2 * square;
            }
        }
    }
}

/* Returns the sum of the logarithms of tolerances. */
static double solve(problem *problem)
{
    double allowed[FAN], x[ASKED], least = (double)INFINITY, start = 0;
    for (unsigned k = 0; k < ASKED; k++) {
        x[k] = -2.5; /* a fifteenth of what each could have alone: inside */
        start += log(problem->units[k]);
    }
    for (int i = 0; i < FAN; i++) {
        allowed[i] = 1e-13;
    }
    nlopt_opt solver = nlopt_create(NLOPT_LD_SLSQP, ASKED);
    TEST_ASSERT_NOT_NULL(solver);
    nlopt_set_min_objective(solver, objective, problem);
    nlopt_add_inequality_mconstraint(solver, problem->rss ? FAN : CORNERS, problem->rss ? directions : corners, problem,
                                     allowed);
    nlopt_set_upper_bounds1(solver, 0);
    nlopt_set_xtol_abs1(solver, 1e-12);
    nlopt_set_maxeval(solver, 2000);
    for (int round = 1; round <= ROUNDS; round++) { /* rounding may end one early: the next goes on, or elsewhere */
        double found = (double)INFINITY;
        const bool ended = nlopt_optimize(solver, x, &found) < 0;
        least = fmin(least, found);
        for (unsigned k = 0; k < ASKED && ended; k++) {
            x[k] = -2.5 - 0.1 * (double)(k + (unsigned)round);
        }
    }
    nlopt_destroy(solver);
    return start - least;
}

static void make_problem(const armtol_answer *answer, const size_t asked[ASKED], problem *problem)
{
    const double limit = answer->norms[0].limit * (problem->rss ? sqrt(3) / answer->sigma : 1);
    for (size_t j = 0; j < ASKED; j++) {
        double squares = 0;
        for (size_t i = 0; i < 3; i++) {
            const double element = answer->matrices[i * answer->n_columns + asked[j]];
            problem->columns[j][i] = problem->disc && i == 2 ? 0 : element / limit;
            squares += problem->columns[j][i] * problem->columns[j][i];
        }
        problem->units[j] = 1 / sqrt(squares);
        for (size_t i = 0; i < 3; i++) {
            problem->columns[j][i] *= problem->units[j];
        }
    }
}

/* Seven columns that the norm sees, at random. */
static void choose(random_source *source, const armtol_answer *seen, unsigned components, size_t asked[ASKED])
{
    for (size_t n = 0; n < ASKED;) {
        const size_t k = (size_t)(random_bits(source) % seen->n_columns);
        bool fits = false;
        for (size_t i = 0; i < 3; i++) {
            fits = fits || ((components >> i & 1) != 0 && fabs(seen->matrices[i * seen->n_columns + k]) > 1e-3);
        }
        for (size_t j = 0; j < n; j++) {
            fits = fits && asked[j] != k;
        }
        if (fits) {
            asked[n++] = k;
        }
    }
}

static void compare(random_source *source, int i)
{
    const armtol_arm *arm = armtol_arm_at((size_t)i / 3 % armtol_arm_count());
    problem problem = {.rss = i % 3 == 2, .disc = i % 3 != 0};
    const armtol_norm norm = {problem.disc ? 003 : 007, 0.7};
    double q[8], least[COLUMNS] = {0}, largest[COLUMNS] = {0}, found = 0;
    size_t asked[ASKED];
    armtol_question question = {.arm = arm, .q = q, .n_poses = 1, .norms = &norm, .n_norms = 1, .sigma = 3,
                                .method = problem.rss ? ARMTOL_METHOD_RSS : ARMTOL_METHOD_WORST};
    armtol_answer *answer;
    for (int j = 0; j < 8; j++) {
        q[j] = random_between(source, -1.5, 1.5);
    }
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_answer_create(&question, &answer, NULL));
    choose(source, answer, norm.components, asked);
    armtol_answer_destroy(answer);
    for (size_t j = 0; j < ASKED; j++) {
        largest[asked[j]] = (double)INFINITY;
    }
    question.least = least;
    question.largest = largest;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_answer_create(&question, &answer, NULL));
    for (size_t j = 0; j < ASKED; j++) {
        found += log(answer->tolerances[asked[j]]);
    }
    make_problem(answer, asked, &problem);
    const double solved = solve(&problem), less = problem.rss ? -ASKED * log(cos(pi / 2 / FAN)) : 0;
    check_within(less / 2 + 1e-8, solved - less / 2, found, "%s, problem %d", arm->name, i);
    armtol_answer_destroy(answer);
}

static void test_random_arms(void)
{
    random_source source = {12};
    for (int i = 0; i < ARMS; i++) {
        compare(&source, i);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_random_arms);
    return UNITY_END();
}
