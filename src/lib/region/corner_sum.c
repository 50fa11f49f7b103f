#include "lib/region/corner_sum.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/*
 * The error of the tool along a direction, by a column of A, is what a wrench does on the twist of the column: a
 * force F of size 1 along the direction at the tool point or, for a rotation, a moment. In the frame of a link,
 * turned by theta, with S from the link's end to the tool point and M = S x F + G the moment about that end, it is
 *
 *     theta  M_z + a F_y     d  F_z     a  F_x     alpha  M_x     beta  cos(alpha) M_y + sin(alpha) M_z.
 *
 * F of a direction of the base depends on the joints up to the link and S on those behind it; of a direction of the
 * tool all depends on those behind it. Each is linear in the cosine and the sine of every joint's angle, or affine in
 * its travel, and no joint is in both: a product is affine in each joint too.
 */

/* ---- memory ---- */

/* So many choices, and those of a link. A box has no more than `most`. */
static size_t with_link(const chain *chain, size_t link, size_t count, size_t most)
{
    const size_t j = chain->links[link].variable;
    const bool moves = j != CHAIN_FIXED && chain->low[j] < chain->high[j];
    return !moves ? count : count < most / ARC_CORNERS ? count * ARC_CORNERS : most;
}

/*
 * The most choices up to each link's corner and behind it, those of the direction with both, and all in all: they are
 * behind every link where the error is along the tool's axes, else in front.
 */
static size_t count_most(const chain *chain, size_t most, size_t before[], size_t after[])
{
    const size_t directions = ARC_CORNERS * ARC_CORNERS, first = directions < most ? directions : most;
    size_t count = first, all = 0;
    for (size_t i = 0; i < chain->n_links; i++) {
        before[i] = count = with_link(chain, i, count, most);
        all += count;
    }
    count = first;
    for (size_t i = chain->n_links; i-- > 0;) {
        after[i] = count;
        all += 2 * count;
        count = with_link(chain, i, count, most);
    }
    return all;
}

static bool get_counts(corner_space *space, size_t n_links)
{
    space->before = calloc(n_links, sizeof *space->before);
    space->after = calloc(n_links, sizeof *space->after);
    space->behind = calloc(n_links, sizeof *space->behind);
    space->moments = calloc(n_links, sizeof *space->moments);
    space->forces = calloc(n_links + 1, sizeof *space->forces);
    return space->before != NULL && space->after != NULL && space->behind != NULL && space->moments != NULL &&
           space->forces != NULL;
}

bool corner_space_make(corner_space *space, const chain *chain, size_t most)
{
    *space = (corner_space){.most = most};
    if (!get_counts(space, chain->n_links)) {
        return false;
    }
    const size_t all = count_most(chain, most, space->before, space->after);
    space->memory = malloc((3 * all + 11 * most) * sizeof *space->memory);
    if (space->memory == NULL) {
        return false;
    }
    double *from = space->memory;
    space->forces[0] = cut(&from, most);
    for (size_t i = 0; i < chain->n_links; i++) {
        space->forces[i + 1] = cut(&from, space->before[i]);
        space->behind[i] = cut(&from, space->after[i]);
        space->moments[i] = cut(&from, space->after[i]);
    }
    space->points = cut(&from, most);
    space->tools = cut(&from, most);
    space->sums = from;
    space->parts = from + most;
    return chain->loads == NULL || load_space_make(&space->loads, chain, space->before, space->after, most);
}

void corner_space_free(corner_space *space)
{
    free(space->before);
    free(space->after);
    free(space->behind);
    free(space->moments);
    free(space->forces);
    free(space->memory);
    load_space_free(&space->loads);
}

/* ---- corners ---- */

static void count_corners(const chain *chain, corner_box *box)
{
    box->is_pose = false;
    box->of_links = 1;
    box->stretch = box->directions[0].stretch * box->directions[1].stretch;
    for (size_t i = 0; i < chain->n_links; i++) {
        box->of_links *= box->links[i].count;
        box->stretch *= box->links[i].stretch;
    }
    box->count = box->of_links * box->directions[0].count * box->directions[1].count;
}

