#include "lib/region/chain.h"

#include "lib/arms/motion.h"
#include "lib/report/trigonometry.h"
#include "lib/tool/negligible.h"
#include "lib/tool/pose_link.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

static const double unit = DBL_EPSILON / 2;

/* Rounded up. */
#define HALF_TURN 3.1415926535897936
#define TURN 6.283185307179587

static void take_motion(const armtol_arm *arm, size_t link, const size_t variables[], chain_link *made)
{
    const armtol_motion motion = arm_motion(arm, link);
    made->leads = armtol_arm_is_driven(arm, link);
    made->times = motion.sign * motion.multiplier;
    made->plus = motion.follows == link ? 0 : motion.sign * motion.offset;
    made->variable = variables[motion.follows]; /* CHAIN_FIXED of a fixed link */
}

static chain_link link_of(const armtol_arm *arm, size_t link, const size_t variables[])
{
    const armtol_link *from = &arm->links[link];
    chain_link made = {
        .a = from->a,
        .d = from->d,
        .theta = from->theta,
        .cos_alpha = cosine_of(&armtol_errata_none, from->alpha),
        .sin_alpha = sine_of(&armtol_errata_none, from->alpha),
        .cos_beta = cosine_of(&armtol_errata_none, from->beta),
        .sin_beta = sine_of(&armtol_errata_none, from->beta),
        .joint = from->joint,
    };
    take_motion(arm, link, variables, &made);
    return made;
}

/* The longest that a link's own vector is in the region. */
static double longest(const chain *chain, size_t i)
{
    const chain_link *link = &chain->links[i];
    double d = fabs(link->d);
    if (link->joint == ARMTOL_PRISMATIC) {
        const size_t j = link->variable;
        d = fmax(fabs(link->d + link->plus + link->times * chain->low[j]),
                 fabs(link->d + link->plus + link->times * chain->high[j]));
    }
    return length_of(link->a, d);
}

static bool make_links(chain *chain, const armtol_arm *arm)
{
    size_t *variables = calloc(arm->n_links, sizeof *variables), joint = 0;
    if (variables == NULL) {
        return false;
    }
    for (size_t i = 0; i < arm->n_links; i++) {
        variables[i] = armtol_arm_is_driven(arm, i) ? CHAIN_DIRECTIONS + joint++ : CHAIN_FIXED;
    }
    for (size_t i = 0; i < arm->n_links; i++) {
        chain->links[i] = link_of(arm, i, variables);
        chain->reach += longest(chain, i);
    }
    free(variables);
    return true;
}

static void take_joints(chain *chain, const armtol_region *region)
{
    for (size_t j = 0; j < chain->n_joints; j++) {
        chain->low[CHAIN_DIRECTIONS + j] = region->low[j];
        chain->high[CHAIN_DIRECTIONS + j] = region->high[j];
    }
}

bool chain_make(chain *chain, const armtol_arm *arm, const armtol_tool_point *tool, const armtol_region *region)
{
    const size_t n_joints = armtol_arm_joint_count(arm);
    *chain = (struct chain){.n_links = arm->n_links, .n_joints = n_joints, .n_variables = CHAIN_DIRECTIONS + n_joints,
                            .arm = arm};
    chain->links = calloc(arm->n_links, sizeof *chain->links);
    chain->low = calloc(chain->n_variables, sizeof *chain->low);
    chain->high = calloc(chain->n_variables, sizeof *chain->high);
    if (chain->links == NULL || chain->low == NULL || chain->high == NULL) {
        return false;
    }
    take_joints(chain, region);
    for (int i = 0; i < 3; i++) {
        chain->offset[i] = tool->offset[i];
    }
    chain->along_tool = tool->frame == ARMTOL_TOOL_FRAME;
    chain->reach = length_of_vector(tool->offset);
    const bool made = make_links(chain, arm);
    chain->reach = chain->reach > 0 ? chain->reach : 1; /* an arm without lengths only turns: any scale will do */
    return made;
}

void chain_free(chain *chain)
{
    free(chain->links);
    free(chain->low);
    free(chain->high);
}

