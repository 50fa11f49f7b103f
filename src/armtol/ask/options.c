#include "armtol/ask/options.h"

#include "armtol/arrivals.h"
#include "armtol/ask/number_list.h"
#include "armtol/axes.h"
#include "console/exit_code.h"
#include "console/flags.h"
#include "console/message.h"
#include "console/number.h"
#include "console/word.h"

#include <string.h>

enum { MOST_THREADS = 1024 };
#define DEFAULT_GAP 0.01
#define DEFAULT_BOXES 1000000
#define MOST_BOXES 1000000000u
#define MOST_CYCLES 1000000u
#define DEFAULT_SIGMA 3.0
#define DEFAULT_SEED 1987

/* ---- what an option takes ---- */

typedef struct option_row option_row;

/* An option as it stands on the command line. */
typedef struct typed_option {
    const option_row *row;
    const char *argument; /* NULL where it has none */
    cli_options *options;
    void *place; /* in the options, of what it sets */
} typed_option;

/* All about an option. */
struct option_row {
    const char *name;
    bool (*take)(const typed_option *typed); /* false after a message */
    size_t place;          /* in cli_options, of what it sets; 0 where the taker knows better */
    unsigned sets;         /* to what, where it has no argument; else 0 */
    const char *exclusive; /* the options of which one may be chosen */
    size_t given;          /* in cli_options, where it is noted that it was read; 0 for nowhere */
    uint64_t least, most;  /* of a whole number */
    double low, high;      /* of a number, and what to say of one that is not between them */
    const char *beyond;
    bool percent;          /* the number is */
    bool many;             /* it may be repeated */
    bool optional;         /* the argument may be missing, or be a number and the next word */
};

static bool take_text(const typed_option *typed)
{
    *(const char **)typed->place = typed->argument;
    return true;
}

static bool take_flag(const typed_option *typed)
{
    return *(bool *)typed->place = true;
}

static bool take_action(const typed_option *typed)
{
    typed->options->action = (cli_action)typed->row->sets;
    return true;
}

/* Whether nothing else was chosen before. */
static bool check_exclusive(const typed_option *typed, unsigned chosen)
{
    const bool fine = chosen == 0 || chosen == typed->row->sets;
    if (!fine) {
        message("%s exclude each other", typed->row->exclusive);
    }
    return fine;
}

static bool take_format(const typed_option *typed)
{
    const unsigned chosen = typed->options->format;
    typed->options->format = (output_format)typed->row->sets;
    return check_exclusive(typed, chosen);
}

static bool take_units(const typed_option *typed)
{
    unit_choice *const units = typed->place;
    const unsigned chosen = *units;
    *units = (unit_choice)typed->row->sets;
    return check_exclusive(typed, chosen);
}

static bool take_whole(const typed_option *typed)
{
    const option_row *row = typed->row;
    return whole_number_parse(row->name, typed->argument, row->least, row->most, typed->place);
}

static bool take_positive(const typed_option *typed)
{
    return number_option_positive(typed->row->name, typed->argument, typed->place);
}

static bool take_range(const typed_option *typed)
{
    const option_row *row = typed->row;
    double value;
    if (!number_option_parse(row->name, typed->argument, &value)) {
        return false;
    }
    const bool fine = value >= row->low && value <= row->high;
    if (!fine) {
        message("%s: %s %s %g to %g%s", row->name, message_quote(typed->argument, &(quoted){""}), row->beyond, row->low,
                row->high, row->percent ? " (percent)" : "");
    }
    *(double *)typed->place = row->percent ? value / 100 : value;
    return fine;
}

/* The place of the argument among the names, or count after a message. */
static size_t choose(const typed_option *typed, const char *const names[], size_t count)
{
    const char *option = typed->row->name;
    const size_t chosen = word_among(typed->argument, names, count);
    if (chosen == count) {
        char known[64] = "";
        for (size_t i = 0; i < count; i++) {
            strcat(known, i == 0 ? "" : i + 1 < count ? ", " : " or ");
            strcat(known, names[i]);
        }
        message("%s: unknown %s %s; expected %s", option, option + 2, message_quote(typed->argument, &(quoted){""}),
                known);
    }
    return chosen;
}

