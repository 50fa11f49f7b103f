/*
 * Wrong answers, on a pipe and on a terminal: what is said, how the run ends, and which files there are then.
 * On a terminal the question is asked again, and right answers still lead to the right files.
 */

#include "programs/programs.h"

#include "unity.h"

#include <string.h>

void setUp(void)
{
}

void tearDown(void)
{
    process_clean_up();
}

/* ---- one wrong answer, on a pipe and on a terminal ---- */

enum { ON_PIPE = 1, ON_TERMINAL = 2, ON_BOTH = 3 };

typedef struct wrong {
    const tested *program;
    bool corrected; /* with --fix all */
    int question;
    const char *answer;
    size_t length;       /* 0: up to the zero byte */
    const char *message; /* words of it */
    int where;
} wrong;

static const char *const *arguments_of(const wrong *wrong)
{
    static const char *const corrected[] = {"--fix", "all", NULL};
    return wrong->corrected ? corrected : NULL;
}

static size_t length_of(const wrong *wrong)
{
    return wrong->length > 0 ? wrong->length : strlen(wrong->answer);
}

/* How a failure calls the case. */
static string name_of(const wrong *wrong, const char *where)
{
    const string command = command_of(wrong->program, arguments_of(wrong));
    return string_of("%s, %s, question %d answered with \"%.60s\"", command.text, where, wrong->question + 1,
                     wrong->answer);
}

static bool is_control(char c)
{
    return ((unsigned char)c < ' ' && c != '\n') || c == 127;
}

static void check_no_control_characters(const text *said, const char *what)
{
    for (size_t i = 0; i < said->length; i++) {
        if (is_control(said->bytes[i])) {
            fail_with("%s: the control character %d is echoed", what, said->bytes[i]);
        }
    }
}

/* The files of A are written once the wish is fine, the others are not. */
static void check_files_before(const char *folder, const tested *program, int question, const char *what)
{
    const int pairs = question > QUESTION_WISH ? 1 : 0;
    const string listing = listing_of(program, pairs, 1);
    folder_check(folder, listing.text, what);
}

/* The right answer that comes after the wrong one must not be read any more. */
static void check_on_pipe(const wrong *wrong)
{
    const tested *program = wrong->program;
    const string what = name_of(wrong, "pipe"), folder = folder_new();
    const process_setup setup = {
        .program = program->path, .arguments = arguments_of(wrong), .folder = folder.text};
    process process;
    process_start(&process, &setup);
    say_answers(&process, program, 0, wrong->question);
    process_send(&process, wrong->answer, length_of(wrong));
    process_say(&process, "\n");
    say_answers(&process, program, wrong->question, QUESTIONS);
    process_finish(&process);
    process_check_status(&process, 2, what.text);
    check_message(&process, program, wrong->message, what.text);
    check_no_control_characters(&process.errors, what.text);
    check_files_before(folder.text, program, wrong->question, what.text);
}

static void start_on_terminal(process *process, const tested *program, const char *const arguments[],
                              const char *folder, int question)
{
    const process_setup setup = {
        .program = program->path, .arguments = arguments, .folder = folder, .wires = ALL_ON_TERMINAL};
    start_up_to(process, &setup, program, question);
}

static void check_right_end(process *process, const tested *program, const char *folder, const char *set,
                            const char *what)
{
    process_finish(process);
    process_check_status(process, 0, what);
    const string listing = listing_of(program, 2, 1);
    folder_check(folder, listing.text, what);
    check_golden(folder, 1, program, set, 1, FILES, what);
}

static void check_on_terminal(const wrong *wrong)
{
    const tested *program = wrong->program;
    const string what = name_of(wrong, "terminal"), folder = folder_new();
    const string message_begin = string_of("\n%s: ", program->name);
    process process;
    start_on_terminal(&process, program, arguments_of(wrong), folder.text, wrong->question);
    process_send(&process, wrong->answer, length_of(wrong));
    process_say(&process, "\n");
    process_expect(&process, message_begin.text);
    process_expect(&process, wrong->message);
    process_expect(&process, "\n");
    check_files_before(folder.text, program, wrong->question, what.text);
    answer_prompts(&process, program, wrong->question, QUESTIONS);
    check_right_end(&process, program, folder.text, wrong->corrected ? golden_corrected : golden_1987,
                    what.text);
}

static void check_wrong(const wrong *wrong)
{
    if ((wrong->where & ON_PIPE) != 0) {
        check_on_pipe(wrong);
    }
    if ((wrong->where & ON_TERMINAL) != 0) {
        check_on_terminal(wrong);
    }
}

/* ---- words that are no numbers ---- */

typedef struct bad_word {
    const char *word;
    size_t length;
    const char *shown; /* NULL: as it is */
    const char *fault;
    int where;
} bad_word;

/* A literal with its length, zero bytes included. */
#define BYTES(literal) (literal), sizeof(literal) - 1

#define NOT_A_NUMBER "is not a number; expected a decimal number"
#define NOT_SEPARATED "is not a number; expected numbers separated by blanks, with a point for decimals"
#define NOT_FINITE "is not a finite number"
#define TOO_LARGE "is too large a number"

