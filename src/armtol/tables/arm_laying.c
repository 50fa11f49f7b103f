#include "armtol/tables/arm_laying.h"

#include "armtol/tables/laid_masses.h"
#include "console/exit_code.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

/* What an arm is laid anew from, and with. */
typedef struct layer {
    const arm_model *model;
    armtol_axis *axes;
    size_t n_axes;
    armtol_transform tool;
    armtol_link *links;
    armtol_drive *drives;
    armtol_mass *masses;
    armtol_motion *motions;
    const char **names;
    size_t *joint_links; /* of the model's joints: the new links */
    size_t n_links;
    armtol_snapped *snapped;
    size_t n_snapped;
} layer;

static bool layer_start(layer *layer, const arm_model *model)
{
    const size_t most = ARMTOL_LINKS_OF_AXES(model->arm.n_links);
    *layer = (struct layer){
        .model = model,
        .axes = calloc(most, sizeof *layer->axes),
        .links = calloc(most, sizeof *layer->links),
        .drives = calloc(most, sizeof *layer->drives),
        .masses = calloc(most, sizeof *layer->masses),
        .motions = calloc(most, sizeof *layer->motions),
        .names = calloc(most, sizeof *layer->names),
        .joint_links = calloc(most, sizeof *layer->joint_links),
        .snapped = calloc(most, sizeof *layer->snapped),
    };
    return enough_memory(layer->axes != NULL && layer->links != NULL && layer->drives != NULL &&
                         layer->masses != NULL && layer->motions != NULL && layer->names != NULL &&
                         layer->joint_links != NULL && layer->snapped != NULL);
}

static void layer_free(layer *layer)
{
    free(layer->axes);
    free(layer->links);
    free(layer->drives);
    free(layer->masses);
    free(layer->motions);
    free(layer->names);
    free(layer->joint_links);
    free(layer->snapped);
}

/* False for an arm of fixed links, and for one whose numbers overflow: they stay as they are. */
static bool find_axes(layer *layer)
{
    const armtol_arm *arm = &layer->model->arm;
    return armtol_joint_count(arm->links, arm->n_links) > 0 &&
           armtol_axes_of_links(arm->links, arm->n_links, layer->axes, &layer->n_axes, &layer->tool) == ARMTOL_OK;
}

static bool find_links(layer *layer, double snap)
{
    return armtol_links_of_axes(layer->axes, layer->n_axes, &layer->tool, snap, layer->links, &layer->n_links,
                                layer->snapped, &layer->n_snapped) == ARMTOL_OK;
}

/* The link of the old arm that has its joint of that number. */
static size_t link_of_joint(const armtol_arm *arm, size_t joint)
{
    size_t link = 0;
    while (arm->links[link].joint == ARMTOL_FIXED || joint-- > 0) {
        link++;
    }
    return link;
}

static size_t joint_of_link(const armtol_arm *arm, size_t link)
{
    return armtol_joint_count(arm->links, link);
}

static void note_links(layer *layer)
{
    size_t joint = 0;
    for (size_t i = 0; i < layer->n_links; i++) {
        if (layer->links[i].joint != ARMTOL_FIXED) {
            layer->joint_links[joint++] = i;
        }
    }
}

/* Drives and motions follow their joints; fixed links have none. */
static void move_drives(layer *layer)
{
    const armtol_arm *arm = &layer->model->arm;
    note_links(layer);
    for (size_t i = 0; i < layer->n_links; i++) {
        layer->drives[i] = armtol_drive_unknown;
        layer->motions[i] = (armtol_motion){.follows = i, .multiplier = 1, .sign = 1};
    }
    for (size_t joint = 0; joint < layer->n_axes; joint++) {
        const size_t from = link_of_joint(arm, joint), to = layer->joint_links[joint];
        layer->drives[to] = arm->drives[from];
        if (arm->motions != NULL) {
            layer->motions[to] = arm->motions[from];
            layer->motions[to].follows = layer->joint_links[joint_of_link(arm, arm->motions[from].follows)];
        }
    }
}

/* Names follow their joints too; that of the old first or last link stays in its place if both are fixed. */
static void move_names(layer *layer)
{
    const armtol_arm *arm = &layer->model->arm;
    const size_t last = layer->n_links - 1, old_last = arm->n_links - 1;
    for (size_t joint = 0; joint < layer->n_axes; joint++) {
        layer->names[layer->joint_links[joint]] = arm->names[link_of_joint(arm, joint)];
    }
    if (layer->links[0].joint == ARMTOL_FIXED && arm->links[0].joint == ARMTOL_FIXED) {
        layer->names[0] = arm->names[0];
    }
    if (layer->links[last].joint == ARMTOL_FIXED && arm->links[old_last].joint == ARMTOL_FIXED) {
        layer->names[last] = arm->names[old_last];
    }
}

static bool replace(layer *layer, arm_model *model, const arm_laying *laying)
{
    armtol_arm arm = model->arm;
    arm_model laid;
    move_drives(layer);
    if (arm.masses != NULL) {
        laid_masses_make(&model->arm, layer->links, layer->n_links, layer->masses);
        arm.masses = layer->masses;
    }
    if (arm.names != NULL) {
        move_names(layer);
        arm.names = layer->names;
    }
    arm.n_links = layer->n_links;
    arm.links = layer->links;
    arm.drives = layer->drives;
    arm.motions = arm.motions != NULL ? layer->motions : NULL;
    if (!arm_model_make(&laid, &arm, model->angle_unit)) {
        return false;
    }
    laid.laying = *laying;
    arm_model_free(model);
    *model = laid;
    return true;
}

bool arm_laying_snap(arm_model *model, double snap)
{
    layer layer;
    bool fine = layer_start(&layer, model);
    if (fine && find_axes(&layer) && find_links(&layer, snap) && layer.n_snapped > 0) {
        const arm_laying laying = {.n_axes = layer.n_axes, .n_snapped = layer.n_snapped, .snapped = layer.snapped};
        fine = replace(&layer, model, &laying);
        layer.snapped = fine ? NULL : layer.snapped;
    }
    layer_free(&layer);
    return fine;
}

bool arm_laying_gather(arm_model *model)
{
    layer layer;
    bool fine = layer_start(&layer, model);
    if (fine && find_axes(&layer)) {
        const armtol_spread spread = armtol_spread_of_axes(layer.axes, layer.n_axes, &layer.tool);
        /* As many roundings as a frame that far off leaves in what is near. */
        const double rounding = 16 * DBL_EPSILON * spread.farthest / spread.reach;
        if (spread.farthest > 3 * spread.reach && spread.reach > 0 && find_links(&layer, rounding)) {
            fine = replace(&layer, model, &(arm_laying){.farthest = spread.farthest, .n_axes = layer.n_axes});
        }
    }
    layer_free(&layer);
    return fine;
}
