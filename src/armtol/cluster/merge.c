#include "armtol/cluster/merge.h"

#include "armtol/armtol.h"
#include "armtol/cluster/coverage.h"
#include "console/exit_code.h"
#include "console/input_file.h"
#include "console/message.h"

#include <stdlib.h>
#include <string.h>

/* What is read before and what is being read: their number does not matter to it but for a range each. */
typedef struct merging {
    merged *merged;
    armtol_tally *part;
    covered *ranges;
    size_t n_ranges;
} merging;

/* ---- one tally more ---- */

static bool check_version(const char *path, const tally_head *head)
{
    const bool same = strcmp(head->version, armtol_version()) == 0;
    if (!same) {
        message("%s: drawn by armtol %s; expected %s, this one", path, head->version, armtol_version());
    }
    return same;
}

static bool check_same(const merged *merged, const char *path, const tally_head *head)
{
    const char *difference = tally_head_difference(&merged->head, head);
    if (difference != NULL) {
        message("%s: not of the same run as %s: another %s; expected tallies of one question", path, merged->path,
                difference);
    }
    return difference == NULL;
}

/* Takes the head over where it is the one of the first arms. */
static void keep_first(merged *merged, const char *path, tally_head *head)
{
    if (merged->path == NULL || tally_head_range(head).first < tally_head_range(&merged->head).first) {
        const tally_head kept = merged->head;
        merged->head = *head;
        merged->path = path;
        *head = kept;
    }
}

static bool add(merging *merging, const char *path, tally_head *head)
{
    merged *merged = merging->merged;
    if (!check_version(path, head) || (merged->path != NULL && !check_same(merged, path, head))) {
        return false;
    }
    merging->ranges[merging->n_ranges++] = (covered){tally_head_range(head), head->n_shards, path};
    armtol_tally_add(merged->tally, merging->part);
    keep_first(merged, path, head);
    return true;
}

static int merge_file(merging *merging, const char *path)
{
    tally_head head;
    FILE *stream = input_file_open("", path, "");
    if (stream == NULL) {
        return EXIT_WRONG;
    }
    const tally_result result = tally_file_read(stream, path, &head, merging->part);
    fclose(stream);
    if (result != TALLY_WHOLE) {
        return EXIT_WRONG; /* what the machine failed at is noted */
    }
    const bool fine = add(merging, path, &head);
    tally_head_free(&head);
    return fine ? EXIT_OK : EXIT_WRONG;
}

/* ---- all of them ---- */

static int merge_all(merging *merging, char *const paths[], size_t n_paths)
{
    int code = EXIT_OK;
    for (size_t i = 0; i < n_paths && code == EXIT_OK; i++) {
        code = merge_file(merging, paths[i]);
    }
    if (code == EXIT_OK && !coverage_check(merging->ranges, merging->n_ranges, merging->merged->head.total)) {
        code = EXIT_WRONG;
    }
    return code;
}

static bool get_memory(merging *merging, size_t n_paths)
{
    merging->ranges = calloc(n_paths, sizeof *merging->ranges);
    return enough_memory(merging->ranges != NULL && armtol_tally_create(&merging->part) == ARMTOL_OK &&
                         armtol_tally_create(&merging->merged->tally) == ARMTOL_OK);
}

int merge_files(char *const paths[], size_t n_paths, merged *merged)
{
    merging merging = {.merged = merged};
    *merged = (struct merged){.path = NULL};
    const int code = get_memory(&merging, n_paths) ? merge_all(&merging, paths, n_paths) : EXIT_FAILED;
    free(merging.ranges);
    armtol_tally_destroy(merging.part);
    if (code != EXIT_OK) {
        merged_free(merged);
    }
    return code;
}

void merged_free(merged *merged)
{
    tally_head_free(&merged->head);
    armtol_tally_destroy(merged->tally);
    merged->tally = NULL;
}

bool merged_is_asked(const merged *merged, const cli_options *options)
{
    const bool same = options->action == CLI_ANSWER && options->verify == merged->head.total &&
                      options->seed == merged->head.seed;
    if (!same) {
        message("%s: the command in it is not the one that its arms were drawn for: the tally is damaged",
                merged->path);
    }
    return same;
}

bool merged_is_of(const merged *merged, const armtol_answer *answer)
{
    for (size_t i = 0; i < ARMTOL_TALLY_SUBJECT_COUNT; i++) {
        const armtol_tally_subject subject = (armtol_tally_subject)i;
        if (armtol_tally_fingerprint(answer, subject) != merged->head.fingerprints[i]) {
            message("%s: the command in it asks now for another %s than when the arms were drawn; expected the files "
                    "that it names, as they were, in this folder",
                    merged->path, armtol_tally_subject_name(subject));
            return false;
        }
    }
    return true;
}
