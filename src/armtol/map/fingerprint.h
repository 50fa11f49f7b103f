#ifndef ARMTOL_MAP_FINGERPRINT_H
#define ARMTOL_MAP_FINGERPRINT_H

#include "armtol/map/plan.h"

#include <stdint.h>

/*
 * 64 bits for each of ROWS_SUBJECTS: they differ where two plans have not the same joint values and the same value in
 * every point. How a map is shown is in none of them.
 */
void map_fingerprints(const map_plan *plan, uint64_t fingerprints[]);

#endif
