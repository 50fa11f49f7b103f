#include "lib/norms/farthest_vertex.h"

#include "lib/norms/farthest_ellipsoid.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/*
 * Method
 *    Every vertex is sum sign(u.g_k) g_k for some direction u. The great circles u.g_k = 0 part the sphere of
 *    directions into cells, a vertex each. The border of a cell is made of arcs, each on the circle of some g_i. So a
 *    direction that turns once about each g_i passes along all cells: beside an arc the signs are those of the arc, and
 *    that of g_i is + on one side and - on the other. A generator parallel to g_i goes with it. The farthest sum of a
 *    vertex and a point of an ellipsoid is, of one of the vertices, the farthest point of the ellipsoid about it.
 *
 * Special cases
 *    Generators in a plane need one turn, about what is across it. Signs of 0 are +.
 *
 * Accuracy
 *    Whatever rounding does to the order of crossings, a sum of signed generators is a point of the zonotope: nothing
 *    too far is found. Nor is the farthest vertex x, |x| = M, u = x / M, missed:
 *    - Turning a generator over makes x no longer, |x - 2 s_k g_k| <= M, so that s_k u.g_k >= |g_k|^2 / M. So the cell
 *      of x among generators longer than h M holds the disc of radius h about u. Their cell has at most n edges and a
 *      border of 2 pi h or more: one edge, of g_i say, has half the length pi h / n or more. Let w be its middle.
 *    - Two circles between which that disc lies are at an angle of 2 h or more. So a generator whose circle is nearer
 *      than h to that of g_i has the sign that goes with g_i's, and is taken for parallel. For all others,
 *      |w.g_k| >= h (pi h / n) |g_k|.
 *    - A crossing is misplaced by rounding only where |v.g_k| < 16 eps |g_k|. With h^2 = 16 eps n / pi no such one is
 *      at w, and the signs there are right. This is the h of `parallel`.
 *    - Generators shorter than h M may be wrong there. They are put right afterwards where |u.g_k| > 2 n h |g_k|;
 *      others cost 4 h n |g_k| each at most, together 4 n^2 h^2 M = 2.3e-15 n^3 M: 1e-10 for 35 columns, if all are so
 *      short. Of all that was drawn none was 1e-13 from the best corner (test_the_worst_of_all_corners).
 */
