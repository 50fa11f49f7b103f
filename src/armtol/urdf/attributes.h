#ifndef ARMTOL_URDF_ATTRIBUTES_H
#define ARMTOL_URDF_ATTRIBUTES_H

#include "console/file_message.h"

#include <stdbool.h>
#include <stddef.h>

/* What is wrong with an element, for whoever finds out whether that matters. */
typedef struct urdf_fault {
    char text[400];
} urdf_fault;

/* An element as it begins: its name, its attributes (name, value, name, value ... NULL) and where it is. */
typedef struct urdf_element {
    const char *name;
    const char *const *attributes;
    file_place place;
    urdf_fault *fault;
} urdf_element;

/* Fills in the element's fault, the first one; false. */
bool urdf_element_fault(const urdf_element *element, const char *format, ...) LIKE_PRINTF(2, 3);

/* The value of an attribute, NULL where it has none. */
const char *urdf_attribute(const urdf_element *element, const char *attribute);

/* The same for one that it has to have, and not empty. False with a fault, as in all that follow. */
bool urdf_attribute_text(const urdf_element *element, const char *attribute, const char **text);

/* `count` numbers set apart by blanks. Without the attribute values stay as they were. */
bool urdf_attribute_numbers(const urdf_element *element, const char *attribute, size_t count,
                            double values[]);

/* What a value that only xacro understands says, "${...}": a fault and false. True for any other. */
bool urdf_is_expanded(const urdf_element *element, const char *value);

#endif
