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

char *path_of(const char *format, ...)
{
    va_list arguments, again;
    va_start(arguments, format);
    va_copy(again, arguments);
    const int length = vsnprintf(NULL, 0, format, arguments);
    char *path = length < 0 ? NULL : malloc((size_t)length + 1);
    if (path != NULL) {
        vsnprintf(path, (size_t)length + 1, format, again);
    } else {
        out_of_memory();
    }
    va_end(again);
    va_end(arguments);
    return path;
}

bool make_folders(const char *path)
{
    char *part = path_of("%s", path);
    bool fine = part != NULL;
    for (char *slash = part; fine && slash != NULL;) {
        slash = strchr(slash + 1, '/');
        if (slash != NULL) {
            *slash = '\0';
        }
        fine = mkdir(part, 0777) == 0 || errno == EEXIST || complain(part);
        if (slash != NULL) {
            *slash = '/';
        }
    }
    free(part);
    return fine;
}

/* A file of report_files in a case's folder. */
static char *path_of_file(const char *folder, const program *program, int file)
{
    return path_of("%s/%s%s.1", folder, program->file_prefix, report_files[file].part);
}

static char *case_folder(const run_settings *settings, const published_number *number)
{
    return path_of("%s/%s-%d", settings->out, number->program, number->case_number);
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

static bool run_port(const run_settings *settings, char *program, const char *folder, const char *input,
                     const char *dialogue)
{
    char *output = path_of("--output=%s", folder);
    char *fix = output != NULL ? path_of("--fix=%s", settings->fix != NULL ? settings->fix : "") : NULL;
    char *const argv[] = {program, output, settings->fix != NULL ? fix : NULL, NULL};
    const bool fine = output != NULL && fix != NULL && judge(spawn(argv, input, dialogue), program, dialogue);
    free(output);
    free(fix);
    return fine;
}

/* A legacy program writes into its current folder, which only a shell changes without a fork of our own. */
static bool run_legacy(const run_settings *settings, char *program, char *folder, const char *input,
                       const char *dialogue)
{
    static char shell[] = "/bin/sh", option[] = "-c";
    char *absolute = realpath(program, NULL);
    char *script = path_of("cd \"$0\" && exec %s \"$@\"", settings->runner);
    char *const argv[] = {shell, option, script, folder, absolute, NULL};
    bool fine = absolute != NULL || complain(program);
    fine = fine && script != NULL && judge(spawn(argv, input, dialogue), program, dialogue);
    free(absolute);
    free(script);
    return fine;
}

static bool run_in(const run_settings *settings, const published_number *number, char *folder, const char *input)
{
    char *program = path_of("%s/%s", settings->programs, number->program);
    char *dialogue = program != NULL ? path_of("%s/dialogue", folder) : NULL;
    bool fine = program != NULL && dialogue != NULL;
    if (fine) {
        fine = settings->legacy ? run_legacy(settings, program, folder, input, dialogue)
                                : run_port(settings, program, folder, input, dialogue);
    }
    free(program);
    free(dialogue);
    return fine;
}

/* What an earlier run has left must not pass for what this one writes. */
static bool remove_old(const published_number *number, const char *folder)
{
    const program *program = program_named(number->program);
    bool fine = true;
    for (int i = 0; program != NULL && i < REPORT_FILES && fine; i++) {
        char *path = path_of_file(folder, program, i);
        fine = path != NULL && (remove(path) == 0 || errno == ENOENT || complain(path));
        free(path);
    }
    return fine;
}

bool run_case(const run_settings *settings, const published_list *list, size_t first)
{
    const published_number *number = &list->numbers[first];
    char *folder = case_folder(settings, number);
    char *input = folder != NULL ? path_of("%s/input", folder) : NULL;
    const bool fine = input != NULL && make_folders(folder) && remove_old(number, folder) &&
                      write_input(input, list, first) && run_in(settings, number, folder, input);
    free(folder);
    free(input);
    return fine;
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
    const program *program = program_named(number->program);
    char *folder = case_folder(settings, number);
    char *text = NULL;
    size_t length = 0;
    bool fine = folder != NULL && program != NULL;
    for (int i = REPORT_TOLERANCES; i <= REPORT_MACHINING && fine; i++) {
        char *path = path_of_file(folder, program, i);
        fine = path != NULL && append_file(&text, &length, path);
        free(path);
    }
    free(folder);
    if (!fine) {
        free(text);
        text = NULL;
    }
    return text;
}
