#include "armtol/tool_point.h"

const armtol_tool_point armtol_tool_origin = {{0, 0, 0}, ARMTOL_BASE_FRAME};
