#include "armtol/ask/weights.h"

#include "armtol/lists/lists.h"
#include "armtol/ask/named.h"
#include "armtol/ask/number_list.h"
#include "console/input_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What is weighted: the columns of A of an arm. */
typedef struct weighted {
    named_columns of;
    double *weights;
} weighted;

/* NAME=NUMBER */
static bool take_item(const named_item *item, void *context)
{
    const weighted *weighted = context;
    double weight;
    if (!named_is(item, "=", "NAME=NUMBER") || !number_option_positive("--weights", item->value, &weight)) {
        return false;
    }
    for (size_t k = 0; k < weighted->of.n_columns; k++) {
        weighted->weights[k] = named_column(&weighted->of, item, k) ? weight : weighted->weights[k];
    }
    return named_any_column(&weighted->of, item);
}

static bool take_table(const char *path, const weighted *weighted)
{
    const parameter_table table = {.arm = weighted->of.arm,
                                   .columns = weighted->of.columns,
                                   .n_columns = weighted->of.n_columns,
                                   .value = "weight"};
    FILE *stream = input_file_open("--weights: ", path, "; expected NAME=NUMBER,... or a file");
    if (stream == NULL) {
        return false;
    }
    const bool fine = parameters_read(stream, path, &table, false, weighted->weights);
    fclose(stream);
    return fine;
}

bool weights_parse(const char *text, const armtol_arm *arm, const armtol_column columns[], size_t n_columns,
                   double weights[])
{
    weighted weighted = {{arm, columns, n_columns}, weights};
    for (size_t k = 0; k < n_columns; k++) {
        weights[k] = 1;
    }
    if (text == NULL) {
        return true;
    }
    return strchr(text, '=') != NULL ? named_each("--weights", text, arm, take_item, &weighted)
                                     : take_table(text, &weighted);
}
