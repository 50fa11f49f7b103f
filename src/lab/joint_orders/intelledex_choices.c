#include "lab/joint_orders/intelledex_choices.h"

const choice intelledex_choices[CHOICES] = {
    [BASE] = {"base", "the height of the base", 0,
              {{"inverse", "T06 = inverse(base) T, by invtrf and mpynn"}, {"subtracted", "taken off z"}}},
    [CONSTANTS] = {"constants", "the lengths of the arm in expressions", 0,
                   {{"double", "macros"}, {"float", "elements of arrays, as in the printed routines"}}},
    [ORDER] = {"order", "the joints outside the plane of links 3 and 4", 1,
               {{"q6", "q6 from the shoulder seen by the tool; T05; then q1 and q2 from its z axis"},
                {"q1", "q1 and q2 from the normal of that plane; then q6"}}},
    [LAST_LINK] = {"last-link", "T05", 1,
                   {{"matrix", "T06 inverse(L6), by transf, invtrf and mpynn"},
                    {"written", "written out, with cosine 0 and sine 1 for the right angle"}}},
    [RIGHT_ANGLE] = {"right-angle", "the angle alpha that transf is given", 1,
                     {{"float", "an element of an array, as in the printed routines"}, {"double", "a macro"}}},
    [SINES] = {"sines", "sines and cosines outside of transf and eulerzyx", 1,
               {{"double", "inside expressions"}, {"float", "variables"}}},
    [PLANE] = {"plane", "how vectors get into the plane of links 3 and 4", 2,
               {{"written", "expressions in c1, s1, c2, s2"},
                {"divided", "inverse(L2) inverse(L1), by invtrf and mpynn"}}},
    [Q345] = {"q345", "q3 + q4 + q5", 2,
              {{"x5", "from the x axis of T05"},
               {"z6", "from the z axis of T06"},
               {"euler", "from the Euler angles"}}},
    [WRIST] = {"wrist", "the wrist", 2,
               {{"t06", "the position of T06 less the tool, by the sine and cosine of q345"},
                {"t05", "the position of T05"},
                {"axis", "the position of T06 less the tool along the z axis of T06"},
                {"mpyn1", "the same by mpyn1: T06 times (0, 0, -tool, 1)"}}},
    [ANGLES] = {"angles", "q345 and q34", 2, {{"float", "variables"}, {"double", "inside expressions"}}},
    [LENGTHS] = {"lengths", "coordinates of wrist and shoulder", 2,
                 {{"float", "variables"}, {"double", "inside expressions"}}},
    [ELBOW] = {"elbow", "the joints in the plane", 3,
               {{"q5-solve", "q5 by solve from the shoulder seen by frame 5; then q3"},
                {"q3-solve", "q3 by solve from the wrist; then q4"},
                {"q4-atan2", "q4 by the law of cosines, a root and atan2; then q3"},
                {"q4-acos", "q4 by the law of cosines and acos; then q3"},
                {"q4-pi-acos", "q4 = pi - acos(c), as the Adept's q2; then q3"},
                {"chain", "link by link from the tool: q5, T04, q4, T03; q1, q2, q3 from T03"}}},
    [BRANCH] = {"branch", "which of the two elbows", 3,
                {{"own", "by the joint found first: q3 nearest to 0, q4 positive"},
                 {"q5", "that with q5 nearest to 0"}}},
    [ROOT] = {"root", "the square root outside of solve", 3,
              {{"float", "a variable"}, {"double", "inside an expression"}}},
    [D] = {"d", "the d that solve is given, or the cosine", 3,
           {{"double", "inside an expression"}, {"float", "a variable"}}},
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

static bool uses_right_angle(const configuration *how)
{
    return (uses_t05(how) && how->option[LAST_LINK] == LAST_LINK_MATRIX) ||
           (!is_chain(how) && how->option[PLANE] == PLANE_DIVIDED);
}

bool intelledex_matters(const configuration *how, size_t choice)
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

bool intelledex_makes_sense(const configuration *how)
{
    return !is_chain(how) || how->option[ORDER] == ORDER_Q6_FIRST;
}
