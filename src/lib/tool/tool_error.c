#include "armtol/tool_error.h"

#include "armtol/error_matrix.h"
#include "armtol/link_transform.h"
#include "armtol/transform.h"
#include "lib/report/columns.h"
#include "lib/report/trigonometry.h"
#include "lib/tool/built.h"

#include <math.h>

/*
 * Method
 *    Both chains by Eq. (4.1), link by link, and the difference of their ends; the turn R R' between them becomes a
 *    quaternion, and that a rotation vector.
 *
 * Special cases
 *    No error gives exactly 0. Next to half a turn the quaternion is had from the largest of its parts. Beyond half a
 *    turn the vector is that of the shorter way. Nan and inf go through.
 *
 * Accuracy
 *    Turns up to pi about any axis to 3e-15 (test_known_rotations). What rounding makes of a chain is bounded in
 *    rounding.c, and the bound held against long double (test_the_bound_holds_for_all_three_computations).
 */

armtol_link built_link(const armtol_link *link, const double parameter_errors[], size_t *count)
{
    armtol_link built = *link;
    const armtol_parameter *parameters = armtol_kind_parameters(link->kind, count);
    for (size_t k = 0; k < *count; k++) {
        *armtol_link_parameter(&built, parameters[k]) += parameter_errors[k];
    }
    return built;
}

armtol_transform built_chain(const armtol_link links[], size_t n_links, const double parameter_errors[])
{
    armtol_transform chain = armtol_transform_identity();
    size_t column = 0;
    for (size_t i = 0; i < n_links; i++) {
        size_t count;
        const armtol_link link = built_link(&links[i], parameter_errors + column, &count);
        const armtol_transform step = armtol_link_transform(&link, &armtol_errata_none);
        chain = armtol_transform_product(&chain, &step, &armtol_errata_none);
        column += count;
    }
    return chain;
}

static void displacement(const armtol_transform *built, const armtol_transform *meant, const double offset[3],
                         double moved[3])
{
    for (int i = 0; i < 3; i++) {
        moved[i] = built->m[i][3] - meant->m[i][3];
        for (int n = 0; n < 3; n++) {
            moved[i] += (built->m[i][n] - meant->m[i][n]) * offset[n];
        }
    }
}

/* R R', R of the arm as built, R' the transpose of that as meant. */
static void turn(const armtol_transform *built, const armtol_transform *meant, double r[3][3])
{
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            r[i][j] = 0;
            for (int n = 0; n < 3; n++) {
                r[i][j] += built->m[i][n] * meant->m[j][n];
            }
        }
    }
}

/*
 * A multiple of the quaternion (w; v) = (cos, axis sin) of half the angle, w >= 0. Of the four ways to have
 * it from r the one is taken that subtracts no like numbers, so that it holds near no turn and near half a
 * turn.
 */
static double half_turn(double r[3][3], double v[3])
{
    double w = 1 + r[0][0] + r[1][1] + r[2][2];
    if (w < 1) {
        int i = r[1][1] > r[0][0] ? 1 : 0;
        i = r[2][2] > r[i][i] ? 2 : i;
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        v[i] = 1 + r[i][i] - r[j][j] - r[k][k];
        v[j] = r[j][i] + r[i][j];
        v[k] = r[k][i] + r[i][k];
        w = r[k][j] - r[j][k];
    } else {
        for (int i = 0; i < 3; i++) {
            const int j = (i + 1) % 3, k = (i + 2) % 3;
            v[i] = r[k][j] - r[j][k];
        }
    }
    for (int i = 0; i < 3 && w < 0; i++) {
        v[i] = -v[i];
    }
    return fabs(w);
}

static void rotation_vector(double r[3][3], double vector[3])
{
    const double w = half_turn(r, vector);
    const double length = sqrt(vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2]);
    const double factor = length > 0 ? 2 * angle_of(&armtol_errata_none, length, w) / length : 2 / w;
    for (int i = 0; i < 3; i++) {
        vector[i] *= factor;
    }
}

/* From base coordinates to those of the frame. */
static void express(const armtol_transform *frame, double vector[3])
{
    const double in_base[3] = {vector[0], vector[1], vector[2]};
    for (int i = 0; i < 3; i++) {
        vector[i] = 0;
        for (int n = 0; n < 3; n++) {
            vector[i] += frame->m[n][i] * in_base[n];
        }
    }
}

void built_error(const armtol_transform *built, const armtol_transform *meant, const armtol_tool_point *tool,
                 double error[6])
{
    double r[3][3];
    turn(built, meant, r);
    displacement(built, meant, tool->offset, error);
    rotation_vector(r, error + 3);
    if (tool->frame == ARMTOL_TOOL_FRAME) {
        express(meant, error);
        express(meant, error + 3);
    }
}

armtol_status armtol_tool_error(const armtol_link links[], size_t n_links, const double parameter_errors[],
                                size_t n_columns, const armtol_tool_point *tool, double error[6])
{
    const armtol_status status = columns_check(links, n_links, n_columns);
    if (status != ARMTOL_OK) {
        return status;
    }
    const armtol_transform meant = armtol_chain_transform(links, n_links, &armtol_errata_none);
    const armtol_transform built = built_chain(links, n_links, parameter_errors);
    built_error(&built, &meant, tool, error);
    return ARMTOL_OK;
}
