#include "armtol/tables/arm_rows.h"

#include "armtol/axes.h"
#include "armtol/link_transform.h"
#include "armtol/transform.h"
#include "console/exit_code.h"

#include <stdlib.h>

static bool moves_by_itself(const arm_entry *row, size_t index)
{
    return row->link.joint == ARMTOL_FIXED || (row->motion.follows == index && row->motion.sign == 1);
}

/* The rows, column by column. */
typedef struct split {
    armtol_link *links;
    armtol_drive *drives;
    armtol_mass *masses;
    armtol_motion *motions;
    const char **names;
    armtol_axis *axes;  /* for the work */
    armtol_kind *kinds; /* that the axes have */
    bool any_motion, any_name;
} split;

static bool split_start(split *split, size_t n_rows)
{
    *split = (struct split){
        .links = calloc(n_rows, sizeof *split->links),
        .drives = calloc(n_rows, sizeof *split->drives),
        .masses = calloc(n_rows, sizeof *split->masses),
        .motions = calloc(n_rows, sizeof *split->motions),
        .names = calloc(n_rows, sizeof *split->names),
        .axes = calloc(n_rows, sizeof *split->axes),
        .kinds = calloc(n_rows, sizeof *split->kinds),
    };
    return enough_memory(split->links != NULL && split->drives != NULL && split->masses != NULL &&
                         split->motions != NULL && split->names != NULL && split->axes != NULL && split->kinds != NULL);
}

static void split_free(split *split)
{
    free(split->links);
    free(split->drives);
    free(split->masses);
    free(split->motions);
    free(split->names);
    free(split->axes);
    free(split->kinds);
}

/*
 * The kinds that the table leaves to the axes. What overflows has none, and the same is said where it is to be placed.
 */
static void choose_kinds(split *split, const arm_rows *rows)
{
    const bool known = armtol_kinds_of_links(split->links, rows->n, split->axes, split->kinds) == ARMTOL_OK;
    for (size_t i = 0; i < rows->n && known; i++) {
        const armtol_kind kind = rows->entries[i].link.kind;
        split->links[i].kind = kind < ARMTOL_KIND_COUNT ? kind : split->kinds[i];
    }
}

static void fill(split *split, const arm_rows *rows)
{
    for (size_t i = 0; i < rows->n; i++) {
        const arm_entry *const row = &rows->entries[i];
        armtol_link *const link = &split->links[i];
        *link = row->link;
        if (link->kind == ARMTOL_KIND_COUNT) {
            link->kind = link->joint == ARMTOL_PRISMATIC ? ARMTOL_NPP : ARMTOL_NPR;
        }
        split->drives[i] = row->drive;
        split->masses[i] = row->mass;
        split->motions[i] = row->motion;
        split->any_motion = split->any_motion || !moves_by_itself(row, i);
        split->names[i] = row->name;
        split->any_name = split->any_name || row->name != NULL;
    }
}

bool arm_rows_make(const arm_rows *rows, const armtol_arm *heading, angle_unit angle_unit, arm_model *model)
{
    split split;
    bool fine = split_start(&split, rows->n);
    if (fine) {
        fill(&split, rows);
        choose_kinds(&split, rows);
        armtol_arm arm = *heading;
        arm.n_links = rows->n;
        arm.links = split.links;
        arm.drives = split.drives;
        arm.masses = rows->has_masses ? split.masses : NULL;
        arm.motions = split.any_motion ? split.motions : NULL;
        arm.names = split.any_name ? split.names : NULL;
        fine = arm_model_make(model, &arm, angle_unit);
    }
    split_free(&split);
    return fine;
}

/* ---- Craig's order ---- */

/* A fixed link that does nothing; its kind is that of fixed links. */
static arm_entry nothing(void)
{
    return (arm_entry){
        .link = {.kind = ARMTOL_NPR}, .drive = armtol_drive_unknown, .motion = {.multiplier = 1, .sign = 1}};
}

/* Give a link the lengths and angles that the next frame has to the axis. */
static void take_link(armtol_link *link, const armtol_link *from)
{
    link->a = from->a;
    link->alpha = from->alpha;
    link->beta = from->beta;
}

static bool goes_nowhere(const armtol_link *link)
{
    return link->a == 0 && link->alpha == 0 && link->beta == 0;
}

/* Only alpha, a and beta tell it from nothing. */
static bool stands_still(const arm_entry *row)
{
    const armtol_link *link = &row->link;
    const bool kind = link->kind == ARMTOL_NPR || link->kind == ARMTOL_KIND_COUNT;
    return link->joint == ARMTOL_FIXED && kind && link->theta == 0 && link->d == 0 && row->mass.mass == 0;
}

