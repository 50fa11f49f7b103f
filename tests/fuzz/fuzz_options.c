/*
 * Command lines: the first byte says of which program, each line behind it is an argument. Either they are taken, and
 * all that came out is within its range, or there is one message.
 */

#include "fuzz/harness.h"
#include "fuzz/require.h"

#include "1987/options.h"
#include "armtol/ask/options.h"
#include "console/exit_code.h"
#include "console/message.h"
#include "lab/joint_orders/options.h"
#include "lab/yield/options.h"

#include <getopt.h>
#include <math.h>
#include <string.h>

enum { MOST_ARGUMENTS = 40, MOST_BYTES = 4096 };

typedef struct command_line {
    int argc;
    char *argv[MOST_ARGUMENTS + 1];
    char text[MOST_BYTES + 1];
} command_line;

static void cut_up(command_line *line, const uint8_t *data, size_t size)
{
    static char name[] = "program";
    const size_t length = size < MOST_BYTES ? size : MOST_BYTES;
    memcpy(line->text, data, length);
    line->text[length] = '\0';
    line->argc = 1;
    line->argv[0] = name;
    char *at = line->text;
    while (*at != '\0' && line->argc < MOST_ARGUMENTS) {
        line->argv[line->argc++] = at;
        at += strcspn(at, "\n");
        if (*at == '\n') {
            *at++ = '\0';
        }
    }
    line->argv[line->argc] = NULL;
}

/* The text of an argument, from somewhere in it on. */
static bool is_typed(const command_line *line, const char *text)
{
    return text == NULL || (text >= line->text && text <= line->text + MOST_BYTES);
}

static int check_1987(command_line *line)
{
    options options;
    const int code = options_parse(line->argc, line->argv, &options);
    if (code == EXIT_OK) {
        REQUIRE(options.run >= 1 && options.run <= 999999);
        REQUIRE(options.action <= ACTION_VERSION);
        REQUIRE(strcmp(options.folder, ".") == 0 || is_typed(line, options.folder));
    }
    return code;
}

static void check_shard(const cli_options *options)
{
    REQUIRE((options->shard != 0) == (options->tally != NULL) && (options->shard != 0) == (options->n_shards != 0));
    REQUIRE(options->shard <= options->n_shards && options->n_shards <= MOST_SHARDS);
}

static void check_question(const cli_options *options)
{
    const bool at = options->n_at > 0 || options->at_file != NULL;
    const bool compared = options->against != NULL || options->deviations != NULL;
    REQUIRE((options->joints != NULL) + (options->poses != NULL) + at + (options->region != NULL) == 1);
    REQUIRE((options->accuracy != NULL || options->tolerances != NULL) != compared);
    REQUIRE(options->weights == NULL || (options->tolerances == NULL && options->method != ARMTOL_METHOD_SPHERE));
    REQUIRE(options->spread == NULL || options->region == NULL);
    REQUIRE(options->delta == NULL || options->method == ARMTOL_METHOD_SPHERE);
    REQUIRE(options->format != OUTPUT_CSV || (!options->budget && options->verify == 0));
    REQUIRE(!options->grades || !compared);
    REQUIRE((!options->seed_given && options->threads == 0) || options->verify != 0);
    check_shard(options);
    REQUIRE(options->n_shards <= options->verify);
    REQUIRE(options->cycles == 0 || (options->cycles >= 2 && options->verify != 0 && options->shard == 0));
}

static void check_map(const command_line *line, const cli_options *options)
{
    const map_texts *map = &options->map;
    const char *const texts[] = {map->plane, map->range, map->grid, map->step, map->offset, map->orientation, map->what,
                                 map->of,
                                 map->contour, map->tsv, options->svg};
    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
        REQUIRE(is_typed(line, texts[i]));
    }
    REQUIRE(options->arm != NULL && map->plane != NULL && map->range != NULL);
    REQUIRE(map->grid == NULL || map->step == NULL);
    REQUIRE(options->format != OUTPUT_CSV && options->verify == 0 && !options->budget);
    REQUIRE(options->threads == 0 || options->shard != 0);
    check_shard(options);
    REQUIRE(!options->grades);
}

static int check_armtol(command_line *line)
{
    cli_options options;
    const int code = cli_options_parse(line->argc, line->argv, &options);
    if (code == EXIT_OK) {
        const char *const texts[] = {options.arm,         options.base,    options.tip,   options.joints,
                                     options.poses,       options.accuracy, options.delta, options.weights,
                                     options.tool_offset, options.tolerances, options.tally,
                                     options.spread};
        for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
            REQUIRE(is_typed(line, texts[i]));
        }
        REQUIRE(options.sigma > 0 && isfinite(options.sigma));
        REQUIRE(options.threads <= 1024 && options.verify <= 1000000000000u);
        REQUIRE(options.method < ARMTOL_METHOD_COUNT && options.frame < ARMTOL_FRAME_COUNT);
        REQUIRE(options.format <= OUTPUT_CSV && options.length <= UNITS_INCHES && options.angle <= UNITS_LARGE);
        for (size_t i = 0; i < options.n_xacro_arguments; i++) {
            REQUIRE(options.xacro && strstr(options.xacro_arguments[i], ":=") != NULL);
        }
        REQUIRE(options.n_xacro_arguments <= XACRO_ARGUMENTS_MOST);
        const bool needs_arm =
            options.action == CLI_ANSWER || options.action == CLI_SHOW || options.action == CLI_LINKS;
        REQUIRE(!needs_arm || options.arm != NULL);
        if (options.action == CLI_ANSWER) {
            check_question(&options);
        }
        if (options.action == CLI_MAP) {
            check_map(line, &options);
        }
    }
    return code;
}

static int check_yield(command_line *line)
{
    yield_options options;
    const int code = yield_options_parse(line->argc, line->argv, &options);
    if (code == EXIT_OK && options.action == YIELD_RUN) {
        REQUIRE(options.published != NULL && is_typed(line, options.published));
        REQUIRE(options.samples >= 1 && options.samples <= 10000000);
        REQUIRE(options.format < FORMAT_COUNT);
    }
    return code;
}

static int check_orders(command_line *line)
{
    orders_options options;
    const int code = orders_options_parse(line->argc, line->argv, &options);
    if (code == EXIT_OK && options.action == ORDERS_RUN) {
        REQUIRE(options.published != NULL && is_typed(line, options.published));
        REQUIRE(options.format < FORMAT_COUNT);
    }
    return code;
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
    static int (*const programs[])(command_line *) = {check_armtol, check_1987, check_yield, check_orders};
    command_line line;
    if (size == 0) {
        return 0;
    }
    caught_forget();
    cut_up(&line, data + 1, size - 1);
    optind = 0; /* glibc's getopt then starts anew */
    const int code = programs[data[0] % 4](&line);
    REQUIRE(code == EXIT_OK || code == EXIT_WRONG);
    REQUIRE(code == EXIT_OK ? caught_nothing() : caught_one_message());
    return 0;
}
