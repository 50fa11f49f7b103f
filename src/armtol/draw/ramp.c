#include "armtol/draw/ramp.h"

static const char *const colours[RAMP_COLOURS] = {
    "#440154", "#481a6c", "#472f7d", "#414487", "#39568c", "#31688e", "#2a788e", "#23888e",
    "#1f988b", "#22a884", "#35b779", "#54c568", "#7ad151", "#a5db36", "#d2e21b", "#fde725",
};

const char *ramp_colour(size_t i, size_t n)
{
    return n > 1 ? colours[(i * (RAMP_COLOURS - 1) + (n - 1) / 2) / (n - 1)] : colours[RAMP_COLOURS / 2];
}
