/* Regions, by what armtol reads them with. */

#include "armtol/region/region_words.h"
#include "console/exit_code.h"
#include "python/binding.h"

#include <stdlib.h>

struct binding_region {
    region_words words;
};

binding_region *binding_region_read(const armtol_arm *arm, const char *text, bool ignore_limits)
{
    binding_region *region = calloc(1, sizeof *region);
    const units units = {.arm = arm->unit, .length = arm->unit, .angle = UNIT_RADIAN};
    if (region == NULL) {
        out_of_memory();
        return NULL;
    }
    if (!region_words_take(text, arm, &units, ignore_limits, &region->words)) {
        binding_region_free(region);
        return NULL;
    }
    return region;
}

const armtol_region *binding_region_of(const binding_region *region)
{
    return &region->words.region;
}

void binding_region_free(binding_region *region)
{
    if (region != NULL) {
        region_words_free(&region->words);
        free(region);
    }
}
