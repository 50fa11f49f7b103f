#include "armtol/tell/output.h"

#include "console/number.h"

#include <math.h>
#include <stdio.h>

bool output_csv(const findings *findings)
{
    puts("link,kind,parameter,role,nominal,tolerance,unit");
    for (size_t k = 0; k < findings->answer->n_columns; k++) {
        const parameter_row row = findings_parameter(findings, k);
        const char *tolerance = isfinite(row.tolerance)
                                    ? number_shortest(row.tolerance, &armtol_errata_none, &(number_text){""})
                                    : "inf";
        printf("%zu,%s,%s,%s,%s,%s,%s\n", row.link, row.kind, row.parameter, row.role,
               number_shortest(row.nominal, &armtol_errata_none, &(number_text){""}), tolerance, row.unit);
    }
    return true;
}
