/* Joint values for the points of a plane. */

#include "armtol/map.h"
#include "armtol/tool_point.h"
#include "lib/pi.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* No joint moves further between joined neighbours: radians, or shares of the arm's size. */
#define JUMP 1.0

/* How far from halfway between them, as a part of the way, joint values halfway may bring the tool. */
#define ASIDE 0.35

/* What is left is looked at in so many steps across and up. */
enum { STRIDE = 3 };

typedef struct walk {
    const armtol_inverse_setup *setup;
    const armtol_map_plane *plane;
    const armtol_map_search *search; /* NULL: in every point, and nothing is known */
    armtol_inverse *inverse;
    bool (*progress)(void *context, size_t done, size_t total);
    void *context;
    size_t n_joints, count;
    size_t kept, passed; /* points that have joint values, and that have been looked at in vain */
    double *units;       /* n_joints: a jump of each; 0 for one that turns, whose values count without whole turns */
    double *middle;      /* n_joints */
    armtol_link *links;
    size_t *queue;       /* points whose neighbours are to be followed to */
    double *q;
    unsigned char *marks;
    armtol_branches branches;
} walk;

static armtol_wish wish_of(const walk *walk, size_t point)
{
    const armtol_map_plane *plane = walk->plane;
    const size_t column = point % plane->n_across, row = point / plane->n_across;
    const double i = (double)column, j = (double)row;
    armtol_wish wish = {plane->axes, plane->point_only};
    for (int d = 0; d < 3; d++) {
        wish.tool.m[d][3] = plane->first[d] + i * plane->across[d] + j * plane->up[d];
        wish.tool.m[3][d] = 0;
    }
    wish.tool.m[3][3] = 1;
    return wish;
}

/* False where whoever waits has ended the work. */
static bool go_on(const walk *walk)
{
    const size_t done = walk->kept + walk->passed;
    return walk->progress == NULL || walk->progress(walk->context, done < walk->count ? done : walk->count,
                                                    walk->count);
}

static void keep(walk *walk, size_t point, const double q[])
{
    memcpy(walk->q + point * walk->n_joints, q, walk->n_joints * sizeof *q);
    walk->marks[point] = ARMTOL_MAP_REACHED;
    walk->kept++;
}

static bool is_reached(const walk *walk, size_t point)
{
    return walk->marks[point] != 0;
}

/* Where joint values bring the tool point. */
static armtol_status find_tool(const walk *walk, const double q[], double tool[3])
{
    const armtol_arm *arm = walk->setup->arm;
    const armtol_status status = armtol_arm_place(arm, q, walk->n_joints, walk->links);
    if (status == ARMTOL_OK) {
        armtol_tool_point point = armtol_tool_origin;
        armtol_transform frame;
        memcpy(point.offset, walk->setup->offset, sizeof point.offset);
        armtol_tool_frame(walk->links, arm->n_links, &point, &frame);
        for (int i = 0; i < 3; i++) {
            tool[i] = frame.m[i][3];
        }
    }
    return status;
}

static double squared(double value)
{
    return value * value;
}

/* What a joint has to move by. */
static double way_of(const walk *walk, size_t joint, double from, double to)
{
    const double way = to - from;
    return walk->units[joint] == 0 ? way - 2 * PI * floor(way / (2 * PI) + 0.5) : way;
}

/* Whether the arm moves on from one to the other point's joint values without a jump: map.h, note 3. */
static bool are_joined(const walk *walk, size_t one, const double from[], size_t other, const double to[])
{
    const armtol_wish start = wish_of(walk, one), end = wish_of(walk, other);
    double tool[3], aside = 0, whole = 0;
    for (size_t k = 0; k < walk->n_joints; k++) {
        const double way = way_of(walk, k, from[k], to[k]), unit = walk->units[k] > 0 ? walk->units[k] : 1;
        if (!(fabs(way) <= JUMP * unit)) {
            return false;
        }
        walk->middle[k] = from[k] + way / 2;
    }
    if (find_tool(walk, walk->middle, tool) != ARMTOL_OK) {
        return false;
    }
    for (int d = 0; d < 3; d++) {
        aside += squared(tool[d] - (start.tool.m[d][3] + end.tool.m[d][3]) / 2);
        whole += squared(end.tool.m[d][3] - start.tool.m[d][3]);
    }
    return aside <= squared(ASIDE) * whole;
}

/* From a point that is reached to a neighbour: whether it was reached without a jump. */
static bool step_to(walk *walk, size_t from, size_t to)
{
    const double *q = walk->q + from * walk->n_joints;
    const armtol_wish wish = wish_of(walk, to);
    armtol_branch branch;
    if (armtol_inverse_follow(walk->inverse, &wish, q, &branch) != ARMTOL_OK ||
        !are_joined(walk, from, q, to, branch.q)) {
        return false;
    }
    keep(walk, to, branch.q);
    return true;
}

