#include "armtol/axes.h"

#include "armtol/link_transform.h"
#include "armtol/transform.h"
#include "lib/arms/given_axes.h"
#include "lib/pi.h"
#include "lib/report/finite.h"
#include "lib/report/trigonometry.h"

#include <math.h>
#include <stdbool.h>

/*
 * Method
 *    The chain is built link by link: each axis is seen from the last frame, as a line with the point that was given
 *    and the place where the arm is (given_axes.h), and the notes of axes.h say how the link goes there.
 *
 * Special cases
 *    Parallel, coaxial and meeting axes, slides, a base or tool that needs no link: axes.h. What is within snap of one
 *    of them is made exact and noted.
 *
 * Accuracy
 *    Placed at any joint values the links bring the tool where the axes do, to 1e-9 for arms of some hundred lengths
 *    (test_links_of_revolute_axes_move_as_the_axes_do, and those of mixed and prismatic ones).
 */

/* The links so far, and what was taken for exact. The arrays are NULL where links are only tried. */
typedef struct chain {
    const given_axes *given;
    double snap;            /* an angle that is no larger was meant to be 0, */
    double near;            /* and so was a distance of axes */
    armtol_transform frame; /* the last one, in base coordinates */
    armtol_link *links;
    size_t n_links;
    armtol_snapped *snapped;
    size_t n_snapped;
    bool finite;
} chain;

/* In (-pi, pi], and a multiple of a quarter turn where it is one but for rounding. */
static double clean_angle(double angle)
{
    const double quarter = PI / 2, nearest = quarter * round(angle / quarter);
    const double clean = fabs(angle - nearest) <= AXES_ROUNDING ? nearest : angle;
    if (clean == 0) {
        return 0; /* never -0 */
    }
    return clean <= -PI ? clean + 2 * PI : clean;
}

static double clean_length(const chain *chain, double length)
{
    return fabs(length) <= chain->given->tiny ? 0 : length;
}

/* ---- what counts as exact ---- */

const char *armtol_relation_text(armtol_relation relation)
{
    static const char *const texts[ARMTOL_RELATION_COUNT] = {
        [ARMTOL_PARALLEL] = "are parallel",
        [ARMTOL_COINCIDENT] = "coincide",
        [ARMTOL_MEETING] = "meet",
        [ARMTOL_SAME_FRAME] = "have one frame",
    };
    const size_t index = (size_t)relation;
    return index < ARMTOL_RELATION_COUNT ? texts[index] : "?";
}

/* Written down where more than rounding was set to 0. */
static void note(chain *chain, size_t axis, armtol_relation relation, double angle, double distance)
{
    if (angle <= AXES_ROUNDING && distance <= chain->given->tiny) {
        return;
    }
    if (chain->snapped != NULL) {
        chain->snapped[chain->n_snapped] = (armtol_snapped){axis, relation, angle, distance};
    }
    chain->n_snapped++;
}

static bool is_parallel(const chain *chain, const axis_line *to)
{
    return length_of(to->direction[0], to->direction[1]) <= chain->snap;
}

/* A nearly parallel line made parallel to z at its place, and z itself where it is as near. */
static void make_parallel(chain *chain, size_t axis, axis_line *to)
{
    const double angle = length_of(to->direction[0], to->direction[1]);
    double distance = length_of(to->place[0], to->place[1]);
    const bool coincide = distance <= chain->near;
    note(chain, axis, coincide ? ARMTOL_COINCIDENT : ARMTOL_PARALLEL, angle, coincide ? distance : 0);
    for (int i = 0; i < 2; i++) {
        to->point[i] = coincide ? 0 : to->place[i];
        to->direction[i] = 0;
    }
    to->direction[2] = to->direction[2] < 0 ? -1 : 1;
}

/* The distance of axes that cross, 0 where they are meant to meet. */
static double clean_distance(chain *chain, size_t axis, double distance)
{
    if (distance > chain->near) {
        return distance;
    }
    note(chain, axis, ARMTOL_MEETING, 0, distance);
    return 0;
}

/* ---- one link ---- */

