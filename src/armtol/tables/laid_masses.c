#include "armtol/tables/laid_masses.h"

#include "armtol/link_transform.h"
#include "armtol/transform.h"

static void add(armtol_mass *to, const armtol_mass *mass, const armtol_transform *frame)
{
    const double *c = mass->center;
    to->mass += mass->mass;
    for (int i = 0; i < 3; i++) { /* for now the sum of masses times centers */
        const double *row = frame->m[i];
        to->center[i] += mass->mass * (row[0] * c[0] + row[1] * c[1] + row[2] * c[2] + row[3]);
    }
}

/* From the sum, in the base's coordinates, to the center in those of a frame. */
static void settle(armtol_mass *mass, const armtol_transform *frame)
{
    const armtol_transform back = armtol_transform_inverse(frame, &armtol_errata_none);
    armtol_mass settled = {.mass = mass->mass};
    for (int i = 0; i < 3 && mass->mass > 0; i++) {
        settled.center[i] = back.m[i][3];
        for (int k = 0; k < 3; k++) {
            settled.center[i] += back.m[i][k] * mass->center[k] / mass->mass;
        }
    }
    *mass = settled;
}

/* The link that so many joints move, the first of them; n_links where there is none. */
static size_t link_behind(const armtol_link links[], size_t n_links, size_t joints)
{
    size_t i = 0;
    for (size_t seen = links[0].joint != ARMTOL_FIXED; seen < joints; seen += links[i].joint != ARMTOL_FIXED) {
        i++;
    }
    return joints > 0 || links[0].joint == ARMTOL_FIXED ? i : n_links;
}

void laid_masses_make(const armtol_arm *arm, const armtol_link links[], size_t n_links, armtol_mass masses[])
{
    size_t joints = 0;
    for (size_t i = 0; i < n_links; i++) {
        masses[i] = (armtol_mass){.mass = 0};
    }
    for (size_t i = 0; i < arm->n_links; i++) {
        const armtol_transform frame = armtol_chain_transform(arm->links, i + 1, &armtol_errata_none);
        joints += arm->links[i].joint != ARMTOL_FIXED;
        const size_t to = link_behind(links, n_links, joints);
        if (to < n_links) {
            add(&masses[to], &arm->masses[i], &frame);
        }
    }
    for (size_t i = 0; i < n_links; i++) {
        const armtol_transform frame = armtol_chain_transform(links, i + 1, &armtol_errata_none);
        settle(&masses[i], &frame);
    }
}
