/* The Intelledex's family: invintell. */

#include "lab/joint_orders/family.h"

#include "armtol/euler.h"
#include "armtol/transform.h"

#include <math.h>
#include <string.h>

#define BASE_HEIGHT 359.7
#define UPPER_ARM 373.4
#define FOREARM 279.4
#define TOOL_LENGTH 100.0

enum {
    BASE, CONSTANTS, ORDER, LAST_LINK, RIGHT_ANGLE, SINES, PLANE, Q345, WRIST, ANGLES, LENGTHS, ELBOW, BRANCH, ROOT, D,
    LAST, CHOICES
};

/* The options that the steps ask for by name; the others are float and double. */
enum { BASE_INVERSE, BASE_SUBTRACTED };
enum { CONSTANTS_DOUBLE };
enum { ORDER_Q6_FIRST, ORDER_Q1_FIRST };
enum { LAST_LINK_MATRIX, LAST_LINK_WRITTEN };
enum { PLANE_WRITTEN, PLANE_DIVIDED };
enum { Q345_X5, Q345_Z6, Q345_EULER };
enum { WRIST_T06, WRIST_T05, WRIST_AXIS, WRIST_MPYN1 };
enum { ELBOW_Q5_SOLVE, ELBOW_Q3_SOLVE, ELBOW_Q4_ATAN2, ELBOW_Q4_ACOS, ELBOW_Q4_PI_ACOS, ELBOW_CHAIN };
enum { BRANCH_OWN, BRANCH_Q5 };
enum { LAST_SUM, LAST_DIFFERENCE };

static const choice choices[CHOICES] = {
    [BASE] = {"base", "the height of the base",
              {{"inverse", "T06 = inverse(base) T, by invtrf and mpynn"}, {"subtracted", "taken off z"}}},
    [CONSTANTS] = {"constants", "the lengths of the arm in expressions",
                   {{"double", "macros"}, {"float", "elements of arrays, as in the printed routines"}}},
    [ORDER] = {"order", "the joints outside the plane of links 3 and 4",
               {{"q6", "q6 from the shoulder seen by the tool; T05; then q1 and q2 from its z axis"},
                {"q1", "q1 and q2 from the normal of that plane; then q6"}}},
    [LAST_LINK] = {"last-link", "T05",
                   {{"matrix", "T06 inverse(L6), by transf, invtrf and mpynn"},
                    {"written", "written out, with cosine 0 and sine 1 for the right angle"}}},
    [RIGHT_ANGLE] = {"right-angle", "the angle alpha that transf is given",
                     {{"float", "an element of an array, as in the printed routines"}, {"double", "a macro"}}},
    [SINES] = {"sines", "sines and cosines outside of transf and eulerzyx",
               {{"double", "inside expressions"}, {"float", "variables"}}},
    [PLANE] = {"plane", "how vectors get into the plane of links 3 and 4",
               {{"written", "expressions in c1, s1, c2, s2"},
                {"divided", "inverse(L2) inverse(L1), by invtrf and mpynn"}}},
    [Q345] = {"q345", "q3 + q4 + q5",
              {{"x5", "from the x axis of T05"},
               {"z6", "from the z axis of T06"},
               {"euler", "from the Euler angles"}}},
    [WRIST] = {"wrist", "the wrist",
               {{"t06", "the position of T06 less the tool, by the sine and cosine of q345"},
                {"t05", "the position of T05"},
                {"axis", "the position of T06 less the tool along the z axis of T06"},
                {"mpyn1", "the same by mpyn1: T06 times (0, 0, -tool, 1)"}}},
    [ANGLES] = {"angles", "q345 and q34", {{"float", "variables"}, {"double", "inside expressions"}}},
    [LENGTHS] = {"lengths", "coordinates of wrist and shoulder",
                 {{"float", "variables"}, {"double", "inside expressions"}}},
    [ELBOW] = {"elbow", "the joints in the plane",
               {{"q5-solve", "q5 by solve from the shoulder seen by frame 5; then q3"},
                {"q3-solve", "q3 by solve from the wrist; then q4"},
                {"q4-atan2", "q4 by the law of cosines, a root and atan2; then q3"},
                {"q4-acos", "q4 by the law of cosines and acos; then q3"},
                {"q4-pi-acos", "q4 = pi - acos(c), as the Adept's q2; then q3"},
                {"chain", "link by link from the tool: q5, T04, q4, T03; q1, q2, q3 from T03"}}},
    [BRANCH] = {"branch", "which of the two elbows",
                {{"own", "by the joint found first: q3 nearest to 0, q4 positive"},
                 {"q5", "that with q5 nearest to 0"}}},
    [ROOT] = {"root", "the square root outside of solve",
              {{"float", "a variable"}, {"double", "inside an expression"}}},
    [D] = {"d", "the d that solve is given, or the cosine",
           {{"double", "inside an expression"}, {"float", "a variable"}}},
    [LAST] = {"last", "the joint of the plane that is left",
              {{"sum", "q345 less the other two"},
               {"difference", "of two sums of joints; in the chain read off T03"}}},
};

