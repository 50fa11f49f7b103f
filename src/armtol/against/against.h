#ifndef ARMTOL_AGAINST_AGAINST_H
#define ARMTOL_AGAINST_AGAINST_H

#include "armtol/ask/request.h"
#include "armtol/comparison.h"

#include <stdbool.h>

/* The arm that was asked about, and the other that it is held against, in inside units. */
typedef struct against {
    const request *request;
    const char *other; /* the file, or the arm's name, as typed */
    arm_model model;   /* of the other */
    armtol_difference *differences;
    size_t n_differences;
    armtol_link *work;
    double *explained; /* 6 a difference, of the pose that was asked last */
} against;

/* A distance and an angle: the lengths of the upper half of an error and of its lower half. */
typedef struct against_size {
    double size[2];
} against_size;

/* What one difference does in all poses. */
typedef struct against_share {
    size_t difference;  /* its number */
    double largest[2];  /* by itself, in any pose */
    double share[2];    /* of the squared error, all poses together; nan where there is none */
} against_share;

typedef struct against_summary {
    double mean[2], largest[2];
    size_t worst[2];       /* the pose of the largest, from 0 */
    against_share *shares; /* n_differences, the one that explains most of the distance first */
    double together[2];    /* what no difference explains by itself */
} against_summary;

/* Whether the command line asks for it. */
bool against_is_asked(const cli_options *options);

/* What is asked of two arms, answered and printed. An exit code, after a message. */
int against_run(const request *request, const arm_model *model);

/* The exact error in a pose; *explained is then that pose's. */
void against_pose(against *against, size_t pose, double error[6]);

against_size against_size_of(const double error[6]);

/* From all poses. False after a message; the shares are to be freed. */
bool against_summarise(against *against, against_summary *summary);

/* On standard output. False after a message. */
bool against_text(against *against, const against_summary *summary);
void against_json(against *against, const against_summary *summary);

#endif
