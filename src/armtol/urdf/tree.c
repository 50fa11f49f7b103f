#include "armtol/urdf/tree.h"

#include "console/exit_code.h"
#include "console/list_room.h"
#include "console/message.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const char *const urdf_joint_type_names[URDF_JOINT_TYPES] = {
    [URDF_FIXED] = "fixed",         [URDF_REVOLUTE] = "revolute", [URDF_CONTINUOUS] = "continuous",
    [URDF_PRISMATIC] = "prismatic", [URDF_PLANAR] = "planar",     [URDF_FLOATING] = "floating",
};

bool urdf_joint_moves(const urdf_joint *joint)
{
    return joint->type == URDF_REVOLUTE || joint->type == URDF_CONTINUOUS || joint->type == URDF_PRISMATIC;
}

void urdf_tree_start(urdf_tree *tree, const char *path)
{
    *tree = (urdf_tree){.path = path};
}

void urdf_tree_free(urdf_tree *tree)
{
    for (size_t i = 0; i < tree->n_links; i++) {
        free(tree->links[i].name);
    }
    for (size_t i = 0; i < tree->n_joints; i++) {
        free(tree->joints[i].name);
        free(tree->joints[i].parent_name);
        free(tree->joints[i].child_name);
        free(tree->joints[i].leader_name);
        free(tree->joints[i].fault);
    }
    free(tree->links);
    free(tree->joints);
    free(tree->robot);
}

/* ---- collecting ---- */

static bool no_memory(void)
{
    out_of_memory();
    return false;
}

bool urdf_tree_keep(char **kept, const char *text)
{
    *kept = strdup(text);
    return *kept != NULL || no_memory();
}

bool urdf_tree_add_link(urdf_tree *tree, const char *name, const file_place *place)
{
    urdf_link *const links = list_room(tree->links, tree->n_links, &tree->link_room, sizeof *links);
    if (links == NULL) {
        return false;
    }
    tree->links = links;
    urdf_link *const link = &links[tree->n_links++];
    *link = (urdf_link){.place = *place, .above = URDF_NONE, .is_leaf = true};
    return urdf_tree_keep(&link->name, name);
}

bool urdf_tree_add_joint(urdf_tree *tree, const char *name, const file_place *place)
{
    urdf_joint *const joints = list_room(tree->joints, tree->n_joints, &tree->joint_room, sizeof *joints);
    if (joints == NULL) {
        return false;
    }
    tree->joints = joints;
    urdf_joint *const joint = &joints[tree->n_joints++];
    *joint = (urdf_joint){
        .place = *place,
        .axis = {1, 0, 0},
        .low = -INFINITY,
        .high = INFINITY,
        .multiplier = 1,
        .leader = URDF_NONE,
    };
    return urdf_tree_keep(&joint->name, name);
}

/* ---- names ---- */

static bool is_later(const file_place *one, const file_place *other)
{
    return one->line > other->line || (one->line == other->line && one->column > other->column);
}

/* Two things of one name, in either order. */
static bool said_twice(const char *what, const char *name, const file_place *one, const file_place *other)
{
    const bool in_order = is_later(other, one);
    file_message(in_order ? other : one, "a second %s %s; the first is in line %zu", what,
                 message_quote(name, &(quoted){""}), in_order ? one->line : other->line);
    return false;
}

static int compare_links(const void *one, const void *other)
{
    return strcmp(((const urdf_link *)one)->name, ((const urdf_link *)other)->name);
}

static int compare_name(const void *name, const void *link)
{
    return strcmp(name, ((const urdf_link *)link)->name);
}

size_t urdf_tree_link(const urdf_tree *tree, const char *name)
{
    if (tree->n_links == 0) {
        return URDF_NONE;
    }
    const urdf_link *const found =
        bsearch(name, tree->links, tree->n_links, sizeof *tree->links, compare_name);
    return found != NULL ? (size_t)(found - tree->links) : URDF_NONE;
}

/* Links come into the order of their names, so that one is quickly found. */
static bool sort_links(urdf_tree *tree)
{
    if (tree->n_links > 0) {
        qsort(tree->links, tree->n_links, sizeof *tree->links, compare_links);
    }
    for (size_t i = 1; i < tree->n_links; i++) {
        const urdf_link *const one = &tree->links[i - 1], *const other = &tree->links[i];
        if (strcmp(one->name, other->name) == 0) {
            return said_twice("<link>", one->name, &one->place, &other->place);
        }
    }
    return true;
}

