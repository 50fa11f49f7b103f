#include "lib/region/enclose.h"

#include "lib/region/boxes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/*
 * Branch and bound. The bound of a box is the largest sum at the corners of polygons about the arcs of its joints
 * (region.h, note 2): a sum of magnitudes of functions that are affine in each joint's cosine and sine is convex in
 * that pair, so that for given others it is largest at a corner of the joint's polygon, and joint by joint the same
 * holds for all. An arc of half width h that is cut into n has corners 1 / cos(h / n) out: the bound exceeds the
 * largest error in the box by some h^2 / (2 n^2) a joint, and by nothing where that is at ends of all arcs.
 */

typedef struct bounding {
    pose_search *search;
    const chain *chain;
    const enclose_target *target;
    corner_box box;
    corner_space space;
    size_t *at;
    double *range, *child, *pose, *nearer, *still; /* 2, 2, 1, 1 and 1 times n_variables */
    double *best; /* the caller's: where low is */
    boxes boxes;
    double low, closed; /* closed: the largest bound of boxes that are not halved any more */
    uint64_t looked_at;
    load_range *ends; /* where there are loads: what drives are at one end of a variable */
} bounding;

static bool start(bounding *work, pose_search *search, const enclose_target *target, double best[])
{
    const chain *chain = search->chain;
    const size_t n = chain->n_variables;
    *work = (bounding){.search = search, .chain = chain, .target = target, .best = best, .low = -1, .closed = -1};
    boxes_start(&work->boxes, n);
    work->box.links = calloc(chain->n_links, sizeof *work->box.links);
    work->at = calloc(CHAIN_DIRECTIONS + chain->n_links, sizeof *work->at);
    work->range = calloc(7 * n, sizeof *work->range);
    if (work->range == NULL) {
        return false;
    }
    work->child = work->range + 2 * n;
    work->pose = work->child + 2 * n;
    work->nearer = work->pose + n;
    work->still = work->nearer + n;
    if (chain->loaded) {
        work->ends = calloc(chain->loads->n_cases, chain->loads->n_drives * sizeof *work->ends);
    }
    const bool space = corner_space_make(&work->space, chain, CORNERS_MOST);
    return space && (!chain->loaded || work->ends != NULL) && work->box.links != NULL && work->at != NULL;
}

static void end(bounding *work)
{
    boxes_free(&work->boxes);
    free(work->box.links);
    free(work->at);
    free(work->range);
    free(work->ends);
    corner_space_free(&work->space);
}

/* ---- errors that are found ---- */

static void note_error(bounding *work, const double variables[], double error)
{
    if (error > work->low) {
        work->low = error;
        memcpy(work->best, variables, work->chain->n_variables * sizeof *variables);
    }
}

/* A pose that is better than all before is climbed on from. */
static void try_pose(bounding *work, const double variables[])
{
    const size_t size = work->chain->n_variables * sizeof *variables;
    memcpy(work->nearer, variables, size);
    if (!pose_into_region(work->search, work->nearer)) {
        return;
    }
    const double error = pose_error(work->search, work->nearer);
    if (error > work->low) {
        note_error(work, work->nearer, error);
        note_error(work, work->nearer, pose_climb(work->search, work->nearer));
    }
}

/*
 * Where a moment is 0 the play is a tolerance. By standard deviations that can be worse than any pose nearby: nothing
 * but a search for it gets there. In the worst case it comes to the same.
 */
static void try_balanced(bounding *work, const double range[])
{
    const chain *chain = work->chain;
    for (size_t i = 0; i < chain->loads->n_cases * chain->loads->n_drives; i++) {
        memcpy(work->still, work->pose, chain->n_variables * sizeof *work->still);
        if (work->space.loads.ranges[i].unsure && pose_balance(work->search, i, range, work->still)) {
            try_pose(work, work->still);
        }
    }
}

/* ---- a box ---- */

/* The corners where the bound is, or the points of the arcs next to them. */
static void pose_at_corners(const bounding *work, double pose[])
{
    for (size_t i = 0; i < CHAIN_DIRECTIONS; i++) {
        pose[i] = work->box.directions[i].values[work->at[i]];
    }
    for (size_t i = 0; i < work->chain->n_links; i++) {
        const chain_link *link = &work->chain->links[i];
        if (link->leads) {
            pose[link->variable] = work->box.links[i].values[work->at[CHAIN_DIRECTIONS + i]];
        }
    }
}

static void keep_corner(const arc *from, size_t corner, arc *to)
{
    to->count = 1;
    to->x[0] = from->x[corner];
    to->y[0] = from->y[corner];
    to->d[0] = from->d[corner];
}

static bool is_wide(const double range[], size_t n, size_t j)
{
    return range[n + j] - range[j] > 1e-12 * fmax(1, fabs(range[j]));
}

