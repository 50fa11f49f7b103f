#ifndef ARMTOL_TABLES_DEGREES_H
#define ARMTOL_TABLES_DEGREES_H

#include "console/number.h"

/*
 * Degrees as people write them, radians as doubles. The text is turned into radians with one rounding at the end, not
 * with a rounding to degrees in between: so 90 is the double nearest to pi/2, and every double has a decimal number of
 * degrees, of 17 digits at most, that is read as this very double. (Of two neighbouring doubles in radians there need
 * not be a double in degrees for each.)
 */

/* text is a decimal number in the sense of number_parse. */
double degrees_parse(const char *text);

/* In radians: of it, and of what is less, a double holds the degrees too. */
#define LARGEST_ANGLE 3.1e306

/*
 * The shortest text that degrees_parse takes for this double, of six digits or more. radians is LARGEST_ANGLE at most;
 * below 1e-280 the text may be taken for a neighbour. Returns shortest->text.
 */
const char *degrees_shortest(double radians, number_text *shortest);

#endif
