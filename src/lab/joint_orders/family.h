#ifndef ARMTOL_LAB_JOINT_ORDERS_FAMILY_H
#define ARMTOL_LAB_JOINT_ORDERS_FAMILY_H

#include "armtol/robots.h"

#include <stdbool.h>
#include <stddef.h>

/*
 * A family of ways in which the inverse kinematics of an arm may have been written: a table of choices, each
 * with its options. A configuration is one option of each choice; option 0 of all is what the library does.
 *
 * A choice is what the listing of 1987 leaves open: the steps inside of `invintell` and `invadept`, the two routines
 * that it does not print. What it prints is the same in every configuration: expressions are in double; variables,
 * arrays, the desired position and the joint values are floats; matrices are made by eulerzyx and transf, inverted by
 * invtrf, multiplied by mpynn; PI is 3.14159; tclose is 0.
 */

enum { MOST_CHOICES = 24, MOST_OPTIONS = 6, MOST_JOINTS = 6, MOST_WISH = 6 };

typedef struct choice_option {
    const char *name;
    const char *meaning;
} choice_option;

typedef struct choice {
    const char *name;
    const char *subject;
    size_t step; /* no earlier step looks at it */
    choice_option options[MOST_OPTIONS];
} choice;

typedef struct configuration {
    unsigned char option[MOST_CHOICES];
} configuration;

/* What the steps have found so far; what an arm has no use for is never set. */
typedef struct progress {
    double q[MOST_JOINTS];
    armtol_transform t06, t05;
    double q345, px, py; /* q3 + q4 + q5, the wrist in the plane of links 3 and 4 */
} progress;

/* One step of the way from a wish to joint values, done as a configuration says. */
typedef void (*step)(const configuration *how, const double wish[], progress *progress);

typedef struct family {
    const char *program; /* of 1987 */
    const armtol_robot *robot;
    const choice *choices;
    size_t n_choices;
    const step *steps;
    size_t n_steps;

    /* Whether that choice can make a difference in this configuration. */
    bool (*matters)(const configuration *how, size_t choice);

    /* Whether a programmer might have written it so at all; and what is left out, in words. NULL: always. */
    bool (*makes_sense)(const configuration *how);
    const char *left_out;
} family;

extern const family family_intelledex, family_adept;

enum { FAMILIES = 2 };
extern const family *const families[FAMILIES];

size_t choice_count(const choice *choice);

/* The configuration of the library. */
configuration family_default(void);

/* Options that some choices are to have. */
typedef struct restriction {
    bool restricted[MOST_CHOICES];
    unsigned char option[MOST_CHOICES];
} restriction;

/* Add "choice=option", so many characters, to a restriction. False where the family has no such option. */
bool family_restrict(const family *family, const char *text, size_t length, restriction *given);

/* Whether no choice that matters in the configuration has another option than is given. */
bool family_allows(const family *family, const restriction *given, const configuration *configuration);

/*
 * All configurations that make sense and are allowed, the last choice changing fastest: wants the one before,
 * the first time the default. Where a choice does not matter it is left at option 0, so that what is the same
 * counts once. False: there is none left.
 */
bool family_next(const family *family, const restriction *given, configuration *configuration);

/* The number of choices in which it is not the default. */
size_t family_changes(const family *family, const configuration *configuration);

/* Joint values; nan where there are none. */
void family_solve(const family *family, const configuration *how, const double wish[], double q[]);

/*
 * A joint value as %.6f prints it, in millionths. Exact for a float, whose product with 10^6 a double holds;
 * of another double a tie may go the wrong way.
 */
double printed_of(double q);

#endif