static const bad_word bad_words[] = {
    {BYTES("abc"), NULL, NOT_A_NUMBER, ON_BOTH},
    {BYTES("0x10"), NULL, NOT_A_NUMBER, ON_BOTH},
    {BYTES("1.5.5"), NULL, NOT_A_NUMBER, ON_BOTH},
    {BYTES("1e"), NULL, NOT_A_NUMBER, ON_BOTH},
    {BYTES("1e+"), NULL, NOT_A_NUMBER, ON_BOTH},
    {BYTES("e5"), NULL, NOT_A_NUMBER, ON_BOTH},
    {BYTES("1d3"), NULL, NOT_A_NUMBER, ON_BOTH},
    {BYTES("-"), NULL, NOT_A_NUMBER, ON_BOTH},
    {BYTES("+"), NULL, NOT_A_NUMBER, ON_BOTH},
    {BYTES("--5"), NULL, NOT_A_NUMBER, ON_BOTH},
    {BYTES("."), NULL, NOT_A_NUMBER, ON_BOTH},
    {BYTES("-.e1"), NULL, NOT_A_NUMBER, ON_BOTH},
    {BYTES("200,200"), NULL, NOT_SEPARATED, ON_BOTH},
    {BYTES("200, 200, 0"), "200,", NOT_SEPARATED, ON_BOTH},
    {BYTES("1,5"), NULL, NOT_SEPARATED, ON_BOTH},
    {BYTES("1;5"), NULL, NOT_SEPARATED, ON_BOTH},
    {BYTES("200:"), NULL, NOT_SEPARATED, ON_BOTH},
    {BYTES("|200"), NULL, NOT_SEPARATED, ON_BOTH},
    {BYTES("200mm"), NULL, NOT_A_NUMBER, ON_BOTH},
    {BYTES("nan(1)"), NULL, NOT_A_NUMBER, ON_BOTH},
    {BYTES("information"), NULL, NOT_A_NUMBER, ON_BOTH},
    {BYTES("%s%n"), NULL, NOT_A_NUMBER, ON_BOTH},
    {BYTES("\"200\""), NULL, NOT_A_NUMBER, ON_BOTH},
    {BYTES("abc 200 0 0 1.57 0"), "abc", NOT_A_NUMBER, ON_BOTH},
    {BYTES("nan"), NULL, NOT_FINITE, ON_BOTH},
    {BYTES("NaN"), NULL, NOT_FINITE, ON_BOTH},
    {BYTES("-nan"), NULL, NOT_FINITE, ON_BOTH},
    {BYTES("inf"), NULL, NOT_FINITE, ON_BOTH},
    {BYTES("-inf"), NULL, NOT_FINITE, ON_BOTH},
    {BYTES("+INF"), NULL, NOT_FINITE, ON_BOTH},
    {BYTES("Infinity"), NULL, NOT_FINITE, ON_BOTH},
    {BYTES("-infinity"), NULL, NOT_FINITE, ON_BOTH},
    {BYTES("1e999"), NULL, TOO_LARGE, ON_BOTH},
    {BYTES("-1e999"), NULL, TOO_LARGE, ON_BOTH},
    /* what an arrow sends, and other control characters, which a terminal would act on */
    {BYTES("\033[A"), "?[A", NOT_A_NUMBER " such as 200 or -1.5e2; arrows and such keys edit nothing here", ON_BOTH},
    {BYTES("200\033OD"), "200?OD", NOT_A_NUMBER " such as 200 or -1.5e2; arrows", ON_BOTH},
    {BYTES("\033[31m200"), "?[31m200", NOT_A_NUMBER, ON_BOTH},
    {BYTES("\001\a200"), "??200", NOT_A_NUMBER, ON_BOTH},
    {BYTES("20\b0"), "20?0", NOT_A_NUMBER, ON_BOTH},
    {BYTES("200\177"), "200?", NOT_A_NUMBER, ON_PIPE},
    {BYTES("200\0"), "200?", NOT_A_NUMBER, ON_PIPE},
    {BYTES("\000200"), "?200", NOT_A_NUMBER, ON_PIPE},
    {BYTES("2\00000"), "2?00", NOT_A_NUMBER, ON_PIPE},
};

/* As the first word of every question. */
static void check_bad_word(const tested *program, const bad_word *bad)
{
    for (int question = 0; question < QUESTIONS; question++) {
        const char *value = program->value_names[program->starts[question]];
        const string message =
            string_of("%s: \"%s\" %s", value, bad->shown != NULL ? bad->shown : bad->word, bad->fault);
        const wrong wrong = {program, false, question, bad->word, bad->length, message.text, bad->where};
        check_wrong(&wrong);
    }
}

static void check_bad_words(const tested *program)
{
    for (size_t i = 0; i < sizeof bad_words / sizeof bad_words[0]; i++) {
        check_bad_word(program, &bad_words[i]);
    }
}

static void test_bad_words_to_intella(void)
{
    check_bad_words(&programs[0]);
}

static void test_bad_words_to_adpta(void)
{
    check_bad_words(&programs[1]);
}

/* The message names the value whose place the word has. */
static void test_bad_word_at_every_place(void)
{
    for (int i = 0; i < PROGRAMS; i++) {
        const tested *program = &programs[i];
        for (int question = 0; question < QUESTIONS; question++) {
            for (size_t at = program->starts[question]; at < program->starts[question + 1]; at++) {
                string answer = words_between(program, program->starts[question], at);
                answer.text[strcspn(answer.text, "\n")] = ' ';
                strcat(answer.text, "bad");
                const string message = string_of("%s: \"bad\" " NOT_A_NUMBER, program->value_names[at]);
                const wrong wrong = {program, false, question, answer.text, 0, message.text, ON_BOTH};
                check_wrong(&wrong);
            }
        }
    }
}