static bool is_chain(const configuration *how)
{
    return how->option[ELBOW] == ELBOW_CHAIN;
}

static bool uses_t05(const configuration *how)
{
    return is_chain(how) || how->option[ORDER] == ORDER_Q6_FIRST || how->option[Q345] == Q345_X5 ||
           how->option[WRIST] == WRIST_T05;
}

static bool uses_right_angle(const configuration *how)
{
    return (uses_t05(how) && how->option[LAST_LINK] == LAST_LINK_MATRIX) ||
           (!is_chain(how) && how->option[PLANE] == PLANE_DIVIDED);
}

static bool matters(const configuration *how, size_t choice)
{
    const int elbow = how->option[ELBOW];
    switch (choice) {
    case BASE: /* else the height is rounded in both ways */
        return how->option[CONSTANTS] == CONSTANTS_DOUBLE;
    case PLANE: /* a chain has no need of the plane */
    case Q345:
    case WRIST:
    case ANGLES:
    case LENGTHS:
        return !is_chain(how);
    case LAST_LINK:
        return uses_t05(how);
    case RIGHT_ANGLE:
        return uses_right_angle(how);
    case BRANCH:
        return elbow != ELBOW_Q5_SOLVE && !is_chain(how);
    case ROOT:
        return elbow == ELBOW_Q4_ATAN2;
    case LAST:
        return elbow == ELBOW_Q5_SOLVE || elbow == ELBOW_Q3_SOLVE || is_chain(how);
    default:
        return true;
    }
}

static bool makes_sense(const configuration *how)
{
    return !is_chain(how) || how->option[ORDER] == ORDER_Q6_FIRST;
}

/* ---- values of one kind in the steps that are not printed, each as the configuration keeps them ---- */

static double keep(const configuration *how, size_t choice, double value)
{
    return kept(choices, how, choice, value);
}

static double sine(const configuration *how, double angle)
{
    return keep(how, SINES, sin(angle));
}

static double cosine(const configuration *how, double angle)
{
    return keep(how, SINES, cos(angle));
}

static double constant(const configuration *how, double value)
{
    return keep(how, CONSTANTS, value);
}

/* ---- the routines for matrices as the listing prints them: each element and each term of a sum is stored ---- */

/* mpynn, invtrf */
static armtol_transform product(const armtol_transform *left, const armtol_transform *right)
{
    return armtol_transform_product(left, right, &armtol_errata_1987);
}

static armtol_transform inverse(const armtol_transform *transform)
{
    return armtol_transform_inverse(transform, &armtol_errata_1987);
}

/* transf, Craig's order; alpha is -1, 0 or 1 right angle, given to transf as the configuration says. */
static armtol_transform link_of(const configuration *how, double a, int alpha, double d, double theta)
{
    const double kalpha = keep(how, RIGHT_ANGLE, alpha * HEADER_PI / 2);
    const double sa = stored(sin(kalpha)), ca = stored(cos(kalpha));
    const double st = stored(sin(theta)), ct = stored(cos(theta));
    armtol_transform link = {{
        {ct, -st, 0, a},
        {st * ca, ct * ca, -sa, -sa * d},
        {st * sa, ct * sa, ca, ca * d},
        {0, 0, 0, 1},
    }};
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 4; j++) {
            link.m[i][j] = stored(link.m[i][j]);
        }
    }
    return link;
}

/* inverse(link) transform, and transform inverse(link) */
static armtol_transform behind(const armtol_transform *link, const armtol_transform *transform)
{
    const armtol_transform back = inverse(link);
    return product(&back, transform);
}

