#ifndef ARMTOL_ARMTOL_H
#define ARMTOL_ARMTOL_H

/* Everything, in groups. The equations are those of Hahn 1987. */

/* What all the others mean: frames, units, storage; what can go wrong; where the programs differ from the report. */
#include "armtol/conventions.h"
#include "armtol/errata.h"
#include "armtol/interface.h"
#include "armtol/status.h"

/* Links and chains of them, Eqs (4.1) and (4.2); a small motion seen from another frame, Eq. (4.8). */
#include "armtol/link.h"
#include "armtol/link_transform.h"
#include "armtol/transform.h"
#include "armtol/twist_transform.h"

/* A, by which errors of the parameters move the tool: Eqs (4.9) and (4.11); lengths apart from angles, Eq. (4.23). */
#include "armtol/column_order.h"
#include "armtol/error_matrix.h"
#include "armtol/link_jacobian.h"

/* The bounds, Eqs (4.25) to (4.31); what they leave a shop, Eq. (4.32); what a drawing allows, Eqs (4.14) to (4.19);
   what workshops call tolerances. */
#include "armtol/bounds.h"
#include "armtol/drawing.h"
#include "armtol/grades.h"
#include "armtol/machining.h"
#include "armtol/seat.h"
#include "armtol/sphere.h"

/* Arms: built in, or from axes in space; what the inverse kinematics of 1987 is made of. */
#include "armtol/arm.h"
#include "armtol/axes.h"
#include "armtol/craig.h"
#include "armtol/euler.h"
#include "armtol/robots.h"
#include "armtol/solve.h"

/* The largest tolerances, which the report asks for and has a sphere in their place. */
#include "armtol/optimum.h"

/* The tool: any point of it, A and its bounds fast, the exact error and what A leaves out of it. */
#include "armtol/comparison.h"
#include "armtol/corners.h"
#include "armtol/loads.h"
#include "armtol/norm.h"
#include "armtol/poses.h"
#include "armtol/sampler.h"
#include "armtol/tool_error.h"
#include "armtol/tool_matrix.h"
#include "armtol/tool_point.h"

/* All of it at once: what armtol answers to a question, and how the answer is tried on arms drawn at random. */
#include "armtol/answer.h"
#include "armtol/arrivals.h"
#include "armtol/budget.h"
#include "armtol/map.h"
#include "armtol/question.h"
#include "armtol/share_interval.h"
#include "armtol/spread.h"
#include "armtol/tally.h"
#include "armtol/verification.h"
#include "armtol/region.h"

/* From where the tool should be to joint values, for any arm. */
#include "armtol/inverse.h"

ARMTOL_INTERFACE_BEGIN

/* The version of the library in use, "major.minor.patch". */
const char *armtol_version(void);

ARMTOL_INTERFACE_END

#endif
