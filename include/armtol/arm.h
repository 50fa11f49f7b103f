#ifndef ARMTOL_ARM_H
#define ARMTOL_ARM_H

#include "armtol/interface.h"
#include "armtol/link.h"
#include "armtol/loads.h"
#include "armtol/status.h"

#include <stdbool.h>
#include <stddef.h>

ARMTOL_INTERFACE_BEGIN

typedef enum armtol_length_unit {
    ARMTOL_MILLIMETRE,
    ARMTOL_METRE,
    ARMTOL_INCH, /* 25.4 mm */
    ARMTOL_LENGTH_UNIT_COUNT
} armtol_length_unit;

/* "mm", "m", "in"; "?" for a value that is none. */
const char *armtol_length_unit_name(armtol_length_unit unit);

/*
 * What is known of a joint beyond its place in the chain. Radians, or lengths for a prismatic joint; N m, or N for a
 * prismatic joint.
 */
typedef struct armtol_drive {
    double low, high;  /* the least and the largest joint value; -infinity and infinity where not known */
    double backlash;   /* how far the joint moves while its motor stands, from end to end; nan where not known */
    double compliance; /* how far it gives way to a N m (or N, if prismatic); 0 if stiff */
    double moment;     /* the largest moment that it bears, where the masses of the arm's links are not known */
    double resolution; /* the step of the encoder at the joint */
    double friction;   /* the moment that it takes to move the joint through its play */
    double noise;      /* the standard deviation of where the joint comes to rest, arrival by arrival */
} armtol_drive;

/* A drive of which nothing is known: no limits, backlash nan; all else is 0. */
extern const armtol_drive armtol_drive_unknown;

/* Whether anything is known of how far it lets its joint be off: backlash, compliance, resolution or noise. */
bool armtol_drive_is_known(const armtol_drive *drive);

/*
 * How far a drive lets its joint be off: backlash + compliance moment, nan where the backlash is not known.
 *
 * Reference:
 *    Hahn 1987, Eqs (4.33) and (4.34).
 */
double armtol_drive_error(const armtol_drive *drive);

/* Where a drive holds its joint: off by `shift`, give or take `half`. */
typedef struct armtol_drive_offset {
    double shift, half;
} armtol_drive_offset;

/*
 * Where a drive holds its joint under a moment.
 *
 * Given:
 *    drive         what is known of it
 *    moment        N m, or N for a prismatic joint
 *    doubt         what the moment can be off to either side, >= 0
 *    compensated   the share of what compliance gives way by that is taken back, 0 to 1
 *
 * Returned (function value):
 *    where the joint is, less where it should be: a shift, and what may come to it on either side
 *
 * Notes:
 * 1) Compliance gives way to the moment: compliance moment, less the share `compensated` of it, is a shift, and
 *    compliance doubt goes to either side.
 * 2) The whole play counts, as in the equation: nothing says at which of its ends the joint was when its zero was set.
 *    It lies on the side of the moment. Where the moment may be 0, or less than the friction, it may lie on either
 *    side. A backlash that is not known counts as 0.
 * 3) The encoder adds half a step to either side.
 * 4) Noise is normal, and has no largest value: ARMTOL_NOISE_SIGMAS standard deviations of it count to either side. An
 *    arrival is farther off than that 27 times in 10000.
 *
 * Reference:
 *    Hahn 1987, Eq. (4.20); note 3 is the term for sensors that stands below it; noise is ours.
 */
armtol_drive_offset armtol_drive_offset_under(const armtol_drive *drive, double moment, double doubt,
                                              double compensated);

enum { ARMTOL_NOISE_SIGMAS = 3 };

/* What a drive is off by otherwise at each arrival, about a middle that does not change. */
typedef struct armtol_drive_arrival {
    double play;  /* to either side, evenly: half the play where nothing holds the joint at an end of it, else 0 */
    double step;  /* to either side, evenly: half a step of the encoder */
    double noise; /* the standard deviation of a normal distribution */
} armtol_drive_arrival;