static int compare_joints(const void *one, const void *other)
{
    const urdf_joint *const *const a = one, *const *const b = other;
    return strcmp((*a)->name, (*b)->name);
}

static int compare_joint_name(const void *name, const void *joint)
{
    const urdf_joint *const *const it = joint;
    return strcmp(name, (*it)->name);
}

static void find_leaders(urdf_tree *tree, const urdf_joint *const sorted[])
{
    for (size_t i = 0; i < tree->n_joints; i++) {
        const char *name = tree->joints[i].leader_name;
        const urdf_joint *const *const found =
            name != NULL ? bsearch(name, sorted, tree->n_joints, sizeof *sorted, compare_joint_name) : NULL;
        tree->joints[i].leader = found != NULL ? (size_t)(*found - tree->joints) : URDF_NONE;
    }
}

/* Joints stay in the order of the file; who follows whom is found by names in order. */
static bool check_joint_names(urdf_tree *tree)
{
    const urdf_joint **const sorted = calloc(tree->n_joints + 1, sizeof *sorted);
    if (sorted == NULL) {
        return no_memory();
    }
    for (size_t i = 0; i < tree->n_joints; i++) {
        sorted[i] = &tree->joints[i];
    }
    qsort(sorted, tree->n_joints, sizeof *sorted, compare_joints);
    bool fine = true;
    for (size_t i = 1; i < tree->n_joints && fine; i++) {
        fine = strcmp(sorted[i - 1]->name, sorted[i]->name) != 0 ||
               said_twice("<joint>", sorted[i]->name, &sorted[i - 1]->place, &sorted[i]->place);
    }
    if (fine) {
        find_leaders(tree, sorted);
    }
    free(sorted);
    return fine;
}

/* ---- the tree ---- */

static bool find_end(const urdf_tree *tree, const urdf_joint *joint, const char *which, const char *name,
                     size_t *link)
{
    *link = urdf_tree_link(tree, name);
    if (*link == URDF_NONE) {
        file_message(&joint->place, "joint %s has the %s %s, and there is no <link> of that name",
                     message_quote(joint->name, &(quoted){""}), which, message_quote(name, &(quoted){""}));
    }
    return *link != URDF_NONE;
}

static bool connect(urdf_tree *tree, size_t index)
{
    urdf_joint *const joint = &tree->joints[index];
    if (!find_end(tree, joint, "parent", joint->parent_name, &joint->parent) ||
        !find_end(tree, joint, "child", joint->child_name, &joint->child)) {
        return false;
    }
    urdf_link *const child = &tree->links[joint->child];
    if (child->above != URDF_NONE) {
        file_message(&joint->place, "joint %s has the child %s, which joint %s has already; expected a tree",
                     message_quote(joint->name, &(quoted){""}), message_quote(child->name, &(quoted){""}),
                     message_quote(tree->joints[child->above].name, &(quoted){""}));
        return false;
    }
    child->above = index;
    tree->links[joint->parent].is_leaf = false;
    return true;
}

/* Walk up from a link, to the top or to where an earlier walk was; false where it comes to its own steps. */
static bool leads_up(urdf_tree *tree, size_t link, size_t walk)
{
    while (tree->links[link].visited == 0) {
        tree->links[link].visited = walk;
        const size_t above = tree->links[link].above;
        if (above == URDF_NONE) {
            return true;
        }
        link = tree->joints[above].parent;
    }
    if (tree->links[link].visited != walk) {
        return true;
    }
    const urdf_joint *const joint = &tree->joints[tree->links[link].above];
    file_message(&joint->place, "joint %s is part of a ring: link %s hangs from itself; expected a tree",
                 message_quote(joint->name, &(quoted){""}),
                 message_quote(tree->links[link].name, &(quoted){""}));
    return false;
}

bool urdf_tree_connect(urdf_tree *tree)
{
    bool fine = sort_links(tree) && check_joint_names(tree);
    for (size_t i = 0; i < tree->n_joints && fine; i++) {
        fine = connect(tree, i);
    }
    for (size_t i = 0; i < tree->n_links && fine; i++) {
        fine = leads_up(tree, i, i + 1);
    }
    return fine;
}
