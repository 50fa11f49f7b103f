#ifndef ARMTOL_LIB_REGION_LOAD_SUM_H
#define ARMTOL_LIB_REGION_LOAD_SUM_H

#include "lib/private_names.h"
#include "lib/region/corner_vectors.h"

/* Of a drive in a case: from where to where its element of A and its moment go at the corners of a box. */
typedef struct load_range {
    double element, element_half; /* the middle, and half of the width */
    double moment, moment_half;
    bool unsure; /* on which side the load holds the play is not the same in all of the box */
} load_range;

/* Memory to work in. */
typedef struct load_space {
    vectors *weights, *pushes; /* a link: gravity and force along its turned frame, a choice up to its corner each */
    vectors *levers, *reaches; /* a link: for choices behind it the sum of mass times place, and the tool point, both
                                  from the link's end */
    double *carried;           /* a link: the mass at and behind it */
    double *lengths, *most, *least; /* a link: the longest it is; the most, and the least, its moment could be */
    double *elements, *moments, *up, *down, *sums; /* a choice of all corners each */
    load_range *ranges;        /* n_cases x n_drives */
    double *memory;
} load_space;

/* before, after: the most choices of a link and those before it, and behind it. False where memory is short. */
bool load_space_make(load_space *space, const chain *chain, const size_t before[], const size_t after[], size_t most);
void load_space_free(load_space *space);

struct corner_box;
struct corner_space;

/*
 * The largest error at all corners with what the drives give way by, in any case, and the choice where it is. sums are
 * the errors without, which repeat after n_sums choices.
 */
double load_sum_largest(const chain *chain, const struct corner_box *box, struct corner_space *space,
                        const double sums[], size_t n_sums, size_t *best);

#endif
