#include "armtol/urdf/arm.h"

#include "armtol/axes.h"
#include "armtol/euler.h"
#include "armtol/transform.h"
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
    size_t n_links;
} parts;

static bool parts_start(parts *parts, size_t most_axes)
{
    *parts = (struct parts){
        .axes = calloc(most_axes + 1, sizeof *parts->axes),
        .axis_drives = calloc(most_axes + 1, sizeof *parts->axis_drives),
        .tip = armtol_transform_identity(),
        .links = calloc(ARMTOL_LINKS_OF_AXES(most_axes), sizeof *parts->links),
        .drives = calloc(ARMTOL_LINKS_OF_AXES(most_axes), sizeof *parts->drives),
    };
    const bool fine =
        parts->axes != NULL && parts->axis_drives != NULL && parts->links != NULL && parts->drives != NULL;
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
}

/* ---- joints to axes ---- */

static armtol_transform origin_of(const urdf_joint *joint)
{
    const double *p = joint->xyz, *rpy = joint->rpy;
    return armtol_pose_to_transform((const double[6]){p[0], p[1], p[2], rpy[0], rpy[1], rpy[2]}, &armtol_errata_none);
}

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
    const armtol_transform origin = origin_of(joint);
    parts->tip = armtol_transform_product(&parts->tip, &origin, &armtol_errata_none);
    if (joint->type != URDF_FIXED) {
        add_axis(parts, joint);
    }
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
    const armtol_status status =
        armtol_links_of_axes(parts->axes, parts->n_axes, &parts->tip, parts->links, &parts->n_links);
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
    };
    return arm_model_make(model, &arm, UNIT_RADIAN);
}

bool urdf_arm_make(const urdf_tree *tree, const urdf_chain *chain, arm_model *model)
{
    parts parts;
    bool fine = parts_start(&parts, chain->n_joints);
    for (size_t i = 0; i < chain->n_joints && fine; i++) {
        fine = add_joint(&parts, &tree->joints[chain->joints[i]]);
    }
    fine = fine && make_links(tree, chain, &parts) && make_model(tree, chain, &parts, model);
    parts_free(&parts);
    return fine;
}
