#include "lib/region/load_sum.h"

#include "lib/region/corner_sum.h"
#include "lib/report/trigonometry.h"
#include "lib/tool/negligible.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/*
 * Method
 *    A drive gives way to its moment m and so shifts the error by c a m, a its element of A. Each of a and m is affine
 *    in the cosine and the sine of every joint, or in its travel (corner_sum.c; m is what gravity does on the twist of
 *    the joint, its lever the places of the masses, and a force at the tool point likewise). Their product is not. With
 *    a = a_0 + A x and m = m_0 + B y, for any numbers a_0, m_0, A and B,
 *
 *        a m = a_0 m + m_0 a - a_0 m_0 + A B x y,   x y <= (x + y)^2 / 4,   -x y <= (x - y)^2 / 4.
 *
 *    Squares of affine functions are convex, so that shift and -shift are no larger than functions that are convex in
 *    each joint's pair, and with the magnitudes of the tolerances beside them largest at corners. a_0 and m_0 are the
 *    middles of what a and m are at the corners, A and B half of the widths: what is added is A B at most, of second
 *    order in the size of the box, and nothing where a and m grow together.
 *
 *    Play p is p sign(m) in the shift where the load is sure to hold it, and comes to the tolerance where it is sure
 *    not to. Where neither is sure it takes the larger of both: p |a| on the side of the shift, or the tolerance with p
 *    in it.
 */

/* ---- memory ---- */

static bool get_links(load_space *space, const chain *chain)
{
    const size_t n = chain->n_links;
    space->weights = calloc(n, sizeof *space->weights);
    space->pushes = calloc(n, sizeof *space->pushes);
    space->levers = calloc(n, sizeof *space->levers);
    space->reaches = calloc(n, sizeof *space->reaches);
    space->carried = calloc(n, 4 * sizeof *space->carried);
    space->ranges = calloc(chain->loads->n_cases, chain->loads->n_drives * sizeof *space->ranges);
    return space->weights != NULL && space->pushes != NULL && space->levers != NULL && space->reaches != NULL &&
           space->carried != NULL && space->ranges != NULL;
}

bool load_space_make(load_space *space, const chain *chain, const size_t before[], const size_t after[], size_t most)
{
    size_t all = 0;
    if (!get_links(space, chain)) {
        return false;
    }
    for (size_t i = 0; i < chain->n_links; i++) {
        all += before[i] + after[i];
    }
    space->memory = malloc((6 * all + 5 * most) * sizeof *space->memory);
    if (space->memory == NULL) {
        return false;
    }
    double *from = space->memory;
    for (size_t i = 0; i < chain->n_links; i++) {
        space->weights[i] = cut(&from, before[i]);
        space->pushes[i] = cut(&from, before[i]);
        space->levers[i] = cut(&from, after[i]);
        space->reaches[i] = cut(&from, after[i]);
    }
    space->lengths = space->carried + chain->n_links;
    space->most = space->lengths + chain->n_links;
    space->least = space->most + chain->n_links;
    space->elements = from;
    space->moments = from + most;
    space->up = from + 2 * most;
    space->down = from + 3 * most;
    space->sums = from + 4 * most;
    return true;
}

void load_space_free(load_space *space)
{
    free(space->weights);
    free(space->pushes);
    free(space->levers);
    free(space->reaches);
    free(space->carried);
    free(space->ranges);
    free(space->memory);
}

/* ---- what a load case brings to a box ---- */

typedef struct loaded {
    const chain *chain;
    const corner_box *box;
    corner_space *corners;
    load_space *space;
    const loads *loads;
    size_t which;      /* the case */
    size_t directions; /* choices of the direction, in front of all links or behind them */
} loaded;

/* Choices of the links up to one, and of those behind it. */
static size_t choices(const corner_box *box, size_t from, size_t to)
{
    size_t count = 1;
    for (size_t i = from; i < to; i++) {
        count *= box->links[i].count;
    }
    return count;
}

/* A vector of the base in the turned frames of all links. */
static void carry_out(const loaded *work, const double v[3], const vectors turned[])
{
    const chain *chain = work->chain;
    double x = v[0], y = v[1], z = v[2];
    vectors first = {&x, &y, &z};
    size_t count = 1;
    for (size_t i = 0; i < chain->n_links; i++) {
        step_on(i > 0 ? &chain->links[i - 1] : NULL, &work->box->links[i], count, i > 0 ? &turned[i - 1] : &first,
                &turned[i]);
        count *= work->box->links[i].count;
    }
}

