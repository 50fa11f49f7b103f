#include "armtol/ask/options.h"

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
#define DEFAULT_SIGMA 3.0
#define DEFAULT_SEED 1987

enum {
    OPTION_JOINTS = 256,
    OPTION_POSES,
    OPTION_AT,
    OPTION_AT_FILE,
    OPTION_NEAR,
    OPTION_BRANCHES,
    OPTION_REGION,
    OPTION_GAP,
    OPTION_MOST,
    OPTION_ACCURACY,
    OPTION_TOLERANCES,
    OPTION_DEGREES,
    OPTION_RADIANS,
    OPTION_MM,
    OPTION_METRES,
    OPTION_INCHES,
    OPTION_TOOL_OFFSET,
    OPTION_FRAME,
    OPTION_METHOD,
    OPTION_SIGMA,
    OPTION_DELTA,
    OPTION_WEIGHTS,
    OPTION_GIVEN,
    OPTION_WISH,
    OPTION_DRIVES,
    OPTION_PAYLOAD,
    OPTION_GRAVITY,
    OPTION_FORCE,
    OPTION_COMPENSATED,
    OPTION_AGAINST,
    OPTION_DEVIATIONS,
    OPTION_BUDGET,
    OPTION_TOOL_POSE,
    OPTION_VERIFY,
    OPTION_SEED,
    OPTION_THREADS,
    OPTION_SHARD,
    OPTION_TALLY,
    OPTION_BASE,
    OPTION_TIP,
    OPTION_SNAP,
    OPTION_AS_IS,
    OPTION_XACRO,
    OPTION_IGNORE_LIMITS,
    OPTION_JSON,
    OPTION_CSV,
    OPTION_LIST,
    OPTION_LINKS,
    OPTION_SHOW,
    OPTION_CRAIG,
    OPTION_SVG,
    OPTION_PLANE,
    OPTION_OFFSET,
    OPTION_RANGE,
    OPTION_GRID,
    OPTION_STEP,
    OPTION_ORIENTATION,
    OPTION_WHAT,
    OPTION_OF,
    OPTION_CONTOUR,
    OPTION_TSV
};

static const struct option long_options[] = {
    {"joints", required_argument, NULL, OPTION_JOINTS},
    {"poses", required_argument, NULL, OPTION_POSES},
    {"at", required_argument, NULL, OPTION_AT},
    {"at-file", required_argument, NULL, OPTION_AT_FILE},
    {"near", required_argument, NULL, OPTION_NEAR},
    {"branches", no_argument, NULL, OPTION_BRANCHES},
    {"region", required_argument, NULL, OPTION_REGION},
    {"gap", required_argument, NULL, OPTION_GAP},
    {"most", required_argument, NULL, OPTION_MOST},
    {"accuracy", required_argument, NULL, OPTION_ACCURACY},
    {"tolerances", required_argument, NULL, OPTION_TOLERANCES},
    {"degrees", no_argument, NULL, OPTION_DEGREES},
    {"radians", no_argument, NULL, OPTION_RADIANS},
    {"mm", no_argument, NULL, OPTION_MM},
    {"metres", no_argument, NULL, OPTION_METRES},
    {"inches", no_argument, NULL, OPTION_INCHES},
    {"tool-offset", required_argument, NULL, OPTION_TOOL_OFFSET},
    {"frame", required_argument, NULL, OPTION_FRAME},
    {"method", required_argument, NULL, OPTION_METHOD},
    {"sigma", required_argument, NULL, OPTION_SIGMA},
    {"delta", required_argument, NULL, OPTION_DELTA},
    {"weights", required_argument, NULL, OPTION_WEIGHTS},
    {"given", required_argument, NULL, OPTION_GIVEN},
    {"wish", required_argument, NULL, OPTION_WISH},
    {"drives", required_argument, NULL, OPTION_DRIVES},
    {"payload", required_argument, NULL, OPTION_PAYLOAD},
    {"gravity", required_argument, NULL, OPTION_GRAVITY},
    {"force", required_argument, NULL, OPTION_FORCE},
    {"compensated", required_argument, NULL, OPTION_COMPENSATED},
    {"against", required_argument, NULL, OPTION_AGAINST},
    {"deviations", required_argument, NULL, OPTION_DEVIATIONS},
    {"budget", no_argument, NULL, OPTION_BUDGET},
    {"tool-pose", no_argument, NULL, OPTION_TOOL_POSE},
    {"verify", required_argument, NULL, OPTION_VERIFY},
    {"seed", required_argument, NULL, OPTION_SEED},
    {"threads", required_argument, NULL, OPTION_THREADS},
    {"shard", required_argument, NULL, OPTION_SHARD},
    {"tally", required_argument, NULL, OPTION_TALLY},
    {"base", required_argument, NULL, OPTION_BASE},
    {"tip", required_argument, NULL, OPTION_TIP},
    {"snap", required_argument, NULL, OPTION_SNAP},
    {"as-is", no_argument, NULL, OPTION_AS_IS},
    {"xacro", no_argument, NULL, OPTION_XACRO},
    {"ignore-limits", no_argument, NULL, OPTION_IGNORE_LIMITS},
    {"json", no_argument, NULL, OPTION_JSON},
    {"csv", no_argument, NULL, OPTION_CSV},
    {"list", no_argument, NULL, OPTION_LIST},
    {"links", no_argument, NULL, OPTION_LINKS},
    {"show", no_argument, NULL, OPTION_SHOW},
    {"craig", no_argument, NULL, OPTION_CRAIG},
    {"svg", required_argument, NULL, OPTION_SVG},
    {"plane", required_argument, NULL, OPTION_PLANE},
    {"offset", required_argument, NULL, OPTION_OFFSET},
    {"range", required_argument, NULL, OPTION_RANGE},
    {"grid", required_argument, NULL, OPTION_GRID},
    {"step", required_argument, NULL, OPTION_STEP},
    {"orientation", required_argument, NULL, OPTION_ORIENTATION},
    {"what", required_argument, NULL, OPTION_WHAT},
    {"of", required_argument, NULL, OPTION_OF},
    {"contour", required_argument, NULL, OPTION_CONTOUR},
    {"tsv", required_argument, NULL, OPTION_TSV},
    {"help", no_argument, NULL, 'h'},
    {"version", no_argument, NULL, 'V'},
    {NULL, 0, NULL, 0},
};

