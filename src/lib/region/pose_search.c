#include "lib/region/pose_search.h"

#include "lib/spread/splitmix.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { RESIDUALS = 6, STEPS = 30, HALVINGS = 24, MOST_PASSES = 300 };

bool pose_search_make(pose_search *search, const chain *chain, const armtol_region *region)
{
    const size_t n = chain->n_variables;
    *search = (pose_search){.chain = chain, .region = region, .state = 1987};
    search->box.links = calloc(chain->n_links, sizeof *search->box.links);
    search->at = calloc(CHAIN_DIRECTIONS + chain->n_links, sizeof *search->at);
    search->tried = calloc(n, sizeof *search->tried);
    search->moved = calloc(n, sizeof *search->moved);
    search->step = calloc(n, sizeof *search->step);
    search->jacobian = calloc(n, RESIDUALS * sizeof *search->jacobian);
    const bool space = corner_space_make(&search->space, chain, 1);
    return space && search->box.links != NULL && search->at != NULL && search->tried != NULL && search->moved != NULL &&
           search->step != NULL && search->jacobian != NULL;
}

void pose_search_free(pose_search *search)
{
    free(search->box.links);
    free(search->at);
    free(search->tried);
    free(search->moved);
    free(search->step);
    free(search->jacobian);
    corner_space_free(&search->space);
}

double pose_error(pose_search *search, const double variables[])
{
    corner_box_at(search->chain, variables, &search->box);
    return corners_largest(search->chain, &search->box, &search->space, search->at);
}

/* ---- into the region ---- */

static void place(pose_search *search, const double variables[], double point[3], double tool[3])
{
    corner_box_at(search->chain, variables, &search->box);
    corners_place(search->chain, &search->box, true, &search->space);
    const vectors *p = &search->space.points, *t = &search->space.tools;
    point[0] = p->x[0], point[1] = p->y[0], point[2] = p->z[0];
    tool[0] = t->x[0], tool[1] = t->y[0], tool[2] = t->z[0];
}

static double slack_of(const chain *chain)
{
    return 1e-9 * chain->reach;
}

bool pose_is_in_region(pose_search *search, const double variables[])
{
    double point[3], tool[3];
    if (!where_asks(search->region)) {
        return true;
    }
    place(search, variables, point, tool);
    return where_holds(search->region, point, tool, slack_of(search->chain));
}

/* The tool, its direction counted as a length by the reach. */
static void find(pose_search *search, const double variables[], double where[RESIDUALS])
{
    place(search, variables, where, where + 3);
    for (int i = 3; i < RESIDUALS; i++) {
        where[i] *= search->chain->reach;
    }
}

/* Where it is, and what is missing to the region; whether that is nothing. */
static bool miss_of(pose_search *search, const double variables[], double where[RESIDUALS], double miss[RESIDUALS])
{
    double point[3], tool[3], to_point[3], to_tool[3];
    place(search, variables, point, tool);
    if (where_holds(search->region, point, tool, slack_of(search->chain))) {
        return true;
    }
    where_nearest(search->region, point, tool, to_point, to_tool);
    for (int i = 0; i < 3; i++) {
        where[i] = point[i];
        where[i + 3] = search->chain->reach * tool[i];
        miss[i] = to_point[i] - point[i];
        miss[i + 3] = search->chain->reach * (to_tool[i] - tool[i]);
    }
    return false;
}

/* Differences are good enough for what is tested afterwards. */
static void differentiate(pose_search *search, const double variables[], const double where[RESIDUALS])
{
    const chain *chain = search->chain;
    memcpy(search->moved, variables, chain->n_variables * sizeof *search->moved);
    memset(search->jacobian, 0, RESIDUALS * chain->n_variables * sizeof *search->jacobian);
    for (size_t j = CHAIN_DIRECTIONS; j < chain->n_variables; j++) {
        const double step = 1e-6 * fmax(1, fabs(variables[j]));
        double there[RESIDUALS];
        if (!(chain->low[j] < chain->high[j])) {
            continue;
        }
        search->moved[j] = variables[j] + step;
        find(search, search->moved, there);
        search->moved[j] = variables[j];
        for (size_t i = 0; i < RESIDUALS; i++) {
            search->jacobian[RESIDUALS * j + i] = (there[i] - where[i]) / step;
        }
    }
}

