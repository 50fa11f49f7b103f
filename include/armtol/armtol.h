#ifndef ARMTOL_ARMTOL_H
#define ARMTOL_ARMTOL_H

/* Everything. conventions.h first: the frames, units and storage that all the others mean. */

#include "armtol/conventions.h"
#include "armtol/errata.h"
#include "armtol/status.h"

#include "armtol/bounds.h"
#include "armtol/column_order.h"
#include "armtol/error_matrix.h"
#include "armtol/link.h"
#include "armtol/link_jacobian.h"
#include "armtol/link_transform.h"
#include "armtol/machining.h"
#include "armtol/twist_transform.h"

#include "armtol/arm.h"
#include "armtol/axes.h"
#include "armtol/corners.h"
#include "armtol/optimum.h"
#include "armtol/poses.h"
#include "armtol/sampler.h"
#include "armtol/sphere.h"
#include "armtol/tool_error.h"
#include "armtol/tool_matrix.h"
#include "armtol/tool_point.h"

#include "armtol/answer.h"
#include "armtol/budget.h"
#include "armtol/question.h"
#include "armtol/share_interval.h"
#include "armtol/verification.h"

#include "armtol/craig.h"
#include "armtol/euler.h"
#include "armtol/interface.h"
#include "armtol/robots.h"
#include "armtol/solve.h"
#include "armtol/transform.h"

ARMTOL_INTERFACE_BEGIN

/* The version of the library in use, "major.minor.patch". */
const char *armtol_version(void);

ARMTOL_INTERFACE_END

#endif