static const char length_options[] = "--mm, --metres and --inches";

static const char *const frame_names[ARMTOL_FRAME_COUNT] = {"base", "tool"};

/* The place of a text among the names, or count after a message. */
static size_t choose(const char *option, const char *text, const char *const names[], size_t count)
{
    char known[64] = "";
    for (size_t i = 0; i < count; i++) {
        if (strcmp(text, names[i]) == 0) {
            return i;
        }
        strcat(known, i == 0 ? "" : i + 1 < count ? ", " : " or ");
        strcat(known, names[i]);
    }
    message("%s: unknown %s %s; expected %s", option, option + 2, message_quote(text, &(quoted){""}), known);
    return count;
}

static bool take_method(const char *text, armtol_method *method)
{
    const char *names[ARMTOL_METHOD_COUNT];
    for (size_t i = 0; i < ARMTOL_METHOD_COUNT; i++) {
        names[i] = armtol_method_name((armtol_method)i);
    }
    const size_t i = choose("--method", text, names, ARMTOL_METHOD_COUNT);
    *method = (armtol_method)i;
    return i < ARMTOL_METHOD_COUNT;
}

static bool take_frame(const char *text, armtol_frame *frame)
{
    const size_t i = choose("--frame", text, frame_names, ARMTOL_FRAME_COUNT);
    *frame = (armtol_frame)i;
    return i < ARMTOL_FRAME_COUNT;
}

static bool take_snap(const char *text, double *snap)
{
    if (!number_option_parse("--snap", text, snap)) {
        return false;
    }
    const bool fine = *snap >= 0 && *snap <= ARMTOL_MOST_SNAP;
    if (!fine) {
        message("--snap: %s is out of range; expected 0 to %g", message_quote(text, &(quoted){""}), ARMTOL_MOST_SNAP);
    }
    return fine;
}

/* In percent. */
static bool take_gap(const char *text, cli_options *options)
{
    double gap;
    if (!number_option_parse("--gap", text, &gap)) {
        return false;
    }
    const bool fine = gap >= 1e-4 && gap <= 1000;
    if (!fine) {
        message("--gap: %s is out of range; expected 0.0001 to 1000 (percent)", message_quote(text, &(quoted){""}));
    }
    options->gap = gap / 100;
    options->gap_given = true;
    return fine;
}

static bool take_most(const char *text, cli_options *options)
{
    options->most_given = true;
    return whole_number_parse("--most", text, 1, MOST_BOXES, &options->most);
}

