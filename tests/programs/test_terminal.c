/* Whole sessions on a terminal: the dialogue of 1987 as it stood on the screen, and the note that ends it. */

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

#define NOTE_1987 "These are the numbers of 1987, errata included; for an arm to be built: %s --fix all\n"
#define NOTE_SOME "Some errata of 1987 are still included; for an arm to be built: %s --fix all\n"

/* A session in which all is right, with --fix FIX where there is one. */
static void run_session(const tested *program, const char *fix, process *process)
{
    const char *const arguments[] = {fix != NULL ? "--fix" : NULL, fix, NULL};
    const string folder = folder_new(), what = command_of(program, arguments);
    const process_setup setup = {
        .program = program->path, .arguments = arguments, .folder = folder.text, .wires = ALL_ON_TERMINAL};
    process_start(process, &setup);
    answer_prompts(process, program, 0, QUESTIONS);
    process_finish(process);
    process_check_status(process, 0, what.text);
}

/* The golden dialogue, after each prompt what was typed there, as the terminal echoes it. */
static string dialogue_with_echo(const tested *program, const char *set)
{
    const string file = golden_of(set, program, 1, "dialogue");
    string session = {""};
    text dialogue;
    file_read(file.text, &dialogue);
    const char *rest = dialogue.bytes;
    for (int i = 0; i < QUESTIONS; i++) {
        const string answer = right_answer(program, i);
        const char *prompt = strstr(rest, prompts[i]);
        TEST_ASSERT_NOT_NULL_MESSAGE(prompt, prompts[i]);
        const char *end = prompt + strlen(prompts[i]);
        strncat(session.text, rest, (size_t)(end - rest));
        strcat(session.text, answer.text);
        rest = end;
    }
    TEST_ASSERT_EQUAL_STRING_MESSAGE("", rest, "the dialogue ends with a prompt");
    return session;
}

static void check_session(const tested *program, const char *fix, const char *set, const char *before, const char *note)
{
    const string dialogue = dialogue_with_echo(program, set);
    const string expected = string_of("%s%s%s", before, dialogue.text, note);
    process process;
    run_session(program, fix, &process);
    text_check(expected.text, strlen(expected.text), &process.errors, program->name);
}

static void test_sessions_of_1987(void)
{
    for (int i = 0; i < PROGRAMS; i++) {
        const string note = string_of(NOTE_1987, programs[i].name);
        check_session(&programs[i], NULL, golden_1987, "", note.text);
    }
}

static void test_corrected_sessions(void)
{
    for (int i = 0; i < PROGRAMS; i++) {
        check_session(&programs[i], "all", golden_corrected, "", "");
    }
}

/* One corrected and all others kept; and one kept, all others corrected, some of which change nothing here. */
static void test_partly_corrected_sessions(void)
{
    static const char *const without_effect[PROGRAMS] = {
        "--fix: in intella this changes nothing: adept-shift, skew-residue, copied-counts, signed-mach, "
        "prismatic-alpha, half-turns, gppp-clearing\n",
        "--fix: in adpta this changes nothing: prismatic-alpha, gppp-clearing\n",
    };
    string all_but_last = {""};
    for (int i = 0; i < ERRATA - 1; i++) {
        strcat(all_but_last.text, i > 0 ? "," : "");
        strcat(all_but_last.text, errata[i]);
    }
    for (int i = 0; i < PROGRAMS; i++) {
        const string note = string_of(NOTE_SOME, programs[i].name);
        /* both leave the dialogue as it is in one of the golden sets: labels and the distance bound are in files */
        check_session(&programs[i], "labels", golden_1987, "", note.text);
        check_session(&programs[i], all_but_last.text, golden_corrected, without_effect[i], note.text);
    }
}

