#include "lab/joint_orders/tables.h"

#include "console/message.h"
#include "lab/joint_orders/elsewhere.h"

#include <inttypes.h>
#include <math.h>
#include <stdarg.h>
#include <string.h>

const char *const orders_part_names[PART_COUNT] = {
    [PART_FAMILY] = "family", [PART_HISTOGRAM] = "histogram", [PART_CHOICES] = "choices",
    [PART_MARGINS] = "margins", [PART_OPEN] = "open",         [PART_MISSES] = "misses",
    [PART_ALL] = "all",
};

/* Wishes over which one configuration is compared with the library's, and over which all that fit are. */
enum { WISHES_OF_ONE = 2000, WISHES_OF_ALL = 100 };

/* ---- what things are called ---- */

/* Room for a name: name_of(...,  &(label){""}). */
typedef struct label {
    char text[1024];
} label;

/* printf to the end of a label; what is too long is cut. */
LIKE_PRINTF(2, 3)
static void append(label *label, const char *format, ...)
{
    const size_t length = strlen(label->text);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(label->text + length, sizeof label->text - length, format, arguments);
    va_end(arguments);
}

/* What a configuration has other than the library's: "sines=float elbow=chain". */
static const char *name_of_changes(const family *family, const configuration *configuration, label *label)
{
    for (size_t i = 0; i < family->n_choices; i++) {
        const choice *choice = &family->choices[i];
        if (configuration->option[i] != 0) {
            append(label, "%s%s=%s", label->text[0] != '\0' ? " " : "", choice->name,
                   choice->options[configuration->option[i]].name);
        }
    }
    return label->text[0] != '\0' ? label->text : "(the library's)";
}

/* A set of values of the evidence, by case and joint: "1: 3, 2: 3 4"; empty for none. */
static const char *name_of_values(const evidence *evidence, unsigned long values, label *label)
{
    size_t last_case = evidence->n_cases;
    for (size_t i = 0; i < evidence_count(evidence); i++) {
        const size_t case_index = i / evidence->n_joints;
        if ((values >> i & 1) == 0) {
            continue;
        }
        if (case_index != last_case) {
            append(label, "%s%d:", label->text[0] != '\0' ? ", " : "", evidence->numbers[i]->case_number);
            last_case = case_index;
        }
        append(label, " %zu", i % evidence->n_joints + 1);
    }
    return label->text;
}

/* "intella: " and a title. */
static const char *title_of(const survey *survey, const char *title, label *label)
{
    append(label, "%s: %s", survey->family->program, title);
    return label->text;
}

static bool finish(table *table, const survey *survey, const char *title, const char *remark, table_format format)
{
    return table_finish(table, title_of(survey, title, &(label){""}), remark, format, stdout);
}

/* ---- the parts ---- */

static void print_option(const choice *choice, size_t option, table_format format)
{
    const char *name = choice->options[option].name, *meaning = choice->options[option].meaning;
    switch (format) {
    case FORMAT_TEXT:
        printf("    %-12s %s\n", name, meaning);
        break;
    case FORMAT_MARKDOWN:
        printf("  - `%s`: %s\n", name, meaning);
        break;
    default:
        printf("%s=%s\t%s\t%s\n", choice->name, name, choice->subject, meaning);
    }
}

static bool print_family(const survey *survey, table_format format)
{
    const family *family = survey->family;
    table_print_title(title_of(survey, "the family", &(label){""}),
                      "Each choice and its options; the first is what the library does.", format, stdout);
    for (size_t i = 0; i < family->n_choices; i++) {
        const choice *choice = &family->choices[i];
        if (format != FORMAT_TSV) {
            printf(format == FORMAT_TEXT ? "  %s: %s\n" : "- `%s`: %s\n", choice->name, choice->subject);
        }
        for (size_t j = 0; j < choice_count(choice); j++) {
            print_option(choice, j, format);
        }
    }
    if (family->left_out != NULL) {
        static const char *const before[FORMAT_COUNT] = {"\n  Left out: ", "\nLeft out: ", "# Left out: "};
        printf("%s%s.\n", before[format], family->left_out);
    }
    return true;
}