void pose_levers(pose_search *search, const double variables[], double levers[])
{
    double where[RESIDUALS];
    const size_t counted = search->region->cone != NULL ? RESIDUALS : 3;
    find(search, variables, where);
    differentiate(search, variables, where);
    for (size_t j = 0; j < search->chain->n_variables; j++) {
        double square = 0;
        for (size_t i = 0; i < counted; i++) {
            const double part = j < CHAIN_DIRECTIONS ? 0 : search->jacobian[RESIDUALS * j + i];
            square += part * part;
        }
        levers[j] = sqrt(square);
    }
}

/* (J J' + damping) y = miss, by Gauss and Jordan: the matrix is positive definite. */
static void solve(const pose_search *search, const double miss[RESIDUALS], double y[RESIDUALS])
{
    double m[RESIDUALS][RESIDUALS + 1] = {{0}}, size = 0;
    for (size_t j = CHAIN_DIRECTIONS; j < search->chain->n_variables; j++) {
        const double *column = search->jacobian + RESIDUALS * j;
        for (size_t i = 0; i < RESIDUALS; i++) {
            for (size_t k = 0; k < RESIDUALS; k++) {
                m[i][k] += column[i] * column[k];
            }
            size += column[i] * column[i];
        }
    }
    for (size_t i = 0; i < RESIDUALS; i++) {
        m[i][i] += 1e-8 * size + 1e-300;
        m[i][RESIDUALS] = miss[i];
    }
    for (size_t i = 0; i < RESIDUALS; i++) {
        for (size_t r = 0; r < RESIDUALS; r++) {
            const double factor = r == i ? 0 : m[r][i] / m[i][i];
            for (size_t k = i; k <= RESIDUALS; k++) {
                m[r][k] -= factor * m[i][k];
            }
        }
    }
    for (size_t i = 0; i < RESIDUALS; i++) {
        y[i] = m[i][RESIDUALS] / m[i][i];
    }
}

static double clipped(const chain *chain, size_t j, double value)
{
    return fmax(chain->low[j], fmin(chain->high[j], value));
}

bool pose_into_region(pose_search *search, double variables[])
{
    const chain *chain = search->chain;
    if (!where_asks(search->region)) {
        return true;
    }
    for (int step = 0; step < STEPS; step++) {
        double where[RESIDUALS], miss[RESIDUALS], y[RESIDUALS];
        if (miss_of(search, variables, where, miss)) {
            return true;
        }
        differentiate(search, variables, where);
        solve(search, miss, y);
        for (size_t j = CHAIN_DIRECTIONS; j < chain->n_variables; j++) {
            double move = 0;
            for (size_t i = 0; i < RESIDUALS; i++) {
                move += search->jacobian[RESIDUALS * j + i] * y[i];
            }
            variables[j] = clipped(chain, j, variables[j] + move);
        }
    }
    return pose_is_in_region(search, variables);
}

/* In [0, 1). */
static double uniform(pose_search *search)
{
    search->state += SPLITMIX_STEP;
    return splitmix_uniform(search->state);
}

bool pose_draw(pose_search *search, double variables[])
{
    const chain *chain = search->chain;
    for (size_t j = 0; j < chain->n_variables; j++) {
        variables[j] = clipped(chain, j, chain->low[j] + uniform(search) * (chain->high[j] - chain->low[j]));
    }
    return pose_into_region(search, variables);
}

/* ---- to larger errors ---- */

