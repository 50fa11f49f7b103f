#include "lib/arms/arms.h"

static const armtol_link links[] = {
    {ARMTOL_NPR, ARMTOL_REVOLUTE, .alpha = QUARTER},
    {ARMTOL_PPR, ARMTOL_REVOLUTE, .a = 431.8},
    {ARMTOL_NPR, ARMTOL_REVOLUTE, .a = 20.3, .alpha = -QUARTER, .d = 150.05},
    {ARMTOL_NPR, ARMTOL_REVOLUTE, .alpha = QUARTER, .d = 431.8},
    {ARMTOL_NPR, ARMTOL_REVOLUTE, .alpha = -QUARTER},
    {ARMTOL_NPR, ARMTOL_REVOLUTE},
};

static const armtol_drive drives[] = {
    LIMITS(DEGREES(-160), DEGREES(160)), LIMITS(DEGREES(-45), DEGREES(225)),
    LIMITS(DEGREES(-225), DEGREES(45)),  LIMITS(DEGREES(-110), DEGREES(170)),
    LIMITS(DEGREES(-100), DEGREES(100)), LIMITS(DEGREES(-266), DEGREES(266)),
};

const armtol_arm arm_puma_560 = {
    .name = "puma560",
    .title = "Unimation Puma 560",
    .source = "Corke and Armstrong-Helouvry 1994 and, for limits, Wang and Chen 1991, both as in "
              "mdl_puma560 of the Robotics Toolbox for MATLAB, 2017",
    .unit = ARMTOL_MILLIMETRE,
    .n_links = sizeof links / sizeof links[0],
    .links = links,
    .drives = drives,
};
