#include "armtol/arm.h"

#include "lib/arms/arms.h"

#include <math.h>
#include <string.h>

static const armtol_arm *const arms[] = {
    &arm_intelledex_605t, &arm_adept_one, &arm_puma_560, &arm_stanford,
    &arm_scara,           &arm_ur5e,      &arm_panda,    &arm_iiwa_14,
};

const armtol_drive armtol_drive_unknown = UNKNOWN;

const char *armtol_length_unit_name(armtol_length_unit unit)
{
    static const char *const names[ARMTOL_LENGTH_UNIT_COUNT] = {
        [ARMTOL_MILLIMETRE] = "mm",
        [ARMTOL_METRE] = "m",
        [ARMTOL_INCH] = "in",
    };
    return (size_t)unit < ARMTOL_LENGTH_UNIT_COUNT ? names[unit] : "?";
}

double armtol_drive_error(const armtol_drive *drive)
{
    return drive->backlash + drive->compliance * drive->moment;
}

bool armtol_drive_is_known(const armtol_drive *drive)
{
    return !isnan(drive->backlash) || drive->compliance != 0 || drive->resolution != 0;
}

armtol_drive_offset armtol_drive_offset_under(const armtol_drive *drive, double moment, double doubt,
                                              double compensated)
{
    const double play = isnan(drive->backlash) ? 0 : drive->backlash;
    const double least = fabs(moment) - doubt;
    const bool one_side = least > 0 && least >= drive->friction;
    return (armtol_drive_offset){
        .shift = drive->compliance * moment * (1 - compensated) + (one_side ? copysign(play, moment) : 0),
        .half = drive->compliance * doubt + (one_side ? 0 : play) + drive->resolution / 2,
    };
}

size_t armtol_arm_count(void)
{
    return sizeof arms / sizeof arms[0];
}

const armtol_arm *armtol_arm_at(size_t index)
{
    return index < armtol_arm_count() ? arms[index] : NULL;
}

const armtol_arm *armtol_arm_named(const char *name)
{
    for (size_t i = 0; i < armtol_arm_count(); i++) {
        if (strcmp(arms[i]->name, name) == 0) {
            return arms[i];
        }
    }
    return NULL;
}
