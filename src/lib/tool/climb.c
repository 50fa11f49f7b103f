#include "armtol/corners.h"

#include "armtol/error_matrix.h"
#include "armtol/link_transform.h"
#include "armtol/tool_error.h"
#include "armtol/transform.h"
#include "lib/tool/built.h"

#include <math.h>
#include <stdbool.h>

/*
 * Method
 *    One error after the other, link by link, is tried at both ends of its range, and kept where the size grows; round
 *    after round until one gains nothing. What is before a link and what is behind it are kept, so that a trial costs
 *    three products of matrices, whatever the length of the chain.
 *
 * Special cases
 *    A gain below 1e-9 is none: it may be rounding. After 100 rounds it ends. A size of nan ends it at once.
 *
 * Accuracy
 *    It finds a corner that is a local maximum; from where A's signs point, in 60 arms of two links, the largest of all
 *    corners to 1e-6 of it (test_the_worst_corner_is_the_worst_of_all). What is returned is armtol_tool_error's.
 */

/* What is climbed on. */
typedef struct slope {
    const armtol_link *links;
    size_t n_links;
    const armtol_tool_point *tool;
    const double *shifts, *tolerances;
    size_t n_columns;
    armtol_error_size size;
    const void *context;
} slope;

static double size_at(const slope *slope, const double errors[])
{
    double error[6];
    const armtol_status status =
        armtol_tool_error(slope->links, slope->n_links, errors, slope->n_columns, slope->tool, error);
    return status == ARMTOL_OK ? slope->size(error, slope->context) : (double)NAN;
}

/*
 * A link in its chain: an error of it is tried between what comes before and what comes behind, in the same time
 * however long the chain is.
 */
typedef struct place {
    armtol_transform meant, before, behind;
    size_t link, column;
} place;

static armtol_transform step_of(const slope *slope, const place *place, const double errors[])
{
    size_t count;
    const armtol_link link = built_link(&slope->links[place->link], errors + place->column, &count);
    return armtol_link_transform(&link, &armtol_errata_none);
}

static armtol_transform product(const armtol_transform *a, const armtol_transform *b)
{
    return armtol_transform_product(a, b, &armtol_errata_none);
}

/* The size as size_at has it, but for the rounding of the ways to and from the link. */
static double size_in(const slope *slope, const place *place, const double errors[])
{
    double error[6];
    const armtol_transform step = step_of(slope, place, errors), up_to = product(&place->before, &step),
                           built = product(&up_to, &place->behind);
    built_error(&built, &place->meant, slope->tool, error);
    return slope->size(error, slope->context);
}

static bool is_more(double changed, double most)
{
    static const double least_gain = 1e-9; /* less may be rounding, and not end */
    return changed > most * (1 + least_gain);
}

/* Give one error the sign that makes more of it, if any does. Returns what it is then: size_at has the last word. */
static double climb_one(const slope *slope, const place *place, double most, size_t k, double errors[])
{
    const double shift = slope->shifts != NULL ? slope->shifts[k] : 0;
    for (int sign = -1; sign <= 1; sign += 2) {
        const double before = errors[k], end = shift + sign * slope->tolerances[k];
        if (before == end) {
            continue;
        }
        errors[k] = end;
        const double changed = is_more(size_in(slope, place, errors), most) ? size_at(slope, errors) : most;
        if (is_more(changed, most)) {
            most = changed;
        } else {
            errors[k] = before;
        }
    }
    return most;
}

/* One round, link by link: what is behind a link is the inverse of its step off what was behind the one before. */
static double climb_links(const slope *slope, double most, double errors[])
{
    place place = {
        .meant = armtol_chain_transform(slope->links, slope->n_links, &armtol_errata_none),
        .before = armtol_transform_identity(),
        .behind = built_chain(slope->links, slope->n_links, errors),
    };
    for (; place.link < slope->n_links; place.link++) {
        const size_t count = armtol_column_count(&slope->links[place.link], 1);
        const armtol_transform meant = step_of(slope, &place, errors);
        const armtol_transform back = armtol_transform_inverse(&meant, &armtol_errata_none);
        place.behind = product(&back, &place.behind);
        for (size_t k = 0; k < count; k++) {
            most = climb_one(slope, &place, most, place.column + k, errors);
        }
        const armtol_transform step = step_of(slope, &place, errors);
        place.before = product(&place.before, &step);
        place.column += count;
    }
    return most;
}

double armtol_climb(const armtol_link links[], size_t n_links, const armtol_tool_point *tool, const double shifts[],
                    const double tolerances[], size_t n_columns, armtol_error_size size, const void *context,
                    double errors[])
{
    enum { MOST_ROUNDS = 100 }; /* two or three do, where errors are small */
    const slope slope = {links, n_links, tool, shifts, tolerances, n_columns, size, context};
    double most = size_at(&slope, errors), before = -1;
    for (int round = 0; round < MOST_ROUNDS && most > before; round++) {
        before = most;
        most = climb_links(&slope, most, errors);
    }
    return most;
}
