#include "armtol/robots.h"

#include "lib/arms/arms.h"
#include "lib/report/arithmetic.h"
#include "lib/report/finite.h"
#include "lib/report/trigonometry.h"

#include <math.h>
#include <string.h>

enum { LINKS = 6, JOINTS = 4, WISH = 4 };

#define BASE_HEIGHT 203.2
#define INNER_LINK 425.0
#define OUTER_LINK 375.0

static const armtol_link table[LINKS] = {
    {ARMTOL_NPR, ARMTOL_FIXED, .d = BASE_HEIGHT},
    {ARMTOL_PPR, ARMTOL_REVOLUTE, .a = INNER_LINK},
    {ARMTOL_PPR, ARMTOL_REVOLUTE, .a = OUTER_LINK},
    {ARMTOL_PPR, ARMTOL_REVOLUTE, .a = 0},
    {ARMTOL_PPP, ARMTOL_PRISMATIC, .a = 0},
    {ARMTOL_NPR, ARMTOL_FIXED},
};

static void links_of(const armtol_errata *errata, armtol_link links[])
{
    memcpy(links, table, sizeof table);
    /* Erratum `half-turns`: base and tool turn, and the tool tilts, in this description only. */
    if (errata->half_turns) {
        links[0].theta = links[5].theta = pi_of(errata);
        links[5].alpha = pi_of(errata) / 2;
    }
    /* Erratum `adept-shift`: every length of a revolute link stands one link late. */
    if (errata->adept_shift) {
        links[3].a = links[2].a;
        links[2].a = links[1].a;
        links[1].a = 0;
    }
}

static void forward(const double q[], const armtol_errata *errata, double wish[])
{
    static const armtol_craig_link links[] = {
        {ARMTOL_FIXED, .d = BASE_HEIGHT},
        {ARMTOL_REVOLUTE},
        {ARMTOL_REVOLUTE, .a = INNER_LINK},
        {ARMTOL_REVOLUTE, .a = OUTER_LINK},
        {ARMTOL_PRISMATIC},
    };
    const armtol_transform tool = armtol_craig_chain(links, sizeof links / sizeof links[0], q, errata);
    for (int i = 0; i < 3; i++) {
        wish[i] = tool.m[i][3];
    }
    wish[3] = store(errata, angle_of(errata, tool.m[1][0], tool.m[0][0]));
}

/*
 * Method
 *    The elbow by the law of cosines, q2 = pi - acos(c) between 0 and pi; joint 1 by the difference of two angles; the
 *    other two are what is left.
 *
 * Special cases
 *    Out of reach where |c| > 1. Nothing is singular: where the arm is folded or stretched there is one answer.
 *
 * Accuracy
 *    Without errata the tool gets to the wish to 1e-7 mm and 1e-10 rad (test_the_adept_gets_where_it_should).
 */
static armtol_status inverse(const double wish[], const armtol_errata *errata, double q[],
                             armtol_reach *reach)
{
    const double x = wish[0], y = wish[1], z = wish[2], theta = wish[3];
    double solved[JOINTS];
    if (!all_finite(wish, WISH)) {
        return ARMTOL_NOT_FINITE;
    }
    *reach = (armtol_reach){length_of(x, y), fabs(INNER_LINK - OUTER_LINK), INNER_LINK + OUTER_LINK};
    const double c = store(errata, (INNER_LINK * INNER_LINK + OUTER_LINK * OUTER_LINK - x * x - y * y) /
                                       (2 * INNER_LINK * OUTER_LINK));
    if (!(fabs(c) <= 1)) {
        return ARMTOL_OUT_OF_REACH;
    }
    solved[1] = store(errata, pi_of(errata) - arc_cosine_of(errata, c));
    const double elbow_x = INNER_LINK + OUTER_LINK * cosine_of(errata, solved[1]);
    const double elbow_y = OUTER_LINK * sine_of(errata, solved[1]);
    solved[0] = store(errata, angle_of(errata, y, x) - angle_of(errata, elbow_y, elbow_x));
    solved[2] = store(errata, theta - solved[0] - solved[1]);
    solved[3] = store(errata, z - BASE_HEIGHT);
    if (!all_finite(solved, JOINTS)) {
        return ARMTOL_NOT_FINITE;
    }
    memcpy(q, solved, sizeof solved);
    return ARMTOL_OK;
}

const armtol_robot armtol_adept_one = {
    .name = "Adept AdeptOne",
    .n_links = LINKS,
    .n_joints = JOINTS,
    .n_wish = WISH,
    .links = links_of,
    .inverse = inverse,
    .forward = forward,
};

static const armtol_drive drives[LINKS] = {UNKNOWN, UNKNOWN, UNKNOWN, UNKNOWN, UNKNOWN, UNKNOWN};

const armtol_arm arm_adept_one = {
    .name = "adeptone",
    .title = "Adept AdeptOne",
    .source = "Hahn 1987, appendix, program adpta",
    .unit = ARMTOL_MILLIMETRE,
    .n_links = LINKS,
    .links = table,
    .drives = drives,
};
