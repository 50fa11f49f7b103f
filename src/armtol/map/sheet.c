#include "armtol/map/sheet.h"

#include "armtol/link_transform.h"
#include "console/exit_code.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { LEFT = 76, TOP = 66, BESIDE = 128, PLOT_WIDTH = 640, PLOT_HEIGHT = 520, PLOT_LEAST = 120 };

/* ---- the arm ---- */

static double shown(const sheet *sheet, double length)
{
    return units_shown(&sheet->plan->request->units, true, length);
}

static void add_station(sheet *sheet, const armtol_transform *frame, double along_x, double along_z, armtol_joint joint)
{
    const size_t across = sheet->plan->right, up = sheet->plan->up;
    const double x = frame->m[across][3] + along_x * frame->m[across][0] + along_z * frame->m[across][2];
    const double y = frame->m[up][3] + along_x * frame->m[up][0] + along_z * frame->m[up][2];
    sheet->stations[sheet->n_stations++] = (station){shown(sheet, x), shown(sheet, y), joint};
}

/* Each link is its d along the axis before it, then its a across to the next. */
static void place_stations(sheet *sheet, const armtol_link links[], size_t n)
{
    armtol_transform frame = armtol_transform_identity();
    for (size_t i = 0; i < n; i++) {
        add_station(sheet, &frame, 0, 0, links[i].joint);
        add_station(sheet, &frame, 0, links[i].d, ARMTOL_FIXED);
        const armtol_transform step = armtol_link_transform(&links[i], &armtol_errata_none);
        frame = armtol_transform_product(&frame, &step, &armtol_errata_none);
    }
    add_station(sheet, &frame, 0, 0, ARMTOL_FIXED);
    armtol_tool_frame(links, n, &sheet->plan->request->question.tool, &frame);
    add_station(sheet, &frame, 0, 0, ARMTOL_FIXED);
}

/* A pose of the command line, from 0: whether it has the tool in the plane, to half a step, and where. */
static bool find_mark(const sheet *sheet, size_t pose, armtol_link links[], station *mark)
{
    const map_plan *plan = sheet->plan;
    const armtol_arm *arm = &plan->request->arm;
    const size_t n = armtol_arm_joint_count(arm);
    armtol_transform frame;
    double half = 0;
    if (armtol_arm_place(arm, plan->request->q + pose * n, n, links) != ARMTOL_OK) {
        return false;
    }
    armtol_tool_frame(links, arm->n_links, &plan->request->question.tool, &frame);
    const double places[2] = {frame.m[plan->right][3], frame.m[plan->up][3]};
    bool within = true;
    for (int d = 0; d < 2; d++) {
        const double step = (plan->last[d] - plan->first[d]) / (double)(plan->n[d] - 1);
        half = fmax(half, step / 2);
        within = within && places[d] >= plan->first[d] - step / 2 && places[d] <= plan->last[d] + step / 2;
    }
    *mark = (station){shown(sheet, places[0]), shown(sheet, places[1]), ARMTOL_FIXED};
    return within && fabs(frame.m[plan->third][3] - plan->offset) <= half;
}

static bool place_marks(sheet *sheet)
{
    const armtol_question *question = &sheet->plan->request->question;
    armtol_link *links = calloc(question->arm->n_links, sizeof *links);
    sheet->marks = calloc(question->n_poses + 1, sizeof *sheet->marks);
    const bool fine = links != NULL && sheet->marks != NULL;
    for (size_t pose = 0; fine && pose < question->n_poses; pose++) {
        sheet->n_marks += find_mark(sheet, pose, links, &sheet->marks[sheet->n_marks]);
    }
    free(links);
    return fine;
}

static bool place_arm(sheet *sheet)
{
    const armtol_arm *arm = &sheet->plan->request->arm;
    const size_t n = armtol_arm_joint_count(arm), worst = map_worst_point(sheet->plan, sheet->found);
    armtol_link *links = calloc(arm->n_links, sizeof *links);
    sheet->stations = calloc(2 * arm->n_links + 2, sizeof *sheet->stations);
    const bool fine = links != NULL && sheet->stations != NULL;
    if (fine && sheet->found->n_values > 0 &&
        armtol_arm_place(arm, sheet->found->q + worst * n, n, links) == ARMTOL_OK) {
        place_stations(sheet, links, arm->n_links);
    }
    free(links);
    return fine;
}

/* ---- what is seen, and how large ---- */

static void see(sheet *sheet, double x, double y)
{
    sheet->view[0] = fmin(sheet->view[0], x);
    sheet->view[1] = fmax(sheet->view[1], x);
    sheet->view[2] = fmin(sheet->view[2], y);
    sheet->view[3] = fmax(sheet->view[3], y);
}

/* Half a step beyond the points, and the whole arm. */
static void find_view(sheet *sheet)
{
    const map_plan *plan = sheet->plan;
    for (int d = 0; d < 2; d++) {
        const double half = (plan->last[d] - plan->first[d]) / (double)(plan->n[d] - 1) / 2;
        sheet->view[2 * d] = shown(sheet, plan->first[d] - half);
        sheet->view[2 * d + 1] = shown(sheet, plan->last[d] + half);
    }
    for (size_t i = 0; i < sheet->n_stations; i++) {
        see(sheet, sheet->stations[i].x, sheet->stations[i].y);
    }
    const double margin = 0.025 * fmax(sheet->view[1] - sheet->view[0], sheet->view[3] - sheet->view[2]);
    for (int d = 0; d < 2; d++) {
        sheet->view[2 * d] -= margin;
        sheet->view[2 * d + 1] += margin;
    }
}

