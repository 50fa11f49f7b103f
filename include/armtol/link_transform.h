#ifndef ARMTOL_LINK_TRANSFORM_H
#define ARMTOL_LINK_TRANSFORM_H

#include "armtol/conventions.h"
#include "armtol/errata.h"
#include "armtol/interface.h"
#include "armtol/link.h"

ARMTOL_INTERFACE_BEGIN

/*
 * The transform of one placed link, written out element by element. Errata: mtransf-typo, float.
 *
 * Reference:
 *    Hahn 1987, Eq. (4.2), routine mtransf.
 */
armtol_transform armtol_link_transform(const armtol_link *link, const armtol_errata *errata);

/*
 * The transform of a chain of placed links, base to tool; the identity for none. Errata: those of
 * armtol_link_transform.
 */
armtol_transform armtol_chain_transform(const armtol_link links[], size_t n_links,
                                        const armtol_errata *errata);

ARMTOL_INTERFACE_END

#endif