static vector scaled(const double v[3], double times)
{
    return (vector){times * v[0], times * v[1], times * v[2]};
}

static vector sum(vector a, vector b)
{
    return (vector){a.x + b.x, a.y + b.y, a.z + b.z};
}

/* Mass times place, the sum of what is at and behind each link; last: that of what the tool holds. */
static void carry_back(const loaded *work, const armtol_mass masses[], vector last, double mass, const vectors levers[],
                       double carried[])
{
    const chain *chain = work->chain;
    size_t count = 1;
    for (size_t i = chain->n_links; i-- > 0;) {
        const vector own = masses != NULL ? scaled(masses[i].center, masses[i].mass) : (vector){0, 0, 0};
        mass += masses != NULL ? masses[i].mass : 0;
        carried[i] = mass;
        if (i + 1 == chain->n_links) {
            put(&levers[i], 0, tilted(&chain->links[i], sum(last, own)));
            continue;
        }
        const arc *arc = &work->box->links[i + 1];
        for (size_t c = 0; c < arc->count; c++) {
            const vector moved = {carried[i + 1] * chain->links[i + 1].a, 0, carried[i + 1] * arc->d[c]};
            for (size_t k = 0; k < count; k++) {
                const vector seen = turned(arc, c, sum(get(&levers[i + 1], k), moved));
                put(&levers[i], c * count + k, tilted(&chain->links[i], sum(seen, own)));
            }
        }
        count *= arc->count;
    }
}

/* The longest, or the shortest, that each link is at the corners. */
static void find_lengths(const loaded *work, bool longest, double lengths[])
{
    for (size_t i = 0; i < work->chain->n_links; i++) {
        const arc *arc = &work->box->links[i];
        double d = fabs(arc->d[0]);
        for (size_t c = 1; c < arc->count; c++) {
            const bool crosses = arc->d[0] * arc->d[c] < 0;
            d = longest ? fmax(d, fabs(arc->d[c])) : crosses ? 0 : fmin(d, fabs(arc->d[c]));
        }
        lengths[i] = length_of(work->chain->links[i].a, d);
    }
}

static void take_case(const loaded *work)
{
    load_space *space = work->space;
    const armtol_mass *held = loads_payload(work->loads, work->which);
    const vector tool = scaled(work->loads->offset, 1);
    const double mass = held != NULL ? held->mass : 0;
    const vector there = held != NULL ? sum(scaled(work->loads->offset, mass), scaled(held->center, mass))
                                      : (vector){0, 0, 0};
    if (work->loads->pushed) {
        carry_out(work, work->loads->loading->force, space->pushes);
        carry_back(work, NULL, tool, 1, space->reaches, space->carried);
    }
    carry_out(work, work->loads->loading->gravity, space->weights);
    carry_back(work, work->loads->arm->masses, there, mass, space->levers, space->carried);
    find_lengths(work, true, space->lengths);
    loads_most(work->loads, work->which, space->lengths, space->most);
    if (!work->box->is_pose) {
        find_lengths(work, false, space->lengths);
        loads_most(work->loads, work->which, space->lengths, space->least);
    }
}

/* ---- elements and moments of a drive ---- */

static double element_of(const chain *chain, const chain_link *link, vector f, vector s)
{
    if (link->joint != ARMTOL_REVOLUTE) {
        return chain->angular ? 0 : f.z;
    }
    return chain->angular ? f.z : s.x * f.y - s.y * f.x + link->a * f.y;
}

static void repeat(double values[], size_t count, size_t times)
{
    for (size_t i = 1; i < times; i++) {
        memcpy(values + i * count, values, count * sizeof *values);
    }
}

static void find_elements(const loaded *work, size_t link, size_t front, size_t behind)
{
    const chain *chain = work->chain;
    const chain_link *at = &chain->links[link];
    const corner_space *corners = work->corners;
    double *elements = work->space->elements;
    if (chain->along_tool) { /* moments are those about the link's end: force and moment are behind */
        for (size_t b = 0; b < behind * work->directions; b++) {
            const vector f = get(&corners->behind[link], b), m = get(&corners->moments[link], b);
            const bool turns = at->joint == ARMTOL_REVOLUTE;
            elements[b] = chain->angular ? (turns ? m.z : 0) : turns ? m.z + at->a * f.y : f.z;
        }
        repeat(elements, behind * work->directions, front);
        return;
    }
    for (size_t f = 0; f < front * work->directions; f++) {
        for (size_t b = 0; b < behind; b++) {
            elements[f * behind + b] = element_of(chain, at, get(&corners->forces[link + 1], f),
                                                  get(&corners->behind[link], b));
        }
    }
}

