#include "armtol/axes.h"

#include "armtol/link_transform.h"
#include "armtol/transform.h"
#include "lib/arms/given_axes.h"
#include "lib/report/finite.h"

#include <math.h>

static armtol_axis axis_of_frame(const armtol_transform *frame, armtol_joint joint)
{
    armtol_axis axis = {.joint = joint};
    for (int i = 0; i < 3; i++) {
        axis.point[i] = frame->m[i][3];
        axis.direction[i] = frame->m[i][2];
    }
    return axis;
}

/* The z axes of rows; where `all`, also those of fixed links, which then count as revolute ones. */
static armtol_status find_axes(const armtol_link links[], size_t n_links, bool all, armtol_axis axes[], size_t *n_axes,
                               armtol_transform *tool)
{
    const armtol_status status = armtol_links_check(links, n_links);
    if (status != ARMTOL_OK) {
        return status;
    }
    *tool = armtol_transform_identity();
    *n_axes = 0;
    for (size_t i = 0; i < n_links; i++) {
        const bool fixed = links[i].joint == ARMTOL_FIXED;
        if (all || !fixed) {
            axes[(*n_axes)++] = axis_of_frame(tool, fixed ? ARMTOL_REVOLUTE : links[i].joint);
        }
        const armtol_transform own = armtol_link_transform(&links[i], &armtol_errata_none);
        *tool = armtol_transform_product(tool, &own, &armtol_errata_none);
    }
    bool finite = true;
    for (int i = 0; i < 3; i++) {
        finite = finite && all_finite(tool->m[i], 4);
    }
    return finite ? ARMTOL_OK : ARMTOL_NOT_FINITE;
}

armtol_status armtol_axes_of_links(const armtol_link links[], size_t n_links, armtol_axis axes[], size_t *n_axes,
                                   armtol_transform *tool)
{
    return find_axes(links, n_links, false, axes, n_axes, tool);
}

armtol_spread armtol_spread_of_axes(const armtol_axis axes[], size_t n_axes, const armtol_transform *tool)
{
    const given_axes given = given_axes_of(axes, n_axes, tool);
    armtol_spread spread = {.reach = given.base_reach};
    for (size_t i = 0; i < n_axes; i++) {
        if (axes[i].joint != ARMTOL_PRISMATIC) {
            spread.farthest = fmax(spread.farthest, axis_distance_from_place(&given, i));
        }
    }
    return spread;
}

/* ---- kinds ---- */

/* The next row's axis, seen from the row's frame. */
static axis_line next_line(const given_axes *given, const armtol_link links[], size_t row)
{
    axis_line line = axis_line_of(given, row + 1);
    armtol_transform frame = armtol_chain_transform(links, row, &armtol_errata_none);
    line = axis_line_seen(&frame, &line);
    if (links[row].joint == ARMTOL_PRISMATIC) {
        line.place[0] = line.place[1] = 0;
    }
    return line;
}

/* Whether the row is the last joint's and its d, where it has one, is the length of the tool. */
static bool carries_tool(const armtol_link links[], size_t n_links, size_t row)
{
    const armtol_link *link = &links[row];
    return link->joint == ARMTOL_REVOLUTE && armtol_joint_count(link, n_links - row) == 1 &&
           link->beta == 0 && (link->a == 0 || link->d != 0);
}

static armtol_kind kind_of_row(const given_axes *given, const armtol_link links[], size_t row)
{
    const armtol_joint joint = links[row].joint;
    if (joint == ARMTOL_FIXED || carries_tool(links, given->n_axes, row)) {
        return ARMTOL_NPR;
    }
    const axis_line line = next_line(given, links, row);
    return axis_kind(joint, links[row].beta != 0 || !axis_is_crossing(given, joint, row + 1, &line));
}

armtol_status armtol_kinds_of_links(const armtol_link links[], size_t n_links, armtol_axis rows[], armtol_kind kinds[])
{
    size_t n_rows;
    armtol_transform tool;
    const armtol_status status = find_axes(links, n_links, true, rows, &n_rows, &tool);
    if (status != ARMTOL_OK) {
        return status;
    }
    const given_axes given = given_axes_of(rows, n_rows, &tool);
    for (size_t i = 0; i < n_links; i++) {
        kinds[i] = kind_of_row(&given, links, i);
    }
    return ARMTOL_OK;
}
