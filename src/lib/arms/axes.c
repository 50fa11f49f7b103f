#include "armtol/axes.h"

#include "armtol/link_transform.h"
#include "armtol/transform.h"
#include "lib/pi.h"
#include "lib/report/finite.h"
#include "lib/report/trigonometry.h"

#include <math.h>
#include <stdbool.h>

static const double sine_of_a_degree = 0.017452406437283512819;

/* Some hundred roundings: an angle, or a share of the arm's size, that is no larger was meant to be 0. */
static const double rounding = 1e-13;

/* What is given. Axis n_axes is the tool's z axis. */
typedef struct given {
    const armtol_axis *axes;
    size_t n_axes;
    const armtol_transform *tool;
    double tiny; /* a length that is no larger is rounding */
} given;

typedef struct line {
    double point[3];
    double direction[3]; /* of length 1 */
} line;

/* The links so far. */
typedef struct chain {
    armtol_transform frame; /* the last one, in base coordinates */
    armtol_link *links;     /* NULL where they are only tried */
    size_t n_links;
    bool finite;
} chain;

static armtol_kind kind_of(armtol_joint joint, bool parallel)
{
    if (joint == ARMTOL_PRISMATIC) {
        return parallel ? ARMTOL_PPP : ARMTOL_NPP;
    }
    return parallel && joint == ARMTOL_REVOLUTE ? ARMTOL_PPR : ARMTOL_NPR;
}

armtol_kind armtol_kind_of(armtol_joint joint, double alpha)
{
    return kind_of(joint, fabs(sine_of(&armtol_errata_none, alpha)) <= sine_of_a_degree);
}

/* In (-pi, pi], and a multiple of a quarter turn where it is one but for rounding. */
static double clean_angle(double angle)
{
    const double quarter = PI / 2, nearest = quarter * round(angle / quarter);
    const double clean = fabs(angle - nearest) <= rounding ? nearest : angle;
    if (clean == 0) {
        return 0; /* never -0 */
    }
    return clean <= -PI ? clean + 2 * PI : clean;
}

static double clean_length(const given *given, double length)
{
    return fabs(length) <= given->tiny ? 0 : length;
}

static double largest_of(const double values[3])
{
    return fmax(fabs(values[0]), fmax(fabs(values[1]), fabs(values[2])));
}

/* Divided by its largest component first, so that no square over- or underflows. */
static void set_direction(line *line, const double direction[3])
{
    const double largest = largest_of(direction);
    double squares = 0;
    for (int i = 0; i < 3; i++) {
        line->direction[i] = direction[i] / largest;
        squares += line->direction[i] * line->direction[i];
    }
    for (int i = 0; i < 3; i++) {
        line->direction[i] /= sqrt(squares);
    }
}

/* An axis as a line; that of a prismatic joint goes through the point of the next one that has a place. */
static line line_of(const given *given, size_t axis)
{
    size_t placed = axis;
    while (placed < given->n_axes && given->axes[placed].joint == ARMTOL_PRISMATIC) {
        placed++;
    }
    const bool of_tool = placed == given->n_axes;
    double tool_z[3];
    line line;
    for (int i = 0; i < 3; i++) {
        line.point[i] = of_tool ? given->tool->m[i][3] : given->axes[placed].point[i];
        tool_z[i] = given->tool->m[i][2];
    }
    set_direction(&line, axis == given->n_axes ? tool_z : given->axes[axis].direction);
    return line;
}

/* The line in the coordinates of a frame. */
static line seen_from(const armtol_transform *frame, const line *in_base)
{
    line seen = {{0}, {0}};
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            seen.point[i] += frame->m[k][i] * (in_base->point[k] - frame->m[k][3]);
            seen.direction[i] += frame->m[k][i] * in_base->direction[k];
        }
    }
    return seen;
}

/* From the z axis along the common perpendicular to a line that is not parallel to it. */
static armtol_link across(const given *given, armtol_joint joint, const line *to)
{
    const double *const p = to->point, *const u = to->direction;
    const double sine = length_of(u[0], u[1]);
    const double away = (u[0] * p[1] - u[1] * p[0]) / sine; /* along the cross product of z and u */
    const double foot = -(p[0] * u[0] + p[1] * u[1]) / (sine * sine); /* on the line, counted from p */
    const double a = clean_length(given, fabs(away));
    const double sense = a > 0 && away < 0 ? -1 : 1;
    return (armtol_link){
        .kind = kind_of(joint, false),
        .joint = joint,
        .theta = clean_angle(angle_of(&armtol_errata_none, sense * u[0], -sense * u[1])),
        .d = clean_length(given, p[2] + foot * u[2]),
        .a = a,
        .alpha = clean_angle(angle_of(&armtol_errata_none, sense * sine, u[2])),
    };
}

