#include "armtol/tell/laying.h"

#include "armtol/forms/wrap.h"

#include <stdio.h>

/* Room for a line about it. */
typedef struct line {
    char text[400];
} line;

/* "axes 2 and 3", "the base's z and axis 1", "the tool's z and axis 6"; joints are counted from 1. */
static const char *axes_text(size_t axis, size_t n_axes, char *room, size_t size)
{
    if (axis == 0) {
        return "the base's z axis and axis 1";
    }
    if (axis == n_axes) {
        snprintf(room, size, "axis %zu and the tool's z axis", n_axes);
    } else {
        snprintf(room, size, "axes %zu and %zu", axis, axis + 1);
    }
    return room;
}

static void say_farthest(const arm_laying *laying, const units *units, line *said)
{
    snprintf(said->text, sizeof said->text,
             "Laid anew: frames of the table lie up to %.6g %s off the arm (--as-is keeps them).",
             units_shown(units, true, laying->farthest), units_name(units, true));
}

static void say_snapped(const armtol_snapped *snapped, size_t n_axes, const units *units, line *said)
{
    char axes[80];
    snprintf(said->text, sizeof said->text, "Taken for exact (--snap): %s %s (but for %.3g %s and %.3g %s).",
             axes_text(snapped->axis, n_axes, axes, sizeof axes), armtol_relation_text(snapped->relation),
             units_shown(units, false, snapped->angle), units_name(units, false),
             units_shown(units, true, snapped->distance), units_name(units, true));
}

/* A comment of a table stays on its line. */
static void put_line(const line *said, const char *before)
{
    wrap wrap;
    if (*before != '\0') {
        printf("%s%s\n", before, said->text);
        return;
    }
    wrap_start(&wrap, stdout, 0, 0);
    wrap_say(&wrap, "%s", said->text);
    wrap_end(&wrap);
}

void laying_print(const arm_laying *laying, const units *units, const char *before)
{
    line said = {""};
    if (laying->farthest > 0) {
        say_farthest(laying, units, &said);
        put_line(&said, before);
    }
    for (size_t i = 0; i < laying->n_snapped; i++) {
        say_snapped(&laying->snapped[i], laying->n_axes, units, &said);
        put_line(&said, before);
    }
}

static void write_snapped(json *json, const armtol_snapped *snapped, const units *units)
{
    static const char *const names[ARMTOL_RELATION_COUNT] = {
        [ARMTOL_PARALLEL] = "parallel",
        [ARMTOL_COINCIDENT] = "coincident",
        [ARMTOL_MEETING] = "meeting",
        [ARMTOL_SAME_FRAME] = "same frame",
    };
    json_open_object(json, NULL);
    json_count(json, "axis", snapped->axis);
    json_text(json, "relation", names[snapped->relation]);
    json_number(json, "angle", units_shown(units, false, snapped->angle));
    json_number(json, "distance", units_shown(units, true, snapped->distance));
    json_close_object(json);
}

void laying_write(json *json, const arm_laying *laying, const units *units)
{
    if (laying->farthest == 0 && laying->n_snapped == 0) {
        return;
    }
    json_open_object(json, "laying");
    json_number(json, "farthest", units_shown(units, true, laying->farthest));
    json_open_array(json, "snapped");
    for (size_t i = 0; i < laying->n_snapped; i++) {
        write_snapped(json, &laying->snapped[i], units);
    }
    json_close_array(json);
    json_close_object(json);
}
