#ifndef TEST_DRAWN_H
#define TEST_DRAWN_H

#include "armtol/inverse.h"
#include "support/random.h"

enum { MOST_JOINTS = 16, MOST_LINKS = 16 };

/* Joint values uniform in the limits of an arm; where they are not known, in a turn, or 100 to 300 for a slide. */
void draw_posture(random_source *random, const armtol_arm *arm, double q[]);

/* Where they bring the last frame: Eq. (4.1) in long double, which shares nothing with the library (reference.h). */
armtol_transform tool_at(const armtol_arm *arm, const double q[]);

/* How far two tools are apart: lengths, and the largest difference of two elements of the axes, as an angle. */
double distance_between(const armtol_transform *one, const armtol_transform *other);
double turn_between(const armtol_transform *one, const armtol_transform *other);

#endif
