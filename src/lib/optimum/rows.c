#include "lib/optimum/rows.h"

#include <math.h>

bool optimum_in_range(double value)
{
    return value >= 1e-280 && value <= 1e280;
}

/* Note which columns the row bounds, and raise the most that a column takes of a limit. */
static void note_row(const double row[], size_t n, double limit, double bounded[], double most[])
{
    const double inverse = 1 / limit;
    for (size_t k = 0; k < n; k++) {
        bounded[k] = row[k] != 0 ? 1 : bounded[k];
        most[k] = fmax(most[k], fabs(row[k]) * inverse);
    }
}

bool optimum_find_units(optimum_rows *rows, double room[])
{
    const size_t n = rows->n_columns;
    double *bounded = room, *most = rows->units;
    for (size_t k = 0; k < n; k++) {
        bounded[k] = most[k] = 0;
    }
    for (size_t i = 0; i < rows->n_rows; i++) {
        if (!isinf(rows->limits[i])) {
            note_row(rows->matrix + i * n, n, rows->limits[i], bounded, most);
        }
    }
    rows->n_bounded = 0;
    bool in_range = true;
    for (size_t k = 0; k < n; k++) {
        rows->units[k] = bounded[k] > 0 ? 1 / most[k] : 0;
        rows->n_bounded += bounded[k] > 0;
        in_range = in_range && (bounded[k] <= 0 || optimum_in_range(rows->units[k]));
    }
    return in_range;
}

double optimum_element(const optimum_rows *rows, size_t row, size_t column)
{
    const double element = fabs(rows->matrix[row * rows->n_columns + column]);
    const double part = element * (1 / rows->limits[row]) * rows->units[column];
    return rows->sum == ARMTOL_ROOT_SUM_SQUARES ? part * part : part;
}

void optimum_pack(const optimum_rows *rows, size_t row, double packed[])
{
    size_t place = 0;
    for (size_t k = 0; k < rows->n_columns; k++) {
        if (rows->units[k] > 0) {
            packed[place++] = optimum_element(rows, row, k);
        }
    }
}

static double sum_of_magnitudes(const double row[], const double tolerances[], size_t n)
{
    double sum = 0;
    for (size_t k = 0; k < n; k++) {
        sum += fabs(row[k]) * tolerances[k];
    }
    return sum;
}

static double sum_of_squares(const double row[], const double tolerances[], size_t n, double inverse)
{
    double sum = 0;
    for (size_t k = 0; k < n; k++) {
        const double part = row[k] * tolerances[k] * inverse;
        sum += part * part;
    }
    return sum;
}

double optimum_use(const optimum_rows *rows, size_t row, const double tolerances[])
{
    const size_t n = rows->n_columns;
    const double *elements = rows->matrix + row * n;
    if (isinf(rows->limits[row])) {
        return 0;
    }
    const double inverse = 1 / rows->limits[row];
    return rows->sum == ARMTOL_ROOT_SUM_SQUARES ? sum_of_squares(elements, tolerances, n, inverse)
                                                : sum_of_magnitudes(elements, tolerances, n) * inverse;
}
