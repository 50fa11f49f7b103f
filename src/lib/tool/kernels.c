#include "lib/tool/kernels.h"

const kernels *kernels_of_machine(int most_lanes)
{
    (void)most_lanes;
#if VECTORS_OF_X86
    /* The compiler's runtime has asked the processor when the program began: here its answer is read. */
    if (most_lanes >= 8 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")) {
        return &kernels_avx512;
    }
    if (most_lanes >= 4 && __builtin_cpu_supports("avx2")) {
        return &kernels_avx2;
    }
#endif
    return &kernels_portable;
}

void armtol_pose_blocks(const armtol_poses *poses, const double q[], size_t n_poses, double blocks[],
                        armtol_bounds bounds[])
{
    kernels_of_machine(ARMTOL_POSE_BLOCK)->pose_blocks(poses, q, n_poses, blocks, bounds);
}

void armtol_sampler_draw(const armtol_sampler *sampler, uint64_t first, size_t count, double errors[])
{
    kernels_of_machine(ARMTOL_POSE_BLOCK)->draw(sampler, first, count, errors);
}
