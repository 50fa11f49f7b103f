#ifndef ARMTOL_MAP_OUTPUT_H
#define ARMTOL_MAP_OUTPUT_H

#include "armtol/map/sheet.h"

#include <stdio.h>

typedef struct map_findings {
    const map_plan *plan;
    const map_found *found;
    const sheet *sheet; /* of the picture; NULL where none is asked for */
} map_findings;

/* For people, and for programs (docs/json.md), on standard output. False after a message where memory is short. */
void map_print_text(const map_findings *findings);
bool map_print_json(const map_findings *findings);

/* For outfile_write; data points to map_findings. */
void map_write_tsv(FILE *stream, const void *data);
void map_write_svg(FILE *stream, const void *data);

#endif
