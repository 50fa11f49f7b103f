#ifndef EXPERIMENTS_COLUMN_TOLERANCES_H
#define EXPERIMENTS_COLUMN_TOLERANCES_H

#include "analysis.h"

/*
 * What a machinist takes for the tolerance of a length.
 *
 * Eq. (4.32) gives a link one tolerance, rd, of the distance h between its axes. It is what h can be off when a
 * and d are off by the share of one parameter each, and so no tolerance of either: of a link with a = d = 0 it
 * is the share times the root of 2. The bound was shared out among the parameters; the share is the reading that
 * the theory means. But rd is what the machining file prints, and where a link has only one length to be made,
 * who makes it can only take rd for that length's tolerance.
 */
typedef enum length_reading {
    LENGTHS_SHARE, /* every length within the share */
    LENGTHS_RD,    /* the length of a link that has only one within its rd, the others within the share */
    LENGTH_READING_COUNT
} length_reading;

/* "share" or "rd". */
bool length_reading_of(const char *name, length_reading *reading);

/*
 * What the parameter of each column of A may be off, in a complete analysis; magnitudes, where the erratum
 * signed-mach gives a negative one. The parameter that a joint moves has the tolerance of its motor, in place of
 * one of its own: A counts it once, and so do the bounds and the numbers of parameters that share them.
 */
void column_tolerances(const analysis *analysis, length_reading reading, double tolerances[]);

#endif