static void take_corners(const chain *chain, const double low[], const double high[], size_t fewer, corner_box *box)
{
    for (size_t i = 0; i < CHAIN_DIRECTIONS; i++) {
        const size_t between = arc_tangents((high[i] - low[i]) / 2);
        arc_of_angle(low[i], high[i], between > fewer ? between - fewer : 0, &box->directions[i]);
    }
    for (size_t i = 0; i < chain->n_links; i++) {
        const chain_link *link = &chain->links[i];
        const bool moves = link->variable != CHAIN_FIXED;
        const double from = moves ? low[link->variable] : 0, to = moves ? high[link->variable] : 0;
        const size_t between = arc_tangents(fabs(link->times) * (to - from) / 2);
        arc_of_link(link, from, to, between > fewer ? between - fewer : 0, &box->links[i]);
    }
    count_corners(chain, box);
}

/* Where there are too many, tangents are left out of all arcs alike. */
bool corner_box_of(const chain *chain, const double low[], const double high[], size_t most, corner_box *box)
{
    for (size_t fewer = 0; fewer < ARC_CORNERS; fewer++) {
        take_corners(chain, low, high, fewer, box);
        if (box->count <= most) {
            return box->stretch < 1e6;
        }
    }
    return false;
}

void corner_box_at(const chain *chain, const double variables[], corner_box *box)
{
    take_corners(chain, variables, variables, 0, box);
    box->is_pose = true;
}

/* ---- the links behind ---- */

/* What lies behind a link, seen from its start and along the frame before it, for each of its corners. */
static void step_back(const chain_link *link, const arc *arc, size_t count, const vectors *from, bool free_vector,
                      const chain_link *before, const vectors *to)
{
    for (size_t c = 0; c < arc->count; c++) {
        const double a = free_vector ? 0 : link->a, d = free_vector ? 0 : arc->d[c];
        for (size_t i = 0; i < count; i++) {
            const vector end = get(from, i), start = {end.x + a, end.y, end.z + d}, seen = turned(arc, c, start);
            put(to, c * count + i, before != NULL ? tilted(before, seen) : seen);
        }
    }
}

static void walk_back(const chain *chain, const corner_box *box, vector last, bool free_vector, corner_space *space,
                      vectors behind[], const vectors *base)
{
    const size_t n = chain->n_links;
    put(&behind[n - 1], 0, tilted(&chain->links[n - 1], last));
    space->after[n - 1] = 1;
    for (size_t i = n - 1; i > 0; i--) {
        step_back(&chain->links[i], &box->links[i], space->after[i], &behind[i], free_vector, &chain->links[i - 1],
                  &behind[i - 1]);
        space->after[i - 1] = space->after[i] * box->links[i].count;
    }
    if (base != NULL) {
        step_back(&chain->links[0], &box->links[0], space->after[0], &behind[0], free_vector, NULL, base);
    }
}

static vector tool_of(const chain *chain)
{
    return (vector){chain->offset[0], chain->offset[1], chain->offset[2]};
}

void corners_place(const chain *chain, const corner_box *box, bool turned_too, corner_space *space)
{
    if (turned_too) {
        walk_back(chain, box, (vector){0, 0, 1}, true, space, space->moments, &space->tools);
    }
    walk_back(chain, box, tool_of(chain), false, space, space->behind, &space->points);
}

/* ---- sums of columns ---- */

static double counted(const chain *chain, double weight, double element)
{
    const double part = weight * fabs(element);
    return chain->squares ? part * part : part;
}

static double of_force(const chain *chain, const chain_link *link, vector f)
{
    return counted(chain, link->weights[ARMTOL_A], f.x) + counted(chain, link->weights[ARMTOL_D], f.z);
}

