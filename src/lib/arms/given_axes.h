#ifndef ARMTOL_LIB_ARMS_GIVEN_AXES_H
#define ARMTOL_LIB_ARMS_GIVEN_AXES_H

#include "armtol/axes.h"
#include "lib/private_names.h"

#include <stdbool.h>

/* Some hundred roundings: an angle, or a share of the arm's size, that is no larger was meant to be 0. */
#define AXES_ROUNDING 1e-13

/* What is given, and what follows from it: note 1 of axes.h. Axis n_axes is the tool's z axis. */
typedef struct given_axes {
    const armtol_axis *axes;
    size_t n_axes;
    const armtol_transform *tool;
    double reach;
    double base_reach; /* with the way to the base's origin */
    double tiny;       /* a length that is no larger is rounding */
} given_axes;

given_axes given_axes_of(const armtol_axis axes[], size_t n_axes, const armtol_transform *tool);

/* An axis as a line. */
typedef struct axis_line {
    double point[3];     /* as it was given; of a slide, what its line is put through */
    double direction[3]; /* of length 1 */
    double place[3];     /* where the arm is; of a slide the point */
} axis_line;

axis_line axis_line_of(const given_axes *given, size_t axis);

/* How far the point that was given is from the axis' place. */
double axis_distance_from_place(const given_axes *given, size_t axis);

/* In the coordinates of a frame. */
axis_line axis_line_seen(const armtol_transform *frame, const axis_line *in_base);

/*
 * Note 2 of axes.h: whether the common perpendicular of z and a line lies near. The line is seen from z's frame; joint
 * is the one about z, axis the line's number.
 */
bool axis_is_crossing(const given_axes *given, armtol_joint joint, size_t axis, const axis_line *line);

/* npp or ppp for a prismatic joint, else npr or ppr; npr where nothing moves. */
armtol_kind axis_kind(armtol_joint joint, bool parallel);

#endif
