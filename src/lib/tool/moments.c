#include "armtol/loads.h"

#include "armtol/link_transform.h"
#include "lib/report/finite.h"

#include <math.h>

/*
 * Method
 *    From the tool back to the base the force and the moment about the frame's origin are carried along, with the sums
 *    of their magnitudes; each joint sees the part along its axis.
 *
 * Special cases
 *    What is no more than 1e-12 of the magnitudes is 0: rounding would say on which side of its play a drive lies.
 *
 * Accuracy
 *    1e-11 beside central differences of the potential energy, for arms of some metres and kg
 *    (test_moments_are_slopes_of_the_potential_energy); 1e-13 beside m g l cos q (test_one_link_bears_m_g_l_cos_q).
 */
const armtol_loading armtol_loading_standard = {.gravity = {0, 0, -9.80665}};

/* Below this part of what could be a moment is rounding: it would say on which side of its play a drive lies. */
static const double rounding = 1e-12;

typedef struct vector {
    double x, y, z;
} vector;

/* What a frame carries: the sum of forces, their moment about its origin, and the magnitudes of both without signs. */
typedef struct wrench {
    vector force, moment;
    double most_force, most_moment;
} wrench;

static vector sum(vector a, vector b)
{
    return (vector){a.x + b.x, a.y + b.y, a.z + b.z};
}

static vector cross(vector a, vector b)
{
    return (vector){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static double dot(vector a, vector b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static double length(vector a)
{
    return sqrt(dot(a, a));
}

/* A vector of the frame, along the base's axes. */
static vector turned(const armtol_transform *frame, const double v[3])
{
    double out[3];
    for (int i = 0; i < 3; i++) {
        out[i] = frame->m[i][0] * v[0] + frame->m[i][1] * v[1] + frame->m[i][2] * v[2];
    }
    return (vector){out[0], out[1], out[2]};
}

static void add_force(wrench *wrench, vector lever, vector force)
{
    wrench->force = sum(wrench->force, force);
    wrench->moment = sum(wrench->moment, cross(lever, force));
    wrench->most_force += length(force);
    wrench->most_moment += length(lever) * length(force);
}

/* The moment about a point from where the old one is `lever` away. */
static void move_to(wrench *wrench, vector lever)
{
    wrench->moment = sum(wrench->moment, cross(lever, wrench->force));
    wrench->most_moment += length(lever) * wrench->most_force;
}

static vector weight_of(const armtol_mass *mass, const armtol_loading *loading)
{
    const double *g = loading->gravity;
    return (vector){mass->mass * g[0], mass->mass * g[1], mass->mass * g[2]};
}

static wrench at_tool(const armtol_transform *last, const armtol_tool_point *tool, const armtol_mass *payload,
                      const armtol_loading *loading)
{
    const vector lever = turned(last, tool->offset), force = {loading->force[0], loading->force[1], loading->force[2]};
    wrench wrench = {.most_force = 0};
    add_force(&wrench, lever, force);
    if (payload != NULL) {
        add_force(&wrench, sum(lever, turned(last, payload->center)), weight_of(payload, loading));
    }
    return wrench;
}

/* From the frame of a link back to the one before, whose z is the joint's axis. */
static void step_back(armtol_transform *frame, const armtol_link *link, wrench *wrench)
{
    const armtol_transform step = armtol_link_transform(link, &armtol_errata_none);
    armtol_transform before = *frame;
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            before.m[i][k] =
                frame->m[i][0] * step.m[k][0] + frame->m[i][1] * step.m[k][1] + frame->m[i][2] * step.m[k][2];
        }
    }
    *frame = before;
    move_to(wrench, turned(frame, (const double[3]){step.m[0][3], step.m[1][3], step.m[2][3]}));
}

static double seen_by(armtol_joint joint, const armtol_transform *frame, const wrench *wrench)
{
    const vector axis = turned(frame, (const double[3]){0, 0, 1});
    const double value = joint == ARMTOL_REVOLUTE    ? dot(axis, wrench->moment)
                         : joint == ARMTOL_PRISMATIC ? dot(axis, wrench->force)
                                                     : 0;
    const double most = joint == ARMTOL_REVOLUTE ? wrench->most_moment : wrench->most_force;
    return fabs(value) <= rounding * most ? 0 : value;
}

static armtol_status check_mass(const armtol_mass *mass)
{
    if (!isfinite(mass->mass) || !all_finite(mass->center, 3)) {
        return ARMTOL_NOT_FINITE;
    }
    return mass->mass < 0 ? ARMTOL_BAD_LOAD : ARMTOL_OK;
}

static armtol_status check(const armtol_link links[], size_t n_links, const armtol_mass masses[],
                           const armtol_tool_point *tool, const armtol_mass *payload, const armtol_loading *loading)
{
    armtol_status status = armtol_links_check(links, n_links);
    if (status == ARMTOL_OK && !(all_finite(loading->gravity, 3) && all_finite(loading->force, 3) &&
                                 all_finite(tool->offset, 3))) {
        status = ARMTOL_NOT_FINITE;
    }
    for (size_t i = 0; i < n_links && status == ARMTOL_OK && masses != NULL; i++) {
        status = check_mass(&masses[i]);
    }
    return status == ARMTOL_OK && payload != NULL ? check_mass(payload) : status;
}

armtol_status armtol_moments(const armtol_link links[], size_t n_links, const armtol_mass masses[],
                             const armtol_tool_point *tool, const armtol_mass *payload, const armtol_loading *loading,
                             double moments[])
{
    const armtol_status status = check(links, n_links, masses, tool, payload, loading);
    if (status != ARMTOL_OK) {
        return status;
    }
    armtol_transform frame = armtol_chain_transform(links, n_links, &armtol_errata_none);
    wrench wrench = at_tool(&frame, tool, payload, loading);
    for (size_t i = n_links; i-- > 0;) {
        if (masses != NULL) {
            add_force(&wrench, turned(&frame, masses[i].center), weight_of(&masses[i], loading));
        }
        step_back(&frame, &links[i], &wrench);
        moments[i] = seen_by(links[i].joint, &frame, &wrench);
    }
    return all_finite(moments, n_links) ? ARMTOL_OK : ARMTOL_NOT_FINITE;
}