static double of_moment(const chain *chain, const chain_link *link, vector m, double along)
{
    return counted(chain, link->weights[ARMTOL_THETA], m.z + link->a * along) +
           counted(chain, link->weights[ARMTOL_ALPHA], m.x) +
           counted(chain, link->weights[ARMTOL_BETA], link->cos_alpha * m.y + link->sin_alpha * m.z);
}

/* For one force and all tool points: the loop that takes the time. */
static void add_magnitudes(const chain_link *link, vector f, double first, size_t count, const vectors *s,
                           double sums[])
{
    const double *restrict x = s->x, *restrict y = s->y, *restrict z = s->z;
    const double of_theta = link->weights[ARMTOL_THETA], of_alpha = link->weights[ARMTOL_ALPHA];
    const double of_beta = link->weights[ARMTOL_BETA], about = link->a * f.y, c = link->cos_alpha, e = link->sin_alpha;
    for (size_t i = 0; i < count; i++) {
        const double mx = y[i] * f.z - z[i] * f.y, my = z[i] * f.x - x[i] * f.z, mz = x[i] * f.y - y[i] * f.x;
        sums[i] += first + of_theta * fabs(mz + about) + of_alpha * fabs(mx) + of_beta * fabs(c * my + e * mz);
    }
}

static void add_squares(const chain *chain, const chain_link *link, vector f, double first, size_t count,
                        const vectors *s, double sums[])
{
    for (size_t i = 0; i < count; i++) {
        const vector m = {s->y[i] * f.z - s->z[i] * f.y, s->z[i] * f.x - s->x[i] * f.z, s->x[i] * f.y - s->y[i] * f.x};
        sums[i] += first + of_moment(chain, link, m, f.y);
    }
}

/* ---- errors along the base's axes ---- */

/* The directions at their corners. */
static size_t put_directions(const chain *chain, const corner_box *box, const vectors *to)
{
    size_t count = 0;
    for (size_t i = 0; i < box->directions[0].count; i++) {
        for (size_t j = 0; j < box->directions[1].count; j++) {
            const arc *about = &box->directions[0], *up = &box->directions[1];
            double v[3] = {0, 0, 0};
            v[chain->axes[0]] = up->x[j] * about->x[i];
            if (chain->n_axes > 1) {
                v[chain->axes[1]] = up->x[j] * about->y[i];
            }
            if (chain->n_axes > 2) {
                v[chain->axes[2]] = up->y[j];
            }
            put(to, count++, (vector){v[0], v[1], v[2]});
        }
    }
    return count;
}

static void add_link(const chain *chain, const chain_link *link, vector f, size_t count, const vectors *behind,
                     double sums[])
{
    if (chain->angular) {
        const double part = of_moment(chain, link, f, 0);
        for (size_t i = 0; i < count; i++) {
            sums[i] += part;
        }
    } else if (chain->squares) {
        add_squares(chain, link, f, of_force(chain, link, f), count, behind, sums);
    } else {
        add_magnitudes(link, f, of_force(chain, link, f), count, behind, sums);
    }
}

/* A choice is numbered by its corners, those of the direction first. */
static size_t sum_along_base(const chain *chain, const corner_box *box, corner_space *space)
{
    size_t before = put_directions(chain, box, &space->forces[0]);
    walk_back(chain, box, tool_of(chain), false, space, space->behind, NULL);
    memset(space->sums, 0, box->count * sizeof *space->sums);
    for (size_t i = 0; i < chain->n_links; i++) {
        const vectors *to = &space->forces[i + 1];
        step_on(i > 0 ? &chain->links[i - 1] : NULL, &box->links[i], before, &space->forces[i], to);
        before *= box->links[i].count;
        for (size_t k = 0; k < before; k++) {
            add_link(chain, &chain->links[i], get(to, k), space->after[i], &space->behind[i],
                     space->sums + k * space->after[i]);
        }
    }
    return box->count;
}

/* ---- errors along the tool's axes ---- */

