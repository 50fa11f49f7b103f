#include "armtol/error_matrix.h"

#include "armtol/link_jacobian.h"
#include "armtol/link_transform.h"
#include "armtol/twist_transform.h"
#include "lib/report/arithmetic.h"
#include "lib/report/columns.h"
#include "lib/report/finite.h"

size_t armtol_column_count(const armtol_link links[], size_t n_links)
{
    size_t total = 0;
    for (size_t i = 0; i < n_links; i++) {
        size_t count;
        armtol_kind_parameters(links[i].kind, &count);
        total += count;
    }
    return total;
}

armtol_status columns_check(const armtol_link links[], size_t n_links, size_t n_columns)
{
    const armtol_status status = armtol_links_check(links, n_links);
    if (status != ARMTOL_OK) {
        return status;
    }
    return n_columns == armtol_column_count(links, n_links) ? ARMTOL_OK : ARMTOL_WRONG_SIZE;
}

armtol_status armtol_columns(const armtol_link links[], size_t n_links, armtol_column columns[],
                             size_t n_columns)
{
    const armtol_status status = columns_check(links, n_links, n_columns);
    if (status != ARMTOL_OK) {
        return status;
    }
    size_t column = 0;
    for (size_t i = 0; i < n_links; i++) {
        size_t count;
        const armtol_parameter *parameters = armtol_kind_parameters(links[i].kind, &count);
        for (size_t k = 0; k < count; k++) {
            columns[column++] = (armtol_column){i, parameters[k]};
        }
    }
    return ARMTOL_OK;
}

static armtol_adjoint adjoint_of(const armtol_link *link, const armtol_residue *residue,
                                 const armtol_errata *errata)
{
    const armtol_transform transform = armtol_link_transform(link, errata);
    return armtol_twist_transform(&transform, residue, errata);
}

static armtol_adjoint adjoint_product(const armtol_adjoint *left, const armtol_adjoint *right,
                                      const armtol_errata *errata)
{
    armtol_adjoint product;
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            double sum = 0;
            for (int n = 0; n < 6; n++) {
                sum = store(errata, sum + left->m[i][n] * right->m[n][j]);
            }
            product.m[i][j] = sum;
        }
    }
    return product;
}

/* Columns first .. first + count - 1 of the matrix: the link's own columns, seen from the base. */
static void link_columns(const armtol_adjoint *to_base, double g[6][ARMTOL_PARAMETER_COUNT], size_t count,
                         const armtol_errata *errata, double matrix[], size_t n_columns, size_t first)
{
    for (size_t i = 0; i < 6; i++) {
        for (size_t k = 0; k < count; k++) {
            double sum = 0;
            for (int n = 0; n < 6; n++) {
                sum = store(errata, sum + to_base->m[i][n] * g[n][k]);
            }
            matrix[i * n_columns + first + k] = sum;
        }
    }
}

static void base_twists(const armtol_link links[], size_t n_links, const armtol_residue *residue,
                        const armtol_errata *errata, double matrix[], size_t n_columns)
{
    armtol_adjoint to_base = adjoint_of(&links[0], residue, errata);
    size_t column = 0;
    for (size_t i = 0; i < n_links; i++) {
        /* zeros, as g4 of the main program was on a fresh stack: erratum gppp-clearing leaves some of them */
        double g[6][ARMTOL_PARAMETER_COUNT] = {{0}};
        size_t count = 0;
        if (i > 0) {
            const armtol_adjoint step = adjoint_of(&links[i], residue, errata);
            to_base = adjoint_product(&to_base, &step, errata);
        }
        armtol_link_jacobian(&links[i], errata, g, &count);
        link_columns(&to_base, g, count, errata, matrix, n_columns, column);
        column += count;
    }
}

void armtol_refer_to_point(double matrix[], size_t n_columns, const double point[3],
                           const armtol_errata *errata)
{
    for (size_t k = 0; k < n_columns; k++) {
        double *const v = matrix + k, *const w = matrix + 3 * n_columns + k;
        for (size_t i = 0; i < 3; i++) {
            const size_t j = (i + 1) % 3, l = (i + 2) % 3;
            const double moved = w[j * n_columns] * point[l] - w[l * n_columns] * point[j];
            v[i * n_columns] = store(errata, v[i * n_columns] + moved);
        }
    }
}

armtol_status armtol_error_matrix_with_residue(const armtol_link links[], size_t n_links, const armtol_residue *residue,
                                               const armtol_errata *errata, double matrix[], size_t n_columns)
{
    const armtol_status status = columns_check(links, n_links, n_columns);
    if (status != ARMTOL_OK) {
        return status;
    }
    base_twists(links, n_links, residue, errata, matrix, n_columns);
    /* Erratum `base-twist`: the twist stays referred to the base's origin. */
    if (!errata->base_twist) {
        const armtol_transform tool = armtol_chain_transform(links, n_links, errata);
        const double point[3] = {tool.m[0][3], tool.m[1][3], tool.m[2][3]};
        armtol_refer_to_point(matrix, n_columns, point, errata);
    }
    return all_finite(matrix, 6 * n_columns) ? ARMTOL_OK : ARMTOL_NOT_FINITE;
}

armtol_status armtol_error_matrix(const armtol_link links[], size_t n_links, const armtol_errata *errata,
                                  double matrix[], size_t n_columns)
{
    const armtol_residue residue = armtol_skew_residue(links, n_links, errata);
    return armtol_error_matrix_with_residue(links, n_links, &residue, errata, matrix, n_columns);
}
