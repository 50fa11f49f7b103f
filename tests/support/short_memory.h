#ifndef TEST_SHORT_MEMORY_H
#define TEST_SHORT_MEMORY_H

#include <stdbool.h>

/*
 * Memory that runs out. In a program that is linked with the linker's --wrap (armtol_test_short_memory in
 * tests/CMakeLists.txt) the calls of malloc, calloc, realloc and strdup in the project's own code, and those of fdopen,
 * open_memstream and posix_spawn_file_actions_addopen, which allocate, are counted. Libraries' own calls are not.
 */

typedef enum memory_lack { LACK_FOR_GOOD, LACK_ONCE, LACKS } memory_lack;

/* The next n allocations succeed; all after them fail, or just the one that follows. */
void memory_is_left(long n, memory_lack lack);

/* Whether one has failed since. */
bool memory_was_short(void);

/* None fails from now on, as before memory_is_left. */
void memory_is_enough(void);

#endif
