#include "armtol/tell/text_tables.h"
#include "console/table.h"

#include <math.h>
#include <stdio.h>

enum { BAR = 60 };

static void set_share(table_row *row, size_t i, double share)
{
    table_set(row, i + 1, isnan(share) ? "-" : "%.1f", 100 * share);
}

static bool print_table(const armtol_budget *budget)
{
    const char *head[7] = {"link"};
    table table;
    for (size_t i = 0; i < 6; i++) {
        head[i + 1] = armtol_component_name(i);
    }
    table_start(&table, 7);
    bool fine = table_add_head(&table, head);
    for (size_t r = 0; r < budget->n_rows && fine; r++) {
        char label[TABLE_CELL];
        snprintf(label, sizeof label, "%zu %s", budget->rows[r].link, armtol_role_name(budget->rows[r].role));
        table_row *row = table_add(&table, label);
        fine = row != NULL;
        for (size_t i = 0; i < 6 && fine; i++) {
            set_share(row, i, budget->rows[r].shares[i]);
        }
    }
    table_row *row = fine ? table_add(&table, "all motors") : NULL;
    for (size_t i = 0; i < 6 && row != NULL; i++) {
        set_share(row, i, budget->motors[i]);
    }
    if (row != NULL) {
        table_print_title("Where the error comes from, % of each component", NULL, FORMAT_TEXT, stdout);
        table_print(&table, FORMAT_TEXT, stdout);
    }
    table_free(&table);
    return row != NULL;
}

/* A link's sign in a bar: 0 to 9, then letters, then over again. */
static char sign_of(size_t link)
{
    static const char signs[] = "0123456789abcdefghijklmnopqrstuvwxyz";
    return signs[link % (sizeof signs - 1)];
}

/* Up to what the sum of the shares says, which rounding may bring above 1. */
static void print_bar(const armtol_budget *budget, size_t i, armtol_role role)
{
    double sum = 0;
    size_t at = 0;
    for (size_t r = 0; r < budget->n_rows; r++) {
        const armtol_budget_row *row = &budget->rows[r];
        sum += row->role == role ? row->shares[i] : 0;
        for (const size_t end = (size_t)(fmin(sum, 1) * BAR + 0.5); at < end; at++) {
            putchar(sign_of(row->link));
        }
    }
    putchar('\n');
}

static void print_bars(const armtol_budget *budget, size_t i)
{
    if (isnan(budget->motors[i])) {
        printf("  %s without a bound\n", armtol_component_name(i));
        return;
    }
    printf("  %s motors    |", armtol_component_name(i));
    print_bar(budget, i, ARMTOL_MOTOR);
    printf("     machining |");
    print_bar(budget, i, ARMTOL_MACHINING);
}

bool text_budget(const findings *findings)
{
    if (!print_table(findings->budget)) {
        return false;
    }
    printf("\nThe same as bars of link numbers, a whole component being %d long\n\n", BAR);
    for (size_t i = 0; i < 6; i++) {
        print_bars(findings->budget, i);
    }
    return true;
}