static armtol_transform without(const armtol_transform *transform, const armtol_transform *link)
{
    const armtol_transform back = inverse(link);
    return product(transform, &back);
}

/* ---- joints 6, 1 and 2, and T05 ---- */

/* What the steps have found so far. */
typedef struct found {
    armtol_transform t06, t05;
    double *q;
    double q345, px, py; /* q3 + q4 + q5, the wrist in the plane of links 3 and 4 */
} found;

static armtol_transform t06_of(const configuration *how, const double wish[])
{
    const double height = constant(how, BASE_HEIGHT);
    armtol_transform tool = armtol_pose_to_transform(wish, &armtol_errata_1987);
    if (how->option[BASE] == BASE_SUBTRACTED) {
        tool.m[2][3] = stored(wish[2] - height);
        return tool;
    }
    const armtol_transform base = link_of(how, 0, 0, height, 0);
    return behind(&base, &tool);
}

static armtol_transform t05_of(const configuration *how, const armtol_transform *t06, double q6)
{
    const double tool = constant(how, TOOL_LENGTH);
    if (how->option[LAST_LINK] == LAST_LINK_MATRIX) {
        const armtol_transform link6 = link_of(how, 0, 1, tool, q6);
        return without(t06, &link6);
    }
    const double c6 = cosine(how, q6), s6 = sine(how, q6);
    armtol_transform t05 = *t06;
    for (int i = 0; i < 3; i++) {
        const double *row = t06->m[i];
        t05.m[i][0] = stored(c6 * row[0] - s6 * row[1]);
        t05.m[i][1] = -row[2];
        t05.m[i][2] = stored(s6 * row[0] + c6 * row[1]);
        t05.m[i][3] = stored(row[3] - tool * row[2]);
    }
    return t05;
}

/* Joints 1 and 2, which bring the common axis of joints 3 to 5 to (x, y, z). */
static void aim(const configuration *how, double x, double y, double z, double q[])
{
    q[0] = stored(atan2(y, x));
    q[1] = stored(atan2(cosine(how, q[0]) * x + sine(how, q[0]) * y, z));
}

static void aim_along_z(const configuration *how, const armtol_transform *t, double q[])
{
    aim(how, t->m[0][2], t->m[1][2], t->m[2][2], q);
}

/* The axis of joint 5 is square to the tool's axis and to the line from the shoulder to the tool. */
static void find_q1_q2_q6(const configuration *how, const armtol_transform *t06, double q[])
{
    const double(*t)[4] = t06->m;
    double normal[3];
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        normal[i] = stored(t[j][2] * t[k][3] - t[k][2] * t[j][3]);
    }
    aim(how, normal[0], normal[1], normal[2], q);
    const double c2 = cosine(how, q[1]), s2 = sine(how, q[1]);
    const double x = cosine(how, q[0]) * s2, y = sine(how, q[0]) * s2;
    q[5] = stored(atan2(x * t[0][0] + y * t[1][0] + c2 * t[2][0], x * t[0][1] + y * t[1][1] + c2 * t[2][1]));
}

static void find_q6_q1_q2(const configuration *how, found *found)
{
    if (how->option[ORDER] == ORDER_Q6_FIRST) {
        const armtol_transform t60 = inverse(&found->t06);
        found->q[5] = stored(atan2(t60.m[1][3], -t60.m[0][3]));
        found->t05 = t05_of(how, &found->t06, found->q[5]);
        aim_along_z(how, &found->t05, found->q);
    } else {
        find_q1_q2_q6(how, &found->t06, found->q);
        found->t05 = t05_of(how, &found->t06, found->q[5]);
    }
}

/* ---- q345 and the wrist ---- */

/* A vector in the plane of links 3 and 4: along link 3 at q3 = 0, and square to it. */
typedef struct planar {
    double along, across;
} planar;

static planar written_out(const configuration *how, const double q[], double x, double y, double z)
{
    const double c1 = cosine(how, q[0]), s1 = sine(how, q[0]), c2 = cosine(how, q[1]), s2 = sine(how, q[1]);
    return (planar){c1 * c2 * x + s1 * c2 * y - s2 * z, -s1 * x + c1 * y};
}