/* Beyond what a float holds, which is what the programs of 1987 kept numbers in; a double holds them. */
static void test_numbers_beyond_a_float(void)
{
    static const char *const words[] = {"1e39", "-1e39", "3.4028236e38"};
    for (int i = 0; i < PROGRAMS; i++) {
        for (size_t j = 0; j < sizeof words / sizeof words[0]; j++) {
            const string answer = string_of("%s 0 0 0 0 0", words[j]);
            const string message = string_of("x: \"%s\" " TOO_LARGE, words[j]);
            const wrong too_large = {&programs[i], false,  QUESTION_WISH, answer.text, 0,
                                     message.text, ON_BOTH};
            const wrong too_far = {&programs[i],           true,   QUESTION_WISH, answer.text, 0,
                                   "mm too far; expected", ON_BOTH};
            check_wrong(&too_large);
            check_wrong(&too_far);
        }
    }
}

static void test_the_largest_float_is_a_number(void)
{
    for (int i = 0; i < PROGRAMS; i++) {
        const wrong too_far = {&programs[i], false,  QUESTION_WISH, "3.4028235e38 0 0 0 0 0", 0,
                               "mm too far", ON_BOTH};
        check_wrong(&too_far);
    }
}

/* Nothing is to pass for a number because its end was cut, nor to fill the screen. */
static void test_very_long_words(void)
{
    static const size_t lengths[] = {600, 3000, 100000};
    static char word[100001];
    for (size_t i = 0; i < sizeof lengths / sizeof lengths[0]; i++) {
        for (int j = 0; j < PROGRAMS; j++) {
            /* a terminal takes no lines of more than 4095 characters */
            const int where = lengths[i] < 4000 ? ON_BOTH : ON_PIPE;
            memset(word, '7', lengths[i]);
            word[lengths[i]] = '\0';
            const wrong digits = {&programs[j], false, QUESTION_DELTA, word, 0, "...\" is too long", where};
            check_wrong(&digits);
            word[lengths[i] - 1] = 'x';
            const wrong letters = {&programs[j], false, QUESTION_WISH, word, 0, "...\" is too long", where};
            check_wrong(&letters);
        }
    }
}

static void test_a_message_about_a_long_word_is_short(void)
{
    char input[3000];
    memset(input, 'x', sizeof input - 1);
    input[sizeof input - 1] = '\0';
    for (int i = 0; i < PROGRAMS; i++) {
        const string folder = folder_new();
        process process;
        run_in(folder.text, &programs[i], NULL, input, &process);
        const string line = process_last_line(&process);
        TEST_ASSERT_TRUE_MESSAGE(strlen(line.text) < 160, line.text);
    }
}

/* On a terminal too a zero byte must not end a word early and make part of it pass for the whole. */
static void test_a_zero_byte_on_a_terminal(void)
{
    for (int i = 0; i < PROGRAMS; i++) {
        const string after = right_answer(&programs[i], QUESTION_WISH);
        char answer[100] = "20";
        memcpy(answer + 3, after.text, strlen(after.text) - 1);
        const wrong wrong = {&programs[i],           false,      QUESTION_WISH, answer,
                             2 + strlen(after.text), "x: \"20?", ON_TERMINAL};
        check_wrong(&wrong);
    }
}

/* Whether all of it is UTF-8, and no character of it a control character but the newline. */
static bool is_printable_utf8(const char *bytes)
{
    for (const unsigned char *c = (const unsigned char *)bytes; *c != '\0';) {
        const int more = *c < 0x80 ? 0 : *c < 0xc2 ? -1 : *c < 0xe0 ? 1 : *c < 0xf0 ? 2 : *c < 0xf5 ? 3 : -1;
        if (more < 0 || is_control((char)*c) || (c[0] == 0xc2 && c[1] < 0xa0)) {
            return false;
        }
        c++;
        for (int i = 0; i < more; i++, c++) {
            if ((*c & 0xc0) != 0x80) {
                return false;
            }
        }
    }
    return true;
}

/* A terminal acts on U+009B as on ESC and a bracket, and shows rubbish for a character that is cut in two. */
static void test_words_beyond_ascii_are_fit_to_print(void)
{
    static const char euros[] =
        "\xe2\x82\xac\xe2\x82\xac\xe2\x82\xac\xe2\x82\xac\xe2\x82\xac\xe2\x82\xac\xe2\x82\xac\xe2\x82\xac"
        "\xe2\x82\xac\xe2\x82\xac\xe2\x82\xac\xe2\x82\xac\xe2\x82\xac\xe2\x82\xac\xe2\x82\xac\xe2\x82\xac";
    static const char *const words[] = {
        "zw\xc3\xb6lf",
        "\xc2\x9b[31m200",
        "\xff\xfe",
        euros,
    };
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        const string folder = folder_new();
        process process;
        run_in(folder.text, &programs[0], NULL, words[i], &process);
        process_check_status(&process, 2, words[i]);
        check_message(&process, &programs[0], "x: ", words[i]);
        TEST_ASSERT_TRUE_MESSAGE(is_printable_utf8(process.errors.bytes), process.errors.bytes);
    }
}

/* ---- wishes that cannot be ---- */

#define REACH_ADEPT "expected between 50 and 800 mm"
#define REACH_INTELLEDEX "expected between 94 and 652.8 mm"
#define SINGULAR "the shoulder at (0, 0, 359.7) lies on the tool's axis"

