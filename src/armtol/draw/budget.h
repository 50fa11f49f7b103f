#ifndef ARMTOL_DRAW_BUDGET_H
#define ARMTOL_DRAW_BUDGET_H

#include <stdio.h>

/* The budget of findings as bars, for outfile_write; data points to findings that have one. */
void budget_write_svg(FILE *stream, const void *data);

#endif
