#include "armtol/tell/output.h"

#include "armtol/names/link_name.h"
#include "console/number.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* In quotes where it needs them: RFC 4180, and a # begins a comment in tables that are read again. */
static void put_name(const char *name)
{
    const bool quotes = strpbrk(name, "\",;#\t ") != NULL;
    putchar(',');
    fputs(quotes ? "\"" : "", stdout);
    for (; *name != '\0'; name++) {
        fputs(*name == '"' ? "\"\"" : (const char[]){*name, '\0'}, stdout);
    }
    fputs(quotes ? "\"" : "", stdout);
}

bool output_csv(const findings *findings)
{
    const bool names = links_have_names(findings->request->question.arm);
    printf("link,kind,parameter,role,nominal,tolerance,unit%s\n", names ? ",name" : "");
    for (size_t k = 0; k < findings->answer->n_columns; k++) {
        const parameter_row row = findings_parameter(findings, k);
        const char *tolerance = isfinite(row.tolerance)
                                    ? number_shortest(row.tolerance, &armtol_errata_none, &(number_text){""})
                                    : "inf";
        printf("%zu,%s,%s,%s,%s,%s,%s", row.link, row.kind, row.parameter, row.role,
               number_shortest(row.nominal, &armtol_errata_none, &(number_text){""}), tolerance, row.unit);
        if (names) {
            put_name(row.name != NULL ? row.name : "");
        }
        putchar('\n');
    }
    return true;
}
