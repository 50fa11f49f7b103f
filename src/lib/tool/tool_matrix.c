#include "armtol/tool_matrix.h"

#include "lib/report/finite.h"
#include "lib/lanes/lanes.h"
#include "lib/tool/matrix_view.h"
#include "lib/tool/pose_link.h"

static const armtol_transform base = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};

#define LANES 1
#include "lib/lanes/triple_kernel.h"
#include "lib/lanes/frame_kernel.h"
#include "lib/lanes/matrix_kernel.h"
#include "lib/tool/tool_matrix_kernel.h"
#undef LANES
#if LANES_HAVE_MACHINES
#include "lib/lanes/quad.h"
#define LANES quad
#include "lib/lanes/frame_kernel.h"
#include "lib/lanes/matrix_kernel.h"
#include "lib/tool/tool_matrix_kernel.h"
#undef LANES
#endif

LANE_INLINE void fill(const armtol_link links[], size_t n_links, const armtol_tool_point *tool,
                      const matrix_view *matrix, int lanes)
{
    QUAD_CALL(tool_matrix, lanes, (links, n_links, tool, matrix));
}

LANES_MACHINES(fill,
               (const armtol_link links[], size_t n_links, const armtol_tool_point *tool,
                const matrix_view *matrix), links, n_links, tool, matrix)

static armtol_status check(const armtol_link links[], size_t n_links, size_t n_columns)
{
    const armtol_status status = armtol_links_check(links, n_links);
    if (status != ARMTOL_OK) {
        return status;
    }
    return n_columns == armtol_column_count(links, n_links) ? ARMTOL_OK : ARMTOL_WRONG_SIZE;
}

armtol_status armtol_tool_matrix(const armtol_link links[], size_t n_links, const armtol_tool_point *tool,
                                 double matrix[], size_t n_columns)
{
    const armtol_status status = check(links, n_links, n_columns);
    if (status != ARMTOL_OK) {
        return status;
    }
    const matrix_view view = {matrix, n_columns, 1};
    fill_on_machine(links, n_links, tool, &view);
    return all_finite(matrix, 6 * n_columns) ? ARMTOL_OK : ARMTOL_NOT_FINITE;
}
