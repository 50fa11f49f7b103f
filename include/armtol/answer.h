#ifndef ARMTOL_ANSWER_H
#define ARMTOL_ANSWER_H

#include "armtol/bounds.h"
#include "armtol/error_matrix.h"
#include "armtol/interface.h"
#include "armtol/question.h"
#include "armtol/transform.h"

#include <stdbool.h>

ARMTOL_INTERFACE_BEGIN

/* What whoever makes a link, and its joint, has to keep to. nan where there is nothing to keep to. */
typedef struct armtol_part {
    double distance; /* between the axes of the link, Eq. (4.32); note 1 */
    double angle;    /* the smallest of the link's angles that no motor moves, Eq. (4.33) */
    double motor;    /* the joint's */
    double drive;    /* how far the drive of the joint is off: backlash and compliance, Eqs (4.20), (4.34) */
} armtol_part;

/* One component of the tool's error, the largest of all poses. Magnitudes; infinite where nothing bounds them. */
typedef struct armtol_predicted {
    double worst;      /* |A s| + sum over |A| t, s what the parameters are shifted by: loads, means */
    double shift;      /* |A s|: the mean of the error */
    double deviation;  /* the standard deviation about it, errors being spread as the question says */
    double remainder;  /* what the exact error can differ from A's by (armtol_remainder), rounding included */
    double binds;      /* the share of the optimum that this component's limit holds down, over all poses */
    size_t worst_pose; /* where `worst` is largest, the first of several */
    size_t deviation_pose; /* likewise where `deviation` is */
    size_t binds_pose;     /* where `binds` is largest; 0 where it is 0 */
    double rounding;       /* what of the remainder is rounding (armtol_rounding) */
} armtol_predicted;

/*
 * A norm of the tool's error. worst, shift, remainder and rounding are norms; the deviation is that of the direction
 * that has the largest (armtol_rss_norm), and deviation_pose is where `spread` is largest.
 */
typedef struct armtol_predicted_norm {
    unsigned components;
    double limit;            /* infinity where none is asked for */
    armtol_predicted of;
    double spread;           /* the largest |u'A s| + sigma deviations along a unit vector u; sigma is the question's */
    double worst_direction[6];  /* the unit vector along which it is `of.worst` in of.worst_pose (armtol_worst_norm) */
    double spread_direction[6]; /* likewise `spread` in of.deviation_pose */
} armtol_predicted_norm;

/* A direction in which a norm's limit holds the optimum down. Those of a pose and a norm are apart by 1e-4 or more. */
typedef struct armtol_held_direction {
    size_t norm, pose;   /* the pose counted as of the answer */
    double direction[6]; /* a unit vector u, of either sign */
    double share;        /* of the optimum, > 0: what the limit along u holds, as a row's multiplier in optimum.h */
} armtol_held_direction;

/*
 * An answer, whole in itself: it needs nothing of the question any more, so that armtol_budget_create and armtol_verify
 * need it alone. To be read, not to be changed.
 */
