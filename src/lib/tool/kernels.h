#ifndef ARMTOL_LIB_TOOL_KERNELS_H
#define ARMTOL_LIB_TOOL_KERNELS_H

#include "armtol/poses.h"
#include "armtol/sampler.h"
#include "lib/lanes/vectors.h"
#include "lib/private_names.h"

/* What is asked for of each of many poses: |A| t of a row, or the length of that of the three rows that have it. */
typedef struct worst_case {
    const armtol_poses *poses;
    const double *tolerances; /* one a column */
    size_t row;
    bool is_length;
} worst_case;

/*
 * What is done for many poses or arms at once: a source file for each width of a vector, of which the widest that the
 * machine has is chosen when the program runs. All give the same bits.
 */
typedef struct kernels {
    /* as armtol_pose_blocks */
    void (*pose_blocks)(const armtol_poses *poses, const double q[], size_t n_poses, double blocks[],
                        armtol_bounds bounds[]);
    /* as armtol_sampler_draw */
    void (*draw)(const armtol_sampler *sampler, uint64_t first, size_t count, double errors[]);
    /*
     * reach: of the arm in each pose, for whole blocks of poses; elements of A that are negligible (negligible.h) are
     * left out. memory: that of a block of A.
     */
    void (*worst)(const worst_case *worst, const double q[], size_t n_poses, const double reach[], double memory[],
                  double found[]);
} kernels;

extern const kernels kernels_portable; /* two lanes, or one where the compiler has no vectors */
extern const kernels kernels_avx2;     /* four; of x86-64 alone, as the next */
extern const kernels kernels_avx512;   /* eight */

/* The widest of at most so many lanes that this machine runs. */
const kernels *kernels_of_machine(int most_lanes);

#endif
