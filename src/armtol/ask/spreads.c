#include "armtol/ask/given.h"

#include "armtol/lists/lists.h"
#include "armtol/names/link_name.h"
#include "console/input_file.h"
#include "console/message.h"

#include <stdio.h>
#include <string.h>

typedef struct spread_out {
    named_columns of;
    armtol_error_spread *spreads;
} spread_out;

/* NAME=DISTRIBUTION */
static bool take_item(const named_item *item, void *context)
{
    const spread_out *out = context;
    armtol_error_spread spread = {ARMTOL_UNIFORM, 0, 0, 0};
    if (!named_is(item, "=", "NAME=DISTRIBUTION")) {
        return false;
    }
    if (!distribution_parse(item->value, &spread)) {
        message("%s: %s: unknown distribution %s; %s", item->option, item->whole,
                message_quote(item->value, &(quoted){""}), distribution_expected);
        return false;
    }
    for (size_t k = 0; k < out->of.n_columns; k++) {
        out->spreads[k] = named_column(&out->of, item, k) ? spread : out->spreads[k];
    }
    return named_any_column(&out->of, item);
}

/* Shifts in the user's units become inside ones. False after a message. */
static bool take_shifts(const named_columns *of, const units *units, armtol_error_spread spreads[])
{
    for (size_t k = 0; k < of->n_columns; k++) {
        spreads[k].shift =
            units_taken(units, armtol_parameter_is_length(of->columns[k].parameter), spreads[k].shift);
        if (!armtol_spread_is_known(&spreads[k])) {
            message("--spread: %s of %s: the shift is too large", armtol_parameter_name(of->columns[k].parameter),
                    link_words(of->arm, of->columns[k].link, &(link_text){""}));
            return false;
        }
    }
    return true;
}

static bool is_like(const armtol_error_spread *one, const armtol_error_spread *other)
{
    return one->group != other->group ||
           (one->distribution == other->distribution && one->sigmas == other->sigmas);
}

/* What is drawn as one has one distribution. */
static bool check_groups(const named_columns *of, const armtol_error_spread spreads[], const group_name groups[])
{
    for (size_t k = 0; k < of->n_columns; k++) {
        for (size_t j = 0; j < k && spreads[k].group != 0; j++) {
            if (!is_like(&spreads[j], &spreads[k])) {
                message("--spread: group %s is %s in %s of %s, and %s in %s of %s; expected one distribution",
                        groups[spreads[k].group - 1].text, distribution_words(&spreads[j], &(distribution_text){""}),
                        armtol_parameter_name(of->columns[j].parameter),
                        link_words(of->arm, of->columns[j].link, &(link_text){""}),
                        distribution_words(&spreads[k], &(distribution_text){""}),
                        armtol_parameter_name(of->columns[k].parameter),
                        link_words(of->arm, of->columns[k].link, &(link_text){""}));
                return false;
            }
        }
    }
    return true;
}

static bool take_table(const char *path, const named_columns *of, const units *units, armtol_error_spread spreads[],
                       group_name groups[])
{
    const parameter_table table = {
        .arm = of->arm,
        .columns = of->columns,
        .n_columns = of->n_columns,
        .value = "distribution",
        .length_unit = units_name(units, true),
        .angle_unit = units_name(units, false),
    };
    FILE *stream = input_file_open("--spread: ", path, "; expected NAME=DISTRIBUTION,... or a file");
    if (stream == NULL) {
        return false;
    }
    const bool fine = spreads_read(stream, path, &table, spreads, groups);
    fclose(stream);
    return fine && take_shifts(of, units, spreads) && check_groups(of, spreads, groups);
}

bool given_spreads_parse(const char *text, const named_columns *of, const units *units, armtol_error_spread spreads[],
                         group_name groups[])
{
    spread_out out = {*of, spreads};
    if (text == NULL) {
        return true;
    }
    return strchr(text, '=') != NULL ? named_each("--spread", text, of->arm, take_item, &out)
                                     : take_table(text, of, units, spreads, groups);
}
