#include "lab/joint_orders/tables.h"

#include "lab/joint_orders/elsewhere.h"
#include "lab/joint_orders/lists.h"
#include "lab/joint_orders/text.h"

#include <inttypes.h>
#include <math.h>

const char *const orders_part_names[PART_COUNT] = {
    [PART_FAMILY] = "family", [PART_HISTOGRAM] = "histogram", [PART_CHOICES] = "choices",
    [PART_MARGINS] = "margins", [PART_OPEN] = "open",         [PART_MISSES] = "misses",
    [PART_ALL] = "all",
};

/* Wishes over which one configuration is compared with the library's, and over which all that fit are. */
enum { WISHES_OF_ONE = 2000, WISHES_OF_ALL = 100 };

static configuration with_one(size_t choice, size_t option)
{
    configuration configuration = family_default();
    configuration.option[choice] = (unsigned char)option;
    return configuration;
}

/* ---- the histogram ---- */

static bool histogram_rows(const survey surveys[FAMILIES], table *table)
{
    const size_t most[FAMILIES] = {evidence_count(surveys[0].evidence), evidence_count(surveys[1].evidence)};
    uint64_t pairs[2 * MOST_VALUES + 1], total = 0;
    const char *const head[] = {"right", surveys[0].family->program, surveys[1].family->program, "pairs"};
    bool fine = table_add_head(table, head);
    survey_pairs(&surveys[0], &surveys[1], pairs);
    for (size_t score = most[0] + most[1] + 1; score-- > 0 && fine;) {
        table_row *row = table_add(table, "");
        fine = row != NULL;
        if (fine) {
            table_set(row, 0, "%zu", score);
            for (size_t i = 0; i < FAMILIES && score <= most[i]; i++) {
                table_set(row, i + 1, "%" PRIu64, surveys[i].by_score[score]);
            }
            table_set(row, 3, "%" PRIu64, pairs[score]);
            total += pairs[score];
        }
    }
    table_row *row = fine ? table_add(table, "any") : NULL;
    if (row != NULL) {
        table_set(row, 1, "%" PRIu64, surveys[0].configurations);
        table_set(row, 2, "%" PRIu64, surveys[1].configurations);
        table_set(row, 3, "%" PRIu64, total);
    }
    return row != NULL;
}

static bool print_histogram(const survey surveys[FAMILIES], table_format format)
{
    table table;
    table_start(&table, 4);
    const bool fine = histogram_rows(surveys, &table);
    if (fine) {
        print_title(format, "", "Configurations by how many joint values are right",
                    "To the last digit. A pair: a configuration of each program.");
        table_print(&table, format, stdout);
    }
    table_free(&table);
    return fine;
}

/* ---- one table for each program ---- */

static bool print_table(const survey *survey, table_format format, size_t n_columns, const char *title,
                        const char *remark, bool (*rows)(const struct survey *, table *))
{
    table table;
    table_start(&table, n_columns);
    const bool fine = rows(survey, &table);
    if (fine) {
        print_title(format, survey->family->program, title, remark);
        table_print(&table, format, stdout);
    }
    table_free(&table);
    return fine;
}

/* ---- choices ---- */

static const char *verdict_of(const survey *survey, size_t choice, size_t option)
{
    const option_tally *tally = &survey->tallies[choice][option];
    size_t n_tried = 0, n_open = 0;
    for (size_t i = 0; i < MOST_OPTIONS; i++) {
        n_tried += survey->tallies[choice][i].configurations > 0;
        n_open += survey->tallies[choice][i].all > 0;
    }
    if (tally->configurations == 0) {
        return "left out";
    }
    if (tally->all == 0) {
        return tally->all_but_one > 0 ? "refuted by one" : "refuted";
    }
    return n_tried == 1 ? "given" : n_open == 1 ? "decided" : "open";
}

