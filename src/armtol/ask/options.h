#ifndef ARMTOL_ASK_OPTIONS_H
#define ARMTOL_ASK_OPTIONS_H

#include "armtol/question.h"
#include "armtol/urdf/xacro.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { MOST_PAYLOADS = 64, MOST_AT = 64 };

#define MOST_ARMS 1000000000000u
#define MOST_SHARDS 1000000u
#define MOST_KEPT_ARMS 10000000u /* of which every number is kept, to be sorted */

typedef enum cli_action {
    CLI_ANSWER,
    CLI_MAP,
    CLI_LIST,
    CLI_SHOW,
    CLI_LINKS,
    CLI_BRANCHES,
    CLI_HELP,
    CLI_VERSION
} cli_action;

typedef enum output_format { OUTPUT_TEXT, OUTPUT_JSON, OUTPUT_CSV } output_format;

typedef enum unit_choice { UNITS_OF_ARM, UNITS_SMALL, UNITS_LARGE, UNITS_INCHES } unit_choice;

/* What `armtol map` is told beside the rest, as typed. */
typedef struct map_texts {
    const char *plane, *offset; /* which coordinates, and the third one */
    const char *range, *grid, *step;
    const char *orientation;
    const char *what, *of, *contour;
    const char *tsv;
    bool given; /* any of them */
} map_texts;

/* The command line. Texts are as typed: what they mean depends on the arm. NULL where not given. */
typedef struct cli_options {
    cli_action action;
    const char *arm;         /* a built-in arm's name, or a file */
    const char *base, *tip;  /* of a URDF */
    bool xacro;              /* the arm is to be expanded, with these: */
    size_t n_xacro_arguments;
    const char *xacro_arguments[XACRO_ARGUMENTS_MOST]; /* NAME:=VALUE */
    bool craig;              /* show the table in Craig's order */
    bool ignore_limits;
    double snap;             /* armtol_links_of_axes, of a URDF */
    bool as_is;              /* a table's frames stay where they are */
    const char *joints;
    const char *poses;
    const char *at[MOST_AT];
    size_t n_at;
    const char *at_file;
    const char *near;
    const char *region; /* a file, or words */
    double gap;         /* of the bounds, as a part */
    uint64_t most;      /* boxes */
    bool gap_given, most_given;
    const char *accuracy;
    const char *tool_offset;
    const char *weights;
    const char *delta;
    const char *tolerances;
    const char *given;
    const char *drawing, *write_drawing; /* files */
    const char *drives;
    const char *spread; /* a list, or a file */
    const char *against, *deviations;
    const char *gravity, *force;
    double compensated;
    const char *payloads[MOST_PAYLOADS];
    size_t n_payloads;
    bool wish_motors;
    armtol_frame frame;
    unit_choice length; /* small: mm, large: m, or inches */
    unit_choice angle;  /* small: degrees, large: radians */
    armtol_method method;
    double sigma; /* standard deviations */
    bool sigma_given;
    bool budget;
    bool grades;
    bool tool_pose;
    uint64_t verify; /* arms to draw, 0 for none */
    uint64_t seed;
    bool seed_given;
    uint64_t threads; /* 0: as many as there are processors */
    uint64_t cycles; /* arrivals of each arm drawn, 0 for none */
    uint64_t shard, n_shards; /* shard 1 to n_shards, 0 for all arms; with it: */
    const char *tally;        /* the file for its counts */
    output_format format;
    char **words; /* as typed, without the program's name */
    size_t n_words;
    const char *svg; /* the file of a map's picture, or the budget's */
    map_texts map;
} cli_options;

/* EXIT_OK, or EXIT_WRONG after a message. */
int cli_options_parse(int argc, char *argv[], cli_options *options);

/* What is missing, or contradicts itself, in a message; NULL where nothing is. */
const char *cli_options_fault(const cli_options *options);

/* What --help prints on standard output. */
void cli_help(void);

#endif
