#ifndef ARMTOL_ARM_H
#define ARMTOL_ARM_H

#include "armtol/interface.h"
#include "armtol/link.h"

#include <stddef.h>

ARMTOL_INTERFACE_BEGIN

typedef enum armtol_length_unit {
    ARMTOL_MILLIMETRE,
    ARMTOL_METRE,
    ARMTOL_LENGTH_UNIT_COUNT
} armtol_length_unit;

/* "mm", "m"; "?" for a value that is none. */
const char *armtol_length_unit_name(armtol_length_unit unit);

/* What is known of a joint beyond its place in the chain. Radians, or lengths for a prismatic joint. */
typedef struct armtol_drive {
    double low, high;  /* the least and the largest joint value; -infinity and infinity where not known */
    double backlash;   /* how far the joint moves while its motor stands; nan where not known */
    double compliance; /* how far it gives way to a unit of moment (or force, if prismatic); 0 if stiff */
    double moment;     /* the largest moment that it bears, in any unit that fits that of compliance */
} armtol_drive;

/* A drive of which nothing is known: no limits, backlash nan; compliance and moment are 0. */
extern const armtol_drive armtol_drive_unknown;

/*
 * How far a drive lets its joint be off: backlash + compliance moment. nan where the backlash is not known.
 * Source: Hahn 1987, Eqs (4.20) and (4.34).
 */
double armtol_drive_error(const armtol_drive *drive);

/* An arm: the table of its links, and what goes with it. */
typedef struct armtol_arm {
    const char *name;   /* one word, as typed: puma560 */
    const char *title;  /* as people say it */
    const char *source; /* where the numbers are from */
    armtol_length_unit unit;
    size_t n_links;
    const armtol_link *links;   /* n_links, at joint values 0 */
    const armtol_drive *drives; /* n_links, a link's own; those of fixed links mean nothing */
} armtol_arm;

/*
 * The built-in arms: index 0 to armtol_arm_count() - 1, NULL beyond; and by name, NULL where none has it. All
 * are in millimetres. Those of 1987 have the corrected tables of robots.h. docs/arms.md says where the
 * numbers are from.
 */
size_t armtol_arm_count(void);
const armtol_arm *armtol_arm_at(size_t index);
const armtol_arm *armtol_arm_named(const char *name);

ARMTOL_INTERFACE_END

#endif