/* The sum at the bound's corners when one variable, or none if it is n, has another value, the others left there. */
static double with_value(bounding *work, size_t j, double value)
{
    corner_box *one = &work->search->box;
    for (size_t i = 0; i < CHAIN_DIRECTIONS; i++) {
        keep_corner(&work->box.directions[i], work->at[i], &one->directions[i]);
    }
    for (size_t i = 0; i < work->chain->n_links; i++) {
        keep_corner(&work->box.links[i], work->at[CHAIN_DIRECTIONS + i], &one->links[i]);
        if (work->chain->links[i].variable == j) {
            arc_of_link(&work->chain->links[i], value, value, 0, &one->links[i]);
        }
    }
    if (j < CHAIN_DIRECTIONS) {
        arc_of_angle(value, value, 0, &one->directions[j]);
    }
    one->count = one->of_links = 1;
    one->is_pose = true;
    return corners_largest(work->chain, one, &work->search->space, work->search->at);
}

/*
 * How much of the bound may be there for a variable's width, because of drives under a load: of what products of
 * elements and moments were enlarged by (load_sum.c), and of play whose side is not sure.
 */
static double loads_gain(bounding *work, const double range[], size_t j)
{
    const loads *loads = work->chain->loads;
    const load_range *whole = work->space.loads.ranges, *ends = work->search->space.loads.ranges;
    double gain = 0;
    with_value(work, j, range[j]);
    memcpy(work->ends, ends, loads->n_cases * loads->n_drives * sizeof *ends);
    with_value(work, j, range[work->chain->n_variables + j]);
    for (size_t i = 0; i < loads->n_cases * loads->n_drives; i++) {
        const load_drive *drive = &loads->drives[i % loads->n_drives];
        const double element = fabs(ends[i].element - work->ends[i].element) / 2;
        const double moment = fabs(ends[i].moment - work->ends[i].moment) / 2;
        gain += drive->give * (element * whole[i].moment_half + moment * whole[i].element_half);
        if (whole[i].unsure && whole[i].moment_half > 0) {
            gain += drive->play * fabs(ends[i].element) * fmin(1, moment / whole[i].moment_half);
        }
    }
    return gain / (double)loads->n_cases;
}

/* What of the bound is there for the variable's width. */
static double gain_of(bounding *work, const double range[], size_t j, double bound, double at_corners)
{
    const double arc = fmax(at_corners / bound - with_value(work, j, work->pose[j]) / bound, 0);
    return arc + (work->chain->loaded ? loads_gain(work, range, j) / bound : 0);
}

/*
 * Halving is of use where the bound's corner is off the arc and, if the tool is not in the region there, where it
 * moves the tool. Without either it is the widest part of the whole range.
 */
static size_t to_halve(bounding *work, const double range[], double bound)
{
    const chain *chain = work->chain;
    const size_t n = chain->n_variables;
    const bool inside = pose_is_in_region(work->search, work->pose);
    double most = 0;
    size_t best = n;
    const double at_corners = work->chain->loaded ? with_value(work, n, 0) : bound;
    if (!inside) {
        pose_levers(work->search, work->pose, work->nearer);
    }
    for (size_t j = 0; j < n; j++) {
        if (is_wide(range, n, j)) {
            const double width = range[n + j] - range[j];
            const double gain = bound > 0 ? gain_of(work, range, j, bound, at_corners) : 0;
            const double moved = inside ? 0 : width * work->nearer[j] / chain->reach;
            const double part = 1e-9 * width / (chain->high[j] - chain->low[j]), use = gain + moved + part;
            best = use > most ? j : best;
            most = fmax(use, most);
        }
    }
    return best;
}

/* Where there are too many corners. */
static size_t widest(const bounding *work, const double range[])
{
    const size_t n = work->chain->n_variables;
    size_t best = 0;
    for (size_t j = 1; j < n; j++) {
        best = range[n + j] - range[j] > range[n + best] - range[best] ? j : best;
    }
    return best;
}

static bool is_excluded(bounding *work)
{
    const armtol_region *region = work->search->region;
    if (!where_asks(region)) {
        return false;
    }
    corners_place(work->chain, &work->box, region->cone != NULL, &work->space);
    return where_excludes(region, &work->space, work->box.of_links, work->chain->blur * work->box.stretch,
                          work->chain->reach);
}

/* Of the largest sum at corners that lie so far out: elements are stretched, and shifts by their moments once more. */
static double rounding_of(const chain *chain, double stretch)
{
    return (chain->rounding + chain->shift_rounding * stretch) * stretch;
}

/* Up to here the boxes are as good as done. */
static double threshold(const bounding *work)
{
    const double near = work->low * (1 + work->target->gap), limit = work->target->limit;
    const double wished = work->low <= limit ? fmin(near, limit) : near;
    return fmax(wished, work->low + 8 * rounding_of(work->chain, 1));
}