static bool take_method(const typed_option *typed)
{
    const char *names[ARMTOL_METHOD_COUNT];
    for (size_t i = 0; i < ARMTOL_METHOD_COUNT; i++) {
        names[i] = armtol_method_name((armtol_method)i);
    }
    typed->options->method = (armtol_method)choose(typed, names, ARMTOL_METHOD_COUNT);
    return typed->options->method != ARMTOL_METHOD_COUNT;
}

static bool take_frame(const typed_option *typed)
{
    static const char *const names[ARMTOL_FRAME_COUNT] = {"base", "tool"};
    typed->options->frame = (armtol_frame)choose(typed, names, ARMTOL_FRAME_COUNT);
    return typed->options->frame != ARMTOL_FRAME_COUNT;
}

static bool take_wish(const typed_option *typed)
{
    static const char *const names[] = {"tolerances", "motors"};
    const size_t chosen = choose(typed, names, 2);
    typed->options->wish_motors = chosen == 1;
    return chosen != 2;
}

/* "I/N" */
static bool take_shard(const typed_option *typed)
{
    cli_options *const options = typed->options;
    char shard[WORD];
    const char *at = typed->argument;
    const bool fine = word_take(&at, "/", shard) && *at == '/' &&
                      whole_number_of(at + 1, 1, MOST_SHARDS, &options->n_shards) &&
                      whole_number_of(shard, 1, options->n_shards, &options->shard);
    if (!fine) {
        message("--shard: %s is no shard; expected I/N, I from 1 to N and N at most %u",
                message_quote(typed->argument, &(quoted){""}), MOST_SHARDS);
    }
    return fine;
}

/* One more text of a list, of which there are `most` at the most. */
static bool add(const char *text, const char *texts[], size_t *n, size_t most, const char *option, const char *what)
{
    if (*n == most) {
        message("%s: more than %zu %s", option, most, what);
        return false;
    }
    texts[(*n)++] = text;
    return true;
}

static bool take_cycles(const typed_option *typed)
{
    typed->options->cycles = ARMTOL_ARRIVAL_CYCLES;
    return typed->argument == NULL || take_whole(typed);
}

static bool take_payload(const typed_option *typed)
{
    cli_options *const options = typed->options;
    return add(typed->argument, options->payloads, &options->n_payloads, MOST_PAYLOADS, "--payload", "load cases");
}

static bool take_at(const typed_option *typed)
{
    cli_options *const options = typed->options;
    return add(typed->argument, options->at, &options->n_at, MOST_AT, "--at",
               "positions; expected a file of them, --at-file");
}

/* ---- the options ---- */

#define AT(member) offsetof(cli_options, member)

static const char angle_options[] = "--degrees and --radians";
static const char length_options[] = "--mm, --metres and --inches";
static const char format_options[] = "--json and --csv";
static const char out_of_range[] = "is out of range; expected";

enum { ROW_HELP, ROW_VERSION };