static bool take_threads(const char *text, size_t *threads)
{
    uint64_t value;
    const bool fine = whole_number_parse("--threads", text, 1, MOST_THREADS, &value);
    *threads = fine ? (size_t)value : 0;
    return fine;
}

/* "I/N" */
static bool take_shard(const char *text, cli_options *options)
{
    char shard[WORD];
    const char *at = text;
    const bool fine = word_take(&at, "/", shard) && *at == '/' &&
                      whole_number_of(at + 1, 1, MOST_SHARDS, &options->n_shards) &&
                      whole_number_of(shard, 1, options->n_shards, &options->shard);
    if (!fine) {
        message("--shard: %s is no shard; expected I/N, I from 1 to N and N at most %u",
                message_quote(text, &(quoted){""}), MOST_SHARDS);
    }
    return fine;
}

static bool take_format(output_format format, cli_options *options)
{
    if (options->format != OUTPUT_TEXT && options->format != format) {
        message("--json and --csv exclude each other");
        return false;
    }
    options->format = format;
    return true;
}

static bool take_text(const char *argument, const char **text)
{
    *text = argument;
    return true;
}

static bool take_units(unit_choice choice, const char *names, unit_choice *units)
{
    if (*units != UNITS_OF_ARM && *units != choice) {
        message("%s exclude each other", names);
        return false;
    }
    *units = choice;
    return true;
}

static bool take_action(cli_action action, cli_options *options)
{
    options->action = action;
    return true;
}

static bool take_wish(const char *text, cli_options *options)
{
    static const char *const names[] = {"tolerances", "motors"};
    const size_t i = choose("--wish", text, names, 2);
    options->wish_motors = i == 1;
    return i < 2;
}

static bool take_payload(const char *text, cli_options *options)
{
    if (options->n_payloads == MOST_PAYLOADS) {
        message("--payload: more than %d load cases", MOST_PAYLOADS);
        return false;
    }
    options->payloads[options->n_payloads++] = text;
    return true;
}

static bool take_at(const char *text, cli_options *options)
{
    if (options->n_at == MOST_AT) {
        message("--at: more than %d positions; expected a file of them, --at-file", MOST_AT);
        return false;
    }
    options->at[options->n_at++] = text;
    return true;
}

static bool take_share(const char *text, double *share)
{
    if (!number_option_parse("--compensated", text, share)) {
        return false;
    }
    if (*share < 0 || *share > 1) {
        message("--compensated: %s is not from 0 to 1", message_quote(text, &(quoted){""}));
        return false;
    }
    return true;
}

/* Options of a region. */
static bool take_region(int option, const char *argument, cli_options *options)
{
    return option == OPTION_GAP    ? take_gap(argument, options)
           : option == OPTION_MOST ? take_most(argument, options)
                                   : take_text(argument, &options->region);
}

/* Options that say what loads the arm, and what is known of its drives. */
static bool take_loading(int option, const char *argument, cli_options *options)
{
    switch (option) {
    case OPTION_GIVEN:
        return take_text(argument, &options->given);
    case OPTION_WISH:
        return take_wish(argument, options);
    case OPTION_DRIVES:
        return take_text(argument, &options->drives);
    case OPTION_PAYLOAD:
        return take_payload(argument, options);
    case OPTION_GRAVITY:
        return take_text(argument, &options->gravity);
    case OPTION_FORCE:
        return take_text(argument, &options->force);
    default:
        return take_share(argument, &options->compensated);
    }
}

/* Options that say what is known and wanted. */
static bool take_problem(int option, const char *argument, cli_options *options)
{
    switch (option) {
    case OPTION_JOINTS:
        return take_text(argument, &options->joints);
    case OPTION_POSES:
        return take_text(argument, &options->poses);
    case OPTION_AT:
        return take_at(argument, options);
    case OPTION_AT_FILE:
        return take_text(argument, &options->at_file);
    case OPTION_NEAR:
        return take_text(argument, &options->near);
    case OPTION_REGION:
    case OPTION_GAP:
    case OPTION_MOST:
        return take_region(option, argument, options);
    case OPTION_ACCURACY:
        return take_text(argument, &options->accuracy);
    case OPTION_TOLERANCES:
        return take_text(argument, &options->tolerances);
    case OPTION_AGAINST:
        return take_text(argument, &options->against);
    case OPTION_DEVIATIONS:
        return take_text(argument, &options->deviations);
    case OPTION_TOOL_OFFSET:
        return take_text(argument, &options->tool_offset);
    case OPTION_WEIGHTS:
        return take_text(argument, &options->weights);
    case OPTION_DELTA:
        return take_text(argument, &options->delta);
    case OPTION_BASE:
        return take_text(argument, &options->base);
    case OPTION_TIP:
        return take_text(argument, &options->tip);
    case OPTION_SNAP:
        return take_snap(argument, &options->snap);
    case OPTION_FRAME:
        return take_frame(argument, &options->frame);
    case OPTION_METHOD:
        return take_method(argument, &options->method);
    case OPTION_SIGMA:
        options->sigma_given = true;
        return number_option_positive("--sigma", argument, &options->sigma);
    default:
        return take_loading(option, argument, options);
    }
}

