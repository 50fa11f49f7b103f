#include "lib/tool/pose_link.h"

#define LANES 1
#include "lib/lanes/sincos.h"

void columns_of_link(armtol_kind kind, size_t *column, size_t columns[ARMTOL_PARAMETER_COUNT])
{
    size_t count;
    const armtol_parameter *parameters = armtol_kind_parameters(kind, &count);
    for (size_t i = 0; i < ARMTOL_PARAMETER_COUNT; i++) {
        columns[i] = NO_COLUMN;
    }
    for (size_t i = 0; i < count; i++) {
        columns[parameters[i]] = (*column)++;
    }
}

/* Most of a table's angles are 0: those are not worked out. */
static void take_sine_cosine(double angle, double *sine, double *cosine)
{
    *sine = 0;
    *cosine = 1;
    if (angle != 0) {
        sine_cosine(&angle, sine, cosine);
    }
}

armtol_pose_link pose_link_of(const armtol_link *link, size_t *column)
{
    armtol_pose_link made = {
        .joint = link->joint,
        .turned = link->joint == ARMTOL_REVOLUTE || link->theta != 0,
        .shifted = link->joint == ARMTOL_PRISMATIC || link->a != 0 || link->d != 0,
        .tilted = link->alpha != 0,
        .bent = link->beta != 0,
        .a = link->a,
        .d = link->d,
        .theta = link->theta,
    };
    take_sine_cosine(link->theta, &made.sin_theta, &made.cos_theta);
    take_sine_cosine(link->alpha, &made.sin_alpha, &made.cos_alpha);
    take_sine_cosine(link->beta, &made.sin_beta, &made.cos_beta);
    columns_of_link(link->kind, column, made.columns);
    return made;
}