static const option_row rows[] = {
    [ROW_HELP] = {"--help", take_action, .sets = CLI_HELP},
    [ROW_VERSION] = {"--version", take_action, .sets = CLI_VERSION},
    {"--list", take_action, .sets = CLI_LIST},
    {"--show", take_action, .sets = CLI_SHOW},
    {"--links", take_action, .sets = CLI_LINKS},
    {"--branches", take_action, .sets = CLI_BRANCHES},
    {"--json", take_format, .sets = OUTPUT_JSON, .exclusive = format_options},
    {"--csv", take_format, .sets = OUTPUT_CSV, .exclusive = format_options},
    {"--degrees", take_units, AT(angle), UNITS_SMALL, angle_options},
    {"--radians", take_units, AT(angle), UNITS_LARGE, angle_options},
    {"--mm", take_units, AT(length), UNITS_SMALL, length_options},
    {"--metres", take_units, AT(length), UNITS_LARGE, length_options},
    {"--inches", take_units, AT(length), UNITS_INCHES, length_options},
    /* the arm */
    {"--base", take_text, AT(base)},
    {"--tip", take_text, AT(tip)},
    {"--snap", take_range, AT(snap), .high = ARMTOL_MOST_SNAP, .beyond = out_of_range},
    {"--as-is", take_flag, AT(as_is), true},
    {"--xacro", take_flag, AT(xacro), true},
    {"--ignore-limits", take_flag, AT(ignore_limits), true},
    {"--craig", take_flag, AT(craig), true},
    /* what is known and wanted */
    {"--joints", take_text, AT(joints)},
    {"--poses", take_text, AT(poses)},
    {"--at", take_at, .many = true},
    {"--at-file", take_text, AT(at_file)},
    {"--near", take_text, AT(near)},
    {"--region", take_text, AT(region)},
    {"--gap", take_range, AT(gap), .given = AT(gap_given), .low = 1e-4, .high = 1000, .beyond = out_of_range,
     .percent = true},
    {"--most", take_whole, AT(most), .given = AT(most_given), .least = 1, .most = MOST_BOXES},
    {"--accuracy", take_text, AT(accuracy)},
    {"--tolerances", take_text, AT(tolerances)},
    {"--against", take_text, AT(against)},
    {"--deviations", take_text, AT(deviations)},
    {"--tool-offset", take_text, AT(tool_offset)},
    {"--frame", take_frame},
    {"--method", take_method},
    {"--sigma", take_positive, AT(sigma), .given = AT(sigma_given)},
    {"--delta", take_text, AT(delta)},
    {"--weights", take_text, AT(weights)},
    {"--given", take_text, AT(given)},
    {"--drawing", take_text, AT(drawing)},
    {"--write-drawing", take_text, AT(write_drawing)},
    {"--spread", take_text, AT(spread)},
    {"--wish", take_wish},
    /* what loads the arm */
    {"--drives", take_text, AT(drives)},
    {"--payload", take_payload, .many = true},
    {"--gravity", take_text, AT(gravity)},
    {"--force", take_text, AT(force)},
    {"--compensated", take_range, AT(compensated), .high = 1, .beyond = "is not from"},
    /* what to do, and how to show it */
    {"--budget", take_flag, AT(budget), true},
    {"--grades", take_flag, AT(grades), true},
    {"--tool-pose", take_flag, AT(tool_pose), true},
    {"--svg", take_text, AT(svg)},
    {"--verify", take_whole, AT(verify), .least = 1, .most = MOST_ARMS},
    {"--seed", take_whole, AT(seed), .given = AT(seed_given), .most = UINT64_MAX},
    {"--iso9283", take_cycles, AT(cycles), .least = 2, .most = MOST_CYCLES, .optional = true},
    {"--threads", take_whole, AT(threads), .least = 1, .most = MOST_THREADS},
    {"--shard", take_shard},
    {"--tally", take_text, AT(tally)},
    /* of a map: what they mean is for the map to say */
    {"--plane", take_text, AT(map.plane), .given = AT(map.given)},
    {"--offset", take_text, AT(map.offset), .given = AT(map.given)},
    {"--range", take_text, AT(map.range), .given = AT(map.given)},
    {"--grid", take_text, AT(map.grid), .given = AT(map.given)},
    {"--step", take_text, AT(map.step), .given = AT(map.given)},
    {"--orientation", take_text, AT(map.orientation), .given = AT(map.given)},
    {"--what", take_text, AT(map.what), .given = AT(map.given)},
    {"--of", take_text, AT(map.of), .given = AT(map.given)},
    {"--contour", take_text, AT(map.contour), .given = AT(map.given)},
    {"--tsv", take_text, AT(map.tsv), .given = AT(map.given)},
};

