#include "lab/yield/tables.h"

#include "1987/report.h"

#include <stdio.h>
#include <string.h>

static const char *const set_names[SET_COUNT] = {"published", "corrected"};

/* Adds the cells after the first, which names case and set. */
typedef void add_cells(const set_result *set, table *table);

/* A table of a row for each case and set. */
static bool print_sets(const yield_case cases[], size_t n_cases, table_format format, const char *title,
                       const char *head, add_cells *add)
{
    table table = TABLE_EMPTY;
    table_add(&table, "%s", head);
    for (size_t i = 0; i < n_cases; i++) {
        for (int s = 0; s < SET_COUNT; s++) {
            table_add(&table, "%s %d, %s", cases[i].program, cases[i].case_number, set_names[s]);
            add(&cases[i].sets[s], &table);
        }
    }
    return table_finish(&table, title, NULL, format, stdout);
}

static void add_share(const set_result *set, table *table)
{
    const arm_draws *draws = &set->draws;
    const armtol_share_interval interval = armtol_share_interval_95(draws->within, draws->samples);
    table_add_cells(table, "%.6f\t%.6f\t%zu\t%.3f\t%.3f to %.3f\t%s", set->length, set->angle, draws->within,
                    100 * (double)draws->within / (double)draws->samples, 100 * interval.low, 100 * interval.high,
                    set->all_within ? "yes" : "no");
}

static void add_spread(const error_spread *spread, int decimals, table *table)
{
    for (size_t i = 0; i < QUANTILE_COUNT; i++) {
        table_add_cells(table, "%.*f", decimals, spread->quantiles[i]);
    }
    table_add_cells(table, "%.*f", decimals, spread->worst);
}

static void add_linear(const set_result *set, table *table)
{
    add_spread(&set->draws.linear, 4, table);
}

static void add_distance(const set_result *set, table *table)
{
    add_spread(&set->draws.distance, 4, table);
}

static void add_angular(const set_result *set, table *table)
{
    add_spread(&set->draws.angular, 6, table);
}

static void add_worst(const set_result *set, table *table)
{
    const corner *worst = &set->worst;
    table_add_cells(table, "%c%s\t%.4f\t%.4f\t%.4f\t%.4f\t%.4f", worst->sign > 0 ? '+' : '-',
                    tolerance_names[worst->row], set->rows[worst->row].prediction, worst->largest, worst->distance,
                    set->farthest, set->remainder);
}

static bool print_shares(const yield_case cases[], size_t n_cases, const yield_options *options)
{
    char title[160];
    snprintf(title, sizeof title, "Arms within the accuracy, of %zu drawn (seed %llu, lengths within %s)",
             options->samples, (unsigned long long)options->seed,
             options->reading == LENGTHS_RD ? "rd where a link has one" : "their share");
    return print_sets(cases, n_cases, options->format, title,
                      "tolerances\tlength, mm\tangle, rad\tarms within\twithin, %\t95 % interval, %\t"
                      "all, by the bounds",
                      add_share);
}

static bool print_spreads(const yield_case cases[], size_t n_cases, table_format format)
{
    char head[160] = "not exceeded by";
    for (int i = 0; i < QUANTILE_COUNT; i++) {
        const size_t length = strlen(head);
        snprintf(head + length, sizeof head - length, "\t%zu %% of arms%s", quantile_percents[i],
                 i + 1 < QUANTILE_COUNT ? "" : "\tany drawn");
    }
    return print_sets(cases, n_cases, format, "Largest linear component of the tool's error, mm", head, add_linear) &&
           print_sets(cases, n_cases, format, "Distance of the tool point from where it should be, mm", head,
                      add_distance) &&
           print_sets(cases, n_cases, format, "Largest angular component of the tool's error, rad", head, add_angular);
}

static bool print_worst(const yield_case cases[], size_t n_cases, table_format format)
{
    return print_sets(cases, n_cases, format, "Worst corner, mm",
                      "tolerances\tcorner of\tfirst order\tlargest component\ttool point there\t"
                      "farthest tool point\tremainder, at most",
                      add_worst);
}

/* The six components of a case, each at its own corners. */
static bool print_components(const yield_case *one, table_format format)
{
    char title[96];
    table table = TABLE_EMPTY;
    table_add(&table, "component\tasked for\tpublished: first order\t+ corner\t- corner\t"
                      "corrected: first order\t+ corner\t- corner");
    for (size_t i = 0; i < 6; i++) {
        table_add(&table, "%s\t%g", tolerance_names[i], one->accuracy[i]);
        for (size_t s = 0; s < SET_COUNT; s++) {
            const row_corners *corners = &one->sets[s].rows[i];
            table_add_cells(&table, "%.6f\t%.6f\t%.6f", corners->prediction, corners->high, corners->low);
        }
    }
    snprintf(title, sizeof title, "%s, case %d: every component at its corners, mm and rad", one->program,
             one->case_number);
    return table_finish(&table, title, NULL, format, stdout);
}

bool yield_tables_print(const yield_case cases[], size_t n_cases, const yield_options *options)
{
    bool fine = print_shares(cases, n_cases, options) && print_spreads(cases, n_cases, options->format) &&
                print_worst(cases, n_cases, options->format);
    for (size_t i = 0; i < n_cases && fine; i++) {
        fine = print_components(&cases[i], options->format);
    }
    return fine;
}