typedef struct armtol_answer {
    size_t n_links, n_joints, n_columns;
    size_t n_loads; /* load cases: 1 or more */
    size_t n_poses; /* the question's times n_loads: each pose in each load, the loads of a pose one behind the other */
    armtol_tool_point tool;
    armtol_method method;   /* the question's, also where tolerances were given */
    double sigma;           /* the question's */
    double accuracy[6];     /* infinity where none is asked for */
    size_t n_norms;
    armtol_predicted_norm norms[ARMTOL_MOST_NORMS]; /* n_norms, the question's */
    armtol_column *columns; /* n_columns: what they stand for */
    armtol_link *links;     /* n_poses x n_links, placed */
    double *matrices;       /* n_poses x 6 x n_columns: A of every pose, one below the other (tool_matrix.h), cleared */

    double *tolerances; /* n_columns; infinity for a parameter that no bounded component sees; of a motor whose drive is
                           known the largest of all poses and loads */
    double *bounded;    /* n_poses x n_columns: the same, pose by pose, with 0 for infinity: what is not bounded counts
                           as exact */
    double *shifts;     /* n_poses x n_columns: what the parameters are shifted by: motors by drives, and all by the
                           means that the question says */
    armtol_error_spread *spreads; /* n_columns: the question's, or zeros */
    double *factors;    /* n_columns: sqrt 3 times the standard deviation for a tolerance of 1: 1 of a uniform error */
    size_t *leaders;    /* n_columns: the first column of the same group; its own number for one by itself */
    double *moments;    /* n_poses x n_links: N m about the joints, N along those that slide */
    armtol_drive_arrival *arrivals; /* n_poses x n_links: the part of the half widths that is drawn at each arrival; 0
                                       where a drive is not known, or apart */
    double *droops;     /* n_poses x 6: where that takes the tool, by the exact kinematics (tool_error.h) */
    double *remainders; /* n_poses x 6: what the exact error can differ from A's by */
    bool *given;        /* n_columns: a drive or the question gave the tolerance, with or without an accuracy */
    bool *discs;        /* n_columns, the question's */
    double *held;       /* n_columns: the share of the optimum that the column's largest, or (negative) least, holds */
    size_t n_held;      /* the shares of norms, direction by direction; they sum up to what `binds` of the norms does */
    armtol_held_direction *held_directions; /* n_held, the largest share first */
    bool loaded;        /* some shift by a drive is not 0 */
    bool shifted;       /* some shift is not 0 */
    bool grouped;       /* some column has another leader than itself */
    armtol_part *parts; /* n_links */
    armtol_predicted components[6];
    armtol_bounds bounds; /* ARMTOL_METHOD_SPHERE, tolerances asked for: the two radii; else 0 */
    double delta;         /* likewise; else nan */
} armtol_answer;

