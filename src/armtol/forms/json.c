#include "armtol/forms/json.h"

#include "console/number.h"

#include <inttypes.h>
#include <math.h>

static void put_string(const json *json, const char *text)
{
    fputc('"', json->stream);
    for (const unsigned char *c = (const unsigned char *)text; *c != '\0'; c++) {
        if (*c == '"' || *c == '\\') {
            fprintf(json->stream, "\\%c", *c);
        } else if (*c < ' ') {
            fprintf(json->stream, "\\u%04x", (unsigned)*c);
        } else {
            fputc(*c, json->stream);
        }
    }
    fputc('"', json->stream);
}

static void put_number(const json *json, double value)
{
    fputs(isfinite(value) ? number_shortest(value, &armtol_errata_none, &(number_text){""}) : "null", json->stream);
}

static void new_line(const json *json)
{
    fprintf(json->stream, "\n%*s", (int)(2 * json->depth), "");
}

/* The comma, the line and the name that come before a value. */
static void begin_value(json *json, const char *name)
{
    if (!json->first) {
        fputc(',', json->stream);
    }
    if (json->depth > 0) {
        new_line(json);
    }
    json->first = false;
    if (name != NULL) {
        put_string(json, name);
        fputs(": ", json->stream);
    }
}

static void open_one(json *json, const char *name, char bracket)
{
    begin_value(json, name);
    fputc(bracket, json->stream);
    json->depth++;
    json->first = true;
}

static void close_one(json *json, char bracket)
{
    const bool empty = json->first;
    json->depth--;
    json->first = false;
    if (!empty) {
        new_line(json);
    }
    fputc(bracket, json->stream);
}

void json_start(json *json, FILE *stream)
{
    *json = (struct json){.stream = stream, .first = true};
    json_open_object(json, NULL);
}

void json_end(json *json)
{
    json_close_object(json);
    fputc('\n', json->stream);
}

void json_open_object(json *json, const char *name)
{
    open_one(json, name, '{');
}

void json_close_object(json *json)
{
    close_one(json, '}');
}

void json_open_array(json *json, const char *name)
{
    open_one(json, name, '[');
}

void json_close_array(json *json)
{
    close_one(json, ']');
}

void json_text(json *json, const char *name, const char *text)
{
    begin_value(json, name);
    put_string(json, text);
}

void json_text_if(json *json, const char *name, const char *text)
{
    if (text != NULL) {
        json_text(json, name, text);
    }
}

void json_number(json *json, const char *name, double value)
{
    begin_value(json, name);
    put_number(json, value);
}

void json_known(json *json, const char *name, double value)
{
    if (!isnan(value)) {
        json_number(json, name, value);
    }
}

void json_count(json *json, const char *name, uint64_t value)
{
    begin_value(json, name);
    fprintf(json->stream, "%" PRIu64, value);
}

void json_numbers(json *json, const char *name, const double values[], size_t count)
{
    begin_value(json, name);
    fputc('[', json->stream);
    for (size_t i = 0; i < count; i++) {
        fputs(i > 0 ? ", " : "", json->stream);
        put_number(json, values[i]);
    }
    fputc(']', json->stream);
}
