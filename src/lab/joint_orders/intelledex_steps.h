#ifndef ARMTOL_LAB_JOINT_ORDERS_INTELLEDEX_STEPS_H
#define ARMTOL_LAB_JOINT_ORDERS_INTELLEDEX_STEPS_H

#include "lab/joint_orders/family.h"

#define INTELLEDEX_UPPER_ARM 373.4
#define INTELLEDEX_FOREARM 279.4

/* Each wants what those before it found: T06; q6, q1, q2 and T05; q345 and the wrist; all joints. */
void intelledex_find_t06(const configuration *how, const double wish[], progress *progress);
void intelledex_find_q6_q1_q2(const configuration *how, const double wish[], progress *progress);
void intelledex_find_wrist(const configuration *how, const double wish[], progress *progress);
void intelledex_find_q3_q4_q5(const configuration *how, const double wish[], progress *progress);

/* Joints 1 and 2, which bring the common axis of joints 3 to 5 to (x, y, z). */
void intelledex_aim(const configuration *how, double x, double y, double z, double q[]);

#endif
