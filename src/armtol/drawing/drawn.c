#include "armtol/drawing/drawn.h"

#include "armtol/drawing.h"

#include <math.h>

/* d of a link of parallel axes is none of their distance. */
static double distance_d(const armtol_link *link)
{
    return drawing_is_parallel(link) ? 0 : link->d;
}

/* ---- from a drawing ---- */

static double farther_end(armtol_range range)
{
    return fmax(-range.low, range.high) + 0; /* no -0 */
}

/* What a or d may be off by: the farther end of its range, to either side. */
static double length_of(const armtol_link *link, const drawing_row *row, armtol_parameter parameter)
{
    const double d = distance_d(link), distance = row->distance;
    const bool is_a = parameter == ARMTOL_A;
    if (row->split == DRAWING_SPLIT_EVEN) {
        return farther_end(armtol_drawing_length_both(link->a, d, distance));
    }
    if (row->split != (is_a ? DRAWING_SPLIT_A : DRAWING_SPLIT_D)) {
        return 0; /* exact */
    }
    return farther_end(is_a ? armtol_drawing_length(link->a, d, distance)
                            : armtol_drawing_length(d, link->a, distance));
}

static bool has_beta(const armtol_link *link)
{
    return drawing_is_parallel(link);
}

/* Whether the drawing says something of the parameter, and what. */
static bool tolerance_of(const armtol_link *link, const drawing_row *row, armtol_parameter parameter, double *tolerance)
{
    const bool is_length = parameter == ARMTOL_A || parameter == ARMTOL_D;
    const bool is_angle = parameter == ARMTOL_ALPHA || parameter == ARMTOL_BETA;
    if (armtol_joint_moves(link->joint, parameter) || isnan(is_length ? row->distance : row->angle)) {
        return false;
    }
    if (is_length) {
        *tolerance = length_of(link, row, parameter);
    } else if (is_angle) {
        *tolerance = has_beta(link) ? armtol_drawing_radius(row->angle) : row->angle;
    }
    return is_length || is_angle;
}

void drawn_take(const drawing *drawing, const armtol_arm *arm, const armtol_column columns[], size_t n_columns,
                const drawn *into)
{
    for (size_t i = 0; i < drawing->n_rows; i++) {
        const drawing_row *row = &drawing->rows[i];
        const armtol_link *link = &arm->links[row->link];
        for (size_t k = 0; k < n_columns; k++) {
            const bool is = columns[k].link == row->link &&
                            tolerance_of(link, row, columns[k].parameter, &into->tolerances[k]);
            into->drawn[k] = into->drawn[k] || is;
            into->discs[k] = into->discs[k] || (is && columns[k].parameter == ARMTOL_ALPHA && has_beta(link));
        }
    }
}

/* ---- to a drawing ---- */

/* The tolerance of a parameter that is made; nan where there is none. */
static double made(const armtol_answer *answer, const armtol_link *link, size_t number, armtol_parameter parameter)
{
    double tolerance = (double)NAN;
    for (size_t k = 0; k < answer->n_columns; k++) {
        const armtol_column *column = &answer->columns[k];
        if (column->link == number && column->parameter == parameter && !armtol_joint_moves(link->joint, parameter)) {
            tolerance = answer->tolerances[k];
        }
    }
    return tolerance;
}

static double finite_or_nan(double value)
{
    return isfinite(value) ? value : (double)NAN;
}

static drawing_split split_for(const armtol_link *link, double of_a, double of_d)
{
    if (!drawing_splits_evenly(link)) {
        return drawing_only_split(link);
    }
    return of_d == 0 && of_a > 0 ? DRAWING_SPLIT_A : of_a == 0 && of_d > 0 ? DRAWING_SPLIT_D : DRAWING_SPLIT_EVEN;
}

static double distance_for(const armtol_link *link, drawing_split split, double of_a, double of_d)
{
    const double d = distance_d(link);
    return split == DRAWING_SPLIT_A   ? armtol_drawing_distance(link->a, d, of_a)
           : split == DRAWING_SPLIT_D ? armtol_drawing_distance(d, link->a, of_d)
                                      : armtol_drawing_distance_both(link->a, d, fmin(of_a, of_d));
}

drawing_row drawn_row(const armtol_answer *answer, const armtol_arm *arm, size_t number)
{
    const armtol_link *link = &arm->links[number];
    const double of_a = made(answer, link, number, ARMTOL_A), of_d = made(answer, link, number, ARMTOL_D);
    const double alpha = made(answer, link, number, ARMTOL_ALPHA), beta = made(answer, link, number, ARMTOL_BETA);
    const double both = fmin(alpha, beta); /* a disc in the rectangle of the two; fmin passes nan over */
    drawing_row row = {.link = number, .distance = (double)NAN};
    const drawing_split split = split_for(link, of_a, of_d);
    if (split != DRAWING_SPLIT_NONE) {
        row.distance = finite_or_nan(distance_for(link, split, of_a, of_d));
    }
    row.split = isnan(row.distance) ? DRAWING_SPLIT_NONE : split;
    row.angle = isinf(both) ? (double)NAN : has_beta(link) ? armtol_drawing_angle(both) : fmin(both, 1.57);
    return row;
}
