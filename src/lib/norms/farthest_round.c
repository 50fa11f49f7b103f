#include "lib/norms/farthest_round.h"

#include "lib/norms/farthest_vertex.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

/*
 * Method
 *    Ellipses of one shape add up to one. The largest is an ellipsoid for farthest_vertex. Of the others:
 *    A disc lies in each polygon of its tangents; where those come in pairs, opposite each other, the polygon is the
 *    sum of its sides, each plus or minus a half, and the whole is a zonotope. Its farthest vertex is too far, if at
 *    all. In the vertex's direction every disc gets a tangent, and so on, until the vertex is no farther than what
 *    discs and generators reach in that direction: an outer approximation, as Kelley's cutting planes are.
 *
 * Special cases
 *    An ellipse that is a line, or of which a direction sees nothing, needs no more: a tangent close to one that there
 *    is is not added.
 *
 * Accuracy
 *    The vertex is never nearer than the farthest point, but for rounding. Along its direction a point of that distance
 *    is reached but for 1e-12 of it (test_the_farthest_point_of_discs); where ellipses of several shapes are as far in
 *    a whole circle of directions, tangents run out before: then but for 3.1e-4 of what those behind the first reach.
 */

enum { MOST_TANGENTS = 64, FIRST_TANGENTS = 4 };

static const double gap = 1e-12, close = 1e-8;

/* The tangents of a disc: where they touch it, in half a turn, by their angles. */
typedef struct tangents {
    double at[MOST_TANGENTS][2];
    double count;
} tangents;

enum { TANGENTS_SIZE = sizeof(tangents) / sizeof(double) };

size_t farthest_round_workspace(size_t count, size_t n_ellipses)
{
    return 6 * (count + MOST_TANGENTS * n_ellipses) + TANGENTS_SIZE * n_ellipses;
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static double turned_from(const double a[2], const double b[2])
{
    return a[0] * b[1] - a[1] * b[0];
}

/* Adds it in its place; false where there is one beside it, or no room. */
static bool add_tangent(tangents *tangents, double x, double y)
{
    const double length = sqrt(x * x + y * y), sign = y < 0 || (y == 0 && x < 0) ? -1 : 1;
    const double at[2] = {sign * x / length, sign * y / length};
    const size_t n = (size_t)tangents->count;
    size_t place = 0;
    for (size_t i = 0; i < n; i++) {
        const double turned = turned_from(tangents->at[i], at);
        if (fabs(turned) < close) {
            return false;
        }
        place += turned > 0;
    }
    if (n == MOST_TANGENTS) {
        return false;
    }
    memmove(tangents->at[place + 1], tangents->at[place], (n - place) * sizeof tangents->at[0]);
    memcpy(tangents->at[place], at, sizeof at);
    tangents->count++;
    return true;
}

static void start_tangents(tangents *tangents)
{
    static const double first[FIRST_TANGENTS][2] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}};
    tangents->count = 0;
    for (int i = 0; i < FIRST_TANGENTS; i++) {
        add_tangent(tangents, first[i][0], first[i][1]);
    }
}

/* The tangent of half the angle from one to the next; behind the last comes the first's opposite. */
static double half_angle(const tangents *tangents, size_t i)
{
    const size_t n = (size_t)tangents->count;
    const double sign = i + 1 < n ? 1 : -1, *one = tangents->at[i], *next = tangents->at[(i + 1) % n];
    return sign * turned_from(one, next) / (1 + sign * (one[0] * next[0] + one[1] * next[1]));
}

/* Half a side for each pair of opposite tangents; those that the norm does not see are left out. */
static size_t add_sides(const tangents *tangents, const ellipse *ellipse, double generators[])
{
    const size_t n = (size_t)tangents->count;
    size_t added = 0;
    for (size_t i = 0; i < n; i++) {
        const double half = (half_angle(tangents, i) + half_angle(tangents, (i + n - 1) % n)) / 2;
        double *const side = generators + 3 * added;
        for (int j = 0; j < 3; j++) {
            side[j] = half * (tangents->at[i][0] * ellipse->other[j] - tangents->at[i][1] * ellipse->one[j]);
        }
        added += dot(side, side) > 0;
    }
    return added;
}

/* ---- ellipses of one shape ---- */

