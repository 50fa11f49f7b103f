#include "lab/joint_orders/family.h"

#include <math.h>
#include <string.h>

size_t choice_count(const choice *choice)
{
    size_t n = 0;
    while (n < MOST_OPTIONS && choice->options[n].name != NULL) {
        n++;
    }
    return n;
}

configuration family_default(void)
{
    return (configuration){{0}};
}

const family *const families[FAMILIES] = {&family_intelledex, &family_adept};

bool family_restrict(const family *family, const char *text, size_t length, restriction *given)
{
    for (size_t i = 0; i < family->n_choices; i++) {
        const choice *choice = &family->choices[i];
        for (size_t j = 0; j < choice_count(choice); j++) {
            const size_t n = strlen(choice->name), m = strlen(choice->options[j].name);
            if (length == n + 1 + m && strncmp(text, choice->name, n) == 0 && text[n] == '=' &&
                strncmp(text + n + 1, choice->options[j].name, m) == 0) {
                given->restricted[i] = true;
                given->option[i] = (unsigned char)j;
                return true;
            }
        }
    }
    return false;
}

bool family_allows(const family *family, const restriction *given, const configuration *configuration)
{
    for (size_t i = 0; i < family->n_choices; i++) {
        if (given->restricted[i] && configuration->option[i] != given->option[i] &&
            family->matters(configuration, i)) {
            return false;
        }
    }
    return true;
}

static bool counts(const family *family, const configuration *configuration)
{
    if (family->makes_sense != NULL && !family->makes_sense(configuration)) {
        return false;
    }
    for (size_t i = 0; i < family->n_choices; i++) {
        if (configuration->option[i] != 0 && !family->matters(configuration, i)) {
            return false;
        }
    }
    return true;
}

/* The next option of a choice that may be allowed; 0, which it has where it does not matter, always is. */
static unsigned char next_option(const family *family, const restriction *given, size_t choice,
                                 unsigned char option)
{
    if (given->restricted[choice]) {
        return option < given->option[choice] ? given->option[choice] : 0;
    }
    return (unsigned char)((option + 1u) % choice_count(&family->choices[choice]));
}

static bool advance(const family *family, const restriction *given, configuration *configuration)
{
    for (size_t i = family->n_choices; i-- > 0;) {
        configuration->option[i] = next_option(family, given, i, configuration->option[i]);
        if (configuration->option[i] != 0) {
            return true;
        }
    }
    return false;
}

bool family_next(const family *family, const restriction *given, configuration *configuration)
{
    while (advance(family, given, configuration)) {
        if (counts(family, configuration) && family_allows(family, given, configuration)) {
            return true;
        }
    }
    return false;
}

size_t family_changes(const family *family, const configuration *configuration)
{
    size_t n = 0;
    for (size_t i = 0; i < family->n_choices; i++) {
        n += configuration->option[i] != 0;
    }
    return n;
}

void family_solve(const family *family, const configuration *how, const double wish[], double q[])
{
    progress progress;
    for (size_t i = 0; i < family->n_steps; i++) {
        family->steps[i](how, wish, &progress);
    }
    memcpy(q, progress.q, family->robot->n_joints * sizeof q[0]);
}

double printed_of(double q)
{
    return rint(q * 1e6) + 0.0; /* no -0 */
}
