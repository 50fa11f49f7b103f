#include "armtol/ask/options.h"

#include <stddef.h>
#include <string.h>

typedef struct contradiction {
    bool holds;
    const char *message;
} contradiction;

/* The message of the first that holds; NULL where none does. */
static const char *first_of(const contradiction list[], size_t n)
{
    size_t i = 0;
    while (i < n && !list[i].holds) {
        i++;
    }
    return i < n ? list[i].message : NULL;
}

#define FIRST_OF(list) first_of(list, sizeof(list) / sizeof(list)[0])

static const char *either(const char *first, const char *second)
{
    return first != NULL ? first : second;
}

static bool compares_arms(const cli_options *options)
{
    return options->against != NULL || options->deviations != NULL;
}

/* Two arms are compared as they are: nothing is allowed them, and nothing drawn. */
static const char *fault_of_comparison(const cli_options *options)
{
    const bool wishes = options->accuracy != NULL || options->tolerances != NULL || options->given != NULL ||
                        options->drawing != NULL || options->write_drawing != NULL || options->weights != NULL ||
                        options->spread != NULL || options->budget || options->verify != 0 || options->cycles != 0;
    const contradiction list[] = {
        {options->region != NULL, "--against and --deviations are for poses; expected no --region"},
        {options->against != NULL && options->deviations != NULL, "--against and --deviations exclude each other"},
        {wishes, "--against and --deviations compare two arms; expected no --accuracy, --tolerances, --given, "
                 "--drawing, --weights, --spread, --budget, --verify or --iso9283 beside them"},
        {options->format == OUTPUT_CSV, "--csv writes tolerances only; expected --json, or nothing"},
        {options->grades, "--grades is for tolerances, which --against and --deviations have not"},
    };
    return FIRST_OF(list);
}

static const char *fault_of_shard(const cli_options *options)
{
    const bool shard = options->shard != 0, map = options->action == CLI_MAP;
    const contradiction list[] = {
        {shard != (options->tally != NULL) || (shard && options->verify == 0 && !map),
         "--shard I/N and --tally FILE go together, with --verify N or armtol map"},
        {shard && options->region != NULL, "--shard draws arms in poses that are listed; expected no --region"},
        {options->n_shards > options->verify && !map, "--shard: more shards than arms to draw"},
    };
    return FIRST_OF(list);
}

static const char *fault_of_arrivals(const cli_options *options)
{
    const contradiction list[] = {
        {options->verify == 0, "--iso9283 is for arms that are drawn; expected --verify N with it"},
        {options->verify > MOST_KEPT_ARMS,
         "--iso9283 keeps the numbers of every arm; expected --verify N of 10000000 at the most"},
        {options->shard != 0, "--iso9283 keeps the numbers of every arm, a tally does not; expected no --shard"},
        {options->region != NULL, "--iso9283 is for poses that are listed; expected no --region"},
        {options->wish_motors,
         "--wish motors leaves the drives out, and --iso9283 is about them; expected one of the two"},
    };
    return options->cycles != 0 ? FIRST_OF(list) : NULL;
}

static const char *fault_of_poses(const cli_options *options)
{
    const bool at = options->n_at > 0 || options->at_file != NULL;
    const bool listed = options->joints != NULL || options->poses != NULL;
    const bool region = options->region != NULL, map = options->action == CLI_MAP;
    const contradiction list[] = {
        {options->action == CLI_BRANCHES && !at,
         "the position is missing; expected --at x,y,z,gamma,beta,alpha or --at-file FILE with --branches"},
        {!listed && !region && !at && !map,
         "the pose is missing; expected --joints Q, --poses FILE, --at POSITION, --at-file FILE or --region R"},
        {options->spread != NULL && (region || map),
         "--spread is for poses that are listed; expected none with --region and maps"},
        {region && map, "--region is for tolerances; a map has --plane and --range"},
        {region && (listed || at),
         "--region has poses of its own; expected no --joints, --poses, --at and --at-file"},
        {!region && (options->gap_given || options->most_given), "--gap and --most are for --region R"},
        {options->joints != NULL && options->poses != NULL, "--joints and --poses exclude each other"},
        {listed && at, "--at and --at-file exclude --joints and --poses"},
        {options->near != NULL && !at, "--near is for --at and --at-file"},
    };
    return FIRST_OF(list);
}

