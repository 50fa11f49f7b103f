#ifndef ARMTOL_LAB_YIELD_FARTHEST_H
#define ARMTOL_LAB_YIELD_FARTHEST_H

#include "lab/yield/drawn_arm.h"

/*
 * From a corner of the box of tolerances to one from which no change of one sign takes the tool point farther
 * from where it should be (parameters as drawn take a sign where that helps). Returns that distance; errors
 * is where it ends.
 */
double farthest_from_corner(const drawn_arm *arm, const double tolerances[], double errors[]);

#endif
