#ifndef ARMTOL_MAP_PLAN_H
#define ARMTOL_MAP_PLAN_H

#include "armtol/ask/request.h"
#include "armtol/cluster/tally_form.h"
#include "armtol/map.h"

#include <stdbool.h>
#include <stddef.h>

/* So many points are a map at the most, and so many a picture with a tool tip for each. */
enum { MAP_MOST_POINTS = ROWS_MOST_POINTS, MAP_MOST_DRAWN = 40000 };

/* What of a map the command line says, in inside units. */
typedef struct map_plan {
    const request *request;
    size_t right, up, third; /* which coordinates lie to the right, upwards, and across the plane */
    double offset;           /* the third coordinate */
    double first[2], last[2];
    size_t n[2];             /* points to the right and upwards, two at least */
    armtol_map map;
    bool *columns;           /* the map's, where it is of tolerances */
    const char *of;          /* what it is of, as typed: position, dz, lengths */
    bool is_length;          /* the unit of its values */
    bool keeps_axes;         /* the tool has these axes everywhere; else they are free */
    double axes[3][3];
    double wish;             /* the value of which a contour is asked for; nan: none */
} map_plan;

/* EXIT_OK, or EXIT_WRONG after a message, or EXIT_FAILED; nothing is then to be freed. The request has to stay. */
int map_plan_make(map_plan *plan, const request *request);
void map_plan_free(map_plan *plan);

/* The number of points, and one of them in the arm's coordinates: k from 0, rows from below. */
size_t map_plan_count(const map_plan *plan);
void map_plan_point(const map_plan *plan, size_t k, double point[3]);

/* "x", "y" or "z". */
const char *map_axis_name(size_t axis);

/* A value, and a coordinate, as shown. */
double map_value_shown(const map_plan *plan, double value);
double map_place_shown(const map_plan *plan, double place);

/* "worst-case error of the position", for titles. */
typedef struct map_title {
    char text[120];
} map_title;
const char *map_title_of(const map_plan *plan, map_title *title);

#endif
