#include "programs/programs.h"

#include <string.h>

const char *const prompts[QUESTIONS] = {
    "enter desired position: ",
    "enter desired position and orientation tolerances: ",
    "enter desired delta: ",
};

const char golden_1987[] = "1987", golden_corrected[] = "corrected";

const char *const errata[ERRATA] = {
    "mtransf-typo",  "parallel-arm", "adept-shift", "skew-residue",    "root-of-ratio",
    "copied-counts", "signed-mach",  "short-pi",    "prismatic-alpha", "beta-sign",
    "half-turns",    "base-twist",   "float",       "labels",          "gppp-clearing",
    "distance-share",
};

static const char *const intella_names[] = {"x",  "y",  "z",   "gamma", "beta", "alpha", "dx",
                                            "dy", "dz", "dwx", "dwy",   "dwz",  "delta"};
static const char *const intella_words[] = {"200", "200", "0",  "0",  "1.57", "0", ".5",
                                            ".5",  ".5",  ".1", ".1", ".1",   ".1"};
static const char *const adpta_names[] = {"x",  "y",   "z",   "theta", "dx",   "dy",
                                          "dz", "dwx", "dwy", "dwz",   "delta"};
static const char *const adpta_words[] = {"200", "200", "0", "0", ".5", ".5", ".5", ".1", ".1", ".1", ".1"};

const tested programs[PROGRAMS] = {
    {
        .name = "intella",
        .path = TEST_INTELLA,
        .legacy = TEST_LEGACY_INTELLA_ZERO,
        .files = {"inta", "intat", "inttol", "intmach"},
        .starts = {0, 6, 12, 13},
        .value_names = intella_names,
        .words = intella_words,
    },
    {
        .name = "adpta",
        .path = TEST_ADPTA,
        .legacy = TEST_LEGACY_ADPTA_ZERO,
        .files = {"adpta", "adptat", "adpttol", "adptmach"},
        .starts = {0, 4, 10, 11},
        .value_names = adpta_names,
        .words = adpta_words,
    },
};

string words_between(const tested *program, size_t first, size_t end)
{
    string line = {""};
    for (size_t i = first; i < end; i++) {
        strcat(line.text, program->words[i]);
        strcat(line.text, i + 1 < end ? " " : "\n");
    }
    return line;
}

string right_answer(const tested *program, int question)
{
    return words_between(program, program->starts[question], program->starts[question + 1]);
}

string right_answers(const tested *program)
{
    return words_between(program, 0, program->starts[QUESTIONS]);
}

string listing_of(const tested *program, int pairs, int run)
{
    static const int sorted[FILES] = {FILE_A, FILE_ORDERED, FILE_MACHINING, FILE_TOLERANCES};
    string listing = {""};
    for (int i = 0; i < 2 * pairs; i++) {
        const string name = string_of("%s%s.%d", i > 0 ? " " : "", program->files[sorted[i]], run);
        strcat(listing.text, name.text);
    }
    return listing;
}

string file_of(const char *folder, const tested *program, int file)
{
    return string_of("%s/%s.1", folder, program->files[file]);
}

string command_of(const tested *program, const char *const arguments[])
{
    string command = string_of("%s", program->name);
    for (int i = 0; arguments != NULL && arguments[i] != NULL; i++) {
        const string longer = string_of("%s %s", command.text, arguments[i]);
        command = longer;
    }
    return command;
}

void run_in(const char *folder, const tested *program, const char *const arguments[], const char *input,
            process *process)
{
    const process_setup setup = {.program = program->path, .arguments = arguments, .folder = folder};
    process_run(process, &setup, input);
}

void say_answers(process *process, const tested *program, int first, int end)
{
    for (int i = first; i < end; i++) {
        const string answer = right_answer(program, i);
        process_say(process, answer.text);
    }
}

void answer_prompts(process *process, const tested *program, int first, int end)
{
    for (int i = first; i < end; i++) {
        process_expect(process, prompts[i]);
        say_answers(process, program, i, i + 1);
    }
}

void start_up_to(process *process, const process_setup *setup, const tested *program, int question)
{
    process_start(process, setup);
    answer_prompts(process, program, 0, question);
    process_expect(process, prompts[question]);
}

string golden_of(const char *set, const tested *program, int number, const char *name)
{
    return string_of("%s/%s/%s-%d/%s", TEST_GOLDEN, set, program->name, number, name);
}

void check_golden(const char *folder, int run, const tested *program, const char *set, int number,
                  int n_files, const char *what)
{
    for (int i = 0; i < n_files; i++) {
        const string golden_name = string_of("%s.1", program->files[i]);
        const string golden = golden_of(set, program, number, golden_name.text);
        const string actual = string_of("%s/%s.%d", folder, program->files[i], run);
        file_check_same(golden.text, actual.text, what);
    }
}

static const char old_content[] = "what stood here before\n";

void write_old_files(const char *folder, const tested *program)
{
    for (int i = 0; i < FILES; i++) {
        const string name = file_of(folder, program, i);
        file_write(name.text, old_content);
    }
}

void check_old_files(const char *folder, const tested *program, int first, int end, const char *what)
{
    for (int i = first; i < end; i++) {
        const string name = file_of(folder, program, i);
        file_check(name.text, old_content, what);
    }
}

void check_message(const process *process, const tested *program, const char *words, const char *what)
{
    const string line = process_last_line(process);
    const string begin = string_of("%s: ", program->name);
    if (strncmp(line.text, begin.text, strlen(begin.text)) != 0 || strstr(line.text, words) == NULL) {
        fail_with("%s: expected a last line that begins with \"%s\" and has \"%s\"; it said \"%s\"", what,
                  begin.text, words, process->errors.bytes);
    }
}
