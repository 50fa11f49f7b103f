#ifndef TEST_SHORT_MAIN_H
#define TEST_SHORT_MAIN_H

/* A whole program in this process, memory running out (short_memory.h) at every place where it can. */

typedef int main_routine(int argc, char *argv[]);

/*
 * entry is its main, which armtol_test_short_main in tests/CMakeLists.txt has compiled under another name. Runs it with
 * no allocation that succeeds, with one, with two ... until none fails: before that it has to end with EXIT_FAILED and
 * the message that memory is short. The same where one allocation alone fails; it may then do without, and say nothing.
 * arguments, the name first, go up to a NULL. Fewer than `least` allocations would be too few to be true.
 */
void check_short_main(main_routine *entry, const char *const arguments[], long least);

/* The same of what is wrong: the message that this is begins with `refusal`. */
void check_short_refused(main_routine *entry, const char *const arguments[], const char *refusal, long least);

/* With all the memory that it asks for it ends with EXIT_OK, and says nothing on standard error. */
void check_main_ends_well(main_routine *entry, const char *const arguments[]);

/*
 * It has to end with EXIT_FAILED and say that `file` cannot be opened where no descriptor is to be had. A program keeps
 * in mind that the machine has failed: to be called before the others.
 */
void check_main_without_descriptors(main_routine *entry, const char *const arguments[], const char *file);

#endif
