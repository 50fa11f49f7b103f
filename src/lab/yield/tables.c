#include "lab/yield/tables.h"

#include "1987/report.h"

#include <stdio.h>

static const char *const set_names[SET_COUNT] = {"published", "corrected"};

/* Fills the cells after the first, which names case and set. */
typedef void fill_row(const set_result *set, table_row *row);

static bool add_sets(table *table, const yield_case *one, fill_row *fill)
{
    for (int s = 0; s < SET_COUNT; s++) {
        char label[TABLE_CELL];
        snprintf(label, sizeof label, "%s %d, %s", one->program, one->case_number, set_names[s]);
        table_row *row = table_add(table, label);
        if (row == NULL) {
            return false;
        }
        fill(&one->sets[s], row);
    }
    return true;
}

static void finish(table *table, const char *title, table_format format)
{
    table_print_title(title, NULL, format, stdout);
    table_print(table, format, stdout);
}

/* A table of a row for each case and set. */
static bool print_sets(const yield_case cases[], size_t n_cases, table_format format, const char *title,
                       const char *const head[], size_t n_columns, fill_row *fill)
{
    table table;
    table_start(&table, n_columns);
    bool fine = table_add_head(&table, head);
    for (size_t i = 0; i < n_cases && fine; i++) {
        fine = add_sets(&table, &cases[i], fill);
    }
    if (fine) {
        finish(&table, title, format);
    }
    table_free(&table);
    return fine;
}

static void fill_share(const set_result *set, table_row *row)
{
    const arm_draws *draws = &set->draws;
    const armtol_share_interval interval = armtol_share_interval_95(draws->within, draws->samples);
    table_set(row, 1, "%.6f", set->length);
    table_set(row, 2, "%.6f", set->angle);
    table_set(row, 3, "%zu", draws->within);
    table_set(row, 4, "%.3f", 100 * (double)draws->within / (double)draws->samples);
    table_set(row, 5, "%.3f to %.3f", 100 * interval.low, 100 * interval.high);
    table_set(row, 6, "%s", set->all_within ? "yes" : "no");
}

static void fill_spread(const error_spread *spread, int decimals, table_row *row)
{
    for (size_t i = 0; i < QUANTILE_COUNT; i++) {
        table_set(row, i + 1, "%.*f", decimals, spread->quantiles[i]);
    }
    table_set(row, QUANTILE_COUNT + 1, "%.*f", decimals, spread->worst);
}

static void fill_linear(const set_result *set, table_row *row)
{
    fill_spread(&set->draws.linear, 4, row);
}

static void fill_distance(const set_result *set, table_row *row)
{
    fill_spread(&set->draws.distance, 4, row);
}

static void fill_angular(const set_result *set, table_row *row)
{
    fill_spread(&set->draws.angular, 6, row);
}

static void fill_worst(const set_result *set, table_row *row)
{
    const corner *worst = &set->worst;
    table_set(row, 1, "%c%s", worst->sign > 0 ? '+' : '-', tolerance_names[worst->row]);
    table_set(row, 2, "%.4f", set->rows[worst->row].prediction);
    table_set(row, 3, "%.4f", worst->largest);
    table_set(row, 4, "%.4f", worst->distance);
    table_set(row, 5, "%.4f", set->farthest);
    table_set(row, 6, "%.4f", set->remainder);
}

static bool print_shares(const yield_case cases[], size_t n_cases, const yield_options *options)
{
    static const char *const head[] = {"tolerances", "length, mm",       "angle, rad",        "arms within",
                                       "within, %",  "95 % interval, %", "all, by the bounds"};
    char title[160];
    snprintf(title, sizeof title, "Arms within the accuracy, of %zu drawn (seed %llu, lengths within %s)",
             options->samples, (unsigned long long)options->seed,
             options->reading == LENGTHS_RD ? "rd where a link has one" : "their share");
    return print_sets(cases, n_cases, options->format, title, head, 7, fill_share);
}

static bool print_spreads(const yield_case cases[], size_t n_cases, table_format format)
{
    static const struct {
        const char *title;
        fill_row *fill;
    } spreads[] = {
        {"Largest linear component of the tool's error, mm", fill_linear},
        {"Distance of the tool point from where it should be, mm", fill_distance},
        {"Largest angular component of the tool's error, rad", fill_angular},
    };
    char cells[QUANTILE_COUNT][24];
    const char *head[QUANTILE_COUNT + 2] = {"not exceeded by"};
    for (int i = 0; i < QUANTILE_COUNT; i++) {
        snprintf(cells[i], sizeof cells[i], "%zu %% of arms", quantile_percents[i]);
        head[i + 1] = cells[i];
    }
    head[QUANTILE_COUNT + 1] = "any drawn";
    bool fine = true;
    for (size_t i = 0; i < sizeof spreads / sizeof spreads[0] && fine; i++) {
        fine = print_sets(cases, n_cases, format, spreads[i].title, head, QUANTILE_COUNT + 2,
                          spreads[i].fill);
    }
    return fine;
}

static bool print_worst(const yield_case cases[], size_t n_cases, table_format format)
{
    static const char *const head[] = {"tolerances",         "corner of",        "first order",
                                       "largest component",  "tool point there", "farthest tool point",
                                       "remainder, at most"};
    return print_sets(cases, n_cases, format, "Worst corner, mm", head, 7, fill_worst);
}

/* The six components of a case, each at its own corners. */
static bool add_components(table *table, const yield_case *one)
{
    for (size_t i = 0; i < 6; i++) {
        table_row *row = table_add(table, tolerance_names[i]);
        if (row == NULL) {
            return false;
        }
        table_set(row, 1, "%g", one->accuracy[i]);
        for (size_t s = 0; s < SET_COUNT; s++) {
            const row_corners *corners = &one->sets[s].rows[i];
            table_set(row, 3 * s + 2, "%.6f", corners->prediction);
            table_set(row, 3 * s + 3, "%.6f", corners->high);
            table_set(row, 3 * s + 4, "%.6f", corners->low);
        }
    }
    return true;
}

static bool print_components(const yield_case *one, table_format format)
{
    static const char *const head[] = {"component", "asked for", "published: first order", "+ corner",
                                       "- corner",  "corrected: first order", "+ corner", "- corner"};
    char title[96];
    table table;
    snprintf(title, sizeof title, "%s, case %d: every component at its corners, mm and rad", one->program,
             one->case_number);
    table_start(&table, sizeof head / sizeof head[0]);
    const bool fine = table_add_head(&table, head) && add_components(&table, one);
    if (fine) {
        finish(&table, title, format);
    }
    table_free(&table);
    return fine;
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
