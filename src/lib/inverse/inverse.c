#include "armtol/inverse.h"

#include "lib/inverse/own.h"
#include "lib/inverse/prepare.h"
#include "lib/inverse/search.h"
#include "lib/pi.h"
#include "lib/report/finite.h"
#include "lib/report/trigonometry.h"
#include "lib/spread/splitmix.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/*
 * Starts that have to bring nothing new; of an arm with more joints than components, which arrives from nearly every
 * start; and those that are made where nothing at all is found.
 */
enum { LEAST_STARTS = 64, REDUNDANT_STARTS = 16, VAIN_STARTS = 256, MOST_REFINEMENTS = 50 };

#define USUAL_WITHIN 1e-10

struct armtol_inverse {
    chain chain;
    search search;
    size_t enough;           /* branches */
    const armtol_robot *own; /* NULL but for an arm of 1987 whose own way is wanted */
    double *memory;          /* what chain, search and the following have of doubles */
    double *found;           /* MOST_BRANCHES x n_joints, a place for each branch */
    double *best, *way;      /* n_joints: the nearest so far, and where a start has got to */
};

/* ---- memory ---- */

static double *take(double **memory, size_t count)
{
    double *taken = *memory;
    *memory += count;
    return taken;
}

static void lay_out(armtol_inverse *inverse, bool *held)
{
    const size_t n = inverse->chain.n_joints;
    double *left = inverse->memory;
    inverse->chain.axes = take(&left, 6 * inverse->chain.n_links);
    inverse->chain.jacobian = take(&left, 6 * n);
    inverse->search = (search){.chain = &inverse->chain, .held = held};
    inverse->search.trial = take(&left, n);
    inverse->search.step = take(&left, n);
    inverse->search.pull = take(&left, n);
    inverse->search.last = take(&left, n);
    inverse->best = take(&left, n);
    inverse->way = take(&left, n);
    inverse->found = left;
}

/* An arm without joints has places of its own all the same: what is asked of calloc is never 0. */
static bool get_memory(armtol_inverse *inverse)
{
    const size_t n_links = inverse->chain.n_links, n = inverse->chain.n_joints;
    inverse->chain.links = calloc(n_links, sizeof *inverse->chain.links);
    inverse->chain.joints = calloc(n + 1, sizeof *inverse->chain.joints);
    inverse->memory = calloc(6 * n_links + (ARMTOL_MOST_BRANCHES + 12) * (n + 1), sizeof *inverse->memory);
    inverse->search.held = calloc(n + 1, sizeof *inverse->search.held);
    return inverse->chain.links != NULL && inverse->chain.joints != NULL && inverse->memory != NULL &&
           inverse->search.held != NULL;
}

armtol_status armtol_inverse_create(const armtol_inverse_setup *setup, armtol_inverse **inverse)
{
    *inverse = NULL;
    armtol_status status = armtol_arm_check(setup->arm);
    if (status != ARMTOL_OK) {
        return status;
    }
    armtol_inverse *made = calloc(1, sizeof *made);
    if (made == NULL) {
        return ARMTOL_NO_MEMORY;
    }
    made->chain.n_links = setup->arm->n_links;
    made->chain.n_joints = armtol_arm_joint_count(setup->arm);
    memcpy(made->chain.offset, setup->offset, sizeof setup->offset);
    status = get_memory(made) ? ARMTOL_OK : ARMTOL_NO_MEMORY;
    if (status == ARMTOL_OK) {
        lay_out(made, made->search.held);
        made->search.within = setup->within > 0 ? setup->within : USUAL_WITHIN;
        made->enough = setup->enough > 0 ? setup->enough : SIZE_MAX;
        made->own = setup->near == NULL ? own_robot(setup->arm) : NULL;
        status = prepare_chain(&made->chain, setup);
    }
    if (status != ARMTOL_OK) {
        armtol_inverse_destroy(made);
        return status;
    }
    *inverse = made;
    return ARMTOL_OK;
}

