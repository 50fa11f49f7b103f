#include "lab/joint_orders/intelledex_choices.h"

const choice intelledex_choices[CHOICES] = {
    [MATRICES] = {"matrices", "elements of matrices", 0,
                  {{"float", "stored"}, {"double", "not stored"}}},
    [SUMS] = {"sums", "an element of a product of matrices", 0,
              {{"each", "stored after each term"}, {"once", "summed in double, then stored"}}},
    [SINES] = {"sines", "sines and cosines", 0,
               {{"double", "inside expressions, not stored"}, {"float", "stored"}}},
    [BASE] = {"base", "the height of the base", 0,
              {{"inverse", "T06 = inverse(base) T"}, {"subtracted", "taken off z"}}},
    [CONSTANTS] = {"constants", "the lengths of the arm", 0,
                   {{"double", "macros"}, {"float", "variables"}}},
    [ORDER] = {"order", "the joints outside the plane of links 3 and 4", 1,
               {{"q6", "q6 from the shoulder seen by the tool; T05; then q1 and q2 from its z axis"},
                {"q1", "q1 and q2 from the normal of that plane; then q6"}}},
    [LAST_LINK] = {"last-link", "T05", 1,
                   {{"matrix", "T06 inverse(L6)"},
                    {"written", "written out, L6 taken to turn by a right angle"}}},
    [RIGHT_ANGLE] = {"right-angle", "the angle alpha in the matrix of a link", 1,
                     {{"float", "pi/2, stored"}, {"double", "pi/2"}, {"exact", "cosine 0, sine 1"}}},
    [PI] = {"pi", "pi", 1, {{"3.14159", "the macro of the headers"}, {"true", "all digits of a double"}}},
    [JOINTS] = {"joints", "joint values", 1,
                {{"float", "stored at once"},
                 {"late", "stored at the end, not before they are used"},
                 {"double", "never stored, unlike in the listings"}}},
    [PLANE] = {"plane", "into the plane of links 3 and 4", 2,
               {{"written", "expressions in c1, s1, c2, s2"},
                {"divided", "inverse(L2) inverse(L1), by matrices"}}},
    [Q345] = {"q345", "q3 + q4 + q5", 2,
              {{"x5", "from the x axis of T05"},
               {"z6", "from the z axis of T06"},
               {"euler", "from the Euler angles"}}},
    [WRIST] = {"wrist", "the wrist", 2,
               {{"t06", "the position of T06 less the tool turned by q345"},
                {"t05", "the position of T05"},
                {"axis", "the position of T06 less the tool along the z axis of T06"}}},
    [ANGLES] = {"angles", "q345 and q34", 2, {{"float", "stored"}, {"double", "not stored"}}},
    [LENGTHS] = {"lengths", "coordinates of wrist and shoulder", 2,
                 {{"float", "stored"}, {"double", "not stored"}}},
    [ELBOW] = {"elbow", "the joints in the plane", 3,
               {{"q5-solve", "q5 by solve from the shoulder seen by frame 5; then q3"},
                {"q3-solve", "q3 by solve from the wrist; then q4"},
                {"q4-atan2", "q4 by the law of cosines, a root and atan2; then q3"},
                {"q4-acos", "q4 by the law of cosines and acos; then q3"},
                {"q4-pi-acos", "q4 = pi - acos(c), as the Adept's q2; then q3"},
                {"chain", "links 5 and 4 divided out too: q5, T04, q4, T03; q1, q2, q3 from T03"}}},
    [BRANCH] = {"branch", "which of the two elbows", 3,
                {{"own", "by the joint found first: q3 nearest to 0, q4 positive"},
                 {"q5", "that with q5 nearest to 0"}}},
    [ROOT] = {"root", "the square root", 3, {{"float", "stored"}, {"double", "not stored"}}},
    [D] = {"d", "the d that solve is given, or the cosine", 3,
           {{"double", "not stored"}, {"float", "stored"}}},
    [LAST] = {"last", "the joint of the plane that is left", 3,
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

static bool divides_l2_out(const configuration *how)
{
    return !is_chain(how) && how->option[PLANE] == PLANE_DIVIDED;
}

static bool uses_right_angle(const configuration *how)
{
    return (uses_t05(how) && how->option[LAST_LINK] == LAST_LINK_MATRIX) || divides_l2_out(how);
}

/* That with the base's inverse is a single sum, of z and the height. */
static bool sums_products(const configuration *how)
{
    return how->option[ORDER] == ORDER_Q6_FIRST || is_chain(how) || uses_right_angle(how);
}

static bool pi_matters(const configuration *how)
{
    return how->option[ELBOW] == ELBOW_Q4_PI_ACOS ||
           (uses_right_angle(how) && how->option[RIGHT_ANGLE] != RIGHT_ANGLE_EXACT);
}

bool intelledex_matters(const configuration *how, size_t choice)
{
    const int elbow = how->option[ELBOW];
    switch (choice) {
    case SUMS:
        return how->option[MATRICES] == STORED && sums_products(how);
    case BASE: /* else the height is rounded in both ways, or in neither */
        return how->option[MATRICES] == STORED && how->option[CONSTANTS] == CONSTANTS_DOUBLE;
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
    case PI:
        return pi_matters(how);
    case BRANCH:
        return elbow != ELBOW_Q5_SOLVE && !is_chain(how);
    case ROOT:
        return elbow != ELBOW_Q4_ACOS && elbow != ELBOW_Q4_PI_ACOS;
    case LAST:
        return elbow == ELBOW_Q5_SOLVE || elbow == ELBOW_Q3_SOLVE || is_chain(how);
    default:
        return true;
    }
}

bool intelledex_makes_sense(const configuration *how)
{
    return !is_chain(how) || how->option[ORDER] == ORDER_Q6_FIRST;
}
