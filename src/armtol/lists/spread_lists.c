#include "armtol/lists/parameter_rows.h"

#include "console/number.h"

#include <stdio.h>
#include <string.h>

enum { FIELD_DISTRIBUTION = FIELD_VALUE, FIELD_SHIFT, FIELD_GROUP };

const char distribution_expected[] = "expected uniform, normal:K (K from 0.01 to 30), triangular or ends";

/* ---- a distribution ---- */

bool distribution_parse(const char *text, armtol_error_spread *spread)
{
    armtol_error_spread found = *spread;
    const char *colon = strchr(text, ':');
    const size_t length = colon != NULL ? (size_t)(colon - text) : strlen(text);
    int i = 0;
    while (i < ARMTOL_DISTRIBUTION_COUNT &&
           !(strlen(armtol_distribution_name((armtol_distribution)i)) == length &&
             strncmp(armtol_distribution_name((armtol_distribution)i), text, length) == 0)) {
        i++;
    }
    found.distribution = (armtol_distribution)i;
    found.sigmas = 0;
    const bool is_normal = found.distribution == ARMTOL_NORMAL;
    const bool fine = is_normal == (colon != NULL) &&
                      (colon == NULL || number_parse(colon + 1, &found.sigmas) == NUMBER_FINE) &&
                      armtol_spread_is_known(&found);
    *spread = fine ? found : *spread;
    return fine;
}

const char *distribution_words(const armtol_error_spread *spread, distribution_text *words)
{
    const char *name = armtol_distribution_name(spread->distribution);
    const bool is_normal = spread->distribution == ARMTOL_NORMAL;
    snprintf(words->text, sizeof words->text, "%s%s%s", name, is_normal ? ":" : "",
             is_normal ? number_shortest(spread->sigmas, &armtol_errata_none, &(number_text){""}) : "");
    return words->text;
}

/* ---- a table of them ---- */

typedef struct wanted {
    armtol_error_spread *spreads;
    group_name *groups; /* a place a column, those in use first */
} wanted;

/* The number of a group, from 1 on, which may be a new one. There are no more than columns of A. */
static size_t group_of(const wanted *wanted, const char *name)
{
    size_t i = 0;
    while (wanted->groups[i].text[0] != '\0' && strcmp(wanted->groups[i].text, name) != 0) {
        i++;
    }
    strcpy(wanted->groups[i].text, name);
    return i + 1;
}

static bool take_distribution(const parameter_rows *rows, armtol_error_spread *spread)
{
    const cell *cell = parameter_rows_cell(rows, FIELD_DISTRIBUTION);
    const bool fine = cell == NULL || distribution_parse(cell->text, spread);
    if (!fine) {
        cells_message(&rows->row, rows->places[FIELD_DISTRIBUTION], "unknown distribution %s; %s",
                      message_quote(cell->text, &(quoted){""}), distribution_expected);
    }
    return fine;
}

static bool take_group(const parameter_rows *rows, armtol_error_spread *spread)
{
    const wanted *wanted = rows->context;
    const cell *cell = parameter_rows_cell(rows, FIELD_GROUP);
    if (cell == NULL) {
        return true;
    }
    if (strlen(cell->text) >= sizeof wanted->groups[0].text) {
        cells_message(&rows->row, rows->places[FIELD_GROUP], "group: %s is too long; expected at most %zu characters",
                      message_quote(cell->text, &(quoted){""}), sizeof wanted->groups[0].text - 1);
        return false;
    }
    spread->group = group_of(wanted, cell->text);
    return true;
}

static bool take_spread(const parameter_rows *rows, size_t column)
{
    const wanted *wanted = rows->context;
    armtol_error_spread *spread = &wanted->spreads[column];
    return take_distribution(rows, spread) &&
           (parameter_rows_cell(rows, FIELD_SHIFT) == NULL ||
            parameter_rows_number(rows, FIELD_SHIFT, &spread->shift)) &&
           take_group(rows, spread);
}

/* All are optional, but one there has to be. */
static bool settle(parameter_rows *rows)
{
    for (size_t i = 0; i < rows->row.n; i++) {
        for (int field = FIELD_DISTRIBUTION; field <= FIELD_GROUP; field++) {
            if (cell_is(&rows->row.cells[i], rows->names[field])) {
                return true;
            }
        }
    }
    cells_message(&rows->row, 0, "the head row has no column \"distribution\", \"shift\" or \"group\"");
    return false;
}

bool spreads_read(FILE *stream, const char *path, const parameter_table *table, armtol_error_spread spreads[],
                  group_name groups[])
{
    wanted wanted = {spreads, groups};
    parameter_rows rows = {
        .table = table,
        .n_fields = FIELD_GROUP + 1,
        .names = {[FIELD_DISTRIBUTION] = "distribution", [FIELD_SHIFT] = "shift", [FIELD_GROUP] = "group"},
        .optional = {[FIELD_DISTRIBUTION] = true, [FIELD_SHIFT] = true, [FIELD_GROUP] = true},
        .settle = settle,
        .take = take_spread,
        .context = &wanted,
    };
    return parameter_rows_each(&rows, stream, path);
}