/* Options of a map: what they mean is for the map to say. */
static bool take_map(int option, const char *argument, map_texts *map)
{
    switch (option) {
    case OPTION_PLANE:
        return take_text(argument, &map->plane);
    case OPTION_OFFSET:
        return take_text(argument, &map->offset);
    case OPTION_RANGE:
        return take_text(argument, &map->range);
    case OPTION_GRID:
        return take_text(argument, &map->grid);
    case OPTION_STEP:
        return take_text(argument, &map->step);
    case OPTION_ORIENTATION:
        return take_text(argument, &map->orientation);
    case OPTION_WHAT:
        return take_text(argument, &map->what);
    case OPTION_OF:
        return take_text(argument, &map->of);
    case OPTION_CONTOUR:
        return take_text(argument, &map->contour);
    default:
        return take_text(argument, &map->tsv);
    }
}

/* Of an option with an argument only one can hold. Every option has a bit of its own. */
static bool is_first(int option, cli_options *options)
{
    const uint64_t bit = option >= OPTION_JOINTS ? (uint64_t)1 << (option - OPTION_JOINTS) : 0;
    const bool many = option == OPTION_PAYLOAD || option == OPTION_AT; /* one a load case, a pose */
    const bool twice = (options->seen & bit) != 0 && !many;
    options->seen |= bit;
    for (size_t i = 0; twice && long_options[i].name != NULL; i++) {
        if (long_options[i].val == option && long_options[i].has_arg == required_argument) {
            message("--%s: is given twice; expected once", long_options[i].name);
            return false;
        }
    }
    return true;
}

/* Options that say what to do, and how to show it. */
static bool take_one(int option, const char *argument, void *context)
{
    cli_options *options = context;
    switch (option) {
    case OPTION_DEGREES:
        return take_units(UNITS_SMALL, "--degrees and --radians", &options->angle);
    case OPTION_RADIANS:
        return take_units(UNITS_LARGE, "--degrees and --radians", &options->angle);
    case OPTION_MM:
        return take_units(UNITS_SMALL, length_options, &options->length);
    case OPTION_METRES:
        return take_units(UNITS_LARGE, length_options, &options->length);
    case OPTION_INCHES:
        return take_units(UNITS_INCHES, length_options, &options->length);
    case OPTION_XACRO:
        return options->xacro = true;
    case OPTION_IGNORE_LIMITS:
        return options->ignore_limits = true;
    case OPTION_CRAIG:
        return options->craig = true;
    case OPTION_AS_IS:
        return options->as_is = true;
    case OPTION_BUDGET:
        return options->budget = true;
    case OPTION_TOOL_POSE:
        return options->tool_pose = true;
    case OPTION_VERIFY:
        return whole_number_parse("--verify", argument, 1, MOST_ARMS, &options->verify);
    case OPTION_SEED:
        options->seed_given = true;
        return whole_number_parse("--seed", argument, 0, UINT64_MAX, &options->seed);
    case OPTION_THREADS:
        return take_threads(argument, &options->threads);
    case OPTION_SHARD:
        return take_shard(argument, options);
    case OPTION_TALLY:
        return take_text(argument, &options->tally);
    case OPTION_JSON:
        return take_format(OUTPUT_JSON, options);
    case OPTION_CSV:
        return take_format(OUTPUT_CSV, options);
    case OPTION_LIST:
        return take_action(CLI_LIST, options);
    case OPTION_LINKS:
        return take_action(CLI_LINKS, options);
    case OPTION_BRANCHES:
        return take_action(CLI_BRANCHES, options);
    case OPTION_SHOW:
        return take_action(CLI_SHOW, options);
    case 'h':
        return take_action(CLI_HELP, options);
    case 'V':
        return take_action(CLI_VERSION, options);
    case OPTION_SVG:
        return take_text(argument, &options->svg);
    default:
        return option >= OPTION_PLANE && option <= OPTION_TSV ? take_map(option, argument, &options->map)
                                                              : take_problem(option, argument, options);
    }
}