/* How the screen looks when every answer is wrong once: each message on a line of its own, no empty lines. */
static void test_wrong_answers_on_the_screen(void)
{
    static const char session[] =
        "enter desired position: 200 200 zero 0\n"
        "adpta: z: \"zero\" is not a number; expected a decimal number such as 200 or -1.5e2\n"
        "enter desired position: 200 200\n"
        "adpta: z: missing; go on with z theta, or type all 4 numbers again\n"
        "0 0\n"
        "itheta[0] = -0.262798\nitheta[1] = 2.429293\nitheta[2] = -2.166495\nitheta[3] = -203.199997\n"
        "check[0] = 200.000717\ncheck[1] = 200.000702\ncheck[2] = 0.000000\ncheck[3] = -0.000000\n"
        "enter desired position and orientation tolerances: .5 .5 0 .1 .1 .1\n"
        "adpta: dz: 0 is no tolerance; expected a number greater than 0\n"
        "enter desired position and orientation tolerances: .5 .5 .5 .1 .1 .1\n"
        "enter desired delta: 2\n"
        "adpta: delta: 2 does not fit; expected a number greater than 0 and less than 0.5, the smallest of "
        "dx, dy and dz\n"
        "enter desired delta: .1\n"
        "These are the numbers of 1987, errata included; for an arm to be built: adpta --fix all\n";
    static const char *const typed[][2] = {
        {"position: ", "200 200 zero 0\n"},
        {"position: ", "200 200\n"},
        {"again\n", "0 0\n"},
        {"tolerances: ", ".5 .5 0 .1 .1 .1\n"},
        {"tolerances: ", ".5 .5 .5 .1 .1 .1\n"},
        {"delta: ", "2\n"},
        {"enter desired delta: ", ".1\n"},
    };
    const string folder = folder_new();
    const process_setup setup = {
        .program = programs[1].path, .folder = folder.text, .wires = ALL_ON_TERMINAL};
    process process;
    process_start(&process, &setup);
    for (size_t i = 0; i < sizeof typed / sizeof typed[0]; i++) {
        process_expect(&process, typed[i][0]);
        process_say(&process, typed[i][1]);
    }
    process_finish(&process);
    process_check_status(&process, 0, "a session with wrong answers");
    text_check(session, strlen(session), &process.errors, "a session with wrong answers");
}

/* As in 1987 a number too many answers the next question; it is said before that is asked. */
static void test_more_on_a_line_than_asked_for(void)
{
    static const char session[] =
        "enter desired position: 200 200 0 0 7\n"
        "itheta[0] = -0.262798\nitheta[1] = 2.429293\nitheta[2] = -2.166495\nitheta[3] = -203.199997\n"
        "check[0] = 200.000717\ncheck[1] = 200.000702\ncheck[2] = 0.000000\ncheck[3] = -0.000000\n"
        "adpta: more on the line than was asked for: \"7\" is taken as dx\n"
        "enter desired position and orientation tolerances: \n"
        "adpta: dy: missing; go on with dy dz dwx dwy dwz, or type all 6 numbers again\n"
        ".5 .5 .5 .1 .1 .1 .1 8 9\n"
        "adpta: more on the line than was asked for: \".1\" is taken as delta, and so on\n"
        "enter desired delta: \n"
        "adpta: warning: more than the 11 numbers asked for; not used: \".1\" \"8\" \"9\"\n"
        "These are the numbers of 1987, errata included; for an arm to be built: adpta --fix all\n";
    const string folder = folder_new();
    const process_setup setup = {
        .program = programs[1].path, .folder = folder.text, .wires = ALL_ON_TERMINAL};
    process process;
    process_start(&process, &setup);
    process_expect(&process, "position: ");
    process_say(&process, "200 200 0 0 7\n");
    process_expect(&process, "again\n");
    process_say(&process, ".5 .5 .5 .1 .1 .1 .1 8 9\n");
    process_finish(&process);
    process_check_status(&process, 0, "more on a line than asked for");
    text_check(session, strlen(session), &process.errors, "more on a line than asked for");
}

/* The terminal shows at once what is pasted, and the prompts that come after it stand on lines of their own. */
static void test_a_pasted_session(void)
{
    for (int i = 0; i < PROGRAMS; i++) {
        const string folder = folder_new(), wish = right_answer(&programs[i], QUESTION_WISH);
        const string tolerances = right_answer(&programs[i], QUESTION_TOLERANCES);
        const string delta = right_answer(&programs[i], QUESTION_DELTA);
        const string pasted = string_of("%s%s%s", wish.text, tolerances.text, delta.text);
        const string end = string_of("\n%s\n%s\n" NOTE_1987, prompts[QUESTION_TOLERANCES], prompts[QUESTION_DELTA],
                                     programs[i].name);
        const process_setup setup = {
            .program = programs[i].path, .folder = folder.text, .wires = ALL_ON_TERMINAL};
        process process;
        process_start(&process, &setup);
        process_expect(&process, prompts[QUESTION_WISH]);
        process_say(&process, pasted.text);
        process_finish(&process);
        process_check_status(&process, 0, programs[i].name);
        const size_t length = strlen(end.text);
        TEST_ASSERT_TRUE_MESSAGE(process.errors.length > length, process.errors.bytes);
        TEST_ASSERT_EQUAL_STRING(end.text, process.errors.bytes + process.errors.length - length);
    }
}

