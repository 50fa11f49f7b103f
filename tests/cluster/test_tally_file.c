/* Tallies as files: what is written is what is read; what is cut or changed anywhere is not. */

#include "armtol/cluster/coverage.h"
#include "armtol/cluster/tally_file.h"
#include "support/random.h"
#include "support/said.h"

#include "unity.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { BYTES = 1 << 16 };

static tally_content tally, again;

void setUp(void)
{
}

void tearDown(void)
{
    tally_content_free(&tally);
    tally_content_free(&again);
}

static armtol_tally_member member_named(const tally_form *form, const char *name)
{
    for (size_t i = 0; i < form->member_count(); i++) {
        const armtol_tally_member member = form->member(&tally, i);
        if (strcmp(member.name, name) == 0) {
            return member;
        }
    }
    TEST_FAIL_MESSAGE(name);
    abort();
}

static char puma[] = "puma560", joints[] = "--joints", nothing[] = "", odd[] = "%, \xff\n";
static char *words[] = {puma, joints, nothing, odd, NULL};

/* Shard 2 of 3 of 300 arms, from 100 on: all in bins of their own or in two of them. */
static tally_head fill(void)
{
    const tally_head head = {.form = &tally_of_arms, .version = "1.2.3", .words = words, .n_words = 4, .shard = 2,
                             .n_shards = 3, .total = 300, .numbers = {UINT64_MAX},
                             .fingerprints = {1, 0xfedcba9876543210u, 0, UINT64_MAX, 5, 6}};
    const tally_form *form = head.form;
    TEST_ASSERT_TRUE(form->start(&tally, &head, 100));
    const armtol_tally_member bins = member_named(form, "bins");
    const size_t each = 65536; /* bins of a histogram: docs/cluster.md */
    member_named(form, "measures").counts[0] = 6;
    member_named(form, "drawn").counts[0] = 100;
    member_named(form, "within").counts[0] = 90;
    member_named(form, "beyond").counts[0] = 10;
    for (size_t i = 0; i < 6; i++) {
        member_named(form, "worst").numbers[i] = 0.1 * (double)i;
        member_named(form, "worst_arm").counts[i] = 100 + i;
        if (i % 2 == 0) {
            for (size_t arm = 0; arm < 100; arm++) {
                bins.counts[i * each + each / 2 + arm] = 1;
            }
        } else {
            bins.counts[i * each] = 3;
            bins.counts[(i + 1) * each - 1] = 97;
        }
    }
    return head;
}

static size_t write_to(char bytes[BYTES], const tally_head *head)
{
    FILE *stream = tmpfile();
    TEST_ASSERT_NOT_NULL(stream);
    tally_file_write(stream, &(tally_written){head, &tally});
    const long length = ftell(stream);
    TEST_ASSERT_TRUE(!ferror(stream) && length > 0 && length < BYTES);
    rewind(stream);
    TEST_ASSERT_EQUAL_INT(length, fread(bytes, 1, (size_t)length, stream));
    fclose(stream);
    return (size_t)length;
}

static tally_result read_from(const char bytes[], size_t length, tally_head *head, said *said)
{
    FILE *stream = stream_of(bytes, length);
    said_begin();
    const tally_result result = tally_file_read(stream, "t", head, &again);
    said_end(said);
    fclose(stream);
    return result;
}

/* With one message exactly, and nothing to free. */
static void check_not_whole(const char bytes[], size_t length, tally_result expected, const char *says)
{
    said said;
    tally_head head;
    TEST_ASSERT_EQUAL_INT_MESSAGE(expected, read_from(bytes, length, &head, &said), says);
    TEST_ASSERT_TRUE(head.words == NULL && head.n_words == 0);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(said.text, says), said.text);
    TEST_ASSERT_TRUE(strchr(said.text, '\n') == said.text + strlen(said.text) - 1);
}

/* Members to the bit. */
static void check_same_members(const tally_form *form)
{
    for (size_t i = 0; i < form->member_count(); i++) {
        const armtol_tally_member one = form->member(&tally, i), other = form->member(&again, i);
        const void *const a = one.counts != NULL ? (void *)one.counts : one.numbers;
        const void *const b = other.counts != NULL ? (void *)other.counts : other.numbers;
        TEST_ASSERT_EQUAL_UINT(one.length, other.length);
        TEST_ASSERT_EQUAL_INT_MESSAGE(0, memcmp(a, b, 8 * one.length), one.name);
    }
}

