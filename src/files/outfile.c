#include "files/outfile.h"

#include "console/message.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

typedef struct draft {
    char name[96];
    bool exists;
} draft;

/*
 * Where a standard stream is closed its number is free, and goes to what is opened next: messages would be written
 * into a file, and a folder be read. Moves a descriptor out of the way; errno says why that cannot be.
 */
static int above_standard(int descriptor)
{
    if (descriptor < 0 || descriptor > STDERR_FILENO) {
        return descriptor;
    }
    const int moved = fcntl(descriptor, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
    const int why = errno;
    close(descriptor);
    errno = why;
    return moved;
}

bool folder_open(folder *folder, const char *path)
{
    folder->path = path;
    folder->descriptor = above_standard(open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (folder->descriptor < 0) {
        message("output folder \"%s\": %s", path, strerror(errno));
        return false;
    }
    if (faccessat(folder->descriptor, ".", W_OK | X_OK, 0) != 0) {
        message("output folder \"%s\": not writable: %s", path, strerror(errno));
        folder_close(folder);
        return false;
    }
    return true;
}

void folder_close(folder *folder)
{
    close(folder->descriptor);
}

static bool complain(const folder *folder, const char *name, const char *what)
{
    message("%s/%s: %s", folder->path, name, what);
    return false;
}

/* rename would replace a FIFO or a device, and fail at a folder when its companion is already in place. */
static bool may_replace(const folder *folder, const char *name)
{
    struct stat status;
    if (fstatat(folder->descriptor, name, &status, AT_SYMLINK_NOFOLLOW) != 0) {
        return errno == ENOENT || complain(folder, name, strerror(errno));
    }
    if (!S_ISREG(status.st_mode) && !S_ISLNK(status.st_mode)) {
        return complain(folder, name, "exists and is not a regular file");
    }
    return true;
}

/*
 * A new file under a name of its own, the file's shortened where it is long, since a name has 255 bytes at most. One
 * that is taken is somebody else's, a killed run's or one on another machine that shares the folder and happens to have
 * our number: it is left alone.
 */
static int create(const folder *folder, const outfile *file, draft *draft)
{
    enum { TRIES = 100 };
    int descriptor = -1;
    for (int n = 0; n < TRIES && descriptor < 0; n++) {
        snprintf(draft->name, sizeof draft->name, ".%.60s.%ld-%d.part", file->name, (long)getpid(), n);
        descriptor = openat(folder->descriptor, draft->name,
                            O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
        if (descriptor < 0 && errno != EEXIST) {
            break;
        }
    }
    draft->exists = descriptor >= 0;
    return above_standard(descriptor);
}

static FILE *draft_open(const folder *folder, const outfile *file, draft *draft)
{
    const int descriptor = create(folder, file, draft);
    if (descriptor < 0) {
        return NULL;
    }
    FILE *stream = fdopen(descriptor, "w");
    if (stream == NULL) {
        const int why = errno;
        close(descriptor);
        errno = why;
    }
    return stream;
}

/* Whether everything has reached the disk; errno says why not. */
static bool finish(FILE *stream)
{
    const bool written = !ferror(stream) && fflush(stream) == 0 && fsync(fileno(stream)) == 0;
    const int why = errno;
    const bool closed = fclose(stream) == 0;
    if (!written) {
        errno = why;
    }
    return written && closed;
}

static bool draft_write(const folder *folder, const outfile *file, const void *data, draft *draft)
{
    FILE *stream = draft_open(folder, file, draft);
    if (stream == NULL) {
        return complain(folder, file->name, strerror(errno));
    }
    file->write(stream, data);
    return finish(stream) || complain(folder, file->name, strerror(errno));
}

static bool publish(const folder *folder, const outfile *file, draft *draft)
{
    if (renameat(folder->descriptor, draft->name, folder->descriptor, file->name) != 0) {
        return complain(folder, file->name, strerror(errno));
    }
    draft->exists = false;
    return true;
}

static bool write_all(const folder *folder, const outfile files[], size_t count, const void *data,
                      draft drafts[])
{
    bool fine = true;
    for (size_t i = 0; i < count && fine; i++) {
        fine = may_replace(folder, files[i].name);
    }
    for (size_t i = 0; i < count && fine; i++) {
        fine = draft_write(folder, &files[i], data, &drafts[i]);
    }
    for (size_t i = 0; i < count && fine; i++) {
        fine = publish(folder, &files[i], &drafts[i]);
    }
    return fine;
}

static void remove_drafts(const folder *folder, const draft drafts[], size_t count)
{
    for (size_t i = 0; i < count; i++) {
        if (drafts[i].exists) {
            unlinkat(folder->descriptor, drafts[i].name, 0);
        }
    }
}

/* A signal that would end the program waits until no draft is left behind; one that tells of a crash does not. */
static void hold_signals(sigset_t *held)
{
    static const int crashes[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP, SIGSYS};
    sigfillset(held);
    for (size_t i = 0; i < sizeof crashes / sizeof crashes[0]; i++) {
        sigdelset(held, crashes[i]);
    }
}

bool outfiles_write(const folder *folder, const outfile files[], size_t count, const void *data)
{
    enum { MOST = 4 };
    draft drafts[MOST] = {{{0}, false}};
    sigset_t held, before;

    if (count > MOST) {
        return complain(folder, files[MOST].name, "too many files at once");
    }
    hold_signals(&held);
    sigprocmask(SIG_BLOCK, &held, &before);
    const bool fine = write_all(folder, files, count, data, drafts);
    remove_drafts(folder, drafts, count);
    sigprocmask(SIG_SETMASK, &before, NULL);
    return fine;
}

bool outfile_open(outfile_place *place, const char *path)
{
    const char *const slash = strrchr(path, '/'), *const name = slash != NULL ? slash + 1 : path;
    const size_t length = slash == NULL ? 0 : slash == path ? 1 : (size_t)(slash - path);
    const bool fits = strlen(name) < sizeof place->name && length < sizeof place->above;
    if (*name == '\0' || !fits) {
        message("%s: %s", path, fits ? "is no name of a file" : strerror(ENAMETOOLONG));
        return false;
    }
    snprintf(place->above, sizeof place->above, "%.*s", length > 0 ? (int)length : 1, length > 0 ? path : ".");
    snprintf(place->name, sizeof place->name, "%s", name);
    if (!folder_open(&place->folder, place->above)) {
        return false;
    }
    const bool fine = may_replace(&place->folder, place->name);
    if (!fine) {
        outfile_close(place);
    }
    return fine;
}

void outfile_close(outfile_place *place)
{
    folder_close(&place->folder);
}

bool outfile_write_at(const outfile_place *place, void (*write)(FILE *stream, const void *data), const void *data)
{
    outfile file = {.write = write};
    memcpy(file.name, place->name, sizeof file.name);
    return outfiles_write(&place->folder, &file, 1, data);
}

bool outfile_is_standard(const char *path)
{
    return path != NULL && strcmp(path, "-") == 0;
}

bool outfile_write(const char *path, void (*write)(FILE *stream, const void *data), const void *data)
{
    outfile_place place;
    if (outfile_is_standard(path)) {
        write(stdout, data);
        return true;
    }
    if (!outfile_open(&place, path)) {
        return false;
    }
    const bool fine = outfile_write_at(&place, write, data);
    outfile_close(&place);
    return fine;
}
