#ifndef ARMTOL_LIB_TOOL_NEGLIGIBLE_H
#define ARMTOL_LIB_TOOL_NEGLIGIBLE_H

/* Of what an element of A can be in an arm: up to this part it is taken for what rounding left of a 0 (rounding.c). */
static const double negligible = 1e-12;

#endif