static void check_written_is_read(const tally_head *head)
{
    static char bytes[BYTES];
    tally_head read;
    said said;
    const size_t length = write_to(bytes, head);
    TEST_ASSERT_EQUAL_INT_MESSAGE(TALLY_WHOLE, read_from(bytes, length, &read, &said), said.text);
    TEST_ASSERT_EQUAL_STRING("", said.text);
    TEST_ASSERT_NULL(tally_head_difference(head, &read));
    TEST_ASSERT_TRUE(read.shard == 2 && read.n_shards == 3 && read.n_words == 4 && read.words[4] == NULL);
    for (size_t i = 0; i < 4; i++) {
        TEST_ASSERT_EQUAL_STRING(words[i], read.words[i]);
    }
    check_same_members(head->form);
    tally_head_free(&read);
}

static void test_what_is_written_is_read(void)
{
    const tally_head head = fill();
    check_written_is_read(&head);
}

/* The form that docs/cluster.md describes, byte by byte. */
static void test_the_form(void)
{
    static char bytes[BYTES];
    const tally_head head = fill();
    static const char begin[] = "armtol tally 1\nversion 1.2.3\nword puma560\nword --joints\n"
                                "word \nword %25,%20%ff%0a\n"
                                "shard 2 3\narms 300\nseed 18446744073709551615\n"
                                "fingerprint arm 0000000000000001\nfingerprint tool fedcba9876543210\n"
                                "fingerprint tolerances 0000000000000000\nfingerprint loads ffffffffffffffff\n"
                                "fingerprint distributions 0000000000000005\n"
                                "fingerprint accuracy 0000000000000006\n"
                                "measures 0 6\ndrawn 0 100\nwithin 0 90\nbeyond 0 10\n"
                                "worst 0 0000000000000000 3fb999999999999a ";
    const size_t length = write_to(bytes, &head);
    TEST_ASSERT_EQUAL_INT(0, strncmp(bytes, begin, sizeof begin - 1));
    bytes[length] = '\0';
    TEST_ASSERT_NOT_NULL(strstr(bytes, "\nworst_arm 0 100 101 102 103 104 105\nbins 32768 1 1 1"));
    TEST_ASSERT_NOT_NULL(strstr(bytes, "\nbins 65536 3\nbins 131071 97\n"));
}

/* FNV-1a of its authors' own test vectors. */
static void test_the_checksum(void)
{
    TEST_ASSERT_TRUE(tally_checksum(TALLY_CHECKSUM_START, "", 0) == 0xcbf29ce484222325u);
    TEST_ASSERT_TRUE(tally_checksum(TALLY_CHECKSUM_START, "a", 1) == 0xaf63dc4c8601ec8cu);
    TEST_ASSERT_TRUE(tally_checksum(TALLY_CHECKSUM_START, "foobar", 6) == 0x85944171f73967e8u);
}

static void test_cut_everywhere(void)
{
    static char bytes[BYTES];
    const tally_head head = fill();
    const size_t length = write_to(bytes, &head), first = strlen("armtol tally 1\n");
    for (size_t cut = 0; cut < length; cut += cut < 400 || cut + 100 > length ? 1 : 37) {
        check_not_whole(bytes, cut, cut < first ? TALLY_NONE : TALLY_DAMAGED,
                        cut < first ? "no tally" : "tally is cut");
    }
}

/* One bit after another: no change of a byte is taken for a tally. */
static void test_changed_everywhere(void)
{
    static char bytes[BYTES];
    const tally_head head = fill();
    const size_t length = write_to(bytes, &head), first = strlen("armtol tally 1\n");
    for (size_t at = 0; at < length; at += at < 500 || at + 100 > length ? 1 : 13) {
        const char was = bytes[at];
        bytes[at] = (char)(was ^ (1 << at % 7));
        check_not_whole(bytes, length, at < first ? TALLY_NONE : TALLY_DAMAGED, "t:");
        bytes[at] = was;
    }
}

static void test_something_behind(void)
{
    static char bytes[BYTES];
    const tally_head head = fill();
    const size_t length = write_to(bytes, &head);
    bytes[length] = '\n';
    check_not_whole(bytes, length + 1, TALLY_DAMAGED, "something stands behind the end");
}

