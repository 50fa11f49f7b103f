#ifndef TEST_FAULTY_H
#define TEST_FAULTY_H

#include "faults/fault.h"

/* What the parts of the shared object share. */
extern fault faulty_plan;
extern fault_outcome *faulty_outcome; /* NULL until main is about to begin: until then nothing goes wrong */

/* Find the routines that ours are put before. */
void faulty_memory_start(void);

/* From here on the kernel hands this process's calls to us. Ends the process where it does not. */
void faulty_calls_start(void);

/* A system call that is not handed to us. */
long faulty_call(long number, const long arguments[5]);

#endif
