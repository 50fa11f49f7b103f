/* A verification in parts by the public interface: ranges, members, fingerprints. */

#include "armtol/tally.h"
#include "lib/engine/one_link.h"

#include "unity.h"

#include <math.h>
#include <string.h>

enum { ARMS = 20011 };

static one_link one;
static armtol_answer *answer;
static armtol_tally *tally, *sum;

void setUp(void)
{
    one_link_make(&one, ARMS);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_answer_create(&one.question, &answer, NULL));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_tally_create(&tally));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_tally_create(&sum));
}

void tearDown(void)
{
    armtol_tally_destroy(sum);
    armtol_tally_destroy(tally);
    armtol_answer_destroy(answer);
}

static armtol_tally_member member_named(armtol_tally *of, const char *name)
{
    size_t i = 0;
    while (i < armtol_tally_member_count() && strcmp(armtol_tally_member_at(of, i).name, name) != 0) {
        i++;
    }
    TEST_ASSERT_TRUE_MESSAGE(i < armtol_tally_member_count(), name);
    return armtol_tally_member_at(of, i);
}

static void add_range(uint64_t first, uint64_t end, size_t n_threads)
{
    armtol_draw draw = one.draw;
    armtol_fault fault;
    draw.samples = end - first;
    draw.n_threads = n_threads;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_tally_draw(answer, &draw, first, tally, &fault));
    TEST_ASSERT_TRUE(fault.status == ARMTOL_OK && fault.about == ARMTOL_ABOUT_NOTHING);
    TEST_ASSERT_TRUE(armtol_tally_is_of(tally, first, end - first));
    armtol_tally_add(sum, tally);
}

static void test_ranges_in_any_order_are_the_whole(void)
{
    armtol_verification whole, found;
    armtol_fault fault;
    add_range(13000, ARMS, 2);
    add_range(0, 1, 1);
    add_range(258, 13000, 3);
    add_range(1, 258, 1);
    TEST_ASSERT_TRUE(armtol_tally_is_of(sum, 0, ARMS));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_verify(answer, &one.draw, &whole, NULL));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_tally_verify(answer, &one.draw, sum, &found, &fault));
    TEST_ASSERT_TRUE(fault.status == ARMTOL_OK && whole.drawn == ARMS);
    TEST_ASSERT_EQUAL_MEMORY(&whole, &found, sizeof whole);
}

/* The link turns by no more than 0.004, and no arm is worse: closed form. Copied by its members a tally is the same. */
static void test_members_are_all_of_it(void)
{
    add_range(100, 5100, 1);
    armtol_tally_clear(tally);
    TEST_ASSERT_TRUE(armtol_tally_is_of(tally, 0, 0) && !armtol_tally_is_of(tally, 100, 5000));
    for (size_t i = 0; i < armtol_tally_member_count(); i++) {
        const armtol_tally_member from = armtol_tally_member_at(sum, i), to = armtol_tally_member_at(tally, i);
        TEST_ASSERT_TRUE((from.counts == NULL) != (from.numbers == NULL));
        if (from.counts != NULL) {
            memcpy(to.counts, from.counts, from.length * sizeof *from.counts);
        } else {
            memcpy(to.numbers, from.numbers, from.length * sizeof *from.numbers);
        }
    }
    TEST_ASSERT_TRUE(armtol_tally_is_of(tally, 100, 5000));
    armtol_verification one_of_them, other;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_tally_verify(answer, &one.draw, sum, &one_of_them, NULL));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_tally_verify(answer, &one.draw, tally, &other, NULL));
    TEST_ASSERT_EQUAL_MEMORY(&one_of_them, &other, sizeof other);
    const armtol_tally_member worst = member_named(tally, "worst");
    TEST_ASSERT_TRUE(worst.length >= 6 && worst.numbers[5] > 0.0039 && worst.numbers[5] <= 0.004 * (1 + 1e-12));
    TEST_ASSERT_TRUE(worst.numbers[1] > 400 * sin(0.0039) && worst.numbers[1] <= 400 * sin(0.004) * (1 + 1e-12));
}

static bool stop(void *context, uint64_t done, uint64_t total)
{
    (void)context;
    (void)done;
    (void)total;
    return false;
}