/* With nothing to note, the line of the last prompt ends all the same: a shell's prompt comes next. */
static void test_the_last_line_on_a_screen_ends(void)
{
    static const char *const arguments[] = {"--fix", "all", NULL};
    const string folder = folder_new(), input = right_answers(&programs[0]);
    const process_setup setup = {.program = programs[0].path,
                                 .arguments = arguments,
                                 .folder = folder.text,
                                 .wires = {WIRE_PIPE, WIRE_PIPE, WIRE_TERMINAL}};
    process process;
    process_run(&process, &setup, input.text);
    process_check_status(&process, 0, "a pipe and a screen");
    const string last = process_last_line(&process);
    TEST_ASSERT_EQUAL_INT('\n', process.errors.bytes[process.errors.length - 1]);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(last.text, prompts[QUESTION_DELTA]), last.text);
}

/* The input ends; or a folder has the name of the last file. */
static void test_no_note_when_the_run_fails(void)
{
    for (int i = 0; i < PROGRAMS; i++) {
        const string here = folder_new(), name = string_of("%s.1", programs[i].files[FILE_MACHINING]);
        const process_setup setup = {
            .program = programs[i].path, .folder = here.text, .wires = ALL_ON_TERMINAL};
        process process;
        start_up_to(&process, &setup, &programs[i], QUESTION_DELTA);
        process_say(&process, "\004");
        process_finish(&process);
        process_check_status(&process, 2, programs[i].name);
        TEST_ASSERT_NULL_MESSAGE(strstr(process.errors.bytes, "--fix all"), process.errors.bytes);

        folder_below(here.text, name.text);
        start_up_to(&process, &setup, &programs[i], QUESTION_DELTA);
        say_answers(&process, &programs[i], QUESTION_DELTA, QUESTIONS);
        process_finish(&process);
        process_check_status(&process, 1, programs[i].name);
        TEST_ASSERT_NULL_MESSAGE(strstr(process.errors.bytes, "--fix all"), process.errors.bytes);
    }
}

/* The answers come from a pipe, and no echo ends the last prompt's line: the note is a line all the same. */
static void test_note_is_a_line_of_its_own(void)
{
    for (int i = 0; i < PROGRAMS; i++) {
        const string folder = folder_new(), input = right_answers(&programs[i]);
        const string note = string_of("\n" NOTE_1987, programs[i].name);
        const process_setup setup = {.program = programs[i].path,
                                     .folder = folder.text,
                                     .wires = {WIRE_PIPE, WIRE_PIPE, WIRE_TERMINAL}};
        process process;
        process_run(&process, &setup, input.text);
        process_check_status(&process, 0, programs[i].name);
        const char *found = strstr(process.errors.bytes, note.text);
        TEST_ASSERT_NOT_NULL_MESSAGE(found, process.errors.bytes);
        TEST_ASSERT_EQUAL_STRING_MESSAGE(note.text, found, "the note comes last");
    }
}

/* Typed at a terminal, read from a file: the note would spoil what is compared with the dialogue of 1987. */
static void test_no_note_in_a_file(void)
{
    for (int i = 0; i < PROGRAMS; i++) {
        const string folder = folder_new(), input = right_answers(&programs[i]);
        const string golden = golden_of(golden_1987, &programs[i], 1, "dialogue");
        const process_setup setup = {.program = programs[i].path,
                                     .folder = folder.text,
                                     .wires = {WIRE_TERMINAL, WIRE_TERMINAL, WIRE_PIPE}};
        text dialogue;
        process process;
        file_read(golden.text, &dialogue);
        process_run(&process, &setup, input.text);
        process_check_status(&process, 0, programs[i].name);
        text_check(dialogue.bytes, dialogue.length, &process.errors, programs[i].name);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_sessions_of_1987);
    RUN_TEST(test_corrected_sessions);
    RUN_TEST(test_partly_corrected_sessions);
    RUN_TEST(test_wrong_answers_on_the_screen);
    RUN_TEST(test_more_on_a_line_than_asked_for);
    RUN_TEST(test_a_pasted_session);
    RUN_TEST(test_the_last_line_on_a_screen_ends);
    RUN_TEST(test_no_note_when_the_run_fails);
    RUN_TEST(test_note_is_a_line_of_its_own);
    RUN_TEST(test_no_note_in_a_file);
    return UNITY_END();
}
