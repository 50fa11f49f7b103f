#include "armtol/cluster/shard.h"

#include "armtol/armtol.h"
#include "console/exit_code.h"
#include "console/message.h"
#include "files/outfile.h"

#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

tally_head shard_head(const cli_options *options, const tally_form *form, uint64_t total)
{
    tally_head head = {
        .form = form,
        .words = options->words,
        .n_words = options->n_words,
        .shard = options->shard,
        .n_shards = options->n_shards,
        .total = total,
    };
    snprintf(head.version, sizeof head.version, "%s", armtol_version());
    return head;
}

/* A word that no reader would take is not written. */
static bool check_words(const tally_head *head)
{
    for (size_t i = 0; i < head->n_words; i++) {
        if (strlen(head->words[i]) > TALLY_WORD_MOST) {
            message("--tally: a word of the command has more than %d characters; expected a file in place of a long "
                    "list",
                    TALLY_WORD_MOST);
            return false;
        }
    }
    return true;
}

/* ---- what is there already ---- */

typedef enum found { FOUND_NOTHING, FOUND_TALLY, FOUND_OTHER, FOUND_UNREADABLE } found;

/* A whole tally of the same shard is kept; a tally of anything else is drawn anew; what is no tally is somebody's. */
static found look_closer(FILE *stream, const char *path, const tally_head *wanted, tally_content *content)
{
    tally_head head;
    const tally_result result = tally_file_read(stream, path, &head, content);
    if (result != TALLY_WHOLE) {
        return result == TALLY_DAMAGED ? FOUND_NOTHING : result == TALLY_NONE ? FOUND_OTHER : FOUND_UNREADABLE;
    }
    const shard_range there = tally_head_range(&head), here = tally_head_range(wanted);
    const char *difference = tally_head_difference(&head, wanted);
    const bool same = difference == NULL && there.first == here.first && there.count == here.count;
    if (!same) {
        message("%s: another %s; it is drawn anew", path, difference != NULL ? difference : "shard");
    }
    tally_head_free(&head);
    return same ? FOUND_TALLY : FOUND_NOTHING;
}

static found look_for(const char *path, const tally_head *wanted, tally_content *content)
{
    FILE *stream = fopen(path, "rb");
    if (stream == NULL) {
        const bool missing = errno == ENOENT;
        if (!missing) {
            exit_code_note_error(errno);
            message("%s: %s", path, strerror(errno));
        }
        return missing ? FOUND_NOTHING : FOUND_UNREADABLE;
    }
    const found found = look_closer(stream, path, wanted, content);
    fclose(stream);
    return found;
}

/* ---- drawing ---- */

static void say(const tally_head *head, const char *what, const char *path)
{
    const shard_range range = tally_head_range(head);
    printf("shard %" PRIu64 "/%" PRIu64 ", %s %" PRIu64 " to %" PRIu64 " of %" PRIu64 ": %s, %s\n", head->shard,
           head->n_shards, head->form->many, range.first, range.first + range.count - 1, head->total, what, path);
}

static int draw_and_write(const shard *shard, const char *path, const outfile_place *place)
{
    const tally_head *head = shard->head;
    if (!head->form->start(shard->content, head, tally_head_range(head).count)) {
        out_of_memory();
        return EXIT_FAILED;
    }
    const int code = shard->draw(shard);
    if (code != EXIT_OK) {
        return code;
    }
    if (!outfile_write_at(place, tally_file_write, &(tally_written){head, shard->content})) {
        return EXIT_FAILED;
    }
    say(head, "drawn", path);
    return EXIT_OK;
}

static int run_at(const shard *shard, const char *path, const outfile_place *place)
{
    switch (look_for(path, shard->head, shard->content)) {
    case FOUND_TALLY:
        say(shard->head, "there already", path);
        return EXIT_OK;
    case FOUND_NOTHING:
        return draw_and_write(shard, path, place);
    case FOUND_OTHER:
        message("--tally: %s is in the way; expected no file, or a tally", path);
        return EXIT_WRONG;
    default:
        return EXIT_FAILED;
    }
}

/* Whether the file can be written is asked before anything is drawn. */
int shard_run(const shard *shard, const char *path)
{
    outfile_place place;
    if (!check_words(shard->head)) {
        return EXIT_WRONG;
    }
    if (!outfile_open(&place, path)) {
        return EXIT_FAILED;
    }
    const int code = run_at(shard, path, &place);
    outfile_close(&place);
    return code;
}
