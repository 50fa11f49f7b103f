#include "armtol/question.h"

const char *armtol_method_name(armtol_method method)
{
    static const char *const names[ARMTOL_METHOD_COUNT] = {"worst", "rss", "sphere"};
    return (size_t)method < ARMTOL_METHOD_COUNT ? names[method] : "?";
}

const char *armtol_component_name(size_t component)
{
    static const char *const names[6] = {"dx", "dy", "dz", "wx", "wy", "wz"};
    return component < 6 ? names[component] : "?";
}
