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

enum { MOST_CHOICES = 16, MOST_OPTIONS = 6, MOST_JOINTS = 6, MOST_WISH = 6 };

typedef struct choice {
    const char *name, *subject;
    struct {
        const char *name, *meaning;
    } options[MOST_OPTIONS];
} choice;

typedef struct configuration {
    unsigned char option[MOST_CHOICES];
} configuration;

typedef struct family {
    const char *program; /* of 1987 */
    const armtol_robot *robot;
    const choice *choices;
    size_t n_choices;

    /* Joint values, done as a configuration says; nan where there are none. */
    void (*solve)(const configuration *how, const double wish[], double q[]);

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

/* Add "choice=option" to a restriction. False where the family has no such option. */
bool family_restrict(const family *family, const char *text, restriction *given);

/*
 * Whether the configuration is one to try: it makes sense, no choice that matters in it has another option than is
 * given, and a choice that does not matter is at option 0, so that what is the same counts once.
 */
bool family_allows(const family *family, const restriction *given, const configuration *configuration);

/* The configuration behind this one, to try or not, the last choice changing fastest; false behind the last. */
bool family_next(const family *family, configuration *configuration);

/* The number of choices in which it is not the default. */
size_t family_changes(const family *family, const configuration *configuration);

/* ---- for the steps ---- */

#define HEADER_PI 3.14159 /* the macro of both robots' headers */

/* The value as a float keeps it: every variable and array of the listing is one. */
double stored(double value);

/*
 * The value as the option of its choice keeps it: stored by one that is called "float", unchanged by one that is
 * called "double", which leaves it a part of a longer expression.
 */
double kept(const choice *choices, const configuration *how, size_t choice, double value);

/*
 * A joint value as %.6f prints it, in millionths. Exact for a float, whose product with 10^6 a double holds;
 * of another double a tie may go the wrong way.
 */
double printed_of(double q);

#endif
