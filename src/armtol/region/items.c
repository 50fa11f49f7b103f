#include "armtol/region/items.h"

#include "console/exit_code.h"
#include "console/message.h"
#include "console/number.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- numbers ---- */

/* What a number stands for; an angle is no length. */
typedef struct reading {
    const char *name; /* of the item, for messages */
    const units *units;
    bool is_length;
} reading;

/* The text up to a separator, which is cut off; *at goes behind it, or becomes NULL. */
static char *cut(char **at, const char *separator)
{
    char *const piece = *at, *end = strstr(piece, separator);
    *at = end != NULL ? end + strlen(separator) : NULL;
    if (end != NULL) {
        *end = '\0';
    }
    return piece;
}

static const char *trimmed(char *text)
{
    text += strspn(text, " \t");
    size_t length = strlen(text);
    while (length > 0 && strchr(" \t", text[length - 1]) != NULL) {
        text[--length] = '\0';
    }
    return text;
}

static bool take_number(const reading *reading, char *text, double *value)
{
    const char *word = trimmed(text);
    const number_fault fault = number_parse(word, value);
    if (fault != NUMBER_FINE) {
        message("--region: %s: %s %s", reading->name, message_quote(word, &(quoted){""}), number_fault_text(fault));
        return false;
    }
    *value = units_taken(reading->units, reading->is_length, *value);
    if (!isfinite(*value)) {
        message("--region: %s: %s is too large", reading->name, message_quote(word, &(quoted){""}));
    }
    return isfinite(*value);
}

/* "1..2", or "1" for 1..1, or "-" for all; either end may be "-". */
static bool take_range(const reading *reading, char *text, bool may_be_free, double *low, double *high)
{
    char whole[48];
    strncpy(whole, text, sizeof whole - 1);
    whole[sizeof whole - 1] = '\0';
    char *from = cut(&text, ".."), *to = text != NULL ? text : from;
    const bool free_low = may_be_free && strcmp(trimmed(from), "-") == 0;
    const bool free_high = may_be_free && strcmp(trimmed(to), "-") == 0;
    *low = -(double)INFINITY;
    *high = (double)INFINITY;
    if ((!free_low && !take_number(reading, from, low)) || (!free_high && !take_number(reading, to, high))) {
        return false;
    }
    if (*low > *high) {
        message("--region: %s: %s runs down; expected the smaller number first", reading->name,
                message_quote(whole, &(quoted){""}));
    }
    return *low <= *high;
}

/* Numbers with a comma between them, as many as there are to be. */
static bool take_numbers(const reading *reading, char *text, size_t count, const char *expected, double values[])
{
    size_t n = 0;
    while (text != NULL && n < count) {
        if (!take_number(reading, cut(&text, ","), &values[n++])) {
            return false;
        }
    }
    if (n < count || text != NULL) {
        message("--region: %s: %s numbers; expected %s", reading->name, text != NULL ? "too many" : "too few",
                expected);
        return false;
    }
    return true;
}

/* ---- joints ---- */

static bool take_joint(const char *name, char *value, const armtol_arm *arm, const units *units, region_words *words)
{
    uint64_t joint;
    const size_t n_joints = armtol_arm_joint_count(arm);
    if (!whole_number_of(name + 1, 1, n_joints, &joint)) {
        message("--region: %s is no joint of %s; expected q1 to q%zu", message_quote(name, &(quoted){""}), arm->name,
                n_joints);
        return false;
    }
    if (words->named[joint - 1]) {
        message("--region: %s is given twice", name);
        return false;
    }
    const reading reading = {name, units, arm->links[armtol_arm_link_of(arm, joint - 1)].joint == ARMTOL_PRISMATIC};
    words->named[joint - 1] = true;
    return take_range(&reading, value, false, &words->low[joint - 1], &words->high[joint - 1]);
}

/* ---- the tool ---- */

/* "x..x,y..y,z..z" */
static bool take_box(const reading *reading, char *value, region_words *words)
{
    size_t n = 0;
    while (value != NULL && n < 3) {
        if (!take_range(reading, cut(&value, ","), true, &words->block.low[n], &words->block.high[n])) {
            return false;
        }
        n++;
    }
    if (n < 3 || value != NULL) {
        message("--region: box: expected three ranges, x..x,y..y,z..z, with - for one that is free");
        return false;
    }
    words->region.block = &words->block;
    return true;
}

