/*
 * Regions, as words and as files. The first byte says which arm, whether limits are set aside, and which of the two.
 * What is taken has ranges that are none upside down and shapes that the library takes; what is not is told in one
 * message.
 */

#include "fuzz/harness.h"
#include "fuzz/require.h"

#include "armtol/region/region_words.h"

#include <math.h>
#include <string.h>

enum { MOST_BYTES = 4096 };

static const units inside = {ARMTOL_MILLIMETRE, ARMTOL_MILLIMETRE, UNIT_DEGREE};

static void check_words(const armtol_arm *arm, const region_words *words)
{
    const armtol_region *region = &words->region;
    const size_t n = armtol_arm_joint_count(arm);
    for (size_t j = 0; j < n; j++) {
        REQUIRE(isfinite(region->low[j]) && isfinite(region->high[j]) && region->low[j] <= region->high[j]);
    }
    for (int i = 0; region->block != NULL && i < 3; i++) {
        REQUIRE(region->block->low[i] <= region->block->high[i]);
    }
    REQUIRE(region->ring == NULL || (region->ring->inner >= 0 && region->ring->inner <= region->ring->outer));
    REQUIRE(region->path == NULL || (region->path->n_points > 0 && region->path->radius >= 0));
    REQUIRE(region->cone == NULL || region->cone->angle >= 0);
}

int LLVMFuzzerInitialize(int *argc, char ***argv)
{
    (void)argc;
    (void)argv;
    caught_start("armtol");
    return 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char text[MOST_BYTES];
    if (size < 2 || size > MOST_BYTES) {
        return 0;
    }
    const armtol_arm *arm = armtol_arm_at(data[0] / 4 % armtol_arm_count());
    region_words words;
    bool fine;
    caught_forget();
    memcpy(text, data + 1, size - 1);
    text[size - 1] = '\0';
    if (data[0] % 2 == 0 && strchr(text, '=') != NULL) { /* without one it would be the name of a file */
        fine = region_words_take(text, arm, &inside, data[0] / 2 % 2 != 0, &words);
    } else {
        FILE *stream = caught_file(data + 1, size - 1);
        fine = region_words_read(stream, "some.region", arm, &inside, data[0] / 2 % 2 != 0, &words);
        fclose(stream);
    }
    REQUIRE(fine ? caught_nothing() : caught_one_message());
    if (fine) {
        check_words(arm, &words);
    }
    region_words_free(&words);
    return 0;
}
