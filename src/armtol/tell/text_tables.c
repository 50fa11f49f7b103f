#include "armtol/tell/text_tables.h"

#include "console/table.h"

#include <math.h>
#include <stdio.h>

/* Prints and frees a table. */
static bool finish(table *table, const char *title, bool fine)
{
    if (fine) {
        table_print_title(title, NULL, FORMAT_TEXT, stdout);
        table_print(table, FORMAT_TEXT, stdout);
    }
    table_free(table);
    return fine;
}

static table_row *add_numbered(table *table, size_t number)
{
    char label[TABLE_CELL];
    snprintf(label, sizeof label, "%zu", number);
    return table_add(table, label);
}

/* A dash where there is nothing to say. */
static void set_digits(table_row *row, size_t column, int digits, double value)
{
    if (isnan(value)) {
        table_set(row, column, "-");
    } else {
        table_set(row, column, "%.*g", digits, value);
    }
}

static void set_number(table_row *row, size_t column, double value)
{
    set_digits(row, column, 6, value);
}

bool text_parameters(const findings *findings)
{
    static const char *const head[] = {"link", "kind", "parameter", "moved by", "nominal", "tolerance", "unit"};
    table table;
    table_start(&table, sizeof head / sizeof head[0]);
    bool fine = table_add_head(&table, head);
    for (size_t k = 0; k < findings->answer->n_columns && fine; k++) {
        const parameter_row parameter = findings_parameter(findings, k);
        table_row *row = add_numbered(&table, parameter.link);
        fine = row != NULL;
        if (fine) {
            table_set(row, 1, "%s", parameter.kind);
            table_set(row, 2, "%s", parameter.parameter);
            table_set(row, 3, "%s", parameter.role);
            set_number(row, 4, parameter.nominal);
            set_number(row, 5, parameter.tolerance);
            table_set(row, 6, "%s", parameter.unit);
        }
    }
    return finish(&table, "Parameters", fine);
}

static void fill_part(const findings *findings, size_t link, table_row *row)
{
    const units *units = &findings->request->units;
    const armtol_part *part = &findings->answer->parts[link];
    const armtol_joint joint = findings->answer->links[link].joint;
    const bool slides = joint == ARMTOL_PRISMATIC;
    set_number(row, 1, units_shown(units, true, part->distance));
    set_number(row, 2, units_shown(units, false, part->angle));
    set_number(row, 3, units_shown(units, slides, part->motor));
    table_set(row, 4, "%s", joint == ARMTOL_FIXED ? "-" : units_name(units, slides));
    set_number(row, 5, units_shown(units, slides, part->drive));
    table_set(row, 6, "%s", isnan(part->drive) ? "-" : part->drive <= part->motor ? "yes" : "NO");
}

bool text_parts(const findings *findings)
{
    static const char *const head[] = {"link", "distance", "angle", "motor", "unit", "its drive", "good enough"};
    const armtol_answer *answer = findings->answer;
    bool drives = false;
    for (size_t i = 0; i < answer->n_links; i++) {
        drives = drives || !isnan(findings->answer->parts[i].drive);
    }
    table table;
    table_start(&table, drives ? 7 : 5);
    bool fine = table_add_head(&table, head);
    for (size_t i = 0; i < answer->n_links && fine; i++) {
        table_row *row = add_numbered(&table, i);
        fine = row != NULL;
        if (fine) {
            fill_part(findings, i, row);
        }
    }
    return finish(&table, "Parts: distance between the axes, smallest angle, motor", fine);
}

static void fill_component(const findings *findings, size_t i, table_row *row)
{
    const request *request = findings->request;
    const double *accuracy = request->question.accuracy;
    const armtol_predicted *component = &findings->answer->components[i];
    if (accuracy != NULL && isinf(accuracy[i])) {
        table_set(row, 1, "free");
    } else {
        set_number(row, 1, accuracy != NULL ? findings_shown(findings, i, accuracy[i]) : (double)NAN);
    }
    set_number(row, 2, findings_shown(findings, i, component->worst));
    set_number(row, 3, findings_shown(findings, i, request->options->sigma * component->deviation));
    set_number(row, 4, findings_shown(findings, i, component->remainder));
    table_set(row, 5, "%s", units_name(&request->units, i < 3));
    table_set(row, 6, component->binds > 5e-4 ? "%.1f %%" : "-", 100 * component->binds);
}

