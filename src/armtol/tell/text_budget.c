#include "armtol/names/link_name.h"
#include "armtol/tell/text_tables.h"
#include "console/table.h"

#include <math.h>
#include <stdio.h>

enum { BAR = 60 };

static void add_shares(table *table, const double shares[6])
{
    for (size_t i = 0; i < 6; i++) {
        table_add_cells(table, isnan(shares[i]) ? "-" : "%.1f", 100 * shares[i]);
    }
}

static bool has_loads(const armtol_budget *budget)
{
    bool any = false;
    for (size_t r = 0; r < budget->n_rows; r++) {
        any = any || budget->rows[r].role == ARMTOL_LOAD;
    }
    return any;
}

static bool print_table(const armtol_arm *arm, const armtol_budget *budget)
{
    table table = TABLE_EMPTY;
    table_add(&table, "link");
    for (size_t i = 0; i < 6; i++) {
        table_add_cells(&table, "%s", armtol_component_name(i));
    }
    for (size_t r = 0; r < budget->n_rows; r++) {
        table_add(&table, "%s %s", link_cell(arm, budget->rows[r].link, &(link_text){""}),
                  armtol_role_name(budget->rows[r].role));
        add_shares(&table, budget->rows[r].shares);
    }
    table_add(&table, "all motors");
    add_shares(&table, budget->motors);
    if (has_loads(budget)) {
        table_add(&table, "all loads");
        add_shares(&table, budget->loads);
    }
    return table_finish(&table, "Where the error comes from, % of each component", NULL, FORMAT_TEXT, stdout);
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
        /* a load that takes off from others leaves its own part of the bar empty */
        for (const size_t end = (size_t)(fmax(fmin(sum, 1), 0) * BAR + 0.5); at < end; at++) {
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
    if (has_loads(budget)) {
        printf("     loads     |");
        print_bar(budget, i, ARMTOL_LOAD);
    }
}

bool text_budget(const findings *findings)
{
    if (!print_table(findings->request->question.arm, findings->budget)) {
        return false;
    }
    printf("\nThe same as bars of link numbers, a whole component being %d long\n\n", BAR);
    for (size_t i = 0; i < 6; i++) {
        print_bars(findings->budget, i);
    }
    return true;
}