/* From the z axis to where a (nearly) parallel line pierces the plane z = d, then the tilt to the line. */
static armtol_link along(const given *given, armtol_joint joint, const line *to, double d)
{
    const double *const p = to->point, *const u = to->direction;
    const double x = p[0] + u[0] * (d - p[2]) / u[2], y = p[1] + u[1] * (d - p[2]) / u[2];
    armtol_link link = {.kind = kind_of(joint, true), .joint = joint, .d = clean_length(given, d)};
    link.a = clean_length(given, length_of(x, y));
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
static armtol_link link_to(const given *given, const chain *chain, armtol_joint joint, size_t axis)
{
    const line in_base = line_of(given, axis);
    line to = seen_from(&chain->frame, &in_base);
    if (joint == ARMTOL_PRISMATIC) {
        to.point[0] = to.point[1] = 0; /* the slide's line goes through it, but for rounding */
    }
    if (length_of(to.direction[0], to.direction[1]) > sine_of_a_degree) {
        return across(given, joint, &to);
    }
    armtol_link link = along(given, joint, &to, joint == ARMTOL_PRISMATIC ? to.point[2] : 0);
    if (joint == ARMTOL_FIXED && is_tilted(&link)) {
        link.kind = ARMTOL_PPR;
    }
    return link;
}

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
static armtol_link rest_behind(const given *given, const chain *chain, const armtol_link *link)
{
    const armtol_transform own = armtol_link_transform(link, &armtol_errata_none);
    const armtol_transform behind = armtol_transform_product(&chain->frame, &own, &armtol_errata_none);
    const armtol_transform back = armtol_transform_inverse(&behind, &armtol_errata_none);
    const armtol_transform rest = armtol_transform_product(&back, given->tool, &armtol_errata_none);
    return (armtol_link){
        .kind = ARMTOL_NPR,
        .theta = clean_angle(angle_of(&armtol_errata_none, rest.m[1][0], rest.m[0][0])),
        .d = clean_length(given, rest.m[2][3]),
    };
}

/* The last axis' link, and what it needs to end in the tool's frame. */
static void append_tool(const given *given, chain *chain)
{
    const armtol_joint joint = given->axes[given->n_axes - 1].joint;
    armtol_link link = link_to(given, chain, joint, given->n_axes);
    const armtol_link rest = rest_behind(given, chain, &link);
    if (link.a > 0 || is_tilted(&link)) {
        append(chain, &link);
        append_fixed(chain, &rest);
        return;
    }
    const double sense = link.alpha == 0 ? 1 : -1; /* behind a half turn about x all counts backwards */
    link.kind = joint == ARMTOL_REVOLUTE ? ARMTOL_NPR : ARMTOL_PPP;
    link.theta = clean_angle(sense * rest.theta);
    link.d += sense * rest.d;
    append(chain, &link);
}

static armtol_status build(const given *given, chain *chain)
{
    chain->frame = armtol_transform_identity();
    chain->n_links = 0;
    chain->finite = true;
    const armtol_link base = link_to(given, chain, ARMTOL_FIXED, 0);
    append_fixed(chain, &base);
    for (size_t i = 0; i + 1 < given->n_axes; i++) {
        const armtol_link link = link_to(given, chain, given->axes[i].joint, i + 1);
        append(chain, &link);
    }
    append_tool(given, chain);
    return chain->finite ? ARMTOL_OK : ARMTOL_NOT_FINITE;
}

static armtol_status check_axis(const armtol_axis *axis)
{
    if (!all_finite(axis->point, 3) || !all_finite(axis->direction, 3)) {
        return ARMTOL_NOT_FINITE;
    }
    const bool moves = axis->joint == ARMTOL_REVOLUTE || axis->joint == ARMTOL_PRISMATIC;
    return moves && largest_of(axis->direction) > 0 ? ARMTOL_OK : ARMTOL_BAD_AXIS;
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

/* The largest coordinate of what has a place. */
static double size_of(const armtol_axis axes[], size_t n_axes, const armtol_transform *tool)
{
    double size = largest_of((double[]){tool->m[0][3], tool->m[1][3], tool->m[2][3]});
    for (size_t i = 0; i < n_axes; i++) {
        if (axes[i].joint == ARMTOL_REVOLUTE) {
            size = fmax(size, largest_of(axes[i].point));
        }
    }
    return size;
}

armtol_status armtol_links_of_axes(const armtol_axis axes[], size_t n_axes, const armtol_transform *tool,
                                   armtol_link links[], size_t *n_links)
{
    armtol_status status = check(axes, n_axes, tool);
    if (status != ARMTOL_OK) {
        return status;
    }
    const given given = {axes, n_axes, tool, rounding * size_of(axes, n_axes, tool)};
    /* Once without writing, as links is to stay as it was where one of them overflows. */
    chain chain = {.links = NULL};
    status = build(&given, &chain);
    if (status == ARMTOL_OK) {
        chain.links = links;
        build(&given, &chain);
        *n_links = chain.n_links;
    }
    return status;
}
