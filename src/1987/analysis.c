#include "1987/analysis.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

bool analysis_start(analysis *analysis, const armtol_robot *robot, const armtol_errata *errata)
{
    memset(analysis, 0, sizeof *analysis);
    analysis->robot = robot;
    analysis->errata = *errata;
    analysis->links = calloc(robot->n_links, sizeof *analysis->links);
    if (analysis->links == NULL) {
        return false;
    }
    robot->links(errata, analysis->links);
    analysis->n_columns = armtol_column_count(analysis->links, robot->n_links);
    analysis->columns = calloc(analysis->n_columns, sizeof *analysis->columns);
    analysis->order = calloc(analysis->n_columns, sizeof *analysis->order);
    analysis->wish = calloc(2 * (robot->n_wish + robot->n_joints + 6 * analysis->n_columns) + robot->n_links,
                            sizeof *analysis->wish);
    if (analysis->columns == NULL || analysis->order == NULL || analysis->wish == NULL) {
        analysis_free(analysis);
        return false;
    }
    analysis->check = analysis->wish + robot->n_wish;
    analysis->q = analysis->check + robot->n_wish;
    analysis->motor = analysis->q + robot->n_joints;
    analysis->matrix = analysis->motor + robot->n_joints;
    analysis->ordered = analysis->matrix + 6 * analysis->n_columns;
    analysis->machining = analysis->ordered + 6 * analysis->n_columns;
    return true;
}

void analysis_free(analysis *analysis)
{
    free(analysis->wish);
    free(analysis->links);
    free(analysis->columns);
    free(analysis->order);
}

armtol_status analysis_place(analysis *analysis, const double wish[])
{
    const armtol_robot *robot = analysis->robot;
    const armtol_errata *errata = &analysis->errata;
    const armtol_status status = robot->inverse(wish, errata, analysis->q, &analysis->reach);
    if (status != ARMTOL_OK) {
        return status;
    }
    memmove(analysis->wish, wish, robot->n_wish * sizeof *wish);
    robot->forward(analysis->q, errata, analysis->check);
    robot->links(errata, analysis->links);
    return armtol_links_place(analysis->links, robot->n_links, analysis->q, robot->n_joints, errata,
                              analysis->links);
}

/* An A whose norms overflow bounds nothing: better told now, with the wish still at hand, than with the bounds. */
static armtol_status check_norms(const analysis *analysis)
{
    static const double any[6] = {2, 2, 2, 2, 2, 2};
    armtol_bounds bounds;
    return armtol_norm_bounds(analysis->ordered, analysis->n_columns, analysis->n_lengths, any, 1,
                              &analysis->errata, &bounds);
}

armtol_status analysis_matrix(analysis *analysis, const armtol_residue *residue)
{
    const size_t n_links = analysis->robot->n_links, n = analysis->n_columns;
    const armtol_residue left = armtol_skew_residue(analysis->links, n_links, &analysis->errata);
    armtol_status status = armtol_columns(analysis->links, n_links, analysis->columns, n);
    if (status == ARMTOL_OK) {
        status = armtol_error_matrix_with_residue(analysis->links, n_links, residue != NULL ? residue : &left,
                                                  &analysis->errata, analysis->matrix, n);
    }
    if (status == ARMTOL_OK) {
        analysis->n_lengths = armtol_column_order(analysis->columns, n, analysis->order);
        armtol_reorder(analysis->matrix, n, analysis->order, analysis->ordered);
        status = check_norms(analysis);
    }
    return status;
}

static armtol_status part_tolerances(analysis *analysis)
{
    const size_t n_angles = analysis->n_columns - analysis->n_lengths;
    analysis->shares = armtol_parameter_shares(&analysis->bounds, analysis->n_lengths, n_angles,
                                               &analysis->errata);
    size_t joint = 0;
    for (size_t i = 0; i < analysis->robot->n_links; i++) {
        const armtol_link *link = &analysis->links[i];
        analysis->machining[i] = armtol_machining_distance(link, analysis->shares.distance,
                                                           &analysis->errata);
        if (link->joint != ARMTOL_FIXED) {
            analysis->motor[joint++] = armtol_motor_tolerance(link, analysis->machining[i],
                                                              &analysis->shares);
        }
        if (!isfinite(analysis->machining[i])) {
            return ARMTOL_NOT_FINITE;
        }
    }
    return isfinite(analysis->shares.angle) ? ARMTOL_OK : ARMTOL_NOT_FINITE;
}

armtol_status analysis_tolerances(analysis *analysis, const double tolerances[6], double delta)
{
    const armtol_status status = armtol_norm_bounds(analysis->ordered, analysis->n_columns,
                                                    analysis->n_lengths, tolerances, delta,
                                                    &analysis->errata, &analysis->bounds);
    if (status != ARMTOL_OK) {
        return status;
    }
    memcpy(analysis->tolerances, tolerances, sizeof analysis->tolerances);
    analysis->delta = delta;
    return part_tolerances(analysis);
}

armtol_status analysis_run(analysis *analysis, const double wish[], const armtol_residue *residue,
                           const double tolerances[6], double delta)
{
    armtol_status status = analysis_place(analysis, wish);
    if (status == ARMTOL_OK) {
        status = analysis_matrix(analysis, residue);
    }
    return status == ARMTOL_OK ? analysis_tolerances(analysis, tolerances, delta) : status;
}
