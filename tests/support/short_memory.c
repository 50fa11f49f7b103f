#include "support/short_memory.h"

#include <errno.h>
#include <limits.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>

static long left = LONG_MAX;
static memory_lack kind;
static bool short_of_it;

void memory_is_left(long n, memory_lack lack)
{
    left = n;
    kind = lack;
    short_of_it = false;
}

bool memory_was_short(void)
{
    return short_of_it;
}

void memory_is_enough(void)
{
    left = LONG_MAX;
}

/* Counts as one. */
static bool memory_fails(void)
{
    const bool fails = kind == LACK_ONCE ? left == 0 : left <= 0;
    left--;
    if (fails) {
        short_of_it = true;
        errno = ENOMEM;
    }
    return fails;
}

void *__real_malloc(size_t size);
void *__real_calloc(size_t count, size_t size);
void *__real_realloc(void *old, size_t size);
char *__real_strdup(const char *text);
FILE *__real_fdopen(int descriptor, const char *mode);
FILE *__real_open_memstream(char **text, size_t *size);
void *__wrap_malloc(size_t size);
void *__wrap_calloc(size_t count, size_t size);
void *__wrap_realloc(void *old, size_t size);
char *__wrap_strdup(const char *text);
FILE *__wrap_fdopen(int descriptor, const char *mode);
FILE *__wrap_open_memstream(char **text, size_t *size);

#define ADD_OPEN posix_spawn_file_actions_t *actions, int descriptor, const char *path, int flags, mode_t mode
int __real_posix_spawn_file_actions_addopen(ADD_OPEN);
int __wrap_posix_spawn_file_actions_addopen(ADD_OPEN);

void *__wrap_malloc(size_t size)
{
    return memory_fails() ? NULL : __real_malloc(size);
}

void *__wrap_calloc(size_t count, size_t size)
{
    return memory_fails() ? NULL : __real_calloc(count, size);
}

void *__wrap_realloc(void *old, size_t size)
{
    return memory_fails() ? NULL : __real_realloc(old, size);
}

char *__wrap_strdup(const char *text)
{
    return memory_fails() ? NULL : __real_strdup(text);
}

FILE *__wrap_fdopen(int descriptor, const char *mode)
{
    return memory_fails() ? NULL : __real_fdopen(descriptor, mode);
}

FILE *__wrap_open_memstream(char **text, size_t *size)
{
    return memory_fails() ? NULL : __real_open_memstream(text, size);
}

int __wrap_posix_spawn_file_actions_addopen(ADD_OPEN)
{
    return memory_fails() ? ENOMEM
                          : __real_posix_spawn_file_actions_addopen(actions, descriptor, path, flags, mode);
}
