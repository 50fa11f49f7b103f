#ifndef TEST_SHORT_MEMORY_H
#define TEST_SHORT_MEMORY_H

/*
 * Memory that runs out. In a program that is linked with the linker's --wrap (armtol_test_short_memory in
 * tests/CMakeLists.txt) the calls of malloc, calloc, realloc and strdup in the project's own code, and those of fdopen
 * and open_memstream, which allocate a stream, are counted. Libraries' own calls are not.
 */

/* The next n allocations succeed, all after them fail; 0: none does. */
void memory_is_left(long n);

/* None fails from now on, as before memory_is_left. */
void memory_is_enough(void);

#endif
