#include "armtol/twist_transform.h"

#include "lib/report/arithmetic.h"
#include "lib/report/trigonometry.h"

#include <stdint.h>
#include <string.h>

/*
 * The upper word of a double, read as a float: what a big-endian machine sees where a routine takes a float
 * from the place of a double argument. Shifting the value, not its bytes, makes it the same everywhere.
 */
static double upper_word(double value)
{
    uint64_t bits;
    uint32_t upper;
    float seen;
    memcpy(&bits, &value, sizeof bits);
    upper = (uint32_t)(bits >> 32);
    memcpy(&seen, &upper, sizeof seen);
    return (double)seen;
}

armtol_residue armtol_skew_residue(const armtol_link links[], size_t n_links, const armtol_errata *errata)
{
    /* Erratum `skew-residue`: the diagonal is what the last gnpr left in its place. */
    if (!errata->skew_residue || n_links == 0 || links[n_links - 1].kind != ARMTOL_NPR) {
        return (armtol_residue){{0, 0, 0}};
    }
    const armtol_link *tool = &links[n_links - 1];
    return (armtol_residue){
        {upper_word(tool->alpha), store(errata, sine_of(errata, tool->alpha)), upper_word(tool->a)},
    };
}

armtol_adjoint armtol_twist_transform(const armtol_transform *transform, const armtol_residue *residue,
                                      const armtol_errata *errata)
{
    const double x = transform->m[0][3], y = transform->m[1][3], z = transform->m[2][3];
    const double skew[3][3] = {
        {residue->diagonal[0], -z, y},
        {z, residue->diagonal[1], -x},
        {-y, x, residue->diagonal[2]},
    };
    armtol_adjoint adjoint = {{{0}}};
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            double sum = 0;
            for (int n = 0; n < 3; n++) {
                sum = store(errata, sum + skew[i][n] * transform->m[n][j]);
            }
            adjoint.m[i][j] = transform->m[i][j];
            adjoint.m[i][j + 3] = sum;
            adjoint.m[i + 3][j + 3] = transform->m[i][j];
        }
    }
    return adjoint;
}