static double moment_of(const loaded *work, size_t link, size_t front, size_t behind)
{
    const load_space *space = work->space;
    const chain_link *at = &work->chain->links[link];
    const vector g = get(&space->weights[link], front), p = get(&space->levers[link], behind);
    const double mass = space->carried[link];
    const bool turns = at->joint == ARMTOL_REVOLUTE;
    double moment = turns ? p.x * g.y - p.y * g.x + mass * at->a * g.y : mass * g.z;
    if (work->loads->pushed) {
        const vector f = get(&space->pushes[link], front), s = get(&space->reaches[link], behind);
        moment += turns ? s.x * f.y - s.y * f.x + at->a * f.y : f.z;
    }
    return moment;
}

static void find_moments(const loaded *work, size_t link, size_t front, size_t behind)
{
    const bool along_tool = work->chain->along_tool;
    const size_t each = along_tool ? work->directions : 1;
    double *to = work->space->moments;
    for (size_t f = 0; f < front; f++) {
        for (size_t b = 0; b < behind; b++) {
            const double moment = moment_of(work, link, f, b);
            for (size_t i = 0; i < each; i++) {
                *to++ = moment;
            }
        }
    }
    if (!along_tool) {
        repeat(work->space->moments, front * behind, work->directions);
    }
}

static void find_both(const loaded *work, size_t link)
{
    const size_t front = choices(work->box, 0, link + 1), behind = choices(work->box, link + 1, work->chain->n_links);
    find_elements(work, link, front, behind);
    find_moments(work, link, front, behind);
}

/* ---- ranges ---- */

static void find_range(const double values[], size_t count, double *middle, double *half)
{
    double low = values[0], high = values[0];
    for (size_t i = 1; i < count; i++) {
        low = values[i] < low ? values[i] : low;
        high = values[i] > high ? values[i] : high;
    }
    *middle = low + (high - low) / 2;
    *half = (high - low) / 2;
}

/* ---- on which side the play is ---- */

typedef enum side { HELD_BELOW = -1, NOT_HELD = 0, HELD_ABOVE = 1, NOT_SURE = 2 } side;

static side side_of_moment(const load_drive *drive, double moment)
{
    const double least = fabs(moment) - drive->doubt;
    return !(least > 0 && least >= drive->friction) ? NOT_HELD : moment > 0 ? HELD_ABOVE : HELD_BELOW;
}

/* What is no more than rounding leaves of 0 is 0, as in moments.c. */
static side side_of_pose(const loaded *work, const load_drive *drive, load_range *range)
{
    if (fabs(range->moment) <= negligible * work->space->most[drive->link]) {
        range->moment = 0;
    }
    return side_of_moment(drive, range->moment);
}

/*
 * A moment at corners is off by less than `rounding` of what it could be, once stretched, and that of moments.c by
 * twice as much (chain.c), where what is no more than 1e-12 of it is cleared.
 */
static side side_of_box(const loaded *work, const load_drive *drive, const load_range *range)
{
    const double most = work->space->most[drive->link], rounding = work->chain->moment_rounding;
    const double off = rounding * (2 + work->box->stretch) * most, cleared = negligible * most;
    const double least = fabs(range->moment) - range->moment_half, largest = fabs(range->moment) + range->moment_half;
    const bool held = least > off + cleared && side_of_moment(drive, least - off - cleared) == HELD_ABOVE;
    if (held) {
        return range->moment > 0 ? HELD_ABOVE : HELD_BELOW;
    }
    const bool is_nothing = largest + off <= negligible * work->space->least[drive->link];
    const bool doubtful = largest + off <= drive->doubt || largest + off - drive->doubt < drive->friction;
    return is_nothing || doubtful ? NOT_HELD : NOT_SURE;
}

/* ---- sums ---- */

/* The drive's own part of the sum, where no load holds its play: what that is more than where one does. */
static void add_free_play(const loaded *work, const load_drive *drive)
{
    const double factor = work->chain->factor, held = factor * drive->held, whole = factor * drive->free_play;
    const double more = work->chain->squares ? whole * whole - held * held : whole - held;
    double *sums = work->space->sums;
    for (size_t i = 0; i < work->box->count; i++) {
        const double a = fabs(work->space->elements[i]);
        sums[i] += work->chain->squares ? more * a * a : more * a;
    }
}

