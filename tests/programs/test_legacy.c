/*
 * The port against the programs of 1987, byte for byte: four files and the dialogue, at positions drawn over
 * the whole workspace. The residue on the stack is out of the comparison: in the legacy programs used here
 * what they never set is static, so that C makes it zero, and the port runs with --fix skew-residue. The
 * Intelledex's residue is zero anyway: its port runs without any correction.
 */

#include "programs/programs.h"
#include "support/random.h"

#include "unity.h"

#include <math.h>
#include <string.h>

enum { POSITIONS = 500 };

void setUp(void)
{
}

void tearDown(void)
{
    process_clean_up();
}

/* Where a number of the wish is drawn from; and what is round there: multiples of step from origin. */
typedef struct range {
    double low, high, origin, step;
} range;

#define EIGHTH_TURN 0.78539816

/* A box about the arm, whose corners are far out of reach: mm, then radians, more than a turn. */
static const range intella_ranges[] = {
    {-620, 620, 0, 100},     {-620, 620, 0, 100},     {-260, 980, 59.7, 100},
    {-4, 4, 0, EIGHTH_TURN}, {-4, 4, 0, EIGHTH_TURN}, {-4, 4, 0, EIGHTH_TURN},
};
static const range adpta_ranges[] = {
    {-800, 800, 0, 50}, {-800, 800, 0, 50}, {-300, 600, 203.2, 100}, {-7, 7, 0, EIGHTH_TURN}};
static const range *const ranges[PROGRAMS] = {intella_ranges, adpta_ranges};

static void append(string *input, double number)
{
    const string longer = string_of("%s%.9g ", input->text, number);
    *input = longer;
}

static double draw(const range *range, bool rounded, random_source *source)
{
    const double number = random_between(source, range->low, range->high);
    return rounded ? range->origin + range->step * round((number - range->origin) / range->step) : number;
}

/* A wish; tolerances over six and four decades of mm and radians; a delta that fits them. */
static string draw_input(int which, bool rounded, random_source *source)
{
    string input = {""};
    double smallest = INFINITY;
    for (size_t i = 0; i < programs[which].starts[QUESTION_TOLERANCES]; i++) {
        append(&input, draw(&ranges[which][i], rounded, source));
    }
    for (int i = 0; i < 3; i++) {
        const double tolerance = pow(10, random_between(source, -4, 2));
        smallest = fmin(smallest, tolerance);
        append(&input, tolerance);
    }
    for (int i = 3; i < 6; i++) {
        append(&input, pow(10, random_between(source, -4, 0)));
    }
    append(&input, smallest * random_between(source, 0.01, 0.99));
    return input;
}

typedef struct folders {
    string port, legacy;
} folders;

/* The port's files of text say what is corrected, in a line that those of 1987 do not have. */
static void take_out_what_is_corrected(text *text)
{
    static const char line[] = "errata of 1987 corrected: skew-residue\n";
    char *found = strstr(text->bytes, line);
    if (found != NULL) {
        memmove(found, found + strlen(line), strlen(found + strlen(line)) + 1);
        text->length -= strlen(line);
    }
}

static void compare(const tested *program, const folders *folders, const process *legacy, const process *port,
                    const char *what)
{
    text_check(legacy->errors.bytes, legacy->errors.length, &port->errors, what);
    for (int i = 0; i < FILES; i++) {
        const string expected = file_of(folders->legacy.text, program, i);
        const string actual = file_of(folders->port.text, program, i);
        text written, of_port;
        file_read(expected.text, &written);
        file_read(actual.text, &of_port);
        take_out_what_is_corrected(&of_port);
        text_check(written.bytes, written.length, &of_port, what);
    }
}

/* False where the port does not take the position; the legacy program would go on with nan. */
static bool compare_runs(const tested *program, const char *const arguments[], const folders *folders,
                         const char *input)
{
    const process_setup setup = {.program = program->legacy, .folder = folders->legacy.text};
    const string command = command_of(program, arguments);
    const string what = string_of("%s, \"%s\"", command.text, input);
    process port, legacy;
    run_in(folders->port.text, program, arguments, input, &port);
    if (port.status == 2) {
        check_message(&port, program, "desired position: ", what.text);
        return false;
    }
    process_check_status(&port, 0, what.text);
    process_run(&legacy, &setup, input);
    process_check_status(&legacy, 0, what.text);
    compare(program, folders, &legacy, &port, what.text);
    return true;
}

static void compare_over_workspace(int which, const char *const arguments[])
{
    random_source source = {1987};
    const folders folders = {folder_new(), folder_new()};
    int taken = 0;
    for (int i = 0; i < POSITIONS; i++) {
        /* at round positions, every fifth, joints are aligned and zeros turn up */
        const string input = draw_input(which, i % 5 == 0, &source);
        taken += compare_runs(&programs[which], arguments, &folders, input.text);
    }
    if (taken < POSITIONS / 2) {
        fail_with("%s takes only %d of %d positions", programs[which].name, taken, POSITIONS);
    }
}

static const char *const without_residue[] = {"--fix", "skew-residue", NULL};

static void test_intella_as_in_1987(void)
{
    compare_over_workspace(0, NULL);
}

static void test_adpta_without_residue(void)
{
    compare_over_workspace(1, without_residue);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_intella_as_in_1987);
    RUN_TEST(test_adpta_without_residue);
    return UNITY_END();
}
