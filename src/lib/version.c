#include "armtol/armtol.h"

/* ARMTOL_VERSION comes from the project() line of CMakeLists.txt, where the version stands. */
const char *armtol_version(void)
{
    return ARMTOL_VERSION;
}
