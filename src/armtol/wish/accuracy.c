#include "armtol/wish/accuracy.h"

#include "armtol/question.h"
#include "console/message.h"
#include "console/number.h"
#include "console/word.h"

#include <math.h>
#include <string.h>

bool accuracy_is_named(const char *text)
{
    return strchr(text, '=') != NULL;
}

/* Adds a norm that is not there yet. */
static double *place_of_norm(named_accuracy *accuracy, unsigned components)
{
    size_t i = 0;
    while (i < accuracy->n_norms && accuracy->norms[i].components != components) {
        i++;
    }
    if (i == accuracy->n_norms) {
        accuracy->norms[accuracy->n_norms++] = (armtol_norm){components, (double)INFINITY};
    }
    return &accuracy->norms[i].limit;
}

/* Where the number of that name goes; NULL where it is none. */
static double *place_of(named_accuracy *accuracy, const char *name)
{
    for (size_t i = 0; i < 6; i++) {
        if (strcmp(name, armtol_component_name(i)) == 0) {
            return &accuracy->components[i];
        }
    }
    if (strcmp(name, "rp") == 0) {
        return &accuracy->repeatability;
    }
    const unsigned components = armtol_norm_of_name(strcmp(name, "ap") == 0 ? "r" : name);
    return components != 0 ? place_of_norm(accuracy, components) : NULL;
}

/* The mean of arrivals and one arrival are held to the same ball (docs/iso9283.md). */
static bool take_ball(named_accuracy *accuracy, const char *name)
{
    accuracy->r = accuracy->r || strcmp(name, "r") == 0;
    accuracy->ap = accuracy->ap || strcmp(name, "ap") == 0;
    if (accuracy->r && accuracy->ap) {
        message("--accuracy: ap and r are the same ball about where the tool should be; expected one of them");
    }
    return !(accuracy->r && accuracy->ap);
}

static bool take_number(const char *name, const char *text, double *value)
{
    const number_fault fault = number_parse(text, value);
    if (fault != NUMBER_FINE) {
        message("--accuracy: %s: %s %s", name, message_quote(text, &(quoted){""}), number_fault_text(fault));
        return false;
    }
    if (!(*value > 0)) {
        message("--accuracy: %s: %s is not greater than zero", name, message_quote(text, &(quoted){""}));
    }
    return *value > 0;
}

/* What is cut at its = . */
static bool take_part(named_accuracy *accuracy, const char *name, const char *number)
{
    if (!take_ball(accuracy, name)) {
        return false;
    }
    double *place = place_of(accuracy, name), value;
    if (place == NULL) {
        message("--accuracy: unknown name %s; expected dx, dy, dz, wx, wy, wz, r, xy, xz, yz, w, wxy, wxz, wyz, "
                "ap or rp",
                message_quote(name, &(quoted){""}));
        return false;
    }
    if (isfinite(*place)) {
        message("--accuracy: %s is given twice; expected once", name);
        return false;
    }
    if (!take_number(name, number, &value)) {
        return false;
    }
    *place = value;
    return true;
}

static bool take_word(named_accuracy *accuracy, char word[WORD])
{
    char *sign = strchr(word, '=');
    if (sign == NULL) {
        message("--accuracy: %s is no NAME=NUMBER; expected names for all numbers, or six numbers without",
                message_quote(word, &(quoted){""}));
        return false;
    }
    *sign = '\0';
    return take_part(accuracy, word, sign + 1);
}

bool accuracy_parse(const char *text, named_accuracy *accuracy)
{
    *accuracy = (named_accuracy){.repeatability = (double)INFINITY};
    for (size_t i = 0; i < 6; i++) {
        accuracy->components[i] = (double)INFINITY;
    }
    for (;; text++) {
        char word[WORD];
        text += strspn(text, " ");
        if (!word_take(&text, ", ", word)) {
            message("--accuracy: %s is too long", message_quote(word, &(quoted){""}));
            return false;
        }
        text += strspn(text, " ");
        if (!take_word(accuracy, word)) {
            return false;
        }
        if (*text == '\0') {
            return true;
        }
        text -= *text != ','; /* blanks alone set apart, too */
    }
}
