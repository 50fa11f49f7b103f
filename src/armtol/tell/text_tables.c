#include "armtol/tell/text_tables.h"

#include "armtol/names/link_name.h"
#include "armtol/forms/wrap.h"
#include "console/table.h"

#include <math.h>
#include <stdio.h>

/* One cell more: a dash where there is nothing to say. */
static void add_digits(table *table, int digits, double value)
{
    if (isnan(value)) {
        table_add_cells(table, "-");
    } else {
        table_add_cells(table, "%.*g", digits, value);
    }
}

static void add_number(table *table, double value)
{
    add_digits(table, 6, value);
}

/* Whether a drive, or --given, says something of a tolerance. */
static bool any_is_set(const armtol_answer *answer)
{
    bool any = false;
    for (size_t k = 0; k < answer->n_columns; k++) {
        any = any || answer->given[k] || answer->held[k] != 0;
    }
    return any;
}

static bool any_is_spread(const armtol_answer *answer)
{
    bool any = false;
    for (size_t k = 0; k < answer->n_columns; k++) {
        any = any || answer->spreads[k].distribution != ARMTOL_UNIFORM;
    }
    return any;
}

static const char *origin_of(const parameter_row *row)
{
    return row->drawn ? "drawing" : row->given ? "given" : row->held > 0 ? "largest" : row->held < 0 ? "least" : "-";
}

bool text_parameters(const findings *findings)
{
    const bool spread = any_is_spread(findings->answer), shifted = findings_are_shifted(findings);
    const bool shows_origin = findings->request->tolerances == NULL && any_is_set(findings->answer);
    table table = {.n_more = 2, .cut_first = true};
    table_add(&table, "link\tkind\tparameter\tmoved by\tnominal\ttolerance\tunit%s%s%s",
              shifted ? "\tshift" : "", spread ? "\tspread" : "", shows_origin ? "\tset by" : "");
    for (size_t k = 0; k < findings->answer->n_columns; k++) {
        const parameter_row parameter = findings_parameter(findings, k);
        table_add(&table, "%s\t%s\t%s\t%s",
                  link_cell(findings->request->question.arm, parameter.link, &(link_text){""}), parameter.kind,
                  parameter.parameter, parameter.role);
        add_number(&table, parameter.nominal);
        add_number(&table, parameter.tolerance);
        table_add_cells(&table, "%s", parameter.unit);
        if (shifted) {
            add_number(&table, parameter.shift);
        }
        if (spread) {
            table_add_cells(&table, "%s", parameter.distribution.text);
        }
        table_add_cells(&table, "%s", origin_of(&parameter));
    }
    return table_finish(&table, "Parameters", NULL, FORMAT_TEXT, stdout);
}

/* What is equal on paper is: either number may have come from degrees or a sum. */
static bool is_enough(const armtol_part *part)
{
    return part->drive <= part->motor * (1 + 1e-12);
}

static void add_part(const findings *findings, size_t link, table *table)
{
    const units *units = &findings->request->units;
    const armtol_part *part = &findings->answer->parts[link];
    const armtol_joint joint = findings->answer->links[link].joint;
    const bool slides = joint == ARMTOL_PRISMATIC;
    table_add(table, "%s", link_cell(findings->request->question.arm, link, &(link_text){""}));
    add_number(table, units_shown(units, true, part->distance));
    add_number(table, units_shown(units, false, part->angle));
    add_number(table, units_shown(units, slides, part->motor));
    table_add_cells(table, "%s", joint == ARMTOL_FIXED ? "-" : units_name(units, slides));
    add_number(table, units_shown(units, slides, part->drive));
    table_add_cells(table, "%s", isnan(part->drive) ? "-" : is_enough(part) ? "yes" : "NO");
}

