#include "lib/inverse/own.h"

#include "armtol/euler.h"

enum { MOST_LINKS = 8 };

static bool same_link(const armtol_link *one, const armtol_link *other)
{
    return one->kind == other->kind && one->joint == other->joint && one->a == other->a && one->alpha == other->alpha &&
           one->d == other->d && one->theta == other->theta && one->beta == other->beta;
}

static bool is_of(const armtol_arm *arm, const armtol_robot *robot)
{
    armtol_link links[MOST_LINKS];
    bool same = arm->n_links == robot->n_links && arm->unit == ARMTOL_MILLIMETRE && arm->motions == NULL;
    robot->links(&armtol_errata_none, links);
    for (size_t i = 0; i < robot->n_links && same; i++) {
        same = same_link(&arm->links[i], &links[i]);
    }
    return same;
}

const armtol_robot *own_robot(const armtol_arm *arm)
{
    return is_of(arm, &armtol_intelledex_605t) ? &armtol_intelledex_605t
           : is_of(arm, &armtol_adept_one)     ? &armtol_adept_one
                                               : NULL;
}

/* A wish of four numbers is one of an arm whose tool only turns about the upright: its tilt is left to the comparison. */
bool own_inverse(const armtol_robot *robot, const armtol_transform *last, double q[])
{
    armtol_reach reach;
    double pose[6];
    armtol_transform_to_pose(last, &armtol_errata_none, pose);
    if (robot->n_wish == 4) {
        pose[3] = pose[5];
    }
    return robot->inverse(pose, &armtol_errata_none, q, &reach) == ARMTOL_OK;
}
