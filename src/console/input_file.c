#include "console/input_file.h"

#include "console/exit_code.h"
#include "console/message.h"

#include <errno.h>
#include <string.h>

FILE *input_file_open(const char *before, const char *path, const char *behind)
{
    FILE *stream = fopen(path, "rb");
    if (stream == NULL) {
        exit_code_note_error(errno);
        message("%s%s: %s%s", before, path, strerror(errno), behind);
    }
    return stream;
}