/*
 * The part of armtol_drive_offset_under's half width that is drawn anew at each arrival: play + step +
 * ARMTOL_NOISE_SIGMAS noise. What else is in it stays, arrival after arrival: what compliance makes of a moment in
 * doubt, and the half of a free play by which the middle of the play may be off, since nothing says where its zero was
 * set.
 *
 * Given:
 *    as of armtol_drive_offset_under
 */
armtol_drive_arrival armtol_drive_arrival_under(const armtol_drive *drive, double moment, double doubt);

/* That part: play + step + ARMTOL_NOISE_SIGMAS noise. */
double armtol_drive_arrival_half(const armtol_drive_arrival *arrival);

/*
 * How the joint of a link moves when it is not simply moved by a motor of its own. The value of the joint is
 *
 *     value = multiplier q + offset
 *
 * with q the value that is asked of the joint of link `follows`; where that is the link itself, value = q, and
 * multiplier and offset are not looked at. sign * value is added to theta or d.
 *
 * Each link keeps its own parameters' errors, a follower too: theta of two links that one motor turns are two
 * parameters. What is guaranteed for errors that are independent of each other holds for those of one motor too: it may
 * be off by the smaller one of the leader's tolerance and the follower's divided by |multiplier|.
 */
typedef struct armtol_motion {
    size_t follows; /* a link whose joint follows none */
    double multiplier, offset;
    double sign; /* 1 or -1 */
} armtol_motion;

/* An arm: the table of its links, and what goes with it. */
typedef struct armtol_arm {
    const char *name;   /* one word, as typed: puma560 */
    const char *title;  /* as people say it */
    const char *source; /* where the numbers are from */
    armtol_length_unit unit;
    size_t n_links;
    const armtol_link *links;   /* n_links, at joint values 0 */
    const armtol_drive *drives; /* n_links, a link's own; those of fixed links mean nothing */
    const armtol_mass *masses;  /* n_links; NULL where they are not known */
    const armtol_motion *motions; /* n_links, not of fixed links; NULL: each joint moves by itself, with sign 1 */
    const char *const *names; /* n_links, of the links and their joints, UTF-8; one, or all, NULL where it has none */
} armtol_arm;

/* Whether the link has a joint that moves by itself: one of those that have a value in q. */
bool armtol_arm_is_driven(const armtol_arm *arm, size_t link);

/* How many joints move by themselves. */
size_t armtol_arm_joint_count(const armtol_arm *arm);

/* How many of them come before a link: the place of its joint's value in q, if it is one of them. */
size_t armtol_arm_joint_of(const armtol_arm *arm, size_t link);

/* The link of the joint whose value is in that place of q; n_links where there are not so many. */
size_t armtol_arm_link_of(const armtol_arm *arm, size_t joint);

/*
 * The value of a link's joint, before its sign.
 *
 * Given:
 *    arm    as armtol_arm_check has it
 *    q      one value for each joint that moves by itself, in link order
 *    link   from 0
 *
 * Returned (function value):
 *    the value, of a link that follows another too; 0 for a fixed link
 */
double armtol_arm_joint_value(const armtol_arm *arm, const double q[], size_t link);

/*
 * Whether links and motions are fit for use.
 *
 * Errors:
 *    those of armtol_links_check
 *    ARMTOL_BAD_JOINT    a motion follows a link whose joint does not move by itself, or its sign is not 1 or -1
 *    ARMTOL_NOT_FINITE   a motion that is not
 */
armtol_status armtol_arm_check(const armtol_arm *arm);

/*
 * armtol_links_place for an arm whose joints need not all move by themselves.
 *
 * Given:
 *    arm           its table and, if it has any, its motions
 *    q, n_joints   one value for each joint that moves by itself, in link order
 *
 * Returned:
 *    placed        arm->n_links links
 *
 * Errors:
 *    those of armtol_arm_check
 *    ARMTOL_WRONG_SIZE   n_joints is not armtol_arm_joint_count
 *    ARMTOL_NOT_FINITE   a q that is not, or a value that overflows
 */
armtol_status armtol_arm_place(const armtol_arm *arm, const double q[], size_t n_joints, armtol_link placed[]);

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
