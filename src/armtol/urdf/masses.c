#include "armtol/urdf/masses.h"

#include "armtol/link_transform.h"
#include "armtol/urdf/origin.h"
#include "console/exit_code.h"

#include <stdlib.h>

/* Up to what is known, and down again; `way` has a place a link. What hangs from nothing known is not carried. */
static void find_carried(const urdf_tree *tree, urdf_carried carried[], size_t link, size_t way[])
{
    size_t n = 0;
    while (!carried[link].known && tree->links[link].above != URDF_NONE) {
        way[n++] = link;
        link = tree->joints[tree->links[link].above].parent;
    }
    if (!carried[link].known) {
        carried[link] = (urdf_carried){.known = true, .at = armtol_transform_identity()};
    }
    while (n > 0) {
        const size_t child = way[--n];
        const armtol_transform origin = urdf_joint_origin(&tree->joints[tree->links[child].above]);
        carried[child] = (urdf_carried){true, carried[link].axis,
                                        armtol_transform_product(&carried[link].at, &origin, &armtol_errata_none)};
        link = child;
    }
}

static void move_point(const armtol_transform *by, const double point[3], double moved[3])
{
    for (int i = 0; i < 3; i++) {
        moved[i] = by->m[i][0] * point[0] + by->m[i][1] * point[1] + by->m[i][2] * point[2] + by->m[i][3];
    }
}

/* The place of the link that an axis moves. */
static size_t link_of_axis(const armtol_link links[], size_t axis)
{
    size_t i = 0;
    for (size_t seen = links[0].joint != ARMTOL_FIXED; seen < axis; seen += links[i].joint != ARMTOL_FIXED) {
        i++;
    }
    return i;
}

/* From sums in the base's coordinates to a center in the frame of the link. */
static void settle(const armtol_link links[], size_t link, armtol_mass *mass)
{
    const armtol_transform at = armtol_chain_transform(links, link + 1, &armtol_errata_none);
    const armtol_transform back = armtol_transform_inverse(&at, &armtol_errata_none);
    double center[3];
    for (int i = 0; i < 3; i++) {
        center[i] = mass->center[i] / mass->mass;
    }
    move_point(&back, center, mass->center);
}

bool urdf_masses_make(const urdf_tree *tree, urdf_carried carried[], const armtol_link links[], size_t n_links,
                      armtol_mass masses[], bool *any)
{
    size_t *const way = calloc(tree->n_links + 1, sizeof *way);
    if (way == NULL) {
        out_of_memory();
        return false;
    }
    *any = false;
    for (size_t i = 0; i < tree->n_links; i++) {
        find_carried(tree, carried, i, way);
        if (tree->links[i].mass > 0 && carried[i].axis > 0) {
            armtol_mass *to = &masses[link_of_axis(links, carried[i].axis)];
            double center[3];
            move_point(&carried[i].at, tree->links[i].center, center);
            to->mass += tree->links[i].mass;
            for (int k = 0; k < 3; k++) { /* for now the sum of masses times centers, in the base's coordinates */
                to->center[k] += tree->links[i].mass * center[k];
            }
        }
    }
    for (size_t i = 0; i < n_links; i++) {
        if (masses[i].mass > 0) {
            settle(links, i, &masses[i]);
            *any = true;
        }
    }
    free(way);
    return true;
}
