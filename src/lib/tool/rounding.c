#include "armtol/corners.h"
#include "armtol/error_matrix.h"
#include "armtol/tool_matrix.h"
#include "lib/report/trigonometry.h"
#include "lib/tool/negligible.h"

#include <float.h>
#include <math.h>

/* The chain's length when it is stretched, and the tool's offset. */
static double reach_of(const armtol_link links[], size_t n_links, const armtol_tool_point *tool)
{
    double reach = length_of_vector(tool->offset);
    for (size_t i = 0; i < n_links; i++) {
        reach += length_of(links[i].a, links[i].d);
    }
    return reach;
}

static void clear_small(double matrix[], size_t n_columns, size_t first, size_t column, double most)
{
    for (size_t i = first; i < first + 3; i++) {
        double *element = &matrix[i * n_columns + column];
        *element = fabs(*element) <= most ? 0 : *element;
    }
}

void armtol_tool_matrix_clear(const armtol_link links[], size_t n_links, const armtol_tool_point *tool, double matrix[],
                              size_t n_columns)
{
    const double reach = reach_of(links, n_links, tool);
    size_t column = 0;
    for (size_t i = 0; i < n_links; i++) {
        size_t count;
        const armtol_parameter *parameters = armtol_kind_parameters(links[i].kind, &count);
        for (size_t k = 0; k < count && column < n_columns; k++, column++) {
            const double lever = armtol_parameter_is_length(parameters[k]) ? 1 : reach;
            clear_small(matrix, n_columns, 0, column, negligible * lever);
            clear_small(matrix, n_columns, 3, column, negligible);
        }
    }
}

/*
 * Rounding.
 *
 * Method
 *    Roundings are counted to first order along the ways to the exact error and to A; the proof is below.
 *
 * Special cases
 *    Tolerances that are not finite, or a bound that overflows, give infinity.
 *
 * Accuracy
 *    A bound: in 2,000 arms of any size no computation is off by more, against long double
 *    (test_the_bound_holds_for_all_three_computations).
 *
 * Let u be half a unit in the last place of 1, and n the number of links. Errors are counted to first order in u; each
 * number below is rounded up by more than the higher orders make, as long as 100 n u is below 1/100.
 *
 * A turn of a frame about one of its axes gives two axes new components c x + s y. The cosine and the sine are off by 2
 * u, and by 8 u where the addition theorems put an error into them (sampler_kernel.h); with three roundings of the sum
 * a component is off by less than 11 u (|x| + |y|), an axis by less than 22 u, a frame by less than 32 u in the
 * Frobenius norm. A link turns its frame three times: 96 u. Where the link's matrix is multiplied out instead
 * (tool_error.c), its nine elements have at most three such factors each, 8 u an element and 24 u in the norm, and the
 * product adds 3 x 4 u: less. An angle that is a sum of its nominal value and an error is off by u times its size. So a
 * link takes no more than
 *
 *     100 u + 2 u sum over its angles of (|angle| + tolerance)
 *
 * from a frame, and the chain E, the sum of that over all links. The origin of a frame is a sum of the links' vectors,
 * no longer than L together (their lengths with tolerances, and the tool's offset): it is off by E L for the frames
 * they are seen in and, with four roundings of numbers up to 2 L a component and link, by less than 16 n u L.
 *
 * Both ways to the exact error take the difference of two such chains, or begin one where the inverse of the other
 * ends: twice that. A rotation vector is its matrix's off by that turned into an angle: the logarithm of a rotation by
 * less than half a turn lengthens what its matrix is off by, 2 E and 12 u of the product, by less than pi / 2, and the
 * components of the quaternion on the way lose no more than 4 parts of 1 + pi u; 4 E + 64 u is more than that.
 *
 * A is off by what its frames and origins are: an element of the linear rows and of an angle by 2 (2 E + 16 n u) L,
 * else by 2 E; and elements up to 1e-12 of L, or of 1, may have been set to 0 (armtol_tool_matrix_clear). Each counts
 * times its tolerance. What adding up |A| t rounds off is less than n_columns + 2 parts in 1 / u of it, and so it is
 * covered by the same 1e-12 of all t for the columns that an arm can have.
 */
static const double unit = DBL_EPSILON / 2;

typedef struct sizes {
    double reach;            /* L */
    double frame;            /* E */
    double lengths, angles;  /* the sums of their tolerances */
} sizes;

static void add_link(const armtol_link *link, const double tolerances[], sizes *sizes)
{
    size_t count;
    const armtol_parameter *parameters = armtol_kind_parameters(link->kind, &count);
    double angles = fabs(link->theta) + fabs(link->alpha) + fabs(link->beta);
    for (size_t k = 0; k < count; k++) {
        const double tolerance = tolerances[k];
        if (armtol_parameter_is_length(parameters[k])) {
            sizes->lengths += tolerance;
        } else {
            sizes->angles += tolerance;
            angles += tolerance;
        }
    }
    sizes->frame += (100 + 2 * angles) * unit;
}

void armtol_rounding(const armtol_link links[], size_t n_links, const armtol_tool_point *tool,
                     const double tolerances[], double rounding[6])
{
    sizes sizes = {.reach = reach_of(links, n_links, tool)};
    size_t column = 0;
    for (size_t i = 0; i < n_links; i++) {
        size_t count;
        armtol_kind_parameters(links[i].kind, &count);
        add_link(&links[i], tolerances + column, &sizes);
        column += count;
    }
    const double reach = 2 * sizes.reach + sizes.lengths; /* |a| + |d| is less than twice the root of their squares */
    const double origin = sizes.frame + 16 * (double)n_links * unit;
    const double linear = 2 * origin * reach + (negligible + 4 * origin) * (sizes.lengths + sizes.angles * reach);
    const double angular = 4 * sizes.frame + 64 * unit + (negligible + 2 * sizes.frame) * sizes.angles;
    for (size_t i = 0; i < 6; i++) {
        const double most = i < 3 ? linear : angular;
        rounding[i] = most <= DBL_MAX ? most : (double)INFINITY;
    }
}
