#include "lib/region/where.h"

#include "lib/report/trigonometry.h"

#include <math.h>

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void unit_of(const double v[3], double made[3])
{
    const double size = length_of_vector(v);
    for (int i = 0; i < 3; i++) {
        made[i] = v[i] / size;
    }
}

static void between(const double from[3], const double to[3], double made[3])
{
    for (int i = 0; i < 3; i++) {
        made[i] = to[i] - from[i];
    }
}

bool where_asks(const armtol_region *region)
{
    return region->block != NULL || region->ring != NULL || region->path != NULL || region->cone != NULL;
}

/* ---- a pose ---- */

/* How far along the ring's axis, of length 1, and the way out from it, which is that long. */
static double along_ring(const armtol_ring *ring, const double axis[3], const double point[3], double out[3])
{
    double from[3];
    between(ring->point, point, from);
    const double along = dot(axis, from);
    for (int i = 0; i < 3; i++) {
        out[i] = from[i] - along * axis[i];
    }
    return along;
}

static void nearest_of_piece(const double from[3], const double to[3], const double point[3], double nearest[3])
{
    double along[3], away[3];
    between(from, to, along);
    between(from, point, away);
    const double square = dot(along, along), share = square > 0 ? fmax(0, fmin(1, dot(along, away) / square)) : 0;
    for (int i = 0; i < 3; i++) {
        nearest[i] = from[i] + share * along[i];
    }
}

/* The nearest point of the path's line, and how far it is. */
static double nearest_of_path(const armtol_path *path, const double point[3], double nearest[3])
{
    double least = (double)INFINITY;
    for (size_t i = 0; i < path->n_points; i++) {
        double found[3], away[3];
        const double *to = path->points + 3 * (i + 1 < path->n_points ? i + 1 : i);
        nearest_of_piece(path->points + 3 * i, to, point, found);
        between(found, point, away);
        const double distance = length_of_vector(away);
        if (distance < least) {
            least = distance;
            for (int k = 0; k < 3; k++) {
                nearest[k] = found[k];
            }
        }
    }
    return least;
}

static bool in_block(const armtol_block *block, const double point[3], double slack)
{
    bool in = true;
    for (int i = 0; i < 3; i++) {
        in = in && point[i] >= block->low[i] - slack && point[i] <= block->high[i] + slack;
    }
    return in;
}

static bool in_ring(const armtol_ring *ring, const double point[3], double slack)
{
    double axis[3], out[3];
    unit_of(ring->axis, axis);
    const double along = along_ring(ring, axis, point, out), away = length_of_vector(out);
    return along >= ring->bottom - slack && along <= ring->top + slack && away >= ring->inner - slack &&
           away <= ring->outer + slack;
}

/* The arc cosine would lose half of the digits of a small angle. */
static double angle_from(const armtol_cone *cone, const double tool[3])
{
    double direction[3], across[3];
    unit_of(cone->direction, direction);
    const double along = dot(direction, tool);
    for (int i = 0; i < 3; i++) {
        across[i] = tool[i] - along * direction[i];
    }
    return angle_of(&armtol_errata_none, length_of_vector(across), along);
}

bool where_holds(const armtol_region *region, const double point[3], const double tool[3], double slack)
{
    double nearest[3];
    return (region->block == NULL || in_block(region->block, point, slack)) &&
           (region->ring == NULL || in_ring(region->ring, point, slack)) &&
           (region->path == NULL || nearest_of_path(region->path, point, nearest) <= region->path->radius + slack) &&
           (region->cone == NULL || angle_from(region->cone, tool) <= region->cone->angle + 1e-9);
}

/* ---- a box ---- */

/* From where to where the points are along a direction. */
static void range_along(const vectors *points, size_t count, const double direction[3], double *low, double *high)
{
    *low = (double)INFINITY;
    *high = -(double)INFINITY;
    for (size_t i = 0; i < count; i++) {
        const double at = points->x[i] * direction[0] + points->y[i] * direction[1] + points->z[i] * direction[2];
        *low = at < *low ? at : *low;
        *high = at > *high ? at : *high;
    }
}

static void middle_of(const vectors *points, size_t count, double middle[3])
{
    middle[0] = middle[1] = middle[2] = 0;
    for (size_t i = 0; i < count; i++) {
        middle[0] += points->x[i] / (double)count;
        middle[1] += points->y[i] / (double)count;
        middle[2] += points->z[i] / (double)count;
    }
}

static bool outside_block(const armtol_block *block, const vectors *points, size_t count, double outward)
{
    for (int i = 0; i < 3; i++) {
        double direction[3] = {0, 0, 0}, low, high;
        direction[i] = 1;
        range_along(points, count, direction, &low, &high);
        if (low - outward > block->high[i] || high + outward < block->low[i]) {
            return true;
        }
    }
    return false;
}

