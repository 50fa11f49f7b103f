#include "armtol/names/joint_values.h"

#include "armtol/names/link_name.h"
#include "console/message.h"
#include "console/number.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { NAMES_LISTED = 8 };

bool joint_values_are_named(const char *text)
{
    return strchr(text, '=') != NULL;
}

/* The text of an item, cut to what a name or a number may have; longer ones are wrong. */
typedef struct part {
    char text[1024];
} part;

static const char *cut_out(const char *begin, const char *end, part *part)
{
    static const char blanks[] = " \t\n";
    while (begin < end && strchr(blanks, *begin) != NULL) {
        begin++;
    }
    while (end > begin && strchr(blanks, end[-1]) != NULL) {
        end--;
    }
    snprintf(part->text, sizeof part->text, "%.*s", (int)(end - begin), begin);
    return part->text;
}

/* The names that there are, some of them where they are many. */
static void say_unknown(const armtol_arm *arm, const char *name)
{
    char names[NAMES_LISTED * sizeof(quoted) + NAMES_LISTED * 2 + 32] = "";
    size_t n = 0, length = 0;
    for (size_t i = 0; i < arm->n_links; i++) {
        const bool named = armtol_arm_is_driven(arm, i) && link_name(arm, i) != NULL;
        n += named;
        if (named && n <= NAMES_LISTED) {
            length += (size_t)snprintf(names + length, sizeof names - length, "%s%s", n > 1 ? ", " : "",
                                       message_quote(link_name(arm, i), &(quoted){""}));
        }
    }
    if (n > NAMES_LISTED) {
        snprintf(names + length, sizeof names - length, " and %zu more", n - NAMES_LISTED);
    }
    if (n == 0) {
        message("--joints: the joints of %s have no names; expected %zu values without", arm->name,
                armtol_arm_joint_count(arm));
    } else {
        message("--joints: %s has no joint %s; it has %s", arm->name, message_quote(name, &(quoted){""}), names);
    }
}

static bool find_joint(const armtol_arm *arm, const char *name, const double q[], size_t *joint)
{
    const size_t link = link_named(arm, name);
    if (link == arm->n_links) {
        say_unknown(arm, name);
        return false;
    }
    *joint = armtol_arm_joint_of(arm, link);
    const char *fault = !armtol_arm_is_driven(arm, link) ? "has no value of its own"
                        : !isnan(q[*joint])              ? "is given twice"
                                                         : NULL;
    if (fault != NULL) {
        message("--joints: %s %s", message_quote(name, &(quoted){""}), fault);
    }
    return fault == NULL;
}

static bool take_item(const armtol_arm *arm, const char *begin, const char *end, double q[])
{
    const char *sign = end;
    part name = {""}, value = {""};
    size_t joint;
    while (sign > begin && *sign != '=') {
        sign--;
    }
    if (*sign != '=') {
        message("--joints: %s is no NAME=VALUE; expected names for all values, or for none",
                message_quote(cut_out(begin, end, &name), &(quoted){""}));
        return false;
    }
    if (!find_joint(arm, cut_out(begin, sign, &name), q, &joint)) {
        return false;
    }
    const number_fault fault = number_parse(cut_out(sign + 1, end, &value), &q[joint]);
    if (fault != NUMBER_FINE) {
        message("--joints: %s: %s %s", message_quote(name.text, &(quoted){""}),
                message_quote(value.text, &(quoted){""}), number_fault_text(fault));
    }
    return fault == NUMBER_FINE;
}

/* All joints have a value. */
static bool check_all(const armtol_arm *arm, const double q[])
{
    link_text room;
    size_t joint = 0;
    for (size_t i = 0; i < arm->n_links; i++) {
        if (!armtol_arm_is_driven(arm, i)) {
            continue;
        }
        if (isnan(q[joint++])) {
            message("--joints: no value for the joint of %s; expected one for each of %zu joints%s",
                    link_words(arm, i, &room), armtol_arm_joint_count(arm),
                    link_name(arm, i) == NULL ? ", without names, since this one has none" : "");
            return false;
        }
    }
    return true;
}

bool joint_values_parse(const char *text, const armtol_arm *arm, double q[])
{
    for (size_t i = 0; i < armtol_arm_joint_count(arm); i++) {
        q[i] = (double)NAN;
    }
    for (;; text++) {
        const char *const end = text + strcspn(text, ",");
        if (!take_item(arm, text, end, q)) {
            return false;
        }
        if (*end == '\0') {
            return check_all(arm, q);
        }
        text = end;
    }
}
