#include "armtol/urdf/xacro.h"

#include "console/exit_code.h"
#include "console/message.h"

#include <errno.h>
#include <spawn.h>
#include <stdbool.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#ifndef __EMSCRIPTEN__
extern char **environ;
#endif

enum { NOT_FOUND = 127 }; /* what some systems' posix_spawnp ends the new process with */

static int not_there(const char *path)
{
    message("%s is to be expanded by the program xacro, which is not on the PATH; pip install xacro gets it", path);
    return EXIT_WRONG;
}

static int failed(const char *path, int error)
{
    exit_code_note_error(error);
    message("%s: xacro cannot be run: %s", path, strerror(error));
    return EXIT_FAILED;
}

/* posix_spawnp takes words that could be changed, and does not change them. */
static void set_word(char **word, const char *text)
{
    memcpy(word, &text, sizeof *word);
}

/* 0, or what errno would be. */
#ifdef __EMSCRIPTEN__ /* a page has no other programs */
static int spawn(char *const words[], int output, pid_t *process)
{
    (void)words;
    (void)output;
    *process = 0;
    return ENOENT;
}
#else
static int spawn(char *const words[], int output, pid_t *process)
{
    posix_spawn_file_actions_t actions;
    int error = posix_spawn_file_actions_init(&actions);
    if (error == 0) {
        error = posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
        error = error != 0 ? error : posix_spawnp(process, words[0], &actions, NULL, words, environ);
        posix_spawn_file_actions_destroy(&actions);
    }
    return error;
}
#endif

/* How the process ended; no signal is handled here that could interrupt the wait. */
static int check_end(const char *path, pid_t process)
{
    int status = 0;
    const bool ended = waitpid(process, &status, 0) == process;
    if (ended && status == 0) {
        return EXIT_OK;
    }
    if (ended && WIFEXITED(status) && WEXITSTATUS(status) == NOT_FOUND) {
        return not_there(path);
    }
    message("%s: xacro could not expand it", path);
    return EXIT_WRONG;
}

static int run(const char *path, char *const words[], FILE *output)
{
    pid_t process;
    const int error = spawn(words, fileno(output), &process);
    if (error != 0) {
        return error == ENOENT ? not_there(path) : failed(path, error);
    }
    return check_end(path, process);
}

int xacro_expand(const char *path, const char *const arguments[], size_t n_arguments, FILE **expanded)
{
    char *words[XACRO_ARGUMENTS_MOST + 3] = {NULL};
    set_word(&words[0], "xacro");
    set_word(&words[1], path);
    for (size_t i = 0; i < n_arguments; i++) {
        set_word(&words[2 + i], arguments[i]);
    }
    *expanded = tmpfile();
    if (*expanded == NULL) {
        return failed(path, errno);
    }
    const int code = run(path, words, *expanded);
    if (code != EXIT_OK) {
        fclose(*expanded);
        return code;
    }
    rewind(*expanded);
    return EXIT_OK;
}
