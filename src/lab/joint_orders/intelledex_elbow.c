/* The Intelledex's joints 3, 4 and 5. */

#include "lab/joint_orders/intelledex_steps.h"

#include "lab/joint_orders/intelledex_matrices.h"
#include "lab/joint_orders/intelledex_storage.h"

/* One of the two angles of solve, by the sign of its root. Its storage is printed. */
static double solve(double px, double py, double d, double sign)
{
    const double sq = stored(sqrt(py * py + px * px - d * d));
    return stored(atan2(px, -py) - atan2(d, sign * sq));
}

/* The angle that solve takes for a tclose of 0. */
static double nearest(double theta1, double theta2)
{
    return stored(theta1 * theta1) <= stored(theta2 * theta2) ? theta1 : theta2;
}

/* ---- the joint of the plane that comes first: two answers, one for each sign ---- */

/* q5 from the shoulder at (x, y) in frame 5. */
static double q5_of(const configuration *how, double x, double y, double sign)
{
    const double upper = constant(how, INTELLEDEX_UPPER_ARM), fore = constant(how, INTELLEDEX_FOREARM);
    const double d = cosine_or_d(how, (upper * upper - fore * fore - x * x - y * y) / (2 * fore));
    return solve(x, -y, d, sign);
}

static double q5_of_wrist(const configuration *how, const progress *p, double sign)
{
    const double c345 = sine(how, cos(p->q345)), s345 = sine(how, sin(p->q345));
    const double x = length(how, -(c345 * p->px + s345 * p->py));
    const double y = length(how, s345 * p->px - c345 * p->py);
    return q5_of(how, x, y, sign);
}

static double q3_of_wrist(const configuration *how, const progress *p, double sign)
{
    const double upper = constant(how, INTELLEDEX_UPPER_ARM), fore = constant(how, INTELLEDEX_FOREARM);
    const double square = p->px * p->px + p->py * p->py;
    const double d = cosine_or_d(how, (square + upper * upper - fore * fore) / (2 * upper));
    return solve(p->px, p->py, d, sign);
}

static double q4_of_wrist(const configuration *how, const progress *p, double sign)
{
    const double upper = constant(how, INTELLEDEX_UPPER_ARM), fore = constant(how, INTELLEDEX_FOREARM);
    const double square = p->px * p->px + p->py * p->py;
    const double c = cosine_or_d(how, (square - upper * upper - fore * fore) / (2 * upper * fore));
    switch (how->option[ELBOW]) {
    case ELBOW_Q4_ATAN2:
        return stored(atan2(sign * root(how, 1 - c * c), c));
    case ELBOW_Q4_ACOS:
        return stored(sign * acos(c));
    default:
        return stored(sign * (HEADER_PI - acos(-c)));
    }
}

static double first_joint(const configuration *how, const progress *p, double sign)
{
    switch (how->option[ELBOW]) {
    case ELBOW_Q5_SOLVE:
        return q5_of_wrist(how, p, sign);
    case ELBOW_Q3_SOLVE:
        return q3_of_wrist(how, p, sign);
    default:
        return q4_of_wrist(how, p, sign);
    }
}

/* ---- the other two ---- */

typedef struct planar_arm {
    double q3, q4, q5;
} planar_arm;

static planar_arm arm_of_q5(const configuration *how, const progress *p, double q5)
{
    const double fore = constant(how, INTELLEDEX_FOREARM);
    const double q34 = angle(how, p->q345 - q5);
    const double y = p->py - fore * sine(how, sin(q34)), x = p->px - fore * sine(how, cos(q34));
    const double q3 = stored(atan2(y, x));
    return (planar_arm){q3, how->option[LAST] == LAST_SUM ? p->q345 - q3 - q5 : q34 - q3, q5};
}

static planar_arm arm_of_q3(const configuration *how, const progress *p, double q3)
{
    const double upper = constant(how, INTELLEDEX_UPPER_ARM);
    const double y = p->py - upper * sine(how, sin(q3)), x = p->px - upper * sine(how, cos(q3));
    const double q34 = angle(how, atan2(y, x));
    const double q4 = stored(q34 - q3);
    return (planar_arm){q3, q4, how->option[LAST] == LAST_SUM ? p->q345 - q3 - q4 : p->q345 - q34};
}

static planar_arm arm_of_q4(const configuration *how, const progress *p, double q4)
{
    const double upper = constant(how, INTELLEDEX_UPPER_ARM), fore = constant(how, INTELLEDEX_FOREARM);
    const double across = fore * sine(how, sin(q4)), along = upper + fore * sine(how, cos(q4));
    const double q3 = stored(atan2(p->py, p->px) - atan2(across, along));
    return (planar_arm){q3, q4, p->q345 - q3 - q4};
}

static planar_arm complete(const configuration *how, const progress *p, double first)
{
    switch (how->option[ELBOW]) {
    case ELBOW_Q5_SOLVE:
        return arm_of_q5(how, p, first);
    case ELBOW_Q3_SOLVE:
        return arm_of_q3(how, p, first);
    default:
        return arm_of_q4(how, p, first);
    }
}

static planar_arm choose_arm(const configuration *how, const progress *p)
{
    const double plus = first_joint(how, p, 1), minus = first_joint(how, p, -1);
    if (how->option[BRANCH] == BRANCH_OWN) {
        const bool by_solve = how->option[ELBOW] == ELBOW_Q5_SOLVE || how->option[ELBOW] == ELBOW_Q3_SOLVE;
        return complete(how, p, by_solve ? nearest(plus, minus) : plus);
    }
    const planar_arm one = complete(how, p, plus), other = complete(how, p, minus);
    return fabs(other.q5) < fabs(one.q5) ? other : one;
}

/* ---- link by link from the tool, no plane needed ---- */

static armtol_transform without_link(const configuration *how, const armtol_transform *t, double a,
                                     double theta)
{
    const armtol_transform link = matrix_of_link(how, a, 0, 0, theta);
    return matrix_without(t, &link);
}

static void follow_chain(const configuration *how, progress *progress)
{
    double *q = progress->q;
    const armtol_transform *t05 = &progress->t05, t50 = matrix_inverse(t05);
    q[4] = nearest(q5_of(how, t50.m[0][3], t50.m[1][3], 1), q5_of(how, t50.m[0][3], t50.m[1][3], -1));
    const armtol_transform t04 = without_link(how, t05, constant(how, INTELLEDEX_FOREARM), q[4]);
    const armtol_transform t40 = matrix_inverse(&t04);
    q[3] = stored(atan2(t40.m[1][3], -t40.m[0][3]));
    const armtol_transform t03 = without_link(how, &t04, constant(how, INTELLEDEX_UPPER_ARM), q[3]);
    intelledex_aim(how, t03.m[0][2], t03.m[1][2], t03.m[2][2], q);
    if (how->option[LAST] == LAST_SUM) {
        q[2] = atan2(t05->m[2][1], -t05->m[2][0]) - q[3] - q[4];
    } else {
        q[2] = atan2(t03.m[2][1], -t03.m[2][0]);
    }
}

void intelledex_find_q3_q4_q5(const configuration *how, const double wish[], progress *progress)
{
    (void)wish;
    if (how->option[ELBOW] == ELBOW_CHAIN) {
        follow_chain(how, progress);
    } else {
        const planar_arm arm = choose_arm(how, progress);
        progress->q[2] = arm.q3;
        progress->q[3] = arm.q4;
        progress->q[4] = arm.q5;
    }
    for (int i = 0; i < MOST_JOINTS; i++) {
        progress->q[i] = stored(progress->q[i]);
    }
}
