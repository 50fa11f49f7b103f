#include "armtol/drawing/named.h"

#include "armtol/grades.h"
#include "console/number.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Letters and a number, as grades are written: what is neither a number nor this is no name. */
static bool looks_like_a_grade(const char *name)
{
    const size_t letters = strspn(name, "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz");
    const size_t digits = strspn(name + letters, "0123456789");
    return letters > 0 && digits > 0 && name[letters + digits] == '\0';
}

/* ARMTOL_GENERAL_COUNT for another word. */
static armtol_general general_named(const char *name)
{
    return strcmp(name, "2768-f") == 0   ? ARMTOL_GENERAL_FINE
           : strcmp(name, "2768-m") == 0 ? ARMTOL_GENERAL_MEDIUM
                                         : ARMTOL_GENERAL_COUNT;
}

/* nan, and why, where the value is. */
static double or_why(double value, const char *reason, const char **why)
{
    *why = isnan(value) ? reason : *why;
    return value;
}

double named_length(const char *name, double size, const char **why)
{
    const armtol_general general = general_named(name);
    armtol_grade grade;
    if (general != ARMTOL_GENERAL_COUNT) {
        return or_why(armtol_general_length(general, size), "is for lengths from 0.5 to 4000 mm (2768-f: 2000 mm)",
                      why);
    }
    if (!looks_like_a_grade(name) && strncmp(name, "2768", 4) != 0) {
        return (double)NAN;
    }
    if (armtol_grade_read(name, &grade) != ARMTOL_OK || grade.zone != ARMTOL_ZONE_EVEN) {
        return or_why((double)NAN,
                      "is no grade to both sides; expected IT, JS or js with a number from 5 to 12, 2768-f or 2768-m",
                      why);
    }
    return or_why(armtol_grade_limits(&grade, size).high, "is for lengths above 0, to 500 mm", why);
}

double named_angle(const char *name, double side, const char **why)
{
    return general_named(name) == ARMTOL_GENERAL_COUNT
               ? (double)NAN
               : or_why(armtol_general_angle(side), "needs the length of the shorter side, in a column side", why);
}

double named_position(const char *name, double unused, const char **why)
{
    char size_text[32];
    const size_t length = strspn(name, "0123456789.");
    double size = (double)NAN;
    armtol_grade grade;
    (void)unused;
    if (length == 0 || !looks_like_a_grade(name + length)) {
        return (double)NAN;
    }
    snprintf(size_text, sizeof size_text, "%.*s", (int)length, name);
    const bool fine = length < sizeof size_text && number_parse(size_text, &size) == NUMBER_FINE &&
                      armtol_grade_read(name + length, &grade) == ARMTOL_OK;
    return or_why(fine ? armtol_grade_width(grade.grade, size) : (double)NAN,
                  "is no grade with its size in mm; expected such as 40H7: a size to 500, IT, H, h, JS or js, 5 to 12",
                  why);
}
