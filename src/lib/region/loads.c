#include "lib/region/loads.h"

#include "lib/arms/motion.h"
#include "lib/report/trigonometry.h"
#include "lib/tool/pose_link.h"

#include <math.h>
#include <stdlib.h>

static const armtol_loading *loading_of(const armtol_question *question)
{
    return question->loading != NULL ? question->loading : &armtol_loading_standard;
}

static bool bears(const armtol_question *question)
{
    const armtol_loading *loading = loading_of(question);
    return question->arm->masses != NULL || loading->n_payloads > 0 || length_of_vector(loading->force) != 0;
}

/* NO_COLUMN where the link's kind does not count what its joint moves. */
static size_t motor_column(const armtol_arm *arm, size_t link)
{
    size_t column = 0, columns[ARMTOL_PARAMETER_COUNT];
    for (size_t i = 0; i <= link; i++) {
        columns_of_link(arm->links[i].kind, &column, columns);
    }
    return columns[arm->links[link].joint == ARMTOL_REVOLUTE ? ARMTOL_THETA : ARMTOL_D];
}

/* What the question itself says of a motor; what has no bound is seen or not, and told elsewhere. */
static double given_to(const armtol_question *question, size_t column)
{
    const double *from = question->tolerances != NULL ? question->tolerances : question->least;
    return from != NULL && isfinite(from[column]) ? from[column] : 0;
}

/* Whether a load makes a difference to the drive. */
static bool is_moved(const armtol_drive *drive, double compensated)
{
    return (drive->compliance > 0 && compensated < 1) || drive->backlash > 0;
}

static load_drive drive_of(const armtol_question *question, size_t link, size_t column)
{
    const armtol_arm *arm = question->arm;
    const armtol_drive *drive = &arm->drives[link];
    const double unit = arm->links[link].joint == ARMTOL_REVOLUTE ? arm_metres(arm->unit) : 1;
    const double doubt = arm->masses == NULL ? drive->moment : 0, given = given_to(question, column);
    const double play = isnan(drive->backlash) ? 0 : drive->backlash;
    const double half = drive->compliance * doubt + drive->resolution / 2;
    return (load_drive){
        .link = link,
        .column = column,
        .give = drive->compliance * (1 - loading_of(question)->compensated) * unit,
        .play = play,
        .doubt = doubt / unit,
        .friction = drive->friction / unit,
        .held = fmax(given, half),
        .free_play = fmax(given, half + play),
    };
}

static void take_sizes(loads *loads, const armtol_question *question)
{
    const armtol_arm *arm = question->arm;
    const double g = length_of_vector(loads->loading->gravity);
    loads->turns = loads->weights + arm->n_links;
    loads->force = length_of_vector(loads->loading->force);
    loads->pushed = loads->force != 0;
    loads->reach = length_of_vector(question->tool.offset);
    for (int i = 0; i < 3; i++) {
        loads->offset[i] = question->tool.offset[i];
    }
    for (size_t i = 0; i < arm->n_links && arm->masses != NULL; i++) {
        loads->weights[i] = g * arm->masses[i].mass;
        loads->turns[i] = length_of_vector(arm->masses[i].center) * loads->weights[i];
    }
}

bool loads_make(loads *loads, const armtol_question *question)
{
    const armtol_arm *arm = question->arm;
    const armtol_loading *loading = loading_of(question);
    *loads = (struct loads){.arm = arm, .loading = loading};
    loads->n_cases = loading->n_payloads > 0 ? loading->n_payloads : 1;
    loads->drives = calloc(arm->n_links, sizeof *loads->drives);
    loads->weights = calloc(arm->n_links, 2 * sizeof *loads->weights);
    if (loads->drives == NULL || loads->weights == NULL) {
        return false;
    }
    take_sizes(loads, question);
    for (size_t i = 0; i < arm->n_links && bears(question) && !question->drives_apart; i++) {
        const bool moves = arm->links[i].joint != ARMTOL_FIXED;
        const size_t column = moves ? motor_column(arm, i) : NO_COLUMN;
        if (column != NO_COLUMN && is_moved(&arm->drives[i], loading->compensated)) {
            loads->drives[loads->n_drives++] = drive_of(question, i, column);
        }
    }
    return true;
}

void loads_free(loads *loads)
{
    free(loads->drives);
    free(loads->weights);
}

const armtol_mass *loads_payload(const loads *loads, size_t which)
{
    return loads->loading->n_payloads > 0 ? &loads->loading->payloads[which] : NULL;
}

bool loads_are_upright(const loads *loads)
{
    const double *g = loads->loading->gravity, *f = loads->loading->force;
    return g[0] == 0 && g[1] == 0 && f[0] == 0 && f[1] == 0;
}

void loads_most(const loads *loads, size_t which, const double lengths[], double most[])
{
    const armtol_arm *arm = loads->arm;
    const armtol_mass *held = loads_payload(loads, which);
    double force = loads->force, moment = loads->reach * force;
    if (held != NULL) {
        const double weight = length_of_vector(loads->loading->gravity) * held->mass;
        force += weight;
        moment += (loads->reach + length_of_vector(held->center)) * weight;
    }
    for (size_t i = arm->n_links; i-- > 0;) {
        force += loads->weights[i];
        moment += loads->turns[i] + lengths[i] * force;
        most[i] = arm->links[i].joint == ARMTOL_REVOLUTE ? moment : force;
    }
}