/*
 * Move a center of mass from the frame behind a, alpha and beta of the link to the one before them, or the other way.
 */
static void move_center(arm_entry *row, const armtol_link *link, bool before)
{
    armtol_link moved = {.a = link->a, .alpha = link->alpha, .beta = link->beta};
    const armtol_transform step = armtol_link_transform(&moved, &armtol_errata_none);
    const armtol_transform back = armtol_transform_inverse(&step, &armtol_errata_none);
    const armtol_transform *by = before ? &step : &back;
    double center[3];
    for (int i = 0; i < 3; i++) {
        center[i] = by->m[i][3];
        for (int k = 0; k < 3; k++) {
            center[i] += by->m[i][k] * row->mass.center[k];
        }
    }
    for (int i = 0; i < 3 && row->mass.mass != 0 && !goes_nowhere(link); i++) {
        row->mass.center[i] = center[i];
    }
}

/* The rows of one table from those of the other; there is room for one more. */
typedef struct moved {
    arm_entry *rows;
    size_t n;
} moved;

/* Row i of `rows` becomes row i + shift. */
static void copy(moved *moved, const arm_entry rows[], size_t n_rows, size_t shift)
{
    for (size_t i = 0; i < n_rows; i++) {
        arm_entry *const row = &moved->rows[i + shift];
        *row = rows[i];
        row->motion.follows += shift;
    }
    moved->n = n_rows + shift;
}

static void to_links(moved *moved, const arm_entry rows[], size_t n_rows)
{
    const armtol_link none = {.a = 0};
    const size_t shift = goes_nowhere(&rows[0].link) ? 0 : 1;
    moved->rows[0] = nothing();
    copy(moved, rows, n_rows, shift);
    for (size_t i = 0; i < moved->n; i++) {
        const size_t next = i + 1 - shift;
        take_link(&moved->rows[i].link, next < n_rows ? &rows[next].link : &none);
        move_center(&moved->rows[i], &moved->rows[i].link, false);
    }
    moved->n -= moved->n > 1 && stands_still(&moved->rows[moved->n - 1]);
}

/* What to_links leaves out is written, so that it makes the same links of them again. */
static void to_rows(moved *moved, const armtol_arm *arm)
{
    const armtol_link *links = arm->links, *last = &links[arm->n_links - 1];
    const arm_entry first = arm_entry_of(arm, 0), end = arm_entry_of(arm, arm->n_links - 1);
    const size_t dropped = stands_still(&first) && !goes_nowhere(&links[0]) ? 1 : 0;
    const size_t n = arm->n_links - dropped;
    for (size_t i = 0; i < n; i++) {
        const size_t link = i + dropped;
        arm_entry *const row = &moved->rows[i];
        *row = arm_entry_of(arm, link);
        move_center(row, &links[link], true);
        row->motion.follows -= row->link.joint != ARMTOL_FIXED ? dropped : 0;
        take_link(&row->link, link > 0 ? &links[link - 1] : &(armtol_link){.a = 0});
    }
    moved->n = n;
    if (stands_still(&end) || !goes_nowhere(last)) {
        moved->rows[moved->n] = nothing();
        take_link(&moved->rows[moved->n++].link, last);
    }
}

static bool get_room(moved *moved, size_t n_rows)
{
    moved->rows = calloc(n_rows + 1, sizeof *moved->rows);
    if (moved->rows == NULL) {
        out_of_memory();
    }
    return moved->rows != NULL;
}

bool craig_rows_make(const arm_rows *rows, const armtol_arm *heading, angle_unit angle_unit, arm_model *model)
{
    moved moved;
    if (!get_room(&moved, rows->n)) {
        return false;
    }
    to_links(&moved, rows->entries, rows->n);
    const bool fine = arm_rows_make(&(arm_rows){moved.rows, moved.n, rows->has_masses}, heading, angle_unit, model);
    free(moved.rows);
    return fine;
}

bool craig_rows_of(const armtol_arm *arm, angle_unit angle_unit, arm_model *table)
{
    moved moved;
    if (!get_room(&moved, arm->n_links)) {
        return false;
    }
    to_rows(&moved, arm);
    const bool fine = arm_rows_make(&(arm_rows){moved.rows, moved.n, arm->masses != NULL}, arm, angle_unit, table);
    free(moved.rows);
    return fine;
}