static const wrong wrong_wishes[] = {
    {&programs[0], false, QUESTION_WISH, "700 0 459.7 0 0 0", 0,
     "would be 700 mm from the shoulder at (0, 0, 359.7), 47.2 mm too far; " REACH_INTELLEDEX, ON_BOTH},
    {&programs[0], true, QUESTION_WISH, "0 -1000 459.7 0 0 0", 0,
     "would be 1000 mm from the shoulder at (0, 0, 359.7), 347.2 mm too far; " REACH_INTELLEDEX, ON_BOTH},
    {&programs[0], false, QUESTION_WISH, "50 0 459.7 0 0 0", 0,
     "would be 50 mm from the shoulder at (0, 0, 359.7), 44 mm too near; " REACH_INTELLEDEX, ON_BOTH},
    {&programs[0], true, QUESTION_WISH, "0 93 459.7 0 0 0", 0,
     "would be 93 mm from the shoulder at (0, 0, 359.7), 1 mm too near; " REACH_INTELLEDEX, ON_BOTH},
    {&programs[0], true, QUESTION_WISH, "1e200 0 0 0 0 0", 0, "would be 1e+200 mm from", ON_BOTH},
    {&programs[0], false, QUESTION_WISH, "0 0 700 0 0 0", 0, SINGULAR, ON_BOTH},
    {&programs[0], true, QUESTION_WISH, "0 0 700 0 0 0", 0, SINGULAR, ON_BOTH},
    {&programs[0], false, QUESTION_WISH, "300 0 359.7 0 1.5707963 0", 0, SINGULAR, ON_BOTH},
    {&programs[0], true, QUESTION_WISH, "300 0 359.7 0 1.5707963 0", 0, SINGULAR, ON_BOTH},
    {&programs[0], false, QUESTION_WISH, "0 -300 359.7 1.5707963 0 0", 0, SINGULAR, ON_BOTH},
    {&programs[1], false, QUESTION_WISH, "801 0 0 0", 0,
     "would be 801 mm from the axis of joint 1, 1 mm too far; " REACH_ADEPT, ON_BOTH},
    {&programs[1], true, QUESTION_WISH, "0 -900 0 0", 0,
     "would be 900 mm from the axis of joint 1, 100 mm too far; " REACH_ADEPT, ON_BOTH},
    {&programs[1], true, QUESTION_WISH, "0 1e200 0 0", 0, "would be 1e+200 mm from", ON_BOTH},
    {&programs[1], false, QUESTION_WISH, "0 49 0 0", 0,
     "would be 49 mm from the axis of joint 1, 1 mm too near; " REACH_ADEPT, ON_BOTH},
    {&programs[1], true, QUESTION_WISH, "0 0 100 0", 0,
     "would be 0 mm from the axis of joint 1, 50 mm too near; " REACH_ADEPT, ON_BOTH},
};

static void test_wishes_that_cannot_be(void)
{
    for (size_t i = 0; i < sizeof wrong_wishes / sizeof wrong_wishes[0]; i++) {
        check_wrong(&wrong_wishes[i]);
    }
}

/* Rounding to float refuses what lies just within the reach: neither too far nor too near. */
static void test_the_very_edge_of_the_reach(void)
{
    static const wrong wishes[] = {
        {&programs[0], false, QUESTION_WISH, "-309.583104 362.490757 871.979204 1.25998 -0.10254 -1.31624", 0,
         "would be 652.799981 mm from the shoulder at (0, 0, 359.7), at the very edge, where rounding "
         "decides; " REACH_INTELLEDEX,
         ON_BOTH},
        {&programs[0], false, QUESTION_WISH, "101.422275 -52.166853 464.860650 2.41115 2.75943 0.625351", 0,
         "would be 94.0000049 mm from the shoulder at (0, 0, 359.7), at the very edge, where rounding "
         "decides; " REACH_INTELLEDEX,
         ON_BOTH},
    };
    for (size_t i = 0; i < sizeof wishes / sizeof wishes[0]; i++) {
        check_wrong(&wishes[i]);
    }
}

/* A wish on the tool's axis and out of reach: no turn of the tool would bring it into reach. */
static void test_out_of_reach_comes_before_singular(void)
{
    const wrong wrong = {
        &programs[0], false, QUESTION_WISH, "0 0 2000 0 0 0", 0, "mm too far; " REACH_INTELLEDEX, ON_PIPE};
    check_wrong(&wrong);
}

/* Numbers whose squares overflow, a float or a double: they must not come out as nan, infinity or 0. */
static void test_numbers_too_large_to_compute_with(void)
{
    static const wrong wishes[] = {
        {&programs[1], false, QUESTION_WISH, "200 200 1e38 0", 0, "desired position: too large", ON_BOTH},
        {&programs[1], true, QUESTION_WISH, "200 200 -1e200 0", 0, "desired position: too large", ON_BOTH},
    };
    for (size_t i = 0; i < sizeof wishes / sizeof wishes[0]; i++) {
        check_wrong(&wishes[i]);
    }
    for (int i = 0; i < PROGRAMS; i++) {
        static const char *const corrected[] = {"--fix", "all", NULL};
        const string wish = right_answer(&programs[i], QUESTION_WISH), folder = folder_new();
        const string input = string_of("%s1e300 1e300 1e300 1 1 1 1e290", wish.text);
        process process;
        run_in(folder.text, &programs[i], corrected, input.text, &process);
        process_check_status(&process, 2, input.text);
        check_message(&process, &programs[i], "delta and tolerances: too large", input.text);
        check_files_before(folder.text, &programs[i], QUESTION_DELTA, input.text);
    }
}

