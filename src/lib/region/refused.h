#ifndef ARMTOL_LIB_REGION_REFUSED_H
#define ARMTOL_LIB_REGION_REFUSED_H

#include "armtol/region.h"
#include "lib/private_names.h"

/* What keeps a question of a region from being answered: a status, what it is about, and what of the region it is. */
typedef struct region_refusal {
    armtol_fault fault;
    armtol_region_fault why;
} region_refusal;

region_refusal region_refusal_of(armtol_status status, armtol_subject about, size_t number, armtol_region_fault why);

/* Before anything is placed: the arm, the region, and what is asked there. */
region_refusal region_check(const armtol_question *question, const armtol_region *region, const armtol_enclosing *how);

#endif
