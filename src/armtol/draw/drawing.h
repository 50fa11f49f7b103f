#ifndef ARMTOL_DRAW_DRAWING_H
#define ARMTOL_DRAW_DRAWING_H

#include <stdio.h>

/* What a drawing may say for the tolerances of findings (data) to be kept: a table that --drawing reads. */
void drawing_write(FILE *stream, const void *data);

#endif
