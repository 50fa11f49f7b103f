/*
 * Method:
 *    The exact error between two chains, once for both arms and once for each parameter alone.
 * Special cases:
 *    An angle that differs by whole turns does not differ.
 * Accuracy:
 *    Errors have the roundings of the two positions: some 1e-16 of the arm's size. test_comparison.c holds what is
 *    explained against A, which differs in second order only.
 */

#include "armtol/comparison.h"

#include "armtol/link_transform.h"
#include "armtol/transform.h"
#include "lib/arms/motion.h"
#include "lib/pi.h"
#include "lib/tool/built.h"

#include <float.h>
#include <math.h>

static bool moves_alike(const armtol_arm *one, const armtol_arm *other, size_t link)
{
    const armtol_motion a = arm_motion(one, link), b = arm_motion(other, link);
    return one->links[link].joint == other->links[link].joint && a.follows == b.follows && a.sign == b.sign &&
           a.multiplier == b.multiplier && a.offset == b.offset;
}

static armtol_status check_alike(const armtol_arm *meant, const armtol_arm *built)
{
    armtol_status status = armtol_arm_check(meant);
    status = status == ARMTOL_OK ? armtol_arm_check(built) : status;
    if (status != ARMTOL_OK) {
        return status;
    }
    if (meant->n_links != built->n_links) {
        return ARMTOL_WRONG_SIZE;
    }
    for (size_t i = 0; i < meant->n_links; i++) {
        if (!moves_alike(meant, built, i)) {
            return ARMTOL_BAD_JOINT;
        }
    }
    return ARMTOL_OK;
}

/* 0 where the two differ as the same number in other units does: 0.2 m and 200 mm. */
static double difference_of(armtol_link meant, armtol_link built, armtol_parameter parameter)
{
    const double from = *armtol_link_parameter(&meant, parameter), to = *armtol_link_parameter(&built, parameter);
    if (fabs(to - from) <= 4 * DBL_EPSILON * fabs(from)) {
        return 0;
    }
    return armtol_parameter_is_length(parameter) ? to - from : remainder(to - from, 2 * PI);
}

armtol_status armtol_arm_differences(const armtol_arm *meant, const armtol_arm *built,
                                     armtol_difference differences[], size_t *n_differences)
{
    const armtol_status status = check_alike(meant, built);
    *n_differences = 0;
    for (size_t i = 0; i < meant->n_links && status == ARMTOL_OK; i++) {
        for (int p = 0; p < ARMTOL_PARAMETER_COUNT; p++) {
            const armtol_parameter parameter = (armtol_parameter)p;
            const double value = difference_of(meant->links[i], built->links[i], parameter);
            if (value != 0) {
                differences[(*n_differences)++] = (armtol_difference){i, parameter, value};
            }
        }
    }
    return status;
}

static armtol_status chain_of(const armtol_arm *arm, const double q[], size_t n_joints, armtol_link placed[],
                              armtol_transform *chain)
{
    const armtol_status status = armtol_arm_place(arm, q, n_joints, placed);
    if (status == ARMTOL_OK) {
        *chain = armtol_chain_transform(placed, arm->n_links, &armtol_errata_none);
    }
    return status;
}

armtol_status armtol_arm_compare(const armtol_arm *meant, const armtol_arm *built, const double q[], size_t n_joints,
                                 const armtol_tool_point *tool, const armtol_difference differences[],
                                 size_t n_differences, armtol_link work[], double error[6], double explained[])
{
    armtol_transform as_meant, as_built;
    armtol_status status = chain_of(built, q, n_joints, work, &as_built);
    status = status == ARMTOL_OK ? chain_of(meant, q, n_joints, work, &as_meant) : status;
    if (status != ARMTOL_OK) {
        return status;
    }
    built_error(&as_built, &as_meant, tool, error);
    for (size_t k = 0; k < n_differences; k++) {
        double *const parameter = armtol_link_parameter(&work[differences[k].link], differences[k].parameter);
        const double kept = *parameter;
        *parameter += differences[k].value;
        as_built = armtol_chain_transform(work, meant->n_links, &armtol_errata_none);
        *parameter = kept;
        built_error(&as_built, &as_meant, tool, explained + 6 * k);
    }
    return ARMTOL_OK;
}
