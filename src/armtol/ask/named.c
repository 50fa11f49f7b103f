#include "armtol/ask/named.h"

#include "armtol/budget.h"
#include "armtol/names/link_name.h"
#include "console/message.h"
#include "console/word.h"

#include <stdlib.h>
#include <string.h>

enum { LINK_DIGITS = 6 };

/* ---- items ---- */

/* A number of a few digits, or NAMED_ANY_LINK. */
static long number_of(const char *text)
{
    const size_t length = strspn(text, "0123456789");
    return length > 0 && length <= LINK_DIGITS && text[length] == '\0' ? strtol(text, NULL, 10) : NAMED_ANY_LINK;
}

/* The link that stands before the dot. False after a message. */
static bool find_link(const named_item *item, const armtol_arm *arm, const char *text, long *link)
{
    const size_t of_that_name = link_named(arm, text), n = arm->n_links;
    *link = number_of(text);
    if (*link == NAMED_ANY_LINK && of_that_name == n) {
        message("%s: %s has no link %s", item->option, arm->name, message_quote(text, &(quoted){""}));
        return false;
    }
    if (*link != NAMED_ANY_LINK && of_that_name != n && (size_t)*link != of_that_name) {
        message("%s: %s may be link %ld, or link %zu, which is called so; expected the other one's number",
                item->option, message_quote(item->whole, &(quoted){""}), *link, of_that_name);
        return false;
    }
    *link = *link == NAMED_ANY_LINK ? (long)of_that_name : *link;
    return true;
}

/* Takes "3." or "elbow." off the front of a name, in which there may be dots too. */
static bool take_link(named_item *item, const armtol_arm *arm)
{
    char text[WORD];
    const char *dot = strrchr(item->whole, '.');
    if (dot == NULL) {
        return true;
    }
    const size_t length = (size_t)(dot - item->whole);
    memcpy(text, item->whole, length);
    text[length] = '\0';
    item->name = dot + 1;
    return find_link(item, arm, text, &item->link);
}

/* Cuts the word at its sign. */
static named_item item_of(const char *option, char word[WORD])
{
    named_item item = {.option = option, .whole = word, .name = word, .link = NAMED_ANY_LINK};
    const size_t length = strcspn(word, "=<>");
    char *sign = word + length;
    const size_t n = *sign == '=' ? 1 : *sign != '\0' && sign[1] == '=' ? 2 : 0;
    memcpy(item.sign, sign, n);
    item.value = sign + n;
    *sign = '\0';
    return item;
}

bool named_each(const char *option, const char *text, const armtol_arm *arm,
                bool (*take)(const named_item *item, void *context), void *context)
{
    for (;; text++) {
        char word[WORD];
        if (!word_take(&text, ",", word)) {
            message("%s: %s is too long", option, message_quote(word, &(quoted){""}));
            return false;
        }
        named_item item = item_of(option, word);
        if (!take_link(&item, arm) || !take(&item, context)) {
            return false;
        }
        if (*text != ',') {
            return true;
        }
    }
}

bool named_is(const named_item *item, const char *signs, const char *expected)
{
    const bool fine = item->sign[0] != '\0' && strstr(signs, item->sign) != NULL;
    if (!fine) {
        message("%s: %s is no %s", item->option, message_quote(item->whole, &(quoted){""}), expected);
    }
    return fine;
}

/* ---- columns ---- */

typedef bool belongs(const armtol_link *link, armtol_parameter parameter);

static bool is_length(const armtol_link *link, armtol_parameter parameter)
{
    (void)link;
    return armtol_parameter_is_length(parameter);
}

static bool is_angle(const armtol_link *link, armtol_parameter parameter)
{
    return !is_length(link, parameter);
}

static bool is_motor(const armtol_link *link, armtol_parameter parameter)
{
    return armtol_role_of(link, parameter) == ARMTOL_MOTOR;
}

static bool is_machined(const armtol_link *link, armtol_parameter parameter)
{
    return !is_motor(link, parameter);
}

/* The class of that name; NULL where it is none. */
static belongs *class_of(const char *name)
{
    static const struct {
        const char *name;
        belongs *belongs;
    } classes[] = {
        {"lengths", is_length}, {"angles", is_angle}, {"motors", is_motor}, {"machining", is_machined}};
    for (size_t i = 0; i < sizeof classes / sizeof classes[0]; i++) {
        if (strcmp(name, classes[i].name) == 0) {
            return classes[i].belongs;
        }
    }
    return NULL;
}

static bool is_parameter(const char *name)
{
    for (int i = 0; i < ARMTOL_PARAMETER_COUNT; i++) {
        if (strcmp(name, armtol_parameter_name((armtol_parameter)i)) == 0) {
            return true;
        }
    }
    return false;
}

bool named_column(const named_columns *of, const named_item *item, size_t column)
{
    const armtol_column *at = &of->columns[column];
    belongs *of_class = class_of(item->name);
    return (item->link == NAMED_ANY_LINK || (size_t)item->link == at->link) &&
           (of_class != NULL ? of_class(&of->arm->links[at->link], at->parameter)
                             : strcmp(item->name, armtol_parameter_name(at->parameter)) == 0);
}

bool named_any_column(const named_columns *of, const named_item *item)
{
    if (class_of(item->name) == NULL && !is_parameter(item->name)) {
        message("%s: unknown name %s; expected theta, d, a, alpha, beta, lengths, angles, motors or machining, "
                "or one of these of a link, as in 3.alpha",
                item->option, message_quote(item->whole, &(quoted){""}));
        return false;
    }
    bool any = false;
    for (size_t k = 0; k < of->n_columns; k++) {
        any = any || named_column(of, item, k);
    }
    if (!any) {
        message("%s: %s has no parameter %s", item->option, of->arm->name, message_quote(item->whole, &(quoted){""}));
    }
    return any;
}