static bool joins(const walk *walk, size_t one, size_t other)
{
    const size_t n = walk->n_joints;
    return is_reached(walk, one) && is_reached(walk, other) &&
           are_joined(walk, one, walk->q + one * n, other, walk->q + other * n);
}

static void mark_joined(walk *walk)
{
    const armtol_map_plane *plane = walk->plane;
    for (size_t point = 0; point < walk->count; point++) {
        const bool last = point % plane->n_across + 1 == plane->n_across, top = point / plane->n_across + 1 ==
            plane->n_up;
        const int next = !last && joins(walk, point, point + 1) ? ARMTOL_MAP_JOINS_NEXT : 0;
        const int above = !top && joins(walk, point, point + plane->n_across) ? ARMTOL_MAP_JOINS_ABOVE : 0;
        walk->marks[point] = (unsigned char)(walk->marks[point] | next | above);
    }
}

/* The neighbours of a point: to the right, left, above, below; how many there are. */
static size_t neighbours_of(const armtol_map_plane *plane, size_t point, size_t neighbours[4])
{
    const size_t i = point % plane->n_across, j = point / plane->n_across;
    size_t n = 0;
    if (i + 1 < plane->n_across) {
        neighbours[n++] = point + 1;
    }
    if (i > 0) {
        neighbours[n++] = point - 1;
    }
    if (j + 1 < plane->n_up) {
        neighbours[n++] = point + plane->n_across;
    }
    if (j > 0) {
        neighbours[n++] = point - plane->n_across;
    }
    return n;
}

/* All that can be come to from the point, which is reached, without a jump. */
static bool spread(walk *walk, size_t point)
{
    size_t head = 0, tail = 0;
    walk->queue[tail++] = point;
    for (; head < tail; head++) {
        size_t neighbours[4];
        const size_t n = neighbours_of(walk->plane, walk->queue[head], neighbours);
        for (size_t k = 0; k < n; k++) {
            if (!is_reached(walk, neighbours[k]) && step_to(walk, walk->queue[head], neighbours[k])) {
                walk->queue[tail++] = neighbours[k];
            }
        }
        if (!go_on(walk)) {
            return false;
        }
    }
    return true;
}

/* The branch nearest to the setup's posture. *q is the solver's. */
static armtol_status search_at(walk *walk, size_t point, const double **q)
{
    const armtol_wish wish = wish_of(walk, point);
    const armtol_status status = armtol_inverse_find(walk->inverse, &wish, &walk->branches);
    *q = status == ARMTOL_OK ? walk->branches.branch[0].q : NULL;
    return status;
}

/* The same, of a search that others may have made, or are to make: then the point counts as out of reach. */
static armtol_status share_search_at(walk *walk, size_t point, bool first, const double **q)
{
    const armtol_map_search *search = walk->search;
    const bool ours = first || (point >= search->first && point - search->first < search->count);
    unsigned char *const result = &search->results[point];
    if (*result == ARMTOL_MAP_FOUND && search->q != NULL) {
        *q = search->q + point * walk->n_joints;
        return ARMTOL_OK;
    }
    if (*result == ARMTOL_MAP_IN_VAIN || !ours) {
        return ARMTOL_OUT_OF_REACH;
    }
    const armtol_status status = search_at(walk, point, q);
    *result = status == ARMTOL_OK ? ARMTOL_MAP_FOUND
              : status == ARMTOL_OUT_OF_REACH ? ARMTOL_MAP_IN_VAIN : ARMTOL_MAP_NOT_SEARCHED;
    return status;
}

/* From here on, where the point can be reached at all. *going: false where the work was ended. */
static armtol_status begin_at(walk *walk, size_t point, bool first, bool *going)
{
    const double *q;
    const armtol_status status = walk->search == NULL ? search_at(walk, point, &q)
                                                      : share_search_at(walk, point, first, &q);
    if (status == ARMTOL_OK) {
        keep(walk, point, q);
        *going = spread(walk, point);
    } else {
        *going = go_on(walk);
    }
    return status == ARMTOL_OUT_OF_REACH ? ARMTOL_OK : status;
}

/* A point beside others that can only be come to by a jump. */
static bool leap_to(walk *walk, size_t point)
{
    const armtol_wish wish = wish_of(walk, point);
    size_t neighbours[4];
    const size_t n = neighbours_of(walk->plane, point, neighbours);
    for (size_t k = 0; k < n && !is_reached(walk, point); k++) {
        armtol_branch branch;
        if (is_reached(walk, neighbours[k]) &&
            armtol_inverse_follow(walk->inverse, &wish, walk->q + neighbours[k] * walk->n_joints, &branch) ==
                ARMTOL_OK) {
            keep(walk, point, branch.q);
            return spread(walk, point);
        }
    }
    return true;
}

