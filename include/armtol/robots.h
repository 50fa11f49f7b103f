#ifndef ARMTOL_ROBOTS_H
#define ARMTOL_ROBOTS_H

#include "armtol/craig.h"
#include "armtol/errata.h"
#include "armtol/interface.h"
#include "armtol/link.h"
#include "armtol/status.h"

#include <stddef.h>

ARMTOL_INTERFACE_BEGIN

/* The two arms of 1987. Millimetres and radians. Source of all constants: Hahn 1987, appendix. */

/* How far a wish is from where the arm turns about, and between which distances the arm gets. */
typedef struct armtol_reach {
    double distance;
    double nearest;
    double farthest;
} armtol_reach;

/* An arm with closed inverse kinematics. The routines write as many values as the counts say. */
typedef struct armtol_robot {
    const char *name;
    size_t n_links;
    size_t n_joints;
    size_t n_wish; /* the numbers that say where the tool should be */

    /* The table of links, Paul's order. Errata: short-pi, and those of the arm. */
    void (*links)(const armtol_errata *errata, armtol_link links[]);

    /*
     * Joint values that bring the tool to a wish, as the programs of 1987 chose them.
     *
     * Given:
     *    wish      n_wish numbers
     *    errata    short-pi, float
     *
     * Returned:
     *    q         n_joints values: every `close` of solve is 0, nothing is wrapped
     *    *reach    also where the arm does not get there; as it was where the wish is not finite
     *
     * Errors:
     *    ARMTOL_NOT_FINITE     the wish, or a joint value that overflows
     *    ARMTOL_OUT_OF_REACH
     *    ARMTOL_SINGULAR
     */
    armtol_status (*inverse)(const double wish[], const armtol_errata *errata, double q[],
                             armtol_reach *reach);

    /* Where joint values bring the tool, by the second description (craig.h), in the form of a wish. */
    void (*forward)(const double q[], const armtol_errata *errata, double wish[]);
} armtol_robot;

/*
 * Intelledex 605T: 8 links, 6 joints; wish x, y, z, gamma, beta, alpha (euler.h). Its reach is the distance of
 * the wrist, where the axes of joints 5 and 6 meet, from the shoulder. Singular, and refused: the shoulder within
 * 0.001 mm of the tool's axis, which leaves joint 6 free. Where the axes of joints 3 to 5 are upright joint 1 is
 * free too, but any value of it serves: one is chosen, and the answer is right.
 */
extern const armtol_robot armtol_intelledex_605t;

/*
 * Adept AdeptOne: 6 links, 4 joints; wish x, y, z, theta. Its reach is the distance of the tool from the axis
 * of joint 1. Errata of its table: adept-shift, half-turns.
 */
extern const armtol_robot armtol_adept_one;

ARMTOL_INTERFACE_END

#endif
