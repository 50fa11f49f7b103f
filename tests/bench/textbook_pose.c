#include "bench/textbook.h"

#include <math.h>

typedef struct vector {
    double x, y, z;
} vector;

typedef struct place {
    vector x, y, z, origin;
} place;

static inline vector plus(vector a, vector b)
{
    return (vector){a.x + b.x, a.y + b.y, a.z + b.z};
}

static inline vector minus(vector a, vector b)
{
    return (vector){a.x - b.x, a.y - b.y, a.z - b.z};
}

static inline vector times(double k, vector a)
{
    return (vector){k * a.x, k * a.y, k * a.z};
}

static inline vector cross(vector a, vector b)
{
    return (vector){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static inline place turned(place p, double q)
{
    const double c = cos(q), s = sin(q);
    return (place){plus(times(c, p.x), times(s, p.y)), minus(times(c, p.y), times(s, p.x)), p.z, p.origin};
}

static inline place along_x(place p, double a)
{
    return (place){p.x, p.y, p.z, plus(p.origin, times(a, p.x))};
}

static inline place along_z(place p, double d)
{
    return (place){p.x, p.y, p.z, plus(p.origin, times(d, p.z))};
}

/* alpha = pi/2, and -pi/2 */
static inline place tilted_up(place p)
{
    return (place){p.x, p.z, times(-1, p.y), p.origin};
}

static inline place tilted_down(place p)
{
    return (place){p.x, times(-1, p.z), p.y, p.origin};
}

typedef struct sums {
    double lengths[3], angles[6];
} sums;

static inline void angle_column(double matrix[6][32], int k, vector axis, vector origin, vector tool,
                                sums *sums)
{
    const vector v = cross(axis, minus(tool, origin));
    const double column[6] = {v.x, v.y, v.z, axis.x, axis.y, axis.z};
    for (int i = 0; i < 6; i++) {
        matrix[i][k] = column[i];
        sums->angles[i] += column[i] * column[i];
    }
}

static inline void length_column(double matrix[6][32], int k, vector axis, sums *sums)
{
    const double column[3] = {axis.x, axis.y, axis.z};
    for (int i = 0; i < 3; i++) {
        matrix[i][k] = column[i];
        matrix[i + 3][k] = 0;
        sums->lengths[i] += column[i] * column[i];
    }
}

/* theta, d, a, alpha; before and behind are the frames with theta as it is, behind without alpha. */
static inline void npr(double matrix[6][32], int k, const place *before, const place *behind, vector tool,
                       sums *sums)
{
    angle_column(matrix, k, before->z, before->origin, tool, sums);
    length_column(matrix, k + 1, before->z, sums);
    length_column(matrix, k + 2, behind->x, sums);
    angle_column(matrix, k + 3, behind->x, behind->origin, tool, sums);
}

/* theta, a, alpha, beta; alpha is 0 */
static inline void ppr(double matrix[6][32], int k, const place *before, const place *behind, vector tool,
                       sums *sums)
{
    angle_column(matrix, k, before->z, before->origin, tool, sums);
    length_column(matrix, k + 1, behind->x, sums);
    angle_column(matrix, k + 2, behind->x, behind->origin, tool, sums);
    angle_column(matrix, k + 3, behind->y, behind->origin, tool, sums);
}

static inline void keep_least(double *bound, double other)
{
    if (other < *bound) {
        *bound = other;
    }
}

/* Eq. (4.31): the lengths have what the angles leave of each row. */
static void bounds_of(const sums *sums, const double tolerances[6], double delta, armtol_bounds *bounds)
{
    double distance = (double)INFINITY, angle = (double)INFINITY, angles[3];
    for (int i = 0; i < 3; i++) {
        angles[i] = sqrt(sums->angles[i]);
        keep_least(&angle, (tolerances[i] - delta) / angles[i]);
        keep_least(&angle, tolerances[i + 3] / sqrt(sums->angles[i + 3]));
    }
    for (int i = 0; i < 3; i++) {
        keep_least(&distance, (tolerances[i] - angles[i] * angle) / sqrt(sums->lengths[i]));
    }
    *bounds = (armtol_bounds){distance, angle};
}

void textbook_pose(const double q[6], const double tolerances[6], double delta, double matrix[6][32],
                   armtol_bounds *bounds)
{
    const place base = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}};
    const place shoulder = along_z(base, 359.7);
    const place p1 = turned(shoulder, q[0]), f1 = tilted_down(p1);
    const place p2 = turned(f1, q[1]), f2 = tilted_up(p2);
    const place f3 = along_x(turned(f2, q[2]), 373.4);
    const place f4 = along_x(turned(f3, q[3]), 279.4);
    const place p5 = turned(f4, q[4]), f5 = tilted_up(p5);
    const place f6 = turned(f5, q[5]);
    const place tool = along_z((place){f6.y, times(-1, f6.x), f6.z, f6.origin}, 100);

    sums sums = {{0}, {0}};
    npr(matrix, 0, &base, &shoulder, tool.origin, &sums);
    npr(matrix, 4, &shoulder, &p1, tool.origin, &sums);
    npr(matrix, 8, &f1, &p2, tool.origin, &sums);
    ppr(matrix, 12, &f2, &f3, tool.origin, &sums);
    ppr(matrix, 16, &f3, &f4, tool.origin, &sums);
    npr(matrix, 20, &f4, &p5, tool.origin, &sums);
    npr(matrix, 24, &f5, &f6, tool.origin, &sums);
    npr(matrix, 28, &f6, &tool, tool.origin, &sums);
    bounds_of(&sums, tolerances, delta, bounds);
}
