#include "lib/region/refused.h"

#include "armtol/error_matrix.h"
#include "lib/norms/discs.h"
#include "lib/report/finite.h"

#include <math.h>

region_refusal region_refusal_of(armtol_status status, armtol_subject about, size_t number, armtol_region_fault why)
{
    return (region_refusal){{status, about, number}, why};
}

static region_refusal fine(void)
{
    return region_refusal_of(ARMTOL_OK, ARMTOL_ABOUT_NOTHING, 0, ARMTOL_REGION_FINE);
}

static region_refusal check_ranges(const armtol_arm *arm, const armtol_region *region)
{
    const size_t n_joints = armtol_arm_joint_count(arm);
    for (size_t j = 0; j < n_joints; j++) {
        const double low = region->low[j], high = region->high[j];
        if (!isfinite(low) || !isfinite(high) || low > high) {
            return region_refusal_of(ARMTOL_BAD_RANGE, ARMTOL_ABOUT_QUESTION, j, ARMTOL_REGION_RANGE);
        }
    }
    return fine();
}

static bool is_block(const armtol_block *block)
{
    bool is = true;
    for (int i = 0; i < 3; i++) {
        is = is && block->low[i] <= block->high[i]; /* nan is not */
    }
    return is;
}

static bool is_direction(const double v[3])
{
    return all_finite(v, 3) && (v[0] != 0 || v[1] != 0 || v[2] != 0);
}

static bool is_ring(const armtol_ring *ring)
{
    return all_finite(ring->point, 3) && is_direction(ring->axis) && ring->inner >= 0 && ring->inner <= ring->outer &&
           ring->bottom <= ring->top && isfinite(ring->inner);
}

static bool is_path(const armtol_path *path)
{
    return path->n_points > 0 && all_finite(path->points, 3 * path->n_points) && path->radius >= 0 &&
        isfinite(path->radius);
}

static bool is_cone(const armtol_cone *cone)
{
    return is_direction(cone->direction) && cone->angle >= 0 && isfinite(cone->angle);
}

static region_refusal check_shapes(const armtol_region *region)
{
    const bool is[] = {region->block == NULL || is_block(region->block), region->ring == NULL || is_ring(region->ring),
                       region->path == NULL || is_path(region->path), region->cone == NULL || is_cone(region->cone)};
    for (size_t i = 0; i < sizeof is / sizeof is[0]; i++) {
        if (!is[i]) {
            return region_refusal_of(ARMTOL_BAD_RANGE, ARMTOL_ABOUT_QUESTION, i, ARMTOL_REGION_SHAPE);
        }
    }
    return fine();
}

static region_refusal check_asked(const armtol_question *question, const armtol_enclosing *how)
{
    if (question->method == ARMTOL_METHOD_SPHERE && question->tolerances == NULL) {
        return region_refusal_of(ARMTOL_BAD_QUESTION, ARMTOL_ABOUT_METHOD, 0, ARMTOL_REGION_METHOD);
    }
    if (question->spreads != NULL) {
        return region_refusal_of(ARMTOL_BAD_SPREAD, ARMTOL_ABOUT_SPREADS, 0, ARMTOL_REGION_FINE);
    }
    if (how != NULL && how->gap != 0 && !(how->gap >= 1e-6 && how->gap <= 10)) {
        return region_refusal_of(ARMTOL_BAD_RANGE, ARMTOL_ABOUT_QUESTION, 0, ARMTOL_REGION_GAP);
    }
    const armtol_arm *arm = question->arm;
    if (discs_count(question->discs, armtol_column_count(arm->links, arm->n_links)) > 0) {
        return region_refusal_of(ARMTOL_BAD_QUESTION, ARMTOL_ABOUT_DISCS, 0, ARMTOL_REGION_DISCS);
    }
    return fine();
}

region_refusal region_check(const armtol_question *question, const armtol_region *region, const armtol_enclosing *how)
{
    if (question->arm == NULL || (question->accuracy == NULL && question->n_norms == 0 &&
                                  question->tolerances == NULL)) {
        return region_refusal_of(ARMTOL_BAD_QUESTION, ARMTOL_ABOUT_QUESTION, 0, ARMTOL_REGION_FINE);
    }
    for (size_t i = 0; i < question->n_norms; i++) {
        if (i == ARMTOL_MOST_NORMS || !armtol_norm_is_known(question->norms[i].components)) {
            return region_refusal_of(ARMTOL_BAD_NORM, ARMTOL_ABOUT_NORM, i, ARMTOL_REGION_FINE);
        }
    }
    const armtol_status status = armtol_arm_check(question->arm);
    region_refusal refusal = region_refusal_of(status, ARMTOL_ABOUT_ARM, 0, ARMTOL_REGION_FINE);
    if (refusal.fault.status == ARMTOL_OK && !all_finite(question->tool.offset, 3)) {
        refusal.fault.status = ARMTOL_NOT_FINITE;
    }
    if (refusal.fault.status == ARMTOL_OK) {
        refusal = check_ranges(question->arm, region);
    }
    if (refusal.fault.status == ARMTOL_OK) {
        refusal = check_shapes(region);
    }
    return refusal.fault.status == ARMTOL_OK ? check_asked(question, how) : refusal;
}