bool text_parts(const findings *findings)
{
    const armtol_answer *answer = findings->answer;
    bool drives = false;
    for (size_t i = 0; i < answer->n_links; i++) {
        drives = drives || !isnan(findings->answer->parts[i].drive);
    }
    table table = TABLE_EMPTY;
    table_add(&table, "link\tdistance\tangle\tmotor\tunit%s", !drives                                   ? ""
              : findings->request->question.drives_apart ? "\tits drive\tgood enough"
                                                         : "\tits drive");
    for (size_t i = 0; i < answer->n_links; i++) {
        add_part(findings, i, &table);
    }
    return table_finish(&table, "Parts: distance between the axes, smallest angle, motor", NULL, FORMAT_TEXT, stdout);
}

static void add_component(const findings *findings, size_t i, table *table)
{
    const request *request = findings->request;
    const double accuracy = findings_accuracy(findings, i);
    const armtol_predicted *component = findings_predicted(findings, i);
    table_add(table, "%s", findings_name(findings, i));
    if (isinf(accuracy)) {
        table_add_cells(table, "free");
    } else {
        add_number(table, findings_shown(findings, i, accuracy));
    }
    add_number(table, findings_shown(findings, i, component->worst));
    add_number(table, findings_shown(findings, i, findings_sigmas(findings, i)));
    if (findings->answer->shifted) {
        add_number(table, findings_shown(findings, i, component->shift));
    }
    add_number(table, findings_shown(findings, i, component->remainder));
    table_add_cells(table, "%s", units_name(&request->units, findings_is_length(findings, i)));
    if (request->question.n_poses > 1) {
        table_add_cells(table, "%zu", findings_pose(findings, i) + 1);
    }
    table_add_cells(table, component->binds > 5e-4 ? "%.1f %%" : "-", 100 * component->binds);
}

/* Accuracies that double precision cannot tell from 0. */
static void print_below_rounding(const findings *findings)
{
    for (size_t i = 0; i < findings_measures(findings); i++) {
        const double rounding = findings_predicted(findings, i)->rounding;
        if (findings_accuracy(findings, i) < rounding) {
            wrap wrap;
            printf("\n");
            wrap_start(&wrap, stdout, 0, 0);
            wrap_say(&wrap, "%s: the accuracy is less than the %.2g %s that rounding can make of an error of this arm: "
                            "numbers of double precision cannot tell whether it is kept.",
                     findings_name(findings, i), findings_shown(findings, i, rounding),
                     units_name(&findings->request->units, findings_is_length(findings, i)));
            wrap_end(&wrap);
        }
    }
}

/* An error is even within its tolerance, and few of them, or one that is larger than all others, do not make a bell. */
static void print_above_worst(const findings *findings)
{
    const double sigma = findings->request->options->sigma;
    size_t n = 0;
    const char *names[6 + ARMTOL_MOST_NORMS];
    for (size_t i = 0; i < findings_measures(findings); i++) {
        const double worst = findings_predicted(findings, i)->worst;
        if (isfinite(worst) && findings_sigmas(findings, i) > worst) {
            names[n++] = findings_name(findings, i);
        }
    }
    if (n > 0) {
        wrap wrap;
        printf("\n");
        wrap_start(&wrap, stdout, 0, 0);
        for (size_t i = 0; i < n; i++) {
            wrap_say(&wrap, "%s%s", names[i], i + 1 < n ? "," : ":");
        }
        wrap_say(&wrap, "%g sigma is more than the worst case. An error that is %s its tolerance has "
                        "extremes, and is not normal: where one or two such errors make most of a component, it "
                        "ends before %g standard deviations.", sigma,
                 any_is_spread(findings->answer) ? "cut at" : "even within", sigma);
        wrap_end(&wrap);
    }
}

/* What the column of shifts is called: by what they are. */
static const char *shift_head(const findings *findings)
{
    return findings_are_shifted(findings) ? "\tshift" : findings->answer->loaded ? "\tload" : "";
}

