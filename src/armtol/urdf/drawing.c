#include "armtol/urdf/drawing.h"

#include "console/exit_code.h"

#include <math.h>
#include <stdlib.h>

/* Who hangs from whom, so that a tree can be walked without going deep into the stack. */
typedef struct drawing {
    const urdf_tree *tree;
    const urdf_units *units;
    FILE *stream;
    size_t *first; /* of a link: the first joint below it */
    size_t *next;  /* of a joint: the next one below the same link */
} drawing;

static bool start(drawing *drawing)
{
    const urdf_tree *tree = drawing->tree;
    drawing->first = calloc(tree->n_links + 1, sizeof *drawing->first);
    drawing->next = calloc(tree->n_joints + 1, sizeof *drawing->next);
    if (drawing->first == NULL || drawing->next == NULL) {
        out_of_memory();
        return false;
    }
    for (size_t i = 0; i < tree->n_links; i++) {
        drawing->first[i] = URDF_NONE;
    }
    for (size_t i = tree->n_joints; i-- > 0;) {
        drawing->next[i] = drawing->first[tree->joints[i].parent];
        drawing->first[tree->joints[i].parent] = i;
    }
    return true;
}

/* ---- one line ---- */

static void write_name(const drawing *drawing, const char *name)
{
    for (; *name != '\0'; name++) {
        const unsigned char c = (unsigned char)*name;
        fputc(c < ' ' || c == 127 ? '?' : c, drawing->stream);
    }
}

static void write_number(const drawing *drawing, const urdf_joint *joint, double value)
{
    const urdf_units *units = drawing->units;
    fprintf(drawing->stream, "%.6g", value * (joint->type == URDF_PRISMATIC ? units->per_metre : units->per_radian));
}

static void write_limits(const drawing *drawing, const urdf_joint *joint)
{
    if (!urdf_joint_moves(joint) || (isinf(joint->low) && isinf(joint->high))) {
        return;
    }
    fputs(", ", drawing->stream);
    write_number(drawing, joint, joint->low);
    fputs(" to ", drawing->stream);
    write_number(drawing, joint, joint->high);
    fprintf(drawing->stream, " %s", joint->type == URDF_PRISMATIC ? drawing->units->length : drawing->units->angle);
}

static void write_leader(const drawing *drawing, const urdf_joint *joint)
{
    if (joint->leader_name != NULL) {
        fprintf(drawing->stream, ", %.6g x ", joint->multiplier);
        write_name(drawing, joint->leader_name);
        fputs(joint->offset != 0 ? " + " : "", drawing->stream);
        if (joint->offset != 0) {
            write_number(drawing, joint, joint->offset);
        }
    }
}

static void write_joint(const drawing *drawing, const urdf_joint *joint)
{
    fputs("  (", drawing->stream);
    write_name(drawing, joint->name);
    fprintf(drawing->stream, ": %s", joint->fault == NULL ? urdf_joint_type_names[joint->type] : "with a fault");
    if (joint->fault == NULL) {
        write_limits(drawing, joint);
        write_leader(drawing, joint);
    }
    fputs(")", drawing->stream);
}

static void write_link(const drawing *drawing, size_t link, size_t depth)
{
    enum { WIDTH = 2, DEEPEST = 40 }; /* deeper ones stand below each other */
    const size_t above = drawing->tree->links[link].above;
    const size_t indent = depth < DEEPEST ? depth : DEEPEST;
    fprintf(drawing->stream, "%*s", (int)(WIDTH * indent), "");
    write_name(drawing, drawing->tree->links[link].name);
    if (above != URDF_NONE) {
        write_joint(drawing, &drawing->tree->joints[above]);
    }
    fputc('\n', drawing->stream);
}

/* ---- the tree ---- */

/*
 * The joint after a link that has nothing more below it: beside it, or beside one above it. *depth is then its child's.
 */
static size_t joint_after(const drawing *drawing, size_t link, size_t *depth)
{
    const urdf_tree *tree = drawing->tree;
    size_t above = tree->links[link].above;
    while (above != URDF_NONE && drawing->next[above] == URDF_NONE) {
        above = tree->links[tree->joints[above].parent].above;
        --*depth;
    }
    return above != URDF_NONE ? drawing->next[above] : URDF_NONE;
}

static void draw_from(const drawing *drawing, size_t root)
{
    size_t link = root, depth = 0, joint;
    do {
        write_link(drawing, link, depth);
        joint = drawing->first[link];
        depth += joint != URDF_NONE;
        joint = joint != URDF_NONE ? joint : joint_after(drawing, link, &depth);
        link = joint != URDF_NONE ? drawing->tree->joints[joint].child : link;
    } while (joint != URDF_NONE);
}

bool urdf_tree_draw(const urdf_tree *tree, const urdf_units *units, FILE *stream)
{
    drawing drawing = {tree, units, stream, NULL, NULL};
    const bool fine = start(&drawing);
    for (size_t i = 0; i < tree->n_links && fine; i++) {
        if (tree->links[i].above == URDF_NONE) {
            draw_from(&drawing, i);
        }
    }
    free(drawing.first);
    free(drawing.next);
    return fine;
}
