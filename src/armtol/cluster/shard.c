#include "armtol/cluster/shard.h"

#include "armtol/armtol.h"
#include "armtol/ask/watched.h"
#include "armtol/cluster/tally_file.h"
#include "console/exit_code.h"
#include "console/message.h"
#include "files/outfile.h"

#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

static tally_head head_of(const cli_options *options, const armtol_answer *answer)
{
    tally_head head = {
        .words = options->words,
        .n_words = options->n_words,
        .shard = options->shard,
        .n_shards = options->n_shards,
        .total = options->verify,
        .seed = options->seed,
    };
    snprintf(head.version, sizeof head.version, "%s", armtol_version());
    for (size_t i = 0; i < ARMTOL_TALLY_SUBJECT_COUNT; i++) {
        head.fingerprints[i] = armtol_tally_fingerprint(answer, (armtol_tally_subject)i);
    }
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
static found look_closer(FILE *stream, const char *path, const tally_head *wanted, armtol_tally *tally)
{
    tally_head head;
    const tally_result result = tally_file_read(stream, path, &head, tally);
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

static found look_for(const char *path, const tally_head *wanted, armtol_tally *tally)
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
    const found found = look_closer(stream, path, wanted, tally);
    fclose(stream);
    return found;
}

/* ---- drawing ---- */

static void say(const tally_head *head, const char *what, const char *path)
{
    const shard_range range = tally_head_range(head);
    printf("shard %" PRIu64 "/%" PRIu64 ", arms %" PRIu64 " to %" PRIu64 " of %" PRIu64 ": %s, %s\n", head->shard,
           head->n_shards, range.first, range.first + range.count - 1, head->total, what, path);
}

static int draw_and_write(const request *request, const armtol_answer *answer, size_t n_threads,
                          const outfile_place *place, const tally_content *content)
{
    const shard_range range = tally_head_range(content->head);
    const armtol_draw draw = {.samples = range.count, .seed = content->head->seed, .n_threads = n_threads};
    armtol_fault fault;
    if (watched_tally_draw(answer, &draw, range.first, content->tally, &fault) != ARMTOL_OK) {
        return request_failed(request, &fault);
    }
    if (!armtol_tally_is_of(content->tally, range.first, range.count)) {
        message("interrupted: no tally is written");
        return EXIT_FAILED;
    }
    if (!outfile_write_at(place, tally_file_write, content)) {
        return EXIT_FAILED;
    }
    say(content->head, "drawn", request->options->tally);
    return EXIT_OK;
}

static int run_at(const request *request, const armtol_answer *answer, size_t n_threads, const outfile_place *place,
                  const tally_content *content)
{
    const char *path = request->options->tally;
    switch (look_for(path, content->head, content->tally)) {
    case FOUND_TALLY:
        say(content->head, "there already", path);
        return EXIT_OK;
    case FOUND_NOTHING:
        return draw_and_write(request, answer, n_threads, place, content);
    case FOUND_OTHER:
        message("--tally: %s is in the way; expected no file, or a tally", path);
        return EXIT_WRONG;
    default:
        return EXIT_FAILED;
    }
}

/* Whether the file can be written is asked before the arms are drawn. */
static int run(const request *request, const armtol_answer *answer, size_t n_threads, const tally_content *content)
{
    outfile_place place;
    if (!outfile_open(&place, request->options->tally)) {
        return EXIT_FAILED;
    }
    const int code = run_at(request, answer, n_threads, &place, content);
    outfile_close(&place);
    return code;
}

int shard_run(const request *request, const armtol_answer *answer, size_t n_threads)
{
    const tally_head head = head_of(request->options, answer);
    armtol_tally *tally;
    if (!check_words(&head)) {
        return EXIT_WRONG;
    }
    if (armtol_tally_create(&tally) != ARMTOL_OK) {
        out_of_memory();
        return EXIT_FAILED;
    }
    const int code = run(request, answer, n_threads, &(tally_content){&head, tally});
    armtol_tally_destroy(tally);
    return code;
}
