#include "armtol/transform.h"

#include "lib/report/arithmetic.h"
#include "lib/report/rows.h"

armtol_transform armtol_transform_identity(void)
{
    return (armtol_transform){{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
}

armtol_transform transform_of_rows(const double rows[3][4], const armtol_errata *errata)
{
    armtol_transform transform = armtol_transform_identity();
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 4; j++) {
            transform.m[i][j] = store(errata, rows[i][j]);
        }
    }
    return transform;
}

armtol_transform armtol_transform_product(const armtol_transform *left, const armtol_transform *right,
                                          const armtol_errata *errata)
{
    armtol_transform product;
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            double sum = 0;
            for (int n = 0; n < 4; n++) {
                sum = store(errata, sum + left->m[i][n] * right->m[n][j]);
            }
            product.m[i][j] = sum;
        }
    }
    return product;
}

armtol_transform armtol_transform_inverse(const armtol_transform *transform, const armtol_errata *errata)
{
    armtol_transform inverse = armtol_transform_identity();
    for (int i = 0; i < 3; i++) {
        double sum = 0;
        for (int j = 0; j < 3; j++) {
            inverse.m[i][j] = transform->m[j][i];
            sum = store(errata, sum + -transform->m[j][i] * transform->m[j][3]);
        }
        inverse.m[i][3] = sum;
    }
    return inverse;
}
