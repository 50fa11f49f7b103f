#ifndef ARMTOL_AXES_H
#define ARMTOL_AXES_H

#include "armtol/conventions.h"
#include "armtol/link.h"

#include <stddef.h>

/* The axis of a joint, all joints at value 0, in base coordinates. */
typedef struct armtol_axis {
    armtol_joint joint;  /* ARMTOL_REVOLUTE or ARMTOL_PRISMATIC */
    double point[3];     /* on the axis; of a prismatic joint any point, only the direction counts */
    double direction[3]; /* the sense of the joint value; need not be a unit vector */
} armtol_axis;

/* What an arm of n axes has room for: a fixed link before the first joint and one behind the last. */
#define ARMTOL_LINKS_OF_AXES(n) ((n) + 2)

/*
 * The links of an arm given by its axes and by where its tool is with all joints at 0: the chain of *n_links links has
 * the same kinematics. ...
 */
armtol_status armtol_links_of_axes(const armtol_axis axes[], size_t n_axes, const armtol_transform *tool,
                                   armtol_link links[], size_t *n_links);

/*
 * The kind of a link with that joint by its twist angle: parallel where the axes are within a degree of it, else not.
 */
armtol_kind armtol_kind_of(armtol_joint joint, double alpha);

#endif
