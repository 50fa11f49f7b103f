#include "armtol/cluster/tally_file.h"

#include <inttypes.h>
#include <string.h>

typedef struct writer {
    FILE *stream;
    uint64_t checksum;
} writer;

static void put(writer *writer, const char *text)
{
    writer->checksum = tally_checksum(writer->checksum, text, strlen(text));
    fputs(text, writer->stream);
}

static void put_count(writer *writer, uint64_t count)
{
    char text[24];
    snprintf(text, sizeof text, " %" PRIu64, count);
    put(writer, text);
}

static void put_bits(writer *writer, uint64_t bits)
{
    char text[24];
    snprintf(text, sizeof text, " %016" PRIx64, bits);
    put(writer, text);
}

/* A word may hold anything; what is no plain character becomes % and two digits. */
static void put_word(writer *writer, const char *word)
{
    put(writer, "word ");
    for (; *word != '\0'; word++) {
        char text[4] = {*word, '\0'};
        if (*word <= ' ' || *word > '~' || *word == '%') {
            snprintf(text, sizeof text, "%%%02x", (unsigned)(unsigned char)*word);
        }
        put(writer, text);
    }
    put(writer, "\n");
}

static void put_head(writer *writer, const tally_head *head)
{
    put(writer, "armtol tally 1\nversion ");
    put(writer, head->version);
    put(writer, "\n");
    for (size_t i = 0; i < head->n_words; i++) {
        put_word(writer, head->words[i]);
    }
    put(writer, "shard");
    put_count(writer, head->shard);
    put_count(writer, head->n_shards);
    put(writer, "\narms");
    put_count(writer, head->total);
    put(writer, "\nseed");
    put_count(writer, head->seed);
    put(writer, "\n");
    for (size_t i = 0; i < ARMTOL_TALLY_SUBJECT_COUNT; i++) {
        put(writer, "fingerprint ");
        put(writer, armtol_tally_subject_name((armtol_tally_subject)i));
        put_bits(writer, head->fingerprints[i]);
        put(writer, "\n");
    }
}

/* A line for each run of counts that are not 0, with the place of its first. */
static void put_counts(writer *writer, const armtol_tally_member *member)
{
    enum { A_LINE = 64 };
    for (size_t i = 0; i < member->length;) {
        if (member->counts[i] == 0) {
            i++;
            continue;
        }
        put(writer, member->name);
        put_count(writer, i);
        for (size_t n = 0; n < A_LINE && i < member->length && member->counts[i] != 0; n++, i++) {
            put_count(writer, member->counts[i]);
        }
        put(writer, "\n");
    }
}

/* By their bits: what was written is what is read, to the last one. */
static void put_numbers(writer *writer, const armtol_tally_member *member)
{
    put(writer, member->name);
    put_count(writer, 0);
    for (size_t i = 0; i < member->length; i++) {
        uint64_t bits;
        memcpy(&bits, &member->numbers[i], sizeof bits);
        put_bits(writer, bits);
    }
    put(writer, "\n");
}

void tally_file_write(FILE *stream, const void *data)
{
    const tally_content *content = data;
    writer writer = {stream, TALLY_CHECKSUM_START};
    put_head(&writer, content->head);
    for (size_t i = 0; i < armtol_tally_member_count(); i++) {
        const armtol_tally_member member = armtol_tally_member_at(content->tally, i);
        if (member.counts != NULL) {
            put_counts(&writer, &member);
        } else {
            put_numbers(&writer, &member);
        }
    }
    fprintf(stream, "end %016" PRIx64 "\n", writer.checksum);
}