/* ---- tolerances and delta ---- */

static void check_tolerance(const tested *program, size_t at, const char *word, const char *shown)
{
    string answer = {""};
    for (size_t i = 0; i < 6; i++) {
        strcat(answer.text, i == at ? word : ".5");
        strcat(answer.text, " ");
    }
    const string message = string_of("%s: %s is no tolerance; expected a number greater than 0",
                                     program->value_names[program->starts[QUESTION_TOLERANCES] + at], shown);
    const wrong wrong = {program, false, QUESTION_TOLERANCES, answer.text, 0, message.text, ON_BOTH};
    check_wrong(&wrong);
}

static void test_tolerances_are_greater_than_0(void)
{
    static const char *const words[][2] = {
        {"0", "0"}, {"-.5", "-0.5"}, {"-0.0", "-0"}, {"1e-400", "0"}, {"1e-46", "0"}};
    for (int i = 0; i < PROGRAMS; i++) {
        for (size_t at = 0; at < 6; at++) {
            for (size_t j = 0; j < sizeof words / sizeof words[0]; j++) {
                check_tolerance(&programs[i], at, words[j][0], words[j][1]);
            }
        }
    }
}

static void test_delta_is_between_0_and_the_tolerances(void)
{
    static const char *const words[][2] = {
        {"0", "0"},
        {"-1", "-1"},
        {"1e-400", "0"},
        {".5", "0.5"},
        {".500001", "0.500001"},
        {"0.5000001", "0.5000001"},
        {"17", "17"},
        {"1e38", "1e+38"},
    };
    for (int i = 0; i < PROGRAMS; i++) {
        for (size_t j = 0; j < sizeof words / sizeof words[0]; j++) {
            const string message =
                string_of("delta: %s does not fit; expected a number greater than 0 and less "
                          "than 0.5, the smallest of dx, dy and dz",
                          words[j][1]);
            const wrong wrong = {&programs[i], false, QUESTION_DELTA, words[j][0], 0, message.text, ON_BOTH};
            check_wrong(&wrong);
        }
    }
}

/* The smallest is any of the three lengths, and not one of the angles. */
static void test_delta_is_held_against_the_smallest_length(void)
{
    static const struct {
        const char *answers, *words; /* NULL: it is fine */
    } rows[] = {
        {".2 .5 .5 .1 .1 .1 .3", "less than 0.2"},
        {".5 .2 .5 .1 .1 .1 .3", "less than 0.2"},
        {".5 .5 .2 .1 .1 .1 .3", "less than 0.2"},
        {".5 .5 .2 .1 .1 .1 .2", "less than 0.2"},
        {".5 .5 .5 .1 .1 .1 .3", NULL},
        {".5 .5 .5 .1 .1 .1 .499", NULL},
    };
    for (int i = 0; i < PROGRAMS; i++) {
        for (size_t j = 0; j < sizeof rows / sizeof rows[0]; j++) {
            const string wish = right_answer(&programs[i], QUESTION_WISH);
            const string input = string_of("%s%s\n", wish.text, rows[j].answers), folder = folder_new();
            process process;
            run_in(folder.text, &programs[i], NULL, input.text, &process);
            process_check_status(&process, rows[j].words == NULL ? 0 : 2, input.text);
            if (rows[j].words != NULL) {
                check_message(&process, &programs[i], rows[j].words, input.text);
            }
        }
    }
}

/* ---- too few numbers ---- */

/* "dz: missing; expected 6 numbers (dx dy dz dwx dwy dwz), got 2" */
static string message_of_missing(const tested *program, size_t at)
{
    int question = QUESTION_WISH;
    while (at >= program->starts[question + 1]) {
        question++;
    }
    const size_t first = program->starts[question], count = program->starts[question + 1] - first;
    string message = string_of("%s: missing; expected %zu number%s (", program->value_names[at], count,
                               count == 1 ? "" : "s");
    for (size_t i = first; i < first + count; i++) {
        strcat(message.text, i > first ? " " : "");
        strcat(message.text, program->value_names[i]);
    }
    const string rest = string_of("%s), got %zu", message.text, at - first);
    return rest;
}

/* Every number in turn is the one that does not come any more. */
static void test_missing_numbers_on_a_pipe(void)
{
    for (int i = 0; i < PROGRAMS; i++) {
        const tested *program = &programs[i];
        for (size_t at = 0; at < program->starts[QUESTIONS]; at++) {
            const string input = words_between(program, 0, at), message = message_of_missing(program, at);
            const string folder = folder_new();
            process process;
            run_in(folder.text, program, NULL, input.text, &process);
            process_check_status(&process, 2, message.text);
            check_message(&process, program, message.text, message.text);
            check_files_before(folder.text, program, at < program->starts[1] ? QUESTION_WISH : QUESTION_DELTA,
                               message.text);
        }
    }
}

/* The end of input, Ctrl-D, where number `at` is due; right answers come before. */
static void check_end_on_terminal(const tested *program, int question, size_t at)
{
    const string message = message_of_missing(program, at), folder = folder_new();
    const string words = words_between(program, program->starts[question], at);
    process process;
    start_on_terminal(&process, program, NULL, folder.text, question);
    process_say(&process, words.text);
    process_say(&process, "\004");
    process_finish(&process);
    process_check_status(&process, 2, message.text);
    check_message(&process, program, message.text, message.text);
    check_files_before(folder.text, program, question, message.text);
}