/* ---- with the right checksum ---- */

/* The text, where `old` stands, changed to `new`, and an end with the checksum that is right. */
static size_t forge(char bytes[BYTES], const tally_head *head, const char *old, const char *new)
{
    static char forged[BYTES];
    bytes[write_to(bytes, head)] = '\0';
    char *const at = strstr(bytes, old), *const end = strstr(bytes, "\nend ") + 1;
    TEST_ASSERT_TRUE_MESSAGE(at != NULL && at < end, old);
    const int length = snprintf(forged, sizeof forged, "%.*s%s%.*s", (int)(at - bytes), bytes, new,
                                (int)(end - at - (long)strlen(old)), at + strlen(old));
    memcpy(bytes, forged, (size_t)length);
    return (size_t)length + (size_t)sprintf(bytes + length, "end %016" PRIx64 "\n",
                                            tally_checksum(TALLY_CHECKSUM_START, forged, (size_t)length));
}

static void check_forged_of(const tally_head *head, const char *old, const char *new, const char *says)
{
    static char bytes[BYTES];
    const size_t length = forge(bytes, head, old, new);
    check_not_whole(bytes, length, TALLY_DAMAGED, says);
}

static void check_forged(const char *old, const char *new, const char *says)
{
    const tally_head head = fill();
    check_forged_of(&head, old, new, says);
}

static void test_counts_that_cannot_be(void)
{
    static const char sum[] = "the counts do not add up to the arms of the shard", here[] = "the tally is damaged here";
    static char bytes[BYTES];
    const tally_head head = fill();
    tally_head read;
    said said;
    TEST_ASSERT_EQUAL_INT(TALLY_WHOLE, read_from(bytes, forge(bytes, &head, "within 0 90", "within 0 89"), &read,
                                                 &said));
    tally_head_free(&read);
    check_forged("drawn 0 100", "drawn 0 101", sum);
    check_forged("within 0 90", "within 0 91", sum);
    check_forged("within 0 90", "within 0 18446744073709551615", sum);
    check_forged("beyond 0 10", "beyond 0 18446744073709551615", sum);
    check_forged("bins 65536 3", "bins 65536 4", sum);
    check_forged("bins 65536 3", "bins 65536 18446744073709551519", sum);
    check_forged("worst_arm 0 100", "worst_arm 0 99", sum);
    check_forged("105\n", "200\n", sum);
    check_forged("worst 0 0000000000000000", "worst 0 7ff8000000000000", sum);
    check_forged("worst 0 0000000000000000", "worst 0 bff0000000000000", sum);
    check_forged("shard 2 3", "shard 1 3", sum);
    check_forged("measures 0 6", "measures 0 5", sum);
    check_forged("measures 0 6", "measures 0 7", sum);
    check_forged("measures 0 6", "measures 0 18446744073709551615", sum);
    check_forged("bins 65536 3", "bins 18446744073709551615 1 1", here);
    check_forged("bins 65536 3", "bins 65536 18446744073709551616", here);
    check_forged("bins 65536 3", "bins 65536 0x3", here);
    check_forged("bins 65536 3", "bins  3", here);
    check_forged("bins 65536 3", "baskets 65536 3", here);
    check_forged("shard 2 3", "shard 0 3", here);
    check_forged("shard 2 3", "shard 4 3", here);
    check_forged("shard 2 3", "shard 2 301", here);
    check_forged("shard 2 3", "shard 2 3 3", here);
    check_forged("shard 2 3", "shard two 3", here);
    check_forged("shard 2 3", "chard 2 3", here);
    check_forged("arms 300", "arms 1000000000001", here);
    check_forged("arms 300", "arms -300", here);
    check_forged("arms 300", "arms", here);
    check_forged("arms 300", "arms 300 ", here);
    check_forged("word %25", "word %2", here);
    check_forged("word %25", "word %00", here);
    check_forged("word %25", "word %zz", here);
    check_forged("word puma560\nword --joints\nword \nword %25,%20%ff%0a\n", "", here);
    check_forged("version 1.2.3", "version 1.2.3.4.5.6.7.8.9.10.11.12.13.14.15", here);
    check_forged("version 1.2.3", "version", here);
    check_forged("fingerprint tool", "fingerprint fool", here);
}

