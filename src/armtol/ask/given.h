#ifndef ARMTOL_ASK_GIVEN_H
#define ARMTOL_ASK_GIVEN_H

#include "armtol/ask/named.h"
#include "armtol/ask/units.h"
#include "armtol/lists/lists.h"

#include <stdbool.h>

/*
 * The argument of --given, NULL where there is none: NAME=NUMBER, NAME=LEAST..LARGEST, NAME>=LEAST, NAME<=LARGEST, with
 * the names of --weights, in the user's units; one range a column, 0 to infinity where nothing is said. What is said
 * later holds. False after a message.
 */
bool given_parse(const char *text, const named_columns *of, const units *units, double least[], double largest[]);

/* The list of --tolerances: NAME=NUMBER, 0 for what is not named. */
bool given_tolerances_parse(const char *text, const named_columns *of, const units *units, double tolerances[]);

/*
 * The argument of --drives, NULL where there is none: NAME=NUMBER, where NAME is a column of an arm's table (backlash,
 * 2.compliance).
 */
bool given_drives_parse(const char *text, const armtol_arm *arm, const units *units, armtol_drive drives[]);

/*
 * The argument of --spread, NULL where there is none: NAME=DISTRIBUTION,... with the names of --weights, or a table
 * (lists.h) where there is no = in it. What is not said stays as it was; what is said later holds. groups: as of
 * spreads_read. False after a message.
 */
bool given_spreads_parse(const char *text, const named_columns *of, const units *units, armtol_error_spread spreads[],
                         group_name groups[]);

#endif
