#include "armtol/urdf/arm.h"

#include "armtol/axes.h"
#include "armtol/tables/text_lines.h"
#include "armtol/transform.h"
#include "armtol/urdf/chain_check.h"
#include "armtol/urdf/follower.h"
#include "armtol/urdf/masses.h"
#include "armtol/urdf/origin.h"
#include "console/exit_code.h"
#include "console/message.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What an arm is made from, while it is made. */
typedef struct parts {
    armtol_axis *axes;
    armtol_drive *axis_drives; /* of the axes */
    size_t *joints;            /* of the tree, of the axes */
    size_t n_axes;
    armtol_transform tip; /* of the chain so far, all joints at 0 */
    armtol_link *links;
    armtol_drive *drives;   /* of the links */
    armtol_mass *masses;    /* likewise */
    bool has_masses;
    armtol_motion *motions; /* of the links */
    char **names;           /* likewise; NULL where a link has none */
    size_t most_links;
    size_t *link_of_axis;
    size_t n_links;
    urdf_carried *carried; /* of the links of the tree */
} parts;

static bool parts_start(parts *parts, size_t most_axes, size_t n_tree_links)
{
    const size_t most_links = ARMTOL_LINKS_OF_AXES(most_axes);
    *parts = (struct parts){
        .axes = calloc(most_axes + 1, sizeof *parts->axes),
        .axis_drives = calloc(most_axes + 1, sizeof *parts->axis_drives),
        .joints = calloc(most_axes + 1, sizeof *parts->joints),
        .tip = armtol_transform_identity(),
        .links = calloc(most_links, sizeof *parts->links),
        .drives = calloc(most_links, sizeof *parts->drives),
        .masses = calloc(most_links, sizeof *parts->masses),
        .carried = calloc(n_tree_links, sizeof *parts->carried),
        .motions = calloc(most_links, sizeof *parts->motions),
        .names = calloc(most_links, sizeof *parts->names),
        .most_links = most_links,
        .link_of_axis = calloc(most_axes + 1, sizeof *parts->link_of_axis),
    };
    return enough_memory(parts->axes != NULL && parts->axis_drives != NULL && parts->joints != NULL &&
                         parts->links != NULL && parts->drives != NULL && parts->masses != NULL &&
                         parts->carried != NULL && parts->motions != NULL && parts->names != NULL &&
                         parts->link_of_axis != NULL);
}

static void parts_free(parts *parts)
{
    free(parts->axes);
    free(parts->axis_drives);
    free(parts->joints);
    free(parts->links);
    free(parts->drives);
    free(parts->masses);
    free(parts->carried);
    free(parts->motions);
    for (size_t i = 0; i < parts->most_links && parts->names != NULL; i++) {
        free(parts->names[i]);
    }
    free(parts->names);
    free(parts->link_of_axis);
}

/* ---- joints to axes ---- */

/* The axis is the same seen from both sides of the joint; seen from the child's, the parent turns the other way. */
static void add_axis(parts *parts, const urdf_tree *tree, size_t index, bool up)
{
    const urdf_joint *const joint = &tree->joints[index];
    armtol_axis *const axis = &parts->axes[parts->n_axes];
    *axis = (armtol_axis){.joint = joint->type == URDF_PRISMATIC ? ARMTOL_PRISMATIC : ARMTOL_REVOLUTE};
    for (int i = 0; i < 3; i++) {
        axis->point[i] = parts->tip.m[i][3];
        for (int k = 0; k < 3; k++) {
            axis->direction[i] += parts->tip.m[i][k] * (up ? -joint->axis[k] : joint->axis[k]);
        }
    }
    armtol_drive *const drive = &parts->axis_drives[parts->n_axes];
    *drive = armtol_drive_unknown;
    drive->low = joint->low;
    drive->high = joint->high;
    parts->joints[parts->n_axes++] = index;
}

static void go(parts *parts, const armtol_transform *step)
{
    parts->tip = armtol_transform_product(&parts->tip, step, &armtol_errata_none);
}

static void add_joint(parts *parts, const urdf_tree *tree, size_t index, bool up)
{
    const armtol_transform origin = urdf_joint_origin(&tree->joints[index]);
    const armtol_transform back = armtol_transform_inverse(&origin, &armtol_errata_none);
    if (!up) {
        go(parts, &origin);
    }
    if (urdf_joint_moves(&tree->joints[index])) {
        add_axis(parts, tree, index, up);
    }
    if (up) {
        go(parts, &back);
    } else {
        parts->carried[tree->joints[index].child] = (urdf_carried){true, parts->n_axes, parts->tip};
    }
}

/* ---- axes to links ---- */

/* Say what is wrong between the two ends of the chain. */
static bool no_arm(const urdf_tree *tree, const urdf_chain *chain, const char *why)
{
    message("%s: the joints from link %s to link %s make no arm: %s", tree->path,
            message_quote(tree->links[chain->base].name, &(quoted){""}),
            message_quote(tree->links[chain->tip].name, &(quoted){""}), why);
    return false;
}

static bool make_links(const urdf_tree *tree, const urdf_chain *chain, parts *parts)
{
    if (parts->n_axes == 0) {
        return no_arm(tree, chain, "none of them moves");
    }
    size_t n_snapped;
    const armtol_status status = armtol_links_of_axes(parts->axes, parts->n_axes, &parts->tip, 0, parts->links,
                                                      &parts->n_links, NULL, &n_snapped);
    if (status != ARMTOL_OK) {
        return no_arm(tree, chain, armtol_status_text(status));
    }
    size_t axis = 0;
    for (size_t i = 0; i < parts->n_links; i++) {
        const bool moves = parts->links[i].joint != ARMTOL_FIXED;
        parts->drives[i] = moves ? parts->axis_drives[axis] : armtol_drive_unknown;
        parts->motions[i] = (armtol_motion){.follows = i, .multiplier = 1, .sign = 1};
        if (moves) {
            parts->link_of_axis[axis++] = i;
        }
    }
    return true;
}

