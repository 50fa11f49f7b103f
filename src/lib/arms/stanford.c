#include "lib/arms/arms.h"

static const armtol_link links[] = {
    {ARMTOL_NPR, ARMTOL_REVOLUTE, .alpha = -QUARTER, .d = 412},
    {ARMTOL_NPR, ARMTOL_REVOLUTE, .alpha = QUARTER, .d = 154},
    {ARMTOL_PPP, ARMTOL_PRISMATIC, .theta = -QUARTER},
    {ARMTOL_NPR, ARMTOL_REVOLUTE, .alpha = -QUARTER},
    {ARMTOL_NPR, ARMTOL_REVOLUTE, .alpha = QUARTER},
    {ARMTOL_NPR, ARMTOL_REVOLUTE, .d = 263},
};

static const armtol_drive drives[] = {
    LIMITS(DEGREES(-170), DEGREES(170)),
    LIMITS(DEGREES(-170), DEGREES(170)),
    UNKNOWN, /* the source guessed it, from a photograph */
    LIMITS(DEGREES(-170), DEGREES(170)),
    LIMITS(DEGREES(-90), DEGREES(90)),
    LIMITS(DEGREES(-170), DEGREES(170)),
};

const armtol_arm arm_stanford = {
    .name = "stanford",
    .title = "Stanford arm",
    .source = "Paul 1972 (Stanford AIM-177, figure 2.3) and, for limits, Dobrotin and Scheinman 1973, "
              "both as in mdl_stanford of the Robotics Toolbox for MATLAB, 2017",
    .unit = ARMTOL_MILLIMETRE,
    .n_links = sizeof links / sizeof links[0],
    .links = links,
    .drives = drives,
};