/* "inner..outer", "inner..outer,bottom..top" and "inner..outer,bottom..top,x,y" */
static bool take_cylinder(const reading *reading, char *value, region_words *words)
{
    armtol_ring *ring = &words->ring;
    *ring = (armtol_ring){.axis = {0, 0, 1}, .bottom = -(double)INFINITY, .top = (double)INFINITY};
    char *wide = cut(&value, ","), *tall = value != NULL ? cut(&value, ",") : NULL;
    if (!take_range(reading, wide, true, &ring->inner, &ring->outer) ||
        (tall != NULL && !take_range(reading, tall, true, &ring->bottom, &ring->top)) ||
        (value != NULL && !take_numbers(reading, value, 2, "inner..outer,bottom..top,x,y", ring->point))) {
        return false;
    }
    if (ring->inner < 0 && isfinite(ring->inner)) {
        message("--region: cylinder: a radius is not negative");
        return false;
    }
    ring->inner = fmax(ring->inner, 0);
    words->region.ring = ring;
    return true;
}

static size_t count_of(const char *text, char sign)
{
    size_t n = 0;
    for (; *text != '\0'; text++) {
        n += *text == sign;
    }
    return n;
}

/* "radius:x,y,z:x,y,z..." */
static bool take_path(const reading *reading, char *value, region_words *words)
{
    const size_t count = count_of(value, ':');
    if (count > 0 && !take_number(reading, cut(&value, ":"), &words->path.radius)) {
        return false;
    }
    if (count == 0 || words->path.radius < 0) {
        message("--region: path: expected a radius >= 0 and points behind it, radius:x,y,z:x,y,z");
        return false;
    }
    words->points = calloc(count, 3 * sizeof *words->points);
    if (words->points == NULL) {
        out_of_memory();
        return false;
    }
    for (size_t n = 0; value != NULL; n++) { /* count times */
        if (!take_numbers(reading, cut(&value, ":"), 3, "x,y,z for each point", words->points + 3 * n)) {
            return false;
        }
    }
    words->path.points = words->points;
    words->path.n_points = count;
    words->region.path = &words->path;
    return true;
}

/* A direction has no unit. */
static bool take_direction(const reading *reading, char *value, region_words *words)
{
    const units none = {.arm = reading->units->arm, .length = reading->units->arm, .angle = reading->units->angle};
    const struct reading plain = {reading->name, &none, true};
    double *v = words->cone.direction;
    if (!take_numbers(&plain, value, 3, "x,y,z", v)) {
        return false;
    }
    if (v[0] == 0 && v[1] == 0 && v[2] == 0) {
        message("--region: direction: 0,0,0 is none");
        return false;
    }
    words->region.cone = &words->cone;
    return true;
}

static bool take_cone(const reading *reading, char *value, region_words *words)
{
    const struct reading angle = {reading->name, reading->units, false};
    if (!take_number(&angle, value, &words->cone.angle)) {
        return false;
    }
    if (words->cone.angle < 0) {
        message("--region: cone: an angle is not negative");
        return false;
    }
    words->has_cone_angle = true;
    return true;
}

static bool take_elbow(const reading *reading, char *value, region_words *words)
{
    (void)reading;
    const char *text = trimmed(value);
    if (text[0] == '\0' || strlen(text) >= sizeof words->elbow) {
        message("--region: elbow: %s is none; expected a joint and a sign, as in 2+",
                message_quote(text, &(quoted){""}));
        return false;
    }
    strcpy(words->elbow, text);
    return true;
}

/* ---- items ---- */

typedef bool taker(const reading *reading, char *value, region_words *words);

static const struct {
    const char *name;
    taker *take;
} takers[] = {{"box", take_box},             {"cylinder", take_cylinder}, {"path", take_path},
              {"direction", take_direction}, {"cone", take_cone},         {"elbow", take_elbow}};

enum { TAKERS = sizeof takers / sizeof takers[0] };

static size_t taker_of(const char *name)
{
    size_t i = 0;
    while (i < TAKERS && strcmp(takers[i].name, name) != 0) {
        i++;
    }
    return i;
}

bool region_item_take(char *item, const armtol_arm *arm, const units *units, region_words *words)
{
    char *value = item;
    const char *name = trimmed(cut(&value, "="));
    if (value == NULL) {
        message("--region: %s has no value; expected NAME=VALUE", message_quote(name, &(quoted){""}));
        return false;
    }
    const size_t kind = taker_of(name);
    const reading reading = {name, units, true};
    if (kind == TAKERS && name[0] == 'q' && name[1] != '\0') {
        return take_joint(name, value, arm, units, words);
    }
    if (kind == TAKERS) {
        message("--region: unknown name %s; expected q1 to q%zu, box, cylinder, path, direction, cone or elbow",
                message_quote(name, &(quoted){""}), armtol_arm_joint_count(arm));
        return false;
    }
    if ((words->taken >> kind & 1) != 0) {
        message("--region: %s is given twice", name);
        return false;
    }
    words->taken |= 1u << kind;
    return takers[kind].take(&reading, value, words);
}
