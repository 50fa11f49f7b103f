#ifndef BENCH_TEXTBOOK_H
#define BENCH_TEXTBOOK_H

#include "armtol/bounds.h"

#include <stdint.h>

/*
 * What one would write by hand for the Intelledex 605T and nothing else, to hold the library against: scalar
 * loops, the arm's zeros and quarter turns folded into the code, sines and cosines from libm.
 */

/*
 * A for the tool's origin along the base's axes, and its bounds: six sines and cosines, axes, cross products,
 * norms.
 */
void textbook_pose(const double q[6], const double tolerances[6], double delta, double matrix[6][32],
                   armtol_bounds *bounds);

/* What the sampler's loop needs to know of a pose. */
typedef struct textbook_arm {
    double cosines[8], sines[8]; /* of theta as meant */
    double rotation[3][3];       /* of the tool as meant */
    double point[3];
    const double *tolerances; /* 32 */
    uint64_t key;             /* the seed, mixed */
} textbook_arm;

void textbook_arm_start(textbook_arm *arm, const double q[6], const double tolerances[32], uint64_t seed);

/*
 * The exact error of the tool of one arm drawn: 32 draws of splitmix64; the sines and cosines of errors of
 * angles by series of three terms, good for errors up to 0.01, and sums of angles; the chain; the rotation
 * vector with libm's atan2 and a root.
 */
void textbook_sample(const textbook_arm *arm, uint64_t number, double error[6]);

#endif
