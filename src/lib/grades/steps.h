#ifndef ARMTOL_LIB_GRADES_STEPS_H
#define ARMTOL_LIB_GRADES_STEPS_H

#include <stdbool.h>
#include <stddef.h>

/* What is equal on paper is: numbers may have come from inches, degrees or a sum. nan is within nothing. */
static inline bool step_is_within(double value, double limit)
{
    return value <= limit * (1 + 1e-12);
}

/* The step that a size lies in, over the end before it and up to its own; n for one above them all, 0 or nan. */
static inline size_t step_of(const double ends[], size_t n, double size)
{
    size_t step = size > 0 ? 0 : n;
    while (step < n && !step_is_within(size, ends[step])) {
        step++;
    }
    return step;
}

#endif
