#include "armtol/sampler.h"

#include "armtol/error_matrix.h"
#include "armtol/link_transform.h"
#include "armtol/transform.h"
#include "lib/report/columns.h"
#include "lib/report/finite.h"
#include "lib/spread/splitmix.h"
#include "lib/tool/pose_link.h"

#define LANES 1
#include "lib/lanes/frame.h"
#include "lib/tool/disc_draw.h"

/*
 * Method
 *    The frame of an arm begins where the inverse of the last frame as meant is, and is carried link by link: where it
 *    ends is the error, seen from the tool (sampler_kernel.h). Draws are splitmix64's, by their number.
 *
 * Special cases
 *    Errors of angles up to 1/128, and turns up to 1/4 together, have short series; larger ones the sine, cosine and
 *    arc tangent of lanes/, angles beyond 1e6 libm's. A tolerance of 0 takes no draw.
 *
 * Accuracy
 *    3e-14 for arms of some metres, small errors and large
 *    (test_errors_are_those_of_the_definition_for_small_tolerances, ..._large_tolerances);
 *    one turn as rotation.h says. The same bits for any split and width of vectors (test_the_same_bits_for_any_split).
 */

/* ---- drawing ---- */

/* The upper 53 bits, over 2^52, less 1: exact. */
static double uniform_at(uint64_t state)
{
    return (double)(splitmix_mix(state) >> 11) * 0x1p-52 - 1;
}

/* The seed is mixed too: the draws of neighbouring seeds would else be each other's, one place on. */
static uint64_t key_of(uint64_t seed)
{
    return splitmix_mix(seed);
}

double armtol_sampler_uniform(uint64_t seed, uint64_t number)
{
    return uniform_at(key_of(seed) + SPLITMIX_STEP * (number + 1));
}

void armtol_sampler_parameters(const armtol_sampler *sampler, uint64_t arm, double parameter_errors[])
{
    for (size_t k = 0; k < sampler->n_columns; k++) {
        parameter_errors[k] = 0;
    }
    for (size_t i = 0; i < sampler->n_links; i++) {
        const armtol_sampled_link *const link = &sampler->links[i];
        double errors[ARMTOL_PARAMETER_COUNT];
        for (size_t k = 0; k < link->n_drawn; k++) {
            const uint64_t state = sampler->key + SPLITMIX_STEP * (arm * sampler->n_columns + 1) + link->steps[k];
            errors[link->drawn[k]] = link->tolerances[k] * armtol_shape_value(&link->shapes[k], uniform_at(state));
        }
        draw_in_disc(link, errors);
        for (size_t k = 0; k < link->n_drawn; k++) {
            parameter_errors[link->columns[k]] = errors[link->drawn[k]];
        }
    }
}

/* What is drawn for the two is then a share of the disc's. */
static void make_disc(armtol_sampled_link *link)
{
    for (size_t k = 0; k < link->n_drawn; k++) {
        if (link->drawn[k] == ARMTOL_ALPHA || link->drawn[k] == ARMTOL_BETA) {
            link->disc = link->tolerances[k];
            link->tolerances[k] = 1;
        }
    }
}

void armtol_sampler_discs(const armtol_sampler *sampler, armtol_sampled_link prepared[], const bool discs[])
{
    for (size_t i = 0; i < sampler->n_links; i++) {
        for (size_t k = 0; k < prepared[i].n_drawn; k++) {
            if (discs[prepared[i].columns[k]]) {
                make_disc(&prepared[i]);
                break;
            }
        }
    }
}

/* ---- what is prepared ---- */

static armtol_status check_tolerances(const double tolerances[], size_t n)
{
    if (!all_finite(tolerances, n)) {
        return ARMTOL_NOT_FINITE;
    }
    for (size_t k = 0; k < n; k++) {
        if (tolerances[k] < 0) {
            return ARMTOL_BAD_TOLERANCE;
        }
    }
    return ARMTOL_OK;
}

static armtol_status check(const armtol_link links[], size_t n_links, const double tolerances[],
                           size_t n_columns, const armtol_tool_point *tool)
{
    const armtol_status status = columns_check(links, n_links, n_columns);
    if (status != ARMTOL_OK) {
        return status;
    }
    return all_finite(tool->offset, 3) ? check_tolerances(tolerances, n_columns) : ARMTOL_NOT_FINITE;
}

