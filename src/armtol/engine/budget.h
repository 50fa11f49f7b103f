#ifndef ARMTOL_ENGINE_BUDGET_H
#define ARMTOL_ENGINE_BUDGET_H

#include "armtol/engine/answer.h"

#include <stdbool.h>
#include <stddef.h>

/* Where the error comes from: what one link's making, or its motor, has to do with each component of it. */
typedef struct budget_row {
    size_t link;
    bool motor;
    double shares[6]; /* of the component's predicted error, 0 to 1 */
} budget_row;

typedef struct budget {
    size_t n_rows;    /* two a link at most */
    budget_row *rows; /* in link order, making before motor, those without a parameter left out */
    double motors[6]; /* the share of all motors; that of all making is what is missing from 1 */
} budget;

/*
 * The shares of the worst case, or with method rss of the summed squares; each component in the pose where its worst
 * case is largest. All 0 for a component that nothing moves, nan for one that nothing bounds. False,
 * after a message, where memory is short.
 */
bool budget_make(budget *budget, const request *request, const answer *answer);
void budget_free(budget *budget);

#endif
