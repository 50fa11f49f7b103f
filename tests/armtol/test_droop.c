/*
 * A Panda that holds 5 kg, from its URDF, its joints of 1e-5 rad a N m: how far it droops, against Pinocchio 4.1.0 (pip
 * install pin, Python 3.11.7). The numbers are those that tests/armtol/pinocchio_droop prints for
 *     panda.urdf panda_hand 1e-5 5 0.1 -0.7 0.2 -2.1 0.3 1.6 0.8
 */

#include "armtol/answer.h"
#include "armtol/urdf/urdf.h"

#include "support/check.h"

#include "unity.h"

#include <math.h>
#include <stdio.h>

enum { JOINTS = 7, MOST_LINKS = 16 };

static const double q[JOINTS] = {0.1, -0.7, 0.2, -2.1, 0.3, 1.6, 0.8};
static const double moments[JOINTS] = {0, 20.473262350320272, 8.47307228775404, -43.873774524356236,
                                       -1.7219030984775334, -7.683499514199099, 0.006538716569436598};
static const double droop[3] = {8.416906092922893e-05, 2.4213265766764858e-05, -0.00028577036534183087};

void setUp(void)
{
}

void tearDown(void)
{
}

static void read_panda(arm_model *model)
{
    FILE *stream = fopen(TEST_PANDA, "rb");
    TEST_ASSERT_NOT_NULL(stream);
    TEST_ASSERT_TRUE(urdf_read(stream, "panda.urdf", NULL, "panda_hand", model));
    fclose(stream);
}

static void test_a_panda_droops_as_pinocchio_says(void)
{
    static const double accuracy[6] = {1, 1, 1, 1, 1, 1};
    const armtol_mass held = {.mass = 5};
    armtol_loading loading = armtol_loading_standard;
    armtol_drive drives[MOST_LINKS];
    arm_model model;
    read_panda(&model);
    armtol_arm arm = model.arm;
    TEST_ASSERT_TRUE(arm.n_links <= MOST_LINKS && arm.masses != NULL);
    for (size_t i = 0; i < arm.n_links; i++) {
        drives[i] = arm.drives[i];
        drives[i].compliance = 1e-5;
    }
    arm.drives = drives;
    loading.n_payloads = 1;
    loading.payloads = &held;
    const armtol_question question = {
        .arm = &arm, .q = q, .n_poses = 1, .accuracy = accuracy, .loading = &loading};
    armtol_answer *answer;
    armtol_fault fault;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_answer_create(&question, &answer, &fault));
    size_t joint = 0;
    for (size_t i = 0; i < arm.n_links; i++) {
        if (arm.links[i].joint != ARMTOL_FIXED) {
            check_within(1e-9, moments[joint], answer->moments[i], "moment of joint %zu", joint + 1);
            joint++;
        }
    }
    TEST_ASSERT_EQUAL_INT(JOINTS, joint);
    for (size_t i = 0; i < 3; i++) {
        check_within(1e-9, droop[i], answer->droops[i], "droop, %s", armtol_component_name(i));
    }
    armtol_answer_destroy(answer);
    arm_model_free(&model);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_panda_droops_as_pinocchio_says);
    return UNITY_END();
}
