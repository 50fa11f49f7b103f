#ifndef TEST_ONE_LINK_H
#define TEST_ONE_LINK_H

#include "armtol/engine/verification.h"

/* A link of length 400 along x that turns about z by errors within 0.004, and is in no other error. */
typedef struct one_link {
    armtol_link link;
    double matrix[6 * 4];
    double tolerances[4]; /* theta a alpha beta */
} one_link;

/* The task of drawing such arms, nothing asked of them; *one has to stay. */
verification_task one_link_task(one_link *one, uint64_t samples);

#endif
