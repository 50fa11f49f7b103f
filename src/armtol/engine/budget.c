#include "armtol/engine/budget.h"

#include "console/exit_code.h"

#include <math.h>
#include <stdlib.h>

/* The row of a link and a role, made if it is not there. */
static budget_row *row_of(budget *budget, size_t link, bool motor)
{
    for (size_t i = 0; i < budget->n_rows; i++) {
        if (budget->rows[i].link == link && budget->rows[i].motor == motor) {
            return &budget->rows[i];
        }
    }
    budget_row *row = &budget->rows[budget->n_rows++];
    *row = (budget_row){.link = link, .motor = motor};
    return row;
}

/* What a column puts into a component: a magnitude, or its square. */
static double contribution(const request *request, const answer *answer, size_t column, size_t i)
{
    const posed_arm *posed = &request->posed;
    const double *matrix = posed_arm_matrix(posed, answer->components[i].worst_pose);
    const double error = fabs(matrix[i * posed->n_columns + column]) * answer->bounded[column];
    return request->options->method == METHOD_RSS ? error * error : error;
}

static double share_of(double part, double total)
{
    return isinf(total) ? (double)NAN : total > 0 ? part / total : 0;
}

static void add_component(budget *budget, const request *request, const answer *answer, size_t i)
{
    const posed_arm *posed = &request->posed;
    double total = isinf(answer->components[i].worst) ? (double)INFINITY : 0;
    for (size_t k = 0; k < posed->n_columns; k++) {
        total += contribution(request, answer, k, i);
    }
    for (size_t k = 0; k < posed->n_columns; k++) {
        const bool motor = posed_arm_is_motor(posed, k);
        const double share = share_of(contribution(request, answer, k, i), total);
        row_of(budget, posed->columns[k].link, motor)->shares[i] += share;
        budget->motors[i] += motor ? share : 0;
    }
}

static int in_order(const void *one, const void *other)
{
    const budget_row *a = one, *b = other;
    return a->link != b->link ? (a->link > b->link) - (a->link < b->link) : (int)a->motor - (int)b->motor;
}

bool budget_make(budget *budget, const request *request, const answer *answer)
{
    *budget = (struct budget){.rows = calloc(2 * request->posed.n_links, sizeof *budget->rows)};
    if (budget->rows == NULL) {
        out_of_memory();
        return false;
    }
    for (size_t i = 0; i < 6; i++) {
        add_component(budget, request, answer, i);
    }
    qsort(budget->rows, budget->n_rows, sizeof *budget->rows, in_order);
    return true;
}

void budget_free(budget *budget)
{
    free(budget->rows);
}
