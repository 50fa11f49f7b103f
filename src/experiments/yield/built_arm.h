#ifndef EXPERIMENTS_BUILT_ARM_H
#define EXPERIMENTS_BUILT_ARM_H

#include "armtol/armtol.h"

#include <stdbool.h>
#include <stddef.h>

/* An arm as it is drawn, to be held against the same arm as it is built, its joints at the same values. */
typedef struct built_arm {
    const armtol_link *links; /* as drawn, placed */
    size_t n_links;
    const armtol_column *columns; /* the parameters that can be off */
    size_t n_columns;
    armtol_transform drawn; /* its tool */
    armtol_link *built;     /* n_links places to work in */
} built_arm;

/* The links and the columns are the caller's and have to stay. False where memory is short. */
bool built_arm_start(built_arm *arm, const armtol_link links[], size_t n_links, const armtol_column columns[],
                     size_t n_columns);
void built_arm_free(built_arm *arm);

/*
 * Where the tool is with these errors of the parameters, one a column, less where it should be, by Eq. (4.1)
 * and nothing linear: the displacement of the tool point, then the rotation vector (axis times angle, for
 * angles less than pi) that turns the orientation as drawn into that as built; both in base coordinates, like
 * A's rows.
 */
void built_arm_error(const built_arm *arm, const double errors[], double error[6]);

#endif