static void test_end_of_input_on_a_terminal(void)
{
    for (int i = 0; i < PROGRAMS; i++) {
        for (int question = 0; question < QUESTIONS; question++) {
            for (size_t at = programs[i].starts[question]; at < programs[i].starts[question + 1]; at++) {
                check_end_on_terminal(&programs[i], question, at);
            }
        }
    }
}

/* Ctrl-D in the middle of a line hands over what is typed; once more ends the input. */
static void test_end_of_input_within_a_line(void)
{
    for (int i = 0; i < PROGRAMS; i++) {
        const string folder = folder_new();
        process process;
        start_on_terminal(&process, &programs[i], NULL, folder.text, QUESTION_WISH);
        process_say(&process, "200 200\004\004\004");
        process_finish(&process);
        process_check_status(&process, 2, programs[i].name);
        check_message(&process, &programs[i], "z: missing; expected", programs[i].name);
    }
}

/* What was typed is no part of the message's line. */
static void test_the_message_of_an_end_within_a_line(void)
{
    static const char session[] = "enter desired position: 200 200\n"
                                  "adpta: z: missing; expected 4 numbers (x y z theta), got 2\n";
    const string folder = folder_new();
    process process;
    start_on_terminal(&process, &programs[1], NULL, folder.text, QUESTION_WISH);
    process_say(&process, "200 200\004\004");
    process_finish(&process);
    process_check_status(&process, 2, "an end within a line");
    text_check(session, strlen(session), &process.errors, "an end within a line");
}

/* Start on a terminal, answer right before the question, there type a line of words, fewer than asked for. */
static void type_too_few(process *process, const tested *program, int question, size_t at, const char *words,
                         const char *folder)
{
    const size_t end = program->starts[question + 1];
    string message = string_of("%s: %s: missing; go on with", program->name, program->value_names[at]);
    for (size_t i = at; i < end; i++) {
        strcat(message.text, " ");
        strcat(message.text, program->value_names[i]);
    }
    strcat(message.text, ", or type all ");
    start_on_terminal(process, program, NULL, folder, question);
    process_say(process, words);
    process_expect(process, message.text);
}

static void check_going_on(const tested *program, int question, size_t at)
{
    const string what = string_of("%s, going on with %s", program->name, program->value_names[at]);
    const string words = words_between(program, program->starts[question], at), folder = folder_new();
    const string rest = words_between(program, at, program->starts[question + 1]);
    process process;
    type_too_few(&process, program, question, at, words.text, folder.text);
    process_say(&process, rest.text);
    answer_prompts(&process, program, question + 1, QUESTIONS);
    check_right_end(&process, program, folder.text, golden_1987, what.text);
}

/* Whoever types all numbers again means those, and not the ones before. */
static void check_typing_again(const tested *program, int question, size_t at)
{
    const string what =
        string_of("%s, typing all again for want of %s", program->name, program->value_names[at]);
    const string again = right_answer(program, question), folder = folder_new();
    string words = {""};
    for (size_t i = program->starts[question]; i < at; i++) {
        strcat(words.text, " 77");
    }
    strcat(words.text, "\n");
    process process;
    type_too_few(&process, program, question, at, words.text, folder.text);
    process_say(&process, again.text);
    answer_prompts(&process, program, question + 1, QUESTIONS);
    check_right_end(&process, program, folder.text, golden_1987, what.text);
}

static void test_too_few_numbers_on_a_terminals_line(void)
{
    for (int i = 0; i < PROGRAMS; i++) {
        for (int question = 0; question < QUESTION_DELTA; question++) {
            for (size_t at = programs[i].starts[question] + 1; at < programs[i].starts[question + 1]; at++) {
                check_going_on(&programs[i], question, at);
                check_typing_again(&programs[i], question, at);
            }
        }
    }
}

/* ---- right answers in other shapes ---- */

/* All right answers, each number followed by the separator. */
static string separated(const tested *program, const char *separator)
{
    string all = {""};
    for (size_t i = 0; i < program->starts[QUESTIONS]; i++) {
        strcat(all.text, program->words[i]);
        strcat(all.text, separator);
    }
    return all;
}

static void check_shape_on_pipe(const tested *program, const char *input)
{
    const string what = string_of("%s, pipe, \"%s\"", program->name, input), folder = folder_new();
    const process_setup setup = {.program = program->path, .folder = folder.text};
    process process;
    process_start(&process, &setup);
    process_say(&process, input);
    check_right_end(&process, program, folder.text, golden_1987, what.text);
}

static void check_shape_on_terminal(const tested *program, const char *input)
{
    const string what = string_of("%s, terminal, \"%s\"", program->name, input), folder = folder_new();
    process process;
    start_on_terminal(&process, program, NULL, folder.text, QUESTION_WISH);
    process_say(&process, input);
    check_right_end(&process, program, folder.text, golden_1987, what.text);
}

static void test_numbers_over_many_lines_or_on_one(void)
{
    static const char *const separators[] = {"\n", " ", "\t", "\n\n", "\r\n", " \v\f "};
    for (int i = 0; i < PROGRAMS; i++) {
        for (size_t j = 0; j < sizeof separators / sizeof separators[0]; j++) {
            const string input = separated(&programs[i], separators[j]);
            const string line = string_of("%s\n", input.text);
            check_shape_on_pipe(&programs[i], input.text);
            check_shape_on_terminal(&programs[i], line.text);
        }
    }
}

