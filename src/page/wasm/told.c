#include "page/wasm/told.h"

#include "console/exit_code.h"

#include <stdio.h>
#include <stdlib.h>

static char *text;
static size_t length;
static json writer;

json *told_begin(void)
{
    free(text);
    text = NULL;
    FILE *stream = open_memstream(&text, &length);
    if (stream == NULL) {
        out_of_memory();
        return NULL;
    }
    json_start(&writer, stream);
    return &writer;
}

const char *told_end(void)
{
    json_end(&writer);
    const bool whole = fclose(writer.stream) == 0;
    return whole && text != NULL ? text : "{}";
}

const char *told_error(const char *why)
{
    json *json = told_begin();
    if (json == NULL) {
        return "{}";
    }
    json_text(json, "error", why);
    return told_end();
}
