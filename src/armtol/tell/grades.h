#ifndef ARMTOL_TELL_GRADES_H
#define ARMTOL_TELL_GRADES_H

#include "armtol/tell/findings.h"

/* What workshops call a tolerance, rounded down: the grade and the class that are within it. */
typedef struct grades_held {
    const char *iso_286;  /* "IT7", or why there is none; NULL for an angle and for a motor */
    const char *iso_2768; /* "f" or "m"; NULL where neither is */
    double side;          /* mm, what the shorter side of an angle has to be longer than; nan of all else */
} grades_held;

/* Whether it is made, and not a motor's; what has no grades has none of the above. */
bool grades_has_parameter(const findings *findings, size_t column);
grades_held grades_of_parameter(const findings *findings, size_t column);

/* Of the distance between the axes of a link, which has to have a tolerance, and the nominal distance. */
grades_held grades_of_distance(const findings *findings, size_t link);
double grades_distance(const findings *findings, size_t link);
bool grades_has_distance(const findings *findings, size_t link);

/* Of the smallest angle of a part. */
grades_held grades_of_angle(double tolerance);

enum { GRADES_CLASS = 24 };

/* The class in words, "m over 120 mm", or `none`. Returns text. */
const char *grades_class(const grades_held *held, const char *none, char text[GRADES_CLASS]);

#endif