/* Its support along u is the root of u' squares u. */
static void find_squares(const ellipse *ellipse, double squares[3][3])
{
    for (int i = 0; i < 9; i++) {
        squares[i / 3][i % 3] = ellipse->one[i / 3] * ellipse->one[i % 3] +
                                ellipse->other[i / 3] * ellipse->other[i % 3];
    }
}

/* The sum of the squares of its half axes. */
static double size_of(const ellipse *ellipse)
{
    return dot(ellipse->one, ellipse->one) + dot(ellipse->other, ellipse->other);
}

static bool is_of_shape(const ellipse *one, const ellipse *other)
{
    static const double rounding = 1e-14;
    double of_one[3][3], of_other[3][3], most = 0;
    const double ratio = size_of(one) / size_of(other);
    find_squares(one, of_one);
    find_squares(other, of_other);
    for (int i = 0; i < 9; i++) {
        most = fmax(most, fabs(of_one[i / 3][i % 3] - ratio * of_other[i / 3][i % 3]));
    }
    return most <= rounding * size_of(one);
}

static void scale(ellipse *ellipse, double factor)
{
    for (int i = 0; i < 3; i++) {
        ellipse->one[i] *= factor;
        ellipse->other[i] *= factor;
    }
}

/* Puts those of one shape together, and the largest in front; returns how many are left. */
static size_t join(ellipse ellipses[], size_t n_ellipses)
{
    size_t n = 0;
    for (size_t i = 0; i < n_ellipses; i++) {
        size_t like = 0;
        while (like < n && !is_of_shape(&ellipses[like], &ellipses[i])) {
            like++;
        }
        if (like < n) {
            scale(&ellipses[like], 1 + sqrt(size_of(&ellipses[i]) / size_of(&ellipses[like])));
        } else {
            ellipses[n++] = ellipses[i];
        }
    }
    for (size_t i = 1; i < n; i++) {
        if (size_of(&ellipses[i]) > size_of(&ellipses[0])) {
            const ellipse larger = ellipses[i];
            ellipses[i] = ellipses[0];
            ellipses[0] = larger;
        }
    }
    return n;
}

/* ---- the farthest point ---- */

/* How far discs and generators reach along a vector, as a part of its length squared. */
static double reach(const double generators[], size_t count, const ellipse ellipses[], size_t n_ellipses,
                    const double vector[3])
{
    double sum = 0;
    for (size_t k = 0; k < count; k++) {
        sum += fabs(dot(generators + 3 * k, vector));
    }
    for (size_t i = 0; i < n_ellipses; i++) {
        const double one = dot(ellipses[i].one, vector), other = dot(ellipses[i].other, vector);
        sum += sqrt(one * one + other * other);
    }
    return sum / dot(vector, vector);
}

/* False where no disc gets a new one. */
static bool touch(const ellipse ellipses[], size_t n_ellipses, const double vector[3], tangents tangents[])
{
    bool any = false;
    for (size_t i = 0; i < n_ellipses; i++) {
        const double one = dot(ellipses[i].one, vector), other = dot(ellipses[i].other, vector);
        if (one * one + other * other > 0) {
            any = add_tangent(&tangents[i], one, other) || any;
        }
    }
    return any;
}

void farthest_round(const double generators[], size_t count, ellipse ellipses[], size_t n_ellipses, int flat,
                    double workspace[], double point[3])
{
    double squares[3][3];
    const size_t most = count + MOST_TANGENTS * n_ellipses;
    double *const all = workspace;
    crossing *const crossings = (crossing *)(void *)(workspace + 3 * most);
    tangents *const tangents = (struct tangents *)(void *)(workspace + 6 * most);
    const size_t n_shapes = join(ellipses, n_ellipses);
    find_squares(&ellipses[0], squares);
    memcpy(all, generators, 3 * count * sizeof *all);
    for (size_t i = 1; i < n_shapes; i++) {
        start_tangents(&tangents[i]);
    }
    do {
        size_t n = count;
        for (size_t i = 1; i < n_shapes; i++) {
            n += add_sides(&tangents[i], &ellipses[i], all + 3 * n);
        }
        farthest_vertex(all, n, flat, (const double(*)[3])squares, crossings, point);
    } while (reach(generators, count, ellipses, n_shapes, point) < 1 - gap &&
             touch(ellipses + 1, n_shapes - 1, point, tangents + 1));
}