static bool take(int option, const char *argument, void *context)
{
    return is_first(option, context) && take_one(option, argument, context);
}

static bool take_xacro_argument(const char *argument, cli_options *options)
{
    if (options->n_xacro_arguments == XACRO_ARGUMENTS_MOST) {
        message("--xacro: more than %d arguments", XACRO_ARGUMENTS_MOST);
        return false;
    }
    options->xacro_arguments[options->n_xacro_arguments++] = argument;
    return true;
}

/* Behind --xacro, a NAME:=VALUE is for xacro. */
static bool take_word(const char *argument, cli_options *options)
{
    if (options->xacro && strstr(argument, ":=") != NULL) {
        return take_xacro_argument(argument, options);
    }
    if (options->arm == NULL && options->action == CLI_ANSWER && strcmp(argument, "map") == 0) {
        return take_action(CLI_MAP, options);
    }
    if (options->arm != NULL) {
        return flags_wrong("unexpected argument", argument);
    }
    options->arm = argument;
    return true;
}

/* The arm, and what is for xacro, may stand before, between and behind the options. */
static bool read_all(int argc, char *argv[], cli_options *options)
{
    for (;;) {
        if (!flags_read(argc, argv, "+:hV", long_options, take, options)) {
            return false;
        }
        if (optind >= argc) {
            return true;
        }
        if (!take_word(argv[optind], options)) {
            return false;
        }
        argc -= optind;
        argv += optind; /* the word is passed over like a program's name */
        optind = 1;
    }
}

/* Two arms are compared as they are: nothing is allowed them, and nothing drawn. */
static const char *fault_of_comparison(const cli_options *options)
{
    if (options->region != NULL) {
        return "--against and --deviations are for poses; expected no --region";
    }
    if (options->against != NULL && options->deviations != NULL) {
        return "--against and --deviations exclude each other";
    }
    if (options->accuracy != NULL || options->tolerances != NULL || options->given != NULL ||
        options->weights != NULL || options->budget || options->verify != 0) {
        return "--against and --deviations compare two arms; expected no --accuracy, --tolerances, --given, --weights, "
               "--budget or --verify beside them";
    }
    return options->format == OUTPUT_CSV ? "--csv writes tolerances only; expected --json, or nothing" : NULL;
}

static const char *fault_of_shard(const cli_options *options)
{
    if ((options->shard != 0) != (options->tally != NULL) || (options->shard != 0 && options->verify == 0)) {
        return "--shard I/N and --tally FILE go together, with --verify N";
    }
    if (options->shard != 0 && options->region != NULL) {
        return "--shard draws arms in poses that are listed; expected no --region";
    }
    return options->n_shards > options->verify ? "--shard: more shards than arms to draw" : NULL;
}

/* What is missing, or contradicts itself; NULL where nothing is. */
static const char *fault_of_poses(const cli_options *options)
{
    const bool at = options->n_at > 0 || options->at_file != NULL;
    if (options->action == CLI_BRANCHES && !at) {
        return "the position is missing; expected --at x,y,z,gamma,beta,alpha or --at-file FILE with --branches";
    }
    if (options->joints == NULL && options->poses == NULL && options->region == NULL && !at &&
        options->action != CLI_MAP) {
        return "the pose is missing; expected --joints Q, --poses FILE, --at POSITION, --at-file FILE or --region R";
    }
    if (options->region != NULL && options->action == CLI_MAP) {
        return "--region is for tolerances; a map has --plane and --range";
    }
    if (options->region != NULL && (options->joints != NULL || options->poses != NULL || at)) {
        return "--region has poses of its own; expected no --joints, --poses, --at and --at-file";
    }
    if (options->region == NULL && (options->gap_given || options->most_given)) {
        return "--gap and --most are for --region R";
    }
    if (options->joints != NULL && options->poses != NULL) {
        return "--joints and --poses exclude each other";
    }
    if ((options->joints != NULL || options->poses != NULL) && at) {
        return "--at and --at-file exclude --joints and --poses";
    }
    return options->near != NULL && !at ? "--near is for --at and --at-file" : NULL;
}

