#ifndef ARMTOL_ASK_REQUEST_H
#define ARMTOL_ASK_REQUEST_H

#include "armtol/answer.h"
#include "armtol/ask/at.h"
#include "armtol/ask/options.h"
#include "armtol/ask/units.h"
#include "armtol/drawing/drawing_file.h"
#include "armtol/lists/lists.h"
#include "armtol/tables/arm_model.h"

/* What is asked, in inside units: the command line and its files, read in the light of the arm. */
typedef struct request {
    const cli_options *options;
    units units;
    const arm_laying *laying; /* how the arm's frames were laid */
    armtol_question question;
    double accuracy[6];               /* the question's, as are these: */
    armtol_norm norms[ARMTOL_MOST_NORMS];
    bool as_ap;                       /* the norm of dx, dy and dz was asked for as ap */
    double repeatability;             /* rp; 0 where it is not asked for */
    bool repeatability_alone;         /* and nothing else, nor are tolerances given: those are free */
    double *q, *weights, *tolerances; /* tolerances NULL where they are asked for */
    double *least, *largest;
    double *means;                    /* of errors from a lower to an upper end; part of spreads */
    drawing drawing;    /* of --drawing, in inside units; no rows without */
    bool *drawn;        /* a column of A: what it says something of */
    bool *discs;        /* the question's */
    armtol_error_spread *spreads; /* the question's where something is said of any, else zeros */
    group_name *groups;           /* the names of their groups, by number from 1 */
    at_taken *taken;                  /* of each pose, where its position was asked for; else NULL */
    armtol_arm arm;       /* the model's, with drives of its own: */
    armtol_drive *drives;
    armtol_loading loading;
    armtol_mass payloads[MOST_PAYLOADS];
    armtol_column *columns;           /* of A */
    size_t n_columns;
} request;

/*
 * Where the command line has no pose the question has none. EXIT_OK, or an exit code after a message; nothing is then
 * to be freed. The request stays where it is.
 */
int request_make(request *request, const cli_options *options, const arm_model *model);
void request_free(request *request);

/* Whether a joint's value is within its limits, to their rounding. */
bool request_within_limits(const armtol_drive *drive, double value);

/* The tool point that is meant; false after a message. */
bool request_tool(const cli_options *options, const units *units, armtol_tool_point *tool);

/*
 * A file of the values of parameters, in the user's units; the table says which, and may leave out what the request
 * knows. What may be 0 may be infinite too. False after a message: `before` the path, and why.
 */
bool request_read_parameters(const request *request, const char *before, const char *path, parameter_table table,
                             double values[]);

/* The engine's answer, to be destroyed. EXIT_OK, or an exit code after a message. */
int request_answer(const request *request, armtol_answer **answer);

/*
 * The message of what the engine could not do, and an exit code: what has no tolerances, a delta too large say, is
 * wrong input; that none are found is not.
 */
int request_failed(const request *request, const armtol_fault *fault);

#endif
