#include "armtol/tables/arm_model.h"

#include "armtol/tables/arm_table.h"
#include "console/exit_code.h"
#include "console/message.h"

#include <math.h>
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
        if ((i < 5 || arm->masses != NULL) && model->memory[i] == NULL) {
            arm_model_free(model);
            out_of_memory();
            return false;
        }
    }
    return true;
}

/* Of a slide the drive's numbers are lengths where those of another joint are angles. */
static bool is_length(arm_column column, armtol_joint joint)
{
    const bool of_slide = joint == ARMTOL_PRISMATIC && arm_column_is_drive(column) &&
                          arm_column_is_angle(column, ARMTOL_REVOLUTE);
    return column == COLUMN_A || column == COLUMN_D || column >= COLUMN_COM_X || of_slide;
}

static bool convert_entry(arm_entry *entry, armtol_length_unit unit)
{
    bool fine = true;
    for (arm_column column = COLUMN_A; column < ARM_COLUMNS; column++) {
        double *number = arm_column_number(column, entry);
        if (is_length(column, entry->link.joint)) {
            const bool finite = isfinite(*number);
            *number = unit == ARMTOL_METRE ? *number / 1000 : *number * 1000;
            fine = fine && isfinite(*number) == finite;
        }
    }
    return fine;
}

bool arm_model_convert(arm_model *model, armtol_length_unit unit)
{
    armtol_link *links = model->memory[3];
    armtol_drive *drives = model->memory[4];
    armtol_mass *masses = model->memory[5];
    for (size_t i = 0; i < model->arm.n_links && unit != model->arm.unit; i++) {
        arm_entry entry = arm_entry_of(&model->arm, i);
        if (!convert_entry(&entry, unit)) {
            message("%s: link %zu: a length is too large in %s", model->arm.name, i, armtol_length_unit_name(unit));
            return false;
        }
        links[i] = entry.link;
        drives[i] = entry.drive;
        if (masses != NULL) {
            masses[i] = entry.mass;
        }
    }
    model->arm.unit = unit;
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
