#include "cluster/shard_runs.h"

#include "armtol/runs.h"

#include "unity.h"

#include <string.h>

void join(const char *words[SHARD_WORDS], const char *const more[])
{
    size_t n = 0, i = 0;
    while (words[n] != NULL) {
        n++;
    }
    do {
        words[n++] = more[i];
    } while (more[i++] != NULL);
}

void draw_shard(process *process, const char *folder, const char *first, const char *const question[],
                const char *shard, const char *tally)
{
    const char *words[SHARD_WORDS] = {first, NULL};
    join(words, question);
    join(words, (const char *const[]){"--shard", shard, "--tally", tally, NULL});
    run(process, folder, words);
}

void merge(process *process, const char *folder, const char *const tallies[])
{
    const char *words[SHARD_WORDS] = {"merge", NULL};
    join(words, tallies);
    run(process, folder, words);
}

void check_refused(const char *folder, const char *const tallies[], const char *words)
{
    process process;
    merge(&process, folder, tallies);
    process_check_status(&process, 2, words);
    text_check("", 0, &process.output, words);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(process.errors.bytes, words), process.errors.bytes);
}

string path_in(const char *folder, const char *name)
{
    return string_of("%s/%s", folder, name);
}