static double parallel(size_t n)
{
    return 2.4e-8 * sqrt((double)n);
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void add(double sum[3], double factor, const double a[3])
{
    for (int i = 0; i < 3; i++) {
        sum[i] += factor * a[i];
    }
}

static void cross(const double a[3], const double b[3], double product[3])
{
    for (int i = 0; i < 3; i++) {
        product[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
    }
}

static void normalise(double a[3])
{
    const double length = sqrt(dot(a, a));
    for (int i = 0; i < 3; i++) {
        a[i] /= length;
    }
}

static double sign_of(double value)
{
    return value < 0 ? -1 : 1;
}

/* A plane of directions, and what turns in it. */
typedef struct turn {
    const double *generators;
    size_t count;
    const double (*ellipsoid)[3]; /* NULL: none */
    double reach;                 /* no point of the ellipsoid is farther from its center */
    double first[3], second[3]; /* across the axis, and across each other */
    double along[3];            /* the sum of the generators that go with the axis */
    double at[3];               /* the sum of all others */
    crossing *crossings;
    size_t n_crossings;
} turn;

/* Two unit vectors across an axis; the coordinate that it has least of is the farthest from it. */
static void span_plane(turn *turn, const double axis[3])
{
    int least = 0;
    for (int i = 1; i < 3; i++) {
        least = fabs(axis[i]) < fabs(axis[least]) ? i : least;
    }
    const double unit[3] = {least == 0, least == 1, least == 2};
    cross(axis, unit, turn->first);
    normalise(turn->first);
    cross(axis, turn->first, turn->second);
    normalise(turn->second);
}

/* From 0 to half a turn a direction passes each circle once. The key grows with the angle of what lies across. */
static void take_generator(turn *turn, const double axis[3], size_t k)
{
    const double *g = turn->generators + 3 * k;
    const double p = dot(g, turn->first), q = dot(g, turn->second), size = fabs(p) + fabs(q);
    if (size <= parallel(turn->count) * sqrt(dot(g, g))) {
        add(turn->along, sign_of(dot(axis, g)), g);
        return;
    }
    const double sign = q < 0 || (q == 0 && p < 0) ? -1 : 1;
    turn->crossings[turn->n_crossings++] = (crossing){.key = -sign * p / size, .sign = sign, .generator = (double)k};
    add(turn->at, sign, g);
}

/* A total order: the same on every machine, whatever its qsort does. */
static int by_key(const void *one, const void *other)
{
    const crossing *a = one, *b = other;
    if (a->key != b->key) {
        return a->key < b->key ? -1 : 1;
    }
    return a->generator < b->generator ? -1 : a->generator > b->generator;
}

static void keep_farthest(const turn *turn, double vertex[3])
{
    for (int sign = -1; sign <= 1; sign += 2) {
        double point[3];
        memcpy(point, turn->at, sizeof point);
        add(point, sign, turn->along);
        if (turn->ellipsoid != NULL) {
            if (sqrt(dot(point, point)) + turn->reach <= sqrt(dot(vertex, vertex))) {
                continue;
            }
            const double center[3] = {point[0], point[1], point[2]};
            farthest_of_ellipsoid(turn->ellipsoid, center, point);
        }
        if (dot(point, point) > dot(vertex, vertex)) {
            memcpy(vertex, point, sizeof point);
        }
    }
}

/* The other half of the turn has the same points with the other sign. */
static void turn_about(turn *turn, const double axis[3], double vertex[3])
{
    turn->n_crossings = 0;
    memset(turn->along, 0, sizeof turn->along);
    memset(turn->at, 0, sizeof turn->at);
    for (size_t k = 0; k < turn->count; k++) {
        take_generator(turn, axis, k);
    }
    qsort(turn->crossings, turn->n_crossings, sizeof *turn->crossings, by_key);
    keep_farthest(turn, vertex);
    for (size_t j = 0; j < turn->n_crossings; j++) {
        const crossing *at = &turn->crossings[j];
        add(turn->at, -2 * at->sign, turn->generators + 3 * (size_t)at->generator);
        keep_farthest(turn, vertex);
    }
}

/* The point of the ellipsoid in a direction. */
static void add_ellipsoid(const double ellipsoid[3][3], const double direction[3], double point[3])
{
    double pulled[3];
    for (int i = 0; i < 3; i++) {
        pulled[i] = dot(ellipsoid[i], direction);
    }
    const double square = dot(pulled, direction);
    add(point, square > 0 ? 1 / sqrt(square) : 0, pulled);
}

/* Each sign as the vertex itself wants it: that makes it no shorter. False where it gains nothing. */
static bool put_right(const turn *turn, double vertex[3])
{
    double point[3] = {0, 0, 0};
    for (size_t k = 0; k < turn->count; k++) {
        add(point, sign_of(dot(vertex, turn->generators + 3 * k)), turn->generators + 3 * k);
    }
    if (turn->ellipsoid != NULL) {
        add_ellipsoid(turn->ellipsoid, vertex, point);
    }
    const bool farther = dot(point, point) > dot(vertex, vertex);
    memcpy(vertex, point, sizeof point);
    return farther;
}

void farthest_vertex(const double generators[], size_t count, int flat, const double (*ellipsoid)[3],
                     crossing crossings[], double vertex[3])
{
    enum { MOST_ROUNDS = 64 };
    const double across[3] = {flat == 0, flat == 1, flat == 2};
    turn turn = {.generators = generators, .count = count, .ellipsoid = ellipsoid, .crossings = crossings};
    if (ellipsoid != NULL) {
        turn.reach = sqrt(ellipsoid[0][0] + ellipsoid[1][1] + ellipsoid[2][2]);
    }
    memset(vertex, 0, 3 * sizeof *vertex);
    keep_farthest(&turn, vertex); /* where there is no generator, the ellipsoid's */
    for (size_t i = 0; i < (flat >= 0 ? 1 : count); i++) {
        const double *axis = flat >= 0 ? across : generators + 3 * i;
        span_plane(&turn, axis);
        turn_about(&turn, axis, vertex);
    }
    for (int round = 0; round < MOST_ROUNDS && put_right(&turn, vertex); round++) {
    }
}
