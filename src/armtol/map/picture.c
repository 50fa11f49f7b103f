/* The picture of a map: docs/maps.md says how to read it. */

#include "armtol/map/output.h"

#include "armtol/draw/contour.h"
#include "armtol/draw/ramp.h"
#include "armtol/draw/scale.h"
#include "armtol/draw/svg.h"

#include <math.h>
#include <string.h>

/* ---- colours ---- */

static void put_style(FILE *stream, const void *data)
{
    const sheet *sheet = data;
    for (size_t i = 0; i < sheet->scale.n_bands; i++) {
        fprintf(stream, "    .c%zu { fill: %s }\n", i, ramp_colour(i, sheet->scale.n_bands));
    }
    fputs("    .line { stroke: #111; stroke-width: 0.8 }"
          " .under { stroke: #fff; stroke-width: 2.4; stroke-opacity: 0.55 }\n"
          "    .wish { stroke: #111; stroke-width: 2.6 } .wishunder { stroke: #fff; stroke-width: 6 }\n"
          "    .edge { stroke: #c2185b; stroke-width: 1.8; stroke-dasharray: 5 3 }\n"
          "    .arm { stroke: #111; stroke-width: 3.2 } .armunder { stroke: #fff; stroke-width: 6.4 }\n"
          "    .joint { fill: #fff; stroke: #111; stroke-width: 1.6 }"
          " .tool { fill: #e5383b; stroke: #fff; stroke-width: 1.6 }\n",
          stream);
}

static void put_patterns(FILE *stream)
{
    fputs("  <defs>\n"
          "    <pattern id=\"out\" width=\"8\" height=\"8\" patternUnits=\"userSpaceOnUse\" "
          "patternTransform=\"rotate(45)\">"
          "<path class=\"sg\" d=\"M0 0V8\" stroke-width=\"3\"/></pattern>\n"
          "    <pattern id=\"free\" width=\"6\" height=\"6\" patternUnits=\"userSpaceOnUse\">"
          "<path class=\"sm\" d=\"M0 0L6 6M6 0L0 6\" stroke-width=\"0.7\"/></pattern>\n"
          "  </defs>\n", stream);
}

/* ---- cells ---- */

/* The corners of a point's cell: halfway to its neighbours. */
static void cell_of(const sheet *sheet, size_t k, double *left, double *top, double *right, double *bottom)
{
    const size_t *n = sheet->plan->n, i = k % n[0], j = k / n[0];
    *left = sheet_x(sheet, (double)i - 0.5);
    *right = sheet_x(sheet, (double)i + 0.5);
    *top = sheet_y(sheet, (double)j + 0.5);
    *bottom = sheet_y(sheet, (double)j - 0.5);
}

static void put_cell(FILE *stream, const sheet *sheet, size_t k)
{
    const map_plan *plan = sheet->plan;
    const double value = map_value_shown(plan, sheet->found->values[k]);
    double left, top, right, bottom, point[3];
    char class[16] = "free";
    if (!map_is_reached(sheet->found, k)) {
        return;
    }
    if (isfinite(value)) {
        snprintf(class, sizeof class, "c%zu", scale_band(&sheet->scale, value));
    }
    cell_of(sheet, k, &left, &top, &right, &bottom);
    map_plan_point(plan, k, point);
    fprintf(stream, "    <path class=\"%s\" d=\"M%s %sH%sV%sH%sz\"><title>%s %.6g, %s %.6g: ", class,
            svg_px(left, &(pixel){""}), svg_px(top, &(pixel){""}), svg_px(right, &(pixel){""}),
                svg_px(bottom, &(pixel){""}),
            svg_px(left, &(pixel){""}), map_axis_name(plan->right), map_place_shown(plan, point[plan->right]),
            map_axis_name(plan->up), map_place_shown(plan, point[plan->up]));
    if (isfinite(value)) {
        fprintf(stream, "%.5g %s</title></path>\n", value, sheet->unit);
    } else {
        fputs("no bound</title></path>\n", stream);
    }
}

static void put_cells(FILE *stream, const sheet *sheet)
{
    const size_t *n = sheet->plan->n;
    const double left = sheet_x(sheet, -0.5), right = sheet_x(sheet, (double)n[0] - 0.5);
    const double top = sheet_y(sheet, (double)n[1] - 0.5), bottom = sheet_y(sheet, -0.5);
    fputs("  <g style=\"fill: url(#out)\"><title>not reached</title>\n", stream);
    fprintf(stream, "    <rect x=\"%s\" y=\"%s\" width=\"%s\" height=\"%s\"/>\n  </g>\n", svg_px(left, &(pixel){""}),
            svg_px(top, &(pixel){""}), svg_px(right - left, &(pixel){""}), svg_px(bottom - top, &(pixel){""}));
    fputs("  <g shape-rendering=\"crispEdges\">\n", stream);
    for (size_t k = 0; k < map_plan_count(sheet->plan); k++) {
        put_cell(stream, sheet, k);
    }
    fputs("  </g>\n", stream);
}