void armtol_inverse_destroy(armtol_inverse *inverse)
{
    if (inverse != NULL) {
        free(inverse->chain.links);
        free(inverse->chain.joints);
        free(inverse->memory);
        free(inverse->search.held);
        free(inverse);
    }
}

double armtol_inverse_size(const armtol_inverse *inverse)
{
    return inverse->chain.size;
}

/* ---- branches ---- */

/* More joints than components: it can move while the tool stands. */
static bool is_redundant(const armtol_inverse *inverse)
{
    return inverse->chain.n_joints > inverse->search.goal.n_rows;
}

/*
 * Postures that can be moved while the tool stands come to where `near` is nearest only as well as rounding tells: in a
 * flat valley, as far from `near` as each other, they can be some way apart.
 */
static bool same_branch(const armtol_inverse *inverse, const double one[], const double other[])
{
    const chain *chain = &inverse->chain;
    const double far = search_from_near(chain, one), further = fabs(search_from_near(chain, other) - far);
    const bool flat = is_redundant(inverse) && further <= 1e-6 * far;
    const double most = flat ? 100 * ARMTOL_BRANCH_APART : ARMTOL_BRANCH_APART;
    bool same = true;
    for (size_t j = 0; j < chain->n_joints; j++) {
        double apart = one[j] - other[j];
        apart -= chain->joints[j].turns ? 2 * PI * floor(apart / (2 * PI) + 0.5) : 0;
        same = same && fabs(apart) <= most * chain->joints[j].unit;
    }
    return same;
}

static bool comes_before(const chain *chain, const armtol_branch *one, const armtol_branch *other)
{
    const double further = one->from_near - other->from_near;
    if (one->own || other->own || fabs(further) > 1e-9 * (1 + other->from_near)) {
        return one->own || (!other->own && further < 0);
    }
    size_t j = 0;
    while (j + 1 < chain->n_joints && fabs(one->q[j] - other->q[j]) <= ARMTOL_BRANCH_APART * chain->joints[j].unit) {
        j++;
    }
    return one->q[j] > other->q[j];
}

static armtol_branch branch_of(const armtol_inverse *inverse, const double q[], const chain_error *error)
{
    const double *e = error->e;
    return (armtol_branch){
        .q = q,
        .from_near = search_from_near(&inverse->chain, q),
        .distance = inverse->chain.size * length_of_vector(e),
        .angle = inverse->search.goal.n_rows == 6 ? length_of_vector(e + 3) : 0,
    };
}

/* Up or down to its place in the order: all others are in theirs. */
static void put_in_order(const chain *chain, armtol_branches *branches, size_t i)
{
    armtol_branch *branch = branches->branch;
    for (; i > 0 && comes_before(chain, &branch[i], &branch[i - 1]); i--) {
        const armtol_branch earlier = branch[i - 1];
        branch[i - 1] = branch[i];
        branch[i] = earlier;
    }
}

/* The branch that is the same, or count. */
static size_t find_same(const armtol_inverse *inverse, const armtol_branches *branches, const double q[])
{
    size_t i = 0;
    while (i < branches->count && !same_branch(inverse, branches->branch[i].q, q)) {
        i++;
    }
    return i;
}

/* Whether it is a new one. Of more than there is room for the farthest are left out. */
static bool add_branch(armtol_inverse *inverse, armtol_branches *branches, const double q[], const chain_error *error,
                       bool own)
{
    const size_t n = inverse->chain.n_joints, same = find_same(inverse, branches, q);
    const bool known = same < branches->count, full = branches->count == ARMTOL_MOST_BRANCHES;
    const size_t i = known ? same : full ? branches->count - 1 : branches->count;
    armtol_branch branch = branch_of(inverse, q, error);
    branch.own = own;
    if ((known || full) && !comes_before(&inverse->chain, &branch, &branches->branch[i])) {
        return false;
    }
    double *place = inverse->found + (known || full ? branches->branch[i].q - inverse->found : (ptrdiff_t)(i * n));
    for (size_t j = 0; j < n; j++) { /* what rounding left of a 0 is 0 */
        place[j] = fabs(q[j]) < 1e-14 * inverse->chain.joints[j].unit ? 0 : q[j];
    }
    branch.q = place;
    branches->branch[i] = branch;
    branches->count += !known && !full;
    put_in_order(&inverse->chain, branches, i);
    return !known;
}

