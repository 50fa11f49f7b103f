/* Tallies of rows of a map: what was found in each point. */

#include "armtol/cluster/tally_file.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char *subject(size_t number)
{
    static const char *const names[ROWS_SUBJECTS] = {"arm",  "pose",       "plane", "value",
                                                     "tool", "tolerances", "loads", "accuracy"};
    return names[number];
}

/* The number of rows is known not to be 0, and none of them large enough for the products to overflow. */
static bool is_sound(const tally_head *head)
{
    const uint64_t points = head->numbers[ROWS_POINTS], joints = head->numbers[ROWS_JOINTS];
    return points >= 1 && points <= ROWS_MOST_POINTS && head->total * points <= ROWS_MOST_POINTS &&
           joints <= ROWS_MOST_VALUES && head->total * points * joints <= ROWS_MOST_VALUES;
}

static void free_rows(tally_rows *rows)
{
    free(rows->points);
    free(rows->values);
    free(rows->q);
    *rows = (tally_rows){0};
}

static bool start(tally_content *content, const tally_head *head, uint64_t count)
{
    tally_rows *rows = &content->rows;
    free_rows(rows);
    rows->n_points = (size_t)(count * head->numbers[ROWS_POINTS]);
    rows->n_joints = (size_t)head->numbers[ROWS_JOINTS];
    rows->points = calloc(rows->n_points, sizeof *rows->points);
    rows->values = calloc(rows->n_points, sizeof *rows->values);
    rows->q = calloc(rows->n_points * rows->n_joints + 1, sizeof *rows->q); /* an arm may have no joint */
    return rows->points != NULL && rows->values != NULL && rows->q != NULL;
}

enum { MEMBERS = 3 };

static size_t member_count(void)
{
    return MEMBERS;
}

static armtol_tally_member member(const tally_content *content, size_t number)
{
    const tally_rows *rows = &content->rows;
    const armtol_tally_member members[MEMBERS] = {
        {"point", rows->n_points, rows->points, NULL},
        {"value", rows->n_points, NULL, rows->values},
        {"q", rows->n_points * rows->n_joints, NULL, rows->q},
    };
    return members[number];
}

static bool point_fits(const tally_rows *rows, size_t k)
{
    const uint64_t known = rows->points[k];
    const bool reached = (known & ROWS_REACHED) != 0, found = (known & ROWS_FOUND) != 0;
    bool fine = known <= (ROWS_REACHED | ROWS_IN_VAIN) && (reached || !found);
    for (size_t j = 0; j < rows->n_joints && reached; j++) {
        fine = fine && isfinite(rows->q[k * rows->n_joints + j]);
    }
    return fine && (!reached || rows->values[k] >= 0);
}

static bool fits(const tally_content *content, const tally_head *head)
{
    bool fine = true;
    (void)head;
    for (size_t k = 0; k < content->rows.n_points; k++) {
        fine = fine && point_fits(&content->rows, k);
    }
    return fine;
}

static void add(tally_content *into, const tally_content *part, const tally_head *head)
{
    const tally_rows *from = &part->rows, *to = &into->rows;
    const size_t first = (size_t)(tally_head_range(head).first * head->numbers[ROWS_POINTS]);
    memcpy(to->points + first, from->points, from->n_points * sizeof *to->points);
    memcpy(to->values + first, from->values, from->n_points * sizeof *to->values);
    memcpy(to->q + first * to->n_joints, from->q, from->n_points * to->n_joints * sizeof *to->q);
}

const tally_form tally_of_rows = {
    .one = "row",
    .many = "rows",
    .number = "number of rows",
    .most = ROWS_MOST_POINTS,
    .n_numbers = 2,
    .numbers = {[ROWS_POINTS] = "points", [ROWS_JOINTS] = "joints"},
    .meanings = {[ROWS_POINTS] = "number of points", [ROWS_JOINTS] = "number of joints"},
    .n_subjects = ROWS_SUBJECTS,
    .subject = subject,
    .misfit = "the points cannot be those of a map: the tally is damaged",
    .is_sound = is_sound,
    .start = start,
    .member_count = member_count,
    .member = member,
    .fits = fits,
    .add = add,
};

void tally_content_free(tally_content *content)
{
    armtol_tally_destroy(content->arms);
    content->arms = NULL;
    free_rows(&content->rows);
}
