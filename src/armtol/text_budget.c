#include "table.h"
#include "text_tables.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { BAR = 60 };

static void set_share(table_row *row, size_t i, double share)
{
    if (isnan(share)) {
        table_set(row, i + 1, "-");
    } else {
        table_set(row, i + 1, "%.1f", 100 * share);
    }
}

static bool print_table(const budget *budget)
{
    const char *head[7] = {"link"};
    table table;
    for (int i = 0; i < 6; i++) {
        head[i + 1] = component_names[i];
    }
    table_start(&table, 7);
    bool fine = table_add_head(&table, head);
    for (size_t r = 0; r < budget->n_rows && fine; r++) {
        char label[TABLE_CELL];
        snprintf(label, sizeof label, "%zu %s", budget->rows[r].link, budget->rows[r].motor ? "motor" : "machining");
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

/* Lengthens the bar to what the sum of shares says. */
static void lengthen(char bar[BAR + 1], double sum, char sign)
{
    const size_t end = (size_t)(sum * BAR + 0.5);
    for (size_t at = strlen(bar); at < end && at < BAR; at++) {
        bar[at] = sign;
        bar[at + 1] = '\0';
    }
}

static void print_bar(const budget *budget, size_t i)
{
    char bar[2][BAR + 1] = {"", ""};
    double sum[2] = {0, 0};
    for (size_t r = 0; r < budget->n_rows; r++) {
        const budget_row *row = &budget->rows[r];
        sum[row->motor] += row->shares[i];
        lengthen(bar[row->motor], sum[row->motor], sign_of(row->link));
    }
    printf("  %s motors    |%s\n     machining |%s\n", component_names[i], bar[true], bar[false]);
}

bool text_budget(const findings *findings)
{
    if (!print_table(findings->budget)) {
        return false;
    }
    printf("\nThe same as bars of link numbers, a whole component being %d long\n\n", BAR);
    for (size_t i = 0; i < 6; i++) {
        if (isnan(findings->budget->motors[i])) {
            printf("  %s without a bound\n", component_names[i]);
        } else {
            print_bar(findings->budget, i);
        }
    }
    return true;
}
