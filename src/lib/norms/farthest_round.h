#ifndef ARMTOL_LIB_NORMS_FARTHEST_ROUND_H
#define ARMTOL_LIB_NORMS_FARTHEST_ROUND_H

#include "lib/private_names.h"

#include <stddef.h>

/* A disc as it is seen from a norm: all c one + s other with c^2 + s^2 <= 1. */
typedef struct ellipse {
    double one[3], other[3];
} ellipse;

/* The doubles of a workspace for so many generators and ellipses. */
size_t farthest_round_workspace(size_t count, size_t n_ellipses);

/*
 * The point farthest from the origin among all sums of `count` generators, each plus or minus, and of points of the
 * ellipses: never nearer than the farthest, and to 1e-12 of its distance (the source says where only to 3.1e-4). As
 * farthest_vertex otherwise. There is one ellipse at least; afterwards they are others, with the same sum.
 */
void farthest_round(const double generators[], size_t count, ellipse ellipses[], size_t n_ellipses, int flat,
                    double workspace[], double point[3]);

#endif
