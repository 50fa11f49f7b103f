#ifndef ARMTOL_LAB_YIELD_COLUMN_TOLERANCES_H
#define ARMTOL_LAB_YIELD_COLUMN_TOLERANCES_H

#include "1987/analysis.h"

/*
 * What a machinist takes for the tolerance of a length.
 *
 * The bound on lengths is shared out among the parameters a and d of all links, so the share is what the
 * theory lets each of them be off. Eq. (4.32) then gives a link one tolerance, rd: what the distance h
 * between its axes is off when a and d are both off by the share. It is the tolerance of neither: of a link
 * with a = d = 0 it is the share times the root of 2. But rd is what the machining file prints, and of a
 * link with only one length whoever makes it will take rd for that length's tolerance. Of a link with two,
 * rd alone does not say what each may be off.
 */
typedef enum length_reading {
    LENGTHS_SHARE, /* every length within the share */
    LENGTHS_RD,    /* the length of a link that has only one within its rd, the others within the share */
    LENGTH_READING_COUNT
} length_reading;

/*
 * What the parameter of each column of A may be off, in a complete analysis; magnitudes, where the erratum
 * signed-mach gives a negative one. The parameter that a joint moves has the tolerance of the joint's motor,
 * in place of one of its own: A has one column for it, and the bounds are shared among as many parameters as
 * A has columns.
 */
void column_tolerances(const analysis *analysis, length_reading reading, double tolerances[]);

#endif
