#ifndef ARMTOL_LOADS_H
#define ARMTOL_LOADS_H

#include "armtol/interface.h"
#include "armtol/link.h"
#include "armtol/tool_point.h"

#include <stddef.h>

ARMTOL_INTERFACE_BEGIN

/*
 * A mass in kg and where its center is, in the arm's unit of length. Of a link: in the frame at the end of the link's
 * transform, Eq. (4.2), which moves with it. Of what the tool holds: from the tool point, along the axes of the last
 * frame.
 */
typedef struct armtol_mass {
    double mass;
    double center[3];
} armtol_mass;

/* What loads an arm beside its own mass. */
typedef struct armtol_loading {
    double gravity[3];  /* m/s^2, along the base's axes: where a mass falls */
    double force[3];    /* N, at the tool point, along the base's axes */
    double compensated; /* the share of what compliance gives way by that a controller takes back, 0 to 1 */
    size_t n_payloads;  /* load cases; 0: one, and nothing held */
    const armtol_mass *payloads;
} armtol_loading;

/* 9.80665 m/s^2 towards the base's -z; nothing held, no force, nothing compensated. */
extern const armtol_loading armtol_loading_standard;

/*
 * What turns, or pushes, every joint: the moment of all that its link carries about its axis, in its positive sense.
 *
 * Given:
 *    links, n_links   the arm, placed
 *    masses           n_links, the links' own; NULL: none
 *    tool             the tool point; its frame is not looked at
 *    payload          what the tool holds; NULL: nothing
 *    loading          gravity and force; the rest is not looked at
 *
 * Returned:
 *    moments          n_links: the moment of a revolute joint in N times the links' unit of length, the force along a
 *                     prismatic one in N, 0 of a fixed link. What is no more than 1e-12 of what could be, were every
 *                     lever at a right angle, is what rounding leaves of 0, and is 0.
 *
 * Errors:
 *    those of armtol_links_check
 *    ARMTOL_BAD_LOAD     a mass is negative
 *    ARMTOL_NOT_FINITE   something given is not, or a moment overflows; moments are then of no use
 *
 * Reference:
 *    Hahn 1987, section 4.2: l x m of Eq. (4.20), the mass of links i to n and of what is held; its component along the
 *    joint's axis z is z . sum (p_j - o) x m_j g + z . (p - o) x f, and of a slide z . (sum m_j g + f).
 */
armtol_status armtol_moments(const armtol_link links[], size_t n_links, const armtol_mass masses[],
                             const armtol_tool_point *tool, const armtol_mass *payload, const armtol_loading *loading,
                             double moments[]);

ARMTOL_INTERFACE_END

#endif