/* The distance from an axis is convex: no point of the hull is further than the furthest corner. */
static double furthest_from_axis(const armtol_ring *ring, const double axis[3], const vectors *points, size_t count)
{
    double furthest = 0;
    for (size_t i = 0; i < count; i++) {
        double out[3];
        along_ring(ring, axis, (const double[3]){points->x[i], points->y[i], points->z[i]}, out);
        furthest = fmax(furthest, length_of_vector(out));
    }
    return furthest;
}

/* Beyond the plane that touches the outer cylinder on the side of the middle. */
static bool beyond_ring(const armtol_ring *ring, const double axis[3], const vectors *points, size_t count,
                        double outward)
{
    double middle[3], out[3], low, high;
    middle_of(points, count, middle);
    along_ring(ring, axis, middle, out);
    if (!(length_of_vector(out) > 0)) {
        return false;
    }
    unit_of(out, out);
    range_along(points, count, out, &low, &high);
    return low - dot(out, ring->point) - outward > ring->outer;
}

static bool outside_ring(const armtol_ring *ring, const vectors *points, size_t count, double outward)
{
    double axis[3], low, high;
    unit_of(ring->axis, axis);
    range_along(points, count, axis, &low, &high);
    const double foot = dot(axis, ring->point);
    return low - foot - outward > ring->top || high - foot + outward < ring->bottom ||
           furthest_from_axis(ring, axis, points, count) + outward < ring->inner ||
           beyond_ring(ring, axis, points, count, outward);
}

/* The hull is in a ball about its middle. */
static bool outside_path(const armtol_path *path, const vectors *points, size_t count, double outward)
{
    double middle[3], nearest[3], furthest = 0;
    middle_of(points, count, middle);
    for (size_t i = 0; i < count; i++) {
        const double away[3] = {points->x[i] - middle[0], points->y[i] - middle[1], points->z[i] - middle[2]};
        furthest = fmax(furthest, dot(away, away));
    }
    return nearest_of_path(path, middle, nearest) - sqrt(furthest) - outward > path->radius;
}

static bool outside_cone(const armtol_cone *cone, const vectors *tools, size_t count, double outward)
{
    double direction[3], low, high;
    unit_of(cone->direction, direction);
    range_along(tools, count, direction, &low, &high);
    return cone->angle < 3.141592653589793 && high + outward < cosine_of(&armtol_errata_none, cone->angle);
}

bool where_excludes(const armtol_region *region, const corner_space *space, size_t count, double outward, double reach)
{
    const vectors *points = &space->points;
    return (region->block != NULL && outside_block(region->block, points, count, outward)) ||
           (region->ring != NULL && outside_ring(region->ring, points, count, outward)) ||
           (region->path != NULL && outside_path(region->path, points, count, outward)) ||
           (region->cone != NULL && outside_cone(region->cone, &space->tools, count, outward / reach));
}

/* ---- towards it ---- */

static void into_block(const armtol_block *block, double point[3])
{
    for (int i = 0; i < 3; i++) {
        point[i] = fmax(block->low[i], fmin(block->high[i], point[i]));
    }
}

static void into_ring(const armtol_ring *ring, double point[3])
{
    double axis[3], out[3];
    unit_of(ring->axis, axis);
    const double along = along_ring(ring, axis, point, out), away = length_of_vector(out);
    const double to = fmax(ring->bottom, fmin(ring->top, along)), wide = fmax(ring->inner, fmin(ring->outer, away));
    for (int i = 0; i < 3; i++) {
        point[i] += (to - along) * axis[i] + (away > 0 ? (wide / away - 1) * out[i] : 0);
    }
}

static void into_path(const armtol_path *path, double point[3])
{
    double nearest[3];
    const double away = nearest_of_path(path, point, nearest);
    for (int i = 0; i < 3 && away > path->radius; i++) {
        point[i] = nearest[i] + path->radius / away * (point[i] - nearest[i]);
    }
}

/* To the edge of the cone, in the plane of direction and tool. */
static void into_cone(const armtol_cone *cone, double tool[3])
{
    double direction[3], across[3];
    const double angle = angle_from(cone, tool);
    unit_of(cone->direction, direction);
    if (angle <= cone->angle) {
        return;
    }
    for (int i = 0; i < 3; i++) {
        across[i] = tool[i] - dot(tool, direction) * direction[i];
    }
    const double size = length_of_vector(across);
    const double c = cosine_of(&armtol_errata_none, cone->angle), s = sine_of(&armtol_errata_none, cone->angle);
    for (int i = 0; i < 3; i++) {
        tool[i] = c * direction[i] + (size > 0 ? s * across[i] / size : 0);
    }
}

void where_nearest(const armtol_region *region, const double point[3], const double tool[3], double to_point[3],
                   double to_tool[3])
{
    for (int i = 0; i < 3; i++) {
        to_point[i] = point[i];
        to_tool[i] = tool[i];
    }
    if (region->block != NULL) {
        into_block(region->block, to_point);
    }
    if (region->ring != NULL) {
        into_ring(region->ring, to_point);
    }
    if (region->path != NULL) {
        into_path(region->path, to_point);
    }
    if (region->cone != NULL) {
        into_cone(region->cone, to_tool);
    }
}
