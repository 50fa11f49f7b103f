#ifndef ARMTOL_FILES_OUTFILE_H
#define ARMTOL_FILES_OUTFILE_H

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

enum { OUTFILE_NAME = 256 };

/* A file to be: its name and what writes it. */
typedef struct outfile {
    char name[OUTFILE_NAME];
    void (*write)(FILE *stream, const void *data);
} outfile;

/* False, after a message, where the folder is missing, no folder or not writable. */
bool folder_open(folder *folder, const char *path);
void folder_close(folder *folder);

/* Write them all, or none as far as said above. False after a message that names the file. */
bool outfiles_write(const folder *folder, const outfile files[], size_t count, const void *data);

/* A single file at a path, its folder open. */
typedef struct outfile_place {
    char above[4096]; /* the path of the folder */
    folder folder;
    char name[OUTFILE_NAME];
} outfile_place;

/* Whether a file can be there, found out before there is anything to write. False after a message; else to close. */
bool outfile_open(outfile_place *place, const char *path);
void outfile_close(outfile_place *place);

/* The file, written from the data. False after a message. */
bool outfile_write_at(const outfile_place *place, void (*write)(FILE *stream, const void *data), const void *data);

/* Whether a path is "-", which stands for standard output; NULL is none. */
bool outfile_is_standard(const char *path);

/* All three at once; or on standard output, where that can fail at its end. */
bool outfile_write(const char *path, void (*write)(FILE *stream, const void *data), const void *data);

#endif
