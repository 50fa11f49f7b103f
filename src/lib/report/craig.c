#include "armtol/craig.h"

#include "armtol/transform.h"
#include "lib/report/arithmetic.h"
#include "lib/report/rows.h"
#include "lib/report/trigonometry.h"

armtol_transform armtol_craig_transform(const armtol_craig_link *link, double q, const armtol_errata *errata)
{
    const double alpha = store(errata, link->alpha);
    const double theta = store(errata, link->joint == ARMTOL_REVOLUTE ? link->theta + q : link->theta);
    const double d = store(errata, link->joint == ARMTOL_PRISMATIC ? link->d + q : link->d);
    const double sa = store(errata, sine_of(errata, alpha)), ca = store(errata, cosine_of(errata, alpha));
    const double st = store(errata, sine_of(errata, theta)), ct = store(errata, cosine_of(errata, theta));
    const double rows[3][4] = {
        {ct, -st, 0, link->a},
        {st * ca, ct * ca, -sa, -sa * d},
        {st * sa, ct * sa, ca, ca * d},
    };
    return transform_of_rows(rows, errata);
}

armtol_transform armtol_craig_chain(const armtol_craig_link links[], size_t n_links, const double q[],
                                    const armtol_errata *errata)
{
    armtol_transform chain = armtol_transform_identity();
    size_t joint = 0;
    for (size_t i = 0; i < n_links; i++) {
        const double value = links[i].joint == ARMTOL_FIXED ? 0 : q[joint++];
        const armtol_transform link = armtol_craig_transform(&links[i], value, errata);
        chain = armtol_transform_product(&chain, &link, errata);
    }
    return chain;
}
