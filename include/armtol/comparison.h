#ifndef ARMTOL_COMPARISON_H
#define ARMTOL_COMPARISON_H

#include "armtol/arm.h"
#include "armtol/interface.h"
#include "armtol/tool_point.h"

#include <stddef.h>

ARMTOL_INTERFACE_BEGIN

/*
 * Two arms of the same joints, one as meant and one as built (or nominal and identified, or with and without what a
 * calibration found): how far apart their tools are at the same joint values, and which parameters that comes from.
 *
 * Notes:
 * 1) Both have the same number of links, the same joints, motions alike, and lengths in the same unit. Their kinds of
 *    links may differ: all five parameters of (4.1) are compared, whatever a kind counts.
 * 2) Errors are as in tool_error.h: exact, not to first order.
 * 3) What one parameter explains is the exact error of the arm as meant with that parameter alone as built. What is
 *    left, the error less the sum of all explained, is what the differences do together; it is of second order.
 */

/* One parameter that is not the same: as built less as meant, an angle between -pi and pi. */
typedef struct armtol_difference {
    size_t link;
    armtol_parameter parameter;
    double value;
} armtol_difference;

/*
 * The parameters that differ.
 *
 * Given:
 *    meant, built   the arms
 * Returned:
 *    differences    in link order and the order of (4.1), but for those of less than four roundings of the
 *                   parameter; room for ARMTOL_PARAMETER_COUNT a link
 *    n_differences  their number
 * Errors:
 *    those of armtol_arm_check, of either arm; ARMTOL_WRONG_SIZE where the numbers of links differ; ARMTOL_BAD_JOINT
 *    where a joint or a motion does.
 */
armtol_status armtol_arm_differences(const armtol_arm *meant, const armtol_arm *built,
                                     armtol_difference differences[], size_t *n_differences);

/*
 * Where the tool of the arm as built is, less where it should be, in one pose, and what explains it.
 *
 * Given:
 *    meant, built   the arms, for which armtol_arm_differences has been asked
 *    q              a value each joint that moves by itself, radians or lengths; NULL for an arm without joints
 *    n_joints       their number
 *    tool           the point, and the axes along which errors are counted: the base's, or those of the tool as meant
 *    differences    what it said; n_differences of them
 *    work           room for as many links as the arm has
 * Returned:
 *    error          dx, dy, dz, then the rotation vector
 *    explained      6 a difference, in their order
 * Errors:
 *    those of armtol_arm_place, of either arm.
 */
armtol_status armtol_arm_compare(const armtol_arm *meant, const armtol_arm *built, const double q[], size_t n_joints,
                                 const armtol_tool_point *tool, const armtol_difference differences[],
                                 size_t n_differences, armtol_link work[], double error[6], double explained[]);

ARMTOL_INTERFACE_END

#endif
