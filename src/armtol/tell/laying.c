#include "armtol/tell/laying.h"

#include <stdio.h>

/* "axes 2 and 3", "the base's z and axis 1", "the tool's z and axis 6"; joints are counted from 1. */
static void print_axes(size_t axis, size_t n_axes)
{
    if (axis == 0) {
        printf("the base's z axis and axis 1");
    } else if (axis == n_axes) {
        printf("axis %zu and the tool's z axis", n_axes);
    } else {
        printf("axes %zu and %zu", axis, axis + 1);
    }
}

static void print_snapped(const armtol_snapped *snapped, size_t n_axes, const units *units)
{
    print_axes(snapped->axis, n_axes);
    printf(" %s (but for %.3g %s and %.3g %s)", armtol_relation_text(snapped->relation),
           units_shown(units, false, snapped->angle), units_name(units, false),
           units_shown(units, true, snapped->distance), units_name(units, true));
}

void laying_print(const arm_laying *laying, const units *units, const char *before)
{
    if (laying->farthest > 0) {
        printf("%sLaid anew: frames of the table lie up to %.6g %s off the arm (--as-is keeps them).\n", before,
               units_shown(units, true, laying->farthest), units_name(units, true));
    }
    for (size_t i = 0; i < laying->n_snapped; i++) {
        printf("%sTaken for exact (--snap): ", before);
        print_snapped(&laying->snapped[i], laying->n_axes, units);
        printf(".\n");
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
