#include "armtol/tables/arm_model.h"

#include "console/exit_code.h"

#include <stdlib.h>
#include <string.h>

/* A copy of n bytes at the model's next free place; NULL where memory is short. */
static void *keep(arm_model *model, size_t place, const void *bytes, size_t n)
{
    model->memory[place] = malloc(n);
    if (model->memory[place] != NULL) {
        memcpy(model->memory[place], bytes, n);
    }
    return model->memory[place];
}

bool arm_model_make(arm_model *model, const armtol_arm *arm, angle_unit angle_unit)
{
    *model = (arm_model){.arm = *arm, .angle_unit = angle_unit};
    model->arm.name = keep(model, 0, arm->name, strlen(arm->name) + 1);
    model->arm.title = keep(model, 1, arm->title, strlen(arm->title) + 1);
    model->arm.source = keep(model, 2, arm->source, strlen(arm->source) + 1);
    model->arm.links = keep(model, 3, arm->links, arm->n_links * sizeof *arm->links);
    model->arm.drives = keep(model, 4, arm->drives, arm->n_links * sizeof *arm->drives);
    if (arm->masses != NULL) {
        model->arm.masses = keep(model, 5, arm->masses, arm->n_links * sizeof *arm->masses);
    }
    for (size_t i = 0; i < sizeof model->memory / sizeof model->memory[0]; i++) {
        if (model->memory[i] == NULL && (i < 5 || arm->masses != NULL)) {
            arm_model_free(model);
            out_of_memory();
            return false;
        }
    }
    return true;
}

void arm_model_free(arm_model *model)
{
    for (size_t i = 0; i < sizeof model->memory / sizeof model->memory[0]; i++) {
        free(model->memory[i]);
    }
    free(model->laying.snapped);
    *model = (arm_model){.arm = {.name = NULL}};
}
