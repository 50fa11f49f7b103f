#include "armtol/column_order.h"

#include <stdbool.h>

enum { GROUP_SECOND_LENGTH, GROUP_FIRST_LENGTH, GROUP_THETA, GROUP_ALPHA, GROUP_BETA, GROUP_COUNT };

static bool has_d(const armtol_column columns[], size_t n_columns, size_t link)
{
    for (size_t k = 0; k < n_columns; k++) {
        if (columns[k].link == link && columns[k].parameter == ARMTOL_D) {
            return true;
        }
    }
    return false;
}

static int group_of(const armtol_column columns[], size_t n_columns, size_t k)
{
    switch (columns[k].parameter) {
    case ARMTOL_A:
        return has_d(columns, n_columns, columns[k].link) ? GROUP_SECOND_LENGTH : GROUP_FIRST_LENGTH;
    case ARMTOL_D:
        return GROUP_FIRST_LENGTH;
    case ARMTOL_THETA:
        return GROUP_THETA;
    case ARMTOL_ALPHA:
        return GROUP_ALPHA;
    default:
        return GROUP_BETA;
    }
}

size_t armtol_column_order(const armtol_column columns[], size_t n_columns, size_t order[])
{
    size_t place = 0, lengths = 0;
    for (int group = 0; group < GROUP_COUNT; group++) {
        if (group == GROUP_THETA) {
            lengths = place;
        }
        for (size_t k = 0; k < n_columns; k++) {
            if (group_of(columns, n_columns, k) == group) {
                order[place++] = k;
            }
        }
    }
    return lengths;
}

void armtol_reorder(const double matrix[], size_t n_columns, const size_t order[], double ordered[])
{
    for (size_t i = 0; i < 6; i++) {
        for (size_t k = 0; k < n_columns; k++) {
            ordered[i * n_columns + k] = matrix[i * n_columns + order[k]];
        }
    }
}
