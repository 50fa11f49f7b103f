#include "lab/joint_orders/intelledex_matrices.h"

#include "armtol/transform.h"
#include "lab/joint_orders/keep.h"

#include <math.h>

armtol_transform matrix_product(const armtol_transform *left, const armtol_transform *right)
{
    return armtol_transform_product(left, right, &armtol_errata_1987);
}

armtol_transform matrix_inverse(const armtol_transform *transform)
{
    return armtol_transform_inverse(transform, &armtol_errata_1987);
}

armtol_transform matrix_of_link(const configuration *how, double a, int alpha, double d, double theta)
{
    const double kalpha = keep(how->option[RIGHT_ANGLE] == RIGHT_ANGLE_FLOAT, alpha * HEADER_PI / 2);
    const double sa = stored(sin(kalpha)), ca = stored(cos(kalpha));
    const double st = stored(sin(theta)), ct = stored(cos(theta));
    armtol_transform link = {{
        {ct, -st, 0, a},
        {st * ca, ct * ca, -sa, -sa * d},
        {st * sa, ct * sa, ca, ca * d},
        {0, 0, 0, 1},
    }};
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 4; j++) {
            link.m[i][j] = stored(link.m[i][j]);
        }
    }
    return link;
}

armtol_transform matrix_without(const armtol_transform *transform, const armtol_transform *link)
{
    const armtol_transform back = matrix_inverse(link);
    return matrix_product(transform, &back);
}
