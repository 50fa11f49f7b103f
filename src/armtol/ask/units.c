#include "armtol/ask/units.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define PI 3.14159265358979323846

armtol_length_unit units_chosen_length(unit_choice choice)
{
    return choice == UNITS_SMALL ? ARMTOL_MILLIMETRE : choice == UNITS_LARGE ? ARMTOL_METRE : ARMTOL_INCH;
}

/* The product first, unless no double holds that one; exactly as it is where nothing changes. */
static double scaled(double value, double factor, double divisor)
{
    if (factor == divisor) {
        return value;
    }
    const double product = value * factor;
    return isinf(product) ? value / divisor * factor : product / divisor;
}

double units_shown(const units *units, bool is_length, double value)
{
    if (is_length) {
        return scaled(value, arm_model_millimetres(units->arm), arm_model_millimetres(units->length));
    }
    return units->angle == UNIT_DEGREE ? scaled(value, 180, PI) : value;
}

double units_taken(const units *units, bool is_length, double value)
{
    if (is_length) {
        return scaled(value, arm_model_millimetres(units->length), arm_model_millimetres(units->arm));
    }
    return units->angle == UNIT_DEGREE ? scaled(value, PI, 180) : value;
}

void units_take_joints(const units *units, const armtol_arm *arm, double q[])
{
    size_t joint = 0;
    for (size_t i = 0; i < arm->n_links; i++) {
        if (armtol_arm_is_driven(arm, i)) {
            q[joint] = units_taken(units, arm->links[i].joint == ARMTOL_PRISMATIC, q[joint]);
            joint++;
        }
    }
}

double units_typed(const units *units, bool is_length, double value)
{
    const double shown = units_shown(units, is_length, value);
    for (int digits = 6; digits < 17 && isfinite(shown); digits++) {
        char text[40];
        snprintf(text, sizeof text, "%.*g", digits, shown);
        const double typed = strtod(text, NULL);
        if (fabs(typed - shown) <= 2 * DBL_EPSILON * fabs(shown)) {
            return typed;
        }
    }
    return shown;
}

const char *units_joint_text(const units *units, const armtol_link *link, double value, number_text *text)
{
    return number_shortest(units_typed(units, link->joint == ARMTOL_PRISMATIC, value), &armtol_errata_none, text);
}

units units_chosen(const cli_options *options, const arm_model *model)
{
    units units = {model->arm.unit, model->arm.unit, model->angle_unit};
    if (options->length != UNITS_OF_ARM) {
        units.length = units_chosen_length(options->length);
    }
    if (options->angle != UNITS_OF_ARM) {
        units.angle = options->angle == UNITS_SMALL ? UNIT_DEGREE : UNIT_RADIAN;
    }
    return units;
}

const char *units_name(const units *units, bool is_length)
{
    if (is_length) {
        return armtol_length_unit_name(units->length);
    }
    return units->angle == UNIT_DEGREE ? "deg" : "rad";
}
