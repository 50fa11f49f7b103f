#ifndef ARMTOL_LAB_JOINT_ORDERS_TEXT_H
#define ARMTOL_LAB_JOINT_ORDERS_TEXT_H

#include "console/table.h"
#include "lab/joint_orders/survey.h"

/* What the parts of the output call things, and how their tables begin. */

/* Room for a label: label_of_value(number, &(label){""}). Each returns label->text. */
typedef struct label {
    char text[1024];
} label;

/* "elbow=chain" */
const char *label_of_option(const family *family, size_t choice, size_t option, label *label);

/* "theta[4] of case 2" */
const char *label_of_value(const published_number *number, label *label);

/* What a configuration has other than the library's: "sines=float elbow=chain". */
const char *label_of_changes(const family *family, const configuration *configuration, label *label);

/* A set of values of the evidence, by case and joint: "1: 3, 2: 3 4"; empty for none. */
const char *label_of_values(const evidence *evidence, unsigned long values, label *label);

/* A title and a line on what is below it, on standard output. program is "" where it is about both. */
void print_title(table_format format, const char *program, const char *title, const char *remark);

#endif
