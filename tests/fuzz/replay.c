/* In place of libFuzzer: gives every file of the folders that it is called with to the harness, once. */

#include "fuzz/harness.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 1 << 20 };

static void fail(const char *what)
{
    perror(what);
    exit(1);
}

/* In memory of just its size, so that a read beyond it is seen where reads are watched. */
static void replay(const char *path)
{
    static char bytes[MOST];
    FILE *stream = fopen(path, "rb");
    if (stream == NULL) {
        fail(path);
    }
    const size_t size = fread(bytes, 1, sizeof bytes, stream);
    fclose(stream);
    uint8_t *exact = malloc(size > 0 ? size : 1);
    if (exact == NULL) {
        fail("memory");
    }
    memcpy(exact, bytes, size);
    LLVMFuzzerTestOneInput(exact, size);
    free(exact);
}

static size_t replay_folder(const char *folder)
{
    size_t n = 0;
    DIR *entries = opendir(folder);
    if (entries == NULL) {
        fail(folder);
    }
    for (const struct dirent *entry = readdir(entries); entry != NULL; entry = readdir(entries)) {
        if (entry->d_name[0] != '.') {
            char path[4096];
            snprintf(path, sizeof path, "%s/%s", folder, entry->d_name);
            printf("%s\n", path);
            fflush(stdout); /* the name of the one that ends it is the last */
            replay(path);
            n++;
        }
    }
    closedir(entries);
    return n;
}

int main(int argc, char *argv[])
{
    size_t n = 0;
    LLVMFuzzerInitialize(&argc, &argv);
    for (int i = 1; i < argc; i++) {
        n += replay_folder(argv[i]);
    }
    printf("%zu inputs\n", n);
    return n > 0 ? 0 : 1;
}
