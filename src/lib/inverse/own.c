#include "lib/inverse/own.h"

#include "armtol/euler.h"
#include "armtol/link_transform.h"
#include "armtol/transform.h"

enum { MOST_LINKS = 8, WISH = 6 };

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

/* A pose of a robot's wish: where that has four numbers, the tool turns about the upright alone. */
static armtol_transform tool_of_wish(const armtol_robot *robot, const double wish[])
{
    double pose[WISH] = {wish[0], wish[1], wish[2]};
    if (robot->n_wish == WISH) {
        pose[3] = wish[3];
        pose[4] = wish[4];
    }
    pose[5] = wish[robot->n_wish - 1];
    return armtol_pose_to_transform(pose, &armtol_errata_none);
}

/*
 * The programs of 1987 ask for another frame at the tool than the table has: the Intelledex's is a quarter turn about
 * the tool's axis from it. What lies between the two is the same in every posture, so that of joint values 0 tells it.
 */
static armtol_transform as_wished(const armtol_robot *robot, const armtol_transform *last)
{
    const double q[MOST_LINKS] = {0};
    double wish[WISH];
    armtol_link links[MOST_LINKS];
    robot->links(&armtol_errata_none, links);
    robot->forward(q, &armtol_errata_none, wish);
    const armtol_transform table = armtol_chain_transform(links, robot->n_links, &armtol_errata_none);
    const armtol_transform back = armtol_transform_inverse(&table, &armtol_errata_none);
    const armtol_transform wished = tool_of_wish(robot, wish);
    const armtol_transform between = armtol_transform_product(&back, &wished, &armtol_errata_none);
    return armtol_transform_product(last, &between, &armtol_errata_none);
}

/* A tilt that a wish of four numbers cannot tell is left to whoever compares. */
bool own_inverse(const armtol_robot *robot, const armtol_transform *last, double q[])
{
    const armtol_transform tool = as_wished(robot, last);
    armtol_reach reach;
    double pose[WISH];
    armtol_transform_to_pose(&tool, &armtol_errata_none, pose);
    pose[3] = robot->n_wish == WISH ? pose[3] : pose[5];
    return robot->inverse(pose, &armtol_errata_none, q, &reach) == ARMTOL_OK;
}
