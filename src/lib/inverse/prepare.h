#ifndef ARMTOL_LIB_INVERSE_PREPARE_H
#define ARMTOL_LIB_INVERSE_PREPARE_H

#include "lib/inverse/chain.h"

/* Fill the links and joints of a chain, whose memory is there. ARMTOL_NOT_FINITE for a size or a `near` that is not. */
armtol_status prepare_chain(chain *chain, const armtol_inverse_setup *setup);

#endif
