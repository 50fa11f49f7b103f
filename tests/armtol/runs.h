#ifndef TEST_RUNS_H
#define TEST_RUNS_H

#include "support/process.h"

/* Runs of the program armtol in a folder, without input; what they printed is in *process. */
void run(process *process, const char *folder, const char *const arguments[]);

/* One that has to be right: status 0, and nothing on standard error. */
void run_well(process *process, const char *folder, const char *const arguments[]);

/* One that is refused: status 2, nothing on standard output, and the words somewhere on standard error. */
void check_refused_run(const char *folder, const char *const arguments[], const char *words);

/* The same where the message is all that is on standard error, the name "armtol: " before it. */
void check_refused_line(const char *folder, const char *const arguments[], const char *message);

/* The words stand somewhere on its standard output. */
void check_says(const process *process, const char *words);

/* What comes after the words, which have to be in the text; and the number there. */
const char *text_after(const char *text, const char *words);
double number_after(const char *text, const char *words);

/* The number behind "name": in the JSON on standard output, from where the words stand on. */
double json_number(const process *process, const char *words, const char *name);

#endif
