#include "lab/reproduce/run_case.h"

#include "1987/program.h"
#include "1987/report.h"
#include "console/exit_code.h"
#include "console/message.h"

#include <errno.h>
#include <fcntl.h>
#include <spawn.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>

extern char **environ;

static bool complain(const char *path)
{
    if (errno == ENOMEM) {
        out_of_memory();
    } else {
        message("%s: %s", path, strerror(errno));
    }
    return false;
}

bool path_of(path *path, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    const int length = vsnprintf(path->text, sizeof path->text, format, arguments);
    va_end(arguments);
    errno = ENAMETOOLONG;
    return (length >= 0 && (size_t)length < sizeof path->text) || complain(path->text);
}

static bool make_folders(const path *folder)
{
    path part = *folder;
    bool fine = true;
    for (char *slash = part.text; fine && slash != NULL;) {
        slash = strchr(slash + 1, '/');
        if (slash != NULL) {
            *slash = '\0';
        }
        fine = mkdir(part.text, 0777) == 0 || errno == EEXIST || complain(part.text);
        if (slash != NULL) {
            *slash = '/';
        }
    }
    return fine;
}

/* A file of report_files in a case's folder. */
static bool path_of_file(path *path, const run_settings *settings, const published_number *number, int file)
{
    const program *program = program_named(number->program);
    return program != NULL && path_of(path, "%s/%s-%d/%s%s.1", settings->out, number->program, number->case_number,
                                      program->file_prefix, report_files[file].part);
}

/* What a person would type, a line for each question. */
static bool write_input(const char *path, const published_list *list, size_t first)
{
    FILE *stream = fopen(path, "w");
    if (stream == NULL) {
        return complain(path);
    }
    for (int role = ROLE_POSITION; role < ROLE_RESULT; role++) {
        const char *separator = "";
        for (size_t i = first; i < list->count; i++) {
            const published_number *number = &list->numbers[i];
            if ((int)number->role == role && published_same_case(number, &list->numbers[first])) {
                fprintf(stream, "%s%s", separator, number->value);
                separator = " ";
            }
        }
        fputc('\n', stream);
    }
    return fclose(stream) == 0 || complain(path);
}

static int open_files(posix_spawn_file_actions_t *actions, const char *input, const char *dialogue)
{
    const int failure = posix_spawn_file_actions_addopen(actions, 0, input, O_RDONLY, 0);
    return failure != 0
               ? failure
               : posix_spawn_file_actions_addopen(actions, 2, dialogue, O_WRONLY | O_CREAT | O_TRUNC, 0666);
}

/* Start argv with its input and its standard error in files. 0, or what errno would be. */
static int start(pid_t *child, char *const argv[], const char *input, const char *dialogue)
{
    posix_spawn_file_actions_t actions;
    int failure = posix_spawn_file_actions_init(&actions);
    if (failure == 0) {
        failure = open_files(&actions, input, dialogue);
        failure = failure != 0 ? failure : posix_spawn(child, argv[0], &actions, NULL, argv, environ);
        posix_spawn_file_actions_destroy(&actions);
    }
    return failure;
}

/* Run argv to its end. Its exit status, or -1 with errno. */
static int spawn(char *const argv[], const char *input, const char *dialogue)
{
    pid_t child;
    int status = 0;
    const int failure = start(&child, argv, input, dialogue);
    if (failure != 0) {
        errno = failure;
        return -1;
    }
    while (waitpid(child, &status, 0) < 0) {
        if (errno != EINTR) {
            return -1;
        }
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/* The command was run to its end: say so if it failed. */
static bool judge(int status, const char *program, const char *dialogue)
{
    if (status < 0) {
        return complain(program);
    }
    if (status > 0) {
        message("%s ended with %d; what it said is in %s", program, status, dialogue);
    }
    return status == 0;
}

/* The places of a case. */
typedef struct places {
    path folder, input, dialogue, program;
} places;

static bool run_port(const run_settings *settings, places *at)
{
    path output, fix;
    if (!path_of(&output, "--output=%s", at->folder.text) ||
        !path_of(&fix, "--fix=%s", settings->fix != NULL ? settings->fix : "")) {
        return false;
    }
    char *const argv[] = {at->program.text, output.text, settings->fix != NULL ? fix.text : NULL, NULL};
    return judge(spawn(argv, at->input.text, at->dialogue.text), at->program.text, at->dialogue.text);
}

/* A legacy program writes into its current folder, which only a shell changes without a fork of our own. */
static bool run_legacy(const run_settings *settings, places *at)
{
    static char shell[] = "/bin/sh", option[] = "-c";
    path script;
    char *absolute = realpath(at->program.text, NULL);
    char *const argv[] = {shell, option, script.text, at->folder.text, absolute, NULL};
    bool fine = absolute != NULL || complain(at->program.text);
    fine = fine && path_of(&script, "cd \"$0\" && exec %s \"$@\"", settings->runner) &&
           judge(spawn(argv, at->input.text, at->dialogue.text), at->program.text, at->dialogue.text);
    free(absolute);
    return fine;
}

/* What an earlier run has left must not pass for what this one writes. */
static bool remove_old(const run_settings *settings, const published_number *number)
{
    bool fine = true;
    for (int i = 0; program_named(number->program) != NULL && i < REPORT_FILES && fine; i++) {
        path path;
        fine = path_of_file(&path, settings, number, i) &&
               (remove(path.text) == 0 || errno == ENOENT || complain(path.text));
    }
    return fine;
}

bool run_case(const run_settings *settings, const published_list *list, size_t first)
{
    const published_number *number = &list->numbers[first];
    places at;
    return path_of(&at.folder, "%s/%s-%d", settings->out, number->program, number->case_number) &&
           path_of(&at.input, "%s/input", at.folder.text) && path_of(&at.dialogue, "%s/dialogue", at.folder.text) &&
           path_of(&at.program, "%s/%s", settings->programs, number->program) && make_folders(&at.folder) &&
           remove_old(settings, number) && write_input(at.input.text, list, first) &&
           (settings->legacy ? run_legacy(settings, &at) : run_port(settings, &at));
}

/* Append what the stream has to the text, NULL at first, which grows and may move. */
static bool append_stream(char **text, size_t *length, FILE *stream, const char *path)
{
    enum { CHUNK = 4096 };
    for (size_t got = 1; got > 0; *length += got) {
        char *grown = realloc(*text, *length + CHUNK + 1);
        if (grown == NULL) {
            out_of_memory();
            return false;
        }
        *text = grown;
        got = fread(grown + *length, 1, CHUNK, stream);
    }
    (*text)[*length] = '\0';
    return !ferror(stream) || complain(path);
}

static bool append_file(char **text, size_t *length, const char *path)
{
    FILE *stream = fopen(path, "r");
    if (stream == NULL) {
        return complain(path);
    }
    const bool fine = append_stream(text, length, stream, path);
    fclose(stream);
    return fine;
}

char *run_case_results(const run_settings *settings, const published_number *number)
{
    char *text = NULL;
    size_t length = 0;
    bool fine = true;
    for (int i = REPORT_TOLERANCES; i <= REPORT_MACHINING && fine; i++) {
        path path;
        fine = path_of_file(&path, settings, number, i) && append_file(&text, &length, path.text);
    }
    if (!fine) {
        free(text);
        text = NULL;
    }
    return text;
}
