#include "lab/joint_orders/text.h"


#include <stdarg.h>
#include <string.h>

/* printf to the end of a label; what is too long is cut. */
#ifdef __GNUC__
__attribute__((format(printf, 2, 3)))
#endif
static void append(label *label, const char *format, ...)
{
    const size_t length = strlen(label->text);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(label->text + length, sizeof label->text - length, format, arguments);
    va_end(arguments);
}

const char *label_of_option(const family *family, size_t choice, size_t option, label *label)
{
    label->text[0] = '\0';
    append(label, "%s=%s", family->choices[choice].name, family->choices[choice].options[option].name);
    return label->text;
}

const char *label_of_value(const published_number *number, label *label)
{
    label->text[0] = '\0';
    append(label, "%s of case %d", number->quantity, number->case_number);
    return label->text;
}

const char *label_of_changes(const family *family, const configuration *configuration, label *label)
{
    label->text[0] = '\0';
    for (size_t i = 0; i < family->n_choices; i++) {
        if (configuration->option[i] != 0) {
            struct label one;
            append(label, "%s%s", label->text[0] != '\0' ? " " : "",
                   label_of_option(family, i, configuration->option[i], &one));
        }
    }
    if (label->text[0] == '\0') {
        append(label, "(the library's)");
    }
    return label->text;
}

const char *label_of_values(const evidence *evidence, unsigned long values, label *label)
{
    size_t last_case = evidence->n_cases;
    label->text[0] = '\0';
    for (size_t i = 0; i < evidence_count(evidence); i++) {
        const size_t case_index = i / evidence->n_joints;
        if ((values >> i & 1) == 0) {
            continue;
        }
        if (case_index != last_case) {
            append(label, "%s%d:", label->text[0] != '\0' ? ", " : "", evidence->numbers[i]->case_number);
            last_case = case_index;
        }
        append(label, " %zu", i % evidence->n_joints + 1);
    }
    return label->text;
}

void print_title(table_format format, const char *program, const char *title, const char *remark)
{
    char whole[256];
    snprintf(whole, sizeof whole, "%s%s%s", program, program[0] != '\0' ? ": " : "", title);
    table_print_title(whole, remark, format, stdout);
}
