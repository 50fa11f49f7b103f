/* The Intelledex from the wish to the wrist in the plane of links 3 and 4: every joint outside that plane. */

#include "lab/joint_orders/intelledex_steps.h"

#include "armtol/euler.h"
#include "lab/joint_orders/intelledex_matrices.h"
#include "lab/joint_orders/intelledex_storage.h"

#define BASE_HEIGHT 359.7
#define TOOL_LENGTH 100.0

void intelledex_find_t06(const configuration *how, const double wish[], progress *progress)
{
    const double height = constant(how, BASE_HEIGHT);
    progress->t06 = armtol_pose_to_transform(wish, &armtol_errata_1987);
    if (how->option[BASE] == BASE_SUBTRACTED) {
        progress->t06.m[2][3] = stored(wish[2] - height);
        return;
    }
    const armtol_transform base = matrix_of_link(how, 0, 0, height, 0), back = matrix_inverse(&base);
    progress->t06 = matrix_product(&back, &progress->t06);
}

/* ---- joints 6, 1 and 2, and T05 ---- */

static armtol_transform t05_written_out(const configuration *how, const armtol_transform *t06, double q6)
{
    const double c6 = sine(how, cos(q6)), s6 = sine(how, sin(q6)), tool = constant(how, TOOL_LENGTH);
    armtol_transform t05 = *t06;
    for (int i = 0; i < 3; i++) {
        const double *row = t06->m[i];
        t05.m[i][0] = stored(c6 * row[0] - s6 * row[1]);
        t05.m[i][1] = -row[2];
        t05.m[i][2] = stored(s6 * row[0] + c6 * row[1]);
        t05.m[i][3] = stored(row[3] - tool * row[2]);
    }
    return t05;
}

static armtol_transform t05_of(const configuration *how, const armtol_transform *t06, double q6)
{
    if (how->option[LAST_LINK] == LAST_LINK_WRITTEN) {
        return t05_written_out(how, t06, q6);
    }
    const armtol_transform link6 = matrix_of_link(how, 0, 1, constant(how, TOOL_LENGTH), q6);
    return matrix_without(t06, &link6);
}

void intelledex_aim(const configuration *how, double x, double y, double z, double q[])
{
    q[0] = stored(atan2(y, x));
    q[1] = stored(atan2(sine(how, cos(q[0])) * x + sine(how, sin(q[0])) * y, z));
}

static void find_q6_first(const configuration *how, progress *progress)
{
    const armtol_transform t60 = matrix_inverse(&progress->t06);
    progress->q[5] = stored(atan2(t60.m[1][3], -t60.m[0][3]));
    progress->t05 = t05_of(how, &progress->t06, progress->q[5]);
    intelledex_aim(how, progress->t05.m[0][2], progress->t05.m[1][2], progress->t05.m[2][2], progress->q);
}

/* The axis of joint 5 is square to the tool's axis and to the line from the shoulder to the tool. */
static void find_q1_first(const configuration *how, progress *progress)
{
    double *q = progress->q, normal[3];
    double(*t)[4] = progress->t06.m;
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        normal[i] = stored(t[j][2] * t[k][3] - t[k][2] * t[j][3]);
    }
    intelledex_aim(how, normal[0], normal[1], normal[2], q);
    const double c2 = sine(how, cos(q[1])), s2 = sine(how, sin(q[1]));
    const double x = sine(how, cos(q[0])) * s2, y = sine(how, sin(q[0])) * s2;
    q[5] = stored(atan2(x * t[0][0] + y * t[1][0] + c2 * t[2][0], x * t[0][1] + y * t[1][1] + c2 * t[2][1]));
    progress->t05 = t05_of(how, &progress->t06, q[5]);
}

void intelledex_find_q6_q1_q2(const configuration *how, const double wish[], progress *progress)
{
    (void)wish;
    if (how->option[ORDER] == ORDER_Q6_FIRST) {
        find_q6_first(how, progress);
    } else {
        find_q1_first(how, progress);
    }
}

/* ---- q345 and the wrist ---- */

/* A vector in the plane of links 3 and 4: along link 3 at q3 = 0, and square to it. */
typedef struct planar {
    double along, across;
} planar;

static planar written_out(const configuration *how, const double q[], double x, double y, double z)
{
    const double c1 = sine(how, cos(q[0])), s1 = sine(how, sin(q[0]));
    const double c2 = sine(how, cos(q[1])), s2 = sine(how, sin(q[1]));
    return (planar){c1 * c2 * x + s1 * c2 * y - s2 * z, -s1 * x + c1 * y};
}

/* A column of t. Links 1 and 2 divided out, the plane's axes are x and z of frame 2. */
static planar column_in_plane(const configuration *how, const double q[], const armtol_transform *t,
                              int column)
{
    if (how->option[PLANE] == PLANE_WRITTEN) {
        return written_out(how, q, t->m[0][column], t->m[1][column], t->m[2][column]);
    }
    const armtol_transform link1 = matrix_of_link(how, 0, 0, 0, q[0]);
    const armtol_transform link2 = matrix_of_link(how, 0, -1, 0, q[1]);
    const armtol_transform back1 = matrix_inverse(&link1), back2 = matrix_inverse(&link2);
    const armtol_transform in_frame1 = matrix_product(&back1, t);
    const armtol_transform in_frame2 = matrix_product(&back2, &in_frame1);
    return (planar){in_frame2.m[0][column], in_frame2.m[2][column]};
}

static planar tool_axis_of_euler(const configuration *how, const double wish[], const double q[])
{
    const double cg = sine(how, cos(wish[3])), sg = sine(how, sin(wish[3]));
    const double cb = sine(how, cos(wish[4])), sb = sine(how, sin(wish[4]));
    const double ca = sine(how, cos(wish[5])), sa = sine(how, sin(wish[5]));
    return written_out(how, q, ca * sb * cg + sa * sg, sa * sb * cg - ca * sg, cb * cg);
}

/* The tool's axis is a quarter turn behind the x axis of frame 5. */
static double q345_of(const configuration *how, const double wish[], const progress *progress)
{
    planar axis;
    switch (how->option[Q345]) {
    case Q345_X5:
        axis = column_in_plane(how, progress->q, &progress->t05, 0);
        return atan2(axis.across, axis.along);
    case Q345_Z6:
        axis = column_in_plane(how, progress->q, &progress->t06, 2);
        break;
    default:
        axis = tool_axis_of_euler(how, wish, progress->q);
    }
    return atan2(axis.along, -axis.across);
}

static planar wrist_of(const configuration *how, const progress *progress)
{
    const double tool = constant(how, TOOL_LENGTH);
    if (how->option[WRIST] == WRIST_T06) {
        const planar end = column_in_plane(how, progress->q, &progress->t06, 3);
        return (planar){end.along - tool * sine(how, sin(progress->q345)),
                        end.across + tool * sine(how, cos(progress->q345))};
    }
    armtol_transform wrist = how->option[WRIST] == WRIST_T05 ? progress->t05 : progress->t06;
    for (int i = 0; i < 3 && how->option[WRIST] != WRIST_T05; i++) {
        const double behind = keep(how->option[WRIST] == WRIST_MPYN1, -tool * wrist.m[i][2]);
        wrist.m[i][3] = stored(behind + wrist.m[i][3]);
    }
    return column_in_plane(how, progress->q, &wrist, 3);
}

void intelledex_find_wrist(const configuration *how, const double wish[], progress *progress)
{
    progress->q345 = angle(how, q345_of(how, wish, progress));
    const planar wrist = wrist_of(how, progress);
    progress->px = length(how, wrist.along);
    progress->py = length(how, wrist.across);
}