static size_t entries_of(const sheet *sheet)
{
    const map_found *found = sheet->found;
    return (size_t)(sheet->n_stations > 0) + (size_t)(sheet->n_marks > 0) + (size_t)!isnan(sheet->plan->wish) +
           (size_t)(found->n_reached < map_plan_count(sheet->plan)) + (size_t)(found->n_values < found->n_reached) +
           (size_t)(found->n_seams > 0);
}

/* The same scale both ways; what is too flat or too narrow to be seen has some ground beside it. */
static void find_size(sheet *sheet)
{
    const double across = sheet->view[1] - sheet->view[0], up = sheet->view[3] - sheet->view[2];
    sheet->pixels = fmin(PLOT_WIDTH / across, PLOT_HEIGHT / up);
    const double sizes[2] = {across * sheet->pixels, up * sheet->pixels};
    for (int d = 0; d < 2; d++) {
        const double more = fmax(PLOT_LEAST - sizes[d], 0) / sheet->pixels / 2;
        sheet->view[2 * d] -= more;
        sheet->view[2 * d + 1] += more;
    }
    sheet->left = LEFT;
    sheet->top = TOP;
    sheet->right = LEFT + fmax(sizes[0], PLOT_LEAST);
    sheet->bottom = TOP + fmax(sizes[1], PLOT_LEAST);
    sheet->width = ceil(fmax(sheet->right + BESIDE, 620));
    sheet->height = ceil(sheet->bottom + SHEET_LEGEND + SHEET_ENTRY * (double)entries_of(sheet));
}

static void find_scale(sheet *sheet)
{
    const map_plan *plan = sheet->plan;
    const map_found *found = sheet->found;
    if (found->n_values > 0) {
        scale_make(&sheet->scale, map_value_shown(plan, found->values[found->least]),
                   map_value_shown(plan, found->values[found->most]));
    }
}

bool sheet_make(sheet *sheet, const map_plan *plan, const map_found *found)
{
    *sheet = (struct sheet){.plan = plan, .found = found, .unit = units_name(&plan->request->units, plan->is_length)};
    if (!place_arm(sheet) || !place_marks(sheet)) {
        out_of_memory();
        sheet_free(sheet);
        return false;
    }
    snprintf(sheet->title, sizeof sheet->title, "%.80s: %s", plan->request->arm.title,
             map_title_of(plan, &(map_title){""}));
    find_view(sheet);
    find_size(sheet);
    find_scale(sheet);
    return true;
}

void sheet_free(sheet *sheet)
{
    free(sheet->stations);
    free(sheet->marks);
}

/* ---- places ---- */

double sheet_world_x(const sheet *sheet, double x)
{
    return sheet->left + (x - sheet->view[0]) * sheet->pixels;
}

double sheet_world_y(const sheet *sheet, double y)
{
    return sheet->bottom - (y - sheet->view[2]) * sheet->pixels;
}

static double world(const sheet *sheet, int d, double steps)
{
    const map_plan *plan = sheet->plan;
    return shown(sheet, plan->first[d] + steps / (double)(plan->n[d] - 1) * (plan->last[d] - plan->first[d]));
}

double sheet_x(const sheet *sheet, double steps)
{
    return sheet_world_x(sheet, world(sheet, 0, steps));
}

double sheet_y(const sheet *sheet, double steps)
{
    return sheet_world_y(sheet, world(sheet, 1, steps));
}

static double distance(double x, double y)
{
    return sqrt(x * x + y * y);
}

/* How far a place is from the line of a link. */
static double from_link(const sheet *sheet, size_t i, double x, double y)
{
    const double x1 = sheet_world_x(sheet, sheet->stations[i].x), y1 = sheet_world_y(sheet, sheet->stations[i].y);
    const double along_x = sheet_world_x(sheet, sheet->stations[i + 1].x) - x1;
    const double along_y = sheet_world_y(sheet, sheet->stations[i + 1].y) - y1;
    const double square = along_x * along_x + along_y * along_y;
    const double share = square > 0 ? ((x - x1) * along_x + (y - y1) * along_y) / square : 0;
    const double at = fmin(fmax(share, 0), 1);
    return distance(x - x1 - at * along_x, y - y1 - at * along_y);
}

double sheet_room(const sheet *sheet, double x, double y)
{
    const map_plan *plan = sheet->plan;
    double room = fmin(fmin(x - sheet_x(sheet, 0), sheet_x(sheet, (double)plan->n[0] - 1) - x),
                       fmin(y - sheet_y(sheet, (double)plan->n[1] - 1), sheet_y(sheet, 0) - y) + 10);
    room = fmin(room + 12, 90);
    for (size_t i = 0; i < sheet->n_places; i++) {
        room = fmin(room, distance(x - sheet->places_x[i], y - sheet->places_y[i]));
    }
    for (size_t i = 0; i < sheet->n_marks; i++) {
        room = fmin(room, distance(x - sheet_world_x(sheet, sheet->marks[i].x),
                                   y - sheet_world_y(sheet, sheet->marks[i].y)));
    }
    for (size_t i = 0; i + 1 < sheet->n_stations; i++) {
        room = fmin(room, from_link(sheet, i, x, y) + 4);
    }
    return room;
}

void sheet_take_place(sheet *sheet, double x, double y)
{
    if (sheet->n_places < SHEET_PLACES) {
        sheet->places_x[sheet->n_places] = x;
        sheet->places_y[sheet->n_places++] = y;
    }
}
