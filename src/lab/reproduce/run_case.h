#ifndef ARMTOL_LAB_REPRODUCE_RUN_CASE_H
#define ARMTOL_LAB_REPRODUCE_RUN_CASE_H

#include "console/message.h"
#include "lab/published.h"

#include <stdbool.h>
#include <stddef.h>

/* Where the programs stand and how they are to be run. */
typedef struct run_settings {
    const char *programs; /* the folder of intella and adpta */
    const char *fix;      /* an argument for --fix, or NULL */
    const char *out;      /* the folder that gets one folder a case */
    bool legacy;          /* the programs take no options and write where they are started */
    const char *runner;   /* legacy only: the beginning of the command, an emulator say; or "" */
} run_settings;

/*
 * Run the case that begins at number `first` as a process of its own. Its folder, OUT/PROGRAM-CASE, then holds
 * the four files, `input` (what the program read) and `dialogue` (what it said).
 * False, after a message, where that failed.
 */
bool run_case(const run_settings *settings, const published_list *list, size_t first);

/* What the case's files say, the tolerance and the machining file one after the other; to be freed. */
char *run_case_results(const run_settings *settings, const published_number *number);

/* Room for a path, or an argument that holds one. */
typedef struct path {
    char text[4096];
} path;

/* "a/b/c" from printf's arguments; false, after a message, where it is too long. */
bool path_of(path *path, const char *format, ...) LIKE_PRINTF(2, 3);

#endif
