#include "armtol/arm.h"

#include "lib/arms/arms.h"
#include "lib/arms/motion.h"

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

double arm_metres(armtol_length_unit unit)
{
    static const double counts[ARMTOL_LENGTH_UNIT_COUNT] = {
        [ARMTOL_MILLIMETRE] = 1e-3, [ARMTOL_METRE] = 1, [ARMTOL_INCH] = 0.0254};
    return (size_t)unit < ARMTOL_LENGTH_UNIT_COUNT ? counts[unit] : 1e-3;
}

double armtol_drive_error(const armtol_drive *drive)
{
    return drive->backlash + drive->compliance * drive->moment;
}

bool armtol_drive_is_known(const armtol_drive *drive)
{
    return !isnan(drive->backlash) || drive->compliance != 0 || drive->resolution != 0 || drive->noise != 0;
}

static double play_of(const armtol_drive *drive)
{
    return isnan(drive->backlash) ? 0 : drive->backlash;
}

/* Whether the moment holds the joint at one end of its play. */
static bool is_held(const armtol_drive *drive, double moment, double doubt)
{
    const double least = fabs(moment) - doubt;
    return least > 0 && least >= drive->friction;
}

armtol_drive_offset armtol_drive_offset_under(const armtol_drive *drive, double moment, double doubt,
                                              double compensated)
{
    const double play = play_of(drive);
    const bool held = is_held(drive, moment, doubt);
    return (armtol_drive_offset){
        .shift = drive->compliance * moment * (1 - compensated) + (held ? copysign(play, moment) : 0),
        .half = drive->compliance * doubt + (held ? 0 : play) + drive->resolution / 2 +
                ARMTOL_NOISE_SIGMAS * drive->noise,
    };
}

armtol_drive_arrival armtol_drive_arrival_under(const armtol_drive *drive, double moment, double doubt)
{
    return (armtol_drive_arrival){
        .play = is_held(drive, moment, doubt) ? 0 : play_of(drive) / 2,
        .step = drive->resolution / 2,
        .noise = drive->noise,
    };
}

double armtol_drive_arrival_half(const armtol_drive_arrival *arrival)
{
    return arrival->play + arrival->step + ARMTOL_NOISE_SIGMAS * arrival->noise;
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
