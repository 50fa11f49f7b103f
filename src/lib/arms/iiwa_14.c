#include "lib/arms/arms.h"

static const armtol_link links[] = {
    {ARMTOL_NPR, ARMTOL_REVOLUTE, .alpha = -QUARTER, .d = 360},
    {ARMTOL_NPR, ARMTOL_REVOLUTE, .alpha = QUARTER},
    {ARMTOL_NPR, ARMTOL_REVOLUTE, .alpha = QUARTER, .d = 420},
    {ARMTOL_NPR, ARMTOL_REVOLUTE, .alpha = -QUARTER},
    {ARMTOL_NPR, ARMTOL_REVOLUTE, .alpha = -QUARTER, .d = 400},
    {ARMTOL_NPR, ARMTOL_REVOLUTE, .alpha = QUARTER},
    {ARMTOL_NPR, ARMTOL_REVOLUTE, .d = 126},
};

static const armtol_drive drives[] = {
    LIMITS(DEGREES(-170), DEGREES(170)), LIMITS(DEGREES(-120), DEGREES(120)),
    LIMITS(DEGREES(-170), DEGREES(170)), LIMITS(DEGREES(-120), DEGREES(120)),
    LIMITS(DEGREES(-170), DEGREES(170)), LIMITS(DEGREES(-120), DEGREES(120)),
    LIMITS(DEGREES(-175), DEGREES(175)),
};

const armtol_arm arm_iiwa_14 = {
    .name = "iiwa14",
    .title = "KUKA LBR iiwa 14 R820",
    .source = "ROS packages iiwa_description 1.4.0 (iiwa_stack, TU Munich), 2023 and "
              "kuka_lbr_iiwa_support (ROS-Industrial), 2023",
    .unit = ARMTOL_MILLIMETRE,
    .n_links = sizeof links / sizeof links[0],
    .links = links,
    .drives = drives,
};
