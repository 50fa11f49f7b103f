#ifndef ARMTOL_ASK_ARM_SOURCE_H
#define ARMTOL_ASK_ARM_SOURCE_H

#include "armtol/ask/options.h"
#include "armtol/tables/arm_model.h"

#include <stdio.h>

/*
 * The arm of the command line: a built-in one of that name, else a file, which is a URDF where it begins with '<' and
 * else a table; the program xacro expands one that ends in .xacro, or where --xacro says so. EXIT_OK, or an exit code
 * after a message.
 */
int arm_source_read(const cli_options *options, arm_model *model);

/* The arm in a stream that can be wound back; options->arm is its name in messages. An exit code as above. */
int arm_source_take(FILE *stream, const cli_options *options, arm_model *model);

/* The links of the command line's URDF, drawn on standard output. EXIT_OK, or an exit code after a message. */
int arm_source_draw(const cli_options *options);

#endif