/* What was drawn until then are the first arms of the range. */
static void test_a_range_that_is_ended_early(void)
{
    armtol_draw draw = one.draw;
    draw.progress = stop;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_tally_draw(answer, &draw, 7, tally, NULL));
    const uint64_t drawn = member_named(tally, "drawn").counts[0];
    TEST_ASSERT_TRUE(drawn > 0 && drawn < ARMS && armtol_tally_is_of(tally, 7, drawn));
    add_range(7, 7 + drawn, 1);
    TEST_ASSERT_EQUAL_MEMORY(member_named(sum, "worst").numbers, member_named(tally, "worst").numbers,
                             6 * sizeof(double));
}

static void test_what_has_no_bound_is_refused(void)
{
    static const double accuracy[6] = {1, 1, 1, 1, 1, 1};
    armtol_answer *unbounded;
    armtol_verification found;
    armtol_fault fault;
    one.tolerances[0] = (double)INFINITY;
    one.question.accuracy = accuracy;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_answer_create(&one.question, &unbounded, NULL));
    TEST_ASSERT_EQUAL_INT(ARMTOL_UNBOUNDED, armtol_tally_draw(unbounded, &one.draw, 0, tally, &fault));
    TEST_ASSERT_TRUE(fault.about == ARMTOL_ABOUT_ACCURACY && fault.number == 1);
    TEST_ASSERT_EQUAL_INT(ARMTOL_UNBOUNDED, armtol_tally_verify(unbounded, &one.draw, tally, &found, &fault));
    TEST_ASSERT_TRUE(fault.about == ARMTOL_ABOUT_ACCURACY && fault.number == 1);
    armtol_answer_destroy(unbounded);
}

/* ---- fingerprints ---- */

/* The subjects in which the question's answer differs from the first, a bit each. */
static unsigned differences(void)
{
    unsigned bits = 0;
    armtol_answer *other;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_answer_create(&one.question, &other, NULL));
    for (int i = 0; i < ARMTOL_TALLY_SUBJECT_COUNT; i++) {
        const armtol_tally_subject subject = (armtol_tally_subject)i;
        bits |= (unsigned)(armtol_tally_fingerprint(answer, subject) != armtol_tally_fingerprint(other, subject)) << i;
    }
    armtol_answer_destroy(other);
    return bits;
}

static void test_fingerprints(void)
{
    static const double accuracy[6] = {1, 2, 3, 4, 5, 6};
    enum { ARM = 1 << ARMTOL_TALLY_ARM, TOOL = 1 << ARMTOL_TALLY_TOOL, TOLERANCES = 1 << ARMTOL_TALLY_TOLERANCES,
           ACCURACY = 1 << ARMTOL_TALLY_ACCURACY };
    TEST_ASSERT_TRUE(differences() == 0);
    one.question.accuracy = accuracy;
    TEST_ASSERT_TRUE(differences() == ACCURACY);
    one.question.accuracy = NULL;
    one.tolerances[0] = 0.005;
    TEST_ASSERT_TRUE((differences() & (ARM | TOOL | TOLERANCES)) == TOLERANCES);
    one.tolerances[0] = 0.004;
    one.link.d = 1;
    TEST_ASSERT_TRUE((differences() & (ARM | TOOL | TOLERANCES)) == ARM);
    one.link.d = 0;
    one.question.tool.frame = ARMTOL_TOOL_FRAME;
    TEST_ASSERT_TRUE(differences() == TOOL);
    one.question.tool.offset[2] = 1;
    TEST_ASSERT_TRUE((differences() & (ARM | TOOL | TOLERANCES)) == TOOL);
}

static void test_names_of_subjects(void)
{
    TEST_ASSERT_EQUAL_STRING("arm", armtol_tally_subject_name(ARMTOL_TALLY_ARM));
    TEST_ASSERT_EQUAL_STRING("accuracy", armtol_tally_subject_name(ARMTOL_TALLY_ACCURACY));
    TEST_ASSERT_EQUAL_STRING("?", armtol_tally_subject_name(ARMTOL_TALLY_SUBJECT_COUNT));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_ranges_in_any_order_are_the_whole);
    RUN_TEST(test_members_are_all_of_it);
    RUN_TEST(test_a_range_that_is_ended_early);
    RUN_TEST(test_what_has_no_bound_is_refused);
    RUN_TEST(test_fingerprints);
    RUN_TEST(test_names_of_subjects);
    return UNITY_END();
}
