#ifndef ARMTOL_1987_PROGRAM_H
#define ARMTOL_1987_PROGRAM_H

#include "armtol/robots.h"

#include <stdbool.h>
#include <stddef.h>

/* What makes one of the two programs of 1987 differ from the other. */
typedef struct program {
    const char *name;
    const armtol_robot *robot;
    const char *title;               /* "For the ..." in the files */
    const char *file_prefix;         /* int: inta.1, intat.1, inttol.1, intmach.1 */
    const char *const *wish_names;   /* in messages: x, y, z, gamma ... */
    const char *const *wish_letters; /* in the files: x, y, z, g ... */
    const char *reach_subject;       /* "the wrist would be 700 mm from the shoulder" */
    const char *reach_origin;
    const char *singular_text;       /* NULL where no wish is singular */
} program;

extern const program program_intella; /* the Intelledex 605T */
extern const program program_adpta;   /* the Adept AdeptOne */

/* How many errata are kept. */
size_t errata_kept(const armtol_errata *errata);

/* Whether the erratum of that index can change the program's results. */
bool program_shows_erratum(const program *program, size_t index);

/* The program of that name, or NULL. */
const program *program_named(const char *name);

/* The whole program: options, dialogue, files. Returns its exit code. */
int program_main(int argc, char *argv[], const program *program);

#endif
