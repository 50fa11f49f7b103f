/* Standard tolerance grades, ISO 286-1. */

#include "armtol/grades.h"
#include "lib/grades/steps.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

enum { STEPS = 13, GRADES = ARMTOL_GRADE_WIDEST - ARMTOL_GRADE_FINEST + 1 };

/* mm, the upper end of each step */
static const double sizes[STEPS] = {3, 6, 10, 18, 30, 50, 80, 120, 180, 250, 315, 400, 500};

/* micrometres: ISO 286-1, table 1 */
static const short widths[GRADES][STEPS] = {
    {4, 5, 6, 8, 9, 11, 13, 15, 18, 20, 23, 25, 27},                   /* IT5 */
    {6, 8, 9, 11, 13, 16, 19, 22, 25, 29, 32, 36, 40},                 /* IT6 */
    {10, 12, 15, 18, 21, 25, 30, 35, 40, 46, 52, 57, 63},              /* IT7 */
    {14, 18, 22, 27, 33, 39, 46, 54, 63, 72, 81, 89, 97},              /* IT8 */
    {25, 30, 36, 43, 52, 62, 74, 87, 100, 115, 130, 140, 155},         /* IT9 */
    {40, 48, 58, 70, 84, 100, 120, 140, 160, 185, 210, 230, 250},      /* IT10 */
    {60, 75, 90, 110, 130, 160, 190, 220, 250, 290, 320, 360, 400},    /* IT11 */
    {100, 120, 150, 180, 210, 250, 300, 350, 400, 460, 520, 570, 630}, /* IT12 */
};

double armtol_grade_width(int grade, double size)
{
    const size_t step = step_of(sizes, STEPS, fabs(size));
    const bool known = grade >= ARMTOL_GRADE_FINEST && grade <= ARMTOL_GRADE_WIDEST && step < STEPS;
    return known ? widths[grade - ARMTOL_GRADE_FINEST][step] / 1000.0 : (double)NAN;
}

int armtol_grade_within(double size, double tolerance)
{
    const double thirteenth = 10 * armtol_grade_width(8, size); /* each fifth grade is ten times as wide */
    if (isnan(thirteenth) || isnan(tolerance)) {
        return ARMTOL_GRADE_NONE;
    }
    if (step_is_within(thirteenth / 2, tolerance)) {
        return ARMTOL_GRADE_WIDER;
    }
    int grade = ARMTOL_GRADE_WIDEST;
    while (grade > ARMTOL_GRADE_FINER && !step_is_within(armtol_grade_width(grade, size) / 2, tolerance)) {
        grade--; /* nothing is within FINER's width, nan */
    }
    return grade;
}

/* "5" to "12", as it is written: no sign, no 0 before it. */
static int number_of(const char *text)
{
    static const char *const numbers[GRADES] = {"5", "6", "7", "8", "9", "10", "11", "12"};
    int i = 0;
    while (i < GRADES && strcmp(text, numbers[i]) != 0) {
        i++;
    }
    return i < GRADES ? ARMTOL_GRADE_FINEST + i : ARMTOL_GRADE_NONE;
}

armtol_status armtol_grade_read(const char *name, armtol_grade *grade)
{
    static const struct {
        const char *letters;
        armtol_zone zone;
    } known[] = {{"IT", ARMTOL_ZONE_EVEN},
                 {"JS", ARMTOL_ZONE_EVEN},
                 {"js", ARMTOL_ZONE_EVEN},
                 {"H", ARMTOL_ZONE_ABOVE},
                 {"h", ARMTOL_ZONE_BELOW}};
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++) {
        const size_t length = strlen(known[i].letters);
        const int number = strncmp(name, known[i].letters, length) == 0 ? number_of(name + length) : ARMTOL_GRADE_NONE;
        if (number != ARMTOL_GRADE_NONE) {
            *grade = (armtol_grade){number, known[i].zone};
            return ARMTOL_OK;
        }
    }
    return ARMTOL_BAD_GRADE;
}

armtol_range armtol_grade_limits(const armtol_grade *grade, double size)
{
    const double width = size > 0 ? armtol_grade_width(grade->grade, size) : (double)NAN;
    if (isnan(width)) {
        return (armtol_range){width, width};
    }
    switch (grade->zone) {
    case ARMTOL_ZONE_EVEN:
        return (armtol_range){-width / 2, width / 2};
    case ARMTOL_ZONE_ABOVE:
        return (armtol_range){0, width};
    case ARMTOL_ZONE_BELOW:
        return (armtol_range){-width, 0};
    default:
        return (armtol_range){(double)NAN, (double)NAN};
    }
}
