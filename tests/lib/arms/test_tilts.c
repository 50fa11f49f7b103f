/*
 * Arms whose one axis is tilted from 0 to 90 degrees by half a degree: what is asked of their parts changes as smoothly
 * as the arm does, but for the one tilt at which Hayati's beta gives way to d.
 */

#include "armtol/answer.h"
#include "armtol/axes.h"
#include "armtol/euler.h"
#include "armtol/transform.h"

#include "support/check.h"
#include "unity.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

void setUp(void)
{
}

void tearDown(void)
{
}

enum { MOST_AXES = 6, MOST_LINKS = ARMTOL_LINKS_OF_AXES(MOST_AXES), MOST_COLUMNS = 4 * MOST_LINKS, STEPS = 180 };

static const double pi = 3.14159265358979323846;

/* From frame to frame, as a URDF has it; the last one is the tool's. */
typedef struct step {
    double xyz[3], rpy[3];
} step;

typedef struct family {
    const char *name;
    size_t n_axes;
    step steps[MOST_AXES + 1];
    size_t tilted;   /* the step that is, */
    double about[3]; /* with this as its rpy for an angle of 1 */
    double q[MOST_AXES], linear, angular;
    double most_jump; /* of a tolerance where the kinds change */
} family;

/* All about, and a tool or an axis that leans along and across the line from the axis before. */
#define QUILL                                                                                                          \
    3, {{{0, 0, .4}, {0}}, {{0, 0, .1}, {-QUARTER, 0, 0}}, {{.35, 0, 0}, {0, QUARTER, 0}}, {{0, .08, .05}, {0}}}, 3
#define TWO 2, {{{0, 0, .2}, {0}}, {{.3, 0, 0}, {0}}, {{.25, 0, .05}, {0}}}, 1
#define SIX                                                                                                            \
    6,                                                                                                                 \
    {{{0, 0, .4}, {0}}, {{0, 0, .1}, {-QUARTER, 0, 0}}, {{.4, 0, 0}, {0}}, {{.4, 0, .1}, {0}},                       \
     {{0, .1, 0}, {-QUARTER, 0, 0}}, {{0, -.1, 0}, {QUARTER, 0, 0}}, {{0, 0, .1}, {0}}}, 2
#define QUARTER 1.5707963267948966

static const family families[] = {
    {"a tool beside axis 3", QUILL, {1, 0, 0}, {.4, -.7, .3}, .0005, .002, 1.6},
    {"a tool that leans to axis 3", QUILL, {0, 1, 0}, {.4, -.7, .3}, .0005, .002, 6},
    {"two axes", TWO, {0, 1, 0}, {.349, .698}, .0001, .0017, 3},
    {"two twisted axes", TWO, {1, 0, 0}, {.349, .698}, .0001, .0017, 6.5},
    {"two axes, askew", TWO, {.6, .8, 0}, {.349, .698}, .0001, .0017, 2.2},
    {"an elbow", SIX, {0, 1, 0}, {.4, -.7, .9, .4, .8, .3}, .0005, .002, 6},
    {"a twisted elbow", SIX, {1, 0, 0}, {.4, -.7, .9, .4, .8, .3}, .0005, .002, 2},
    {"an elbow, askew", SIX, {.6, .8, 0}, {.4, -.7, .9, .4, .8, .3}, .0005, .002, 5.5},
};

enum { FAMILIES = sizeof families / sizeof families[0] };

/* What is compared: tolerances by column, and the reach for lengths. */
typedef struct found {
    size_t n_links, n_columns;
    armtol_link links[MOST_LINKS];
    armtol_column columns[MOST_COLUMNS];
    double tolerances[MOST_COLUMNS];
    double longest, reach;
} found;

static void lay(const family *family, double tilt, found *found)
{
    armtol_axis axes[MOST_AXES];
    size_t n_snapped;
    armtol_transform frame = armtol_transform_identity();
    for (size_t i = 0; i <= family->n_axes; i++) {
        const step *at = &family->steps[i];
        double pose[6];
        for (int k = 0; k < 3; k++) {
            pose[k] = at->xyz[k];
            pose[3 + k] = at->rpy[k] + (i == family->tilted ? tilt * family->about[k] : 0);
        }
        const armtol_transform step = armtol_pose_to_transform(pose, &armtol_errata_none);
        frame = armtol_transform_product(&frame, &step, &armtol_errata_none);
        for (int k = 0; k < 3 && i < family->n_axes; k++) {
            axes[i].joint = ARMTOL_REVOLUTE;
            axes[i].point[k] = frame.m[k][3];
            axes[i].direction[k] = frame.m[k][2];
        }
    }
    TEST_ASSERT_EQUAL(ARMTOL_OK, armtol_links_of_axes(axes, family->n_axes, &frame, ARMTOL_USUAL_SNAP, found->links,
                                                      &found->n_links, NULL, &n_snapped));
    found->reach = armtol_spread_of_axes(axes, family->n_axes, &frame).reach;
    found->longest = 0;
    for (size_t i = 0; i < found->n_links; i++) {
        found->longest = fmax(found->longest, fmax(found->links[i].a, fabs(found->links[i].d)));
    }
}

