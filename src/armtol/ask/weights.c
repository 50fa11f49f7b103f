#include "armtol/ask/weights.h"

#include "armtol/ask/lists.h"
#include "armtol/ask/number_list.h"
#include "armtol/budget.h"
#include "console/input_file.h"
#include "console/message.h"
#include "console/word.h"

#include <stdio.h>
#include <string.h>

enum { ANY_LINK = -1, LINK_DIGITS = 6 };

/* What is weighted: the columns of A of an arm. */
typedef struct weighted {
    const armtol_arm *arm;
    const armtol_column *columns;
    size_t n_columns;
    double *weights;
} weighted;

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

/* Takes "3." off the front of a name. */
static long link_of(const char **name)
{
    const size_t length = strspn(*name, "0123456789");
    if (length == 0 || length > LINK_DIGITS || (*name)[length] != '.') {
        return ANY_LINK;
    }
    long link = 0;
    for (size_t i = 0; i < length; i++) {
        link = 10 * link + ((*name)[i] - '0');
    }
    *name += length + 1;
    return link;
}

static bool is_named(const weighted *weighted, size_t column, long link, const char *name)
{
    const armtol_column *at = &weighted->columns[column];
    belongs *of_class = class_of(name);
    return (link == ANY_LINK || (size_t)link == at->link) &&
           (of_class != NULL ? of_class(&weighted->arm->links[at->link], at->parameter)
                             : strcmp(name, armtol_parameter_name(at->parameter)) == 0);
}

static bool set(const char *name, double weight, const weighted *weighted)
{
    const char *whole = name;
    const long link = link_of(&name);
    if (class_of(name) == NULL && !is_parameter(name)) {
        message("--weights: unknown name %s; expected theta, d, a, alpha, beta, lengths, angles, motors or machining, "
                "or one of these of a link, as in 3.alpha",
                message_quote(whole, &(quoted){""}));
        return false;
    }
    bool any = false;
    for (size_t k = 0; k < weighted->n_columns; k++) {
        if (is_named(weighted, k, link, name)) {
            weighted->weights[k] = weight;
            any = true;
        }
    }
    if (!any) {
        message("--weights: %s has no parameter %s", weighted->arm->name, message_quote(whole, &(quoted){""}));
    }
    return any;
}

/* NAME=NUMBER, up to a comma. */
static bool take_item(const char **at, const weighted *weighted)
{
    char word[WORD];
    double weight;
    if (!word_take(at, ",", word)) {
        message("--weights: %s is too long", message_quote(word, &(quoted){""}));
        return false;
    }
    char *equals = strchr(word, '=');
    if (equals == NULL) {
        message("--weights: %s is no NAME=NUMBER", message_quote(word, &(quoted){""}));
        return false;
    }
    *equals = '\0';
    return number_option_positive("--weights", equals + 1, &weight) && set(word, weight, weighted);
}

static bool take_list(const char *text, const weighted *weighted)
{
    bool fine = take_item(&text, weighted);
    while (fine && *text++ == ',') {
        fine = take_item(&text, weighted);
    }
    return fine;
}

static bool take_table(const char *path, const weighted *weighted)
{
    const parameter_table table = {.links = weighted->arm->links,
                                   .columns = weighted->columns,
                                   .n_columns = weighted->n_columns,
                                   .value = "weight"};
    FILE *stream = input_file_open("--weights: ", path, "; expected NAME=NUMBER,... or a file");
    if (stream == NULL) {
        return false;
    }
    const bool fine = parameters_read(stream, path, &table, false, weighted->weights);
    fclose(stream);
    return fine;
}

bool weights_parse(const char *text, const armtol_arm *arm, const armtol_column columns[], size_t n_columns,
                   double weights[])
{
    const weighted weighted = {arm, columns, n_columns, weights};
    for (size_t k = 0; k < n_columns; k++) {
        weights[k] = 1;
    }
    if (text == NULL) {
        return true;
    }
    return strchr(text, '=') != NULL ? take_list(text, &weighted) : take_table(text, &weighted);
}
