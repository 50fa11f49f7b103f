#include "armtol/urdf/arm.h"

#include "armtol/axes.h"
#include "armtol/transform.h"
#include "armtol/urdf/masses.h"
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
    size_t n_axes;
    armtol_transform tip; /* of the chain so far, all joints at 0 */
    armtol_link *links;
    armtol_drive *drives; /* of the links */
    armtol_mass *masses;  /* likewise */
    bool has_masses;
    size_t n_links;
    urdf_carried *carried; /* of the links of the tree */
} parts;

static bool parts_start(parts *parts, size_t most_axes, size_t n_tree_links)
{
    *parts = (struct parts){
        .axes = calloc(most_axes + 1, sizeof *parts->axes),
        .axis_drives = calloc(most_axes + 1, sizeof *parts->axis_drives),
        .tip = armtol_transform_identity(),
        .links = calloc(ARMTOL_LINKS_OF_AXES(most_axes), sizeof *parts->links),
        .drives = calloc(ARMTOL_LINKS_OF_AXES(most_axes), sizeof *parts->drives),
        .masses = calloc(ARMTOL_LINKS_OF_AXES(most_axes), sizeof *parts->masses),
        .carried = calloc(n_tree_links, sizeof *parts->carried),
    };
    const bool fine = parts->axes != NULL && parts->axis_drives != NULL && parts->links != NULL &&
                      parts->drives != NULL && parts->masses != NULL && parts->carried != NULL;
    if (!fine) {
        out_of_memory();
    }
    return fine;
}

static void parts_free(parts *parts)
{
    free(parts->axes);
    free(parts->axis_drives);
    free(parts->links);
    free(parts->drives);
    free(parts->masses);
    free(parts->carried);
}

/* ---- joints to axes ---- */

static void add_axis(parts *parts, const urdf_joint *joint)
{
    armtol_axis *const axis = &parts->axes[parts->n_axes];
    *axis = (armtol_axis){.joint = joint->type == URDF_PRISMATIC ? ARMTOL_PRISMATIC : ARMTOL_REVOLUTE};
    for (int i = 0; i < 3; i++) {
        axis->point[i] = parts->tip.m[i][3];
        for (int k = 0; k < 3; k++) {
            axis->direction[i] += parts->tip.m[i][k] * joint->axis[k];
        }
    }
    armtol_drive *const drive = &parts->axis_drives[parts->n_axes];
    *drive = armtol_drive_unknown;
    drive->low = joint->low;
    drive->high = joint->high;
    parts->n_axes++;
}

static bool refuse(const urdf_joint *joint, const char *what)
{
    file_message(&joint->place,
                 "joint %s %s; an arm's joints are fixed, revolute, continuous or prismatic, "
                 "each with a motor of its own",
                 message_quote(joint->name, &(quoted){""}), what);
    return false;
}

static bool add_joint(parts *parts, const urdf_joint *joint)
{
    if (joint->type == URDF_PLANAR || joint->type == URDF_FLOATING) {
        return refuse(joint, joint->type == URDF_PLANAR ? "is planar" : "is floating");
    }
    if (joint->mimics) {
        return refuse(joint, "mimics another");
    }
    const armtol_transform origin = urdf_joint_origin(joint);
    parts->tip = armtol_transform_product(&parts->tip, &origin, &armtol_errata_none);
    if (joint->type != URDF_FIXED) {
        add_axis(parts, joint);
    }
    parts->carried[joint->child] = (urdf_carried){true, parts->n_axes, parts->tip};
    return true;
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
    const armtol_status status =
        armtol_links_of_axes(parts->axes, parts->n_axes, &parts->tip, 0, parts->links, &parts->n_links, NULL, &n_snapped);
    if (status != ARMTOL_OK) {
        return no_arm(tree, chain, armtol_status_text(status));
    }
    size_t axis = 0;
    for (size_t i = 0; i < parts->n_links; i++) {
        const bool moves = parts->links[i].joint != ARMTOL_FIXED;
        parts->drives[i] = moves ? parts->axis_drives[axis++] : armtol_drive_unknown;
    }
    return true;
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

static bool make_model(const urdf_tree *tree, const urdf_chain *chain, const parts *parts, arm_model *model)
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
    };
    return arm_model_make(model, &arm, UNIT_RADIAN);
}

bool urdf_arm_make(const urdf_tree *tree, const urdf_chain *chain, arm_model *model)
{
    parts parts;
    bool fine = parts_start(&parts, chain->n_joints, tree->n_links);
    if (fine) {
        parts.carried[chain->base] = (urdf_carried){.known = true, .at = armtol_transform_identity()};
    }
    for (size_t i = 0; i < chain->n_joints && fine; i++) {
        fine = add_joint(&parts, &tree->joints[chain->joints[i]]);
    }
    fine = fine && make_links(tree, chain, &parts) &&
           urdf_masses_make(tree, parts.carried, parts.links, parts.n_links, parts.masses, &parts.has_masses) &&
           make_model(tree, chain, &parts, model);
    parts_free(&parts);
    return fine;
}
