#ifndef ARMTOL_FORMS_JSON_H
#define ARMTOL_FORMS_JSON_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

/*
 * Writes JSON (RFC 8259), indented, one member a line, short arrays of numbers on one. Numbers read back as the same
 * double; nan and infinity, for which JSON has no number, are null. Texts are UTF-8 or, byte for byte, taken for it.
 * name is NULL inside an array.
 */
typedef struct json {
    FILE *stream;
    size_t depth;
    bool first; /* nothing stands in the innermost object or array yet */
} json;

void json_start(json *json, FILE *stream);
void json_end(json *json);

void json_open_object(json *json, const char *name);
void json_close_object(json *json);
void json_open_array(json *json, const char *name);
void json_close_array(json *json);

void json_text(json *json, const char *name, const char *text);
/* Where the text is there, that is not NULL. */
void json_text_if(json *json, const char *name, const char *text);
void json_number(json *json, const char *name, double value);
/* Where there is one: what does not exist is left out, null is what has no bound. */
void json_known(json *json, const char *name, double value);
void json_count(json *json, const char *name, uint64_t value);
void json_numbers(json *json, const char *name, const double values[], size_t count);

#endif
