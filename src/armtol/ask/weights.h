#ifndef ARMTOL_ASK_WEIGHTS_H
#define ARMTOL_ASK_WEIGHTS_H

#include "armtol/arm.h"
#include "armtol/error_matrix.h"

#include <stdbool.h>

/*
 * The argument of --weights, NULL where there is none, one weight a column: NAME=NUMBER,... , where NAME is a parameter
 * (theta), a class (lengths, angles, motors, machining), or one of these of a link (3.alpha, 3.motors), and the last
 * that names a column holds; or the name, without an =, of a table with a column `weight`. 1 for what is not named.
 * False after a message.
 */
bool weights_parse(const char *text, const armtol_arm *arm, const armtol_column columns[], size_t n_columns,
                   double weights[]);

#endif
