#include "lab/reproduce/measure.h"

#include "lab/recompute.h"
#include "lab/reproduce/compare.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Distance and angle bound of a case with these errata, in two neighbouring cells. */
static bool set_bounds(const published_list *list, size_t first, const armtol_errata *errata, table_row *row,
                       size_t column)
{
    analysis analysis;
    if (!recompute(list, first, errata, &analysis)) {
        return false;
    }
    table_set(row, column, "%.6f", analysis.bounds.distance);
    table_set(row, column + 1, "%.6f", analysis.bounds.angle);
    analysis_free(&analysis);
    return true;
}

static armtol_errata with_one(armtol_errata errata, const char *id, bool keep)
{
    armtol_erratum_keep(&errata, id, keep);
    return errata;
}

static bool errata_rows(const published_list *list, size_t first, table *table)
{
    static const char *const head[] = {"erratum",      "without it: mm", "without it: rad",
                                       "it alone: mm", "it alone: rad"};
    table_row *row;
    bool fine = table_add_head(table, head) && (row = table_add(table, "(all as of 1987; none)")) != NULL &&
                set_bounds(list, first, &armtol_errata_1987, row, 1) &&
                set_bounds(list, first, &armtol_errata_none, row, 3);
    for (size_t i = 0; i < armtol_errata_count() && fine; i++) {
        const char *id = armtol_erratum(i)->id;
        const armtol_errata without = with_one(armtol_errata_1987, id, false);
        const armtol_errata alone = with_one(armtol_errata_none, id, true);
        row = table_add(table, id);
        fine = row != NULL && set_bounds(list, first, &without, row, 1) && set_bounds(list, first, &alone, row, 3);
    }
    return fine;
}

static bool walk_rows(const published_list *list, size_t first, table *table)
{
    static const char *const head[] = {"corrected so far", "distance bound, mm", "angle bound, rad"};
    armtol_errata errata = armtol_errata_1987;
    table_row *row;
    bool fine = table_add_head(table, head) && (row = table_add(table, "nothing")) != NULL &&
                set_bounds(list, first, &errata, row, 1);
    for (size_t i = 0; i < armtol_errata_count() && fine; i++) {
        char label[TABLE_CELL];
        snprintf(label, sizeof label, "+ %s", armtol_erratum(i)->id);
        errata = with_one(errata, armtol_erratum(i)->id, false);
        row = table_add(table, label);
        fine = row != NULL && set_bounds(list, first, &errata, row, 1);
    }
    return fine;
}

/* The four ways to compute: float or double storage, short or true pi. */
enum { WAYS = 4 };

static armtol_errata way(int index)
{
    armtol_errata errata = armtol_errata_1987;
    errata.float_storage = index < 2;
    errata.short_pi = index % 2 == 0;
    return errata;
}

static void free_files(char *files[WAYS])
{
    for (int w = 0; w < WAYS; w++) {
        free(files[w]);
        files[w] = NULL;
    }
}

static bool recompute_ways(const published_list *list, size_t first, char *files[WAYS])
{
    bool fine = true;
    free_files(files);
    for (int w = 0; w < WAYS && fine; w++) {
        const armtol_errata errata = way(w);
        files[w] = recompute_files(list, first, &errata);
        fine = files[w] != NULL;
    }
    return fine;
}

/* One published number and what each way makes of it; a star where they differ. */
static bool add_ways(const published_number *number, char *const files[WAYS], size_t agreeing[WAYS], table *table)
{
    char label[2 * TABLE_CELL]; /* the cell cuts it */
    snprintf(label, sizeof label, "%s %d: %s", number->program, number->case_number, number->quantity);
    table_row *row = table_add(table, label);
    if (row == NULL) {
        return false;
    }
    table_set(row, 1, "%s", number->value);
    for (int w = 0; w < WAYS; w++) {
        const comparison comparison = compare_number(number, files[w]);
        const bool agrees = compare_agrees(&comparison);
        agreeing[w] += agrees;
        table_set(row, (size_t)w + 2, "%s%s", agrees ? "" : "* ", comparison.computed);
    }
    return true;
}

static bool portability_rows(const published_list *list, table *table)
{
    static const char *const head[] = {"number",       "published",         "float, 3.14159",
                                       "float, pi", "double, 3.14159", "double, pi"};
    char *files[WAYS] = {NULL};
    size_t agreeing[WAYS] = {0}, results = 0;
    bool fine = table_add_head(table, head);
    for (size_t i = 0; i < list->count && fine; i++) {
        if (published_begins_case(list, i)) {
            fine = recompute_ways(list, i, files);
        }
        if (fine && list->numbers[i].role == ROLE_RESULT) {
            fine = add_ways(&list->numbers[i], files, agreeing, table);
            results++;
        }
    }
    free_files(files);
    table_row *row = fine ? table_add(table, "reproduced") : NULL;
    for (int w = 0; w < WAYS && row != NULL; w++) {
        table_set(row, (size_t)w + 2, "%zu of %zu", agreeing[w], results);
    }
    return row != NULL;
}

static void print_title(const published_number *number, table_format format)
{
    char title[TABLE_CELL];
    snprintf(title, sizeof title, "%s, case %d", number->program, number->case_number);
    table_print_title(title, NULL, format, stdout);
}

/* One table a case. */
static bool tables(const published_list *list, table_format format, size_t n_columns,
                   bool (*rows)(const published_list *, size_t, table *))
{
    bool fine = true;
    for (size_t i = 0; i < list->count && fine; i++) {
        if (published_begins_case(list, i)) {
            table table;
            table_start(&table, n_columns);
            fine = rows(list, i, &table);
            if (fine) {
                print_title(&list->numbers[i], format);
                table_print(&table, format, stdout);
            }
            table_free(&table);
        }
    }
    return fine;
}

bool measure_errata(const published_list *list, table_format format)
{
    return tables(list, format, 5, errata_rows);
}

bool measure_walk(const published_list *list, table_format format)
{
    return tables(list, format, 3, walk_rows);
}

bool measure_portability(const published_list *list, table_format format)
{
    table table;
    table_start(&table, 2 + WAYS);
    const bool fine = portability_rows(list, &table);
    if (fine) {
        table_print(&table, format, stdout);
    }
    table_free(&table);
    return fine;
}