bool chain_take_loads(chain *chain, loads *loads)
{
    double *lengths = calloc(chain->n_links, 2 * sizeof *lengths);
    if (lengths == NULL) {
        return false;
    }
    double *most = lengths + chain->n_links;
    for (size_t i = 0; i < chain->n_links; i++) {
        lengths[i] = longest(chain, i);
    }
    for (size_t which = 0; which < loads->n_cases; which++) {
        loads_most(loads, which, lengths, most);
        for (size_t d = 0; d < loads->n_drives; d++) {
            load_drive *drive = &loads->drives[d];
            drive->most = fmax(drive->most, most[drive->link]);
        }
    }
    free(lengths);
    chain->loads = loads->n_drives > 0 ? loads : NULL;
    return true;
}

/* ---- symmetry ---- */

static bool is_along_z(const double axis[3])
{
    return axis[0] == 0 && axis[1] == 0;
}

/* Whether the region stays what it is, ranges of joints apart, when all turns about z of the base. */
static bool is_round(const armtol_region *region)
{
    const armtol_ring *ring = region->ring;
    const armtol_block *block = region->block;
    bool flat = block == NULL || (isinf(block->low[0]) && isinf(block->high[0]) && isinf(block->low[1]) &&
                                  isinf(block->high[1]));
    return flat && region->path == NULL &&
           (ring == NULL || (is_along_z(ring->axis) && ring->point[0] == 0 && ring->point[1] == 0)) &&
           (region->cone == NULL || is_along_z(region->cone->direction));
}

static bool has_axis(const chain *chain, size_t axis)
{
    bool has = false;
    for (size_t i = 0; i < chain->n_axes; i++) {
        has = has || chain->axes[i] == axis;
    }
    return has;
}

static bool is_followed(const chain *chain, size_t variable)
{
    size_t count = 0;
    for (size_t i = 0; i < chain->n_links; i++) {
        count += chain->links[i].variable == variable;
    }
    return count > 1;
}

static void hold_at_middle(chain *chain, size_t variable)
{
    chain->low[variable] += (chain->high[variable] - chain->low[variable]) / 2;
    chain->high[variable] = chain->low[variable];
}

/*
 * The first joint turns the whole arm about z of the base. Where the region turns with it, an error along the tool's
 * axes or z, or the length of one across z, is the same at each of its values; an error along another axis is the
 * same after half a turn. So it is with drives under a load, where what bears on them is along z.
 */
static void use_symmetry(chain *chain, const armtol_region *region)
{
    const chain_link *first = &chain->links[0];
    const size_t j = first->variable;
    const bool seen = chain->loaded && !loads_are_upright(chain->loads);
    if (first->joint != ARMTOL_REVOLUTE || is_followed(chain, j) || !is_round(region) || seen) {
        return;
    }
    const bool x = has_axis(chain, 0), y = has_axis(chain, 1);
    if (chain->along_tool || x == y) {
        hold_at_middle(chain, j);
    } else if (!has_axis(chain, 2) && chain->high[j] - chain->low[j] > HALF_TURN) {
        chain->high[j] = chain->low[j] + HALF_TURN;
    }
}

/* More than one turn is one turn. */
static void use_periods(chain *chain)
{
    for (size_t i = 0; i < chain->n_links; i++) {
        const chain_link *link = &chain->links[i];
        const size_t j = link->variable;
        if (link->joint == ARMTOL_REVOLUTE && !is_followed(chain, j) && chain->high[j] - chain->low[j] > TURN) {
            chain->high[j] = chain->low[j] + TURN;
        }
    }
}

/* ---- the measure ---- */

static void take_axes(chain *chain, unsigned components)
{
    chain->n_axes = 0;
    chain->angular = components >= 8;
    for (size_t i = 0; i < 3; i++) {
        if ((components >> (i + (chain->angular ? 3 : 0)) & 1) != 0) {
            chain->axes[chain->n_axes++] = i;
        }
    }
}

/* Both senses of a direction are one: half a turn of it, and of a ball half of the sphere, are all. */
static void take_directions(chain *chain)
{
    for (size_t i = 0; i < 2; i++) {
        chain->low[i] = chain->high[i] = 0;
    }
    if (chain->n_axes > 1) {
        chain->high[0] = HALF_TURN;
    }
    if (chain->n_axes > 2) {
        chain->low[1] = -HALF_TURN / 2;
        chain->high[1] = HALF_TURN / 2;
    }
}

static void take_ranges(chain *chain, const armtol_region *region)
{
    take_joints(chain, region);
    use_periods(chain);
    use_symmetry(chain, region);
    take_directions(chain);
}

