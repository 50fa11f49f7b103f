#include "armtol/urdf/follower.h"

#include "console/exit_code.h"
#include "console/message.h"

#include <stdlib.h>

static bool in_ring(const urdf_joint *joint)
{
    file_message(&joint->place, "joint %s mimics itself, by way of others",
                 message_quote(joint->name, &(quoted){""}));
    return false;
}

/* The farthest of those that it follows which is in the chain; axis_of is URDF_NONE for a joint that is not. */
static bool find(const urdf_tree *tree, size_t index, const size_t axis_of[], urdf_follower *follower)
{
    double multiplier = 1, offset = 0;
    const urdf_joint *joint = &tree->joints[index];
    for (size_t steps = 0; joint->leader != URDF_NONE; steps++) {
        if (steps == tree->n_joints) {
            return in_ring(&tree->joints[index]);
        }
        offset += multiplier * joint->offset;
        multiplier *= joint->multiplier;
        if (axis_of[joint->leader] != URDF_NONE) {
            *follower = (urdf_follower){axis_of[joint->leader], multiplier, offset};
        }
        joint = &tree->joints[joint->leader];
    }
    return true;
}

static void note_axes(const urdf_tree *tree, const size_t joints[], size_t n_axes, size_t axis_of[])
{
    for (size_t i = 0; i < tree->n_joints; i++) {
        axis_of[i] = URDF_NONE;
    }
    for (size_t axis = 0; axis < n_axes; axis++) {
        axis_of[joints[axis]] = axis;
    }
}

bool urdf_followers_find(const urdf_tree *tree, const size_t joints[], size_t n_axes, urdf_follower followers[])
{
    size_t *const axis_of = calloc(tree->n_joints, sizeof *axis_of);
    if (axis_of == NULL) {
        out_of_memory();
        return false;
    }
    bool fine = true;
    note_axes(tree, joints, n_axes, axis_of);
    for (size_t axis = 0; axis < n_axes && fine; axis++) {
        followers[axis] = (urdf_follower){axis, 1, 0};
        fine = find(tree, joints[axis], axis_of, &followers[axis]);
    }
    free(axis_of);
    return fine;
}