/*
 * An answer and half the next on one line; an empty line first; the end of the file right after the last
 * digit. Not on a terminal where the second line has as many numbers as the question asks for: it is then
 * typed again.
 */
static void test_answers_cut_anywhere(void)
{
    for (int i = 0; i < PROGRAMS; i++) {
        const size_t tolerances = programs[i].starts[QUESTION_TOLERANCES];
        const size_t last = programs[i].starts[QUESTIONS];
        for (size_t cut = 1; cut < last; cut++) {
            const string first = words_between(&programs[i], 0, cut);
            const string second = words_between(&programs[i], cut, last);
            const string lines = string_of("\n%s%s", first.text, second.text);
            const string unended = string_of("%.*s", (int)strlen(lines.text) - 1, lines.text);
            check_shape_on_pipe(&programs[i], unended.text);
            if (cut != tolerances + 1) {
                check_shape_on_terminal(&programs[i], lines.text);
            }
        }
    }
}

static void test_numbers_in_other_forms(void)
{
    static const char *const forms[] = {
        "200", "+200", "200.", "200.0", "0200", "2e2", "2E+02", ".2e3", "20000e-2", "2.00e0000002",
        "200.0000000000000000000000000000000000000000000000000001",
    };
    for (int i = 0; i < PROGRAMS; i++) {
        for (size_t j = 0; j < sizeof forms / sizeof forms[0]; j++) {
            const string rest = words_between(&programs[i], 1, programs[i].starts[QUESTIONS]);
            const string input = string_of("%s %s", forms[j], rest.text);
            check_shape_on_pipe(&programs[i], input.text);
            check_shape_on_terminal(&programs[i], input.text);
        }
    }
}

/* As documents have them: a minus sign, a dash in its place, and the mark that some editors begin a file with. */
static void test_numbers_out_of_a_document(void)
{
    static const char *const minus[] = {"\xe2\x88\x92", "\xe2\x80\x93"};
    for (int i = 0; i < PROGRAMS; i++) {
        const string rest = words_between(&programs[i], 1, programs[i].starts[QUESTIONS]);
        for (size_t j = 0; j < sizeof minus / sizeof minus[0]; j++) {
            const string input = string_of("20000e%s2 %s", minus[j], rest.text);
            const string below_0 = string_of("%s.5 1 1 1 1 1", minus[j]);
            const wrong wrong = {&programs[i], false, QUESTION_TOLERANCES, below_0.text, 0,
                                 "dx: -0.5 is no tolerance", ON_BOTH};
            check_shape_on_pipe(&programs[i], input.text);
            check_wrong(&wrong);
        }
        const string all = right_answers(&programs[i]);
        const string marked = string_of("\xef\xbb\xbf%s", all.text), apart = string_of("\xef\xbb\xbf\n%s", all.text);
        check_shape_on_pipe(&programs[i], marked.text);
        check_shape_on_pipe(&programs[i], apart.text);
        check_shape_on_terminal(&programs[i], marked.text);
        const wrong later = {&programs[i], false, QUESTION_DELTA, "\xef\xbb\xbf" "1", 0, "delta: \"???1\"", ON_BOTH};
        check_wrong(&later);
    }
}

/* ---- more than was asked for ---- */

/* The run is a right one; what scanf would have left is named. */
static void check_left_over(const tested *program, const char *more, const char *named)
{
    const string all = right_answers(program), input = string_of("%s%s", all.text, more), folder = folder_new();
    const string warning = string_of("warning: more than the %zu numbers asked for; not used: %s",
                                     program->starts[QUESTIONS], named);
    const process_setup setup = {.program = program->path, .folder = folder.text};
    process process;
    process_start(&process, &setup);
    process_say(&process, input.text);
    check_right_end(&process, program, folder.text, golden_1987, warning.text);
    check_message(&process, program, warning.text, warning.text);
    const string line = process_last_line(&process);
    TEST_ASSERT_EQUAL_STRING(named, line.text + strlen(line.text) - strlen(named));
}

static void test_left_over_input_is_named(void)
{
    for (int i = 0; i < PROGRAMS; i++) {
        check_left_over(&programs[i], "7", "\"7\"");
        check_left_over(&programs[i], "\n .1 \033[A\n", "\".1\" \"?[A\"");
        check_left_over(&programs[i], "1 2 3 4 5 6", "\"1\" \"2\" \"3\" \"4\" \"5\" \"6\"");
        check_left_over(&programs[i], "1 2 3 4 5 6 7", "\"1\" \"2\" \"3\" \"4\" \"5\" \"6\" ...");
    }
}

/* What goes on and on is not looked at to its end. */
static void test_no_end_of_left_over_input(void)
{
    static char blanks[20000];
    const string folder = folder_new(), all = right_answers(&programs[0]);
    const process_setup setup = {.program = programs[0].path, .folder = folder.text};
    process process;
    memset(blanks, '\n', sizeof blanks);
    process_start(&process, &setup);
    process_say(&process, all.text);
    process_send(&process, blanks, sizeof blanks);
    process_say(&process, "7");
    check_right_end(&process, &programs[0], folder.text, golden_1987, "blanks without end");
    TEST_ASSERT_NULL_MESSAGE(strstr(process.errors.bytes, "warning"), process.errors.bytes);
}

