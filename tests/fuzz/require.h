#ifndef FUZZ_REQUIRE_H
#define FUZZ_REQUIRE_H

#include "fuzz/caught.h"

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

/* What has to hold for every input. If it does not, the place, and what the program said, go to the real stderr. */
#define REQUIRE(condition)                                                                                   \
    do {                                                                                                     \
        if (!(condition)) {                                                                                  \
            dprintf(STDERR_FILENO, "%s:%d: does not hold: %s\n", __FILE__, __LINE__, #condition);            \
            dprintf(STDERR_FILENO, "said: %s\n", caught_text());                                             \
            abort();                                                                                         \
        }                                                                                                    \
    } while (0)

#endif
