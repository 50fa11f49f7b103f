#include "lab/joint_orders/intelledex_matrices.h"

#include "armtol/transform.h"
#include "lab/joint_orders/intelledex_storage.h"

armtol_transform matrix_kept(const configuration *how, armtol_transform transform)
{
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 4; j++) {
            transform.m[i][j] = element(how, transform.m[i][j]);
        }
    }
    return transform;
}

/* How the terms of a sum are kept: in floats, or in doubles of which matrix_kept then stores the last. */
static const armtol_errata *terms(const configuration *how)
{
    const bool each = how->option[MATRICES] == STORED && how->option[SUMS] == SUMS_EACH;
    return each ? &armtol_errata_1987 : &armtol_errata_none;
}

armtol_transform matrix_product(const configuration *how, const armtol_transform *left,
                                const armtol_transform *right)
{
    return matrix_kept(how, armtol_transform_product(left, right, terms(how)));
}

armtol_transform matrix_inverse(const configuration *how, const armtol_transform *transform)
{
    return matrix_kept(how, armtol_transform_inverse(transform, terms(how)));
}

armtol_transform matrix_of_link(const configuration *how, double a, int alpha, double d, double theta)
{
    const double stored_alpha = keep(how->option[RIGHT_ANGLE] == RIGHT_ANGLE_FLOAT, alpha * pi_of(how) / 2);
    const bool exact = alpha == 0 || how->option[RIGHT_ANGLE] == RIGHT_ANGLE_EXACT;
    const double ca = exact ? alpha == 0 : sine(how, cos(stored_alpha));
    const double sa = exact ? alpha : sine(how, sin(stored_alpha));
    const double ct = sine(how, cos(theta)), st = sine(how, sin(theta));
    const armtol_transform link = {{
        {ct, -st, 0, a},
        {st * ca, ct * ca, -sa, -sa * d},
        {st * sa, ct * sa, ca, ca * d},
        {0, 0, 0, 1},
    }};
    return matrix_kept(how, link);
}

armtol_transform matrix_without(const configuration *how, const armtol_transform *transform,
                                const armtol_transform *link)
{
    const armtol_transform back = matrix_inverse(how, link);
    return matrix_product(how, transform, &back);
}
