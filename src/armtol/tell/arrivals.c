/* Arms that come to a pose again and again, as text and as JSON: docs/iso9283.md. */

#include "armtol/tell/output.h"
#include "armtol/tell/text_tables.h"
#include "armtol/forms/wrap.h"
#include "console/table.h"

#include <math.h>
#include <stdio.h>

enum { MOST_ROWS = 24 };

static double shown(const findings *findings, double value)
{
    return units_shown(&findings->request->units, true, value);
}

/* ---- text ---- */

static void add_value(table *table, const findings *findings, double value)
{
    table_add_cells(table, isnan(value) ? "-" : "%.4g", shown(findings, value));
}

static void add_over(table *table, const findings *findings, const armtol_over_arms *over)
{
    for (size_t i = 0; i < ARMTOL_ARRIVAL_QUANTILES; i++) {
        add_value(table, findings, over->quantiles[i]);
    }
    add_value(table, findings, over->largest);
}

/* The same of both numbers, one below the other: who reads a pose reads both. */
static void add_repeated(table *table, const findings *findings, const char *pose, const armtol_repeated *repeated)
{
    table_add(table, "%s\tAP", pose);
    add_over(table, findings, &repeated->accuracy);
    table_add(table, "%s\tRP", pose);
    add_over(table, findings, &repeated->repeatability);
}

static void add_pose(table *table, const findings *findings, size_t place)
{
    const size_t n_loads = findings->answer->n_loads;
    char pose[64];
    const int written = snprintf(pose, sizeof pose, "%zu", place / n_loads + 1);
    if (n_loads > 1) {
        snprintf(pose + written, sizeof pose - (size_t)written, ", load %zu", place % n_loads + 1);
    }
    add_repeated(table, findings, pose, &findings->arrivals->poses[place]);
}

static void say_arrivals(const findings *findings)
{
    const armtol_arrivals *arrivals = findings->arrivals;
    wrap wrap;
    printf("\n");
    wrap_start(&wrap, stdout, 0, 0);
    wrap_say(&wrap, "%llu arms that come to %s %zu times: pose accuracy AP and pose repeatability RP of the position "
                    "(ISO 9283), in %s, not exceeded by",
             (unsigned long long)arrivals->drawn, arrivals->n_poses > 1 ? "each pose" : "the pose", arrivals->cycles,
             units_name(&findings->request->units, true));
    wrap_end(&wrap);
    printf("\n");
}

bool text_arrivals(const findings *findings)
{
    const armtol_arrivals *arrivals = findings->arrivals;
    table table = TABLE_EMPTY;
    table_add(&table, "pose\t");
    for (size_t i = 0; i < ARMTOL_ARRIVAL_QUANTILES; i++) {
        table_add_cells(&table, "%g %%", 100 * arrivals->probabilities[i]);
    }
    table_add_cells(&table, "worst");
    size_t place = 0;
    for (; place < arrivals->n_poses && 2 * place < MOST_ROWS; place++) {
        add_pose(&table, findings, place);
    }
    if (arrivals->n_poses > 1) {
        add_repeated(&table, findings, "largest of all", &arrivals->all);
    }
    say_arrivals(findings);
    const bool fine = table_finish(&table, NULL, NULL, FORMAT_TEXT, stdout);
    if (fine && place < arrivals->n_poses) {
        printf("  and %zu more poses (--json has all)\n", arrivals->n_poses - place);
    }
    if (fine && isnan(arrivals->all.accuracy.largest)) {
        printf("\nAP is not known: the position depends on parameters without a bound.\n");
    }
    return fine;
}

/* ---- JSON ---- */

static void write_over(json *json, const findings *findings, const char *name, const armtol_over_arms *over)
{
    double quantiles[ARMTOL_ARRIVAL_QUANTILES];
    for (size_t i = 0; i < ARMTOL_ARRIVAL_QUANTILES; i++) {
        quantiles[i] = shown(findings, over->quantiles[i]);
    }
    json_open_object(json, name);
    json_numbers(json, "quantiles", quantiles, ARMTOL_ARRIVAL_QUANTILES);
    json_number(json, "worst", shown(findings, over->largest));
    if (!isnan(over->largest)) {
        json_count(json, "worst_arm", over->largest_arm);
    }
    json_close_object(json);
}

static void write_repeated(json *json, const findings *findings, const armtol_repeated *repeated)
{
    write_over(json, findings, "ap", &repeated->accuracy);
    write_over(json, findings, "rp", &repeated->repeatability);
}

void json_arrivals(json *json, const findings *findings)
{
    const armtol_arrivals *arrivals = findings->arrivals;
    const size_t n_loads = findings->answer->n_loads;
    json_open_object(json, "iso9283");
    json_count(json, "asked", findings->request->options->verify);
    json_count(json, "drawn", arrivals->drawn);
    json_count(json, "cycles", arrivals->cycles);
    json_count(json, "seed", findings->request->options->seed);
    json_numbers(json, "probabilities", arrivals->probabilities, ARMTOL_ARRIVAL_QUANTILES);
    json_open_array(json, "poses");
    for (size_t place = 0; place < arrivals->n_poses; place++) {
        json_open_object(json, NULL);
        json_count(json, "pose", place / n_loads + 1);
        json_count(json, "load", place % n_loads + 1);
        write_repeated(json, findings, &arrivals->poses[place]);
        json_close_object(json);
    }
    json_close_array(json);
    json_open_object(json, "all");
    write_repeated(json, findings, &arrivals->all);
    json_close_object(json);
    json_close_object(json);
}
