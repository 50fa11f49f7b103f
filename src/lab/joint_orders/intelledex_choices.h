#ifndef ARMTOL_LAB_JOINT_ORDERS_INTELLEDEX_CHOICES_H
#define ARMTOL_LAB_JOINT_ORDERS_INTELLEDEX_CHOICES_H

#include "lab/joint_orders/family.h"

/* The choices of the Intelledex's family, by the step that first looks at them, and the options of each. */

enum {
    BASE, CONSTANTS,                      /* step 0 */
    ORDER, LAST_LINK, RIGHT_ANGLE, SINES, /* step 1 */
    PLANE, Q345, WRIST, ANGLES, LENGTHS,  /* step 2 */
    ELBOW, BRANCH, ROOT, D, LAST,         /* step 3 */
    CHOICES
};

enum { STORED, NOT_STORED }; /* of angles, lengths, the root */

enum { SINES_DOUBLE, SINES_FLOAT };
enum { BASE_INVERSE, BASE_SUBTRACTED };
enum { CONSTANTS_DOUBLE, CONSTANTS_FLOAT };
enum { ORDER_Q6_FIRST, ORDER_Q1_FIRST };
enum { LAST_LINK_MATRIX, LAST_LINK_WRITTEN };
enum { RIGHT_ANGLE_FLOAT, RIGHT_ANGLE_DOUBLE };
enum { PLANE_WRITTEN, PLANE_DIVIDED };
enum { Q345_X5, Q345_Z6, Q345_EULER };
enum { WRIST_T06, WRIST_T05, WRIST_AXIS, WRIST_MPYN1 };
enum { ELBOW_Q5_SOLVE, ELBOW_Q3_SOLVE, ELBOW_Q4_ATAN2, ELBOW_Q4_ACOS, ELBOW_Q4_PI_ACOS, ELBOW_CHAIN };
enum { BRANCH_OWN, BRANCH_Q5 };
enum { D_DOUBLE, D_FLOAT };
enum { LAST_SUM, LAST_DIFFERENCE };

extern const choice intelledex_choices[CHOICES];

/* family.matters, family.makes_sense */
bool intelledex_matters(const configuration *how, size_t choice);
bool intelledex_makes_sense(const configuration *how);

#endif
