#ifndef ARMTOL_GRADES_H
#define ARMTOL_GRADES_H

#include "armtol/drawing.h"
#include "armtol/interface.h"
#include "armtol/status.h"

ARMTOL_INTERFACE_BEGIN

/*
 * The tolerances that workshops have names for: the grades IT5 to IT12 of ISO 286-1 for sizes to 500 mm, and the
 * classes f and m of ISO 2768-1.
 *
 * Notes:
 * 1) Lengths are in mm, whatever the arm's unit is: the standards' tables are. Angles are in radians.
 * 2) A tolerance is to either side, +- t; a grade has a width, which is 2 t. So a grade is within a tolerance where
 *    half its width is no more than t.
 * 3) What is equal on paper is: sizes and tolerances are compared to a part in 1e12.
 * 4) A step of sizes is over its lower end, up to and including its upper one.
 *
 * References:
 *    ISO 286-1:2010, table 1 (the same numbers as in ISO 286-1:1988); ISO 2768-1:1989, tables 1 and 3. docs/grades.md
 *    says where the numbers were taken from and what they were compared with.
 */

enum {
    ARMTOL_GRADE_NONE = 0,    /* the size is not above 0, above 500 mm, or nan */
    ARMTOL_GRADE_FINER = 4,   /* finer than the finest that is known */
    ARMTOL_GRADE_FINEST = 5,  /* IT5 */
    ARMTOL_GRADE_WIDEST = 12, /* IT12 */
    ARMTOL_GRADE_WIDER = 13   /* wider than the widest that is known: IT13 would do */
};

/*
 * The width of a grade.
 *
 * Given:
 *    grade   5 to 12, of IT5 to IT12
 *    size    nominal size in mm, of either sign, |size| to 500
 * Returned (function value):
 *    the width in mm; nan for another grade, and for a size of 0, above 500 or nan.
 */
double armtol_grade_width(int grade, double size);

/*
 * The widest grade that a tolerance holds.
 *
 * Given:
 *    size        nominal size in mm, of either sign
 *    tolerance   to either side, mm; infinity for one without a bound
 * Returned (function value):
 *    the largest number from 5 to 12 whose grade has half its width within the tolerance; ARMTOL_GRADE_FINER where not
 *    even IT5 has; ARMTOL_GRADE_WIDER where IT13, which is ten times IT8, has; ARMTOL_GRADE_NONE where the size has
 *    none or the tolerance is nan.
 */
int armtol_grade_within(double size, double tolerance);

/* On which side of the nominal size the width lies. */
typedef enum armtol_zone {
    ARMTOL_ZONE_EVEN,  /* half of it to either side: IT, JS, js */
    ARMTOL_ZONE_ABOVE, /* a hole, H */
    ARMTOL_ZONE_BELOW, /* a shaft, h */
    ARMTOL_ZONE_COUNT  /* the number of the above, itself none */
} armtol_zone;

/* A grade as a drawing names it. */
typedef struct armtol_grade {
    int grade; /* 5 to 12 */
    armtol_zone zone;
} armtol_grade;

/*
 * What a name means.
 *
 * Given:
 *    name   IT, H, h, JS or js, and behind it a number from 5 to 12: "IT6", "H7", "h6", "js12"
 * Returned:
 *    grade
 * Errors (function value):
 *    ARMTOL_BAD_GRADE   another name; grade is as it was. The text of this status says which names are known.
 * Note:
 *    The other letters of ISO 286 have deviations of their own, which are not in this library.
 */
armtol_status armtol_grade_read(const char *name, armtol_grade *grade);

/*
 * How far a size may be off.
 *
 * Given:
 *    grade   as armtol_grade_read gives it
 *    size    nominal size in mm, above 0 to 500
 * Returned (function value):
 *    the limits of the deviation in mm, low <= 0 <= high; both nan where the size has no grade or the zone is none.
 * Note:
 *    Of JS and js half of the width is exactly half. ISO 286-1 lets those of IT7 to IT11 be rounded down to whole
 *    micrometres.
 */
armtol_range armtol_grade_limits(const armtol_grade *grade, double size);

/* Classes of ISO 2768-1: what holds where a drawing says no tolerance. The finer first. */
typedef enum armtol_general {
    ARMTOL_GENERAL_FINE,
    ARMTOL_GENERAL_MEDIUM,
    ARMTOL_GENERAL_COUNT /* the number of the above, itself none */
} armtol_general;

/* "f" or "m", "" for what is none. */
const char *armtol_general_name(armtol_general of);

/*
 * The permissible deviation of a length.
 *
 * Given:
 *    of     the class
 *    size   nominal size in mm, of either sign
 * Returned (function value):
 *    to either side, mm; nan where the table has none: below 0.5 mm, above 4000 mm and, for f, above 2000 mm; of a size
 *    or class that is none.
 */
double armtol_general_length(armtol_general of, double size);

/*
 * The coarser class that a tolerance of a length holds.
 *
 * Given:
 *    size        nominal size in mm, of either sign
 *    tolerance   to either side, mm
 * Returned (function value):
 *    the class; ARMTOL_GENERAL_COUNT where neither f nor m does.
 */
armtol_general armtol_general_within(double size, double tolerance);

/*
 * The permissible deviation of an angle, the same for f and m.
 *
 * Given:
 *    side   length of the shorter side of the angle, mm, above 0
 * Returned (function value):
 *    to either side, radians: 1 degree up to 10 mm, then 30', 20', 10' and, above 400 mm, 5'; nan for a side that is
 *    not above 0.
 */
double armtol_general_angle(double side);

/*
 * How long the shorter side has to be for a tolerance of an angle to hold f and m.
 *
 * Given:
 *    tolerance   to either side, radians
 * Returned (function value):
 *    the length, mm, that the side has to be above: 0, 10, 50, 120 or 400; infinity where no side is long enough, and
 *    for nan.
 */
double armtol_general_side(double tolerance);

ARMTOL_INTERFACE_END

#endif
