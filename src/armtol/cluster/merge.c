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
    tally_content part;
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

/* Takes the head over where it is the one of the first arms, or rows. */
static void keep_first(merged *merged, const char *path, tally_head *head)
{
    if (merged->path == NULL || tally_head_range(head).first < tally_head_range(&merged->head).first) {
        const tally_head kept = merged->head;
        merged->head = *head;
        merged->path = path;
        *head = kept;
    }
}

/* The first tally says how much there is of it all. */
static int start(merged *merged, const tally_head *head)
{
    const bool fine = head->form->start(&merged->content, head, head->total);
    return enough_memory(fine) ? EXIT_OK : EXIT_FAILED;
}

static int add(merging *merging, const char *path, tally_head *head)
{
    merged *merged = merging->merged;
    if (!check_version(path, head) || (merged->path != NULL && !check_same(merged, path, head))) {
        return EXIT_WRONG;
    }
    const int code = merged->path == NULL ? start(merged, head) : EXIT_OK;
    if (code == EXIT_OK) {
        merging->ranges[merging->n_ranges++] = (covered){tally_head_range(head), head->n_shards, path};
        head->form->add(&merged->content, &merging->part, head);
        keep_first(merged, path, head);
    }
    return code;
}

static int merge_file(merging *merging, const char *path)
{
    tally_head head;
    FILE *stream = input_file_open("", path, "");
    if (stream == NULL) {
        return EXIT_WRONG;
    }
    const tally_result result = tally_file_read(stream, path, &head, &merging->part);
    fclose(stream);
    if (result != TALLY_WHOLE) {
        return EXIT_WRONG; /* what the machine failed at is noted */
    }
    const int code = add(merging, path, &head);
    tally_head_free(&head);
    return code;
}

/* ---- all of them ---- */

static int merge_all(merging *merging, char *const paths[], size_t n_paths)
{
    int code = EXIT_OK;
    for (size_t i = 0; i < n_paths && code == EXIT_OK; i++) {
        code = merge_file(merging, paths[i]);
    }
    if (code == EXIT_OK && !coverage_check(merging->ranges, merging->n_ranges, &merging->merged->head)) {
        code = EXIT_WRONG;
    }
    return code;
}

int merge_files(char *const paths[], size_t n_paths, merged *merged)
{
    merging merging = {.merged = merged, .ranges = calloc(n_paths, sizeof *merging.ranges)};
    *merged = (struct merged){.path = NULL};
    const int code = enough_memory(merging.ranges != NULL) ? merge_all(&merging, paths, n_paths) : EXIT_FAILED;
    free(merging.ranges);
    tally_content_free(&merging.part);
    if (code != EXIT_OK) {
        merged_free(merged);
    }
    return code;
}

void merged_free(merged *merged)
{
    tally_head_free(&merged->head);
    tally_content_free(&merged->content);
}

static bool asks_for(const cli_options *options, const tally_head *head)
{
    return head->form == &tally_of_rows ? options->action == CLI_MAP
                                        : options->action == CLI_ANSWER && options->verify == head->total &&
                                              options->seed == head->numbers[0];
}

bool merged_is_asked(const merged *merged, const cli_options *options)
{
    const bool same = asks_for(options, &merged->head);
    if (!same) {
        message("%s: the command in it is not the one that its %s were drawn for: the tally is damaged", merged->path,
                merged->head.form->many);
    }
    return same;
}

bool merged_is_of(const merged *merged, const uint64_t fingerprints[])
{
    const tally_form *form = merged->head.form;
    for (size_t i = 0; i < form->n_subjects; i++) {
        if (fingerprints[i] != merged->head.fingerprints[i]) {
            message("%s: the command in it asks now for another %s than when the %s were drawn; expected the files "
                    "that it names, as they were, in this folder",
                    merged->path, form->subject(i), form->many);
            return false;
        }
    }
    return true;
}