/* The largest that the angles of a link are, all their magnitudes together. */
static double angles_of(const chain *chain, size_t link)
{
    const armtol_link *from = &chain->arm->links[link];
    const chain_link *made = &chain->links[link];
    double moved = 0;
    if (made->joint == ARMTOL_REVOLUTE) {
        const double far = fmax(fabs(chain->low[made->variable]), fabs(chain->high[made->variable]));
        moved = fabs(made->plus) + fabs(made->times) * far;
    }
    return fabs(from->theta) + moved + fabs(from->alpha) + fabs(from->beta);
}

/*
 * How far rounding takes the sum. With n links, u half a unit in the last place of 1 and L the reach,
 * src/lib/tool/rounding.c shows that the frames of a chain are off by no more than E, the sum of 100 u + 2 u (its
 * angles) over its links, and an element of A by 2 (2 E + 16 n u) L, or 2 E where it is no motion by an angle; up to
 * 1e-12 of it may have been cleared in the A that an answer has. Here a corner of an arc is off by less than 16 u, an
 * angle of the direction counts as a link, and each link turns the frame as often as there: 200 u in the place of 100
 * is more than that. Corners lie further out than 1, which stretches all of it alike: enclose.c multiplies.
 *
 * A moment is a product like an element's, once more of a lever and a force: at corners it is off by less than that
 * origin's part of what it could be, and as moments.c has it by twice that, up to 1e-12 cleared. A shift is a sum of
 * products of both, and the functions above it (load_sum.c) are of their sizes.
 */
static void take_rounding(chain *chain, double lengths, double angles)
{
    const double n = (double)chain->n_links + 2;
    double frame = 400 * unit;
    for (size_t i = 0; i < chain->n_links; i++) {
        frame += (200 + 2 * angles_of(chain, i)) * unit;
    }
    const double origin = frame + 16 * n * unit;
    chain->blur = 2 * (negligible + origin) * chain->reach;
    chain->moment_rounding = origin;
    chain->shift_rounding = 0;
    for (size_t i = 0; chain->loaded && i < chain->loads->n_drives; i++) {
        const load_drive *drive = &chain->loads->drives[i];
        const bool turns = chain->links[drive->link].joint == ARMTOL_REVOLUTE && !chain->angular;
        const double lever = turns ? 2 * chain->reach : 1;
        chain->shift_rounding += (2 * negligible + 10 * origin + 64 * unit) * lever * drive->give * drive->most;
    }
    chain->rounding = chain->angular ? (negligible + 2 * frame) * angles
                                     : (negligible + 4 * origin) * (lengths + 2 * chain->reach * angles);
}

/* Of motors under a load: what they may be off by where it holds their play, in the place of the most of all poses. */
static void take_drives(chain *chain, double *lengths, double *angles)
{
    for (size_t i = 0; i < chain->loads->n_drives; i++) {
        const load_drive *drive = &chain->loads->drives[i];
        const bool turns = chain->links[drive->link].joint == ARMTOL_REVOLUTE;
        chain->links[drive->link].weights[turns ? ARMTOL_THETA : ARMTOL_D] = chain->factor * drive->held;
        *(turns ? angles : lengths) += chain->factor * drive->free_play + drive->play;
    }
}

void chain_measure(chain *chain, const armtol_region *region, unsigned components, const double tolerances[],
                   double sigma, bool loaded)
{
    double lengths = 0, angles = 0;
    size_t column = 0;
    chain->loaded = loaded && chain->loads != NULL;
    chain->squares = sigma > 0;
    chain->factor = sigma > 0 ? sigma / sqrt(3) : 1;
    take_axes(chain, components);
    take_ranges(chain, region);
    for (size_t i = 0; i < chain->n_links; i++) {
        size_t columns[ARMTOL_PARAMETER_COUNT];
        columns_of_link(chain->arm->links[i].kind, &column, columns);
        for (int p = 0; p < ARMTOL_PARAMETER_COUNT; p++) {
            const double t = columns[p] == NO_COLUMN || isinf(tolerances[columns[p]]) ? 0 : tolerances[columns[p]];
            chain->links[i].weights[p] = sigma > 0 ? t * sigma / sqrt(3) : t;
            *(armtol_parameter_is_length((armtol_parameter)p) ? &lengths : &angles) += chain->links[i].weights[p];
        }
    }
    if (chain->loaded) {
        take_drives(chain, &lengths, &angles);
    }
    take_rounding(chain, lengths, angles);
}
