#ifndef ARMTOL_LIB_LANES_VECTORS_H
#define ARMTOL_LIB_LANES_VECTORS_H

#include <float.h>

/*
 * Whether the compiler has vectors, and whether it has those of x86-64, whose width is known when the program runs.
 * What computes in long double (x87, 68881) has none, nor may a long double be put into one.
 */
#if defined(__GNUC__) && (FLT_EVAL_METHOD == 0 || FLT_EVAL_METHOD == 1)
#define VECTORS 1
#else
#define VECTORS 0
#endif

#if VECTORS && defined(__x86_64__)
#define VECTORS_OF_X86 1
#else
#define VECTORS_OF_X86 0
#endif

#endif