/* Joints that mimic another of the chain; *any where there are such. */
static bool make_motions(const urdf_tree *tree, parts *parts, bool *any)
{
    urdf_follower *const followers = calloc(parts->n_axes, sizeof *followers);
    if (followers == NULL) {
        out_of_memory();
        return false;
    }
    const bool fine = urdf_followers_find(tree, parts->joints, parts->n_axes, followers);
    *any = false;
    for (size_t axis = 0; axis < parts->n_axes && fine; axis++) {
        armtol_motion *const motion = &parts->motions[parts->link_of_axis[axis]];
        motion->follows = parts->link_of_axis[followers[axis].leader];
        motion->multiplier = followers[axis].multiplier;
        motion->offset = followers[axis].offset;
        *any = *any || followers[axis].leader != axis;
    }
    free(followers);
    return fine;
}

/* ---- names ---- */

/* Every character that is not printable becomes this one. */
static void make_printable(char *text)
{
    for (; *text != '\0'; text++) {
        if (*text < ' ' || *text > '~') {
            *text = '?';
        }
    }
}

/* One word, as users may have to type it. */
static void make_word(char *text)
{
    for (; *text != '\0'; text++) {
        if (!isalnum((unsigned char)*text) && strchr("_.-", *text) == NULL) {
            *text = '_';
        }
    }
}

/* Nothing, a dash, a spreadsheet's fault, and what another link is called are no names that a table could have. */
static bool is_usable(const parts *parts, const char *name)
{
    bool fine = *name != '\0' && *name != '#' && strcmp(name, "-") != 0 && strcmp(name, "\xe2\x88\x92") != 0;
    for (size_t i = 0; i < parts->n_links; i++) {
        fine = fine && (parts->names[i] == NULL || strcmp(parts->names[i], name) != 0);
    }
    return fine;
}

static bool name_link(parts *parts, size_t link, const char *name)
{
    char *kept;
    if (!urdf_tree_keep(&kept, name)) {
        return false;
    }
    text_make_printable(kept);
    if (is_usable(parts, kept)) {
        parts->names[link] = kept;
    } else {
        free(kept);
    }
    return true;
}

/* A link is called as its joint is; a fixed one at an end of the chain as the link of the URDF that is there. */
static bool make_names(const urdf_tree *tree, const urdf_chain *chain, parts *parts)
{
    const size_t last = parts->n_links - 1;
    bool fine = true;
    for (size_t axis = 0; axis < parts->n_axes && fine; axis++) {
        fine = name_link(parts, parts->link_of_axis[axis], tree->joints[parts->joints[axis]].name);
    }
    if (fine && parts->links[0].joint == ARMTOL_FIXED) {
        fine = name_link(parts, 0, tree->links[chain->base].name);
    }
    if (fine && parts->links[last].joint == ARMTOL_FIXED) {
        fine = name_link(parts, last, tree->links[chain->tip].name);
    }
    return fine;
}

static bool make_model(const urdf_tree *tree, const urdf_chain *chain, const parts *parts, bool any_motion,
                       arm_model *model)
{
    char name[64], title[128], source[512];
    const char *const slash = strrchr(tree->path, '/');
    snprintf(name, sizeof name, "%s", tree->robot);
    snprintf(title, sizeof title, "%s", tree->robot);
    snprintf(source, sizeof source, "URDF file %.160s, from %.160s to %.160s",
             slash != NULL ? slash + 1 : tree->path, tree->links[chain->base].name,
             tree->links[chain->tip].name);
    make_word(name);
    make_printable(title);
    make_printable(source);
    const armtol_arm arm = {
        .name = name,
        .title = title,
        .source = source,
        .unit = ARMTOL_METRE,
        .n_links = parts->n_links,
        .links = parts->links,
        .drives = parts->drives,
        .masses = parts->has_masses ? parts->masses : NULL,
        .motions = any_motion ? parts->motions : NULL,
        .names = (const char *const *)parts->names,
    };
    return arm_model_make(model, &arm, UNIT_RADIAN);
}

/* Where the chain goes up, the links hang from another base than the one that the masses are carried by. */
static bool make_masses(const urdf_tree *tree, const urdf_chain *chain, parts *parts)
{
    return chain->n_up > 0 || urdf_masses_make(tree, parts->carried, parts->links, parts->n_links, parts->masses,
                                               &parts->has_masses);
}

bool urdf_arm_make(const urdf_tree *tree, const urdf_chain *chain, arm_model *model)
{
    parts parts;
    bool any_motion;
    if (!urdf_chain_check(tree, chain)) {
        return false;
    }
    bool fine = parts_start(&parts, chain->n_joints, tree->n_links);
    for (size_t i = 0; i < chain->n_joints && fine; i++) {
        add_joint(&parts, tree, chain->joints[i], i < chain->n_up);
    }
    fine = fine && make_links(tree, chain, &parts) && make_motions(tree, &parts, &any_motion) &&
           make_masses(tree, chain, &parts) && make_names(tree, chain, &parts) &&
           make_model(tree, chain, &parts, any_motion, model);
    parts_free(&parts);
    if (fine) {
        urdf_chain_warn(tree, chain);
    }
    return fine;
}
