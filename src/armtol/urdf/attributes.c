#include "armtol/urdf/attributes.h"

#include "console/message.h"
#include "console/number.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static const char blanks[] = " \t\r\n";

bool urdf_element_fault(const urdf_element *element, const char *format, ...)
{
    if (element->fault->text[0] == '\0') {
        va_list arguments;
        va_start(arguments, format);
        vsnprintf(element->fault->text, sizeof element->fault->text, format, arguments);
        va_end(arguments);
    }
    return false;
}

const char *urdf_attribute(const urdf_element *element, const char *attribute)
{
    for (const char *const *at = element->attributes; *at != NULL; at += 2) {
        if (strcmp(at[0], attribute) == 0) {
            return at[1];
        }
    }
    return NULL;
}

bool urdf_is_expanded(const urdf_element *element, const char *value)
{
    const bool expanded = strstr(value, "${") == NULL && strstr(value, "$(") == NULL;
    return expanded || urdf_element_fault(element,
                                          "<%.40s> holds %s, which is xacro; expand the file with xacro first, or "
                                          "say --xacro",
                                          element->name, message_quote(value, &(quoted){""}));
}

bool urdf_attribute_text(const urdf_element *element, const char *attribute, const char **text)
{
    *text = urdf_attribute(element, attribute);
    if (*text == NULL || **text == '\0') {
        return urdf_element_fault(element, "<%.40s> has no %s", element->name, attribute);
    }
    return urdf_is_expanded(element, *text);
}

/* The next word of a text, copied; *text then stands behind it. False where it is too long. */
static bool next_word(const char **text, char word[], size_t room)
{
    *text += strspn(*text, blanks);
    const size_t length = strcspn(*text, blanks);
    if (length >= room) {
        return false;
    }
    memcpy(word, *text, length);
    word[length] = '\0';
    *text += length;
    return true;
}

static bool wrong_number(const urdf_element *element, const char *attribute, const char *word,
                         number_fault fault)
{
    return urdf_element_fault(element, "%s of <%.40s>: %s %s", attribute, element->name,
                              message_quote(word, &(quoted){""}), number_fault_text(fault));
}

static bool wrong_count(const urdf_element *element, const char *attribute, size_t count, const char *value)
{
    return urdf_element_fault(element, "%s of <%.40s> is %s; expected %zu number%s", attribute, element->name,
                              message_quote(value, &(quoted){""}), count, count == 1 ? "" : "s set apart by blanks");
}

bool urdf_attribute_numbers(const urdf_element *element, const char *attribute, size_t count,
                            double values[])
{
    const char *const value = urdf_attribute(element, attribute);
    if (value == NULL) {
        return true;
    }
    if (!urdf_is_expanded(element, value)) {
        return false;
    }
    const char *rest = value;
    for (size_t i = 0; i < count; i++) {
        char word[128];
        if (!next_word(&rest, word, sizeof word)) {
            return wrong_number(element, attribute, rest, NUMBER_TOO_LONG);
        }
        if (*word == '\0') {
            return wrong_count(element, attribute, count, value);
        }
        const number_fault fault = number_parse(word, &values[i]);
        if (fault != NUMBER_FINE) {
            return wrong_number(element, attribute, word, fault);
        }
    }
    return rest[strspn(rest, blanks)] == '\0' || wrong_count(element, attribute, count, value);
}
