#ifndef ARMTOL_DRAWING_H
#define ARMTOL_DRAWING_H

#include "armtol/interface.h"

ARMTOL_INTERFACE_BEGIN

/*
 * What a drawing says of a part is how far its two axes are apart, r = sqrt(a^2 + d^2), and at what angle they stand.
 * Here the errors of parameters that the tolerances of these two allow, and the way back. (The report's own way back,
 * Eqs (4.32) and (4.33), is machining.h: what it gives can allow the parameters more than they may be off.)
 *
 * Notes:
 * 1) A length has any unit, the same for all of a call; angles are in radians.
 * 2) The errors of a distance are those with which r stays within +- the tolerance, and which the part can reach from
 *    0 without leaving it. Where the tolerance is small beside the lengths that is an interval about 0, its lower end
 *    a little farther off than the upper one. Where the distance may become so short that the axes pass through each
 *    other, the parameter may change its sign, and the interval reaches over to the other side.
 * 3) The results are nan where an argument is, or where a tolerance is negative; infinite where the squares overflow.
 *
 * Reference:
 *    Hahn 1987, section 4.1.3. The report has the upper end of each; the lower end is (4.13) with -rd.
 */

/* What a parameter may be off: from low, not above 0, to high, not below 0. */
typedef struct armtol_range {
    double low, high;
} armtol_range;

/*
 * The range of the error of a, d being exact. That of the error of d, a being exact, is the same with a and d changed
 * about.
 *
 * Given:
 *    a, d        the lengths of the link as meant, of either sign
 *    tolerance   of the distance of its axes, >= 0
 * Returned:
 *    range of the error of a.
 * Reference:
 *    Hahn 1987, Eqs (4.14) and (4.15).
 */
armtol_range armtol_drawing_length(double a, double d, double tolerance);

/*
 * The range of the error of a where d has the same error.
 *
 * Given and Returned:
 *    as above.
 * Reference:
 *    Hahn 1987, Eq. (4.16).
 */
armtol_range armtol_drawing_length_both(double a, double d, double tolerance);

/*
 * The error that alpha and beta may have each where they share the tolerance of an angle evenly.
 *
 * Given:
 *    tolerance   of the angle of the two axes, 0 <= tolerance < pi/2
 * Returned:
 *    the largest error of alpha, and of beta, >= 0.
 * Reference:
 *    Hahn 1987, Eq. (4.17).
 */
double armtol_drawing_angle_even(double tolerance);

/*
 * The errors of alpha and beta of an axis on the rim of the cone that the tolerance of an angle allows.
 *
 * Given:
 *    tolerance   of the angle, half the opening of the cone, 0 <= tolerance < pi/2
 *    phi         the direction in which the axis leans, from that of alpha towards that of beta
 * Returned:
 *    alpha, beta their errors; their tangents are the parts of tan tolerance along phi and across it.
 * Reference:
 *    Hahn 1987, Eqs (4.18) and (4.19).
 */
void armtol_drawing_angle_at(double tolerance, double phi, double *alpha, double *beta);

/*
 * The radius of the disc that holds all errors of alpha and beta which the tolerance of an angle allows: sqrt(2) times
 * the even share, since the rim bulges most there, by tolerance^2 / 6 of it.
 *
 * Given:
 *    tolerance   of the angle, 0 <= tolerance < pi/2
 * Returned:
 *    the radius: alpha^2 + beta^2 <= radius^2 for both of armtol_drawing_angle_at.
 * Reference:
 *    Hahn 1987, Eqs (4.17) to (4.19); the disc is ours.
 */
double armtol_drawing_radius(double tolerance);

/*
 * The way back: the largest tolerance of a drawing that allows no more than this. Ours.
 *
 * Given:
 *    a, d        the lengths of the link as meant
 *    error       what the error of a (of a and of d, which have the same; of alpha and beta together) may be, >= 0
 * Returned:
 *    armtol_drawing_distance         of the distance, d being exact: neither end of armtol_drawing_length is beyond
 *                                    +-error
 *    armtol_drawing_distance_both    likewise of armtol_drawing_length_both
 *    armtol_drawing_angle            of the angle, at most 1.57: armtol_drawing_radius is not beyond the error
 * Notes:
 * 1) Found by halving, with the routines of the way there: so it keeps to the error to the last bit, and a tolerance
 *    one bit larger does not (but for the 1.57).
 * 2) nan where the error is, or is negative; infinite for distances where it is.
 */
double armtol_drawing_distance(double a, double d, double error);
double armtol_drawing_distance_both(double a, double d, double error);
double armtol_drawing_angle(double error);

ARMTOL_INTERFACE_END

#endif