/* Where two neighbours are reached by different branches: the side between their cells. */
static void put_branches(FILE *stream, const sheet *sheet)
{
    if (sheet->found->n_seams == 0) {
        return;
    }
    fputs("  <path class=\"edge\" d=\"", stream);
    for (size_t k = 0; k < map_plan_count(sheet->plan); k++) {
        double left, top, right, bottom;
        cell_of(sheet, k, &left, &top, &right, &bottom);
        if (map_is_seam_next(sheet->plan, sheet->found, k)) {
            fprintf(stream, "M%s %sV%s", svg_px(right, &(pixel){""}), svg_px(top, &(pixel){""}),
                    svg_px(bottom, &(pixel){""}));
        }
        if (map_is_seam_above(sheet->plan, sheet->found, k)) {
            fprintf(stream, "M%s %sH%s", svg_px(left, &(pixel){""}), svg_px(top, &(pixel){""}),
                    svg_px(right, &(pixel){""}));
        }
    }
    fputs("\"/>\n", stream);
}

/* ---- contours ---- */

static bool joins(const void *context, size_t point, bool above)
{
    const map_found *found = context;
    return (found->marks[point] & (above ? ARMTOL_MAP_JOINS_ABOVE : ARMTOL_MAP_JOINS_NEXT)) != 0;
}

typedef struct tracing {
    FILE *stream;
    sheet *sheet;
    double best, x, y; /* the place for the label: as far as can be from others and from the border */
} tracing;

static void put_piece(const piece *piece, void *context)
{
    const tracing *tracing = context;
    fprintf(tracing->stream, "M%s %sL%s %s", svg_px(sheet_x(tracing->sheet, piece->x[0]), &(pixel){""}),
            svg_px(sheet_y(tracing->sheet, piece->y[0]), &(pixel){""}),
            svg_px(sheet_x(tracing->sheet, piece->x[1]), &(pixel){""}),
            svg_px(sheet_y(tracing->sheet, piece->y[1]), &(pixel){""}));
}

static void judge_piece(const piece *piece, void *context)
{
    tracing *tracing = context;
    const double x = sheet_x(tracing->sheet, (piece->x[0] + piece->x[1]) / 2);
    const double y = sheet_y(tracing->sheet, (piece->y[0] + piece->y[1]) / 2);
    const double room = sheet_room(tracing->sheet, x, y);
    if (room > tracing->best) {
        tracing->best = room;
        tracing->x = x;
        tracing->y = y;
    }
}

static void put_path(tracing *tracing, const char *class, const field *field, double level)
{
    fprintf(tracing->stream, "  <path class=\"%s\" d=\"", class);
    contour_trace(field, level, put_piece, tracing);
    fputs("\"/>\n", tracing->stream);
}

static void put_contour(FILE *stream, sheet *sheet, double level, const char *under, const char *over, const char *text)
{
    const field field = {sheet->plan->n[0], sheet->plan->n[1], sheet->found->values, joins, sheet->found};
    tracing tracing = {stream, sheet, SHEET_LEAST_ROOM, 0, 0};
    contour_trace(&field, level, judge_piece, &tracing);
    put_path(&tracing, under, &field, level);
    put_path(&tracing, over, &field, level);
    if (tracing.best > SHEET_LEAST_ROOM) {
        svg_label(stream, "small halo", tracing.x, tracing.y + 4, "middle", text);
        sheet_take_place(sheet, tracing.x, tracing.y);
    }
}

/* From the user's unit to inside ones. */
static double inside(const sheet *sheet, double value)
{
    return units_taken(&sheet->plan->request->units, sheet->plan->is_length, value);
}

static void put_contours(FILE *stream, sheet *sheet)
{
    char text[40];
    if (!isnan(sheet->plan->wish)) {
        snprintf(text, sizeof text, "%.4g %s", map_value_shown(sheet->plan, sheet->plan->wish), sheet->unit);
        put_contour(stream, sheet, sheet->plan->wish, "wishunder", "wish", text);
    }
    for (size_t i = 1; i < sheet->scale.n_bands; i++) {
        const double wish = map_value_shown(sheet->plan, sheet->plan->wish), edge = sheet->scale.edges[i];
        if (fabs(wish - edge) <= 1e-9 * edge) {
            continue;
        }
        snprintf(text, sizeof text, "%.4g", edge);
        put_contour(stream, sheet, inside(sheet, sheet->scale.edges[i]), "under", "line", text);
    }
}

