#ifndef ARMTOL_LIB_MAP_VALUES_H
#define ARMTOL_LIB_MAP_VALUES_H

#include "armtol/map.h"
#include "lib/private_names.h"

/* Whether a pose is one that could not be reached. */
bool map_is_left_out(const double q[], size_t n_joints);

/* The worst case of many poses side by side, the drives being in no error. The question is known to be fine. */
armtol_fault map_blocks(const armtol_question *question, const armtol_map *map, double values[]);

/* Any value by an answer a pose. */
armtol_fault map_answers(const armtol_question *question, const armtol_map *map, double values[]);

#endif
