/* Arms drawn in parts, out of order, count as those that are drawn at once. */

#include "lib/engine/one_link.h"
#include "lib/engine/draw.h"
#include "lib/engine/verification_parts.h"
#include "support/check.h"

#include "unity.h"

#include <stdlib.h>

void setUp(void)
{
}

void tearDown(void)
{
}

static armtol_answer *answer_of(one_link *one, uint64_t samples)
{
    armtol_answer *answer;
    one_link_make(one, samples);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_answer_create(&one->question, &answer, NULL));
    return answer;
}

/* Arms first to end - 1, into the sum. */
static void draw_part(const armtol_answer *answer, const armtol_draw *whole, uint64_t first, uint64_t end, tally *sum)
{
    tally *part = malloc(sizeof *part);
    tally_limits limits;
    armtol_draw draw = *whole;
    draw.samples = end - first;
    TEST_ASSERT_NOT_NULL(part);
    verification_limits(answer, &limits);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, draw_arms(answer, &draw, first, &limits, part));
    TEST_ASSERT_TRUE(part->drawn == end - first);
    tally_merge(sum, part);
    free(part);
}

static void test_parts_count_as_the_whole(void)
{
    enum { ARMS = 30011 };
    one_link one;
    armtol_verification whole, merged = {0};
    armtol_answer *answer = answer_of(&one, ARMS);
    tally *sum = malloc(sizeof *sum);
    tally_limits limits;
    TEST_ASSERT_NOT_NULL(sum);
    tally_start(sum, 6);
    draw_part(answer, &one.draw, 20000, ARMS, sum);
    draw_part(answer, &one.draw, 0, 77, sum);
    draw_part(answer, &one.draw, 77, 20000, sum);
    verification_limits(answer, &limits);
    verification_report(answer, sum, &limits, &merged);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_verify(answer, &one.draw, &whole, NULL));
    TEST_ASSERT_TRUE(whole.drawn == ARMS && merged.drawn == ARMS);
    TEST_ASSERT_TRUE(whole.within == merged.within && whole.beyond == merged.beyond);
    check_same(whole.share_low, merged.share_low, "share");
    for (size_t i = 0; i < 6; i++) {
        check_same(whole.components[i].worst_drawn, merged.components[i].worst_drawn, "worst of %zu", i);
        TEST_ASSERT_TRUE(whole.components[i].worst_arm == merged.components[i].worst_arm);
        for (size_t n = 0; n < ARMTOL_QUANTILES; n++) {
            check_same(whole.components[i].quantiles[n], merged.components[i].quantiles[n], "quantile %zu of %zu", n,
                       i);
        }
    }
    free(sum);
    armtol_answer_destroy(answer);
}

/* The progress of a part is counted from its own first arm. */
static bool look_on(void *context, uint64_t done, uint64_t total)
{
    uint64_t *seen = context;
    TEST_ASSERT_TRUE(done <= total);
    *seen = done;
    return true;
}

static void test_the_progress_of_a_part(void)
{
    one_link one;
    uint64_t seen = 0;
    armtol_answer *answer = answer_of(&one, 1);
    tally *sum = malloc(sizeof *sum);
    TEST_ASSERT_NOT_NULL(sum);
    tally_start(sum, 6);
    one.draw.progress = look_on;
    one.draw.context = &seen;
    draw_part(answer, &one.draw, 1000000, 1010000, sum);
    TEST_ASSERT_TRUE(seen == 10000);
    free(sum);
    armtol_answer_destroy(answer);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_parts_count_as_the_whole);
    RUN_TEST(test_the_progress_of_a_part);
    return UNITY_END();
}
