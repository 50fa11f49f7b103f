#include "lib/arms/motion.h"

#include "lib/report/finite.h"

static bool follows_itself(const armtol_arm *arm, size_t link)
{
    return arm->motions == NULL || arm->motions[link].follows == link;
}

armtol_motion arm_motion(const armtol_arm *arm, size_t link)
{
    armtol_motion motion = {.follows = link, .multiplier = 1, .sign = 1};
    if (arm->motions != NULL && arm->links[link].joint != ARMTOL_FIXED) {
        motion = arm->motions[link];
    }
    if (motion.follows == link) {
        motion.multiplier = 1;
        motion.offset = 0;
    }
    return motion;
}

bool armtol_arm_is_driven(const armtol_arm *arm, size_t link)
{
    return arm->links[link].joint != ARMTOL_FIXED && follows_itself(arm, link);
}

size_t armtol_arm_joint_of(const armtol_arm *arm, size_t link)
{
    size_t count = 0;
    for (size_t i = 0; i < link; i++) {
        count += armtol_arm_is_driven(arm, i);
    }
    return count;
}

size_t armtol_arm_joint_count(const armtol_arm *arm)
{
    return armtol_arm_joint_of(arm, arm->n_links);
}

size_t armtol_arm_link_of(const armtol_arm *arm, size_t joint)
{
    size_t link = 0, before = 0;
    while (link < arm->n_links && !(armtol_arm_is_driven(arm, link) && before == joint)) {
        before += armtol_arm_is_driven(arm, link++);
    }
    return link;
}

/* *joint is the number of the next joint that moves by itself. */
static double value_of(const armtol_arm *arm, const double q[], size_t link, size_t *joint)
{
    if (arm->links[link].joint == ARMTOL_FIXED) {
        return 0;
    }
    if (follows_itself(arm, link)) {
        return q[(*joint)++];
    }
    const armtol_motion *motion = &arm->motions[link];
    return motion->multiplier * q[armtol_arm_joint_of(arm, motion->follows)] + motion->offset;
}

double armtol_arm_joint_value(const armtol_arm *arm, const double q[], size_t link)
{
    size_t joint = armtol_arm_joint_of(arm, link);
    return value_of(arm, q, link, &joint);
}

static armtol_status check_motion(const armtol_arm *arm, size_t link)
{
    const armtol_motion *motion = &arm->motions[link];
    if (arm->links[link].joint == ARMTOL_FIXED) {
        return ARMTOL_OK;
    }
    const bool sign = motion->sign == 1 || motion->sign == -1;
    if (!sign || motion->follows >= arm->n_links || !armtol_arm_is_driven(arm, motion->follows)) {
        return ARMTOL_BAD_JOINT;
    }
    const double values[] = {motion->multiplier, motion->offset};
    return motion->follows == link || all_finite(values, 2) ? ARMTOL_OK : ARMTOL_NOT_FINITE;
}

armtol_status armtol_arm_check(const armtol_arm *arm)
{
    armtol_status status = armtol_links_check(arm->links, arm->n_links);
    for (size_t i = 0; i < arm->n_links && status == ARMTOL_OK && arm->motions != NULL; i++) {
        status = check_motion(arm, i);
    }
    return status;
}

static armtol_status place_link(const armtol_arm *arm, const double q[], size_t link, size_t *joint,
                                armtol_link *placed)
{
    const double moved = arm_motion(arm, link).sign * value_of(arm, q, link, joint);
    return armtol_links_place(&arm->links[link], 1, &moved, arm->links[link].joint != ARMTOL_FIXED, &armtol_errata_none,
                              placed);
}

/* placed may be NULL. */
static armtol_status place_all(const armtol_arm *arm, const double q[], armtol_link placed[])
{
    armtol_status status = ARMTOL_OK;
    armtol_link unused;
    size_t joint = 0;
    for (size_t i = 0; i < arm->n_links && status == ARMTOL_OK; i++) {
        status = place_link(arm, q, i, &joint, placed != NULL ? &placed[i] : &unused);
    }
    return status;
}

armtol_status armtol_arm_place(const armtol_arm *arm, const double q[], size_t n_joints, armtol_link placed[])
{
    armtol_status status = armtol_arm_check(arm);
    if (status == ARMTOL_OK && n_joints != armtol_arm_joint_count(arm)) {
        status = ARMTOL_WRONG_SIZE;
    }
    if (status == ARMTOL_OK) {
        status = place_all(arm, q, NULL);
    }
    return status == ARMTOL_OK ? place_all(arm, q, placed) : status;
}