/* Bounds the box, and keeps it where it is open. False where memory is short. */
static bool look_at(bounding *work, const double range[], double above)
{
    const size_t n = work->chain->n_variables;
    work->looked_at++;
    if (!corner_box_of(work->chain, range, range + n, CORNERS_MOST, &work->box)) {
        return boxes_add(&work->boxes, above, widest(work, range), range);
    }
    if (is_excluded(work)) {
        return true;
    }
    const double largest = corners_largest(work->chain, &work->box, &work->space, work->at);
    const double bound = fmin(above, largest * (1 + 1e-12) + rounding_of(work->chain, work->box.stretch));
    pose_at_corners(work, work->pose);
    if (bound > work->low) {
        try_pose(work, work->pose);
        if (work->chain->loaded && work->chain->squares) {
            try_balanced(work, range);
        }
    }
    const size_t halve = bound > threshold(work) ? to_halve(work, range, largest) : n;
    if (halve == n) { /* done, or as narrow as numbers are */
        work->closed = fmax(work->closed, bound);
        return true;
    }
    return boxes_add(&work->boxes, bound, halve, range);
}

static bool divide(bounding *work, const open_box *box)
{
    const size_t n = work->chain->n_variables, j = box->halve, size = 2 * n * sizeof *work->range;
    const double middle = work->range[j] + (work->range[n + j] - work->range[j]) / 2;
    memcpy(work->child, work->range, size);
    work->child[n + j] = middle;
    const bool enough = look_at(work, work->child, box->bound);
    memcpy(work->child, work->range, size);
    work->child[j] = middle;
    return look_at(work, work->child, box->bound) && enough;
}

/* ---- all of them ---- */

static double high_of(const bounding *work)
{
    const double open = work->boxes.count > 0 ? work->boxes.heap[0].bound : -1;
    return fmax(work->low, fmax(work->closed, open));
}

static bool may_go_on(const bounding *work, armtol_enclosure *found)
{
    const double high = high_of(work), open = work->low > 0 && isfinite(high) ? (high - work->low) / high : 1;
    if (work->looked_at >= work->target->most) {
        found->ended = ARMTOL_ENDED_MOST;
        return false;
    }
    if (work->target->progress != NULL && !work->target->progress(work->target->context, open, work->looked_at)) {
        found->ended = ARMTOL_ENDED_CALLER;
        return false;
    }
    return true;
}

static bool all_boxes(bounding *work, armtol_enclosure *found)
{
    const chain *chain = work->chain;
    const size_t n = chain->n_variables;
    memcpy(work->range, chain->low, n * sizeof *work->range);
    memcpy(work->range + n, chain->high, n * sizeof *work->range);
    bool enough = look_at(work, work->range, (double)INFINITY);
    while (enough && work->boxes.count > 0 && work->low <= work->target->too_much &&
           work->boxes.heap[0].bound > threshold(work) && may_go_on(work, found)) {
        const open_box box = boxes_take(&work->boxes, work->range);
        enough = divide(work, &box);
    }
    return enough;
}

/* Poses from which to climb before boxes are halved: what is found early need not be bounded. */
static void seed(bounding *work)
{
    enum { DRAWN = 12 };
    for (int i = 0; i < DRAWN && work->low <= work->target->too_much; i++) {
        if (pose_draw(work->search, work->pose)) {
            memcpy(work->nearer, work->pose, work->chain->n_variables * sizeof *work->pose);
            const double error = pose_climb(work->search, work->nearer);
            note_error(work, work->nearer, error);
        }
    }
}

armtol_status enclose(pose_search *search, const enclose_target *target, double variables[],
                      armtol_enclosure *found)
{
    bounding work;
    found->ended = ARMTOL_ENDED_GAP;
    bool enough = start(&work, search, target, variables);
    if (enough) {
        seed(&work);
        enough = all_boxes(&work, found);
        found->low = work.low;
        found->high = high_of(&work);
        found->boxes = work.looked_at;
    }
    end(&work);
    if (!enough) {
        return ARMTOL_NO_MEMORY;
    }
    return work.low >= 0 ? ARMTOL_OK : found->ended == ARMTOL_ENDED_GAP ? ARMTOL_OUT_OF_REACH : ARMTOL_NOT_SOLVED;
}

bool enclose_unseen(pose_search *search)
{
    const enclose_target target = {.gap = 0};
    const chain *chain = search->chain;
    bounding work;
    bool unseen = false;
    if (start(&work, search, &target, NULL) &&
        corner_box_of(chain, chain->low, chain->high, CORNERS_MOST, &work.box)) {
        const double largest = corners_largest(chain, &work.box, &work.space, work.at);
        unseen = largest <= 8 * chain->rounding * work.box.stretch;
    }
    end(&work);
    return unseen;
}
