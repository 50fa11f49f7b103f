#include "lab/joint_orders/intelledex_choices.h"
#include "lab/joint_orders/intelledex_steps.h"

static const step steps[] = {
    intelledex_find_t06,
    intelledex_find_q6_q1_q2,
    intelledex_find_wrist,
    intelledex_find_q3_q4_q5,
};

const family family_intelledex = {
    .program = "intella",
    .robot = &armtol_intelledex_605t,
    .choices = intelledex_choices,
    .n_choices = CHOICES,
    .steps = steps,
    .n_steps = sizeof steps / sizeof steps[0],
    .matters = intelledex_matters,
    .makes_sense = intelledex_makes_sense,
    .left_out = "elbow=chain with order=q1, which would find q1 and q2 twice",
};
