#include "lib/inverse/chain.h"

#include "lib/tool/built.h"

#define LANES 1
#include "lib/lanes/sincos.h"

/* Rot(z, theta) Trans(a, 0, d) Rot(x, alpha) Rot(y, beta), Eq. (4.1). */
static void link_rows(const chain_link *link, double value, double rows[3][4])
{
    const double theta = link->joint == ARMTOL_REVOLUTE ? link->theta + value : link->theta;
    const double sa = link->sin_alpha, ca = link->cos_alpha, sb = link->sin_beta, cb = link->cos_beta;
    double st, ct;
    sine_cosine(&theta, &st, &ct);
    const double made[3][4] = {
        {ct * cb - st * sa * sb, -st * ca, ct * sb + st * sa * cb, link->a * ct},
        {st * cb + ct * sa * sb, ct * ca, st * sb - ct * sa * cb, link->a * st},
        {-ca * sb, sa, ca * cb, link->joint == ARMTOL_PRISMATIC ? link->d + value : link->d},
    };
    memcpy(rows, made, sizeof made);
}

/* frame times the rows. */
static void append(armtol_transform *frame, double rows[3][4])
{
    for (int i = 0; i < 3; i++) {
        const double x = frame->m[i][0], y = frame->m[i][1], z = frame->m[i][2];
        for (int j = 0; j < 4; j++) {
            frame->m[i][j] = x * rows[0][j] + y * rows[1][j] + z * rows[2][j] + (j == 3 ? frame->m[i][3] : 0);
        }
    }
}

void chain_place(const chain *chain, const double q[], armtol_transform *tool)
{
    double rows[3][4];
    *tool = (armtol_transform){{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
    for (size_t i = 0; i < chain->n_links; i++) {
        const chain_link *link = &chain->links[i];
        const double value = link->joint == ARMTOL_FIXED ? 0 : link->factor * q[link->driver] + link->offset;
        for (int k = 0; k < 3; k++) {
            chain->axes[6 * i + (size_t)k] = tool->m[k][2];
            chain->axes[6 * i + 3 + (size_t)k] = tool->m[k][3];
        }
        link_rows(link, value, rows);
        append(tool, rows);
    }
    for (int i = 0; i < 3; i++) {
        tool->m[i][3] += tool->m[i][0] * chain->offset[0] + tool->m[i][1] * chain->offset[1] +
                         tool->m[i][2] * chain->offset[2];
    }
}

void chain_compare(const chain *chain, const chain_goal *goal, const armtol_transform *tool, chain_error *error)
{
    static const armtol_tool_point origin = {{0, 0, 0}, ARMTOL_BASE_FRAME};
    if (goal->n_rows == 6) {
        built_error(&goal->wish->tool, tool, &origin, error->e);
    } else {
        for (int i = 0; i < 3; i++) {
            error->e[i] = goal->wish->tool.m[i][3] - tool->m[i][3];
        }
    }
    error->square = 0;
    for (size_t i = 0; i < goal->n_rows; i++) {
        error->e[i] = i < 3 ? error->e[i] / chain->size : error->e[i];
        error->square += error->e[i] * error->e[i];
    }
}

/* What a unit of a link's joint does to the tool, times `scale`, added to the column of what drives it. */
static void add_column(const chain *chain, const armtol_transform *tool, size_t i, double scale)
{
    const chain_link *link = &chain->links[i];
    const double *z = chain->axes + 6 * i, *origin = z + 3;
    double column[6] = {z[0], z[1], z[2], 0, 0, 0};
    if (link->joint == ARMTOL_REVOLUTE) {
        const double arm[3] = {tool->m[0][3] - origin[0], tool->m[1][3] - origin[1], tool->m[2][3] - origin[2]};
        for (int k = 0; k < 3; k++) {
            const int next = (k + 1) % 3, last = (k + 2) % 3;
            column[k] = z[next] * arm[last] - z[last] * arm[next];
            column[3 + k] = z[k];
        }
    }
    for (size_t k = 0; k < 6; k++) {
        chain->jacobian[k * chain->n_joints + link->driver] += scale * (k < 3 ? column[k] / chain->size : column[k]);
    }
}

void chain_differentiate(const chain *chain, const armtol_transform *tool)
{
    for (size_t k = 0; k < 6 * chain->n_joints; k++) {
        chain->jacobian[k] = 0;
    }
    for (size_t i = 0; i < chain->n_links; i++) {
        const chain_link *link = &chain->links[i];
        if (link->joint != ARMTOL_FIXED) {
            add_column(chain, tool, i, link->factor * chain->joints[link->driver].unit);
        }
    }
}
