/* General tolerances, ISO 2768-1. */

#include "armtol/grades.h"
#include "lib/grades/steps.h"
#include "lib/pi.h"

#include <math.h>
#include <stddef.h>

enum { STEPS = 8, SIDES = 5 };

#define LEAST 0.5 /* mm */

/* mm, the upper end of each step */
static const double sizes[STEPS] = {3, 6, 30, 120, 400, 1000, 2000, 4000};

/* mm: ISO 2768-1, table 1; 0 for none */
static const double deviations[ARMTOL_GENERAL_COUNT][STEPS] = {
    [ARMTOL_GENERAL_FINE] = {0.05, 0.05, 0.1, 0.15, 0.2, 0.3, 0.5, 0},
    [ARMTOL_GENERAL_MEDIUM] = {0.1, 0.1, 0.2, 0.3, 0.5, 0.8, 1.2, 2},
};

/* mm, and minutes of arc: ISO 2768-1, table 3. The last step has no upper end. */
static const double sides[SIDES - 1] = {10, 50, 120, 400};
static const double minutes[SIDES] = {60, 30, 20, 10, 5};

const char *armtol_general_name(armtol_general of)
{
    return of == ARMTOL_GENERAL_FINE ? "f" : of == ARMTOL_GENERAL_MEDIUM ? "m" : "";
}

double armtol_general_length(armtol_general of, double size)
{
    const size_t step = step_of(sizes, STEPS, fabs(size));
    const bool known = (unsigned)of < ARMTOL_GENERAL_COUNT && step < STEPS && step_is_within(LEAST, fabs(size));
    const double deviation = known ? deviations[of][step] : 0;
    return deviation > 0 ? deviation : (double)NAN;
}

armtol_general armtol_general_within(double size, double tolerance)
{
    return step_is_within(armtol_general_length(ARMTOL_GENERAL_MEDIUM, size), tolerance) ? ARMTOL_GENERAL_MEDIUM
           : step_is_within(armtol_general_length(ARMTOL_GENERAL_FINE, size), tolerance) ? ARMTOL_GENERAL_FINE
                                                                                         : ARMTOL_GENERAL_COUNT;
}

static double angle_of_step(size_t step)
{
    return minutes[step] / 60 * PI / 180;
}

double armtol_general_angle(double side)
{
    return side > 0 ? angle_of_step(step_of(sides, SIDES - 1, side)) : (double)NAN;
}

double armtol_general_side(double tolerance)
{
    size_t step = 0;
    while (step < SIDES && !step_is_within(angle_of_step(step), tolerance)) {
        step++;
    }
    return step == 0 ? 0 : step < SIDES ? sides[step - 1] : (double)INFINITY;
}
