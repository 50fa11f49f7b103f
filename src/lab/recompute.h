#ifndef ARMTOL_LAB_RECOMPUTE_H
#define ARMTOL_LAB_RECOMPUTE_H

#include "1987/analysis.h"
#include "1987/program.h"
#include "lab/published.h"

#include <stdbool.h>
#include <stddef.h>

/*
 * Run the case that begins at number `first` in this process, with these errata, and with these words where 1987 took
 * what it found on the stack: NULL for those that the library works out. True: the analysis is complete and has to be
 * freed. False, after a message: there is nothing to free.
 */
bool recompute(const published_list *list, size_t first, const armtol_errata *errata, const armtol_residue *residue,
               analysis *analysis);

/*
 * What the tolerance and the machining file would say, one after the other; to be freed; NULL after a message. Of a
 * complete analysis, and of a case.
 */
char *recompute_text(const analysis *analysis, const program *program);
char *recompute_files(const published_list *list, size_t first, const armtol_errata *errata);

#endif
