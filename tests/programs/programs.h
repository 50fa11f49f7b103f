#ifndef TEST_PROGRAMS_H
#define TEST_PROGRAMS_H

#include "support/process.h"

#include <stddef.h>

/* The two programs under test, and what right runs of them are. */

/* The files of a run, in the order in which they are written; the first two and the last two together. */
enum { FILE_A, FILE_ORDERED, FILE_TOLERANCES, FILE_MACHINING, FILES };

/* The questions of a run, in order. */
enum { QUESTION_WISH, QUESTION_TOLERANCES, QUESTION_DELTA, QUESTIONS };
extern const char *const prompts[QUESTIONS];

typedef struct tested {
    const char *name;               /* its messages begin with it */
    const char *path;
    const char *legacy;             /* the program of 1987; what it never sets is zero */
    const char *files[FILES];       /* names without the run number and the point before it */
    size_t starts[QUESTIONS + 1];   /* the number that each question begins with; last, how many there are */
    const char *const *value_names; /* of all numbers asked for, as messages call them */
    const char *const *words;       /* the paper's first case, as one might type it */
} tested;

enum { PROGRAMS = 2 };
extern const tested programs[PROGRAMS];

/* The ids of all errata, in the order of --list-errata. */
enum { ERRATA = 16 };
extern const char *const errata[ERRATA];

/* The paper's first case: the words first to end - 1 in a line; the answer to a question; all answers. */
string words_between(const tested *program, size_t first, size_t end);
string right_answer(const tested *program, int question);
string right_answers(const tested *program);

/* A file of run 1. */
string file_of(const char *folder, const tested *program, int file);

/* The files of a run as folder_list has them, after 0, 1 or 2 pairs of them are written. */
string listing_of(const tested *program, int pairs, int run);

/* How a failure calls a run: the command. Arguments, here and below, go up to a NULL and may be NULL. */
string command_of(const tested *program, const char *const arguments[]);

/* Run it in a folder. */
void run_in(const char *folder, const tested *program, const char *const arguments[], const char *input,
            process *process);

/* Give it right answers, to the questions first to end - 1: at once, or each when it is asked. */
void say_answers(process *process, const tested *program, int first, int end);
void answer_prompts(process *process, const tested *program, int first, int end);

/* Start it, and answer right up to the prompt of a question. */
void start_up_to(process *process, const process_setup *setup, const tested *program, int question);

/* What golden/ has of a program's case, 1 or 2. The set is golden_1987 or golden_corrected. */
extern const char golden_1987[], golden_corrected[];
string golden_of(const char *set, const tested *program, int number, const char *name);

/* The files in a folder, of a run of that number, are those of golden/: all four, or the first n_files. */
void check_golden(const char *folder, int run, const tested *program, const char *set, int number,
                  int n_files, const char *what);

/* Files that were there before the run: one of each name, of run 1. */
void write_old_files(const char *folder, const tested *program);

/* Those first to end - 1 are as they were. */
void check_old_files(const char *folder, const tested *program, int first, int end, const char *what);

/* The last line on standard error is this program's message, and has those words. */
void check_message(const process *process, const tested *program, const char *words, const char *what);

#endif