static void find(const family *family, double tilt, found *found)
{
    lay(family, tilt, found);
    armtol_drive drives[MOST_LINKS];
    for (size_t i = 0; i < MOST_LINKS; i++) {
        drives[i] = armtol_drive_unknown;
    }
    const double a = family->linear, w = family->angular, accuracy[6] = {a, a, a, w, w, w};
    const armtol_arm arm = {.name = "tilted", .title = "tilted", .source = "", .unit = ARMTOL_METRE,
                            .n_links = found->n_links, .links = found->links, .drives = drives};
    const armtol_question question = {.arm = &arm, .q = family->q, .n_poses = 1, .accuracy = accuracy};
    armtol_answer *answer;
    TEST_ASSERT_EQUAL(ARMTOL_OK, armtol_answer_create(&question, &answer, NULL));
    found->n_columns = answer->n_columns;
    memcpy(found->columns, answer->columns, answer->n_columns * sizeof *answer->columns);
    memcpy(found->tolerances, answer->tolerances, answer->n_columns * sizeof *answer->tolerances);
    armtol_answer_destroy(answer);
}

/* The largest factor between the tolerances of a parameter that both have. */
static double jump_of(const found *one, const found *other)
{
    double most = 1;
    for (size_t i = 0; i < one->n_columns; i++) {
        for (size_t k = 0; k < other->n_columns; k++) {
            if (one->columns[i].link == other->columns[k].link &&
                one->columns[i].parameter == other->columns[k].parameter) {
                const double ratio = one->tolerances[i] / other->tolerances[k];
                TEST_ASSERT_TRUE(ratio > 0 && isfinite(ratio));
                most = fmax(most, fmax(ratio, 1 / ratio));
            }
        }
    }
    return most;
}

static bool same_kinds(const found *one, const found *other)
{
    bool same = one->n_links == other->n_links;
    for (size_t i = 0; same && i < one->n_links; i++) {
        same = one->links[i].kind == other->links[i].kind;
    }
    return same;
}

static void sweep(const family *family)
{
    found before, now;
    int changes = 0;
    for (int n = 0; n <= STEPS; n++) {
        char what[80];
        find(family, n * pi / 2 / STEPS, &now);
        snprintf(what, sizeof what, "%s, at %g degrees", family->name, n * 90.0 / STEPS);
        TEST_ASSERT_TRUE_MESSAGE(now.longest <= 2 * now.reach, what);
        if (n > 0) {
            const bool same = same_kinds(&before, &now);
            changes += !same;
            TEST_ASSERT_TRUE_MESSAGE(jump_of(&before, &now) < (same ? 1.08 : family->most_jump), what);
        }
        before = now;
    }
    TEST_ASSERT_EQUAL_INT_MESSAGE(1, changes, family->name);
}

static void test_tolerances_change_smoothly_with_the_tilt(void)
{
    for (size_t i = 0; i < FAMILIES; i++) {
        sweep(&families[i]);
    }
}

/* From far below what is taken for exact to what is not: no step where the one becomes the other. */
static void test_nothing_happens_where_snapping_ends(void)
{
    for (size_t i = 0; i < FAMILIES; i++) {
        found exact, tilted;
        find(&families[i], 0, &exact);
        for (int n = 0; n < 22; n++) {
            const double tilt = 1e-9 * pow(1.7, n);
            find(&families[i], tilt, &tilted);
            TEST_ASSERT_TRUE_MESSAGE(same_kinds(&exact, &tilted), families[i].name);
            TEST_ASSERT_TRUE_MESSAGE(jump_of(&exact, &tilted) < 1.001, families[i].name);
        }
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_tolerances_change_smoothly_with_the_tilt);
    RUN_TEST(test_nothing_happens_where_snapping_ends);
    return UNITY_END();
}