static armtol_sampled_link sampled_link_of(const armtol_pose_link *link, const double tolerances[])
{
    armtol_sampled_link sampled = {
        .a = link->a,
        .d = link->d,
        .cos_theta = link->cos_theta,
        .sin_theta = link->sin_theta,
        .cos_alpha = link->cos_alpha,
        .sin_alpha = link->sin_alpha,
        .cos_beta = link->cos_beta,
        .sin_beta = link->sin_beta,
    };
    for (size_t i = 0; i < ARMTOL_PARAMETER_COUNT; i++) {
        const size_t column = link->columns[i];
        if (column != NO_COLUMN && tolerances[column] > 0) {
            const size_t k = sampled.n_drawn++;
            sampled.off[i] = true;
            sampled.drawn[k] = (armtol_parameter)i;
            sampled.tolerances[k] = tolerances[column];
            sampled.columns[k] = column;
            sampled.steps[k] = SPLITMIX_STEP * (uint64_t)column;
        }
    }
    return sampled;
}

static void cross_meant_link(const armtol_pose_link *link, frame *frame)
{
    turn(frame->x, frame->y, &link->cos_theta, &link->sin_theta);
    advance(frame, &link->a, &link->d);
    turn(frame->y, frame->z, &link->cos_alpha, &link->sin_alpha);
    turn(frame->z, frame->x, &link->cos_beta, &link->sin_beta);
}

static armtol_transform transform_of(const frame *frame)
{
    armtol_transform transform = {{{0}, {0}, {0}, {0, 0, 0, 1}}};
    for (int i = 0; i < 3; i++) {
        transform.m[i][0] = frame->x[i];
        transform.m[i][1] = frame->y[i];
        transform.m[i][2] = frame->z[i];
        transform.m[i][3] = frame->origin[i];
    }
    return transform;
}

/* How far the short series reach: a single angle, and the turn that all angles together can make. */
#define SMALL_ERROR (1.0 / 128)
#define SMALL_TURN (1.0 / 4)

static void measure(armtol_sampler *sampler)
{
    double sum = 0;
    for (size_t i = 0; i < sampler->n_links; i++) {
        const armtol_sampled_link *const link = &sampler->links[i];
        for (size_t k = 0; k < link->n_drawn; k++) {
            if (!armtol_parameter_is_length(link->drawn[k])) {
                sampler->large_errors = sampler->large_errors || link->tolerances[k] > SMALL_ERROR;
                sum += link->tolerances[k];
            }
        }
    }
    sampler->large_turn = sum > SMALL_TURN;
}

armtol_status armtol_sampler_start(armtol_sampler *sampler, armtol_sampled_link prepared[],
                                   const armtol_link links[], size_t n_links, const double tolerances[],
                                   size_t n_columns, const armtol_tool_point *tool, uint64_t seed)
{
    const armtol_status status = check(links, n_links, tolerances, n_columns, tool);
    if (status != ARMTOL_OK) {
        return status;
    }
    frame frame = {.x = {1, 0, 0}, .y = {0, 1, 0}, .z = {0, 0, 1}};
    size_t column = 0;
    for (size_t i = 0; i < n_links; i++) {
        const armtol_pose_link link = pose_link_of(&links[i], &column);
        prepared[i] = sampled_link_of(&link, tolerances);
        cross_meant_link(&link, &frame);
    }
    const armtol_transform meant = transform_of(&frame);
    *sampler = (armtol_sampler){
        .links = prepared,
        .n_links = n_links,
        .n_columns = n_columns,
        .tool = *tool,
        .meant = meant,
        .start = armtol_transform_inverse(&meant, &armtol_errata_none),
        .seed = seed,
        .key = key_of(seed),
    };
    measure(sampler);
    return ARMTOL_OK;
}

void armtol_sampler_aim(armtol_sampler *sampler, const armtol_link meant[])
{
    sampler->meant = armtol_chain_transform(meant, sampler->n_links, &armtol_errata_none);
    sampler->start = armtol_transform_inverse(&sampler->meant, &armtol_errata_none);
    sampler->large_turn = true; /* nothing says how far the one is from the other */
}

/* ---- spreads ---- */

static size_t first_of_group(const armtol_error_spread spreads[], size_t column)
{
    size_t k = 0;
    while (k < column && (spreads[column].group == 0 || spreads[k].group != spreads[column].group)) {
        k++;
    }
    return k;
}

void armtol_sampler_spread(armtol_sampler *sampler, armtol_sampled_link prepared[], const armtol_error_spread spreads[])
{
    for (size_t i = 0; i < sampler->n_links; i++) {
        armtol_sampled_link *const link = &prepared[i];
        for (size_t k = 0; k < link->n_drawn; k++) {
            const armtol_error_spread *of = &spreads[link->columns[k]];
            link->steps[k] = SPLITMIX_STEP * (uint64_t)first_of_group(spreads, link->columns[k]);
            link->shapes[k] = armtol_shape_of(of);
            sampler->shaped = sampler->shaped || of->distribution != ARMTOL_UNIFORM;
        }
    }
}
