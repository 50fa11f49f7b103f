/* The table of an arm: it is refused with one message, or read and then written and read again to the bit. */

#include "fuzz/harness.h"
#include "fuzz/require.h"

#include "armtol/tables/arm_file.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { MOST_WRITTEN = 1 << 21 };

static char written[MOST_WRITTEN], again[MOST_WRITTEN];

static bool same(double one, double other)
{
    return memcmp(&one, &other, sizeof one) == 0 || (isnan(one) && isnan(other));
}

static size_t write_arm(const arm_model *model, row_order order, angle_unit unit, char text[MOST_WRITTEN])
{
    FILE *stream = fmemopen(text, MOST_WRITTEN, "w");
    REQUIRE(stream != NULL);
    REQUIRE(arm_file_write(&model->arm, order, unit, stream));
    REQUIRE(fflush(stream) == 0);
    const long length = ftell(stream);
    fclose(stream);
    REQUIRE(length > 0 && length < MOST_WRITTEN - 1);
    return (size_t)length;
}

/* What came in is what an arm may have: numbers, limits in order, a drive where there is a joint. */
static void check_arm(const armtol_arm *arm)
{
    REQUIRE(arm->n_links >= 1 && arm->n_links <= 1001);
    REQUIRE(arm->name != NULL && arm->title != NULL && arm->source != NULL);
    REQUIRE(arm->unit < ARMTOL_LENGTH_UNIT_COUNT);
    REQUIRE(armtol_arm_check(arm) == ARMTOL_OK);
    for (size_t i = 0; i < arm->n_links; i++) {
        const armtol_drive *drive = &arm->drives[i];
        REQUIRE(drive->low <= drive->high);
        REQUIRE(isnan(drive->backlash) || drive->backlash >= 0);
        REQUIRE(drive->compliance >= 0 && isfinite(drive->compliance));
        REQUIRE(drive->moment >= 0 && isfinite(drive->moment));
    }
}

static void check_same_link(const armtol_link *one, const armtol_link *other)
{
    REQUIRE(one->kind == other->kind && one->joint == other->joint);
    REQUIRE(same(one->a, other->a) && same(one->d, other->d));
    REQUIRE(same(one->alpha, other->alpha) && same(one->theta, other->theta) && same(one->beta, other->beta));
}

/* Compliance and moment that are both 0 are as good as not known. */
static void check_same_drive(const armtol_drive *one, const armtol_drive *other)
{
    REQUIRE(same(one->low, other->low) && same(one->high, other->high));
    REQUIRE(same(one->backlash, other->backlash));
    if (one->compliance != 0 || one->moment != 0) {
        REQUIRE(same(one->compliance, other->compliance) && same(one->moment, other->moment));
    } else {
        REQUIRE(other->compliance == 0 && other->moment == 0);
    }
}

static void check_same_motion(const armtol_arm *one, const armtol_arm *other, size_t link)
{
    REQUIRE((one->motions == NULL) == (other->motions == NULL));
    if (one->motions != NULL && one->links[link].joint != ARMTOL_FIXED) {
        const armtol_motion *a = &one->motions[link], *b = &other->motions[link];
        REQUIRE(a->follows == b->follows && a->sign == b->sign);
        REQUIRE(same(a->multiplier, b->multiplier) && same(a->offset, b->offset));
    }
}

static void check_same_name(const armtol_arm *one, const armtol_arm *other, size_t link)
{
    const char *a = one->names != NULL ? one->names[link] : NULL, *b = other->names != NULL ? other->names[link] : NULL;
    REQUIRE((a == NULL) == (b == NULL));
    REQUIRE(a == NULL || strcmp(a, b) == 0);
}

static void check_same_arm(const armtol_arm *one, const armtol_arm *other)
{
    REQUIRE(one->n_links == other->n_links && one->unit == other->unit);
    REQUIRE(strcmp(one->name, other->name) == 0);
    REQUIRE(strcmp(one->title, other->title) == 0);
    REQUIRE(strcmp(one->source, other->source) == 0);
    for (size_t i = 0; i < one->n_links; i++) {
        check_same_link(&one->links[i], &other->links[i]);
        check_same_drive(&one->drives[i], &other->drives[i]);
        check_same_motion(one, other, i);
        check_same_name(one, other, i);
    }
}

/* degrees.h: below 1e-280 radians a neighbour may come back, and beyond the largest double no degrees are left. */
static bool has_degrees(double radians)
{
    return radians == 0 || (fabs(radians) > 1e-280 && fabs(radians) < DBL_MAX / 58) || !isfinite(radians);
}

static bool all_have_degrees(const armtol_arm *arm)
{
    bool all = true;
    for (size_t i = 0; i < arm->n_links; i++) {
        const armtol_link *link = &arm->links[i];
        const armtol_drive *drive = &arm->drives[i];
        const double numbers[] = {link->alpha, link->theta,     link->beta,       drive->low,
                                  drive->high, drive->backlash, drive->compliance};
        for (size_t k = 0; k < sizeof numbers / sizeof numbers[0]; k++) {
            all = all && has_degrees(numbers[k]);
        }
        all = all && (arm->motions == NULL || has_degrees(arm->motions[i].offset));
    }
    return all;
}

static void check_comes_back(const arm_model *model, angle_unit unit)
{
    if (unit == UNIT_DEGREE && !all_have_degrees(&model->arm)) {
        return;
    }
    arm_model back;
    const size_t length = write_arm(model, ORDER_PAUL, unit, written);
    FILE *stream = caught_file(written, length);
    REQUIRE(arm_file_read(stream, "written", &back));
    fclose(stream);
    REQUIRE(caught_nothing());
    REQUIRE(back.angle_unit == unit);
    check_same_arm(&model->arm, &back.arm);
    REQUIRE(write_arm(&back, ORDER_PAUL, unit, again) == length && memcmp(written, again, length) == 0);
    arm_model_free(&back);
}

/* In Craig's order what is read is written as it was. */
static void check_other_order(const arm_model *model)
{
    arm_model back;
    if (model->arm.n_links >= 1000) {
        return; /* one row more may be too many */
    }
    const size_t length = write_arm(model, ORDER_CRAIG, UNIT_RADIAN, written);
    FILE *stream = caught_file(written, length);
    REQUIRE(arm_file_read(stream, "written", &back));
    fclose(stream);
    REQUIRE(caught_nothing());
    REQUIRE(write_arm(&back, ORDER_CRAIG, UNIT_RADIAN, again) == length && memcmp(written, again, length) == 0);
    arm_model_free(&back);
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
    arm_model model;
    FILE *stream = caught_file(data, size);
    caught_forget();
    const bool fine = arm_file_read(stream, "folder/arm.csv", &model);
    fclose(stream);
    if (!fine) {
        REQUIRE(caught_one_message());
        REQUIRE(model.arm.name == NULL);
        return 0;
    }
    REQUIRE(caught_nothing());
    check_arm(&model.arm);
    check_comes_back(&model, UNIT_RADIAN);
    check_comes_back(&model, UNIT_DEGREE);
    check_other_order(&model);
    arm_model_free(&model);
    return 0;
}
