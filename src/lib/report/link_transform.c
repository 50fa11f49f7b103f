#include "armtol/link_transform.h"

#include "armtol/transform.h"
#include "lib/report/arithmetic.h"
#include "lib/report/rows.h"
#include "lib/report/trigonometry.h"

armtol_transform armtol_link_transform(const armtol_link *link, const armtol_errata *errata)
{
    const double ca = store(errata, cosine_of(errata, link->alpha));
    const double sa = store(errata, sine_of(errata, link->alpha));
    const double ct = store(errata, cosine_of(errata, link->theta));
    const double st = store(errata, sine_of(errata, link->theta));
    const double cb = store(errata, cosine_of(errata, link->beta));
    const double sb = store(errata, sine_of(errata, link->beta));
    /* Erratum `mtransf-typo`: row 1, column 2 repeats the sine of row 0. */
    const double turn = errata->mtransf_typo ? st : ct;
    const double rows[3][4] = {
        {ct * cb - st * sa * sb, -st * ca, ct * sb + st * sa * cb, link->a * ct},
        {st * cb + ct * sa * sb, ct * ca, st * sb - turn * sa * cb, link->a * st},
        {-ca * sb, sa, ca * cb, link->d},
    };
    return transform_of_rows(rows, errata);
}

armtol_transform armtol_chain_transform(const armtol_link links[], size_t n_links, const armtol_errata *errata)
{
    armtol_transform chain = armtol_transform_identity();
    for (size_t i = 0; i < n_links; i++) {
        const armtol_transform link = armtol_link_transform(&links[i], errata);
        chain = armtol_transform_product(&chain, &link, errata);
    }
    return chain;
}
