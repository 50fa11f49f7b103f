#ifndef ARMTOL_1987_OUTFILE_H
#define ARMTOL_1987_OUTFILE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/*
 * Files that appear whole or not at all. Each is written under a temporary name in its folder and renamed when
 * all that belong together are complete. Until then what stood there before is untouched. Every file is whole at every
 * moment. Files that belong together are of two runs only where the renames come apart: the folder refuses the second
 * of two (another user's file in a sticky folder, say), SIGKILL or a crash of the machine comes between them, or those
 * of another run with the same names do.
 */

typedef struct folder {
    const char *path; /* for messages */
    int descriptor;
} folder;

/* A file to be: its name and what writes it. */
typedef struct outfile {
    char name[64];
    void (*write)(FILE *stream, const void *data);
} outfile;

/* False, after a message, where the folder is missing, no folder or not writable. */
bool folder_open(folder *folder, const char *path);
void folder_close(folder *folder);

/* Write them all, or none as far as said above. False after a message that names the file. */
bool outfiles_write(const folder *folder, const outfile files[], size_t count, const void *data);

#endif