static bool print_histogram(const survey surveys[FAMILIES], table_format format)
{
    const size_t most[FAMILIES] = {evidence_count(&surveys[0].evidence), evidence_count(&surveys[1].evidence)};
    uint64_t pairs[2 * MOST_VALUES + 1], total = 0;
    table table = TABLE_EMPTY;
    table_add(&table, "right\t%s\t%s\tpairs", surveys[0].family->program, surveys[1].family->program);
    survey_pairs(&surveys[0], &surveys[1], pairs);
    for (size_t score = most[0] + most[1] + 1; score-- > 0;) {
        table_add(&table, "%zu", score);
        for (size_t i = 0; i < FAMILIES; i++) {
            if (score <= most[i]) {
                table_add_cells(&table, "%" PRIu64, surveys[i].by_score[score]);
            } else {
                table_add_cells(&table, "%s", "");
            }
        }
        table_add_cells(&table, "%" PRIu64, pairs[score]);
        total += pairs[score];
    }
    table_add(&table, "any\t%" PRIu64 "\t%" PRIu64 "\t%" PRIu64, surveys[0].configurations, surveys[1].configurations,
              total);
    return table_finish(&table, "Configurations by how many joint values are right",
                        "To the last digit. A pair: a configuration of each program.", format, stdout);
}

static const char *verdict_of(const option_tally tallies[MOST_OPTIONS], size_t option)
{
    const option_tally *tally = &tallies[option];
    size_t n_tried = 0, n_open = 0;
    for (size_t i = 0; i < MOST_OPTIONS; i++) {
        n_tried += tallies[i].configurations > 0;
        n_open += tallies[i].all > 0;
    }
    if (tally->configurations == 0) {
        return "left out";
    }
    if (tally->all == 0) {
        return tally->all_but_one > 0 ? "refuted by one" : "refuted";
    }
    return n_tried == 1 ? "given" : n_open == 1 ? "decided" : "open";
}

/* The default with one option changed, and the values that it misses. False where the choice does not matter. */
static bool change_alone(const survey *survey, size_t choice, size_t option, configuration *alone,
                         unsigned long *misses)
{
    double q[MOST_VALUES];
    *alone = family_default();
    alone->option[choice] = (unsigned char)option;
    *misses = evidence_misses(&survey->evidence, survey->family, alone, q);
    return survey->family->matters(alone, choice);
}

static void add_option(const survey *survey, size_t choice, size_t option, table *table)
{
    const struct choice *of = &survey->family->choices[choice];
    const option_tally *tally = &survey->tallies[choice][option];
    configuration alone;
    unsigned long misses;
    const bool matters = change_alone(survey, choice, option, &alone, &misses);
    table_add(table, "%s=%s\t%" PRIu64 "\t%" PRIu64 "\t%" PRIu64 "\t%zu\t%s\t%s", of->name, of->options[option].name,
              tally->configurations, tally->all, tally->all_but_one, tally->best,
              matters ? name_of_values(&survey->evidence, misses, &(label){""}) : "no difference",
              verdict_of(survey->tallies[choice], option));
}

static bool print_choices(const survey *survey, table_format format)
{
    table table = TABLE_EMPTY;
    table_add(&table, "option\tconfigurations\tall right\tone wrong\tmost right\twrong when changed alone\tverdict");
    for (size_t i = 0; i < survey->family->n_choices; i++) {
        for (size_t j = 0; j < choice_count(&survey->family->choices[i]); j++) {
            add_option(survey, i, j, &table);
        }
    }
    return finish(&table, survey, "what the paper's joint values say of each option",
                  "Wrong: case: joints. Refuted: with it no configuration is right in all; "
                  "by one: some are in all but one.",
                  format);
}

/* From the value, as a float, to the next float farther from 0. */
static double step_of_floats(double value)
{
    const float here = (float)fabs(value);
    return (double)nextafterf(here, INFINITY) - (double)here;
}

/* The joint value as the library has it when nothing is stored in a float; nan where there is none. */
static double unrounded(const survey *survey, size_t value)
{
    const evidence *evidence = &survey->evidence;
    armtol_errata errata = armtol_errata_1987;
    armtol_reach reach;
    double q[MOST_JOINTS];
    errata.float_storage = false;
    const double *wish = evidence->wishes[value / evidence->n_joints];
    const bool found = survey->family->robot->inverse(wish, &errata, q, &reach) == ARMTOL_OK;
    return found ? q[value % evidence->n_joints] : (double)NAN;
}

static bool print_margins(const survey *survey, table_format format)
{
    table table = TABLE_EMPTY;
    table_add(&table, "joint value\tpublished\tnothing stored\tto the next digit, 1e-9\tstep of floats, 1e-9");
    for (size_t i = 0; i < evidence_count(&survey->evidence); i++) {
        const published_number *number = survey->evidence.numbers[i];
        const double value = unrounded(survey, i);
        table_add(&table, "%s of case %d\t%s\t%.9f\t%.0f\t%.0f", number->quantity, number->case_number, number->value,
                  value, 1e9 * (0.5e-6 - fabs(value - printed_of(value) * 1e-6)), 1e9 * step_of_floats(value));
    }
    return finish(&table, survey, "how far each joint value is from another last digit",
                  "Worked out by the library in doubles, pi 3.14159.", format);
}