/* ---- starts ---- */

/* Uniform in [0, 1), by the numbers of start and joint alone. */
static double drawn(size_t start, size_t joint, size_t n_joints)
{
    return splitmix_uniform(SPLITMIX_STEP * (uint64_t)(start * n_joints + joint + 1));
}

/* Where a joint's value is looked for: its range, a turn, or as far as `span` about `near`. */
static double drawn_value(const chain_joint *joint, double span, double share)
{
    const double about = joint->slides ? span : PI;
    const bool bounded = isfinite(joint->low) && isfinite(joint->high);
    if (joint->turns && !(joint->high - joint->low < 2 * PI)) {
        return joint->near + about * (2 * share - 1);
    }
    const double low = bounded ? joint->low : fmax(joint->low, joint->near - about);
    const double high = bounded ? joint->high : fmin(joint->high, joint->near + about);
    return low + (high - low) * share;
}

/* Start 0 is `near`. */
static void begin(const armtol_inverse *inverse, size_t start)
{
    const chain *chain = &inverse->chain;
    const double span = (2 + inverse->search.goal.away) * chain->size;
    for (size_t j = 0; j < chain->n_joints; j++) {
        const chain_joint *joint = &chain->joints[j];
        inverse->way[j] = start == 0 ? joint->near : drawn_value(joint, span, drawn(start, j, chain->n_joints));
    }
}

/* Whether a start brought a new branch. */
static bool try_start(armtol_inverse *inverse, size_t start, armtol_branches *branches)
{
    const search *search = &inverse->search;
    chain_error error;
    begin(inverse, start);
    search_descend(search, false, inverse->way, &error);
    if (!search_is_there(search, &error) || !search_bring_within(search, inverse->way, &error)) {
        return false;
    }
    search_approach(search, inverse->way, &error);
    return add_branch(inverse, branches, inverse->way, &error, false);
}

static void try_starts(armtol_inverse *inverse, armtol_branches *branches)
{
    const size_t least = is_redundant(inverse) ? REDUNDANT_STARTS : LEAST_STARTS;
    size_t start = 0, stop = VAIN_STARTS;
    for (; start < stop && start < ARMTOL_MOST_STARTS && branches->count < inverse->enough; start++) {
        if (try_start(inverse, start, branches)) {
            stop = start + 1 + (start + 1 < least ? least : start + 1);
        }
    }
    branches->starts = start;
}

/* Downhill comes to a rest before it is at the bottom: from there it is begun anew until that brings nothing. */
static void refine_best(armtol_inverse *inverse, armtol_branches *branches)
{
    chain_error error;
    search_descend(&inverse->search, true, inverse->best, &error);
    for (int i = 0; i < MOST_REFINEMENTS; i++) {
        const double before = error.square;
        search_descend(&inverse->search, true, inverse->best, &error);
        if (!(error.square < before * (1 - 1e-12))) {
            break;
        }
    }
    branches->best = branch_of(inverse, inverse->best, &error);
}

/* Where the wish is out of reach: the nearest within the limits, which may be near enough all the same. */
static void come_near(armtol_inverse *inverse, armtol_branches *branches)
{
    double least = (double)INFINITY;
    for (size_t start = 0; start < LEAST_STARTS; start++) {
        chain_error error;
        begin(inverse, start);
        search_descend(&inverse->search, true, inverse->way, &error);
        if (error.square < least) {
            least = error.square;
            memcpy(inverse->best, inverse->way, inverse->chain.n_joints * sizeof *inverse->best);
        }
        if (search_is_there(&inverse->search, &error)) {
            add_branch(inverse, branches, inverse->way, &error, false);
        }
    }
    branches->starts += LEAST_STARTS;
    refine_best(inverse, branches);
}