bool text_components(const findings *findings)
{
    const request *request = findings->request;
    const bool optimum = request->tolerances == NULL && request->options->method != ARMTOL_METHOD_SPHERE;
    const bool along_tool = request->options->frame == ARMTOL_TOOL_FRAME;
    char sigma[32];
    snprintf(sigma, sizeof sigma, "%g sigma", request->options->sigma);
    const char *const head[] = {"component", "accuracy", "worst case", sigma, "remainder", "unit", "held down by it"};
    table table;
    table_start(&table, optimum ? 7 : 6);
    bool fine = table_add_head(&table, head);
    for (size_t i = 0; i < 6 && fine; i++) {
        table_row *row = table_add(&table, armtol_component_name(i));
        fine = row != NULL;
        if (fine) {
            fill_component(findings, i, row);
        }
    }
    return finish(&table, along_tool ? "Error of the tool, along its own axes" : "Error of the tool, along the base's axes",
                  fine);
}

static void fill_verified(const findings *findings, size_t i, table_row *row)
{
    const armtol_predicted *predicted = &findings->answer->components[i];
    const armtol_verified *component = &findings->verification->components[i];
    size_t at = 1;
    for (int j = 0; j < ARMTOL_QUANTILES; j++) {
        set_digits(row, at++, 4, findings_shown(findings, i, component->quantiles[j]));
    }
    set_digits(row, at++, 4, findings_shown(findings, i, component->worst_drawn));
    set_digits(row, at++, 6, findings_shown(findings, i, component->worst_corner));
    set_digits(row, at++, 6, findings_shown(findings, i, predicted->worst));
    set_digits(row, at, 2, findings_shown(findings, i, predicted->remainder));
}

static void print_share(const findings *findings)
{
    const armtol_verification *found = findings->verification;
    const double drawn = (double)found->drawn;
    if (findings->request->question.accuracy == NULL || found->drawn == 0) {
        return;
    }
    printf("\n%llu of %llu arms are within the accuracy: %.4f %% (95 %% sure: %.4f to %.4f %%)\n",
           (unsigned long long)found->within, (unsigned long long)found->drawn, 100 * (double)found->within / drawn,
           100 * found->share_low, 100 * found->share_high);
    printf("%llu are outside by more than the remainder\n", (unsigned long long)found->beyond);
}

bool text_verification(const findings *findings)
{
    char quantiles[ARMTOL_QUANTILES][24];
    const char *head[ARMTOL_QUANTILES + 5] = {"error"};
    size_t at = 1;
    for (int j = 0; j < ARMTOL_QUANTILES; j++) {
        snprintf(quantiles[j], sizeof quantiles[j], "%g %%", 100 * findings->verification->probabilities[j]);
        head[at++] = quantiles[j];
    }
    head[at++] = "worst";
    head[at++] = "corner";
    head[at++] = "by A";
    head[at++] = "remainder";
    char title[128];
    table table;
    table_start(&table, at);
    bool fine = table_add_head(&table, head);
    for (size_t i = 0; i < 6 && fine; i++) {
        char label[TABLE_CELL];
        snprintf(label, sizeof label, "%s, %s", armtol_component_name(i), units_name(&findings->request->units, i < 3));
        table_row *row = table_add(&table, label);
        fine = row != NULL;
        if (fine) {
            fill_verified(findings, i, row);
        }
    }
    snprintf(title, sizeof title, "%llu arms drawn within the tolerances (seed %llu): errors not exceeded by",
             (unsigned long long)findings->verification->drawn,
             (unsigned long long)findings->request->options->seed);
    fine = finish(&table, title, fine);
    if (fine) {
        print_share(findings);
    }
    return fine;
}
