#ifndef ARMTOL_POSES_H
#define ARMTOL_POSES_H

#include "armtol/bounds.h"
#include "armtol/interface.h"
#include "armtol/link.h"
#include "armtol/tool_point.h"

#include <stdbool.h>
#include <stddef.h>

ARMTOL_INTERFACE_BEGIN

/*
 * A with its bounds in many poses of one arm, fast: what no joint moves is prepared once, and poses are done
 * side by side in blocks. A pose gives the same bits in any place of a block, on any machine.
 */

/* The poses of a block, and the number of blocks that hold n_poses. */
enum { ARMTOL_POSE_BLOCK = 8 };
#define ARMTOL_POSE_BLOCKS(n_poses) (((n_poses) + (ARMTOL_POSE_BLOCK - 1)) / ARMTOL_POSE_BLOCK)

/* The place of element (i, j) of A in pose p, in the blocks of A of n_columns columns. */
#define ARMTOL_POSE_ELEMENT(n_columns, i, j, p)                                                              \
    ((((p) / ARMTOL_POSE_BLOCK * 6 + (i)) * (n_columns) + (j)) * ARMTOL_POSE_BLOCK + (p) % ARMTOL_POSE_BLOCK)

/* One link as it is needed here. Filled by armtol_poses_start. */
typedef struct armtol_pose_link {
    armtol_joint joint;
    bool turned, shifted, tilted, bent; /* by its joint, or theta; a and d; alpha; beta is not 0 */
    double a, d, theta;
    double cos_theta, sin_theta; /* of what no joint turns */
    double cos_alpha, sin_alpha;
    double cos_beta, sin_beta;
    size_t columns[ARMTOL_PARAMETER_COUNT]; /* SIZE_MAX for what the kind does not count */
} armtol_pose_link;

typedef struct armtol_poses {
    const armtol_pose_link *links;
    size_t n_links, n_joints, n_columns;
    armtol_tool_point tool;
    double limits[3], delta;              /* the linear tolerances, and what is kept of them for lengths */
    double angle_scale, angle_weights[6]; /* angle bound = scale / root of the largest weighted sum of squares */
} armtol_poses;

/*
 * Prepare for poses of an arm.
 *
 * Given:
 *    links, n_links      its table, at joint values 0
 *    tool                the tool point, and along which axes is counted
 *    tolerances, delta   as of armtol_norm_bounds
 *
 * Returned:
 *    *poses              what armtol_pose_blocks needs
 *    prepared            n_links places; they have to stay as long as *poses is used
 *
 * Errors:
 *    those of armtol_links_check and armtol_tolerances_check
 *    ARMTOL_NOT_FINITE      an offset that is not
 *    ARMTOL_BAD_TOLERANCE   one tolerance (less delta) is more than 1e100 times another
 */
armtol_status armtol_poses_start(armtol_poses *poses, armtol_pose_link prepared[], const armtol_link links[],
                                 size_t n_links, const armtol_tool_point *tool, const double tolerances[6],
                                 double delta);

/*
 * A and its bounds in many poses.
 *
 * Given:
 *    poses        prepared
 *    q, n_poses   joint k of pose p is q[p * n_joints + k]
 *
 * Returned:
 *    blocks       ARMTOL_POSE_BLOCKS(n_poses) * ARMTOL_POSE_BLOCK * 6 * n_columns places: element (i, j) of A in pose p
 *                 at ARMTOL_POSE_ELEMENT, to the bit that of armtol_tool_matrix for the placed links
 *    bounds       one a pose: those of armtol_norm_bounds without errata, to rounding
 *
 * Notes:
 * 1) What is nan or overflows makes the bounds it counts for nan.
 * 2) The places of the last block that no pose is left for repeat the last pose.
 * 3) It is fastest where blocks is aligned to 64 bytes.
 */
void armtol_pose_blocks(const armtol_poses *poses, const double q[], size_t n_poses, double blocks[],
                        armtol_bounds bounds[]);

ARMTOL_INTERFACE_END

#endif
