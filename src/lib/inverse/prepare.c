#include "lib/inverse/prepare.h"

#include "lib/arms/motion.h"
#include "lib/pi.h"
#include "lib/report/finite.h"
#include "lib/report/trigonometry.h"

#include <math.h>

static chain_link prepared(const armtol_link *link)
{
    const armtol_errata *none = &armtol_errata_none;
    return (chain_link){
        .joint = link->joint,
        .a = link->a,
        .d = link->d,
        .theta = link->theta,
        .sin_alpha = sine_of(none, link->alpha),
        .cos_alpha = cosine_of(none, link->alpha),
        .sin_beta = sine_of(none, link->beta),
        .cos_beta = cosine_of(none, link->beta),
        .factor = 1,
    };
}

/* How a link's joint is moved by those that move by themselves. */
static void take_motion(chain_link *link, const armtol_arm *arm, size_t i)
{
    const armtol_motion motion = arm_motion(arm, i);
    link->driver = armtol_arm_joint_of(arm, motion.follows);
    link->factor = motion.sign * motion.multiplier;
    link->offset = motion.follows == i ? 0 : motion.sign * motion.offset;
}

static void take_links(chain *chain, const armtol_arm *arm)
{
    for (size_t i = 0; i < arm->n_links; i++) {
        chain->links[i] = prepared(&arm->links[i]);
        if (arm->links[i].joint != ARMTOL_FIXED) {
            take_motion(&chain->links[i], arm, i);
        }
    }
    for (size_t j = 0; j < chain->n_joints; j++) {
        chain->joints[j] = (chain_joint){.low = -(double)INFINITY, .high = (double)INFINITY, .turns = true};
    }
}

/* How far a slide gets from its link's frame, as far as its limits say. */
static double travel_of(const armtol_drive *drive)
{
    const double low = isfinite(drive->low) ? fabs(drive->low) : 0;
    return isfinite(drive->high) ? fmax(low, fabs(drive->high)) : low;
}

static double size_of(const chain *chain, const armtol_arm *arm)
{
    double size = length_of_vector(chain->offset);
    for (size_t i = 0; i < arm->n_links; i++) {
        size += fabs(arm->links[i].a) + fabs(arm->links[i].d);
        size += arm->links[i].joint == ARMTOL_PRISMATIC ? travel_of(&arm->drives[i]) : 0;
    }
    return size > 0 ? size : 1;
}

/* A whole turn of a joint changes nothing if all that it moves turns, and whole turns at that. */
static void take_joint(chain *chain, const armtol_arm *arm, size_t i)
{
    const chain_link *link = &chain->links[i];
    chain_joint *joint = &chain->joints[link->driver];
    joint->turns = joint->turns && link->joint == ARMTOL_REVOLUTE && link->factor == floor(link->factor);
    if (armtol_arm_is_driven(arm, i)) {
        joint->slides = link->joint == ARMTOL_PRISMATIC;
        joint->unit = joint->slides ? chain->size : 1;
    }
}

/* The joint's limits, and what a link's limits are for the joint that it follows: (limit - offset) / multiplier. */
static void take_limits(chain *chain, const armtol_arm *arm, size_t i)
{
    chain_joint *joint = &chain->joints[chain->links[i].driver];
    const armtol_motion motion = arm_motion(arm, i);
    if (motion.multiplier != 0) {
        const double one = (arm->drives[i].low - motion.offset) / motion.multiplier;
        const double other = (arm->drives[i].high - motion.offset) / motion.multiplier;
        joint->low = fmax(joint->low, fmin(one, other));
        joint->high = fmin(joint->high, fmax(one, other));
    }
}

static double usual_near(const chain_joint *joint)
{
    if (isfinite(joint->low) && isfinite(joint->high)) {
        return joint->low / 2 + joint->high / 2;
    }
    return fmin(fmax(0, joint->low), joint->high);
}

armtol_status prepare_chain(chain *chain, const armtol_inverse_setup *setup)
{
    const armtol_arm *arm = setup->arm;
    take_links(chain, arm);
    chain->size = size_of(chain, arm);
    if (!all_finite(setup->offset, 3) || !isfinite(chain->size)) {
        return ARMTOL_NOT_FINITE;
    }
    for (size_t i = 0; i < arm->n_links; i++) {
        if (arm->links[i].joint != ARMTOL_FIXED) {
            take_joint(chain, arm, i);
            if (!setup->ignore_limits) {
                take_limits(chain, arm, i);
            }
        }
    }
    for (size_t j = 0; j < chain->n_joints; j++) {
        chain->joints[j].near = setup->near != NULL ? setup->near[j] : usual_near(&chain->joints[j]);
    }
    return setup->near == NULL || all_finite(setup->near, chain->n_joints) ? ARMTOL_OK : ARMTOL_NOT_FINITE;
}