static void set_alone(const survey *survey, size_t choice, size_t option, table_row *row)
{
    const configuration alone = with_one(choice, option);
    if (survey->family->matters(&alone, choice)) {
        const unsigned long misses = survey_misses(survey, &alone);
        table_set(row, 5, "%s", label_of_values(survey->evidence, misses, &(label){""}));
    } else {
        table_set(row, 5, "no difference");
    }
}

static bool choice_rows(const survey *survey, table *table)
{
    static const char *const head[] = {"option", "configurations", "all right", "one wrong", "most right",
                                       "wrong when changed alone", "verdict"};
    const family *family = survey->family;
    bool fine = table_add_head(table, head);
    for (size_t i = 0; i < family->n_choices; i++) {
        for (size_t j = 0; j < choice_count(&family->choices[i]) && fine; j++) {
            const option_tally *tally = &survey->tallies[i][j];
            table_row *row = table_add(table, label_of_option(family, i, j, &(label){""}));
            fine = row != NULL;
            if (fine) {
                table_set(row, 1, "%" PRIu64, tally->configurations);
                table_set(row, 2, "%" PRIu64, tally->all);
                table_set(row, 3, "%" PRIu64, tally->all_but_one);
                table_set(row, 4, "%zu", tally->best);
                set_alone(survey, i, j, row);
                table_set(row, 6, "%s", verdict_of(survey, i, j));
            }
        }
    }
    return fine;
}

/* ---- margins ---- */

/* From the value, as a float, to the next float farther from 0. */
static double step_of_floats(double value)
{
    const float here = (float)fabs(value);
    return (double)nextafterf(here, INFINITY) - (double)here;
}

/* The joint value as the library has it when nothing is stored in a float; nan where there is none. */
static double unrounded(const survey *survey, size_t value)
{
    const evidence *evidence = survey->evidence;
    armtol_errata errata = armtol_errata_1987;
    armtol_reach reach;
    double q[MOST_JOINTS];
    errata.float_storage = false;
    const double *wish = evidence->wishes[value / evidence->n_joints];
    const bool found = survey->family->robot->inverse(wish, &errata, q, &reach) == ARMTOL_OK;
    return found ? q[value % evidence->n_joints] : (double)NAN;
}

static bool margin_rows(const survey *survey, table *table)
{
    static const char *const head[] = {"joint value", "published", "nothing stored",
                                       "to the next digit, 1e-9", "step of floats, 1e-9"};
    const evidence *evidence = survey->evidence;
    bool fine = table_add_head(table, head);
    for (size_t i = 0; i < evidence_count(evidence) && fine; i++) {
        const double value = unrounded(survey, i);
        table_row *row = table_add(table, label_of_value(evidence->numbers[i], &(label){""}));
        fine = row != NULL;
        if (fine) {
            table_set(row, 1, "%s", evidence->numbers[i]->value);
            table_set(row, 2, "%.9f", value);
            table_set(row, 3, "%.0f", 1e9 * (0.5e-6 - fabs(value - printed_of(value) * 1e-6)));
            table_set(row, 4, "%.0f", 1e9 * step_of_floats(value));
        }
    }
    return fine;
}

/* ---- what is open ---- */

static bool open_row(const survey *survey, size_t choice, size_t option, table *table)
{
    const configuration alone = with_one(choice, option);
    elsewhere_difference difference;
    if (!survey->family->matters(&alone, choice) || survey_misses(survey, &alone) != 0) {
        return true;
    }
    table_row *row = table_add(table, label_of_option(survey->family, choice, option, &(label){""}));
    if (row == NULL || !elsewhere_compare_one(survey->family, &alone, WISHES_OF_ONE, &difference)) {
        return false;
    }
    table_set(row, 1, "%.1f", 100.0 * (double)difference.n_other / WISHES_OF_ONE);
    table_set(row, 2, "%.1f", 100.0 * (double)difference.n_far / WISHES_OF_ONE);
    return true;
}

