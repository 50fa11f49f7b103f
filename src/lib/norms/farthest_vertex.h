#ifndef ARMTOL_LIB_NORMS_FARTHEST_VERTEX_H
#define ARMTOL_LIB_NORMS_FARTHEST_VERTEX_H

#include "lib/private_names.h"

#include <stddef.h>

/* Where a direction that turns comes to lie across a generator. */
typedef struct crossing {
    double key;  /* grows with the angle */
    double sign; /* of the generator before */
    double generator; /* its number */
} crossing;

/*
 * The point farthest from the origin among all sums of count generators of three components, each plus or minus: the
 * farthest vertex of the zonotope that they span. None of them is 0, and the largest is about 1. Where component
 * `flat` of all of them is 0 they are in a plane; -1 where they are not. crossings has `count` places. With an
 * ellipsoid (farthest_ellipsoid.h: its squares; NULL: none) the farthest of all sums of a vertex and a point of it.
 */
void farthest_vertex(const double generators[], size_t count, int flat, const double (*ellipsoid)[3],
                     crossing crossings[], double vertex[3]);

#endif
