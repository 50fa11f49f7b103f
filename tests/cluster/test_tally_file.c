/* Tallies as files: what is written is what is read; what is cut or changed anywhere is not. */

#include "armtol/cluster/coverage.h"
#include "armtol/cluster/tally_file.h"
#include "support/random.h"
#include "support/said.h"

#include "unity.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { BYTES = 1 << 16 };

static armtol_tally *tally, *again;

void setUp(void)
{
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_tally_create(&tally));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_tally_create(&again));
}

void tearDown(void)
{
    armtol_tally_destroy(tally);
    armtol_tally_destroy(again);
}

static armtol_tally_member member_named(armtol_tally *of, const char *name)
{
    for (size_t i = 0; i < armtol_tally_member_count(); i++) {
        const armtol_tally_member member = armtol_tally_member_at(of, i);
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
    tally_head head = {.version = "1.2.3", .words = words, .n_words = 4, .shard = 2, .n_shards = 3, .total = 300,
                       .seed = UINT64_MAX, .fingerprints = {1, 0xfedcba9876543210u, 0, UINT64_MAX, 5}};
    const armtol_tally_member bins = member_named(tally, "bins");
    const size_t each = 65536; /* bins of a histogram: docs/cluster.md */
    member_named(tally, "measures").counts[0] = 6;
    member_named(tally, "drawn").counts[0] = 100;
    member_named(tally, "within").counts[0] = 90;
    member_named(tally, "beyond").counts[0] = 10;
    for (size_t i = 0; i < 6; i++) {
        member_named(tally, "worst").numbers[i] = 0.1 * (double)i;
        member_named(tally, "worst_arm").counts[i] = 100 + i;
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
    tally_file_write(stream, &(tally_content){head, tally});
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
    const tally_result result = tally_file_read(stream, "t", head, again);
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

static void test_what_is_written_is_read(void)
{
    static char bytes[BYTES];
    const tally_head head = fill();
    tally_head read;
    said said;
    const size_t length = write_to(bytes, &head);
    TEST_ASSERT_EQUAL_INT_MESSAGE(TALLY_WHOLE, read_from(bytes, length, &read, &said), said.text);
    TEST_ASSERT_EQUAL_STRING("", said.text);
    TEST_ASSERT_NULL(tally_head_difference(&head, &read));
    TEST_ASSERT_TRUE(read.shard == 2 && read.n_shards == 3 && read.n_words == 4 && read.words[4] == NULL);
    for (size_t i = 0; i < 4; i++) {
        TEST_ASSERT_EQUAL_STRING(words[i], read.words[i]);
    }
    for (size_t i = 0; i < armtol_tally_member_count(); i++) {
        const armtol_tally_member one = armtol_tally_member_at(tally, i), other = armtol_tally_member_at(again, i);
        const void *const a = one.counts != NULL ? (void *)one.counts : one.numbers;
        const void *const b = other.counts != NULL ? (void *)other.counts : other.numbers;
        TEST_ASSERT_EQUAL_INT_MESSAGE(0, memcmp(a, b, 8 * one.length), one.name);
    }
    tally_head_free(&read);
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
                                "fingerprint accuracy 0000000000000005\n"
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
static size_t forge(char bytes[BYTES], const char *old, const char *new)
{
    static char forged[BYTES];
    const tally_head head = fill();
    bytes[write_to(bytes, &head)] = '\0';
    char *const at = strstr(bytes, old), *const end = strstr(bytes, "\nend ") + 1;
    TEST_ASSERT_TRUE_MESSAGE(at != NULL && at < end, old);
    const int length = snprintf(forged, sizeof forged, "%.*s%s%.*s", (int)(at - bytes), bytes, new,
                                (int)(end - at - (long)strlen(old)), at + strlen(old));
    memcpy(bytes, forged, (size_t)length);
    return (size_t)length + (size_t)sprintf(bytes + length, "end %016" PRIx64 "\n",
                                            tally_checksum(TALLY_CHECKSUM_START, forged, (size_t)length));
}

static void check_forged(const char *old, const char *new, const char *says)
{
    static char bytes[BYTES];
    const size_t length = forge(bytes, old, new);
    check_not_whole(bytes, length, TALLY_DAMAGED, says);
}

static void test_counts_that_cannot_be(void)
{
    static const char sum[] = "the counts do not add up to the arms of the shard", here[] = "the tally is damaged here";
    static char bytes[BYTES];
    tally_head head;
    said said;
    TEST_ASSERT_EQUAL_INT(TALLY_WHOLE, read_from(bytes, forge(bytes, "within 0 90", "within 0 89"), &head, &said));
    tally_head_free(&head);
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
    RUN_TEST(test_a_line_that_is_too_long);
    RUN_TEST(test_shards_of_any_number);
    return UNITY_END();
}
