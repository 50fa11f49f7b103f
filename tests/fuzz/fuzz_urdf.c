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
#include "armtol/urdf/origin.h"
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

static bool moves(const urdf_joint *joint)
{
    return joint->type == URDF_REVOLUTE || joint->type == URDF_CONTINUOUS || joint->type == URDF_PRISMATIC;
}

/* The joint of the chain at that index of the tree, n_joints where it is not one that moves there. */
static size_t place_of(const urdf_tree *tree, const urdf_chain *chain, size_t index)
{
    size_t i = 0;
    while (i < chain->n_joints && (chain->joints[i] != index || !moves(&tree->joints[index]))) {
        i++;
    }
    return i;
}

/* Which of the chain's joints the one at i goes by, the last of those whose turn it is to follow, and how. */
static size_t follow(const urdf_tree *tree, const urdf_chain *chain, size_t i, double *multiplier, double *offset)
{
    double m = 1, o = 0;
    size_t last = i, steps = 0;
    *multiplier = 1;
    *offset = 0;
    for (const urdf_joint *joint = &tree->joints[chain->joints[i]];
         joint->leader != URDF_NONE && steps < tree->n_joints; joint = &tree->joints[joint->leader], steps++) {
        o += m * joint->offset;
        m *= joint->multiplier;
        const size_t place = place_of(tree, chain, joint->leader);
        if (place < chain->n_joints) {
            last = place;
            *multiplier = m;
            *offset = o;
        }
    }
    return last;
}

/* The values of the chain's joints by their place in it, of those that have one of their own; false for large ones. */
static bool spread_values(const urdf_tree *tree, const urdf_chain *chain, const double own[], double values[])
{
    bool fine = true;
    for (size_t i = 0; i < chain->n_joints; i++) {
        double multiplier, offset;
        const size_t leader = follow(tree, chain, i, &multiplier, &offset);
        values[i] = multiplier * own[leader] + offset;
        fine = fine && (leader == i || fabs(values[i]) < 1e3);
    }
    return fine;
}

static armtol_transform inverse_of(const armtol_transform *m)
{
    armtol_transform inverse = {{{0}}};
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            inverse.m[i][k] = m->m[k][i];
            inverse.m[i][3] -= m->m[k][i] * m->m[k][3];
        }
    }
    inverse.m[3][3] = 1;
    return inverse;
}

static armtol_transform step_of(const urdf_joint *joint, double value)
{
    const armtol_transform origin =
        joint->has_quaternion ? urdf_joint_origin(joint) : motion_of_rpy(joint->xyz, joint->rpy);
    if (!moves(joint)) {
        return origin;
    }
    const armtol_transform moved =
        joint->type == URDF_PRISMATIC ? motion_along(joint->axis, value) : motion_about(joint->axis, value);
    return motion_product(&origin, &moved);
}

static armtol_transform reached(const urdf_tree *tree, const urdf_chain *chain, const double values[])
{
    armtol_transform tool = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
    for (size_t i = 0; i < chain->n_joints; i++) {
        const armtol_transform down = step_of(&tree->joints[chain->joints[i]], values[i]), up = inverse_of(&down);
        tool = motion_product(&tool, i < chain->n_up ? &up : &down);
    }
    return tool;
}

static void check_pose(const urdf_tree *tree, const urdf_chain *chain, const arm_model *model, const double own[],
                       double size)
{
    armtol_link placed[ARMTOL_LINKS_OF_AXES(MOST_JOINTS)];
    double values[MOST_JOINTS], q[MOST_JOINTS];
    size_t n = 0;
    if (!spread_values(tree, chain, own, values)) {
        return;
    }
    for (size_t i = 0; i < chain->n_joints; i++) {
        double multiplier, offset;
        if (moves(&tree->joints[chain->joints[i]]) && follow(tree, chain, i, &multiplier, &offset) == i) {
            q[n++] = own[i];
        }
        size += fabs(values[i]);
    }
    REQUIRE(armtol_arm_place(&model->arm, q, n, placed) == ARMTOL_OK);
    const armtol_transform expected = reached(tree, chain, values);
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
        double own[MOST_JOINTS];
        for (size_t k = 0; k < chain->n_joints; k++) {
            const double most = tree->joints[chain->joints[k]].type == URDF_PRISMATIC ? size : PI;
            own[k] = i == 0 ? 0 : random_between(&random, -most, most);
        }
        check_pose(tree, chain, model, own, size);
    }
}

/* ---- reading ---- */

static void check_arm(const arm_model *model)
{
    const armtol_arm *arm = &model->arm;
    REQUIRE(caught_nothing() || strstr(caught_text(), "warning: ") != NULL);
    REQUIRE(arm->unit == ARMTOL_METRE && model->angle_unit == UNIT_RADIAN);
    REQUIRE(armtol_arm_check(arm) == ARMTOL_OK);
    REQUIRE(armtol_arm_joint_count(arm) > 0);
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

static void check_drawing(const urdf_tree *tree)
{
    static const urdf_units units = {1, 1, "m", "rad"};
    static char text[1 << 21];
    FILE *stream = fmemopen(text, sizeof text, "w");
    REQUIRE(stream != NULL);
    REQUIRE(urdf_tree_draw(tree, &units, stream));
    fflush(stream);
    size_t lines = 0;
    for (const char *c = text; *c != '\0'; c++) {
        lines += *c == '\n';
    }
    REQUIRE(lines == tree->n_links || ftell(stream) >= (long)sizeof text - 1);
    fclose(stream);
}

static void check_tree(const input *input, const urdf_tree *tree)
{
    check_drawing(tree);
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
