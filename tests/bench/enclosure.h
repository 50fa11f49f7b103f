#ifndef BENCH_ENCLOSURE_H
#define BENCH_ENCLOSURE_H

#include <stdbool.h>

/* How long the largest dx of a Puma 560 takes to enclose on one core, and prints it; false where that fails. */
bool enclosure_print(void);

#endif