/*
 * Answer a question: place the arm, find the tolerances or take those given, and say what follows from them.
 *
 * Given:
 *    question   see question.h; NULL is not allowed
 *
 * Returned:
 *    *answer    the answer, to be freed with armtol_answer_destroy; NULL after an error
 *    *fault     what the status is about; may be NULL. After ARMTOL_OK about nothing
 *
 * Notes:
 * 1) Parts. By method sphere, tolerances asked for, they are as the report has them: the distance of Eq. (4.32) for a
 *    and d both off by the share, whether the link counts them or not, and that distance for the motor of a prismatic
 *    joint, both the least of all poses. Else a parameter that the link does not count is exact, and the motor has the
 *    tolerance of the parameter it moves; parallel axes (ppr, ppp) are |a| apart, so that theirs is the tolerance of a;
 *    a prismatic joint has no distance.
 * 2) Delta that is to be chosen is armtol_sphere_delta's, its lever the length of the arm when it is stretched: the sum
 *    of sqrt(a^2 + d^2), the largest of all poses, and the tool's offset; 1 for an arm without any length.
 * 3) With drives. A drive that the arm names (armtol_drive_is_known) gives its motor: in every pose and load the moment
 *    of its joint (armtol_moments; where the arm has no masses, what is held and the force, and the drive's own
 *    `moment` to either side of that) and Eq. (4.20) (armtol_drive_offset_under) make a shift and a half width of it.
 *    The half width is the motor's tolerance there; one that the question gives counts instead where it is larger. The
 *    optimum is that of
 *        |A| t <= e - |A s| - |A| t_given   in every component, pose and load, least <= t <= largest,
 *    or with ARMTOL_METHOD_RSS of sigma sqrt(sum v (A t)^2) <= e - |A s|, v the variance for a tolerance of 1, 1/3 of
 *    an error that is uniform. It is exact to first order, s included: the
 *    remainder is that of a box about the arm as meant which holds all that drives and tolerances can do together, of
 *    half widths |s| + t.
 * 4) By method sphere what is given takes its part from the accuracy in the same way, the most of all poses and loads;
 *    the bounds are those of the other columns, of which none may have a range.
 * 5) Where nothing is left for what is asked the status is ARMTOL_NOTHING_LEFT. The same question with given
 *    tolerances, 0 for those, tells the sources apart (armtol_budget_create).
 * 6) Norms. The optimum is that of |u'A s| + |u'A| t <= limit for every unit vector u of the norm's components as well,
 *    or with ARMTOL_METHOD_RSS of |u'A s| + sigma sqrt(sum v (u'A t)^2) <= limit: sigma standard deviations of every
 *    direction. It is found by cuts (cuts.c): to 1e-10 of the limit, and never beyond it. By method sphere there
 *    are no norms; given tolerances are held against them by any.
 * 7) Discs. Alpha and beta of a disc are off by no more than its radius together: with g that radius, they are good for
 *    g sqrt(A_alpha^2 + A_beta^2) in the worst case of a row, and for g^2 / 4 each in a variance; a tolerance t of its
 *    own is for |A| t and t^2 / 3. The worst case of a norm with discs is no less than the truth, and nearly
 *    always to 1e-12 of it (farthest_round.c). The remainder is that of the square about the disc.
 * 8) Spreads. The mean of an error is a shift like those of drives, and |A t| counts about it, so that worst cases know
 *    nothing of distributions. Deviations have the true variances. Errors of a group are one: v (sum A t)^2 with the
 *    signs of A is the part of the whole. By method rss no tolerances are found for them, since such a sum may be 0.
 * 9) The same question has the same answer to the bit on every machine with IEEE arithmetic.
 * 10) Questions may be answered on several threads at once. Memory comes from calloc and realloc; no other state is
 *    kept.
 *
 * Errors:
 *    ARMTOL_NO_MEMORY
 *    ARMTOL_BAD_QUESTION    about the question: no arm, no joint values for an arm with joints, no pose, or neither an
 *                           accuracy nor tolerances; about the method: a value that is none, or with ARMTOL_METHOD_RSS
 *                           a sigma that is not > 0 and finite
 *    ARMTOL_NO_LINKS, ARMTOL_BAD_KIND, ARMTOL_BAD_JOINT, ARMTOL_NOT_FINITE  about the arm
 *    ARMTOL_NOT_FINITE      about a pose: a joint value that is not, or A overflows (an offset that is not finite too)
 *    ARMTOL_BAD_TOLERANCE   about the accuracy: a component that is not > 0; about tolerances: one that is not >= 0
 *    ARMTOL_BAD_TOLERANCE   about discs: a column that is no alpha with a beta behind it, or whose two tolerances are
 *                           not given, finite and the same
 *    ARMTOL_BAD_WEIGHT      about the weights: one that is not > 0 and finite
 *    ARMTOL_BAD_RANGE       about the ranges: not 0 <= least <= largest, the least finite; about the method: a range
 *                           that is not one value, by method sphere; a least that is not 0 where tolerances are given
 *    ARMTOL_BAD_SPREAD      about the spreads: one that is not known (armtol_spread_is_known), or unlike the first of
 *                           its group, or in a disc and not uniform by itself; by method rss a
 *                           column that has its group in common with others, and a tolerance that is asked for
 *    ARMTOL_BAD_LOAD        about the loading: a mass < 0, a share that is not 0 to 1; about the drives: a number < 0,
 *                           or compliance where neither masses nor loads nor `moment` say what it bears
 *    ARMTOL_NOTHING_LEFT    about a row, or a norm's place
 *    ARMTOL_BAD_TOLERANCE, ARMTOL_BAD_NORM  about a norm: its limit is not > 0; its components are none, or it is one
 *                                           too many;
 *                           about the method: norms by method sphere, tolerances asked for
 *    ARMTOL_BAD_DELTA, ARMTOL_NOT_FINITE, ARMTOL_NOT_SOLVED  about the method: no tolerances (optimum.h, sphere.h)
 *
 * Reference:
 *    Hahn 1987, sections 4.1 to 4.4 (A, the bounds, Eqs 4.32 to 4.34); the optimum is ours.
 */
armtol_status armtol_answer_create(const armtol_question *question, armtol_answer **answer, armtol_fault *fault);

/* answer may be NULL. */
void armtol_answer_destroy(armtol_answer *answer);

/* Of one pose and load, from 0: its placed links; A; what the parameters can be off by, about which shifts. */
const armtol_link *armtol_answer_links(const armtol_answer *answer, size_t pose);
const double *armtol_answer_matrix(const armtol_answer *answer, size_t pose);
const double *armtol_answer_bounded(const armtol_answer *answer, size_t pose);
const double *armtol_answer_shifts(const armtol_answer *answer, size_t pose);

/* row x shifts: what the component is off by to first order before any tolerance. */
double armtol_answer_shift(const armtol_answer *answer, size_t pose, size_t component);

/* Where the tool point should be in that pose, in the base's coordinates. */
void armtol_answer_tool(const armtol_answer *answer, size_t pose, double point[3]);

/* The tool there: the last frame's orientation, at the tool point. */
void armtol_answer_frame(const armtol_answer *answer, size_t pose, armtol_transform *frame);

ARMTOL_INTERFACE_END

#endif
