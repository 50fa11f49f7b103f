#include "lib/arms/given_axes.h"

#include "lib/report/trigonometry.h"

#include <math.h>
#include <string.h>

static double largest_of(const double values[3])
{
    return fmax(fabs(values[0]), fmax(fabs(values[1]), fabs(values[2])));
}

/* Divided by its largest component first, so that no square over- or underflows. */
static void set_unit(const double direction[3], double unit[3])
{
    const double largest = largest_of(direction);
    double squares = 0;
    for (int i = 0; i < 3; i++) {
        unit[i] = direction[i] / largest;
        squares += unit[i] * unit[i];
    }
    for (int i = 0; i < 3; i++) {
        unit[i] /= sqrt(squares);
    }
}

/* ---- places ---- */

/* Move a place to the point of an axis that is nearest to it. Returns how far that is. */
static double approach(const armtol_axis *axis, double place[3])
{
    double unit[3], along = 0, way[3];
    set_unit(axis->direction, unit);
    for (int i = 0; i < 3; i++) {
        along += unit[i] * (place[i] - axis->point[i]);
    }
    for (int i = 0; i < 3; i++) {
        const double nearest = axis->point[i] + along * unit[i];
        way[i] = nearest - place[i];
        place[i] = nearest;
    }
    return length_of_vector(way);
}

/* The place of an axis; returns the way from there to the tool. */
static double find_place(const given_axes *given, size_t axis, double place[3])
{
    double way = 0;
    for (int i = 0; i < 3; i++) {
        place[i] = given->tool->m[i][3];
    }
    for (size_t i = given->n_axes; i-- > axis;) {
        if (given->axes[i].joint != ARMTOL_PRISMATIC) {
            way += approach(&given->axes[i], place);
        }
    }
    return way;
}

/* The largest coordinate of what has a place. */
static double size_of(const given_axes *given)
{
    const armtol_transform *const tool = given->tool;
    double size = largest_of((double[]){tool->m[0][3], tool->m[1][3], tool->m[2][3]});
    for (size_t i = 0; i < given->n_axes; i++) {
        if (given->axes[i].joint == ARMTOL_REVOLUTE) {
            size = fmax(size, largest_of(given->axes[i].point));
        }
    }
    return size;
}

given_axes given_axes_of(const armtol_axis axes[], size_t n_axes, const armtol_transform *tool)
{
    given_axes given = {.axes = axes, .n_axes = n_axes, .tool = tool};
    double first[3];
    given.reach = find_place(&given, 0, first);
    given.base_reach = given.reach + length_of_vector(first);
    given.tiny = AXES_ROUNDING * size_of(&given);
    return given;
}

/* ---- lines ---- */

static double distance_of(const double v[3], const double w[3])
{
    return length_of_vector((const double[]){v[0] - w[0], v[1] - w[1], v[2] - w[2]});
}

double axis_distance_from_place(const given_axes *given, size_t axis)
{
    double place[3];
    find_place(given, axis, place);
    return distance_of(given->axes[axis].point, place);
}

/* The point that was given, but for one that is so far off that digits would be lost to it. */
static void set_point(const given_axes *given, size_t placed, axis_line *line)
{
    for (int i = 0; i < 3; i++) {
        line->point[i] = placed < given->n_axes ? given->axes[placed].point[i] : given->tool->m[i][3];
    }
    if (distance_of(line->point, line->place) > 2 * given->base_reach) {
        memcpy(line->point, line->place, sizeof line->point);
    }
}

axis_line axis_line_of(const given_axes *given, size_t axis)
{
    size_t placed = axis;
    while (placed < given->n_axes && given->axes[placed].joint == ARMTOL_PRISMATIC) {
        placed++;
    }
    axis_line line;
    find_place(given, axis, line.place);
    set_point(given, placed, &line);
    if (placed > axis) {
        memcpy(line.place, line.point, sizeof line.place);
    }
    const armtol_transform *const tool = given->tool;
    const double tool_z[3] = {tool->m[0][2], tool->m[1][2], tool->m[2][2]};
    set_unit(axis == given->n_axes ? tool_z : given->axes[axis].direction, line.direction);
    return line;
}

axis_line axis_line_seen(const armtol_transform *frame, const axis_line *in_base)
{
    axis_line seen = {{0}, {0}, {0}};
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            seen.point[i] += frame->m[k][i] * (in_base->point[k] - frame->m[k][3]);
            seen.direction[i] += frame->m[k][i] * in_base->direction[k];
            seen.place[i] += frame->m[k][i] * (in_base->place[k] - frame->m[k][3]);
        }
    }
    return seen;
}

/* ---- kinds ---- */

bool axis_is_crossing(const given_axes *given, armtol_joint joint, size_t axis, const axis_line *line)
{
    static const double digits = 1.001; /* so that no natural number's last digit, as that of 45 degrees, decides */
    static const double least = 0.1;
    const double sine = length_of(line->direction[0], line->direction[1]), cosine = fabs(line->direction[2]);
    const double distance = length_of(line->place[0], line->place[1]);
    const double reach = joint == ARMTOL_FIXED ? given->base_reach : given->reach;
    if (digits * sine >= cosine) {
        return true;
    }
    if (joint == ARMTOL_PRISMATIC || (joint == ARMTOL_REVOLUTE && axis < given->n_axes)) {
        return sine >= least * cosine && distance * cosine <= digits * reach * sine;
    }
    return distance <= given->tiny || distance * cosine <= digits * reach * sine;
}

armtol_kind axis_kind(armtol_joint joint, bool parallel)
{
    if (joint == ARMTOL_PRISMATIC) {
        return parallel ? ARMTOL_PPP : ARMTOL_NPP;
    }
    return parallel && joint == ARMTOL_REVOLUTE ? ARMTOL_PPR : ARMTOL_NPR;
}