/* ---- the arm ---- */

static void put_arm_line(FILE *stream, const sheet *sheet, const char *class)
{
    fprintf(stream, "  <polyline class=\"%s\" points=\"", class);
    for (size_t i = 0; i < sheet->n_stations; i++) {
        fprintf(stream, "%s%s,%s", i > 0 ? " " : "", svg_px(sheet_world_x(sheet, sheet->stations[i].x), &(pixel){""}),
                svg_px(sheet_world_y(sheet, sheet->stations[i].y), &(pixel){""}));
    }
    fputs("\"/>\n", stream);
}

static void put_base(FILE *stream, const sheet *sheet)
{
    const double x = sheet_world_x(sheet, sheet->stations[0].x), y = sheet_world_y(sheet, sheet->stations[0].y);
    if (sheet->plan->up == 2) {
        fprintf(stream, "  <path class=\"joint\" d=\"M%s %sh22l-6 -9h-10z\" style=\"fill: #fff\"/>\n",
                svg_px(x - 11, &(pixel){""}), svg_px(y + 4, &(pixel){""}));
    } else {
        fprintf(stream, "  <rect class=\"joint\" x=\"%s\" y=\"%s\" width=\"18\" height=\"18\"/>\n",
                svg_px(x - 9, &(pixel){""}), svg_px(y - 9, &(pixel){""}));
    }
}

static void put_joint(FILE *stream, const sheet *sheet, const station *station)
{
    const double x = sheet_world_x(sheet, station->x), y = sheet_world_y(sheet, station->y);
    if (station->joint == ARMTOL_REVOLUTE) {
        fprintf(stream, "  <circle cx=\"%s\" cy=\"%s\" r=\"4.2\" "
                "style=\"fill: #fff; stroke: #111; stroke-width: 1.6\"/>\n",
                svg_px(x, &(pixel){""}), svg_px(y, &(pixel){""}));
    } else if (station->joint == ARMTOL_PRISMATIC) {
        fprintf(stream, "  <rect class=\"joint\" x=\"%s\" y=\"%s\" width=\"8\" height=\"8\"/>\n",
                svg_px(x - 4, &(pixel){""}), svg_px(y - 4, &(pixel){""}));
    }
}

static void put_arm(FILE *stream, const sheet *sheet)
{
    if (sheet->n_stations == 0) {
        return;
    }
    const station *tool = &sheet->stations[sheet->n_stations - 1];
    fputs("  <g><title>the arm, at scale</title>\n", stream);
    put_arm_line(stream, sheet, "armunder");
    put_base(stream, sheet);
    put_arm_line(stream, sheet, "arm");
    for (size_t i = 0; i < sheet->n_stations; i++) {
        put_joint(stream, sheet, &sheet->stations[i]);
    }
    fprintf(stream, "  <circle cx=\"%s\" cy=\"%s\" r=\"4.6\" "
            "style=\"fill: #e5383b; stroke: #fff; stroke-width: 1.6\"/>\n  </g>\n",
            svg_px(sheet_world_x(sheet, tool->x), &(pixel){""}), svg_px(sheet_world_y(sheet, tool->y), &(pixel){""}));
}

/* ---- the poses of the command line ---- */

static void put_cross(FILE *stream, double x, double y)
{
    const char *const classes[] = {"wishunder", "wish"};
    for (int i = 0; i < 2; i++) {
        fprintf(stream, "  <path class=\"%s\" d=\"M%s %sl10 10m0 -10l-10 10\"/>\n", classes[i],
                svg_px(x - 5, &(pixel){""}),
                svg_px(y - 5, &(pixel){""}));
    }
}

static void put_marks(FILE *stream, const sheet *sheet)
{
    for (size_t i = 0; i < sheet->n_marks; i++) {
        put_cross(stream, sheet_world_x(sheet, sheet->marks[i].x), sheet_world_y(sheet, sheet->marks[i].y));
    }
}

/* ---- around it ---- */

