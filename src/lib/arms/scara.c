#include "lib/arms/arms.h"

static const armtol_link links[] = {
    {ARMTOL_PPR, ARMTOL_REVOLUTE, .a = 325, .d = 387},
    {ARMTOL_PPR, ARMTOL_REVOLUTE, .a = 275, .alpha = PI},
    {ARMTOL_PPP, ARMTOL_PRISMATIC},
    {ARMTOL_NPR, ARMTOL_REVOLUTE},
};

static const armtol_drive drives[] = {
    LIMITS(DEGREES(-105), DEGREES(105)),
    LIMITS(DEGREES(-150), DEGREES(150)),
    LIMITS(0, 210),
    LIMITS(DEGREES(-360), DEGREES(360)),
};

const armtol_arm arm_scara = {
    .name = "scara",
    .title = "Adept Cobra 600, a SCARA",
    .source = "mdl_cobra600 of the Robotics Toolbox for MATLAB, 2017 and, for limits, "
              "the ROS package adept_cobra_s600_support, Schellenbeck 2018",
    .unit = ARMTOL_MILLIMETRE,
    .n_links = sizeof links / sizeof links[0],
    .links = links,
    .drives = drives,
};
