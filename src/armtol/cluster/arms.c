#include "armtol/cluster/arms.h"

#include "armtol/ask/watched.h"
#include "armtol/cluster/shard.h"
#include "console/exit_code.h"
#include "console/message.h"

static void find_fingerprints(const armtol_answer *answer, uint64_t fingerprints[])
{
    for (size_t i = 0; i < ARMTOL_TALLY_SUBJECT_COUNT; i++) {
        fingerprints[i] = armtol_tally_fingerprint(answer, (armtol_tally_subject)i);
    }
}

typedef struct asked {
    const request *request;
    const armtol_answer *answer;
    size_t n_threads;
} asked;

static int draw(const shard *shard)
{
    const asked *asked = shard->asked;
    const shard_range range = tally_head_range(shard->head);
    const armtol_draw draw = {.samples = range.count, .seed = asked->request->options->seed,
                              .n_threads = asked->n_threads};
    armtol_tally *tally = shard->content->arms;
    armtol_fault fault;
    if (watched_tally_draw(asked->answer, &draw, range.first, tally, &fault) != ARMTOL_OK) {
        return request_failed(asked->request, &fault);
    }
    if (!armtol_tally_is_of(tally, range.first, range.count)) {
        message("interrupted: no tally is written");
        return EXIT_FAILED;
    }
    return EXIT_OK;
}

int arms_shard(const request *request, const armtol_answer *answer, size_t n_threads)
{
    const cli_options *options = request->options;
    const asked asked = {request, answer, n_threads};
    tally_content content = {.arms = NULL};
    tally_head head = shard_head(options, &tally_of_arms, options->verify);
    head.numbers[0] = options->seed;
    find_fingerprints(answer, head.fingerprints);
    const int code = shard_run(&(shard){&head, &content, draw, &asked}, options->tally);
    tally_content_free(&content);
    return code;
}

bool arms_are_of(const merged *merged, const armtol_answer *answer)
{
    uint64_t fingerprints[TALLY_SUBJECTS] = {0};
    find_fingerprints(answer, fingerprints);
    return merged_is_of(merged, fingerprints);
}