/* From the z axis along the common perpendicular to a line that is not parallel to it. */
static armtol_link across(chain *chain, armtol_joint joint, size_t axis, const axis_line *to)
{
    const double *const p = to->point, *const u = to->direction;
    const double sine = length_of(u[0], u[1]);
    const double away = (u[0] * p[1] - u[1] * p[0]) / sine; /* along the cross product of z and u */
    const double foot = -(p[0] * u[0] + p[1] * u[1]) / (sine * sine); /* on the line, counted from p */
    const double a = clean_distance(chain, axis, fabs(away));
    const double sense = a > 0 && away < 0 ? -1 : 1;
    return (armtol_link){
        .kind = axis_kind(joint, false),
        .joint = joint,
        .theta = clean_angle(angle_of(&armtol_errata_none, sense * u[0], -sense * u[1])),
        .d = clean_length(chain, p[2] + foot * u[2]),
        .a = a,
        .alpha = clean_angle(angle_of(&armtol_errata_none, sense * sine, u[2])),
    };
}

/* From the z axis to where a (nearly) parallel line pierces the plane z = d, then the tilt to the line. */
static armtol_link along(chain *chain, armtol_joint joint, size_t axis, const axis_line *to)
{
    const double *const p = to->point, *const u = to->direction;
    const double d = joint == ARMTOL_PRISMATIC ? p[2] : 0;
    const double x = p[0] + u[0] * (d - p[2]) / u[2], y = p[1] + u[1] * (d - p[2]) / u[2];
    armtol_link link = {.kind = axis_kind(joint, true), .joint = joint, .d = clean_length(chain, d)};
    link.a = clean_distance(chain, axis, length_of(x, y));
    link.theta = link.a > 0 ? clean_angle(angle_of(&armtol_errata_none, y, x)) : 0;
    const double c = cosine_of(&armtol_errata_none, link.theta), s = sine_of(&armtol_errata_none, link.theta);
    link.beta = clean_angle(arc_sine_of(&armtol_errata_none, c * u[0] + s * u[1]));
    link.alpha = clean_angle(angle_of(&armtol_errata_none, s * u[0] - c * u[1], u[2]));
    return link;
}

static bool is_tilted(const armtol_link *link)
{
    return link->beta != 0 || (link->alpha != 0 && link->alpha != PI);
}

/* The link from the chain's last frame to an axis. */
static armtol_link link_to(chain *chain, armtol_joint joint, size_t axis)
{
    const axis_line in_base = axis_line_of(chain->given, axis);
    axis_line to = axis_line_seen(&chain->frame, &in_base);
    if (joint == ARMTOL_PRISMATIC) { /* the slide's line goes through it, but for rounding */
        to.point[0] = to.point[1] = to.place[0] = to.place[1] = 0;
    }
    if (is_parallel(chain, &to)) {
        make_parallel(chain, axis, &to);
    } else if (axis_is_crossing(chain->given, joint, axis, &to)) {
        return across(chain, joint, axis, &to);
    }
    return along(chain, joint, axis, &to);
}

/* ---- the chain ---- */

static bool is_identity(const armtol_link *link)
{
    return link->theta == 0 && link->d == 0 && link->a == 0 && link->alpha == 0 && link->beta == 0;
}

static void append(chain *chain, const armtol_link *link)
{
    const armtol_transform transform = armtol_link_transform(link, &armtol_errata_none);
    chain->frame = armtol_transform_product(&chain->frame, &transform, &armtol_errata_none);
    chain->finite = chain->finite && armtol_links_check(link, 1) == ARMTOL_OK;
    if (chain->links != NULL) {
        chain->links[chain->n_links] = *link;
    }
    chain->n_links++;
}

/* A fixed link, left out where it does nothing. */
static void append_fixed(chain *chain, const armtol_link *link)
{
    if (!is_identity(link)) {
        append(chain, link);
    }
}

/* What is left between the frame behind a link, which shares the tool's z axis, and the tool. */
static armtol_link rest_behind(const chain *chain, const armtol_link *link)
{
    const armtol_transform own = armtol_link_transform(link, &armtol_errata_none);
    const armtol_transform behind = armtol_transform_product(&chain->frame, &own, &armtol_errata_none);
    const armtol_transform back = armtol_transform_inverse(&behind, &armtol_errata_none);
    const armtol_transform rest = armtol_transform_product(&back, chain->given->tool, &armtol_errata_none);
    return (armtol_link){
        .kind = ARMTOL_NPR,
        .theta = clean_angle(angle_of(&armtol_errata_none, rest.m[1][0], rest.m[0][0])),
        .d = clean_length(chain, rest.m[2][3]),
    };
}

