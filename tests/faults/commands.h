#ifndef TEST_COMMANDS_H
#define TEST_COMMANDS_H

#include "faults/faulted.h"
#include "programs/programs.h"

/* What is run with faults: armtol in all its ways, and the two programs of 1987 in a folder with old files. */

enum { COMMANDS = 16, COMMAND_ARGUMENTS = 18 };

/* Arguments of armtol; files of theirs are in the folder that files_for_commands fills. */
extern const char *const commands[COMMANDS][COMMAND_ARGUMENTS];

/* How a failure calls it. */
string name_of_command(int command);

/* A new folder with the files that the commands read. */
string folder_for_commands(void);

/* Start armtol with that command in the folder. */
void start_command(int command, const char *folder);

/* A folder for a run of the one or the other, and such a run started. */
string start_session(const tested *program);

/* Put the folder as it is before the run: old files of all four names, and nothing else; or nothing at all. */
void prepare_session(const char *folder, const tested *program, bool old);

/*
 * How many of the four files are of the run and whole, in their order; the others must be old and whole, or where
 * `old` is false, not there. Drafts (.NAME.part) may be there where `drafts` says so.
 */
int check_session_files(const char *folder, const tested *program, bool old, bool drafts, const char *what);

#endif
