#ifndef ARMTOL_ENGINE_PARTS_H
#define ARMTOL_ENGINE_PARTS_H

#include "armtol/engine/answer.h"

/*
 * What every link and joint has to keep to when the parameters keep to these tolerances. By method sphere as the report
 * has it: the distance of Eq. (4.32) for a and d both off by the share, whether the link counts them or not, and that
 * distance for the motor of a prismatic joint. Else a parameter that the link does not count is exact, and the motor
 * has the tolerance of the parameter that it moves.
 */
void parts_make(const request *request, const double tolerances[], part parts[]);

/*
 * How long the arm is when it is stretched: sum of sqrt(a^2 + d^2), the largest of all poses, and the tool's offset;
 * 1 for an arm without any length.
 */
double parts_lever(const posed_arm *posed);

#endif