/* One that is too many moves all that follow, as it did in 1987. */
static void test_a_number_too_many_through_a_pipe(void)
{
    const string folder = folder_new(), name = file_of(folder.text, &programs[0], FILE_TOLERANCES);
    process process;
    text tolerances;
    run_in(folder.text, &programs[0], NULL, "200 200 0 0 1.57 0 7\n.5 .5 .5 .1 .1 .1\n.1\n", &process);
    process_check_status(&process, 0, "a 7th number");
    check_message(&process, &programs[0], "warning: more than the 13 numbers asked for; not used: \".1\"",
                  "a 7th number");
    file_read(name.text, &tolerances);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(tolerances.bytes, "7.0"), tolerances.bytes);
}

/* Whoever keeps the other end of a pipe open waits for the program, not the program for more. */
static void test_an_open_pipe_is_not_waited_for(void)
{
    const string all = right_answers(&programs[0]), folder = folder_new();
    const string file = file_of(folder.text, &programs[0], FILE_MACHINING);
    const process_setup setup = {.program = programs[0].path, .folder = folder.text};
    process process;
    process_start(&process, &setup);
    process_say(&process, all.text);
    process_say(&process, "7\n");
    process_expect(&process, "not used: \"7\"\n"); /* the input has not ended yet */
    check_right_end(&process, &programs[0], folder.text, golden_1987, file.text);
}

/* Two programs, one file: the second finds its own numbers, though the first has looked at them. */
static void test_the_rest_of_a_file_stays_unread(void)
{
    const string folder = folder_new(), path = string_of("%s/both", folder.text);
    const string here = folder_below(folder.text, "files");
    const string one = right_answers(&programs[0]), other = right_answers(&programs[1]);
    const string both = string_of("%s%s", one.text, other.text);
    const string line = string_of("'%s' && '%s'", programs[0].path, programs[1].path);
    const char *const arguments[] = {"-c", line.text, NULL};
    const process_setup setup = {
        .program = "/bin/sh", .arguments = arguments, .folder = here.text, .input_path = path.text};
    process process;
    file_write(path.text, both.text);
    process_start(&process, &setup);
    process_finish(&process);
    process_check_status(&process, 0, "two programs and one file");
    for (int i = 0; i < PROGRAMS; i++) {
        check_golden(here.text, 1, &programs[i], golden_1987, 1, FILES, programs[i].name);
    }
}

/* ---- input that cannot be read, which is no wrong answer ---- */

static void check_unreadable(const tested *program, const process_setup *kind, int status, const char *words)
{
    const string folder = folder_new();
    process_setup setup = *kind;
    setup.program = program->path;
    setup.folder = folder.text;
    process process;
    process_start(&process, &setup);
    process_finish(&process);
    process_check_status(&process, status, words);
    check_message(&process, program, words, words);
    folder_check(folder.text, "", words);
}

static void test_input_that_cannot_be_read(void)
{
    const process_setup folder = {.input_path = "."}, nothing = {.input_path = "/dev/null"};
    const process_setup closed = {.wires = {WIRE_CLOSED, WIRE_PIPE, WIRE_PIPE}};
    for (int i = 0; i < PROGRAMS; i++) {
        check_unreadable(&programs[i], &folder, 1, "cannot read the input: Is a directory");
        check_unreadable(&programs[i], &closed, 1, "cannot read the input: Bad file descriptor");
        check_unreadable(&programs[i], &nothing, 2, "x: missing; expected");
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_bad_words_to_intella);
    RUN_TEST(test_bad_words_to_adpta);
    RUN_TEST(test_bad_word_at_every_place);
    RUN_TEST(test_numbers_beyond_a_float);
    RUN_TEST(test_the_largest_float_is_a_number);
    RUN_TEST(test_very_long_words);
    RUN_TEST(test_a_message_about_a_long_word_is_short);
    RUN_TEST(test_a_zero_byte_on_a_terminal);
    RUN_TEST(test_words_beyond_ascii_are_fit_to_print);
    RUN_TEST(test_wishes_that_cannot_be);
    RUN_TEST(test_the_very_edge_of_the_reach);
    RUN_TEST(test_out_of_reach_comes_before_singular);
    RUN_TEST(test_numbers_too_large_to_compute_with);
    RUN_TEST(test_tolerances_are_greater_than_0);
    RUN_TEST(test_delta_is_between_0_and_the_tolerances);
    RUN_TEST(test_delta_is_held_against_the_smallest_length);
    RUN_TEST(test_missing_numbers_on_a_pipe);
    RUN_TEST(test_end_of_input_on_a_terminal);
    RUN_TEST(test_end_of_input_within_a_line);
    RUN_TEST(test_the_message_of_an_end_within_a_line);
    RUN_TEST(test_too_few_numbers_on_a_terminals_line);
    RUN_TEST(test_numbers_over_many_lines_or_on_one);
    RUN_TEST(test_answers_cut_anywhere);
    RUN_TEST(test_numbers_in_other_forms);
    RUN_TEST(test_numbers_out_of_a_document);
    RUN_TEST(test_left_over_input_is_named);
    RUN_TEST(test_no_end_of_left_over_input);
    RUN_TEST(test_a_number_too_many_through_a_pipe);
    RUN_TEST(test_an_open_pipe_is_not_waited_for);
    RUN_TEST(test_the_rest_of_a_file_stays_unread);
    RUN_TEST(test_input_that_cannot_be_read);
    return UNITY_END();
}
