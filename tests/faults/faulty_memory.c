/* Memory: our malloc and the like come before libc's, for the program, its libraries and libc itself. */

#define _GNU_SOURCE /* RTLD_NEXT, dl_iterate_phdr */

#include "faults/faulty.h"

#include <dlfcn.h>
#include <errno.h>
#include <link.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

void *malloc(size_t size);
void *calloc(size_t count, size_t size);
void *realloc(void *old, size_t size);
void free(void *block);

static void *(*real_malloc)(size_t size);
static void *(*real_calloc)(size_t count, size_t size);
static void *(*real_realloc)(void *old, size_t size);
static void (*real_free)(void *block);

/* Where code of the program itself is. */
static uintptr_t program_begin, program_end;

/*
 * The blocks that the program's own code has and has not freed, 0 where none is. Disguised, or valgrind would take each
 * for one that can still be reached.
 */
enum { MOST_BLOCKS = 1 << 12 };
static uintptr_t blocks[MOST_BLOCKS];
static size_t n_blocks; /* places that have been used */

static uintptr_t disguised(const void *block)
{
    return ~(uintptr_t)block;
}

/* Between the beginning and the end of main. */
static bool in_main(void)
{
    return faulty_outcome != NULL && !faulty_outcome->ended;
}

static void keep(void *block, const void *caller)
{
    const bool own = (uintptr_t)caller >= program_begin && (uintptr_t)caller < program_end;
    if (!in_main() || block == NULL || !own) {
        return;
    }
    size_t i = 0;
    while (i < n_blocks && blocks[i] != 0) {
        i++;
    }
    if (i < MOST_BLOCKS) {
        blocks[i] = disguised(block);
        n_blocks += i == n_blocks;
    }
    faulty_outcome->live++;
}

static void drop(const void *block)
{
    for (size_t i = 0; in_main() && block != NULL && i < n_blocks; i++) {
        if (blocks[i] == disguised(block)) {
            blocks[i] = 0;
            faulty_outcome->live--;
            return;
        }
    }
}

static bool fails(void)
{
    if (!in_main()) {
        return false;
    }
    const long n = ++faulty_outcome->allocations;
    const long at = faulty_plan.allocation;
    if (at == 0 || n < at || (n > at && !faulty_plan.all_after)) {
        return false;
    }
    faulty_outcome->happened = true;
    errno = ENOMEM;
    return true;
}

/* dlsym may ask for memory before it has told us where memory comes from. */
static void *early(size_t size)
{
    static long double room[256]; /* zero, and aligned for anything */
    static size_t used;
    const size_t count = (size + sizeof room[0] - 1) / sizeof room[0];
    if (count > sizeof room / sizeof room[0] - used) {
        return NULL;
    }
    used += count;
    return &room[used - count];
}

static int note_program(struct dl_phdr_info *info, size_t size, void *context)
{
    (void)size;
    (void)context;
    for (int i = 0; i < info->dlpi_phnum; i++) {
        const uintptr_t begin = info->dlpi_addr + info->dlpi_phdr[i].p_vaddr;
        if (info->dlpi_phdr[i].p_type == PT_LOAD && (info->dlpi_phdr[i].p_flags & PF_X) != 0) {
            program_begin = begin;
            program_end = begin + info->dlpi_phdr[i].p_memsz;
        }
    }
    return 1; /* the first is the program; enough */
}

void faulty_memory_start(void)
{
    static bool started;
    if (!started) {
        started = true;
        *(void **)&real_free = dlsym(RTLD_NEXT, "free");
        *(void **)&real_realloc = dlsym(RTLD_NEXT, "realloc");
        *(void **)&real_calloc = dlsym(RTLD_NEXT, "calloc");
        *(void **)&real_malloc = dlsym(RTLD_NEXT, "malloc");
        dl_iterate_phdr(note_program, NULL);
    }
}

void *malloc(size_t size)
{
    faulty_memory_start();
    void *block = real_malloc == NULL ? early(size) : fails() ? NULL : real_malloc(size);
    keep(block, __builtin_return_address(0));
    return block;
}

void *calloc(size_t count, size_t size)
{
    faulty_memory_start();
    void *block = real_malloc == NULL ? early(count * size) : fails() ? NULL : real_calloc(count, size);
    keep(block, __builtin_return_address(0));
    return block;
}

void *realloc(void *old, size_t size)
{
    faulty_memory_start();
    if (fails()) {
        return NULL;
    }
    drop(old);
    void *block = real_realloc(old, size);
    keep(block, __builtin_return_address(0));
    return block;
}

void free(void *block)
{
    faulty_memory_start();
    drop(block);
    if (real_free != NULL) {
        real_free(block);
    }
}

char *strdup(const char *text)
{
    const size_t size = strlen(text) + 1;
    char *copy = malloc(size);
    if (copy == NULL) {
        return NULL;
    }
    drop(copy);
    keep(copy, __builtin_return_address(0));
    return memcpy(copy, text, size);
}