/* What contradicts itself in what is known and wanted, of one pose as of a map. */
static const char *fault_of_wishes(const cli_options *options)
{
    if (options->weights != NULL && (options->tolerances != NULL || options->method == ARMTOL_METHOD_SPHERE)) {
        return "--weights is for the methods worst and rss";
    }
    if (options->delta != NULL && (options->tolerances != NULL || options->method != ARMTOL_METHOD_SPHERE)) {
        return "--delta is for --method sphere";
    }
    if (options->given != NULL && options->tolerances != NULL) {
        return "--given is for tolerances that are asked for, and --tolerances gives them all";
    }
    return options->sigma_given && options->method != ARMTOL_METHOD_RSS ? "--sigma is for --method rss" : NULL;
}

static bool has_map_texts(const map_texts *map)
{
    return map->plane != NULL || map->offset != NULL || map->range != NULL || map->grid != NULL || map->step != NULL ||
           map->orientation != NULL || map->what != NULL || map->of != NULL || map->contour != NULL || map->tsv != NULL;
}

static const char *fault_of_map(const cli_options *options)
{
    if (options->map.plane == NULL) {
        return "the plane is missing; expected --plane xy, xz or yz";
    }
    if (options->map.range == NULL) {
        return "the range is missing; expected --range A0..A1,B0..B1";
    }
    if (options->map.grid != NULL && options->map.step != NULL) {
        return "--grid and --step exclude each other";
    }
    if (options->verify != 0 || options->seed_given || options->threads != 0 || options->budget || options->tool_pose ||
        options->wish_motors) {
        return "--verify, --seed, --threads, --budget, --tool-pose and --wish are not for a map";
    }
    if (options->against != NULL || options->deviations != NULL) {
        return "--against and --deviations are not for a map";
    }
    if (options->format == OUTPUT_CSV) {
        return "a map has no --csv; expected --tsv FILE, --svg FILE or --json";
    }
    return fault_of_wishes(options);
}

/* What is missing, or contradicts itself, in a question; NULL where nothing is. */
static const char *fault_of_question(const cli_options *options)
{
    if (has_map_texts(&options->map)) {
        return "--plane, --range and what goes with them are for armtol map ARM";
    }
    if (options->svg != NULL && !options->budget) {
        return "--svg is for --budget, and for armtol map ARM";
    }
    if (options->against != NULL || options->deviations != NULL) {
        return fault_of_comparison(options);
    }
    if (options->accuracy == NULL && options->tolerances == NULL) {
        return "the accuracy is missing; expected --accuracy dx,dy,dz,wx,wy,wz (or --tolerances FILE)";
    }
    const char *wishes = fault_of_wishes(options);
    if (wishes != NULL) {
        return wishes;
    }
    if ((options->seed_given || options->threads != 0) && options->verify == 0) {
        return "--seed and --threads are for --verify N";
    }
    if (options->format == OUTPUT_CSV && (options->budget || options->verify != 0)) {
        return "--csv writes tolerances only; expected --json with --budget and --verify";
    }
    return NULL;
}

static const char *fault_of(const cli_options *options)
{
    if (options->format == OUTPUT_CSV && (options->action == CLI_LIST || options->action == CLI_SHOW)) {
        return "--csv writes tolerances only; expected --json, or nothing, with --list and --show";
    }
    if (options->action == CLI_LIST || options->action == CLI_HELP || options->action == CLI_VERSION) {
        return NULL;
    }
    if (options->arm == NULL) {
        return "the arm is missing; expected a name of --list or a file";
    }
    if (options->craig && options->action != CLI_SHOW) {
        return "--craig is for --show";
    }
    if (options->craig && options->format == OUTPUT_JSON) {
        return "--craig writes a table; expected no --json with it";
    }
    if (options->action == CLI_SHOW || options->action == CLI_LINKS) {
        return NULL;
    }
    const char *fault = fault_of_shard(options);
    fault = fault != NULL ? fault : fault_of_poses(options);
    if (fault != NULL || options->action == CLI_BRANCHES) {
        return fault;
    }
    return options->action == CLI_MAP ? fault_of_map(options) : fault_of_question(options);
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
    const char *fault = fault_of(options);
    if (fault != NULL) {
        message("%s", fault);
        return EXIT_WRONG;
    }
    return EXIT_OK;
}
