#include "fuzz/motion.h"

#include <math.h>

armtol_transform motion_product(const armtol_transform *left, const armtol_transform *right)
{
    armtol_transform product;
    for (int i = 0; i < 4; i++) {
        for (int k = 0; k < 4; k++) {
            long double sum = 0;
            for (int j = 0; j < 4; j++) {
                sum += (long double)left->m[i][j] * right->m[j][k];
            }
            product.m[i][k] = (double)sum;
        }
    }
    return product;
}

/* Rodrigues: R = I + sin(angle) K + (1 - cos(angle)) K^2, K the skew matrix of the unit vector. */
armtol_transform motion_about(const double direction[3], double angle)
{
    const double length = hypot(hypot(direction[0], direction[1]), direction[2]);
    const double u[3] = {direction[0] / length, direction[1] / length, direction[2] / length};
    const double skew[3][3] = {{0, -u[2], u[1]}, {u[2], 0, -u[0]}, {-u[1], u[0], 0}};
    const double half = sin(angle / 2);
    armtol_transform turn = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            const double square = u[i] * u[k] - (i == k ? 1 : 0);
            turn.m[i][k] += sin(angle) * skew[i][k] + 2 * half * half * square;
        }
    }
    return turn;
}

armtol_transform motion_along(const double direction[3], double length)
{
    const double whole = hypot(hypot(direction[0], direction[1]), direction[2]);
    armtol_transform shift = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
    for (int i = 0; i < 3; i++) {
        shift.m[i][3] = direction[i] / whole * length;
    }
    return shift;
}

armtol_transform motion_of_rpy(const double xyz[3], const double rpy[3])
{
    static const double axes[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const armtol_transform roll = motion_about(axes[0], rpy[0]), pitch = motion_about(axes[1], rpy[1]);
    const armtol_transform yaw = motion_about(axes[2], rpy[2]);
    armtol_transform motion = motion_product(&yaw, &pitch);
    motion = motion_product(&motion, &roll);
    for (int i = 0; i < 3; i++) {
        motion.m[i][3] = xyz[i];
    }
    return motion;
}

/* A turn about a line keeps the line's point: p goes to R (p - point) + point. */
armtol_transform motion_of_axis(const armtol_axis *axis, double q)
{
    if (axis->joint == ARMTOL_PRISMATIC) {
        return motion_along(axis->direction, q);
    }
    armtol_transform motion = motion_about(axis->direction, q);
    for (int i = 0; i < 3; i++) {
        motion.m[i][3] = axis->point[i];
        for (int k = 0; k < 3; k++) {
            motion.m[i][3] -= motion.m[i][k] * axis->point[k];
        }
    }
    return motion;
}

motion_difference motion_compare(const armtol_transform *one, const armtol_transform *other)
{
    motion_difference difference = {0, 0};
    for (int i = 0; i < 3; i++) {
        difference.length = fmax(difference.length, fabs(one->m[i][3] - other->m[i][3]));
        for (int k = 0; k < 3; k++) {
            difference.angle = fmax(difference.angle, fabs(one->m[i][k] - other->m[i][k]));
        }
    }
    return difference;
}
