#ifndef ARMTOL_PAGE_WASM_PAGE_H
#define ARMTOL_PAGE_WASM_PAGE_H

#include <stdint.h>

/*
 * What the page asks of the C code. Texts that are returned are JSON objects and stay until the next call; an object
 * with a member `error` says why there is nothing else. Millimetres and radians.
 */

/* The published numbers; 0 after a message. Before the others of bench.c. */
int page_open(const char *path);

/* The rows of the table of errata. */
const char *page_errata(void);

/* All published numbers beside what comes out with these errata corrected: names, a blank between each. */
const char *page_bench(const char *corrected);

/* The same with all errata kept and these three words on the stack of adpta, read as floats. */
const char *page_stack(uint32_t first, uint32_t second, uint32_t third);

/* alpha of the Adept's tool as adpta keeps it: in a float. */
double page_tool_alpha(void);

/* What the library works out for that place of the diagonal, 0 to 2, of the Adept's skew matrix. */
double page_tool_residue(int place);

/* The built-in arms: names, titles, joints. */
const char *page_arms(void);

/* The frames of an arm, a built-in one's name or a file, with these joint values; base first. NULL: all joints at 0. */
const char *page_frames(const char *arm, const double q[], int n_joints);

/* Joint values that bring the arm of intella or adpta to a wish, no erratum; error where it does not get there. */
const char *page_reach(const char *program, const double wish[]);

/*
 * `count` arms drawn to the tolerances of 1987 and as many to the corrected ones, at that wish: the six errors of each,
 * and how many keep to the accuracy. given: six tolerances and delta.
 */
const char *page_cloud(const char *program, const double wish[], const double given[7], int count, int seed);

/*
 * One command line of armtol with --verify, in parts: several workers draw arms, each in steps of its own, and what
 * they counted is added up exactly. An exit code, after a message; 0 is fine.
 */
int page_verify_begin(int argc, char *argv[]);
int page_verify_draw(double first, double count);

/* What was counted, its size in bytes; another's is added to one's own. */
void *page_verify_counted(void);
int page_verify_size(void);
void page_verify_add(const void *counted);

/* Prints what armtol prints. An exit code. */
int page_verify_end(void);

#endif