static void add_open(const survey *survey, size_t choice, size_t option, table *table)
{
    const struct choice *of = &survey->family->choices[choice];
    configuration alone;
    unsigned long misses;
    if (change_alone(survey, choice, option, &alone, &misses) && misses == 0) {
        const elsewhere_difference difference = elsewhere_compare_one(survey->family, &alone, WISHES_OF_ONE);
        table_add(table, "%s=%s\t%.1f\t%.1f", of->name, of->options[option].name,
                  100.0 * (double)difference.n_other / WISHES_OF_ONE, 100.0 * (double)difference.n_far / WISHES_OF_ONE);
    }
}

static bool print_spread(const survey *survey, table_format format)
{
    elsewhere_spread spread;
    char remark[128];
    table table = TABLE_EMPTY;
    if (!elsewhere_compare_all(survey->family, survey->all, survey->n_all, WISHES_OF_ALL, &spread)) {
        return false;
    }
    table_add(&table, "of all that fit\tnumber");
    table_add(&table, "configurations\t%zu", survey->n_all);
    table_add(&table, "different sets of answers\t%zu", spread.n_answers);
    table_add(&table, "configurations with the library's answers\t%zu", spread.n_same);
    table_add(&table, "positions with other digits, the least of any\t%zu", spread.least);
    table_add(&table, "the same, median\t%zu", spread.median);
    table_add(&table, "the same, the most of any\t%zu", spread.most);
    snprintf(remark, sizeof remark, "The same for each of them, over %d positions.", WISHES_OF_ALL);
    return finish(&table, survey, "what all that fit do elsewhere", remark, format);
}

static bool print_open(const survey *survey, table_format format)
{
    char remark[128];
    table table = TABLE_EMPTY;
    table_add(&table, "changed alone\tother digits, %%\tby more than 10 units, %%");
    for (size_t i = 0; i < survey->family->n_choices; i++) {
        for (size_t j = 1; j < choice_count(&survey->family->choices[i]); j++) {
            add_open(survey, i, j, &table);
        }
    }
    snprintf(remark, sizeof remark, "Of %d random positions, those where a joint value is printed otherwise.",
             WISHES_OF_ONE);
    return finish(&table, survey, "what one change that still fits does elsewhere", remark, format) &&
           print_spread(survey, format);
}

static bool print_misses(const survey *survey, table_format format)
{
    table table = TABLE_EMPTY;
    table_add(&table, "wrong alone\tpublished\tcomputed\tconfigurations\tsuch as");
    for (size_t i = 0; i < survey->n_misses; i++) {
        const closest_miss *miss = &survey->misses[i];
        const published_number *number = survey->evidence.numbers[miss->value];
        table_add(&table, "%s of case %d\t%s\t%.6f\t%" PRIu64 "\t%s", number->quantity, number->case_number,
                  number->value, miss->printed * 1e-6, miss->configurations,
                  name_of_changes(survey->family, &miss->nearest, &(label){""}));
    }
    return finish(&table, survey, "the closest misses",
                  "Configurations with one joint value wrong, and the one with fewest changes.", format);
}

static bool print_all(const survey *survey, table_format format)
{
    static const char *const before[FORMAT_COUNT] = {"  ", "- ", ""};
    table_print_title(title_of(survey, "every configuration that fits", &(label){""}),
                      "By what it has other than the library's.", format, stdout);
    for (size_t i = 0; i < survey->n_all; i++) {
        printf("%s%s\n", before[format], name_of_changes(survey->family, &survey->all[i], &(label){""}));
    }
    return true;
}

bool orders_print(orders_part part, const survey surveys[FAMILIES], table_format format)
{
    static bool (*const of_each[PART_COUNT])(const survey *, table_format) = {
        [PART_FAMILY] = print_family, [PART_CHOICES] = print_choices, [PART_MARGINS] = print_margins,
        [PART_OPEN] = print_open,     [PART_MISSES] = print_misses,   [PART_ALL] = print_all,
    };
    bool fine = true;
    for (size_t i = 0; i < FAMILIES && fine && part != PART_HISTOGRAM; i++) {
        fine = of_each[part](&surveys[i], format);
    }
    return fine && (part != PART_HISTOGRAM || print_histogram(surveys, format));
}
