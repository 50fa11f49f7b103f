/* The AdeptOne's family: invadept. */

#include "lab/joint_orders/family.h"

#include "armtol/solve.h"

#include <math.h>

#define BASE_HEIGHT 203.2
#define INNER_LINK 425.0
#define OUTER_LINK 375.0

enum { ELBOW, COSINE, ROOT, SHOULDER, SINES, SUM, TURNS, CONSTANTS, CHOICES };

enum { ELBOW_PI_ACOS, ELBOW_ACOS, ELBOW_PI_ATAN2, ELBOW_ATAN2, ELBOW_SOLVE };
enum { SHOULDER_ATAN2, SHOULDER_ONE_ATAN2, SHOULDER_ACOS };
enum { SUM_IN_TURN, SUM_STORED };
enum { TURNS_KEPT, TURNS_WRAPPED };

static const choice choices[CHOICES] = {
    [ELBOW] = {"elbow", "how q2 is found",
               {{"pi-acos", "pi - acos(c), c the cosine of the angle between the links"},
                {"acos", "acos(-c)"},
                {"pi-atan2", "pi - atan2(sqrt(1 - c^2), c)"},
                {"atan2", "atan2(sqrt(1 - c^2), -c)"},
                {"solve", "q1 first, by solve; then q2 from where the elbow is"}}},
    [COSINE] = {"cosine", "c, or the d that solve is given",
                {{"float", "a variable"}, {"double", "inside an expression"}}},
    [ROOT] = {"root", "the square root outside of solve",
              {{"float", "a variable"}, {"double", "inside an expression"}}},
    [SHOULDER] = {"shoulder", "how q1 is found",
                  {{"atan2", "atan2(y, x) less the angle at the shoulder, by atan2"},
                   {"one-atan2", "one atan2 of both angles together"},
                   {"acos", "atan2(y, x) less the angle at the shoulder, by acos"}}},
    [SINES] = {"sines", "sines and cosines",
               {{"double", "inside expressions"}, {"float", "variables"}}},
    [SUM] = {"sum", "q3",
             {{"in-turn", "theta - q1 - q2"}, {"stored", "theta - q12, with q12 = q1 + q2 in a variable"}}},
    [TURNS] = {"turns", "q3 beyond -pi or pi", {{"kept", "left"}, {"wrapped", "brought between -pi and pi"}}},
    [CONSTANTS] = {"constants", "the lengths of the arm",
                   {{"double", "macros"}, {"float", "elements of arrays, as in the printed routines"}}},
};

static bool matters(const configuration *how, size_t choice)
{
    const int elbow = how->option[ELBOW];
    switch (choice) {
    case ROOT:
        return elbow == ELBOW_PI_ATAN2 || elbow == ELBOW_ATAN2;
    case SHOULDER:
        return elbow != ELBOW_SOLVE;
    case SINES:
        return elbow == ELBOW_SOLVE || how->option[SHOULDER] != SHOULDER_ACOS;
    default:
        return true;
    }
}

static double keep(const configuration *how, size_t choice, double value)
{
    return kept(choices, how, choice, value);
}

static double elbow_of(const configuration *how, double x, double y)
{
    const double c = keep(how, COSINE, (INNER_LINK * INNER_LINK + OUTER_LINK * OUTER_LINK - x * x - y * y) /
                                           (2 * INNER_LINK * OUTER_LINK));
    switch (how->option[ELBOW]) {
    case ELBOW_PI_ACOS:
        return HEADER_PI - acos(c);
    case ELBOW_ACOS:
        return acos(-c);
    case ELBOW_PI_ATAN2:
        return HEADER_PI - atan2(keep(how, ROOT, sqrt(1 - c * c)), c);
    default:
        return atan2(keep(how, ROOT, sqrt(1 - c * c)), -c);
    }
}

static double shoulder_of(const configuration *how, double x, double y, double q2)
{
    if (how->option[SHOULDER] == SHOULDER_ACOS) {
        const double square = x * x + y * y;
        return atan2(y, x) - acos((square + INNER_LINK * INNER_LINK - OUTER_LINK * OUTER_LINK) /
                                  (2 * INNER_LINK * sqrt(square)));
    }
    const double across = OUTER_LINK * keep(how, SINES, sin(q2));
    const double along = INNER_LINK + OUTER_LINK * keep(how, SINES, cos(q2));
    return how->option[SHOULDER] == SHOULDER_ATAN2 ? atan2(y, x) - atan2(across, along)
                                                   : atan2(y * along - x * across, x * along + y * across);
}

/* x cos q1 + y sin q1 = d: how far the tool is from the axis of joint 1 along the inner link. */
static void solve_q1_first(const configuration *how, double x, double y, double q[])
{
    const double square = x * x + y * y;
    const double d = keep(how, COSINE, (square + INNER_LINK * INNER_LINK - OUTER_LINK * OUTER_LINK) / (2 * INNER_LINK));
    q[0] = (double)NAN; /* out of reach */
    armtol_solve(x, y, d, 0, &armtol_errata_1987, &q[0]);
    const double elbow_y = INNER_LINK * keep(how, SINES, sin(q[0])), elbow_x = INNER_LINK * keep(how, SINES, cos(q[0]));
    q[1] = stored(atan2(y - elbow_y, x - elbow_x) - q[0]);
}

static double wrapped(double angle)
{
    if (angle > HEADER_PI) {
        return angle - 2 * HEADER_PI;
    }
    return angle < -HEADER_PI ? angle + 2 * HEADER_PI : angle;
}

static void solve(const configuration *how, const double wish[], double q[])
{
    const double x = wish[0], y = wish[1], z = wish[2], theta = wish[3];
    if (how->option[ELBOW] == ELBOW_SOLVE) {
        solve_q1_first(how, x, y, q);
    } else {
        q[1] = stored(elbow_of(how, x, y));
        q[0] = stored(shoulder_of(how, x, y, q[1]));
    }
    const double q3 = how->option[SUM] == SUM_IN_TURN ? theta - q[0] - q[1] : theta - stored(q[0] + q[1]);
    q[2] = stored(how->option[TURNS] == TURNS_WRAPPED ? wrapped(q3) : q3);
    q[3] = stored(z - keep(how, CONSTANTS, BASE_HEIGHT));
}

const family family_adept = {
    .program = "adpta",
    .robot = &armtol_adept_one,
    .choices = choices,
    .n_choices = CHOICES,
    .solve = solve,
    .matters = matters,
};
