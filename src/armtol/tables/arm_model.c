#include "armtol/tables/arm_model.h"

#include "armtol/names/link_name.h"
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

/* The names, and their letters behind the pointers: one piece of memory. */
static void *keep_names(arm_model *model, size_t place, const char *const names[], size_t n)
{
    size_t letters = 0;
    for (size_t i = 0; i < n; i++) {
        letters += names[i] != NULL ? strlen(names[i]) + 1 : 0;
    }
    const char **kept = malloc(n * sizeof *kept + letters);
    model->memory[place] = kept;
    char *at = kept != NULL ? (char *)(kept + n) : NULL;
    for (size_t i = 0; i < n && kept != NULL; i++) {
        kept[i] = names[i] != NULL ? strcpy(at, names[i]) : NULL;
        at += names[i] != NULL ? strlen(names[i]) + 1 : 0;
    }
    return kept;
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
    if (arm->motions != NULL) {
        model->arm.motions = keep(model, 6, arm->motions, arm->n_links * sizeof *arm->motions);
    }
    if (arm->names != NULL) {
        model->arm.names = keep_names(model, 7, arm->names, arm->n_links);
    }
    const bool wanted[] = {true, true, true, true, true, arm->masses != NULL, arm->motions != NULL, arm->names != NULL};
    for (size_t i = 0; i < sizeof model->memory / sizeof model->memory[0]; i++) {
        if (wanted[i] && model->memory[i] == NULL) {
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
    const bool moves = arm_column_is_drive(column) || arm_column_is_motion(column);
    const bool of_slide = joint == ARMTOL_PRISMATIC && moves && arm_column_is_angle(column, ARMTOL_REVOLUTE);
    return column == COLUMN_A || column == COLUMN_D || column >= COLUMN_COM_X || of_slide;
}

double arm_model_millimetres(armtol_length_unit unit)
{
    static const double counts[ARMTOL_LENGTH_UNIT_COUNT] = {
        [ARMTOL_MILLIMETRE] = 1, [ARMTOL_METRE] = 1000, [ARMTOL_INCH] = 25.4};
    return counts[unit];
}

/* A motor that turns one joint and pushes another: lengths a radian, or radians a length. */
static void convert_multiplier(arm_entry *entry, armtol_joint leader, double factor, double divisor)
{
    const bool slides = entry->link.joint == ARMTOL_PRISMATIC;
    if (entry->link.joint != ARMTOL_FIXED && slides != (leader == ARMTOL_PRISMATIC)) {
        entry->motion.multiplier *= slides ? factor / divisor : divisor / factor;
    }
}

static bool convert_entry(arm_entry *entry, double factor, double divisor)
{
    bool fine = true;
    for (arm_column column = COLUMN_A; column < ARM_COLUMNS; column++) {
        double *number = arm_column_number(column, entry);
        if (is_length(column, entry->link.joint)) {
            const bool finite = isfinite(*number);
            *number = *number * factor / divisor;
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
    armtol_motion *motions = model->memory[6];
    const double factor = arm_model_millimetres(model->arm.unit), divisor = arm_model_millimetres(unit);
    for (size_t i = 0; i < model->arm.n_links && unit != model->arm.unit; i++) {
        arm_entry entry = arm_entry_of(&model->arm, i);
        if (!convert_entry(&entry, factor, divisor)) {
            message("%s: %s: a length is too large in %s", model->arm.name,
                    link_words(&model->arm, i, &(link_text){""}), armtol_length_unit_name(unit));
            return false;
        }
        links[i] = entry.link;
        drives[i] = entry.drive;
        if (masses != NULL) {
            masses[i] = entry.mass;
        }
        if (motions != NULL && entry.link.joint != ARMTOL_FIXED) {
            convert_multiplier(&entry, links[entry.motion.follows].joint, factor, divisor);
            motions[i] = entry.motion;
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
