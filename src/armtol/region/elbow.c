#include "armtol/region/items.h"

#include "armtol/link_transform.h"
#include "armtol/transform.h"
#include "console/exit_code.h"
#include "console/message.h"
#include "console/number.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/*
 * Two axes that are parallel, one joint's and the next joint's, and the tool end behind them, the joints after them
 * at 0: an arm of two links in a plane. It is stretched where the second joint's axis lies between the first and the
 * end.
 */

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double a[3], const double b[3], double made[3])
{
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        made[i] = a[j] * b[k] - a[k] * b[j];
    }
}

/* Origin and z of the frame that the links up to `count` end in. */
static void axis_behind(const armtol_link links[], size_t count, double origin[3], double z[3])
{
    armtol_transform frame = armtol_transform_identity();
    if (count > 0) {
        frame = armtol_chain_transform(links, count, &armtol_errata_none);
    }
    for (int i = 0; i < 3; i++) {
        origin[i] = frame.m[i][3];
        z[i] = frame.m[i][2];
    }
}

/* The value of the joint at which the arm is stretched; nan where that is not a question. */
static double stretched(const armtol_link links[], size_t n_links, size_t first, size_t second)
{
    double from[3], about[3], at[3], axis[3], end[3], unused[3], upper[3], fore[3], turn[3];
    axis_behind(links, first, from, about);
    axis_behind(links, second, at, axis);
    axis_behind(links, n_links, end, unused);
    for (int i = 0; i < 3; i++) {
        upper[i] = at[i] - from[i];
        fore[i] = end[i] - at[i];
    }
    const double along_upper = dot(upper, axis), along_fore = dot(fore, axis);
    const double size = sqrt(dot(upper, upper) + dot(fore, fore));
    for (int i = 0; i < 3; i++) {
        upper[i] -= along_upper * axis[i];
        fore[i] -= along_fore * axis[i];
    }
    cross(upper, fore, turn);
    const bool parallel = fabs(dot(about, axis)) > 1 - 1e-9;
    const bool both = sqrt(dot(upper, upper)) > 1e-9 * size && sqrt(dot(fore, fore)) > 1e-9 * size;
    return parallel && both ? -atan2(dot(turn, axis), dot(upper, fore)) : (double)NAN;
}

/* The link of the joint, and of the one before it; false where they do not both turn by themselves. */
static bool links_of(const armtol_arm *arm, uint64_t joint, size_t *first, size_t *second)
{
    *first = joint > 1 ? armtol_arm_link_of(arm, (size_t)joint - 2) : arm->n_links;
    *second = armtol_arm_link_of(arm, (size_t)joint - 1);
    return *first < arm->n_links && *second < arm->n_links && arm->links[*first].joint == ARMTOL_REVOLUTE &&
           arm->links[*second].joint == ARMTOL_REVOLUTE;
}

static double stretched_value(const armtol_arm *arm, uint64_t joint)
{
    const size_t n_joints = armtol_arm_joint_count(arm);
    size_t first, second;
    double value = (double)NAN;
    double *zero = calloc(n_joints, sizeof *zero);
    armtol_link *links = calloc(arm->n_links, sizeof *links);
    if (zero != NULL && links != NULL && links_of(arm, joint, &first, &second) &&
        armtol_arm_place(arm, zero, n_joints, links) == ARMTOL_OK) {
        value = stretched(links, arm->n_links, first, second) * (arm->motions != NULL ? arm->motions[second].sign : 1);
    }
    free(zero);
    free(links);
    return value;
}

bool region_elbow_take(const char *text, const armtol_arm *arm, region_words *words)
{
    char digits[16] = "";
    const size_t length = strlen(text);
    uint64_t joint = 0;
    memcpy(digits, text, length > 0 ? length - 1 : 0);
    const char sign = length > 0 ? text[length - 1] : '\0';
    if ((sign != '+' && sign != '-') || !whole_number_of(digits, 1, armtol_arm_joint_count(arm), &joint)) {
        message("--region: elbow: %s is none; expected a joint and a sign, as in 2+",
                message_quote(text, &(quoted){""}));
        return false;
    }
    const double at = stretched_value(arm, joint);
    if (isnan(at)) {
        message("--region: elbow: joint %s is no elbow: its axis and the one before it are not parallel, or the arm "
                "does not reach beyond it; expected a range of joints", digits);
        return false;
    }
    double *low = &words->low[joint - 1], *high = &words->high[joint - 1];
    *(sign == '+' ? low : high) = sign == '+' ? fmax(*low, at) : fmin(*high, at);
    if (*low > *high) {
        message("--region: elbow: no value of joint %s is on that side", digits);
    }
    return *low <= *high;
}
