#ifndef ARMTOL_ERROR_MATRIX_H
#define ARMTOL_ERROR_MATRIX_H

#include "armtol/errata.h"
#include "armtol/interface.h"
#include "armtol/link.h"
#include "armtol/twist_transform.h"

#include <stddef.h>

ARMTOL_INTERFACE_BEGIN

/* What a column of A stands for: one parameter of one link. */
typedef struct armtol_column {
    size_t link;
    armtol_parameter parameter;
} armtol_column;

/* The number of parameters of a chain, that is, of columns of A. Links of no known kind count none. */
size_t armtol_column_count(const armtol_link links[], size_t n_links);

/*
 * Describe the columns of A.
 *
 * Given:
 *    links, n_links       the chain
 *
 * Returned:
 *    columns, n_columns   links in order, the parameters of each in the order of its kind
 *
 * Errors:
 *    those of armtol_links_check
 *    ARMTOL_WRONG_SIZE    n_columns is not armtol_column_count
 */
armtol_status armtol_columns(const armtol_link links[], size_t n_links, armtol_column columns[],
                             size_t n_columns);

/*
 * A: the error twist of the tool for a unit error of each parameter, in base coordinates.
 *
 * Given:
 *    links, n_links      the chain, placed
 *    errata              base-twist, float, and those of link_transform.h, link_jacobian.h and twist_transform.h
 *
 * Returned:
 *    matrix, n_columns   6 x n_columns, columns as of armtol_columns
 *
 * Notes:
 * 1) With the erratum base-twist v is the linear part of the twist, the motion of the body point that lies at the
 *    base's origin; corrected, it is the motion of the tool point.
 *
 * Errors:
 *    those of armtol_columns
 *    ARMTOL_NOT_FINITE   where an element overflows; A is then of no use
 *
 * Reference:
 *    Hahn 1987, Eqs (4.9) and (4.11), the main programs.
 */
armtol_status armtol_error_matrix(const armtol_link links[], size_t n_links, const armtol_errata *errata,
                                  double matrix[], size_t n_columns);

/*
 * The same with these words on the diagonals of the skew matrices, in place of those that armtol_skew_residue works
 * out: what the programs of 1987 would have computed on a machine that leaves other words on its stack. The erratum
 * skew-residue is not read.
 */
armtol_status armtol_error_matrix_with_residue(const armtol_link links[], size_t n_links, const armtol_residue *residue,
                                               const armtol_errata *errata, double matrix[], size_t n_columns);

/*
 * Move the reference point of every column of A from the base's origin to point (base coordinates), in
 * place: v becomes v + w x point. Erratum: float.
 */
void armtol_refer_to_point(double matrix[], size_t n_columns, const double point[3],
                           const armtol_errata *errata);

ARMTOL_INTERFACE_END

#endif
