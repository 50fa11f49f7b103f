#include "pose_link.h"

#include "lanes.h"

#define LANES 1
#include "sincos_kernel.h"
#undef LANES

void sine_cosine_of(double angle, double *sine, double *cosine)
{
    sine_cosine_1(&angle, sine, cosine);
}

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

armtol_pose_link pose_link_of(const armtol_link *link, size_t *column)
{
    armtol_pose_link pose_link = {
        .joint = link->joint,
        .turned = link->joint == ARMTOL_REVOLUTE || link->theta != 0,
        .shifted = link->joint == ARMTOL_PRISMATIC || link->a != 0 || link->d != 0,
        .tilted = link->alpha != 0,
        .bent = link->beta != 0,
        .a = link->a,
        .d = link->d,
        .theta = link->theta,
    };
    sine_cosine_of(link->theta, &pose_link.sin_theta, &pose_link.cos_theta);
    sine_cosine_of(link->alpha, &pose_link.sin_alpha, &pose_link.cos_alpha);
    sine_cosine_of(link->beta, &pose_link.sin_beta, &pose_link.cos_beta);
    columns_of_link(link->kind, column, pose_link.columns);
    return pose_link;
}