static void put_axes(FILE *stream, const sheet *sheet)
{
    const map_plan *plan = sheet->plan;
    const char *unit = units_name(&plan->request->units, true);
    char text[64];
    const double step_x = scale_step(sheet->view[1] - sheet->view[0], 8), step_y =
        scale_step(sheet->view[3] - sheet->view[2], 7);
    double x = scale_first(sheet->view[0], step_x), y = scale_first(sheet->view[2], step_y);
    while (x <= sheet->view[1]) {
        const double at = sheet_world_x(sheet, x);
        svg_line(stream, "sg", at, sheet->top, at, sheet->bottom);
        svg_line(stream, "sm", at, sheet->bottom, at, sheet->bottom + 4);
        snprintf(text, sizeof text, "%.6g", fabs(x) < step_x * 1e-6 ? 0 : x);
        svg_label(stream, "small f0", at, sheet->bottom + 17, "middle", text);
        x += step_x;
    }
    while (y <= sheet->view[3]) {
        const double at = sheet_world_y(sheet, y);
        svg_line(stream, "sg", sheet->left, at, sheet->right, at);
        svg_line(stream, "sm", sheet->left - 4, at, sheet->left, at);
        snprintf(text, sizeof text, "%.6g", fabs(y) < step_y * 1e-6 ? 0 : y);
        svg_label(stream, "small f0", sheet->left - 7, at + 4, "end", text);
        y += step_y;
    }
    snprintf(text, sizeof text, "%s, %s", map_axis_name(plan->right), unit);
    svg_label(stream, "f0", (sheet->left + sheet->right) / 2, sheet->bottom + 36, "middle", text);
    snprintf(text, sizeof text, "%s, %s", map_axis_name(plan->up), unit);
    svg_label_upwards(stream, "f0", sheet->left - 46, (sheet->top + sheet->bottom) / 2, text);
}

static void put_frame(FILE *stream, const sheet *sheet)
{
    fprintf(stream, "  <path class=\"sm\" d=\"M%s %sH%sV%sH%sz\"/>\n", svg_px(sheet->left, &(pixel){""}),
            svg_px(sheet->top, &(pixel){""}), svg_px(sheet->right, &(pixel){""}), svg_px(sheet->bottom, &(pixel){""}),
            svg_px(sheet->left, &(pixel){""}));
}

/* Bands of one height; the wish stands where it lies within its band. */
static void put_bar(FILE *stream, const sheet *sheet)
{
    const scale *scale = &sheet->scale;
    const double left = sheet->right + 26, width = 18, band =
        fmin((sheet->bottom - sheet->top - 24) / (double)scale->n_bands, 36);
    const double bottom = sheet->top + 24 + band * (double)scale->n_bands;
    char text[40];
    svg_label(stream, "small f0", left, sheet->top + 12, "start", sheet->unit);
    for (size_t i = 0; i < scale->n_bands; i++) {
        snprintf(text, sizeof text, "c%zu", i);
        svg_box(stream, text, left, bottom - band * (double)(i + 1), width, band);
    }
    for (size_t i = 0; i <= scale->n_bands && (scale->n_bands > 1 || i == 0); i++) {
        const double y = bottom - band * (scale->n_bands > 1 ? (double)i : 0.5);
        snprintf(text, sizeof text, "%.4g", scale->edges[i]);
        svg_line(stream, "sm", left + width, y, left + width + 4, y);
        svg_label(stream, "small f0", left + width + 8, y + 4, "start", text);
    }
    const double wish = map_value_shown(sheet->plan, sheet->plan->wish);
    if (scale->n_bands > 1 && wish >= scale->edges[0] && wish <= scale->edges[scale->n_bands]) {
        const size_t at = scale_band(scale, wish);
        const double share = (wish - scale->edges[at]) / (scale->edges[at + 1] - scale->edges[at]);
        const double y = bottom - band * ((double)at + share);
        svg_line(stream, "s0 w3", left - 6, y, left + width + 2, y);
    }
}

/* ---- what the signs mean ---- */

typedef struct legend {
    FILE *stream;
    double left, y;
} legend;

static void put_entry(legend *legend, const char *text)
{
    svg_label(legend->stream, "small f0", legend->left + 46, legend->y + 4, "start", text);
    legend->y += SHEET_ENTRY;
}

static void explain_arm(legend *legend, const sheet *sheet)
{
    const map_plan *plan = sheet->plan;
    char text[200];
    double point[3];
    const size_t worst = map_worst_point(plan, sheet->found);
    map_plan_point(plan, worst, point);
    svg_line(legend->stream, "armunder", legend->left, legend->y, legend->left + 34, legend->y);
    svg_line(legend->stream, "arm", legend->left, legend->y, legend->left + 34, legend->y);
    fprintf(legend->stream, "  <circle cx=\"%s\" cy=\"%s\" r=\"4.2\" "
            "style=\"fill: #e5383b; stroke: #fff; stroke-width: 1.6\"/>\n",
            svg_px(legend->left + 34, &(pixel){""}), svg_px(legend->y, &(pixel){""}));
    snprintf(text, sizeof text, "the arm, at scale, where the value is %s: %.4g %s at %s %.6g, %s %.6g",
             map_is_of_tolerances(plan) ? "least" : "largest", map_value_shown(plan, sheet->found->values[worst]),
                 sheet->unit,
             map_axis_name(plan->right), map_place_shown(plan, point[plan->right]), map_axis_name(plan->up),
             map_place_shown(plan, point[plan->up]));
    put_entry(legend, text);
}

