#include "lab/reproduce/measure.h"

#include "lab/recompute.h"
#include "lab/reproduce/compare.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Distance and angle bound of a case with these errata, in two more cells. */
static bool add_bounds(const published_list *list, size_t first, const armtol_errata *errata, table *table)
{
    analysis analysis;
    const bool fine = !table->failed && recompute(list, first, errata, NULL, &analysis);
    if (fine) {
        table_add_cells(table, "%.6f\t%.6f", analysis.bounds.distance, analysis.bounds.angle);
        analysis_free(&analysis);
    }
    return fine;
}

static armtol_errata with_one(armtol_errata errata, const char *id, bool keep)
{
    armtol_erratum_keep(&errata, id, keep);
    return errata;
}

static bool errata_rows(const published_list *list, size_t first, table *table)
{
    table_add(table, "erratum\twithout it: mm\twithout it: rad\tit alone: mm\tit alone: rad");
    table_add(table, "(all as of 1987; none)");
    bool fine = add_bounds(list, first, &armtol_errata_1987, table) &&
                add_bounds(list, first, &armtol_errata_none, table);
    for (size_t i = 0; i < armtol_errata_count() && fine; i++) {
        const char *id = armtol_erratum(i)->id;
        const armtol_errata without = with_one(armtol_errata_1987, id, false);
        const armtol_errata alone = with_one(armtol_errata_none, id, true);
        table_add(table, "%s", id);
        fine = add_bounds(list, first, &without, table) && add_bounds(list, first, &alone, table);
    }
    return fine;
}

static bool walk_rows(const published_list *list, size_t first, table *table)
{
    armtol_errata errata = armtol_errata_1987;
    table_add(table, "corrected so far\tdistance bound, mm\tangle bound, rad");
    table_add(table, "nothing");
    bool fine = add_bounds(list, first, &errata, table);
    for (size_t i = 0; i < armtol_errata_count() && fine; i++) {
        errata = with_one(errata, armtol_erratum(i)->id, false);
        table_add(table, "+ %s", armtol_erratum(i)->id);
        fine = add_bounds(list, first, &errata, table);
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
static void add_ways(const published_number *number, char *const files[WAYS], size_t agreeing[WAYS], table *table)
{
    table_add(table, "%s %d: %s\t%s", number->program, number->case_number, number->quantity, number->value);
    for (int w = 0; w < WAYS; w++) {
        const comparison comparison = compare_number(number, files[w]);
        const bool agrees = compare_agrees(&comparison);
        agreeing[w] += agrees;
        table_add_cells(table, "%s%s", agrees ? "" : "* ", comparison.computed);
    }
}

static bool portability_rows(const published_list *list, table *table)
{
    char *files[WAYS] = {NULL};
    size_t agreeing[WAYS] = {0}, results = 0;
    bool fine = true;
    table_add(table, "number\tpublished\tfloat, 3.14159\tfloat, pi\tdouble, 3.14159\tdouble, pi");
    for (size_t i = 0; i < list->count && fine; i++) {
        if (published_begins_case(list, i)) {
            fine = !table->failed && recompute_ways(list, i, files);
        }
        if (fine && list->numbers[i].role == ROLE_RESULT) {
            add_ways(&list->numbers[i], files, agreeing, table);
            results++;
        }
    }
    free_files(files);
    table_add(table, "reproduced\t");
    for (int w = 0; w < WAYS; w++) {
        table_add_cells(table, "%zu of %zu", agreeing[w], results);
    }
    return fine;
}

/* Print the table under its title unless rows were not to be had; free it. */
static bool finish(table *table, bool fine, const char *title, table_format format)
{
    table->failed = table->failed || !fine;
    return table_finish(table, title, NULL, format, stdout);
}

/* One table a case. */
static bool tables(const published_list *list, table_format format,
                   bool (*rows)(const published_list *, size_t, table *))
{
    bool fine = true;
    for (size_t i = 0; i < list->count && fine; i++) {
        if (published_begins_case(list, i)) {
            char title[TABLE_CELL];
            table table = TABLE_EMPTY;
            snprintf(title, sizeof title, "%s, case %d", list->numbers[i].program, list->numbers[i].case_number);
            fine = rows(list, i, &table);
            fine = finish(&table, fine, title, format);
        }
    }
    return fine;
}

bool measure_errata(const published_list *list, table_format format)
{
    return tables(list, format, errata_rows);
}

bool measure_walk(const published_list *list, table_format format)
{
    return tables(list, format, walk_rows);
}

bool measure_portability(const published_list *list, table_format format)
{
    table table = TABLE_EMPTY;
    const bool fine = portability_rows(list, &table);
    return finish(&table, fine, NULL, format);
}
