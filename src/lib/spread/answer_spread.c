#include "lib/spread/answer_spread.h"

#include <math.h>

/* The first column of its group; of a column by itself that one. */
static size_t leader_of(const armtol_answer *answer, size_t column)
{
    const size_t group = answer->spreads[column].group;
    size_t k = 0;
    while (group != 0 ? answer->spreads[k].group != group : k < column) {
        k++;
    }
    return k;
}

void answer_take_spreads(armtol_answer *answer, const armtol_question *question)
{
    for (size_t k = 0; k < answer->n_columns; k++) {
        if (question->spreads != NULL) {
            answer->spreads[k] = question->spreads[k];
        }
        const double shift = answer->spreads[k].shift;
        answer->factors[k] = sqrt(3 * armtol_spread_variance(&answer->spreads[k]));
        answer->leaders[k] = leader_of(answer, k);
        answer->grouped = answer->grouped || answer->leaders[k] != k;
        answer->shifted = answer->shifted || shift != 0;
        for (size_t pose = 0; pose < answer->n_poses; pose++) {
            answer->shifts[pose * answer->n_columns + k] += shift;
        }
    }
}

double spread_part(const armtol_answer *answer, const double row[], const double tolerances[], size_t column)
{
    const size_t end = answer->grouped ? answer->n_columns : column + 1;
    double sum = 0;
    for (size_t k = column; k < end; k++) {
        sum += answer->leaders[k] == column ? row[k] * tolerances[k] * answer->factors[k] : 0;
    }
    return sum;
}

double spread_rss(const armtol_answer *answer, const double row[], const double tolerances[])
{
    double sum = 0;
    for (size_t k = 0; k < answer->n_columns; k++) {
        const double part = spread_part(answer, row, tolerances, k);
        sum += part * part;
    }
    return sqrt(sum);
}

size_t spread_shared(const armtol_answer *answer)
{
    for (size_t k = 0; k < answer->n_columns; k++) {
        for (size_t j = 0; j < answer->n_columns; j++) {
            const bool common = j != k && answer->leaders[j] == answer->leaders[k];
            if (common && !answer->given[k]) {
                return k;
            }
        }
    }
    return answer->n_columns;
}
