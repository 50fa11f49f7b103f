#include "armtol/tool_matrix.h"

#include "finite.h"
#include "lanes.h"
#include "matrix_view.h"
#include "pose_link.h"

#define LANES 1
#include "frame_kernel.h"
#include "matrix_kernel.h"
#undef LANES

static armtol_status check(const armtol_link links[], size_t n_links, size_t n_columns)
{
    const armtol_status status = armtol_links_check(links, n_links);
    if (status != ARMTOL_OK) {
        return status;
    }
    return n_columns == armtol_column_count(links, n_links) ? ARMTOL_OK : ARMTOL_WRONG_SIZE;
}

static frame_1 walk_all(const armtol_link links[], size_t n_links, const matrix_view *matrix)
{
    frame_1 frame = {.x = {1, 0, 0}, .y = {0, 1, 0}, .z = {0, 0, 1}};
    size_t column = 0;
    for (size_t i = 0; i < n_links; i++) {
        const armtol_pose_link link = pose_link_of(&links[i], &column);
        const setting_1 setting = {link.cos_theta, link.sin_theta, link.d};
        walk_link_1(&link, &setting, matrix, &frame);
    }
    return frame;
}

armtol_status armtol_tool_matrix(const armtol_link links[], size_t n_links, const armtol_tool_point *tool,
                                 double matrix[], size_t n_columns)
{
    const armtol_status status = check(links, n_links, n_columns);
    if (status != ARMTOL_OK) {
        return status;
    }
    const matrix_view view = {matrix, n_columns, 1};
    const frame_1 last = walk_all(links, n_links, &view);
    target_1 target = {.along = tool->frame == ARMTOL_TOOL_FRAME ? &last : NULL};
    squares_1 squares = {.lengths = {0}};
    point_of_1(&last, tool->offset, target.point);
    size_t column = 0;
    for (size_t i = 0; i < n_links; i++) {
        size_t columns[ARMTOL_PARAMETER_COUNT];
        columns_of_link(links[i].kind, &column, columns);
        finish_link_1(columns, &view, &target, &squares);
    }
    return all_finite(matrix, 6 * n_columns) ? ARMTOL_OK : ARMTOL_NOT_FINITE;
}
