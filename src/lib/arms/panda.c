#include "lib/arms/arms.h"

/*
 * Published in Craig's order, where a and alpha are those of the link before: in Paul's they stand one row
 * earlier. The first row's are 0, so that the base needs no row; the flange's length joins joint 7's row.
 */
static const armtol_link links[] = {
    {ARMTOL_NPR, ARMTOL_REVOLUTE, .alpha = -QUARTER, .d = 333},
    {ARMTOL_NPR, ARMTOL_REVOLUTE, .alpha = QUARTER},
    {ARMTOL_NPR, ARMTOL_REVOLUTE, .a = 82.5, .alpha = QUARTER, .d = 316},
    {ARMTOL_NPR, ARMTOL_REVOLUTE, .a = -82.5, .alpha = -QUARTER},
    {ARMTOL_NPR, ARMTOL_REVOLUTE, .alpha = QUARTER, .d = 384},
    {ARMTOL_NPR, ARMTOL_REVOLUTE, .a = 88, .alpha = QUARTER},
    {ARMTOL_NPR, ARMTOL_REVOLUTE, .d = 107},
};

static const armtol_drive drives[] = {
    LIMITS(-2.8973, 2.8973), LIMITS(-1.7628, 1.7628), LIMITS(-2.8973, 2.8973), LIMITS(-3.0718, -0.0698),
    LIMITS(-2.8973, 2.8973), LIMITS(-0.0175, 3.7525), LIMITS(-2.8973, 2.8973),
};

const armtol_arm arm_panda = {
    .name = "panda",
    .title = "Franka Emika Panda",
    .source = "Franka Emika, Franka Control Interface documentation, 2019: "
              "Robot and interface specifications",
    .unit = ARMTOL_MILLIMETRE,
    .n_links = sizeof links / sizeof links[0],
    .links = links,
    .drives = drives,
};
