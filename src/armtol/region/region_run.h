#ifndef ARMTOL_REGION_REGION_RUN_H
#define ARMTOL_REGION_REGION_RUN_H

#include "armtol/ask/request.h"
#include "armtol/region.h"

/*
 * Answer a request that names a region, with somebody who waits for it: the gap, falling, on standard error where
 * that is a terminal, and an interrupt ends the work, not the program. The request has the answer's poses from then
 * on. EXIT_OK, or an exit code after a message; the answer is to be destroyed.
 */
int region_run(request *request, armtol_region_answer **answer);

/* EXIT_OK where the bounds are as near as asked for; else, after a message of what is proved, EXIT_FAILED. */
int region_exit_code(const request *request, const armtol_region_answer *answer);

#endif
