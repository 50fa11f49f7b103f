#include "armtol/names/link_name.h"
#include "armtol/tell/text_tables.h"
#include "console/table.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { BAR = 60 };

static void add_share(table *table, double share)
{
    table_add_cells(table, isnan(share) ? "-" : "%.1f", 100 * share);
}

static bool has(const armtol_budget *budget, armtol_role role)
{
    bool any = false;
    for (size_t r = 0; r < budget->n_rows; r++) {
        any = any || budget->rows[r].role == role;
    }
    return any;
}

static bool print_table(const findings *findings)
{
    const armtol_arm *arm = findings->request->question.arm;
    const armtol_budget *budget = findings->budget;
    const size_t n = findings_measures(findings);
    table table = TABLE_EMPTY;
    table_add(&table, "link");
    for (size_t i = 0; i < n; i++) {
        table_add_cells(&table, "%s", findings_name(findings, i));
    }
    for (size_t r = 0; r < budget->n_rows; r++) {
        table_add(&table, "%s %s", link_cell(arm, budget->rows[r].link, &(link_text){""}),
                  armtol_role_name(budget->rows[r].role));
        for (size_t i = 0; i < n; i++) {
            add_share(&table, findings_share(&budget->rows[r], i));
        }
    }
    table_add(&table, "all motors");
    for (size_t i = 0; i < n; i++) {
        add_share(&table, findings_motors(budget, i));
    }
    if (has(budget, ARMTOL_LOAD)) {
        table_add(&table, "all loads");
        for (size_t i = 0; i < n; i++) {
            add_share(&table, findings_loads(budget, i));
        }
    }
    if (has(budget, ARMTOL_SHIFT)) {
        table_add(&table, "all shifts");
        for (size_t i = 0; i < n; i++) {
            add_share(&table, findings_shifts(budget, i));
        }
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
        sum += row->role == role ? findings_share(row, i) : 0;
        /* a load that takes off from others leaves its own part of the bar empty */
        for (const size_t end = (size_t)(fmax(fmin(sum, 1), 0) * BAR + 0.5); at < end; at++) {
            putchar(sign_of(row->link));
        }
    }
    putchar('\n');
}

static void print_bars(const findings *findings, size_t i, int width)
{
    const armtol_budget *budget = findings->budget;
    if (isnan(findings_motors(budget, i))) {
        printf("  %-*s without a bound\n", width, findings_name(findings, i));
        return;
    }
    printf("  %-*s motors    |", width, findings_name(findings, i));
    print_bar(budget, i, ARMTOL_MOTOR);
    printf("  %*s machining |", width, "");
    print_bar(budget, i, ARMTOL_MACHINING);
    if (has(budget, ARMTOL_LOAD)) {
        printf("  %*s loads     |", width, "");
        print_bar(budget, i, ARMTOL_LOAD);
    }
    if (has(budget, ARMTOL_SHIFT)) {
        printf("  %*s shifts    |", width, "");
        print_bar(budget, i, ARMTOL_SHIFT);
    }
}

bool text_budget(const findings *findings)
{
    size_t width = 0;
    if (!print_table(findings)) {
        return false;
    }
    for (size_t i = 0; i < findings_measures(findings); i++) {
        const size_t length = strlen(findings_name(findings, i));
        width = length > width ? length : width;
    }
    printf("\nThe same as bars of link numbers, a whole component being %d long\n\n", BAR);
    for (size_t i = 0; i < findings_measures(findings); i++) {
        print_bars(findings, i, (int)width);
    }
    return true;
}
