#include "armtol/tell/branches.h"

#include "armtol/armtol.h"
#include "armtol/tell/json_arms.h"
#include "armtol/forms/wrap.h"
#include "console/number.h"

#include <stdio.h>

/* Joint values, one after the other, as they are typed. */
typedef void taker(void *context, double value);

static void each_joint(const at_wishes *at, const double q[], taker *take, void *context)
{
    for (size_t i = 0; i < at->arm->n_links; i++) {
        if (armtol_arm_is_driven(at->arm, i)) {
            take(context, units_typed(at->units, at->arm->links[i].joint == ARMTOL_PRISMATIC, *q++));
        }
    }
}

static const char *shortest(double value, number_text *text)
{
    return number_shortest(value, &armtol_errata_none, text);
}

/* ---- text ---- */

static void say_joint(void *context, double value)
{
    wrap_say(context, "%.6g", value);
}

static void print_text(const at_wishes *at, size_t number, const armtol_branches *branches)
{
    const typed_wish *wish = &at->wishes[number];
    wrap wrap;
    wrap_start(&wrap, stdout, 0, 4);
    wrap_say(&wrap, "position %zu:", number + 1);
    for (size_t i = 0; i < wish->n; i++) {
        wrap_say(&wrap, "%.9g", wish->value[i]);
    }
    wrap_say(&wrap, "(%zu branch%s)", branches->count, branches->count == 1 ? "" : "es");
    wrap_end(&wrap);
    for (size_t i = 0; i < branches->count; i++) {
        const armtol_branch *branch = &branches->branch[i];
        wrap_start(&wrap, stdout, 2, 6);
        wrap_say(&wrap, "%zu: joints", i + 1);
        each_joint(at, branch->q, say_joint, &wrap);
        wrap_say(&wrap, "(%.4g from near%s)", branch->from_near,
                 branch->own ? "; the arm's own inverse kinematics" : "");
        wrap_end(&wrap);
    }
}

/* ---- JSON ---- */

static void write_joint(void *context, double value)
{
    json_number(context, NULL, value);
}

static void write_off(json *json, const at_wishes *at, const armtol_branch *branch)
{
    json_number(json, "distance", units_shown(at->units, true, branch->distance));
    json_number(json, "angle", units_shown(at->units, false, branch->angle));
}

static void write_position(json *json, const at_wishes *at, size_t number, const armtol_branches *branches)
{
    json_open_object(json, NULL);
    json_numbers(json, "at", at->wishes[number].value, at->wishes[number].n);
    json_open_array(json, "branches");
    for (size_t i = 0; i < branches->count; i++) {
        const armtol_branch *branch = &branches->branch[i];
        json_open_object(json, NULL);
        json_open_array(json, "joints");
        each_joint(at, branch->q, write_joint, json);
        json_close_array(json);
        json_number(json, "from_near", branch->from_near);
        json_text(json, "inverse", branch->own ? "own" : "search");
        write_off(json, at, branch);
        json_close_object(json);
    }
    json_close_array(json);
    if (branches->count == 0 && branches->best.q != NULL) {
        json_open_object(json, "nearest");
        write_off(json, at, &branches->best);
        json_close_object(json);
    }
    json_close_object(json);
}

static void begin_json(json *json, const at_wishes *at)
{
    json_start(json, stdout);
    json_text(json, "armtol", armtol_version());
    json_open_object(json, "arm");
    json_text(json, "name", at->arm->name);
    json_text(json, "title", at->arm->title);
    json_close_object(json);
    json_units(json, at->units);
    json_open_array(json, "positions");
}

/* ---- CSV ---- */

static void print_cell(void *context, double value)
{
    (void)context;
    printf(",%s", shortest(value, &(number_text){""}));
}

static void print_rows(const at_wishes *at, size_t number, const armtol_branches *branches)
{
    for (size_t i = 0; i < branches->count; i++) {
        const armtol_branch *branch = &branches->branch[i];
        printf("%zu,%zu", number + 1, i + 1);
        each_joint(at, branch->q, print_cell, NULL);
        print_cell(NULL, branch->from_near);
        printf(",%s\n", branch->own ? "own" : "search");
    }
}

/* ---- all ---- */

static void begin(json *json, const at_wishes *at, output_format format)
{
    if (format == OUTPUT_JSON) {
        begin_json(json, at);
    } else if (format == OUTPUT_CSV) {
        printf("position,branch");
        for (size_t j = 0; j < armtol_arm_joint_count(at->arm); j++) {
            printf(",joint%zu", j + 1);
        }
        puts(",from_near,inverse");
    } else {
        wrap wrap;
        wrap_start(&wrap, stdout, 0, 0);
        wrap_say(&wrap, "%s, in %s and %s", at->arm->title, units_name(at->units, true), units_name(at->units, false));
        wrap_end(&wrap);
    }
}

bool branches_print(const at_wishes *at, output_format format)
{
    json json;
    bool fine = true;
    begin(&json, at, format);
    for (size_t i = 0; i < at->n; i++) {
        armtol_branches branches = {.count = 0};
        fine = at_find(at, i, &branches) && fine;
        if (format == OUTPUT_JSON) {
            write_position(&json, at, i, &branches);
        } else if (format == OUTPUT_CSV) {
            print_rows(at, i, &branches);
        } else {
            print_text(at, i, &branches);
        }
    }
    if (format == OUTPUT_JSON) {
        json_close_array(&json);
        json_end(&json);
    }
    return fine;
}
