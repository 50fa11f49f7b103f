#ifndef ARMTOL_AXES_H
#define ARMTOL_AXES_H

#include "armtol/conventions.h"
#include "armtol/interface.h"
#include "armtol/link.h"
#include "armtol/status.h"

#include <stddef.h>

ARMTOL_INTERFACE_BEGIN

/* The axis of a joint, all joints at value 0, in base coordinates. */
typedef struct armtol_axis {
    armtol_joint joint;  /* ARMTOL_REVOLUTE or ARMTOL_PRISMATIC */
    double point[3];     /* on the axis; of a prismatic joint any point, only the direction counts */
    double direction[3]; /* the sense of the joint value; need not be a unit vector */
} armtol_axis;

/* What an arm of n axes has room for: a fixed link before the first joint and one behind the last. */
#define ARMTOL_LINKS_OF_AXES(n) ((n) + 2)

/*
 * The links of an arm given by its axes and by where its tool is with all joints at 0 (a rigid motion;
 * nothing looks whether it is one). The chain of *n_links links has the same kinematics: placed at any joint
 * values it brings the tool where turning about, and sliding along, the axes does. The links that move come
 * in the order of the axes, and their joint values are those of the axes. links has
 * ARMTOL_LINKS_OF_AXES(n_axes) places.
 *
 * The frames, by rules that leave no choice to rounding. Axes count as parallel within a degree of it,
 * antiparallel ones too, and as exactly parallel within 1e-13 rad.
 *
 *   not parallel    The link goes along the common perpendicular: theta and d to it, a >= 0 its length; axes
 *                   that meet have a = 0 and x along the cross product of the two. beta = 0. npr, npp. This
 *                   is the way of Denavit and Hartenberg, in Paul's order.
 *   parallel        The next origin is where the next axis pierces the plane z = 0 of the frame before:
 *                   theta to it, a its distance (both 0 on the axis itself), d = 0; then alpha and beta tilt
 *                   z to the next axis: 0 or pi, and 0, for exactly parallel ones. ppr, ppp. The common
 *                   perpendicular of such axes is anywhere, or far off, and moves by much when an axis tilts
 *                   a little; small errors of theta, d, a and alpha do not describe that. With Hayati's beta
 *                   in place of d they do (1983).
 *   prismatic       Only the direction of such an axis is a fact. Its line is put through the given point of
 *                   the next revolute axis, or through the tool's origin where none follows; the next origin
 *                   is there, d goes to it, a = 0 (and theta = 0 where parallel). So no length stands where
 *                   the kind, npp, counts none.
 *   before axis 1   A fixed link from the base's z axis to axis 1, by the same rules; left out where that is
 *                   the identity, as for an axis 1 on the base's z axis: theta and d of joint 1 do there. It
 *                   is npr, as in the tables of Hahn 1987, also for parallel lines; but ppr where the lines
 *                   are parallel and not exactly so, for Hayati's reason.
 *   behind axis n   Link n goes to the tool's z axis by the same rules, and a fixed npr link, theta and d,
 *                   from there to the tool's frame; left out where that is the identity. Where the tool's z
 *                   axis is axis n itself, theta and d go into link n. A revolute link n is then npr: ppr
 *                   counts no error of d, the length of the tool.
 *
 * Angles are in (-pi, pi]. An angle that differs from a multiple of pi/2 by no more than 1e-13 is set to it,
 * and a length to 0 that is no more than 1e-13 of the largest coordinate of the tool and the points that
 * count: this is what rounding leaves of axes that were turned into place. Kinematics changes by no more
 * than that.
 *
 * Errors: ARMTOL_WRONG_SIZE for no axes; ARMTOL_BAD_AXIS for a joint that does not move or a direction of
 * length 0; ARMTOL_NOT_FINITE, also for a link that overflows.
 */
armtol_status armtol_links_of_axes(const armtol_axis axes[], size_t n_axes, const armtol_transform *tool,
                                   armtol_link links[], size_t *n_links);

/*
 * The kind of a link with that joint by its twist angle: parallel where the axes are within a degree of it,
 * else not. A fixed link is npr at any angle, as in the tables of Hahn 1987.
 */
armtol_kind armtol_kind_of(armtol_joint joint, double alpha);

ARMTOL_INTERFACE_END

#endif
