#include "lib/arms/arms.h"

static const armtol_link links[] = {
    {ARMTOL_NPR, ARMTOL_REVOLUTE, .alpha = QUARTER, .d = 162.5},
    {ARMTOL_PPR, ARMTOL_REVOLUTE, .a = -425},
    {ARMTOL_PPR, ARMTOL_REVOLUTE, .a = -392.2},
    {ARMTOL_NPR, ARMTOL_REVOLUTE, .alpha = QUARTER, .d = 133.3},
    {ARMTOL_NPR, ARMTOL_REVOLUTE, .alpha = -QUARTER, .d = 99.7},
    {ARMTOL_NPR, ARMTOL_REVOLUTE, .d = 99.6},
};

#define TURN_EITHER_WAY LIMITS(DEGREES(-360), DEGREES(360))

static const armtol_drive drives[] = {
    TURN_EITHER_WAY, TURN_EITHER_WAY, TURN_EITHER_WAY, TURN_EITHER_WAY, TURN_EITHER_WAY, TURN_EITHER_WAY,
};

static const char *const names[] = {
    "shoulder_pan_joint", "shoulder_lift_joint", "elbow_joint", "wrist_1_joint", "wrist_2_joint", "wrist_3_joint",
};

const armtol_arm arm_ur5e = {
    .name = "ur5e",
    .title = "Universal Robots UR5e",
    .source = "Universal Robots, DH Parameters for calculations of kinematics and dynamics, 2022 and, "
              "for limits, UR5e User Manual 5.8 as in Universal_Robots_ROS2_Description, 2024",
    .unit = ARMTOL_MILLIMETRE,
    .n_links = sizeof links / sizeof links[0],
    .links = links,
    .drives = drives,
    .names = names,
};