/* ---- rows of a map ---- */

/*
 * Shard 2 of 3 of 5 rows of 3 points: rows 2 and 3, of an arm of 2 joints. The first point is not reached, the second
 * was searched in vain and followed to later, the third a search found; nothing is known of the row behind.
 */
static tally_head fill_rows(void)
{
    const tally_head head = {.form = &tally_of_rows, .version = "1.2.3", .words = words, .n_words = 4, .shard = 2,
                             .n_shards = 3, .total = 5, .numbers = {3, 2},
                             .fingerprints = {1, 2, 3, 4, 5, 6, 7, UINT64_MAX}};
    TEST_ASSERT_TRUE(head.form->start(&tally, &head, 2));
    tally_rows *rows = &tally.rows;
    TEST_ASSERT_TRUE(rows->n_points == 6 && rows->n_joints == 2);
    rows->points[1] = ROWS_REACHED | ROWS_IN_VAIN;
    rows->points[2] = ROWS_REACHED | ROWS_FOUND;
    rows->values[1] = (double)INFINITY;
    rows->values[2] = 0.1;
    rows->q[2] = -0.0;
    rows->q[5] = -1e-310;
    return head;
}

static void test_rows_that_are_written_are_read(void)
{
    const tally_head head = fill_rows();
    check_written_is_read(&head);
}

/* Byte by byte, as docs/cluster.md has it; what is nan, of whatever bits, is left out. */
static void test_the_form_of_rows(void)
{
    static char bytes[BYTES];
    const tally_head head = fill_rows();
    static const char all[] = "shard 2 3\nrows 5\npoints 3\njoints 2\n"
                              "fingerprint arm 0000000000000001\nfingerprint pose 0000000000000002\n"
                              "fingerprint plane 0000000000000003\nfingerprint value 0000000000000004\n"
                              "fingerprint tool 0000000000000005\nfingerprint tolerances 0000000000000006\n"
                              "fingerprint loads 0000000000000007\nfingerprint accuracy ffffffffffffffff\n"
                              "point 1 5 3\n"
                              "value 1 7ff0000000000000 3fb999999999999a\n"
                              "q 2 8000000000000000 0000000000000000 0000000000000000 800012688b70e62b\n"
                              "end ";
    for (size_t k = 0; k < 6; k++) {
        if (tally.rows.points[k] == 0) {
            tally.rows.values[k] = tally.rows.q[2 * k] = tally.rows.q[2 * k + 1] = k % 2 == 0 ? (double)NAN
                                                                                              : -(double)NAN;
        }
    }
    const size_t length = write_to(bytes, &head);
    bytes[length] = '\0';
    const char *const at = strstr(bytes, "shard ");
    TEST_ASSERT_NOT_NULL(at);
    TEST_ASSERT_EQUAL_STRING_LEN(all, at, sizeof all - 1);
}

static void test_rows_that_are_cut_or_changed(void)
{
    static char bytes[BYTES];
    const tally_head head = fill_rows();
    const size_t length = write_to(bytes, &head), first = strlen("armtol tally 1\n");
    for (size_t at = 0; at < length; at++) {
        const char was = bytes[at];
        check_not_whole(bytes, at, at < first ? TALLY_NONE : TALLY_DAMAGED, at < first ? "no tally" : "tally is cut");
        bytes[at] = (char)(was ^ (1 << at % 7));
        check_not_whole(bytes, length, at < first ? TALLY_NONE : TALLY_DAMAGED, "t:");
        bytes[at] = was;
    }
}

