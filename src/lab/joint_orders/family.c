#include "lab/joint_orders/family.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

const family *const families[FAMILIES] = {&family_intelledex, &family_adept};

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

bool family_restrict(const family *family, const char *text, restriction *given)
{
    for (size_t i = 0; i < family->n_choices; i++) {
        const choice *choice = &family->choices[i];
        for (size_t j = 0; j < choice_count(choice); j++) {
            char name[64];
            snprintf(name, sizeof name, "%s=%s", choice->name, choice->options[j].name);
            if (strcmp(text, name) == 0) {
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
    bool allowed = family->makes_sense == NULL || family->makes_sense(configuration);
    for (size_t i = 0; i < family->n_choices && allowed; i++) {
        const int option = configuration->option[i];
        allowed = family->matters(configuration, i) ? !given->restricted[i] || option == given->option[i] : option == 0;
    }
    return allowed;
}

bool family_next(const family *family, configuration *configuration)
{
    for (size_t i = family->n_choices; i-- > 0;) {
        if (++configuration->option[i] < choice_count(&family->choices[i])) {
            return true;
        }
        configuration->option[i] = 0;
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

double stored(double value)
{
    return armtol_stored(&armtol_errata_1987, value);
}

double kept(const choice *choices, const configuration *how, size_t choice, double value)
{
    return choices[choice].options[how->option[choice]].name[0] == 'f' ? stored(value) : value;
}

double printed_of(double q)
{
    return rint(q * 1e6) + 0.0; /* no -0 */
}
