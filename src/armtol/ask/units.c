#include "armtol/ask/units.h"

#include <math.h>

#define PI 3.14159265358979323846

/* How many millimetres a unit has. */
static double millimetres(armtol_length_unit unit)
{
    return unit == ARMTOL_METRE ? 1000 : 1;
}

/* The product first, unless no double holds that one. */
static double scaled(double value, double factor, double divisor)
{
    const double product = value * factor;
    return isinf(product) ? value / divisor * factor : product / divisor;
}

double units_shown(const units *units, bool is_length, double value)
{
    if (is_length) {
        return scaled(value, millimetres(units->arm), millimetres(units->length));
    }
    return units->angle == UNIT_DEGREE ? scaled(value, 180, PI) : value;
}

double units_taken(const units *units, bool is_length, double value)
{
    if (is_length) {
        return scaled(value, millimetres(units->length), millimetres(units->arm));
    }
    return units->angle == UNIT_DEGREE ? scaled(value, PI, 180) : value;
}

const char *units_name(const units *units, bool is_length)
{
    if (is_length) {
        return armtol_length_unit_name(units->length);
    }
    return units->angle == UNIT_DEGREE ? "deg" : "rad";
}