/*
 * By the arm's own inverse kinematics, on its way. Its wish is of the last frame, which the tool is `offset` away from.
 */
static bool find_own(armtol_inverse *inverse, chain_error *error)
{
    const search *search = &inverse->search;
    armtol_transform last = search->goal.wish->tool, tool;
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            last.m[i][3] -= last.m[i][k] * inverse->chain.offset[k];
        }
    }
    if (!own_inverse(inverse->own, &last, inverse->way)) {
        return false;
    }
    chain_place(&inverse->chain, inverse->way, &tool);
    chain_compare(&inverse->chain, &search->goal, &tool, error);
    return search_is_there(search, error) && search_is_within(&inverse->chain, inverse->way);
}

static void try_own(armtol_inverse *inverse, armtol_branches *branches)
{
    chain_error error;
    if (find_own(inverse, &error)) {
        add_branch(inverse, branches, inverse->way, &error, true);
    }
}

static bool can_be_measured(const armtol_inverse *inverse, const armtol_wish *wish)
{
    bool finite = true;
    for (int i = 0; i < 3; i++) {
        finite = finite && isfinite(wish->tool.m[i][3]) && (wish->point_only || all_finite(wish->tool.m[i], 3));
    }
    if (finite) {
        armtol_transform tool;
        chain_error error;
        begin(inverse, 0);
        chain_place(&inverse->chain, inverse->way, &tool);
        chain_compare(&inverse->chain, &inverse->search.goal, &tool, &error);
        finite = isfinite(error.square);
    }
    return finite;
}

/* False for one whose distance cannot be told. */
static bool take_wish(armtol_inverse *inverse, const armtol_wish *wish)
{
    const double(*tool)[4] = wish->tool.m;
    const double away = length_of_vector((const double[]){tool[0][3], tool[1][3], tool[2][3]}) / inverse->chain.size;
    inverse->search.goal = (chain_goal){wish, wish->point_only ? 3 : 6, fmax(1, away)};
    return can_be_measured(inverse, wish);
}

armtol_status armtol_inverse_find(armtol_inverse *inverse, const armtol_wish *wish, armtol_branches *branches)
{
    if (!take_wish(inverse, wish)) {
        return ARMTOL_NOT_FINITE;
    }
    branches->count = 0;
    if (inverse->own != NULL && !wish->point_only) {
        try_own(inverse, branches);
    }
    try_starts(inverse, branches);
    if (branches->count == 0) {
        come_near(inverse, branches);
    }
    if (branches->count > 0) {
        branches->best = branches->branch[0];
    }
    return branches->count > 0 ? ARMTOL_OK : ARMTOL_OUT_OF_REACH;
}

static bool follow(armtol_inverse *inverse, const double from[], chain_error *error)
{
    const search *search = &inverse->search;
    memcpy(inverse->way, from, inverse->chain.n_joints * sizeof *from);
    search_descend(search, false, inverse->way, error);
    return search_is_there(search, error) && search_bring_within(search, inverse->way, error);
}

armtol_status armtol_inverse_follow(armtol_inverse *inverse, const armtol_wish *wish, const double from[],
                                    armtol_branch *branch)
{
    chain_error error;
    if (!take_wish(inverse, wish)) {
        return ARMTOL_NOT_FINITE;
    }
    const bool own = from == NULL && inverse->own != NULL && !wish->point_only;
    if (!(from != NULL ? follow(inverse, from, &error) : own && find_own(inverse, &error))) {
        return ARMTOL_OUT_OF_REACH;
    }
    if (from != NULL && inverse->chain.n_joints > inverse->search.goal.n_rows) {
        search_approach(&inverse->search, inverse->way, &error);
    }
    *branch = branch_of(inverse, inverse->way, &error);
    branch->own = own;
    return ARMTOL_OK;
}
