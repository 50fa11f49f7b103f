#include "armtol/draw/drawing.h"

#include "armtol/drawing/drawn.h"
#include "armtol/tell/findings.h"
#include "console/number.h"

#include <math.h>
#include <stdlib.h>

/* Six digits, rounded down: printing adds no more than 5e-6 of it. A dash where there is nothing to say. */
static void put(FILE *stream, double value)
{
    char text[40];
    if (isnan(value)) {
        fputs(",-", stream);
        return;
    }
    snprintf(text, sizeof text, "%.6g", value * (1 - 5e-6));
    fprintf(stream, ",%s", number_shortest(strtod(text, NULL), &armtol_errata_none, &(number_text){""}));
}

void drawing_write(FILE *stream, const void *data)
{
    const findings *findings = data;
    const units *units = &findings->request->units;
    fprintf(stream, "link,distance,angle,split,unit\n");
    for (size_t i = 0; i < findings->answer->n_links; i++) {
        const drawing_row row = drawn_row(findings->answer, findings->request->question.arm, i);
        fprintf(stream, "%zu", i);
        put(stream, units_shown(units, true, row.distance));
        put(stream, units_shown(units, false, row.angle));
        fprintf(stream, ",%s,%s %s\n", drawing_split_name(row.split), units_name(units, true),
                units_name(units, false));
    }
}