/* Nothing is left where the frame behind the link is meant to be the tool's. */
static void clean_rest(chain *chain, armtol_link *rest)
{
    const double angle = fabs(rest->theta), length = fabs(rest->d);
    if (angle <= chain->snap && length <= chain->near) {
        note(chain, chain->given->n_axes, ARMTOL_SAME_FRAME, angle, length);
        rest->theta = rest->d = 0;
    }
}

/* The last axis' link, and what it needs to end in the tool's frame. */
static void append_tool(chain *chain)
{
    const given_axes *const given = chain->given;
    const armtol_joint joint = given->axes[given->n_axes - 1].joint;
    armtol_link link = link_to(chain, joint, given->n_axes);
    armtol_link rest = rest_behind(chain, &link);
    if (link.a > 0 || is_tilted(&link)) {
        clean_rest(chain, &rest);
        append(chain, &link);
        append_fixed(chain, &rest);
        return;
    }
    const double sense = link.alpha == 0 ? 1 : -1; /* behind a half turn about x all counts backwards */
    link.kind = axis_kind(joint, joint == ARMTOL_PRISMATIC);
    link.theta = clean_angle(sense * rest.theta);
    link.d += sense * rest.d;
    append(chain, &link);
}

static armtol_status build(chain *chain)
{
    const given_axes *const given = chain->given;
    chain->frame = armtol_transform_identity();
    chain->n_links = chain->n_snapped = 0;
    chain->finite = true;
    const armtol_link base = link_to(chain, ARMTOL_FIXED, 0);
    append_fixed(chain, &base);
    for (size_t i = 0; i + 1 < given->n_axes; i++) {
        const armtol_link link = link_to(chain, given->axes[i].joint, i + 1);
        append(chain, &link);
    }
    append_tool(chain);
    return chain->finite ? ARMTOL_OK : ARMTOL_NOT_FINITE;
}

/* ---- what is given ---- */

static bool has_length(const double v[3])
{
    return v[0] != 0 || v[1] != 0 || v[2] != 0;
}

static armtol_status check_axis(const armtol_axis *axis)
{
    if (!all_finite(axis->point, 3) || !all_finite(axis->direction, 3)) {
        return ARMTOL_NOT_FINITE;
    }
    const bool moves = axis->joint == ARMTOL_REVOLUTE || axis->joint == ARMTOL_PRISMATIC;
    return moves && has_length(axis->direction) ? ARMTOL_OK : ARMTOL_BAD_AXIS;
}

static armtol_status check(const armtol_axis axes[], size_t n_axes, const armtol_transform *tool)
{
    armtol_status status = n_axes > 0 ? ARMTOL_OK : ARMTOL_WRONG_SIZE;
    for (size_t i = 0; i < n_axes && status == ARMTOL_OK; i++) {
        status = check_axis(&axes[i]);
    }
    for (int i = 0; i < 4 && status == ARMTOL_OK; i++) {
        status = all_finite(tool->m[i], 4) ? ARMTOL_OK : ARMTOL_NOT_FINITE;
    }
    return status;
}

armtol_status armtol_links_of_axes(const armtol_axis axes[], size_t n_axes, const armtol_transform *tool, double snap,
                                   armtol_link links[], size_t *n_links, armtol_snapped snapped[], size_t *n_snapped)
{
    armtol_status status = check(axes, n_axes, tool);
    if (status != ARMTOL_OK) {
        return status;
    }
    const given_axes given = given_axes_of(axes, n_axes, tool);
    if (!isfinite(given.base_reach)) {
        return ARMTOL_NOT_FINITE;
    }
    const double share = fmin(fmax(snap, AXES_ROUNDING), ARMTOL_MOST_SNAP);
    const double size = given.reach > 1e-3 * given.base_reach ? given.reach : given.base_reach;
    chain chain = {.given = &given, .snap = share, .near = fmax(share * size, given.tiny)};
    /* Once without writing, as links is to stay as it was where one of them overflows. */
    status = build(&chain);
    if (status == ARMTOL_OK) {
        chain.links = links;
        chain.snapped = snapped;
        build(&chain);
        *n_links = chain.n_links;
        *n_snapped = chain.n_snapped;
    }
    return status;
}