/* A step of search->step, times the ranges' widths; back into the region where it leads out of it. */
static bool try_step(pose_search *search, double variables[], double times, double *best)
{
    const chain *chain = search->chain;
    bool moved = false;
    for (size_t j = 0; j < chain->n_variables; j++) {
        const double step = times * search->step[j] * (chain->high[j] - chain->low[j]);
        search->tried[j] = clipped(chain, j, variables[j] + step);
        moved = moved || search->tried[j] != variables[j];
    }
    if (!moved || !pose_into_region(search, search->tried)) {
        return false;
    }
    const double error = pose_error(search, search->tried);
    if (!(error > *best)) {
        return false;
    }
    memcpy(variables, search->tried, chain->n_variables * sizeof *variables);
    *best = error;
    return true;
}

static void along_one(pose_search *search, size_t j)
{
    memset(search->step, 0, search->chain->n_variables * sizeof *search->step);
    search->step[j] = 1;
}

/* The way on which the error grows fastest, of ranges as wide as each other; its largest part is 1. */
static void along_gradient(pose_search *search, double variables[])
{
    const chain *chain = search->chain;
    double most = 0;
    for (size_t j = 0; j < chain->n_variables; j++) {
        const double width = chain->high[j] - chain->low[j], kept = variables[j], step = 1e-6 * width;
        variables[j] = kept + step;
        search->step[j] = pose_error(search, variables);
        variables[j] = kept - step;
        search->step[j] -= pose_error(search, variables);
        variables[j] = kept;
        most = fmax(most, fabs(search->step[j]));
    }
    for (size_t j = 0; j < chain->n_variables && most > 0; j++) {
        search->step[j] /= most;
    }
}

static bool climb_once(pose_search *search, double variables[], double part, double *best)
{
    bool better = false;
    for (size_t j = 0; j < search->chain->n_variables; j++) {
        along_one(search, j);
        better = try_step(search, variables, part, best) || try_step(search, variables, -part, best) || better;
    }
    along_gradient(search, variables);
    return try_step(search, variables, part, best) || better;
}

double pose_climb(pose_search *search, double variables[])
{
    double best = pose_error(search, variables), part = 0.25;
    for (int halving = 0, pass = 0; halving < HALVINGS && pass < MOST_PASSES; pass++) {
        const double before = best;
        if (!climb_once(search, variables, part, &best) || best <= before * (1 + 1e-6)) {
            part /= 2;
            halving++;
        }
    }
    return best;
}

/* ---- to where a load does not hold the play ---- */

static double moment_at(pose_search *search, size_t which, double variables[], size_t j, double value)
{
    variables[j] = value;
    pose_error(search, variables);
    return search->space.loads.ranges[which].moment;
}

/* Between values with moments of either sign, by halving. What is left of it by rounding is 0 (load_sum.c). */
static bool bisect(pose_search *search, size_t which, double variables[], size_t j, double below, double above)
{
    double moment = 1;
    for (double last = above, middle = below; middle != last && moment != 0;) {
        last = middle;
        middle = below + (above - below) / 2;
        moment = moment_at(search, which, variables, j, middle);
        below = moment < 0 ? middle : below;
        above = moment > 0 ? middle : above;
    }
    return moment == 0;
}

bool pose_balance(pose_search *search, size_t which, const double range[], double variables[])
{
    const size_t n = search->chain->n_variables;
    for (size_t j = CHAIN_DIRECTIONS; j < n; j++) {
        const double kept = variables[j], low = range[j], high = range[n + j];
        const double at_low = moment_at(search, which, variables, j, low);
        const double at_high = moment_at(search, which, variables, j, high);
        if (at_low < 0 ? at_high > 0 : at_low > 0 && at_high < 0) {
            return bisect(search, which, variables, j, at_low < 0 ? low : high, at_low < 0 ? high : low);
        }
        variables[j] = kept;
    }
    return false;
}