static void test_rows_that_cannot_be(void)
{
    static const char odd_points[] = "the points cannot be those of a map", here[] = "the tally is damaged here";
    const tally_head head = fill_rows();
    check_forged_of(&head, "point 1 5 3", "point 1 5 2", odd_points);
    check_forged_of(&head, "point 1 5 3", "point 1 5 6", odd_points);
    check_forged_of(&head, "point 1 5 3", "point 1 5 18446744073709551615", odd_points);
    check_forged_of(&head, " 7ff0000000000000", " 7ff8000000000000", odd_points);
    check_forged_of(&head, " 7ff0000000000000", " bff0000000000000", odd_points);
    check_forged_of(&head, " 8000000000000000", " 7ff0000000000000", odd_points);
    check_forged_of(&head, " 8000000000000000", " 7ff8000000000000", odd_points);
    check_forged_of(&head, "point 1 5 3", "point 4 5 3 3", here);
    check_forged_of(&head, "q 0 ", "q 9 ", here);
    check_forged_of(&head, "rows 5", "columns 5", here);
    check_forged_of(&head, "rows 5", "rows 5 5", here);
    check_forged_of(&head, "rows 5", "rows 2", here);
    check_forged_of(&head, "rows 5", "rows 1000001", here);
    check_forged_of(&head, "rows 5\npoints 3", "rows 5\npoints 200001", here);
    check_forged_of(&head, "rows 5\npoints 3", "rows 5\npoints 18446744073709551615", here);
    check_forged_of(&head, "points 3", "points 0", here);
    check_forged_of(&head, "joints 2", "joints 8947849", here); /* times 15 just above 2^27 */
    check_forged_of(&head, "joints 2", "joints 18446744073709551615", here);
}

/* Either may be read where the other was before. */
static void test_contents_of_both_forms(void)
{
    const tally_head arms = fill();
    check_written_is_read(&arms);
    const tally_head rows = fill_rows();
    check_written_is_read(&rows);
    check_written_is_read(&arms);
    TEST_ASSERT_EQUAL_STRING("kind", tally_head_difference(&arms, &rows));
}

/* What two heads of rows differ in. */
static void test_what_heads_of_rows_differ_in(void)
{
    const tally_head head = fill_rows();
    tally_head other = head;
    TEST_ASSERT_NULL(tally_head_difference(&head, &other));
    other.fingerprints[ROWS_PLANE]++;
    TEST_ASSERT_EQUAL_STRING("plane", tally_head_difference(&head, &other));
    other.numbers[ROWS_JOINTS]++;
    TEST_ASSERT_EQUAL_STRING("number of joints", tally_head_difference(&head, &other));
    other.numbers[ROWS_POINTS]++;
    TEST_ASSERT_EQUAL_STRING("number of points", tally_head_difference(&head, &other));
    other.total++;
    TEST_ASSERT_EQUAL_STRING("number of rows", tally_head_difference(&head, &other));
}

static void test_a_line_that_is_too_long(void)
{
    static char bytes[BYTES];
    memset(bytes, 'x', sizeof bytes);
    memcpy(bytes, "armtol tally 1\nversion 1\nword ", 30);
    check_not_whole(bytes, sizeof bytes, TALLY_DAMAGED, "t:3:1: the tally is damaged here");
    bytes[40] = '\0';
    check_not_whole(bytes, 50, TALLY_DAMAGED, "t:3:1: the tally is cut");
}

/* ---- ranges ---- */

/* Shards hold every arm once, are in order, and none is longer than another by two. */
static void test_shards_of_any_number(void)
{
    random_source source = {5};
    for (int n = 0; n < 2000; n++) {
        const uint64_t total = 1 + random_bits(&source) % (n % 2 == 0 ? 1000u : 1000000000000u);
        const uint64_t most = total < 300 ? total : 300, n_shards = 1 + random_bits(&source) % most;
        uint64_t next = 0;
        for (uint64_t shard = 1; shard <= n_shards; shard++) {
            const shard_range range = shard_range_of(shard, n_shards, total);
            TEST_ASSERT_TRUE(range.first == next && range.count - total / n_shards <= 1);
            next += range.count;
        }
        TEST_ASSERT_TRUE(next == total);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_what_is_written_is_read);
    RUN_TEST(test_the_form);
    RUN_TEST(test_the_checksum);
    RUN_TEST(test_cut_everywhere);
    RUN_TEST(test_changed_everywhere);
    RUN_TEST(test_something_behind);
    RUN_TEST(test_counts_that_cannot_be);
    RUN_TEST(test_rows_that_are_written_are_read);
    RUN_TEST(test_the_form_of_rows);
    RUN_TEST(test_rows_that_are_cut_or_changed);
    RUN_TEST(test_rows_that_cannot_be);
    RUN_TEST(test_contents_of_both_forms);
    RUN_TEST(test_what_heads_of_rows_differ_in);
    RUN_TEST(test_a_line_that_is_too_long);
    RUN_TEST(test_shards_of_any_number);
    return UNITY_END();
}
