/*
 * Robots in URDF: refused with one message, or an arm whose tool is where the joints of the file bring it. Read with
 * the ends that the file itself says, with two of its links for ends, and with a link that it has not.
 */

#include "fuzz/bytes.h"
#include "fuzz/harness.h"
#include "fuzz/motion.h"
#include "fuzz/require.h"

#include "armtol/link_transform.h"
#include "armtol/urdf/chain.h"
#include "armtol/urdf/parse.h"
#include "armtol/urdf/tree.h"
#include "armtol/urdf/urdf.h"
#include "support/random.h"

#include <math.h>
#include <string.h>

#define PI 3.14159265358979323846

enum { MOST_JOINTS = 64 };

typedef struct input {
    const uint8_t *data;
    size_t size;
    uint64_t hash;
} input;

/* ---- the joints of the file, one after the other ---- */

/* Lengths and turns of the chain, to measure rounding by; nan where they are beyond an arm's. */
static double size_of(const urdf_tree *tree, const urdf_chain *chain, const arm_model *model)
{
    double size = 0;
    bool fine = true;
    for (size_t i = 0; i < chain->n_joints; i++) {
        const urdf_joint *joint = &tree->joints[chain->joints[i]];
        for (int k = 0; k < 3; k++) {
            size += fabs(joint->xyz[k]);
            fine = fine && fabs(joint->rpy[k]) < 1e3 && fabs(joint->axis[k]) < 1e100;
        }
        const double length = hypot(hypot(joint->axis[0], joint->axis[1]), joint->axis[2]);
        fine = fine && (joint->type == URDF_FIXED || length > 1e-100);
    }
    for (size_t i = 0; i < model->arm.n_links; i++) {
        size += fabs(model->arm.links[i].a) + fabs(model->arm.links[i].d);
    }
    return fine && size < 1e100 ? size : (double)NAN;
}

static armtol_transform reached(const urdf_tree *tree, const urdf_chain *chain, const double q[])
{
    armtol_transform tool = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
    size_t axis = 0;
    for (size_t i = 0; i < chain->n_joints; i++) {
        const urdf_joint *joint = &tree->joints[chain->joints[i]];
        const armtol_transform origin = motion_of_rpy(joint->xyz, joint->rpy);
        tool = motion_product(&tool, &origin);
        if (joint->type != URDF_FIXED) {
            const armtol_transform moved = joint->type == URDF_PRISMATIC ? motion_along(joint->axis, q[axis])
                                                                        : motion_about(joint->axis, q[axis]);
            tool = motion_product(&tool, &moved);
            axis++;
        }
    }
    return tool;
}

static void check_pose(const urdf_tree *tree, const urdf_chain *chain, const arm_model *model, const double q[],
                       double size)
{
    armtol_link placed[ARMTOL_LINKS_OF_AXES(MOST_JOINTS)];
    const size_t n_joints = armtol_joint_count(model->arm.links, model->arm.n_links);
    REQUIRE(armtol_links_place(model->arm.links, model->arm.n_links, q, n_joints, &armtol_errata_none, placed) ==
            ARMTOL_OK);
    const armtol_transform expected = reached(tree, chain, q);
    const armtol_transform actual = armtol_chain_transform(placed, model->arm.n_links, &armtol_errata_none);
    const motion_difference difference = motion_compare(&expected, &actual);
    REQUIRE(difference.angle <= 1e-10);
    REQUIRE(difference.length <= 1e-10 * size + 1e-300);
}

static void check_kinematics(const urdf_tree *tree, const urdf_chain *chain, const arm_model *model, uint64_t seed)
{
    random_source random = {seed};
    const double size = size_of(tree, chain, model);
    if (chain->n_joints > MOST_JOINTS || !(size >= 0)) {
        return;
    }
    for (int i = 0; i < 3; i++) {
        double q[MOST_JOINTS];
        size_t n = 0;
        for (size_t k = 0; k < model->arm.n_links; k++) {
            if (model->arm.links[k].joint != ARMTOL_FIXED) {
                const double most = model->arm.links[k].joint == ARMTOL_PRISMATIC ? size : PI;
                q[n++] = i == 0 ? 0 : random_between(&random, -most, most);
            }
        }
        check_pose(tree, chain, model, q, size);
    }
}

/* ---- reading ---- */

static void check_arm(const arm_model *model)
{
    const armtol_arm *arm = &model->arm;
    REQUIRE(caught_nothing());
    REQUIRE(arm->unit == ARMTOL_METRE && model->angle_unit == UNIT_RADIAN);
    REQUIRE(armtol_links_check(arm->links, arm->n_links) == ARMTOL_OK);
    REQUIRE(armtol_joint_count(arm->links, arm->n_links) > 0);
    for (size_t i = 0; i < arm->n_links; i++) {
        REQUIRE(arm->drives[i].low <= arm->drives[i].high);
    }
    for (const char *c = arm->name; *c != '\0'; c++) {
        REQUIRE(strchr(" \t,;:#\"", *c) == NULL);
    }
}

static bool read_arm(const input *input, const char *base, const char *tip, arm_model *model)
{
    FILE *stream = caught_file(input->data, input->size);
    caught_forget();
    const bool fine = urdf_read(stream, "robot.urdf", base, tip, model);
    fclose(stream);
    if (fine) {
        check_arm(model);
    } else {
        REQUIRE(caught_one_message());
        REQUIRE(model->arm.name == NULL);
    }
    return fine;
}

static void check_ends(const input *input, const urdf_tree *tree, const char *base, const char *tip)
{
    arm_model model;
    if (!read_arm(input, base, tip, &model)) {
        return;
    }
    urdf_chain chain;
    REQUIRE(urdf_chain_find(tree, base, tip, &chain));
    check_kinematics(tree, &chain, &model, input->hash);
    urdf_chain_free(&chain);
    arm_model_free(&model);
}

static void check_tree(const input *input, const urdf_tree *tree)
{
    arm_model model;
    check_ends(input, tree, NULL, NULL);
    REQUIRE(!read_arm(input, "no such link", NULL, &model));
    if (tree->n_links > 0) {
        const char *base = tree->links[input->hash % tree->n_links].name;
        const char *tip = tree->links[(input->hash >> 32) % tree->n_links].name;
        check_ends(input, tree, base, tip);
        check_ends(input, tree, NULL, tip);
    }
}

int LLVMFuzzerInitialize(int *argc, char ***argv)
{
    (void)argc;
    (void)argv;
    caught_start("armtol");
    return 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    const input input = {data, size, bytes_hash(data, size)};
    urdf_tree tree;
    FILE *stream = caught_file(data, size);
    caught_forget();
    urdf_tree_start(&tree, "robot.urdf");
    if (urdf_parse(stream, &tree) && urdf_tree_connect(&tree)) {
        check_tree(&input, &tree);
    } else {
        arm_model model;
        REQUIRE(!read_arm(&input, NULL, NULL, &model));
    }
    urdf_tree_free(&tree);
    fclose(stream);
    return 0;
}
