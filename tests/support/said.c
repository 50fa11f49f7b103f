#include "support/said.h"

#include "unity.h"

#include <unistd.h>

FILE *stream_of(const char *bytes, size_t length)
{
    FILE *stream = tmpfile();
    TEST_ASSERT_NOT_NULL_MESSAGE(stream, "no temporary file");
    TEST_ASSERT_EQUAL_UINT(length, fwrite(bytes, 1, length, stream));
    TEST_ASSERT_EQUAL_INT(0, fflush(stream));
    rewind(stream);
    return stream;
}

static FILE *caught;
static int standard_error;

void said_begin(void)
{
    caught = tmpfile();
    TEST_ASSERT_NOT_NULL_MESSAGE(caught, "no temporary file");
    fflush(stderr);
    standard_error = dup(STDERR_FILENO);
    TEST_ASSERT_TRUE(standard_error >= 0 && dup2(fileno(caught), STDERR_FILENO) >= 0);
}

void said_end(said *said)
{
    fflush(stderr);
    const int restored = dup2(standard_error, STDERR_FILENO);
    close(standard_error);
    rewind(caught);
    said->text[fread(said->text, 1, sizeof said->text - 1, caught)] = '\0';
    fclose(caught);
    TEST_ASSERT_TRUE(restored >= 0);
}