enum { ROWS = sizeof rows / sizeof rows[0], FIRST_LONG = 256 /* getopt's number of the first row */ };

/* ---- the command line ---- */

typedef struct reading {
    cli_options *options;
    bool seen[ROWS];
    const option_row *waits; /* the last option, where its argument may be the next word */
} reading;

/* Of an option with an argument only one can hold, but for one a load case, or a pose. */
static bool is_first(const option_row *row, bool *seen)
{
    const bool fine = !*seen || row->many || row->sets != 0;
    *seen = true;
    if (!fine) {
        message("%s: is given twice; expected once", row->name);
    }
    return fine;
}

static bool take(int option, const char *argument, void *context)
{
    reading *reading = context;
    const size_t i = option == 'h'   ? ROW_HELP
                     : option == 'V' ? ROW_VERSION
                                     : (size_t)(option - FIRST_LONG);
    const option_row *row = &rows[i];
    char *const options = (char *)reading->options;
    if (row->given != 0) {
        bool *given = (void *)(options + row->given);
        *given = true;
    }
    reading->waits = row->optional && argument == NULL ? row : NULL;
    return is_first(row, &reading->seen[i]) &&
           row->take(&(typed_option){row, argument, reading->options, options + row->place});
}

/* Behind an option that waits for it, a number is its argument; behind --xacro, a NAME:=VALUE is for xacro. */
static bool take_word(const char *argument, reading *reading)
{
    cli_options *const options = reading->options;
    const option_row *waits = reading->waits;
    reading->waits = NULL;
    if (waits != NULL && argument[strspn(argument, "0123456789")] == '\0') {
        return waits->take(&(typed_option){waits, argument, options, (char *)options + waits->place});
    }
    if (options->xacro && strstr(argument, ":=") != NULL) {
        return add(argument, options->xacro_arguments, &options->n_xacro_arguments, XACRO_ARGUMENTS_MOST, "--xacro",
                   "arguments");
    }
    if (options->arm == NULL && options->action == CLI_ANSWER && strcmp(argument, "map") == 0) {
        options->action = CLI_MAP;
        return true;
    }
    if (options->arm != NULL) {
        return flags_wrong("unexpected argument", argument);
    }
    options->arm = argument;
    return true;
}

static void list_names(struct option names[])
{
    for (int i = 0; i < ROWS; i++) {
        const int argument = rows[i].sets != 0 ? no_argument : rows[i].optional ? optional_argument : required_argument;
        names[i] = (struct option){rows[i].name + 2, argument, NULL, FIRST_LONG + i};
    }
}

/* The arm, and what is for xacro, may stand before, between and behind the options. */
static bool read_all(int argc, char *argv[], cli_options *options)
{
    reading reading = {.options = options};
    struct option names[ROWS + 1] = {{NULL, 0, NULL, 0}};
    list_names(names);
    for (;;) {
        if (!flags_read(argc, argv, "+:hV", names, take, &reading)) {
            return false;
        }
        if (optind >= argc) {
            return true;
        }
        if (!take_word(argv[optind], &reading)) {
            return false;
        }
        argc -= optind;
        argv += optind; /* the word is passed over like a program's name */
        optind = 1;
    }
}

int cli_options_parse(int argc, char *argv[], cli_options *options)
{
    *options = (cli_options){.snap = ARMTOL_USUAL_SNAP, .sigma = DEFAULT_SIGMA, .seed = DEFAULT_SEED,
                             .gap = DEFAULT_GAP, .most = DEFAULT_BOXES};
    options->words = argv + (argc > 0);
    options->n_words = (size_t)(argc - (argc > 0));
    optind = 0; /* it may not be the first command line that is read, nor the one before have been read to its end */
    if (!read_all(argc, argv, options)) {
        return EXIT_WRONG;
    }
    const char *fault = cli_options_fault(options);
    if (fault != NULL) {
        message("%s", fault);
        return EXIT_WRONG;
    }
    return EXIT_OK;
}
