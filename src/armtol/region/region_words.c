#include "armtol/region/region_words.h"

#include "armtol/ask/request.h"
#include "armtol/region/items.h"
#include "armtol/tables/text_lines.h"
#include "console/exit_code.h"
#include "console/input_file.h"
#include "console/message.h"
#include "console/number.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static bool start(const armtol_arm *arm, region_words *words)
{
    const size_t n = armtol_arm_joint_count(arm) + 1; /* never of no bytes */
    *words = (region_words){.low = calloc(n, sizeof *words->low), .high = calloc(n, sizeof *words->high),
                            .named = calloc(n, sizeof *words->named)};
    return enough_memory(words->low != NULL && words->high != NULL && words->named != NULL);
}

void region_words_free(region_words *words)
{
    free(words->low);
    free(words->high);
    free(words->named);
    free(words->points);
}

/* Items of one line; empty ones, as behind the last ;, are passed over. */
static bool take_line(char *line, const armtol_arm *arm, const units *units, region_words *words)
{
    for (char *item = line; item != NULL;) {
        char *const end = strchr(item, ';'), *const next = end != NULL ? end + 1 : NULL;
        if (end != NULL) {
            *end = '\0';
        }
        if (item[strspn(item, " \t")] != '\0' && !region_item_take(item, arm, units, words)) {
            return false;
        }
        item = next;
    }
    return true;
}

/* ---- ranges of joints ---- */

/* What the arm says of a joint that is not named; an angle has one turn where it says nothing. */
static bool take_limits(const armtol_arm *arm, size_t link, size_t joint, region_words *words)
{
    const armtol_drive *drive = &arm->drives[link];
    const bool turns = arm->links[link].joint == ARMTOL_REVOLUTE;
    if (words->named[joint]) {
        return true;
    }
    words->low[joint] = isfinite(drive->low) || !turns ? drive->low : -3.141592653589793;
    words->high[joint] = isfinite(drive->high) || !turns ? drive->high : 3.141592653589793;
    const bool known = isfinite(words->low[joint]) && isfinite(words->high[joint]);
    if (!known) {
        message("--region: joint %zu slides and has no limits; expected its range, as in q%zu=0..100", joint + 1,
                joint + 1);
    }
    return known;
}

/* Both ends of a link's own joint: of one that follows another too. */
static bool check_limits(const armtol_arm *arm, const units *units, size_t link, const double q[])
{
    const armtol_drive *drive = &arm->drives[link];
    const double value = armtol_arm_joint_value(arm, q, link);
    const bool fine = request_within_limits(drive, value);
    if (!fine) {
        message("--region: the joint of link %zu gets to %s, beyond its limits; expected %s to %s %s "
                "(--ignore-limits sets limits aside)", link,
                units_joint_text(units, &arm->links[link], value, &(number_text){""}),
                units_joint_text(units, &arm->links[link], drive->low, &(number_text){""}),
                units_joint_text(units, &arm->links[link], drive->high, &(number_text){""}),
                units_name(units, arm->links[link].joint == ARMTOL_PRISMATIC));
    }
    return fine;
}

static bool take_ranges(const armtol_arm *arm, const units *units, bool ignore_limits, region_words *words)
{
    size_t joint = 0;
    bool fine = true;
    for (size_t i = 0; i < arm->n_links && fine; i++) {
        if (armtol_arm_is_driven(arm, i)) {
            fine = take_limits(arm, i, joint++, words);
        }
    }
    for (size_t i = 0; i < arm->n_links && fine && !ignore_limits; i++) {
        fine = arm->links[i].joint == ARMTOL_FIXED ||
               (check_limits(arm, units, i, words->low) && check_limits(arm, units, i, words->high));
    }
    words->region.low = words->low;
    words->region.high = words->high;
    return fine && (words->elbow[0] == '\0' || region_elbow_take(words->elbow, arm, words));
}

static bool check_cone(const region_words *words)
{
    const bool fine = (words->region.cone != NULL) == words->has_cone_angle;
    if (!fine) {
        message("--region: direction and cone go together; expected both, as in direction=0,0,-1;cone=10");
    }
    return fine;
}

/* ---- whole texts ---- */

bool region_words_read(FILE *stream, const char *path, const armtol_arm *arm, const units *units, bool ignore_limits,
                       region_words *words)
{
    text_lines lines;
    bool fine = start(arm, words);
    line_result result = LINE_NONE;
    text_lines_start(&lines, stream, path);
    while (fine && (result = text_lines_next(&lines)) == LINE_THERE) {
        lines.text[strcspn(lines.text, "#")] = '\0';
        fine = take_line(lines.text, arm, units, words);
    }
    text_lines_free(&lines);
    return fine && result != LINE_WRONG && check_cone(words) && take_ranges(arm, units, ignore_limits, words);
}

static bool take_words(const char *text, const armtol_arm *arm, const units *units, bool ignore_limits,
                       region_words *words)
{
    char *line = malloc(strlen(text) + 1);
    if (!start(arm, words) || !enough_memory(line != NULL)) {
        free(line);
        return false;
    }
    strcpy(line, text);
    const bool fine = take_line(line, arm, units, words);
    free(line);
    return fine && check_cone(words) && take_ranges(arm, units, ignore_limits, words);
}

bool region_words_take(const char *text, const armtol_arm *arm, const units *units, bool ignore_limits,
                       region_words *words)
{
    if (strchr(text, '=') != NULL) {
        return take_words(text, arm, units, ignore_limits, words);
    }
    *words = (region_words){.low = NULL};
    FILE *stream = input_file_open("--region: ", text, "; expected a file, or words as in q2=-90..30");
    if (stream == NULL) {
        return false;
    }
    const bool fine = region_words_read(stream, text, arm, units, ignore_limits, words);
    fclose(stream);
    return fine;
}
