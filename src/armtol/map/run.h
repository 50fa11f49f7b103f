#ifndef ARMTOL_MAP_RUN_H
#define ARMTOL_MAP_RUN_H

#include "armtol/ask/request.h"

/* The map that a request asks for: found, written and printed. An exit code. */
int map_run(const request *request);

#endif
