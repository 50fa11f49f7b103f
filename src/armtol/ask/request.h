#ifndef ARMTOL_ASK_REQUEST_H
#define ARMTOL_ASK_REQUEST_H

#include "armtol/ask/options.h"
#include "armtol/ask/units.h"
#include "armtol/engine/arm_model.h"
#include "armtol/engine/posed_arm.h"

#include <stdbool.h>

/* What is asked, in inside units: the command line and its files, read in the light of the arm. */
typedef struct request {
    const cli_options *options;
    units units;
    posed_arm posed;
    bool wished;        /* whether there is an accuracy */
    double accuracy[6]; /* infinity for a free component */
    double delta;       /* nan: to be chosen */
    double *weights;    /* n_columns */
    double *tolerances; /* n_columns, infinity for what does not matter; NULL where they are asked for */
} request;

/* EXIT_OK, or an exit code after a message; nothing is then to be freed. */
int request_make(request *request, const cli_options *options, const arm_model *model);
void request_free(request *request);

#endif
