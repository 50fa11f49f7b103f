/*
 * How long armtol takes to merge a thousand tallies, and how much memory, beside ten: many_tallies ARMTOL FOLDER ARMS,
 * with so many arms a tally. The folder is there; the tallies are drawn here and taken away again. Ends with 1 where a
 * thousand take 2 MB more than ten, or more than a minute.
 */

#include "armtol/ask/arm_source.h"
#include "armtol/ask/options.h"
#include "armtol/ask/request.h"
#include "armtol/cluster/shard.h"
#include "console/message.h"

#include <fcntl.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { FEW = 10, MANY = 1000, NAME = 16 };

static char names[MANY][NAME];

static void need(bool fine, const char *what)
{
    if (!fine) {
        fprintf(stderr, "many_tallies: %s\n", what);
        exit(1);
    }
}

/* ---- tallies ---- */

/* As the command line would ask. Never freed: the program ends with it. */
static struct {
    cli_options options;
    arm_model model;
    request request;
    armtol_answer *answer;
} asked;

static void ask(char *arms)
{
    static char program[] = "armtol", arm[] = "puma560", joints[] = "--joints=0,.8,-1.6,0,.8,0",
                accuracy[] = "--accuracy=.5,.5,.5,.0002,.0002,.0002";
    static char *words[6] = {program, arm, joints, accuracy};
    words[4] = arms;
    need(cli_options_parse(5, words, &asked.options) == 0 && arm_source_read(&asked.options, &asked.model) == 0 &&
             request_make(&asked.request, &asked.options, &asked.model) == 0 &&
             request_answer(&asked.request, &asked.answer) == 0,
         "no answer");
}

static void write_tally(tally_head *head, uint64_t shard, const tally_content *content)
{
    head->shard = shard;
    const shard_range range = tally_head_range(head);
    const armtol_draw draw = {.samples = range.count, .seed = head->numbers[0]};
    need(armtol_tally_draw(asked.answer, &draw, range.first, content->arms, NULL) == ARMTOL_OK, "no arms");
    FILE *stream = fopen(names[shard - 1], "wb");
    need(stream != NULL, "no file");
    tally_file_write(stream, &(tally_written){head, content});
    need(fclose(stream) == 0, "no room for a tally");
}

static void write_tallies(uint64_t n, uint64_t each)
{
    static char arms[40];
    tally_content content = {.arms = NULL};
    snprintf(arms, sizeof arms, "--verify=%" PRIu64, n * each);
    ask(arms);
    tally_head head = shard_head(&asked.options, &tally_of_arms, asked.options.verify);
    head.n_shards = n;
    head.numbers[0] = asked.options.seed;
    for (size_t i = 0; i < ARMTOL_TALLY_SUBJECT_COUNT; i++) {
        head.fingerprints[i] = armtol_tally_fingerprint(asked.answer, (armtol_tally_subject)i);
    }
    need(armtol_tally_create(&content.arms) == ARMTOL_OK, "no memory");
    for (uint64_t shard = 1; shard <= n; shard++) {
        write_tally(&head, shard, &content);
    }
    tally_content_free(&content);
}

/* ---- the merge ---- */

typedef struct cost {
    double seconds, processor_seconds;
    long kilobytes;
} cost;

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + (double)time.tv_nsec * 1e-9;
}

static double seconds_of(const struct timeval *time)
{
    return (double)time->tv_sec + (double)time->tv_usec * 1e-6;
}

static void run_merge(const char *armtol, size_t n)
{
    static char merge[] = "merge", program[] = "armtol";
    static char *words[MANY + 3] = {program, merge};
    for (size_t i = 0; i < n; i++) {
        words[i + 2] = names[i];
    }
    words[n + 2] = NULL;
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    execv(armtol, words);
    _exit(127);
}

static cost merging(const char *armtol, size_t n)
{
    struct rusage usage;
    int status = 1;
    const double begin = now();
    const pid_t child = fork();
    if (child == 0) {
        run_merge(armtol, n);
    }
    need(child > 0 && wait4(child, &status, 0, &usage) == child && status == 0, "merging fails");
    const double processor = seconds_of(&usage.ru_utime) + seconds_of(&usage.ru_stime);
    return (cost){now() - begin, processor, usage.ru_maxrss};
}

static double megabytes(size_t n)
{
    double sum = 0;
    for (size_t i = 0; i < n; i++) {
        struct stat status;
        need(stat(names[i], &status) == 0, "no tally");
        sum += (double)status.st_size * 1e-6;
    }
    return sum;
}

static cost measure(const char *armtol, size_t n, uint64_t each)
{
    write_tallies(n, each);
    const cost cost = merging(armtol, n);
    printf("%5zu tallies of %" PRIu64 " arms, %.1f MB: merged in %.2f s (%.2f s of processor) with %ld kB of memory\n",
           n, each, megabytes(n), cost.seconds, cost.processor_seconds, cost.kilobytes);
    for (size_t i = 0; i < n; i++) {
        remove(names[i]);
    }
    return cost;
}

int main(int argc, char *argv[])
{
    char *const armtol = argc == 4 ? realpath(argv[1], NULL) : NULL;
    const uint64_t each = argc == 4 ? strtoull(argv[3], NULL, 10) : 0;
    message_start("many_tallies");
    need(armtol != NULL && each > 0, "usage: many_tallies ARMTOL FOLDER ARMS");
    need(chdir(argv[2]) == 0, "no such folder");
    for (size_t i = 0; i < MANY; i++) {
        snprintf(names[i], sizeof names[i], "%zu.tally", i);
    }
    const cost few = measure(armtol, FEW, each), many = measure(armtol, MANY, each);
    need(many.kilobytes - few.kilobytes < 2048, "memory grows with the number of tallies");
    need(many.seconds < 60, "a thousand tallies take more than a minute");
    free(armtol);
    return 0;
}
