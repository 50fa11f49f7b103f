#include "lab/joint_orders/lists.h"

#include "lab/joint_orders/text.h"

static void print_option(const family *family, size_t choice, size_t option, table_format format)
{
    const choice_option *o = &family->choices[choice].options[option];
    switch (format) {
    case FORMAT_TEXT:
        printf("    %-12s %s\n", o->name, o->meaning);
        break;
    case FORMAT_MARKDOWN:
        printf("  - `%s`: %s\n", o->name, o->meaning);
        break;
    default:
        printf("%s\t%s\t%s\n", label_of_option(family, choice, option, &(label){""}),
               family->choices[choice].subject, o->meaning);
    }
}

void print_family(const survey *survey, table_format format)
{
    const family *family = survey->family;
    print_title(format, family->program, "the family",
                "Each choice and its options; the first is what the library does.");
    for (size_t i = 0; i < family->n_choices; i++) {
        const choice *choice = &family->choices[i];
        if (format == FORMAT_TEXT) {
            printf("  %s: %s\n", choice->name, choice->subject);
        } else if (format == FORMAT_MARKDOWN) {
            printf("- `%s`: %s\n", choice->name, choice->subject);
        }
        for (size_t j = 0; j < choice_count(choice); j++) {
            print_option(family, i, j, format);
        }
    }
    if (family->left_out != NULL) {
        static const char *const before[FORMAT_COUNT] = {"\n  Left out: ", "\nLeft out: ", "# Left out: "};
        printf("%s%s.\n", before[format], family->left_out);
    }
}

void print_all_that_fit(const survey *survey, table_format format)
{
    static const char *const before[FORMAT_COUNT] = {"  ", "- ", ""};
    print_title(format, survey->family->program, "every configuration that fits",
                "By what it has other than the library's.");
    for (size_t i = 0; i < survey->n_all; i++) {
        printf("%s%s\n", before[format], label_of_changes(survey->family, &survey->all[i], &(label){""}));
    }
}
