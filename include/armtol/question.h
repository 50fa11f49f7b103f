#ifndef ARMTOL_QUESTION_H
#define ARMTOL_QUESTION_H

#include "armtol/arm.h"
#include "armtol/interface.h"
#include "armtol/norm.h"
#include "armtol/spread.h"
#include "armtol/status.h"
#include "armtol/tool_point.h"

#include <stdbool.h>
#include <stddef.h>

ARMTOL_INTERFACE_BEGIN

/* The way from an accuracy to tolerances. */
typedef enum armtol_method {
    ARMTOL_METHOD_WORST,  /* the largest that guarantee the accuracy (optimum.h) */
    ARMTOL_METHOD_RSS,    /* the largest with which sigma standard deviations keep to it */
    ARMTOL_METHOD_SPHERE, /* the report's bounds, shared out evenly (sphere.h) */
    ARMTOL_METHOD_COUNT
} armtol_method;

/* "worst", "rss", "sphere"; "?" for a value that is none. */
const char *armtol_method_name(armtol_method method);

/*
 * What the engine is asked. A member that is 0 or NULL has the meaning said here, and what later versions add means
 * nothing where it is 0: set a question up with an initialiser that names its members. Everything is the caller's, is
 * only read, and has to stay until armtol_answer_create returns, no longer.
 *
 * Either an accuracy is given, of components or norms, and tolerances are asked for, or tolerances are given and what
 * they do is asked for; an accuracy beside given tolerances is what they are held against.
 */
typedef struct armtol_question {
    const armtol_arm *arm;    /* not NULL */
    const double *q;          /* n_poses x armtol_arm_joint_count, radians or lengths; NULL for an arm without joints */
    size_t n_poses;           /* at least one; what is asked is asked of all of them at once */
    armtol_tool_point tool;   /* 0: the origin of the last frame, counted along the base's axes */
    const double *accuracy;   /* dx, dy, dz, wx, wy, wz, each > 0, infinity for a free one; NULL: none asked for */
    const armtol_norm *norms; /* n_norms of them, beside the components: all hold; NULL where there are none */
    size_t n_norms;           /* ARMTOL_MOST_NORMS at most */
    armtol_method method;     /* 0: worst */
    double sigma;             /* of ARMTOL_METHOD_RSS, > 0 */
    double delta;             /* of ARMTOL_METHOD_SPHERE: the lengths' share; 0: to be chosen (armtol_sphere_delta) */
    const double *weights;    /* a column of A, each > 0 (optimum.h); NULL: 1 each */
    const double *tolerances; /* a column of A, each >= 0, infinity for what has no bound; NULL: asked for */
    const double *least;      /* a column of A, each >= 0 and finite: no tolerance is found below it; NULL: 0 each */
    const double *largest;    /* a column of A, each >= the least: none is found above it; NULL: infinity each. Where
                                 both are the same the tolerance is given: 0 is exact */
    const armtol_error_spread *spreads; /* a column of A: how its error is distributed about what mean (spread.h); NULL:
                                     uniform about 0 each. Worst cases know of it the shifts alone */
    const armtol_loading *loading; /* NULL: armtol_loading_standard */
    bool drives_apart; /* the drives that the arm names, and what loads them, are in no error; else they are: note 3 of
                          answer.h */
    const bool *discs; /* a column of A: this alpha moves with the beta behind it in a disc, whose radius is their
                          tolerance: given, and the same; NULL: none do. Note 7 of answer.h */
} armtol_question;

/* What a failure is about, and the number that armtol_fault has of it. */
typedef enum armtol_subject {
    ARMTOL_ABOUT_NOTHING,    /* nothing of the question's: memory */
    ARMTOL_ABOUT_QUESTION,   /* the question as a whole */
    ARMTOL_ABOUT_ARM,        /* its links, or the tool's offset */
    ARMTOL_ABOUT_POSE,       /* the pose's number, from 0 */
    ARMTOL_ABOUT_ACCURACY,   /* the component's, 0 to 5 */
    ARMTOL_ABOUT_NORM,       /* the norm's */
    ARMTOL_ABOUT_METHOD,     /* sigma, delta, or that there are no tolerances by this method */
    ARMTOL_ABOUT_WEIGHTS,    /* the column's */
    ARMTOL_ABOUT_TOLERANCES, /* the column's */
    ARMTOL_ABOUT_RANGES,     /* the column's: least and largest */
    ARMTOL_ABOUT_SPREADS,    /* the column's */
    ARMTOL_ABOUT_DRIVES,     /* the link's */
    ARMTOL_ABOUT_LOADING,    /* gravity, force, share; or a payload */
    ARMTOL_ABOUT_ROW,        /* the row of A: 6 for each pose and load of the answer */
    ARMTOL_ABOUT_NORM_PLACE, /* the norm in a pose and load: n_norms for each of them */
    ARMTOL_ABOUT_DISCS,      /* the column's */
    ARMTOL_SUBJECT_COUNT
} armtol_subject;

/* Where a question failed. */
typedef struct armtol_fault {
    armtol_status status;
    armtol_subject about;
    size_t number; /* 0 where the subject has none */
} armtol_fault;

/* "dx", "dy", "dz", "wx", "wy", "wz": the components of the tool's error; "?" for a number beyond. */
const char *armtol_component_name(size_t component);

ARMTOL_INTERFACE_END

#endif
