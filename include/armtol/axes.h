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

/* The largest snap, and one that takes numbers of six digits for what they were meant to be. */
#define ARMTOL_MOST_SNAP 0.01
#define ARMTOL_USUAL_SNAP 1e-5

/* What two axes are taken for. */
typedef enum armtol_relation {
    ARMTOL_PARALLEL,
    ARMTOL_COINCIDENT,
    ARMTOL_MEETING,
    ARMTOL_SAME_FRAME, /* what is left between the last link's frame and the tool's is nothing */
    ARMTOL_RELATION_COUNT
} armtol_relation;

/* Something that is so only nearly, and was taken for exact. */
typedef struct armtol_snapped {
    size_t axis; /* from 0, with the one before it; 0: with the base's z axis; n_axes: the tool's with the last */
    armtol_relation relation;
    double angle;    /* by which it is off, and */
    double distance; /* likewise */
} armtol_snapped;

/* "are parallel" and so on; "?" for a value that is none. */
const char *armtol_relation_text(armtol_relation relation);

/*
 * The links of an arm that is given by its axes and its tool.
 *
 * Given:
 *    axes, n_axes           in the order of the joints
 *    tool                   where the tool is with all joints at 0: a rigid motion, which is not checked
 *    snap                   what is taken for exact, note 4: 0 to ARMTOL_MOST_SNAP
 *
 * Returned:
 *    links, *n_links        ARMTOL_LINKS_OF_AXES(n_axes) places. The chain has the same kinematics: placed at any joint
 *                           values it brings the tool where turning about, and sliding along, the axes does. The links
 *                           that move come in the order of the axes, and their joint values are those of the axes.
 *    snapped, *n_snapped    what was taken for exact and was off by more than rounding; as many places, or NULL
 *
 * Notes:
 * 1) Reach. The place of an axis is its point nearest to the place of the next revolute one, the last one's the point
 *    nearest to the tool's origin. The reach is the length of the way from the tool through all places to axis 1; for
 *    the link before axis 1 the way from there to the base's origin is added. Neither depends on where on its axis a
 *    point was given.
 * 2) Near. Two axes at an angle, a distance D apart where the arm is (from the one to the other's place), have their
 *    common perpendicular at most D / tan(angle) from there, the more the less the tilt is about the line between them.
 *    It counts as near where that is at most the reach: the direction of the tilt does not decide. Beyond 45 degrees it
 *    always is. What could be tilted either way and has no D to show it - coaxial joints, and a slide, whose place is
 *    free - is not near below a tangent of 0.1.
 * 3) The frames, by rules that leave no choice to rounding:
 *   near         The link goes along the common perpendicular where that lies near the arm (note 2): theta and
 *                d to it, a >= 0 its length; axes that meet have a = 0 and x along the cross product of the
 *                two. beta = 0. npr, npp. This is the way of Denavit and Hartenberg, in Paul's order.
 *   far          The next origin is where the next axis pierces the plane z = 0 of the frame before: theta to
 *                it, a its distance (both 0 on the axis itself), d = 0; then alpha and beta tilt z to the next
 *                axis: 0 or pi, and 0, for exactly parallel ones. ppr, ppp. The common perpendicular of such
 *                axes is anywhere, or far off, and moves by much when an axis tilts a little; small errors of
 *                theta, d, a and alpha do not describe that. With Hayati's beta in place of d they do (1983).
 *   prismatic    Only the direction of such an axis is a fact. Its line is put through the given point of the
 *                next revolute axis, or through the tool's origin where none follows; the next origin is
 *                there, d goes to it, a = 0 (and theta = 0 where parallel). So no length stands where the
 *                kind, npp, counts none.
 *   before       A fixed link from the base's z axis to axis 1, by the same rules; left out where that is the
 *   axis 1       identity, as for an axis 1 on the base's z axis: theta and d of joint 1 do there. It is npr,
 *                as in the tables of Hahn 1987, also for lines that are (nearly) parallel.
 *   behind       Link n goes to the tool's z axis by the same rules, and a fixed npr link, theta and d, from
 *   axis n       there to the tool's frame; left out where that is the identity. Where the tool's z axis is
 *                axis n itself, theta and d go into link n. A revolute link n is then npr: ppr counts no error
 *                of d, the length of the tool.
 * 4) Snap says what is taken for exact, as an angle and as a share of the reach (with the way to the base where it is a
 *    thousand times as long: a tool on the only axis); at most ARMTOL_MOST_SNAP. Axes within that angle are parallel,
 *    and at their places as far apart as before; parallel ones within that distance are one axis; others within it
 *    meet; a rest behind link n within both is none. *n_snapped of these were more than rounding and stand in snapped.
 *    Each changes where the tool gets by no more than twice its angle times the reach, a slide's travel included, and
 *    twice its distance.
 * 5) With snap = 0 rounding alone is taken away, as always: angles are in (-pi, pi], one that differs from a multiple
 *    of pi/2 by no more than 1e-13 is set to it, and a length to 0 that is no more than 1e-13 of the largest coordinate
 *    of the tool and the points that count.
 *
 * Errors:
 *    ARMTOL_WRONG_SIZE    no axes
 *    ARMTOL_BAD_AXIS      a joint that does not move, or a direction of length 0
 *    ARMTOL_NOT_FINITE    something given is not, or a link overflows
 *
 * Reference:
 *    Denavit and Hartenberg's way in Paul's order; Hayati 1983 for (nearly) parallel axes. What is near is ours.
 */
armtol_status armtol_links_of_axes(const armtol_axis axes[], size_t n_axes, const armtol_transform *tool, double snap,
                                   armtol_link links[], size_t *n_links, armtol_snapped snapped[], size_t *n_snapped);

/*
 * The other way round: the axes of a table's joints, and the tool, all joints at 0.
 *
 * Given:
 *    links, n_links   the table
 *
 * Returned:
 *    axes, *n_axes    in base coordinates, each with the origin of its link's frame as its point; a place for each
 *    joint *tool            the last frame
 *
 * Errors:
 *    those of armtol_links_check
 *    ARMTOL_NOT_FINITE   where a frame overflows; what is returned is then of no use
 */
armtol_status armtol_axes_of_links(const armtol_link links[], size_t n_links, armtol_axis axes[], size_t *n_axes,
                                   armtol_transform *tool);

/* How far the points of revolute axes are from their places, at most, and the reach with the way to the base. */
typedef struct armtol_spread {
    double farthest;
    double reach;
} armtol_spread;

/*
 * The spread of axes that armtol_links_of_axes takes. Frames that it lays keep to twice the reach, whatever they were.
 */
armtol_spread armtol_spread_of_axes(const armtol_axis axes[], size_t n_axes, const armtol_transform *tool);

/*
 * The kinds that a table's rows have by their joints and axes.
 *
 * Given:
 *    links, n_links   the table; its kinds are not used, but have to be some
 *
 * Returned:
 *    rows             n_links places, for the work
 *    kinds            n_links
 *
 * Notes:
 * 1) A row's z axis and the next one's are taken for its axes: by note 2 of armtol_links_of_axes, and a row with a beta
 *    is ppr or ppp. A fixed link is npr, as in the tables of Hahn 1987.
 * 2) So is the link of the last joint where that is revolute, for its d is then the length of the tool; but not one
 *    with an a and no d.
 *
 * Errors:
 *    those of armtol_links_check
 *    ARMTOL_NOT_FINITE   where a frame overflows
 */
armtol_status armtol_kinds_of_links(const armtol_link links[], size_t n_links, armtol_axis rows[], armtol_kind kinds[]);

ARMTOL_INTERFACE_END

#endif
