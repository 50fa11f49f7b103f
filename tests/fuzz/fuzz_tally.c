/*
 * Tallies of a cluster, of arms and of rows of a map. The first byte says whether the file gets an end with the
 * checksum that is right, so that what is behind it is reached. What is taken for a tally is sound, and is itself when
 * it is written and read again.
 */

#include "fuzz/harness.h"
#include "fuzz/require.h"

#include "armtol/ask/options.h"
#include "armtol/cluster/tally_file.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_BYTES = 1 << 16 };

static tally_content tally, again;

static void check_sound(const tally_head *head)
{
    const shard_range range = tally_head_range(head);
    REQUIRE(head->shard >= 1 && head->shard <= head->n_shards && head->n_shards <= MOST_SHARDS);
    REQUIRE(range.count >= 1 && range.first + range.count <= head->total && head->total <= head->form->most);
    REQUIRE(head->form->is_sound(head));
    REQUIRE(head->n_words > 0 && head->words[head->n_words] == NULL && strlen(head->version) < sizeof head->version);
    REQUIRE(head->form->fits(&tally, head));
}

static void check_same_words(const tally_head *one, const tally_head *other)
{
    REQUIRE(one->n_words == other->n_words);
    for (size_t i = 0; i < one->n_words; i++) {
        REQUIRE(strcmp(one->words[i], other->words[i]) == 0);
    }
}

/* A file of spaces for zeros would be another text; the tally is the same. */
static void check_again(const tally_head *head)
{
    char *text = NULL;
    size_t length = 0;
    tally_head read;
    FILE *written = open_memstream(&text, &length);
    REQUIRE(written != NULL);
    tally_file_write(written, &(tally_written){head, &tally});
    REQUIRE(fclose(written) == 0);
    FILE *stream = caught_file(text, length);
    REQUIRE(tally_file_read(stream, "again", &read, &again) == TALLY_WHOLE);
    fclose(stream);
    free(text);
    REQUIRE(tally_head_difference(head, &read) == NULL && read.shard == head->shard && read.n_shards == head->n_shards);
    check_same_words(head, &read);
    tally_head_free(&read);
}

static void check(const char *text, size_t length)
{
    tally_head head;
    FILE *stream = caught_file(text, length);
    const tally_result result = tally_file_read(stream, "tally", &head, &tally);
    fclose(stream);
    REQUIRE(result == TALLY_WHOLE ? caught_nothing() : caught_one_message());
    if (result == TALLY_WHOLE) {
        check_sound(&head);
        check_again(&head);
        tally_head_free(&head);
    }
}

/* The lines, without one that ends the tally, and then an end. */
static size_t seal(char text[MOST_BYTES + 32], size_t length)
{
    text[length] = '\0';
    char *const end = strstr(text, "\nend ");
    length = end != NULL ? (size_t)(end - text) + 1 : strlen(text);
    const uint64_t checksum = tally_checksum(TALLY_CHECKSUM_START, text, length);
    return length + (size_t)sprintf(text + length, "end %016" PRIx64 "\n", checksum);
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
    static char text[MOST_BYTES + 32];
    if (size < 1 || size > MOST_BYTES) {
        return 0;
    }
    caught_forget();
    memcpy(text, data + 1, size - 1);
    check(text, data[0] % 2 != 0 ? seal(text, size - 1) : size - 1);
    return 0;
}