static void explain_wish(legend *legend, const sheet *sheet)
{
    char text[80];
    svg_line(legend->stream, "wishunder", legend->left, legend->y, legend->left + 34, legend->y);
    svg_line(legend->stream, "wish", legend->left, legend->y, legend->left + 34, legend->y);
    const map_found *found = sheet->found;
    const double wish = sheet->plan->wish;
    const char *where = found->n_values == 0            ? ""
                        : wish < found->values[found->least] ? ": all values are above"
                        : wish > found->values[found->most]  ? ": all values are below" : "";
    snprintf(text, sizeof text, "%.4g %s, the wish%s", map_value_shown(sheet->plan, wish), sheet->unit, where);
    put_entry(legend, text);
}

static void explain_area(legend *legend, const char *pattern, const char *text)
{
    fprintf(legend->stream, "  <rect x=\"%s\" y=\"%s\" width=\"34\" height=\"13\" style=\"fill: url(#%s)\"/>\n",
            svg_px(legend->left, &(pixel){""}), svg_px(legend->y - 7, &(pixel){""}), pattern);
    put_entry(legend, text);
}

static void put_legend(FILE *stream, const sheet *sheet)
{
    const map_found *found = sheet->found;
    legend legend = {stream, sheet->left, sheet->bottom + SHEET_LEGEND};
    if (sheet->n_stations > 0) {
        explain_arm(&legend, sheet);
    }
    if (sheet->n_marks > 0) {
        put_cross(stream, legend.left + 17, legend.y);
        put_entry(&legend, sheet->n_marks == 1 ? "the pose that was given" : "the poses that were given");
    }
    if (!isnan(sheet->plan->wish)) {
        explain_wish(&legend, sheet);
    }
    if (found->n_reached < map_plan_count(sheet->plan)) {
        explain_area(&legend, "out", "not reached");
    }
    if (found->n_values < found->n_reached) {
        explain_area(&legend, "free", "no bound");
    }
    if (found->n_seams > 0) {
        svg_line(stream, "edge", legend.left, legend.y, legend.left + 34, legend.y);
        put_entry(&legend, "between these the arm has to change its branch");
    }
}

static void put_title(FILE *stream, const sheet *sheet)
{
    const map_plan *plan = sheet->plan;
    const map_found *found = sheet->found;
    char text[320];
    snprintf(text, sizeof text, "plane %s%s at %s = %.6g %s, %zu x %zu points, %zu reached, the tool's axes %s",
             map_axis_name(plan->right), map_axis_name(plan->up), map_axis_name(plan->third),
             map_place_shown(plan, plan->offset), units_name(&plan->request->units, true), plan->n[0], plan->n[1],
             found->n_reached, plan->keeps_axes ? "the same everywhere" : "free");
    svg_title(stream, sheet->width, sheet->title, text);
}

static void describe(const sheet *sheet, char text[], size_t size)
{
    const map_plan *plan = sheet->plan;
    const map_found *found = sheet->found;
    if (found->n_values == 0) {
        snprintf(text, size, "A map without a value.");
        return;
    }
    snprintf(text, size, "A map of %zu points, from %.4g to %.4g %s.", found->n_values,
             map_value_shown(plan, found->values[found->least]), map_value_shown(plan, found->values[found->most]),
             sheet->unit);
}

void map_write_svg(FILE *stream, const void *data)
{
    const map_findings *findings = data;
    sheet sheet = *findings->sheet; /* which labels take places on */
    char description[120];
    describe(&sheet, description, sizeof description);
    svg_start(stream, sheet.width, sheet.height, sheet.title, description, put_style, &sheet);
    put_patterns(stream);
    put_title(stream, &sheet);
    put_axes(stream, &sheet);
    put_cells(stream, &sheet);
    if (findings->found->n_values > 0) {
        put_contours(stream, &sheet);
        put_bar(stream, &sheet);
    }
    put_branches(stream, &sheet);
    put_arm(stream, &sheet);
    put_marks(stream, &sheet);
    put_frame(stream, &sheet);
    put_legend(stream, &sheet);
    svg_end(stream);
}
