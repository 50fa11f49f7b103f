#include "armtol/urdf/origin.h"

#include "armtol/euler.h"

#include <math.h>

/* The larger ones first, so that no square is too large or too small. */
static void make_unit(double q[4])
{
    double largest = 0, sum = 0;
    for (int i = 0; i < 4; i++) {
        largest = fmax(largest, fabs(q[i]));
    }
    for (int i = 0; i < 4; i++) {
        q[i] /= largest;
        sum += q[i] * q[i];
    }
    for (int i = 0; i < 4; i++) {
        q[i] /= sqrt(sum);
    }
}

static armtol_transform of_quaternion(const urdf_joint *joint)
{
    double q[4] = {joint->quaternion[0], joint->quaternion[1], joint->quaternion[2], joint->quaternion[3]};
    make_unit(q);
    const double x = q[0], y = q[1], z = q[2], w = q[3], *p = joint->xyz;
    return (armtol_transform){{
        {1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w), p[0]},
        {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w), p[1]},
        {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y), p[2]},
        {0, 0, 0, 1},
    }};
}

armtol_transform urdf_joint_origin(const urdf_joint *joint)
{
    const double *p = joint->xyz, *rpy = joint->rpy;
    if (joint->has_quaternion) {
        return of_quaternion(joint);
    }
    return armtol_pose_to_transform((const double[6]){p[0], p[1], p[2], rpy[0], rpy[1], rpy[2]}, &armtol_errata_none);
}