/* In what is known and wanted, of one pose as of a map. */
static const char *fault_of_wishes(const cli_options *options)
{
    const bool drawn = options->drawing != NULL && options->accuracy == NULL;
    const bool known = options->tolerances != NULL || drawn, sphere = options->method == ARMTOL_METHOD_SPHERE;
    const contradiction list[] = {
        {options->weights != NULL && (known || sphere), "--weights is for the methods worst and rss"},
        {options->delta != NULL && (known || !sphere), "--delta is for --method sphere"},
        {options->given != NULL && known,
         drawn ? "--given is for tolerances that are asked for; expected --accuracy, or --tolerances beside --drawing"
               : "--given is for tolerances that are asked for, and --tolerances gives them all"},
        {options->sigma_given && options->method != ARMTOL_METHOD_RSS, "--sigma is for --method rss"},
    };
    return FIRST_OF(list);
}

static const char *fault_of_map(const cli_options *options)
{
    const contradiction list[] = {
        {options->map.plane == NULL, "the plane is missing; expected --plane xy, xz or yz"},
        {options->map.range == NULL, "the range is missing; expected --range A0..A1,B0..B1"},
        {options->map.grid != NULL && options->map.step != NULL, "--grid and --step exclude each other"},
        {options->verify != 0 || options->seed_given || (options->threads != 0 && options->shard == 0) ||
             options->budget || options->tool_pose || options->wish_motors || options->cycles != 0,
         "--verify, --seed, --threads, --iso9283, --budget, --tool-pose and --wish are not for a map"},
        {options->write_drawing != NULL, "--write-drawing is not for a map"},
        {compares_arms(options), "--against and --deviations are not for a map"},
        {options->format == OUTPUT_CSV, "a map has no --csv; expected --tsv FILE, --svg FILE or --json"},
        {options->grades, "--grades is not for a map"},
    };
    return either(FIRST_OF(list), fault_of_wishes(options));
}

static const char *fault_of_drawing(const cli_options *options)
{
    const bool drawn = options->verify != 0;
    const contradiction list[] = {
        {(options->seed_given || options->threads != 0) && !drawn, "--seed and --threads are for --verify N"},
        {options->format == OUTPUT_CSV && (options->budget || drawn),
         "--csv writes tolerances only; expected --json with --budget and --verify"},
    };
    return FIRST_OF(list);
}

static const char *fault_of_question(const cli_options *options)
{
    const bool compares = compares_arms(options);
    const contradiction list[] = {
        {options->map.given, "--plane, --range and what goes with them are for armtol map ARM"},
        {options->svg != NULL && options->write_drawing != NULL && strcmp(options->svg, "-") == 0 &&
             strcmp(options->write_drawing, "-") == 0,
         "--svg - and --write-drawing - exclude each other"},
        {options->svg != NULL && !options->budget, "--svg is for --budget, and for armtol map ARM"},
        {!compares && options->accuracy == NULL && options->tolerances == NULL && options->drawing == NULL,
         "the accuracy is missing; expected --accuracy dx,dy,dz,wx,wy,wz (or --tolerances FILE)"},
    };
    const char *rest = compares ? fault_of_comparison(options)
                                : either(fault_of_wishes(options),
                                         either(fault_of_arrivals(options), fault_of_drawing(options)));
    return either(FIRST_OF(list), rest);
}

const char *cli_options_fault(const cli_options *options)
{
    const cli_action action = options->action;
    const bool any_arm = action == CLI_LIST || action == CLI_HELP || action == CLI_VERSION;
    const contradiction list[] = {
        {options->format == OUTPUT_CSV && (action == CLI_LIST || action == CLI_SHOW),
         "--csv writes tolerances only; expected --json, or nothing, with --list and --show"},
        {!any_arm && options->arm == NULL, "the arm is missing; expected a name of --list or a file"},
        {!any_arm && options->craig && action != CLI_SHOW, "--craig is for --show"},
        {!any_arm && options->craig && options->format == OUTPUT_JSON,
         "--craig writes a table; expected no --json with it"},
    };
    const char *fault = FIRST_OF(list);
    if (fault != NULL || any_arm || action == CLI_SHOW || action == CLI_LINKS) {
        return fault;
    }
    fault = either(fault_of_shard(options), fault_of_poses(options));
    if (fault != NULL || action == CLI_BRANCHES) {
        return fault;
    }
    return action == CLI_MAP ? fault_of_map(options) : fault_of_question(options);
}
