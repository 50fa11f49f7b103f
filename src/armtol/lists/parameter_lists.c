#include "armtol/lists/parameter_rows.h"

#include <math.h>

/* What is read into: the values, and the means where upper and lower ends may stand in their place. */
typedef struct wanted {
    bool infinite_allowed;
    double *values, *means;
} wanted;

enum { FIELD_UPPER = FIELD_VALUE, FIELD_LOWER };

static bool is_allowed(const parameter_table *table, double value)
{
    return value > 0 || (table->zero_allowed && value == 0) || table->signed_allowed;
}

static bool take_value(const parameter_rows *rows, size_t column)
{
    const wanted *wanted = rows->context;
    const parameter_table *table = rows->table;
    const size_t place = rows->places[FIELD_VALUE];
    const cell *cell = &rows->row.cells[place];
    double value;
    if (wanted->infinite_allowed && (cell_is_unknown(cell) || cell_is(cell, "inf"))) {
        wanted->values[column] = (double)INFINITY;
        return true;
    }
    if (!parameter_rows_number(rows, FIELD_VALUE, &value)) {
        return false;
    }
    if (!is_allowed(table, value)) {
        cells_message(&rows->row, place, "%s: %s is %s", table->value, message_quote(cell->text, &(quoted){""}),
                      table->zero_allowed ? "negative" : "not greater than zero");
        return false;
    }
    wanted->values[column] = value;
    return true;
}

/* From the lower end to the upper one, both with their signs. Halves first: so no sum is too large. */
static bool take_ends(const parameter_rows *rows, size_t column)
{
    const wanted *wanted = rows->context;
    double upper, lower;
    if (!parameter_rows_number(rows, FIELD_UPPER, &upper) || !parameter_rows_number(rows, FIELD_LOWER, &lower)) {
        return false;
    }
    if (upper < lower) {
        cells_message(&rows->row, rows->places[FIELD_UPPER],
                      "upper: %g is below lower, %g; expected both with their signs, as in 0.1 and -0.05", upper,
                      lower);
        return false;
    }
    wanted->values[column] = upper / 2 - lower / 2;
    wanted->means[column] = upper / 2 + lower / 2;
    return true;
}

static bool has_column(const parameter_rows *rows, const char *name)
{
    bool has = false;
    for (size_t i = 0; i < rows->row.n; i++) {
        has = has || cell_is(&rows->row.cells[i], name);
    }
    return has;
}

/* Upper and lower ends, where the head has them. */
static bool settle(parameter_rows *rows)
{
    const wanted *wanted = rows->context;
    if (wanted->means == NULL || !(has_column(rows, "upper") || has_column(rows, "lower"))) {
        return true;
    }
    if (has_column(rows, rows->table->value)) {
        cells_message(&rows->row, 0, "columns for %s and for its ends; expected either %s, or upper and lower",
                      rows->table->value, rows->table->value);
        return false;
    }
    rows->names[FIELD_UPPER] = "upper";
    rows->names[FIELD_LOWER] = "lower";
    rows->n_fields = FIELD_LOWER + 1;
    rows->take = take_ends;
    return true;
}

bool parameters_read(FILE *stream, const char *path, const parameter_table *table, bool infinite_allowed,
                     double values[])
{
    wanted wanted = {infinite_allowed, values, table->means};
    parameter_rows rows = {.table = table, .n_fields = FIELD_VALUE + 1, .names = {[FIELD_VALUE] = table->value},
                           .settle = settle, .take = take_value, .context = &wanted};
    return parameter_rows_each(&rows, stream, path);
}
