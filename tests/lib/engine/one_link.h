#ifndef TEST_ONE_LINK_H
#define TEST_ONE_LINK_H

#include "armtol/verification.h"

/* A link of length 400 along x that turns about z by errors within 0.004, and is in no other error. */
typedef struct one_link {
    armtol_link link;
    armtol_drive drive;
    armtol_arm arm;
    double q[2];
    double tolerances[4]; /* theta a alpha beta */
    armtol_question question;
    armtol_draw draw;
} one_link;

/*
 * The tolerances given, nothing asked of them, one pose; that many arms to be drawn, on one thread. *one has to stay.
 */
void one_link_make(one_link *one, uint64_t samples);

#endif
