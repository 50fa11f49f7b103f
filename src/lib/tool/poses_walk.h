#ifndef ARMTOL_LIB_TOOL_POSES_WALK_H
#define ARMTOL_LIB_TOOL_POSES_WALK_H

#include "lib/lanes/sincos.h"
#include "lib/tool/columns.h"

/* The first half of A in many poses (lanes.h): along the chain. */

/* The poses of the lanes, one after the other in memory; where fewer are left the last stands for the rest. */
typedef struct lane_poses {
    const double *q;
    size_t n_joints, last;
} lane_poses;

LANE_INLINE size_t smaller(size_t one, size_t other)
{
    return one < other ? one : other;
}

LANE_INLINE void read_joint(const lane_poses *at, size_t joint, real *value)
{
    const double *const q = at->q + joint;
    if (RARELY(at->last + 1 < LANES)) {
        double lanes[LANES];
        for (size_t l = 0; l < LANES; l++) {
            lanes[l] = q[smaller(l, at->last) * at->n_joints];
        }
        load(lanes, value);
    } else {
        gather(q, at->n_joints, value);
    }
}

/* What is far is told or, where it is known to be, done by libm. */
LANE_INLINE void set_joint(const armtol_pose_link *link, const lane_poses *at, size_t joint, bool any_far,
                           setting *setting, word *far)
{
    const real zero = {0};
    setting->d = zero + link->d;
    if (link->joint == ARMTOL_REVOLUTE) {
        real angle;
        read_joint(at, joint, &angle);
        angle = angle + link->theta;
        if (any_far) {
            sine_cosine(&angle, &setting->sine, &setting->cosine);
        } else {
            word beyond;
            near_sine_cosine(&angle, &setting->sine, &setting->cosine);
            find_far(&angle, &beyond);
            *far = *far | beyond;
        }
        return;
    }
    setting->cosine = zero + link->cos_theta;
    setting->sine = zero + link->sin_theta;
    if (link->joint == ARMTOL_PRISMATIC) {
        real length;
        read_joint(at, joint, &length);
        setting->d = setting->d + length;
    }
}

LANE_INLINE void walk_links(const armtol_poses *poses, const lane_poses *at, const matrix_view *matrix, bool any_far,
                            frame *frame, word *far)
{
    const armtol_transform base = armtol_transform_identity();
    size_t joint = 0;
    put_frame(&base, frame);
    for (size_t i = 0; i < poses->n_links; i++) {
        const armtol_pose_link *const link = &poses->links[i];
        setting setting;
        set_joint(link, at, joint, any_far, &setting, far);
        walk_link(link, &setting, matrix, frame);
        joint += link->joint != ARMTOL_FIXED;
    }
}

/*
 * The frame at the end of the chain, and in the matrix what finish_axis needs. Angles that are far are rare: whether
 * there are any is asked once, when all is done.
 */
LANE_INLINE void walk_poses(const armtol_poses *poses, const lane_poses *at, const matrix_view *matrix, frame *frame)
{
    word far = {0};
    walk_links(poses, at, matrix, false, frame, &far);
    if (RARELY(any(&far))) {
        walk_links(poses, at, matrix, true, frame, &far);
    }
}

#endif
