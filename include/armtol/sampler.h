#ifndef ARMTOL_SAMPLER_H
#define ARMTOL_SAMPLER_H

#include "armtol/interface.h"
#include "armtol/link.h"
#include "armtol/spread.h"
#include "armtol/tool_point.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

ARMTOL_INTERFACE_BEGIN

/*
 * Arms drawn at random: every parameter of arm i is off by a draw that is uniform within its tolerance, or spread as
 * armtol_sampler_spread says, and depends on the seed, i and the parameter's column alone: not on what was drawn
 * before, on the machine or on the number of threads. Once a sampler is started its arithmetic calls nothing of libm
 * but what rounds exactly (where no tolerance of an angle is more than 1e6), so that machines agree to the bit.
 */

/* One link as the sampler needs it. Filled by armtol_sampler_start. */
typedef struct armtol_sampled_link {
    double a, d;
    double cos_theta, sin_theta;
    double cos_alpha, sin_alpha;
    double cos_beta, sin_beta;
    bool off[ARMTOL_PARAMETER_COUNT]; /* whether the tolerance is more than 0 */

    /* Those that are, in the order in which they are drawn. */
    size_t n_drawn;
    armtol_parameter drawn[ARMTOL_PARAMETER_COUNT];
    double tolerances[ARMTOL_PARAMETER_COUNT];
    size_t columns[ARMTOL_PARAMETER_COUNT];
    uint64_t steps[ARMTOL_PARAMETER_COUNT]; /* of the generator, from an arm's first draw on */
    double disc; /* the radius of the disc that alpha and beta are drawn in; 0 where there is none */

    /* Of those that are not uniform, else of no use. */
    armtol_shape shapes[ARMTOL_PARAMETER_COUNT];
} armtol_sampled_link;

typedef struct armtol_sampler {
    const armtol_sampled_link *links;
    size_t n_links;
    size_t n_columns;
    armtol_tool_point tool;
    armtol_transform meant; /* where the last frame should be */
    armtol_transform start; /* its inverse: a chain that starts there ends in the error, seen from the tool */
    bool large_errors;      /* a tolerance of an angle is too large for the short series of sine and cosine */
    bool shaped;            /* some draw is not uniform */
    bool large_turn;        /* all angles' together are too large for the series of the rotation vector */
    uint64_t seed;
    uint64_t key; /* the seed, mixed */
} armtol_sampler;

/*
 * Prepare to draw arms at one pose.
 *
 * Given:
 *    links, n_links          the arm, placed
 *    tolerances, n_columns   one value >= 0 a column (error_matrix.h)
 *    tool                    the tool point, and along which axes is counted
 *    seed                    samplers with the same seed and columns draw the same parts of their tolerances: one arm
 *                            can be looked at in several poses
 *
 * Returned:
 *    *sampler                what the other routines need
 *    prepared                n_links places; they have to stay as long as *sampler is used
 *
 * Errors:
 *    those of armtol_links_check
 *    ARMTOL_WRONG_SIZE      n_columns is not armtol_column_count
 *    ARMTOL_BAD_TOLERANCE   a tolerance is negative
 *    ARMTOL_NOT_FINITE      a tolerance is not, or an offset
 */
armtol_status armtol_sampler_start(armtol_sampler *sampler, armtol_sampled_link prepared[],
                                   const armtol_link links[], size_t n_links, const double tolerances[],
                                   size_t n_columns, const armtol_tool_point *tool, uint64_t seed);

/*
 * Count the errors of a started sampler from where the tool of these links is: placed, as many as the sampler's own and
 * checked. So arms can be drawn about joint values that loads have shifted, and held against the arm as meant.
 */
void armtol_sampler_aim(armtol_sampler *sampler, const armtol_link meant[]);

/*
 * Draw some alphas in discs, with the betas behind them.
 *
 * Given:
 *    sampler     started; it draws from `prepared` on as said here
 *    prepared    what it was started with
 *    discs       n_columns: true for an alpha that has a beta behind it, of the same tolerance: the radius of a disc in
 *                which the point (alpha, beta) is even
 *
 * Notes:
 * 1) The draws of the two columns are the point's place in the disc's area, from the middle on, and its direction: they
 *    too depend on the seed, the arm and the columns alone, and their bits on no machine.
 */
void armtol_sampler_discs(const armtol_sampler *sampler, armtol_sampled_link prepared[], const bool discs[]);

/*
 * Have the errors of a started sampler distributed otherwise than uniformly, and groups of them drawn as one.
 *
 * Given:
 *    spreads    one a column, known (armtol_spread_is_known); only read. Of the shift nothing is read: what is drawn is
 *               about the links that the sampler was started with
 *
 * Returned:
 *    *sampler, prepared    those of armtol_sampler_start
 *
 * Notes:
 * 1) The draw of a column is that of the first column of its group. So what is uniform and by itself is drawn as
 *    before.
 */
void armtol_sampler_spread(armtol_sampler *sampler, armtol_sampled_link prepared[],
                           const armtol_error_spread spreads[]);

/*
 * One draw.
 *
 * Given:
 *    seed
 *    number   arm i takes number i * n_columns + k for its parameter of column k, and for those of a group that k leads
 *
 * Returned (function value):
 *    uniform in [-1, 1)
 *
 * Reference:
 *    splitmix64 (Steele, Lea, Flood 2014). Its state only counts, so that any draw can be had at once.
 */
double armtol_sampler_uniform(uint64_t seed, uint64_t number);

/*
 * The errors of the tool of some arms.
 *
 * Given:
 *    sampler        started
 *    first, count   the arms first to first + count - 1
 *
 * Returned:
 *    errors         6 * count, as armtol_tool_error has them: component i of arm first + j at errors[i * count + j]
 */
void armtol_sampler_draw(const armtol_sampler *sampler, uint64_t first, size_t count, double errors[]);

/* The parameter errors of one arm, n_columns values. */
void armtol_sampler_parameters(const armtol_sampler *sampler, uint64_t arm, double parameter_errors[]);

ARMTOL_INTERFACE_END

#endif
