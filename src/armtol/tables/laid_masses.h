#ifndef ARMTOL_TABLES_LAID_MASSES_H
#define ARMTOL_TABLES_LAID_MASSES_H

#include "armtol/arm.h"

/*
 * The masses of an arm whose links were laid anew: what moves with a joint goes to its link, in that link's new frame.
 * masses has a place a link. What stands in front of joint 1 loads no joint: it is kept where a fixed link is before
 * it.
 */
void laid_masses_make(const armtol_arm *arm, const armtol_link links[], size_t n_links, armtol_mass masses[]);

#endif