bool text_components(const findings *findings)
{
    const request *request = findings->request;
    const bool optimum = request->tolerances == NULL && request->options->method != ARMTOL_METHOD_SPHERE;
    const bool along_tool = request->options->frame == ARMTOL_TOOL_FRAME;
    table table = TABLE_EMPTY;
    table_add(&table, "component\taccuracy\tworst case\t%g sigma%s\tremainder\tunit%s%s", request->options->sigma,
              shift_head(findings),
              request->question.n_poses > 1 ? "\tpose" : "", optimum ? "\tbinds" : "");
    for (size_t i = 0; i < findings_measures(findings); i++) {
        add_component(findings, i, &table);
    }
    const bool fine = table_finish(&table,
                        along_tool ? "Error of the tool, along its own axes"
                                   : "Error of the tool, along the base's axes",
                        NULL, FORMAT_TEXT, stdout);
    if (fine) {
        text_norms(findings);
        print_above_worst(findings);
        print_below_rounding(findings);
    }
    return fine;
}

static void add_error(const findings *findings, size_t i, table *table)
{
    table_add(table, "%s, %s", findings_name(findings, i),
              units_name(&findings->request->units, findings_is_length(findings, i)));
}

static void add_drawn(const findings *findings, size_t i, table *table)
{
    const armtol_verified *component = findings_verified(findings, i);
    add_error(findings, i, table);
    for (int j = 0; j < ARMTOL_QUANTILES; j++) {
        add_digits(table, 4, findings_shown(findings, i, component->quantiles[j]));
    }
    add_digits(table, 4, findings_shown(findings, i, component->worst_drawn));
}

static bool print_drawn(const findings *findings)
{
    table table = TABLE_EMPTY;
    wrap wrap;
    table_add(&table, "error");
    for (int j = 0; j < ARMTOL_QUANTILES; j++) {
        table_add_cells(&table, "%g %%", 100 * findings->verification->probabilities[j]);
    }
    table_add_cells(&table, "worst");
    for (size_t i = 0; i < findings_measures(findings); i++) {
        add_drawn(findings, i, &table);
    }
    printf("\n");
    wrap_start(&wrap, stdout, 0, 0);
    wrap_say(&wrap, "%llu arms drawn within the tolerances%s (seed %llu): errors not exceeded by",
             (unsigned long long)findings->verification->drawn,
             any_is_spread(findings->answer) ? ", spread as above" : "",
             (unsigned long long)findings->request->options->seed);
    wrap_end(&wrap);
    printf("\n");
    return table_finish(&table, NULL, NULL, FORMAT_TEXT, stdout);
}

static bool print_corners(const findings *findings)
{
    table table = TABLE_EMPTY;
    table_add(&table, "error\tcorner\tby A\tremainder");
    for (size_t i = 0; i < findings_measures(findings); i++) {
        const armtol_predicted *predicted = findings_predicted(findings, i);
        add_error(findings, i, &table);
        add_digits(&table, 6, findings_shown(findings, i, findings_verified(findings, i)->worst_corner));
        add_digits(&table, 6, findings_shown(findings, i, predicted->worst));
        add_digits(&table, 2, findings_shown(findings, i, predicted->remainder));
    }
    return table_finish(&table, "The worst corner that was found, beside what A says of it", NULL, FORMAT_TEXT, stdout);
}

static void print_share(const findings *findings)
{
    const armtol_verification *found = findings->verification;
    const double drawn = (double)found->drawn;
    if (findings->request->question.accuracy == NULL || found->drawn == 0) {
        return;
    }
    wrap wrap;
    printf("\n");
    wrap_start(&wrap, stdout, 0, 0);
    wrap_say(&wrap, "%llu of %llu arms are within the accuracy: %.4f %% (95 %% sure: %.4f to %.4f %%)",
             (unsigned long long)found->within, (unsigned long long)found->drawn, 100 * (double)found->within / drawn,
             100 * found->share_low, 100 * found->share_high);
    wrap_end(&wrap);
    printf("%llu are outside by more than the remainder\n", (unsigned long long)found->beyond);
}

bool text_verification(const findings *findings)
{
    const bool fine = print_drawn(findings) && print_corners(findings);
    if (fine) {
        print_share(findings);
    }
    return fine;
}
