#include "lib/tool/kernels.h"

#if VECTORS_OF_X86
#ifdef __clang__
#pragma clang attribute push(__attribute__((target("avx512f,avx512dq"))), apply_to = function)
#else
/* No gathers: many processors are slow at them. Whole vectors, where the compiler is told of a processor too. */
#pragma GCC target("avx512f,avx512dq,tune=generic,prefer-vector-width=512")
#endif

#define LANES 8
#include "lib/tool/poses_kernel.h"
#include "lib/tool/sampler_kernel.h"
#include "lib/tool/worst_kernel.h"

static void pose_blocks_avx512(const armtol_poses *poses, const double q[], size_t n_poses, double blocks[],
                               armtol_bounds bounds[])
{
    pose_blocks(poses, q, n_poses, blocks, bounds);
}

static void draw_avx512(const armtol_sampler *sampler, uint64_t first, size_t count, double errors[])
{
    draw(sampler, first, count, errors);
}

static void worst_avx512(const worst_case *worst, const double q[], size_t n_poses, const double reach[],
                         double memory[], double found[])
{
    worst_blocks(worst, q, n_poses, reach, memory, found);
}

const kernels kernels_avx512 = {pose_blocks_avx512, draw_avx512, worst_avx512};

#ifdef __clang__
#pragma clang attribute pop
#endif
#endif
