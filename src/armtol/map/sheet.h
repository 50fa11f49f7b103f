#ifndef ARMTOL_MAP_SHEET_H
#define ARMTOL_MAP_SHEET_H

#include "armtol/draw/scale.h"
#include "armtol/map/found.h"

#include <stdbool.h>
#include <stddef.h>

/* Where things lie in the picture of a map: the world is in the user's lengths, the sheet in pixels. */

/* A place of the drawn arm, from its base on; the joint whose axis goes through it. */
typedef struct station {
    double x, y;
    armtol_joint joint; /* ARMTOL_FIXED: none */
} station;

enum { SHEET_PLACES = SCALE_MOST + 2 };
#define SHEET_LEAST_ROOM 26.0

/* Where the signs below the plot are told, and how far apart. */
#define SHEET_LEGEND 60.0
#define SHEET_ENTRY 19.0

typedef struct sheet {
    const map_plan *plan;
    const map_found *found;
    const char *unit; /* of the values */
    char title[240];
    scale scale;      /* of the values, in the user's unit */
    double width, height;
    double left, top, right, bottom; /* of the plot */
    double view[4];                  /* least and largest of the world across, and upwards */
    double pixels;                   /* a unit of the world */
    station *stations;               /* the arm's; none where no point has a value */
    size_t n_stations;
    station *marks;                  /* where the poses of the command line have the tool, if that is in the plane */
    size_t n_marks;
    double places_x[SHEET_PLACES], places_y[SHEET_PLACES]; /* that have a label */
    size_t n_places;
} sheet;

/* False after a message where memory is short. */
bool sheet_make(sheet *sheet, const map_plan *plan, const map_found *found);
void sheet_free(sheet *sheet);

/* A place of the world, and one in steps of the grid from its first point. */
double sheet_world_x(const sheet *sheet, double x);
double sheet_world_y(const sheet *sheet, double y);
double sheet_x(const sheet *sheet, double steps);
double sheet_y(const sheet *sheet, double steps);

/*
 * How far a place is from all labels so far, from the border of the plot and from the arm: the least of them, in
 * pixels.
 */
double sheet_room(const sheet *sheet, double x, double y);
void sheet_take_place(sheet *sheet, double x, double y);

#endif
