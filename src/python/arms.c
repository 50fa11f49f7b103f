/* Arms that are read and written, and lists of names, by what armtol reads them with. */

#include "armtol/ask/arm_source.h"
#include "armtol/ask/given.h"
#include "armtol/ask/nothing_left.h"
#include "armtol/ask/weights.h"
#include "armtol/tables/arm_file.h"
#include "console/exit_code.h"
#include "python/binding.h"

#include <stdlib.h>
#include <string.h>

/* ---- arms ---- */

static int read_text(char *text, size_t length, const cli_options *options, arm_model *model)
{
    FILE *stream = fmemopen(text, length, "r");
    if (stream == NULL) {
        out_of_memory();
        return EXIT_FAILED;
    }
    const int code = arm_source_take(stream, options, model);
    fclose(stream);
    return code;
}

arm_model *binding_arm_read(const char *path, char *text, size_t length, const char *base, const char *tip, double snap,
                            bool as_is)
{
    const cli_options options = {.arm = path, .base = base, .tip = tip, .snap = snap, .as_is = as_is};
    arm_model *model = calloc(1, sizeof *model);
    if (model == NULL) {
        out_of_memory();
        return NULL;
    }
    const int code = text != NULL ? read_text(text, length, &options, model) : arm_source_read(&options, model);
    if (code != EXIT_OK) {
        free(model);
        return NULL;
    }
    return model;
}

void binding_arm_free(arm_model *model)
{
    if (model != NULL) {
        arm_model_free(model);
        free(model);
    }
}

char *binding_arm_table(const armtol_arm *arm, bool craig)
{
    char *text = NULL;
    size_t length = 0;
    FILE *stream = open_memstream(&text, &length);
    bool fine = stream != NULL && arm_file_write(arm, craig ? ORDER_CRAIG : ORDER_PAUL, UNIT_RADIAN, stream);
    fine = stream != NULL && fclose(stream) == 0 && fine;
    if (!fine) {
        free(text);
        out_of_memory();
        return NULL;
    }
    return text;
}

void binding_text_free(char *text)
{
    free(text);
}

/* ---- lists of names ---- */

static units units_of(const armtol_arm *arm)
{
    return (units){.arm = arm->unit, .length = arm->unit, .angle = UNIT_RADIAN};
}

/* What stands for the columns of A; to be freed. NULL after a message. */
static armtol_column *columns_of(const armtol_arm *arm, named_columns *of)
{
    const size_t n = armtol_column_count(arm->links, arm->n_links);
    armtol_column *columns = calloc(n, sizeof *columns);
    if (columns == NULL) {
        out_of_memory();
        return NULL;
    }
    armtol_columns(arm->links, arm->n_links, columns, n);
    *of = (named_columns){arm, columns, n};
    return columns;
}

bool binding_weights(const armtol_arm *arm, const char *text, double weights[])
{
    named_columns of;
    armtol_column *columns = columns_of(arm, &of);
    const bool fine = columns != NULL && weights_parse(text, arm, columns, of.n_columns, weights);
    free(columns);
    return fine;
}

bool binding_given(const armtol_arm *arm, const char *text, double least[], double largest[])
{
    named_columns of;
    const units units = units_of(arm);
    armtol_column *columns = columns_of(arm, &of);
    const bool fine = columns != NULL && given_parse(text, &of, &units, least, largest);
    free(columns);
    return fine;
}

bool binding_tolerances(const armtol_arm *arm, const char *text, double tolerances[])
{
    named_columns of;
    const units units = units_of(arm);
    armtol_column *columns = columns_of(arm, &of);
    const bool fine = columns != NULL && given_tolerances_parse(text, &of, &units, tolerances);
    free(columns);
    return fine;
}

bool binding_drives(const armtol_arm *arm, const char *text, armtol_drive drives[])
{
    const units units = units_of(arm);
    return given_drives_parse(text, arm, &units, drives);
}

/* ---- nothing left ---- */

void binding_say_nothing_left(const armtol_question *question, double q[], double least[], bool is_given,
                              const armtol_fault *fault)
{
    const cli_options options = {.given = is_given ? "" : NULL};
    request request = {
        .options = &options,
        .units = units_of(question->arm),
        .question = *question,
        .q = q,
        .least = least,
        .arm = *question->arm,
        .loading = question->loading != NULL ? *question->loading : armtol_loading_standard,
    };
    memcpy(request.accuracy, question->accuracy, sizeof request.accuracy);
    for (size_t i = 0; i < question->n_norms; i++) {
        request.norms[i] = question->norms[i];
    }
    nothing_left(&request, fault);
}
