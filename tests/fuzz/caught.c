#include "fuzz/caught.h"

#include "console/message.h"
#include "fuzz/require.h"

#include <string.h>

static struct {
    const char *program;
    size_t length;
    char text[1 << 20];
} caught;

/* What does not fit is counted and not kept. */
static ssize_t keep(void *cookie, const char *bytes, size_t length)
{
    (void)cookie;
    if (length < sizeof caught.text - caught.length) {
        memcpy(caught.text + caught.length, bytes, length);
        caught.length += length;
    }
    return (ssize_t)length;
}

void caught_start(const char *program)
{
    FILE *stream = fopencookie(NULL, "w", (cookie_io_functions_t){.write = keep});
    REQUIRE(stream != NULL);
    stderr = stream;
    caught.program = program;
    message_start(program);
}

void caught_forget(void)
{
    fflush(stderr);
    caught.length = 0;
    message_answered(true); /* an input before may have ended in the middle of a prompt */
}

size_t caught_length(void)
{
    fflush(stderr);
    return caught.length;
}

const char *caught_text(void)
{
    caught.text[caught_length()] = '\0';
    return caught.text;
}

bool caught_nothing(void)
{
    return caught_length() == 0;
}

bool caught_one_message(void)
{
    const size_t name = strlen(caught.program);
    const char *text = caught_text();
    if (caught.length < name + 4 || strncmp(text, caught.program, name) != 0 || strncmp(text + name, ": ", 2) != 0) {
        return false;
    }
    size_t at = 0;
    while (text[at] != '\0' && (unsigned char)text[at] >= ' ' && text[at] != 127) {
        at++;
    }
    return text[at] == '\n' && at + 1 == caught.length;
}

/* ---- inputs ---- */

typedef struct input {
    const char *at;
    size_t left;
} input;

static ssize_t give(void *cookie, char *bytes, size_t length)
{
    input *input = cookie;
    const size_t given = length < input->left ? length : input->left;
    memcpy(bytes, input->at, given);
    input->at += given;
    input->left -= given;
    return (ssize_t)given;
}

static int end(void *cookie)
{
    free(cookie);
    return 0;
}

FILE *caught_file(const void *bytes, size_t length)
{
    input *input = malloc(sizeof *input);
    REQUIRE(input != NULL);
    *input = (struct input){bytes, length};
    FILE *stream = fopencookie(input, "r", (cookie_io_functions_t){.read = give, .close = end});
    REQUIRE(stream != NULL);
    return stream;
}