/* The point that is nearest to where `near` has the tool; the middle where there is none. */
static size_t first_point(const walk *walk, const double tool[3])
{
    const armtol_map_plane *plane = walk->plane;
    size_t nearest = plane->n_up / 2 * plane->n_across + plane->n_across / 2;
    double least = (double)INFINITY;
    for (size_t point = 0; point < walk->count && walk->setup->near != NULL; point++) {
        const armtol_wish wish = wish_of(walk, point);
        double distance = 0;
        for (int d = 0; d < 3; d++) {
            distance += squared(wish.tool.m[d][3] - tool[d]);
        }
        nearest = distance < least ? point : nearest;
        least = fmin(least, distance);
    }
    return nearest;
}

static armtol_status walk_regions(walk *walk, const double tool[3])
{
    bool going = true;
    armtol_status status = begin_at(walk, first_point(walk, tool), true, &going);
    for (size_t point = 0; point < walk->count && status == ARMTOL_OK && going; point++) {
        const size_t i = point % walk->plane->n_across, j = point / walk->plane->n_across;
        if (!is_reached(walk, point)) {
            going = leap_to(walk, point);
        }
        if (!is_reached(walk, point) && going && i % STRIDE == 0 && j % STRIDE == 0) {
            status = begin_at(walk, point, false, &going);
        }
        walk->passed += !is_reached(walk, point);
    }
    return status;
}

/* Whether the arm has its own way, and it led anywhere. */
static bool walk_by_own(walk *walk)
{
    bool going = true;
    for (size_t point = 0; point < walk->count && going; point++) {
        const armtol_wish wish = wish_of(walk, point);
        armtol_branch branch;
        if (armtol_inverse_follow(walk->inverse, &wish, NULL, &branch) == ARMTOL_OK) {
            keep(walk, point, branch.q);
        } else {
            walk->passed++;
        }
        going = go_on(walk);
    }
    return walk->kept > 0;
}

static bool get_memory(walk *walk)
{
    walk->units = calloc(walk->n_joints + 1, sizeof *walk->units);
    walk->middle = calloc(walk->n_joints + 1, sizeof *walk->middle);
    walk->queue = calloc(walk->count, sizeof *walk->queue);
    walk->links = calloc(walk->setup->arm->n_links, sizeof *walk->links);
    return walk->units != NULL && walk->middle != NULL && walk->queue != NULL && walk->links != NULL;
}

static void find_units(walk *walk)
{
    const armtol_arm *arm = walk->setup->arm;
    size_t joint = 0;
    for (size_t i = 0; i < arm->n_links; i++) {
        if (armtol_arm_is_driven(arm, i)) {
            walk->units[joint++] = arm->links[i].joint == ARMTOL_PRISMATIC ? armtol_inverse_size(walk->inverse) : 0;
        }
    }
}

static void clear(walk *walk)
{
    for (size_t k = 0; k < walk->count * walk->n_joints; k++) {
        walk->q[k] = (double)NAN;
    }
    memset(walk->marks, 0, walk->count * sizeof *walk->marks);
}

static armtol_status walk_all(walk *walk)
{
    if (!get_memory(walk)) {
        return ARMTOL_NO_MEMORY;
    }
    clear(walk);
    find_units(walk);
    const bool has_own = walk->setup->near == NULL && !walk->plane->point_only;
    armtol_status status = ARMTOL_OK;
    if (!has_own || !walk_by_own(walk)) {
        double tool[3] = {0};
        walk->passed = 0;
        status = walk->setup->near != NULL ? find_tool(walk, walk->setup->near, tool) : ARMTOL_OK;
        status = status == ARMTOL_OK ? walk_regions(walk, tool) : status;
    }
    mark_joined(walk);
    return status;
}

armtol_status armtol_map_poses_in_parts(const armtol_inverse_setup *setup, const armtol_map_plane *plane,
                                        const armtol_map_search *search,
                                        bool (*progress)(void *context, size_t done, size_t total), void *context,
                                        double q[], unsigned char marks[])
{
    walk walk = {.setup = setup, .plane = plane, .search = search, .progress = progress, .context = context, .q = q,
                 .marks = marks};
    if (plane->n_across == 0 || plane->n_up == 0) {
        return ARMTOL_BAD_QUESTION;
    }
    armtol_status status = armtol_inverse_create(setup, &walk.inverse);
    if (status == ARMTOL_OK) {
        walk.n_joints = armtol_arm_joint_count(setup->arm);
        walk.count = plane->n_across * plane->n_up;
        status = walk_all(&walk);
    }
    free(walk.units);
    free(walk.middle);
    free(walk.queue);
    free(walk.links);
    armtol_inverse_destroy(walk.inverse);
    return status;
}

armtol_status armtol_map_poses(const armtol_inverse_setup *setup, const armtol_map_plane *plane,
                               bool (*progress)(void *context, size_t done, size_t total), void *context, double q[],
                               unsigned char marks[])
{
    return armtol_map_poses_in_parts(setup, plane, NULL, progress, context, q, marks);
}