static bool open_rows(const survey *survey, table *table)
{
    static const char *const head[] = {"changed alone", "other digits, %", "by more than 10 units, %"};
    bool fine = table_add_head(table, head);
    for (size_t i = 0; i < survey->family->n_choices; i++) {
        for (size_t j = 1; j < choice_count(&survey->family->choices[i]) && fine; j++) {
            fine = open_row(survey, i, j, table);
        }
    }
    return fine;
}

static bool add_number(table *table, const char *text, size_t number)
{
    table_row *row = table_add(table, text);
    if (row != NULL) {
        table_set(row, 1, "%zu", number);
    }
    return row != NULL;
}

static bool spread_rows(const survey *survey, table *table)
{
    static const char *const head[] = {"of all that fit", "number"};
    elsewhere_spread spread;
    return elsewhere_compare_all(survey->family, survey->all, survey->n_all, WISHES_OF_ALL, &spread) &&
           table_add_head(table, head) && add_number(table, "configurations", survey->n_all) &&
           add_number(table, "different sets of answers", spread.n_answers) &&
           add_number(table, "configurations with the library's answers", spread.n_same) &&
           add_number(table, "positions with other digits, the least of any", spread.least) &&
           add_number(table, "the same, median", spread.median) &&
           add_number(table, "the same, the most of any", spread.most);
}

static bool print_open(const survey *survey, table_format format)
{
    char one[128], all[128];
    snprintf(one, sizeof one, "Of %d random positions, those where a joint value is printed otherwise.",
             WISHES_OF_ONE);
    snprintf(all, sizeof all, "The same for each of them, over %d positions.", WISHES_OF_ALL);
    return print_table(survey, format, 3, "what one change that still fits does elsewhere", one, open_rows) &&
           print_table(survey, format, 2, "what all that fit do elsewhere", all, spread_rows);
}

/* ---- the closest misses ---- */

static bool miss_rows(const survey *survey, table *table)
{
    static const char *const head[] = {"wrong alone", "published", "computed", "configurations", "such as"};
    bool fine = table_add_head(table, head);
    for (size_t i = 0; i < survey->n_misses && fine; i++) {
        const closest_miss *miss = &survey->misses[i];
        const published_number *number = survey->evidence->numbers[miss->value];
        table_row *row = table_add(table, label_of_value(number, &(label){""}));
        fine = row != NULL;
        if (fine) {
            table_set(row, 1, "%s", number->value);
            table_set(row, 2, "%.6f", miss->printed * 1e-6);
            table_set(row, 3, "%" PRIu64, miss->configurations);
            table_set(row, 4, "%s", label_of_changes(survey->family, &miss->nearest, &(label){""}));
        }
    }
    return fine;
}

static bool print_for(orders_part part, const survey *survey, table_format format)
{
    switch (part) {
    case PART_FAMILY:
        print_family(survey, format);
        return true;
    case PART_CHOICES:
        return print_table(survey, format, 7, "what the paper's joint values say of each option",
                           "Wrong: case: joints. Refuted: with it no configuration is right in all; "
                           "by one: some are in all but one.",
                           choice_rows);
    case PART_MARGINS:
        return print_table(survey, format, 5, "how far each joint value is from another last digit",
                           "Worked out by the library in doubles, pi 3.14159.", margin_rows);
    case PART_OPEN:
        return print_open(survey, format);
    case PART_MISSES:
        return print_table(survey, format, 5, "the closest misses",
                           "Configurations with one joint value wrong, and the one with fewest changes.",
                           miss_rows);
    default:
        print_all_that_fit(survey, format);
        return true;
    }
}

bool orders_print(orders_part part, const survey surveys[FAMILIES], table_format format)
{
    if (part == PART_HISTOGRAM) {
        return print_histogram(surveys, format);
    }
    bool fine = true;
    for (size_t i = 0; i < FAMILIES && fine; i++) {
        fine = print_for(part, &surveys[i], format);
    }
    return fine;
}