/* A column of t. Links 1 and 2 divided out, the plane's axes are x and z of frame 2. */
static planar column_in_plane(const configuration *how, const double q[], const armtol_transform *t, int column)
{
    if (how->option[PLANE] == PLANE_WRITTEN) {
        return written_out(how, q, t->m[0][column], t->m[1][column], t->m[2][column]);
    }
    const armtol_transform link1 = link_of(how, 0, 0, 0, q[0]), link2 = link_of(how, 0, -1, 0, q[1]);
    const armtol_transform in_frame1 = behind(&link1, t), in_frame2 = behind(&link2, &in_frame1);
    return (planar){in_frame2.m[0][column], in_frame2.m[2][column]};
}

static planar tool_axis_of_euler(const configuration *how, const double wish[], const double q[])
{
    const double cg = cosine(how, wish[3]), sg = sine(how, wish[3]), cb = cosine(how, wish[4]);
    const double sb = sine(how, wish[4]), ca = cosine(how, wish[5]), sa = sine(how, wish[5]);
    return written_out(how, q, ca * sb * cg + sa * sg, sa * sb * cg - ca * sg, cb * cg);
}

/* The tool's axis is a quarter turn behind the x axis of frame 5. */
static double q345_of(const configuration *how, const double wish[], const found *found)
{
    if (how->option[Q345] == Q345_X5) {
        const planar x5 = column_in_plane(how, found->q, &found->t05, 0);
        return atan2(x5.across, x5.along);
    }
    const planar axis = how->option[Q345] == Q345_Z6 ? column_in_plane(how, found->q, &found->t06, 2)
                                                     : tool_axis_of_euler(how, wish, found->q);
    return atan2(axis.along, -axis.across);
}

static planar wrist_of(const configuration *how, const found *found)
{
    const double tool = constant(how, TOOL_LENGTH);
    const int option = how->option[WRIST];
    if (option == WRIST_T06) {
        const planar end = column_in_plane(how, found->q, &found->t06, 3);
        return (planar){end.along - tool * sine(how, found->q345), end.across + tool * cosine(how, found->q345)};
    }
    armtol_transform wrist = option == WRIST_T05 ? found->t05 : found->t06;
    for (int i = 0; i < 3 && option != WRIST_T05; i++) {
        const double back = -tool * wrist.m[i][2];
        wrist.m[i][3] = stored((option == WRIST_MPYN1 ? stored(back) : back) + wrist.m[i][3]);
    }
    return column_in_plane(how, found->q, &wrist, 3);
}

/* ---- joints 3 to 5: the joint of the plane that comes first, two answers, one for each sign ---- */

/* One of the two angles of solve, by the sign of its root. Its storage is printed. */
static double solve_angle(double px, double py, double d, double sign)
{
    const double sq = stored(sqrt(py * py + px * px - d * d));
    return stored(atan2(px, -py) - atan2(d, sign * sq));
}

/* The angle that solve takes for a tclose of 0. */
static double nearest(double theta1, double theta2)
{
    return stored(theta1 * theta1) <= stored(theta2 * theta2) ? theta1 : theta2;
}

/* q5 from the shoulder at (x, y) in frame 5. */
static double q5_of(const configuration *how, double x, double y, double sign)
{
    const double upper = constant(how, UPPER_ARM), fore = constant(how, FOREARM);
    const double d = keep(how, D, (upper * upper - fore * fore - x * x - y * y) / (2 * fore));
    return solve_angle(x, -y, d, sign);
}

static double q5_of_wrist(const configuration *how, const found *found, double sign)
{
    const double c345 = cosine(how, found->q345), s345 = sine(how, found->q345);
    return q5_of(how, keep(how, LENGTHS, -(c345 * found->px + s345 * found->py)),
                 keep(how, LENGTHS, s345 * found->px - c345 * found->py), sign);
}

static double q4_of_cosine(const configuration *how, double c, double sign)
{
    switch (how->option[ELBOW]) {
    case ELBOW_Q4_ATAN2:
        return atan2(sign * keep(how, ROOT, sqrt(1 - c * c)), c);
    case ELBOW_Q4_ACOS:
        return sign * acos(c);
    default:
        return sign * (HEADER_PI - acos(-c));
    }
}

static double first_joint(const configuration *how, const found *found, double sign)
{
    const double upper = constant(how, UPPER_ARM), fore = constant(how, FOREARM);
    const double square = found->px * found->px + found->py * found->py;
    switch (how->option[ELBOW]) {
    case ELBOW_Q5_SOLVE:
        return q5_of_wrist(how, found, sign);
    case ELBOW_Q3_SOLVE:
        return solve_angle(found->px, found->py,
                           keep(how, D, (square + upper * upper - fore * fore) / (2 * upper)), sign);
    default:
        return stored(q4_of_cosine(
            how, keep(how, D, (square - upper * upper - fore * fore) / (2 * upper * fore)), sign));
    }
}

