#ifndef TEST_REFERENCE_H
#define TEST_REFERENCE_H

#include "armtol/error_matrix.h"
#include "armtol/link.h"

#include <stdbool.h>
#include <stddef.h>

/*
 * Eq. (4.1) done again, sharing nothing with the library: elementary rotations and translations multiplied in
 * long double, and derivatives by central differences.
 */

/* T of one link, and of a chain. */
void reference_link(const armtol_link *link, double transform[4][4]);
void reference_chain(const armtol_link links[], size_t n_links, double transform[4][4]);

/*
 * The twist, in base coordinates, for a unit error of one parameter: v of the tool point, or of the body point at
 * the base's origin.
 */
void reference_column(const armtol_link links[], size_t n_links, armtol_column column, bool of_tool_point,
                      double twist[6]);

#endif