static double along_tool(const chain *chain, const chain_link *link, vector force, vector moment)
{
    return chain->angular ? of_moment(chain, link, moment, 0)
                          : of_force(chain, link, force) + of_moment(chain, link, moment, force.y);
}

/* Force and moment about a link's start, along the frame before it, for each of its corners. */
static size_t carry(const chain *chain, const corner_box *box, size_t link, size_t count, corner_space *space)
{
    const chain_link *at = &chain->links[link], *before = &chain->links[link - 1];
    const arc *arc = &box->links[link];
    for (size_t c = 0; c < arc->count; c++) {
        const vector lever = {at->a, 0, arc->d[c]};
        for (size_t i = 0; i < count; i++) {
            const vector force = get(&space->behind[link], i), arm = cross(lever, force);
            const vector own = get(&space->moments[link], i);
            const vector moment = {own.x + arm.x, own.y + arm.y, own.z + arm.z};
            put(&space->behind[link - 1], c * count + i, tilted(before, turned(arc, c, force)));
            put(&space->moments[link - 1], c * count + i, tilted(before, turned(arc, c, moment)));
            space->parts[c * count + i] = space->sums[i];
        }
    }
    memcpy(space->sums, space->parts, arc->count * count * sizeof *space->sums);
    return arc->count * count;
}

/* A choice is numbered by its corners, those of the direction last; the first link's turn is not seen. */
static size_t sum_along_tool(const chain *chain, const corner_box *box, corner_space *space)
{
    const size_t n = chain->n_links;
    size_t count = put_directions(chain, box, &space->forces[0]);
    for (size_t i = 0; i < count; i++) {
        const vector direction = get(&space->forces[0], i), none = {0, 0, 0};
        const vector force = chain->angular ? none : direction;
        const vector moment = chain->angular ? direction : cross(tool_of(chain), direction);
        put(&space->behind[n - 1], i, tilted(&chain->links[n - 1], force));
        put(&space->moments[n - 1], i, tilted(&chain->links[n - 1], moment));
        space->sums[i] = 0;
    }
    for (size_t link = n; link-- > 0;) {
        for (size_t i = 0; i < count; i++) {
            space->sums[i] += along_tool(chain, &chain->links[link], get(&space->behind[link], i),
                                         get(&space->moments[link], i));
        }
        count = link > 0 ? carry(chain, box, link, count, space) : count;
    }
    return count;
}

/* ---- the largest ---- */

static size_t take_digit(size_t *number, size_t count)
{
    const size_t digit = *number % count;
    *number /= count;
    return digit;
}

static void take_links(const corner_box *box, size_t n_links, size_t first, size_t *number, size_t at[])
{
    for (size_t i = n_links; i-- > first;) {
        at[CHAIN_DIRECTIONS + i] = take_digit(number, box->links[i].count);
    }
}

static void take_directions(const corner_box *box, size_t *number, size_t at[])
{
    at[1] = take_digit(number, box->directions[1].count);
    at[0] = take_digit(number, box->directions[0].count);
}

static void decode(const chain *chain, const corner_box *box, size_t number, size_t at[])
{
    if (chain->along_tool) {
        take_directions(box, &number, at);
        at[CHAIN_DIRECTIONS] = 0;
        take_links(box, chain->n_links, chain->loaded ? 0 : 1, &number, at);
    } else {
        take_links(box, chain->n_links, 0, &number, at);
        take_directions(box, &number, at);
    }
}

double corners_largest(const chain *chain, const corner_box *box, corner_space *space, size_t at[])
{
    const size_t count = chain->along_tool ? sum_along_tool(chain, box, space) : sum_along_base(chain, box, space);
    size_t best = 0;
    if (chain->loaded) {
        const double largest = load_sum_largest(chain, box, space, space->sums, count, &best);
        decode(chain, box, best, at);
        return largest;
    }
    for (size_t i = 1; i < count; i++) {
        best = space->sums[i] > space->sums[best] ? i : best;
    }
    decode(chain, box, best, at);
    return chain->squares ? sqrt(space->sums[best]) : space->sums[best];
}