/* ---- the other two ---- */

/* q3, q4 and q5 of the one that was found first. */
static void complete(const configuration *how, const found *found, double first, double q[3])
{
    const double upper = constant(how, UPPER_ARM), fore = constant(how, FOREARM);
    const bool by_sum = how->option[LAST] == LAST_SUM;
    const double px = found->px, py = found->py, q345 = found->q345;
    if (how->option[ELBOW] == ELBOW_Q5_SOLVE) {
        const double q34 = keep(how, ANGLES, q345 - first);
        q[2] = first;
        q[0] = stored(atan2(py - fore * sine(how, q34), px - fore * cosine(how, q34)));
        q[1] = by_sum ? q345 - q[0] - q[2] : q34 - q[0];
    } else if (how->option[ELBOW] == ELBOW_Q3_SOLVE) {
        q[0] = first;
        const double q34 = keep(how, ANGLES, atan2(py - upper * sine(how, first), px - upper * cosine(how, first)));
        q[1] = stored(q34 - first);
        q[2] = by_sum ? q345 - first - q[1] : q345 - q34;
    } else {
        q[1] = first;
        q[0] = stored(atan2(py, px) - atan2(fore * sine(how, first), upper + fore * cosine(how, first)));
        q[2] = q345 - q[0] - first;
    }
}

static void find_q3_q4_q5(const configuration *how, const found *found)
{
    const double plus = first_joint(how, found, 1), minus = first_joint(how, found, -1);
    double *q = found->q + 2, other[3];
    if (how->option[BRANCH] == BRANCH_OWN) {
        const bool by_solve = how->option[ELBOW] == ELBOW_Q5_SOLVE || how->option[ELBOW] == ELBOW_Q3_SOLVE;
        complete(how, found, by_solve ? nearest(plus, minus) : plus, q);
        return;
    }
    complete(how, found, plus, q);
    complete(how, found, minus, other);
    if (fabs(other[2]) < fabs(q[2])) {
        memcpy(q, other, sizeof other);
    }
}

/* Link by link from the tool, no plane needed. */
static void follow_chain(const configuration *how, const found *found)
{
    double *q = found->q;
    const armtol_transform *t05 = &found->t05, t50 = inverse(t05);
    q[4] = nearest(q5_of(how, t50.m[0][3], t50.m[1][3], 1), q5_of(how, t50.m[0][3], t50.m[1][3], -1));
    const armtol_transform link5 = link_of(how, constant(how, FOREARM), 0, 0, q[4]);
    const armtol_transform t04 = without(t05, &link5), t40 = inverse(&t04);
    q[3] = stored(atan2(t40.m[1][3], -t40.m[0][3]));
    const armtol_transform link4 = link_of(how, constant(how, UPPER_ARM), 0, 0, q[3]);
    const armtol_transform t03 = without(&t04, &link4);
    aim_along_z(how, &t03, q);
    q[2] = how->option[LAST] == LAST_SUM ? atan2(t05->m[2][1], -t05->m[2][0]) - q[3] - q[4]
                                         : atan2(t03.m[2][1], -t03.m[2][0]);
}

static void solve(const configuration *how, const double wish[], double q[])
{
    found found = {.t06 = t06_of(how, wish), .q = q};
    find_q6_q1_q2(how, &found);
    if (is_chain(how)) {
        follow_chain(how, &found);
    } else {
        found.q345 = keep(how, ANGLES, q345_of(how, wish, &found));
        const planar wrist = wrist_of(how, &found);
        found.px = keep(how, LENGTHS, wrist.along);
        found.py = keep(how, LENGTHS, wrist.across);
        find_q3_q4_q5(how, &found);
    }
    for (int i = 2; i < 5; i++) {
        q[i] = stored(q[i]);
    }
}

const family family_intelledex = {
    .program = "intella",
    .robot = &armtol_intelledex_605t,
    .choices = choices,
    .n_choices = CHOICES,
    .solve = solve,
    .matters = matters,
    .makes_sense = makes_sense,
    .left_out = "elbow=chain with order=q1, which would find q1 and q2 twice",
};
