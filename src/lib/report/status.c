#include "armtol/status.h"

#include <stddef.h>

const char *armtol_status_text(armtol_status status)
{
    static const char *const texts[ARMTOL_STATUS_COUNT] = {
        [ARMTOL_OK] = "no error",
        [ARMTOL_NO_LINKS] = "the chain has no links",
        [ARMTOL_BAD_KIND] = "a link is of no known kind",
        [ARMTOL_BAD_JOINT] = "a link's joint is neither fixed, revolute nor prismatic",
        [ARMTOL_NOT_FINITE] = "a value is not finite",
        [ARMTOL_WRONG_SIZE] = "an array's length does not fit the chain",
        [ARMTOL_OUT_OF_REACH] = "out of reach",
        [ARMTOL_SINGULAR] = "singular: infinitely many joint values lead there",
        [ARMTOL_BAD_TOLERANCE] = "a tolerance is not greater than zero",
        [ARMTOL_BAD_DELTA] = "delta is not between zero and the smallest linear tolerance",
        [ARMTOL_UNKNOWN_ERRATUM] = "no erratum has that name",
        [ARMTOL_BAD_WEIGHT] = "a weight is not greater than zero",
        [ARMTOL_BAD_AXIS] = "an axis has no direction or no joint that moves",
        [ARMTOL_NOT_SOLVED] = "the iteration did not converge",
        [ARMTOL_NO_MEMORY] = "out of memory",
        [ARMTOL_BAD_QUESTION] = "the question lacks something, or its method is not known",
        [ARMTOL_UNBOUNDED] = "the tolerances leave a component without a bound",
        [ARMTOL_BAD_LOAD] = "a mass, a drive or a compensated share is out of range, or nothing loads a compliance",
        [ARMTOL_BAD_RANGE] = "a tolerance's range is none, or none that this method keeps to",
        [ARMTOL_NOTHING_LEFT] = "what is given exceeds the accuracy by itself",
        [ARMTOL_BAD_NORM] = "a norm is not one of two or three lengths or angles, or this method has none",
        [ARMTOL_BAD_GRADE] = "no such grade; known are IT, H, h, JS and js with a number from 5 to 12",
        [ARMTOL_BAD_SPREAD] = "a distribution is none, or a group has unlike ones or what this method cannot share out",
    };
    const size_t index = (size_t)status;
    return index < ARMTOL_STATUS_COUNT ? texts[index] : "unknown status";
}
