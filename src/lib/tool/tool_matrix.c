#include "armtol/tool_matrix.h"

#include "lib/report/columns.h"
#include "lib/report/finite.h"

#define LANES 1
#include "lib/tool/columns.h"

/*
 * Method
 *    Each column is the axis of its parameter, and for an angle the cross product with the way to the tool point
 *    (columns.h): one walk along the chain and one look back.
 *
 * Special cases
 *    Angles beyond 1e6 are libm's. An element that overflows is told.
 *
 * Accuracy
 *    Of the arm's reach 1e-9 beside central differences of Eq. (4.1)
 *    (test_chains_of_all_kinds_agree_with_central_differences) and 1e-12 beside A by adjoints
 *    (test_it_is_the_error_matrix_without_errata).
 */

static void walk(const armtol_link links[], size_t n_links, const matrix_view *matrix, frame *frame)
{
    size_t column = 0;
    for (size_t i = 0; i < n_links; i++) {
        const armtol_pose_link link = pose_link_of(&links[i], &column);
        const setting setting = {link.cos_theta, link.sin_theta, link.d};
        walk_link(&link, &setting, matrix, frame);
    }
}

static void complete_axis(const matrix_view *matrix, size_t angle, size_t length, const target *target,
                          const triple way)
{
    triple axis, about;
    finish_axis(matrix, angle, target, way, axis, about);
    write_axis(matrix, angle, length, target, axis, about);
}

static void finish(const armtol_link links[], size_t n_links, const target *target, const matrix_view *matrix)
{
    size_t column = 0, columns[2][ARMTOL_PARAMETER_COUNT];
    triple way;
    columns_of_link(links[0].kind, &column, columns[0]);
    way_before(columns[0], matrix, target, way);
    for (size_t i = 0; i < n_links; i++) {
        const size_t *const here = columns[i % 2];
        complete_axis(matrix, here[ARMTOL_THETA], here[ARMTOL_D], target, way);
        if (i + 1 < n_links) {
            columns_of_link(links[i + 1].kind, &column, columns[(i + 1) % 2]);
            way_before(columns[(i + 1) % 2], matrix, target, way);
        } else {
            way_from(target->along->origin, target, way);
        }
        complete_axis(matrix, here[ARMTOL_ALPHA], here[ARMTOL_A], target, way);
        if (here[ARMTOL_BETA] != NO_COLUMN) {
            complete_axis(matrix, here[ARMTOL_BETA], NO_COLUMN, target, way);
        }
    }
}

armtol_status armtol_tool_matrix(const armtol_link links[], size_t n_links, const armtol_tool_point *tool,
                                 double matrix[], size_t n_columns)
{
    const armtol_status status = columns_check(links, n_links, n_columns);
    if (status != ARMTOL_OK) {
        return status;
    }
    const matrix_view view = {matrix, n_columns, 1};
    const armtol_transform base = armtol_transform_identity();
    frame frame;
    put_frame(&base, &frame);
    walk(links, n_links, &view, &frame);
    target target = {.turned = tool->frame == ARMTOL_TOOL_FRAME, .along = &frame};
    point_of(&frame, tool->offset, target.point);
    finish(links, n_links, &target, &view);
    return all_finite(matrix, 6 * n_columns) ? ARMTOL_OK : ARMTOL_NOT_FINITE;
}
