#include "lib/tool/kernels.h"

#if VECTORS
#define LANES 2
#else
#define LANES 1
#endif
#include "lib/tool/poses_kernel.h"
#include "lib/tool/sampler_kernel.h"
#include "lib/tool/worst_kernel.h"

static void pose_blocks_portable(const armtol_poses *poses, const double q[], size_t n_poses, double blocks[],
                                 armtol_bounds bounds[])
{
    pose_blocks(poses, q, n_poses, blocks, bounds);
}

static void draw_portable(const armtol_sampler *sampler, uint64_t first, size_t count, double errors[])
{
    draw(sampler, first, count, errors);
}

static void worst_portable(const worst_case *worst, const double q[], size_t n_poses, const double reach[],
                           double memory[], double found[])
{
    worst_blocks(worst, q, n_poses, reach, memory, found);
}

const kernels kernels_portable = {pose_blocks_portable, draw_portable, worst_portable};
