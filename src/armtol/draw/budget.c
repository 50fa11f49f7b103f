#include "armtol/draw/budget.h"

#include "armtol/draw/svg.h"
#include "armtol/tell/findings.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

enum { LEFT = 176, TOP = 84, LENGTH = 560, ROW = 19, BAR = 15, GAP = 12, BESIDE = 76, BELOW = 40 };

typedef struct bars {
    FILE *stream;
    const findings *findings;
    const armtol_budget *budget;
    armtol_role roles[ARMTOL_ROLE_COUNT]; /* that have a bar in each component */
    size_t n_roles;
    double least, most; /* of the shares that are to be shown, 0 to 1 at the least */
} bars;

static double share_of(const armtol_budget_row *row, size_t i)
{
    return isnan(row->shares[i]) ? 0 : row->shares[i];
}

/* How far a bar reaches down and up: a load that takes off from others goes to the left of 0. */
static void reach(const armtol_budget *budget, size_t i, armtol_role role, double *down, double *up)
{
    *down = *up = 0;
    for (size_t r = 0; r < budget->n_rows; r++) {
        if (budget->rows[r].role == role) {
            *down += fmin(share_of(&budget->rows[r], i), 0);
            *up += fmax(share_of(&budget->rows[r], i), 0);
        }
    }
}

static bool has_role(const armtol_budget *budget, armtol_role role)
{
    bool any = false;
    for (size_t r = 0; r < budget->n_rows; r++) {
        any = any || budget->rows[r].role == role;
    }
    return any;
}

static bars bars_of(FILE *stream, const findings *findings)
{
    static const armtol_role order[] = {ARMTOL_MOTOR, ARMTOL_MACHINING, ARMTOL_LOAD, ARMTOL_SHIFT};
    bars bars = {.stream = stream, .findings = findings, .budget = findings->budget, .most = 1};
    for (size_t k = 0; k < sizeof order / sizeof order[0]; k++) {
        if (has_role(bars.budget, order[k])) {
            bars.roles[bars.n_roles++] = order[k];
        }
        for (size_t i = 0; i < 6; i++) {
            double down, up;
            reach(bars.budget, i, order[k], &down, &up);
            bars.least = fmin(bars.least, down);
            bars.most = fmax(bars.most, up);
        }
    }
    return bars;
}

static double at(const bars *bars, double share)
{
    return LEFT + LENGTH * (share - bars->least) / (bars->most - bars->least);
}

static double top_of(const bars *bars, size_t i, size_t role)
{
    return TOP + (double)i * ((double)bars->n_roles * ROW + GAP) + (double)role * ROW;
}

static void put_style(FILE *stream, const void *data)
{
    (void)data;
    fputs("    .motor { fill: #58a6d8 } .machining { fill: #f0b36b } .load { fill: #8fcf9f } .shift { fill: #d9a6d9 }\n"
          "    .part { stroke: #1f2328; stroke-width: 0.8 } .number { fill: #111; font-size: 11px }\n", stream);
}

static void put_part(const bars *bars, const armtol_budget_row *row, size_t i, double from, double to, double y)
{
    const double left = at(bars, fmin(from, to)), width = at(bars, fmax(from, to)) - left;
    char text[24];
    if (width < 0.05) {
        return;
    }
    fprintf(bars->stream, "  <rect class=\"%s part\" x=\"%s\" y=\"%s\" width=\"%s\" height=\"%d\"><title>",
            armtol_role_name(row->role),
            svg_px(left, &(pixel){""}), svg_px(y, &(pixel){""}), svg_px(width, &(pixel){""}), BAR);
    fprintf(bars->stream, "%s, %s of link %zu: %.1f %%</title></rect>\n", armtol_component_name(i),
            armtol_role_name(row->role),
            row->link, 100 * row->shares[i]);
    snprintf(text, sizeof text, "%zu", row->link);
    if (width > 7 * (double)strlen(text) + 3) {
        svg_label(bars->stream, "number", left + width / 2, y + BAR - 3.5, "middle", text);
    }
}

/* The parts one behind the other, from 0 to both sides. */
static void put_bar(const bars *bars, size_t i, size_t k)
{
    const armtol_role role = bars->roles[k];
    const double y = top_of(bars, i, k);
    double down = 0, up = 0;
    char text[40];
    svg_label(bars->stream, "small fm", LEFT - 8, y + BAR - 3.5, "end", armtol_role_name(role));
    for (size_t r = 0; r < bars->budget->n_rows; r++) {
        const armtol_budget_row *row = &bars->budget->rows[r];
        const double share = row->role == role ? share_of(row, i) : 0;
        double *end = share < 0 ? &down : &up;
        if (share != 0) {
            put_part(bars, row, i, *end, *end + share, y);
            *end += share;
        }
    }
    snprintf(text, sizeof text, "%.1f %%", 100 * (down + up));
    svg_label(bars->stream, "small f0", LEFT + LENGTH + 8, y + BAR - 3.5, "start", text);
}

static void put_component(const bars *bars, size_t i)
{
    const double y = top_of(bars, i, 0);
    const armtol_predicted *component = &bars->findings->answer->components[i];
    const double whole = bars->findings->answer->method == ARMTOL_METHOD_RSS
                             ? component->shift + bars->findings->answer->sigma * component->deviation
                                 : component->worst;
    char text[60];
    svg_label(bars->stream, "f0", 20, y + BAR - 3.5, "start", armtol_component_name(i));
    if (isnan(bars->budget->motors[i])) {
        svg_label(bars->stream, "small fm", LEFT, y + BAR - 3.5, "start", "without a bound");
        return;
    }
    snprintf(text, sizeof text, "%.3g %s", findings_shown(bars->findings, i, whole),
             units_name(&bars->findings->request->units, i < 3));
    svg_label(bars->stream, "small fm", 20, y + ROW + BAR - 3.5, "start", text);
    for (size_t k = 0; k < bars->n_roles; k++) {
        put_bar(bars, i, k);
    }
}

static void put_scale(const bars *bars, double bottom)
{
    for (int percent = -100; percent <= 200; percent += 25) {
        const double share = percent / 100.0;
        char text[16];
        if (share < bars->least || share > bars->most) {
            continue;
        }
        svg_line(bars->stream, percent == 0 ? "sm" : "sg", at(bars, share), TOP - 8, at(bars, share), bottom);
        snprintf(text, sizeof text, "%d %%", percent);
        svg_label(bars->stream, "small fm", at(bars, share), TOP - 14, "middle", text);
    }
}

void budget_write_svg(FILE *stream, const void *data)
{
    const findings *findings = data;
    const bars bars = bars_of(stream, findings);
    const double bottom = top_of(&bars, 6, 0) - GAP / 2.0;
    char title[200];
    snprintf(title, sizeof title, "%.80s: where the error comes from", findings->request->question.arm->title);
    svg_start(stream, LEFT + LENGTH + BESIDE, bottom + BELOW, title,
              "Bars: the share of each link in each component of the error, motors, making and loads apart.", put_style,
                  NULL);
    svg_title(stream, LEFT + LENGTH + BESIDE, title,
              findings->answer->method == ARMTOL_METHOD_RSS
                  ? "Shares of each component's load and deviations; parts have the number of their link"
                  : "Shares of each component's worst case; parts have the number of their link");
    put_scale(&bars, bottom);
    for (size_t i = 0; i < 6; i++) {
        put_component(&bars, i);
    }
    svg_end(stream);
}