/* Play that lies on a side, and what the drive gives way by. */
static void add_shift(const loaded *work, const load_drive *drive, const load_range *range, double play)
{
    const double give = drive->give, a_0 = range->element, m_0 = range->moment;
    const bool bent = range->element_half >= DBL_MIN && range->moment_half >= DBL_MIN;
    const double quarter = bent ? give * range->element_half * range->moment_half / 4 : 0;
    const double across = bent ? 1 / range->element_half : 0, along = bent ? 1 / range->moment_half : 0;
    const double *restrict elements = work->space->elements, *restrict moments = work->space->moments;
    double *restrict up = work->space->up, *restrict down = work->space->down;
    for (size_t i = 0; i < work->box->count; i++) {
        const double a = elements[i], m = moments[i], x = (a - a_0) * across, y = (m - m_0) * along;
        const double flat = give * (a_0 * m + m_0 * (a - a_0)) + play * a;
        up[i] += flat + quarter * ((x + y) * (x + y));
        down[i] += quarter * ((x - y) * (x - y)) - flat;
    }
}

static load_range *range_of(const loaded *work, size_t drive)
{
    return &work->space->ranges[work->which * work->loads->n_drives + drive];
}

static void add_drive(const loaded *work, size_t number)
{
    const load_drive *drive = &work->loads->drives[number];
    load_range *range = range_of(work, number);
    find_both(work, drive->link);
    find_range(work->space->elements, work->box->count, &range->element, &range->element_half);
    find_range(work->space->moments, work->box->count, &range->moment, &range->moment_half);
    const side side = work->box->is_pose ? side_of_pose(work, drive, range) : side_of_box(work, drive, range);
    range->unsure = side == NOT_SURE;
    if (work->box->is_pose) {
        work->space->moments[0] = range->moment;
    }
    add_shift(work, drive, range, side == NOT_SURE ? 0 : (double)side * drive->play);
    if (side == NOT_HELD) {
        add_free_play(work, drive);
    }
}

/* For each choice the larger of play on the side of the shift and of the tolerance with play in it. */
static void add_unsure(const loaded *work, const load_drive *drive)
{
    const double factor = work->chain->factor, held = factor * drive->held, whole = factor * drive->free_play;
    const double square = whole * whole - held * held;
    const load_space *space = work->space;
    find_both(work, drive->link);
    for (size_t i = 0; i < work->box->count; i++) {
        const double a = fabs(space->elements[i]), root = space->sums[i];
        const double of_rss = sqrt(root * root + square * a * a) - root;
        const double free_play = work->chain->squares ? of_rss : (whole - held) * a;
        const double more = fmax(drive->play * a, free_play);
        space->up[i] += more;
        space->down[i] += more;
    }
}

static void add_case(const loaded *work, const double sums[], size_t n_sums)
{
    load_space *space = work->space;
    const size_t count = work->box->count;
    take_case(work);
    memcpy(space->sums, sums, n_sums * sizeof *sums);
    repeat(space->sums, n_sums, count / n_sums);
    memset(space->up, 0, count * sizeof *space->up);
    memset(space->down, 0, count * sizeof *space->down);
    for (size_t d = 0; d < work->loads->n_drives; d++) {
        add_drive(work, d);
    }
    for (size_t i = 0; i < count && work->chain->squares; i++) {
        space->sums[i] = sqrt(space->sums[i]);
    }
    for (size_t d = 0; d < work->loads->n_drives; d++) {
        if (range_of(work, d)->unsure) {
            add_unsure(work, &work->loads->drives[d]);
        }
    }
}

double load_sum_largest(const chain *chain, const corner_box *box, corner_space *space, const double sums[],
                        size_t n_sums, size_t *best)
{
    loaded work = {.chain = chain, .box = box, .corners = space, .space = &space->loads, .loads = chain->loads,
                   .directions = box->directions[0].count * box->directions[1].count};
    double largest = -1;
    *best = 0;
    for (work.which = 0; work.which < chain->loads->n_cases; work.which++) {
        add_case(&work, sums, n_sums);
        for (size_t i = 0; i < box->count; i++) {
            const double up = space->loads.up[i], down = space->loads.down[i];
            const double error = space->loads.sums[i] + (up > down ? up : down);
            if (error > largest) {
                largest = error;
                *best = i;
            }
        }
    }
    return largest;
}
