#ifndef ARMTOL_URDF_TREE_H
#define ARMTOL_URDF_TREE_H

#include "console/file_message.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* What a URDF says of a robot's kinematics and of its masses: links, and the joints that hang one below another. */

typedef enum urdf_joint_type {
    URDF_FIXED,
    URDF_REVOLUTE,
    URDF_CONTINUOUS,
    URDF_PRISMATIC,
    URDF_PLANAR,
    URDF_FLOATING,
    URDF_JOINT_TYPES
} urdf_joint_type;

extern const char *const urdf_joint_type_names[URDF_JOINT_TYPES];

/* In place of an index: there is none. */
#define URDF_NONE SIZE_MAX

typedef struct urdf_link {
    char *name;
    file_place place;
    double mass;      /* 0 where the file does not say */
    double center[3]; /* of it, in the frame of the link */
    size_t above;   /* the joint that it hangs from, URDF_NONE for a root; from urdf_tree_connect */
    bool is_leaf;   /* nothing hangs from it; from urdf_tree_connect */
    size_t visited; /* for urdf_tree_connect */
} urdf_link;

typedef struct urdf_joint {
    char *name;
    file_place place;
    urdf_joint_type type;
    double xyz[3], rpy[3]; /* where the child is at joint value 0, in the frame of the parent */
    bool has_quaternion;   /* in place of rpy */
    double quaternion[4];  /* x, y, z, w; of any length but 0 */
    double axis[3];        /* in the frame of the child */
    double low, high;      /* -infinity and infinity where the file does not say */
    char *leader_name;     /* of <mimic>, NULL where it follows no other joint; its value is */
    double multiplier, offset; /* multiplier x the leader's + offset */
    size_t leader;     /* a joint, which need not be there: URDF_NONE; from urdf_tree_connect */
    char *parent_name, *child_name;
    size_t parent, child; /* links; from urdf_tree_connect */
    char *fault;          /* what is wrong with it, which only matters where it is needed; NULL where nothing is */
    file_place fault_place;
} urdf_joint;

/* Whether it is revolute, continuous or prismatic. */
bool urdf_joint_moves(const urdf_joint *joint);

typedef struct urdf_tree {
    const char *path; /* for messages */
    char *robot;      /* its name */
    size_t n_links, link_room;
    urdf_link *links;
    size_t n_joints, joint_room;
    urdf_joint *joints;
} urdf_tree;

void urdf_tree_start(urdf_tree *tree, const char *path);
void urdf_tree_free(urdf_tree *tree);

/* A copy of a text, to keep in the tree; and a new link or joint of that name. False after a message. */
bool urdf_tree_keep(char **kept, const char *text);
bool urdf_tree_add_link(urdf_tree *tree, const char *name, const file_place *place);
bool urdf_tree_add_joint(urdf_tree *tree, const char *name, const file_place *place);

/*
 * Once all is there: find the links that the joints name. False after a message where the names or the joints
 * do not make trees: a name that is given twice or to nothing, a link below two joints, a ring.
 */
bool urdf_tree_connect(urdf_tree *tree);

/* The link of that name, URDF_NONE where none has it. */
size_t urdf_tree_link(const urdf_tree *tree, const char *name);

#endif
