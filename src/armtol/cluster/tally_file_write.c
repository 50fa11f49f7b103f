#include "armtol/cluster/tally_file.h"

#include <inttypes.h>
#include <math.h>
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

static void put_number(writer *writer, const char *name, uint64_t number)
{
    put(writer, name);
    put_count(writer, number);
    put(writer, "\n");
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
    put(writer, "\n");
    put_number(writer, head->form->many, head->total);
    for (size_t i = 0; i < head->form->n_numbers; i++) {
        put_number(writer, head->form->numbers[i], head->numbers[i]);
    }
    for (size_t i = 0; i < head->form->n_subjects; i++) {
        put(writer, "fingerprint ");
        put(writer, head->form->subject(i));
        put_bits(writer, head->fingerprints[i]);
        put(writer, "\n");
    }
}

/* Whether there is anything to write: what no line has is 0, or not looked at. */
static bool has_value(const armtol_tally_member *member, size_t i)
{
    return member->counts != NULL ? member->counts[i] != 0 : !isnan(member->numbers[i]);
}

/* A number by its bits: what was written is what is read, to the last one. */
static void put_value(writer *writer, const armtol_tally_member *member, size_t i)
{
    if (member->counts != NULL) {
        put_count(writer, member->counts[i]);
    } else {
        uint64_t bits;
        memcpy(&bits, &member->numbers[i], sizeof bits);
        put_bits(writer, bits);
    }
}

/* A line for each run of values, with the place of its first. */
static void put_member(writer *writer, const armtol_tally_member *member)
{
    enum { A_LINE = 64 };
    for (size_t i = 0; i < member->length;) {
        if (!has_value(member, i)) {
            i++;
            continue;
        }
        put(writer, member->name);
        put_count(writer, i);
        for (size_t n = 0; n < A_LINE && i < member->length && has_value(member, i); n++, i++) {
            put_value(writer, member, i);
        }
        put(writer, "\n");
    }
}

void tally_file_write(FILE *stream, const void *data)
{
    const tally_written *written = data;
    const tally_form *form = written->head->form;
    writer writer = {stream, TALLY_CHECKSUM_START};
    put_head(&writer, written->head);
    for (size_t i = 0; i < form->member_count(); i++) {
        const armtol_tally_member member = form->member(written->content, i);
        put_member(&writer, &member);
    }
    fprintf(stream, "end %016" PRIx64 "\n", writer.checksum);
}
