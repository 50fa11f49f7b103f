/* The files of right runs: the paper's cases, where the files go, and what each erratum changes in them. */

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

/* ---- the paper's cases ---- */

static void check_case(const tested *program, const char *set, int number, const char *folder)
{
    static const char *const corrected[] = {"--fix", "all", NULL};
    const string what = string_of("%s, case %d, %s", program->name, number, set);
    const string input_file = golden_of(set, program, number, "input");
    const string dialogue_file = golden_of(set, program, number, "dialogue");
    const string listing = listing_of(program, 2, 1);
    text input, dialogue;
    process process;
    file_read(input_file.text, &input);
    file_read(dialogue_file.text, &dialogue);
    run_in(folder, program, set == golden_corrected ? corrected : NULL, input.bytes, &process);
    process_check_status(&process, 0, what.text);
    text_check(dialogue.bytes, dialogue.length, &process.errors, what.text);
    text_check("", 0, &process.output, what.text);
    folder_check(folder, listing.text, what.text);
    check_golden(folder, 1, program, set, number, FILES, what.text);
}

/* In one folder one after the other: each run also replaces the files of the one before. */
static void check_cases(const tested *program)
{
    const string folder = folder_new();
    for (int number = 1; number <= 2; number++) {
        check_case(program, golden_1987, number, folder.text);
        check_case(program, golden_corrected, number, folder.text);
    }
}

static void test_paper_cases_of_intella(void)
{
    check_cases(&programs[0]);
}

static void test_paper_cases_of_adpta(void)
{
    check_cases(&programs[1]);
}

/* ---- where the files go ---- */

typedef struct place {
    const char *arguments[5];
    const char *where; /* "in", the folder that the program runs in, or "out", the one beside it */
    int run;
} place;

static const place places[] = {
    {{NULL}, "in", 1},
    {{"-o", "."}, "in", 1},
    {{"-o", "../out"}, "out", 1},
    {{"-o../out"}, "out", 1},
    {{"-o", "../out/"}, "out", 1},
    {{"--output", "../out"}, "out", 1},
    {{"--output=../out"}, "out", 1},
    {{"-o", "../out", "-o", "../in"}, "in", 1},
    {{"-r", "2"}, "in", 2},
    {{"-r7"}, "in", 7},
    {{"--run", "999999"}, "in", 999999},
    {{"--run=10", "--output=../out"}, "out", 10},
    {{"-r", "3", "-r", "4"}, "in", 4},
};

static void check_place(const tested *program, const place *place)
{
    const string what = command_of(program, place->arguments), here = folder_new();
    const string in = folder_below(here.text, "in"), out = folder_below(here.text, "out");
    const bool to_out = strcmp(place->where, "out") == 0;
    const string input = right_answers(program), listing = listing_of(program, 2, place->run);
    process process;
    run_in(in.text, program, place->arguments, input.text, &process);
    process_check_status(&process, 0, what.text);
    folder_check(in.text, to_out ? "" : listing.text, what.text);
    folder_check(out.text, to_out ? listing.text : "", what.text);
    check_golden(to_out ? out.text : in.text, place->run, program, golden_1987, 1, FILES, what.text);
}

static void test_files_go_where_they_are_told(void)
{
    for (int i = 0; i < PROGRAMS; i++) {
        for (size_t j = 0; j < sizeof places / sizeof places[0]; j++) {
            check_place(&programs[i], &places[j]);
        }
    }
}

/* A draft's name may be taken, by a run on another machine that shares the folder, say: it is left alone. */
static void test_a_draft_s_name_that_is_taken(void)
{
    static const char script[] = "for n in 0 1 2; do echo mine >\"$2/.$3.1.$$-$n.part\"; done; exec \"$1\" -o \"$2\"";
    for (int i = 0; i < PROGRAMS; i++) {
        const string folder = folder_new(), input = right_answers(&programs[i]);
        const process_setup setup = {
            .program = "/bin/sh",
            .arguments = (const char *const[]){"-c", script, "sh", programs[i].path, folder.text,
                                               programs[i].files[0], NULL}};
        process process;
        process_run(&process, &setup, input.text);
        process_check_status(&process, 0, programs[i].name);
        check_golden(folder.text, 1, &programs[i], golden_1987, 1, FILES, programs[i].name);
        for (int n = 0; n < 3; n++) {
            const string taken =
                string_of("%s/.%s.1.%ld-%d.part", folder.text, programs[i].files[0], (long)process.id, n);
            file_check(taken.text, "mine\n", taken.text);
        }
    }
}

/* A folder named from the root. */
static void test_files_go_to_an_absolute_folder(void)
{
    for (int i = 0; i < PROGRAMS; i++) {
        const string input = right_answers(&programs[i]), listing = listing_of(&programs[i], 2, 1);
        const string here = folder_new(), out = folder_new();
        const char *const arguments[] = {"-o", out.text, NULL};
        process process;
        run_in(here.text, &programs[i], arguments, input.text, &process);
        process_check_status(&process, 0, programs[i].name);
        folder_check(out.text, listing.text, programs[i].name);
    }
}

/* ---- what one erratum changes ---- */

/* What a run prints: its four files, then its dialogue. */
enum { PRINTED_DIALOGUE = FILES, PRINTED };

typedef struct printed {
    text texts[PRINTED];
} printed;

/* The wishes of the paper's two cases; an erratum may show in one and not in the other. */
static const char *const wishes[PROGRAMS][2] = {
    {"200 200 0 0 1.57 0", "-200 200 100 0 1.57 0"},
    {"200 200 0 0", "-200 200 100 0"},
};

static void print_case(int which, int number, const char *const arguments[], printed *printed)
{
    const tested *program = &programs[which];
    const string input = string_of("%s .5 .5 .5 .1 .1 .1 .1\n", wishes[which][number - 1]);
    const string what = command_of(program, arguments), folder = folder_new();
    process process;
    run_in(folder.text, program, arguments, input.text, &process);
    process_check_status(&process, 0, what.text);
    for (int i = 0; i < FILES; i++) {
        const string file = file_of(folder.text, program, i);
        file_read(file.text, &printed->texts[i]);
    }
    printed->texts[PRINTED_DIALOGUE] = process.errors;
}

/* Take out the line that says what is corrected: in both files of text, behind the heading, and nowhere else. */
static void take_out_what_is_corrected(printed *printed, const char *names)
{
    static const char begin[] = "\nerrata of 1987 corrected: ";
    const string line = string_of("%s%s\n", begin, names);
    for (int i = 0; i < PRINTED; i++) {
        text *text = &printed->texts[i];
        char *found = strstr(text->bytes, begin);
        if (i == FILE_TOLERANCES || i == FILE_MACHINING) {
            const size_t length = strlen(line.text) - 1;
            TEST_ASSERT_NOT_NULL_MESSAGE(found, names);
            TEST_ASSERT_TRUE_MESSAGE(found == strchr(text->bytes, '\n'), names);
            TEST_ASSERT_EQUAL_INT_MESSAGE(0, strncmp(found, line.text, length + 1), names);
            memmove(found, found + length, strlen(found + length) + 1);
            text->length -= length;
        } else {
            TEST_ASSERT_NULL_MESSAGE(found, names);
        }
    }
}

/* Take out the note on standard error about errata that change nothing here. True where it was there. */
static bool take_out_note(printed *printed, const char *program, const char *names)
{
    const string note = string_of("--fix: in %s this changes nothing: %s\n", program, names);
    text *dialogue = &printed->texts[PRINTED_DIALOGUE];
    const size_t length = strlen(note.text);
    const bool noted = strncmp(dialogue->bytes, note.text, length) == 0;
    if (noted) {
        memmove(dialogue->bytes, dialogue->bytes + length, strlen(dialogue->bytes + length) + 1);
        dialogue->length -= length;
    }
    TEST_ASSERT_NULL_MESSAGE(strstr(dialogue->bytes, "--fix"), names);
    return noted;
}

/*
 * What correcting one erratum alone changes in A, A reordered, tolerances, machining tolerances and dialogue:
 * x must, . must not, ? may: it moves numbers there, but by less than the last digit or in a row that does
 * not bind, depending on the position. Of the Intelledex and of the Adept.
 */
typedef struct effect {
    const char *erratum;
    const char *changes[PROGRAMS];
} effect;

static const effect effects[ERRATA] = {
    {"mtransf-typo", {"xxxx.", "xx??."}},    /* the Adept has one link with an alpha, its tool */
    {"parallel-arm", {"xxxx.", "xxxx."}},
    {"adept-shift", {".....", "xxxx."}},
    {"skew-residue", {".....", "xx?x."}},    /* the Intelledex's residue is 0 */
    {"root-of-ratio", {"...x.", "...x."}},
    {"copied-counts", {".....", "...x."}},   /* the counts are the Intelledex's own */
    {"signed-mach", {".....", "...x."}},     /* the Intelledex has no negative length */
    {"short-pi", {"xxx?x", "xxx?x"}},
    {"prismatic-alpha", {".....", "....."}}, /* a and alpha of the one prismatic link are 0 */
    {"beta-sign", {"xx...", "xx..."}},       /* beta is 0: only signs of columns, which no norm sees */
    {"half-turns", {".....", "xx?x."}},
    {"base-twist", {"xxxx.", "xxxx."}},
    {"float", {"xx??x", "xxx?x"}},           /* the Adept's d[4] = -203.199997 is -203.200000 */
    {"labels", {"..x..", "..x.."}},
    {"gppp-clearing", {".....", "....."}},   /* what is not cleared was 0 */
    {"distance-share", {"..xx.", "..??."}},  /* the Adept's first case has one row that sets both bounds */
};

static void check_effect(int which, int number, const effect *effect, const printed *of_1987)
{
    const char *const arguments[] = {"--fix", effect->erratum, NULL};
    static const char *const parts[PRINTED] = {"A", "A reordered", "tolerances", "machining", "dialogue"};
    printed corrected;
    print_case(which, number, arguments, &corrected);
    take_out_what_is_corrected(&corrected, effect->erratum);
    const bool noted = take_out_note(&corrected, programs[which].name, effect->erratum);
    TEST_ASSERT_EQUAL_INT_MESSAGE(strcmp(effect->changes[which], ".....") == 0, noted, effect->erratum);
    for (int i = 0; i < PRINTED; i++) {
        const char expected = effect->changes[which][i];
        const bool changed = strcmp(corrected.texts[i].bytes, of_1987->texts[i].bytes) != 0;
        if ((expected == 'x' && !changed) || (expected == '.' && changed)) {
            fail_with("%s --fix %s, case %d: %s %s", programs[which].name, effect->erratum, number, parts[i],
                      changed ? "changed and must not" : "must change and did not");
        }
    }
}

static void test_each_erratum_changes_what_it_should(void)
{
    for (int i = 0; i < PROGRAMS; i++) {
        for (int number = 1; number <= 2; number++) {
            printed of_1987;
            print_case(i, number, NULL, &of_1987);
            for (int j = 0; j < ERRATA; j++) {
                TEST_ASSERT_EQUAL_STRING_MESSAGE(errata[j], effects[j].erratum, "the table of effects");
                check_effect(i, number, &effects[j], &of_1987);
            }
        }
    }
}

/* ---- which lines of a file one erratum changes ---- */

#define INTELLEDEX_ANGLES \
    "ggd[0] ggd[1] ggd[2] ggd[3] ggd[4] ggd[5] ggd[6] ggd[7] td[0] td[1] td[2] td[3] td[4] td[5]"
#define ADEPT_ANGLES "ggd[0] ggd[1] ggd[2] ggd[3] ggd[4] ggd[5] td[0] td[1] td[2]"
#define DISTANCE_BOUND "A bound on the error in distance parameters"
#define ANGLE_BOUND "A bound on the error in angle parameters"

typedef struct changed_lines {
    int program;
    const char *erratum;
    int file;
    const char *labels; /* of the file of 1987 */
} changed_lines;

static const changed_lines line_changes[] = {
    {0, "labels", FILE_TOLERANCES, "dwx dwx"},
    {1, "labels", FILE_TOLERANCES, "dwx dwx"},
    {0, "parallel-arm", FILE_TOLERANCES, ANGLE_BOUND},
    {1, "parallel-arm", FILE_TOLERANCES, ANGLE_BOUND},
    {0, "parallel-arm", FILE_MACHINING, INTELLEDEX_ANGLES},
    {1, "parallel-arm", FILE_MACHINING, ADEPT_ANGLES},
    {0, "base-twist", FILE_TOLERANCES, ANGLE_BOUND},
    {1, "base-twist", FILE_TOLERANCES, ANGLE_BOUND},
    {1, "adept-shift", FILE_TOLERANCES, ANGLE_BOUND},
    {1, "adept-shift", FILE_MACHINING, "rd[1] rd[2] rd[3] " ADEPT_ANGLES},
    {1, "skew-residue", FILE_MACHINING, ADEPT_ANGLES},
    {1, "half-turns", FILE_MACHINING, ADEPT_ANGLES},
    {1, "signed-mach", FILE_MACHINING, "rd[4] td[3]"},
    {0, "root-of-ratio", FILE_MACHINING,
     "rd[0] rd[1] rd[2] rd[3] rd[4] rd[5] rd[6] rd[7] " INTELLEDEX_ANGLES},
    {1, "root-of-ratio", FILE_MACHINING, "rd[0] rd[1] rd[2] rd[3] rd[4] rd[5] " ADEPT_ANGLES " td[3]"},
    {0, "distance-share", FILE_TOLERANCES, DISTANCE_BOUND},
    {0, "distance-share", FILE_MACHINING, "rd[0] rd[1] rd[2] rd[3] rd[4] rd[5] rd[6] rd[7]"},
    {1, "copied-counts", FILE_MACHINING, "rd[0] rd[1] rd[2] rd[3] rd[4] rd[5] " ADEPT_ANGLES " td[3]"},
};

/* The labels, up to " =", of the lines of one that are not so in other; a blank between each. */
static string labels_of_changes(const char *one, const char *other)
{
    string labels = {""};
    while (*one != '\0' && *other != '\0') {
        const size_t length = strcspn(one, "\n"), other_length = strcspn(other, "\n");
        if (length != other_length || strncmp(one, other, length) != 0) {
            const char *label = one + strspn(one, " "), *end = strstr(label, " =");
            const int size = end != NULL ? (int)(end - label) : 0;
            const string longer =
                string_of("%s%s%.*s", labels.text, labels.text[0] != '\0' ? " " : "", size, label);
            labels = longer;
        }
        one += length + (one[length] == '\n');
        other += other_length + (other[other_length] == '\n');
    }
    return labels;
}

static void test_each_erratum_changes_its_lines_only(void)
{
    for (size_t i = 0; i < sizeof line_changes / sizeof line_changes[0]; i++) {
        const changed_lines *row = &line_changes[i];
        const char *const arguments[] = {"--fix", row->erratum, NULL};
        const string what = string_of("%s --fix %s, %s", programs[row->program].name, row->erratum,
                                      programs[row->program].files[row->file]);
        printed of_1987, corrected;
        print_case(row->program, 2, NULL, &of_1987);
        print_case(row->program, 2, arguments, &corrected);
        take_out_what_is_corrected(&corrected, row->erratum);
        const string labels =
            labels_of_changes(of_1987.texts[row->file].bytes, corrected.texts[row->file].bytes);
        TEST_ASSERT_EQUAL_STRING_MESSAGE(row->labels, labels.text, what.text);
    }
}

/* The line with that label, which begins with a blank. */
static string line_with(const text *text, const char *label)
{
    const string begin = string_of("\n %s = ", label);
    const char *found = strstr(text->bytes, begin.text);
    if (found == NULL) {
        fail_with("no line \"%s\" in \"%s\"", label, text->bytes);
    }
    return string_of("%.*s", (int)strcspn(found + 1, "\n"), found + 1);
}

static void test_labels_are_told_apart_when_corrected(void)
{
    static const char *const arguments[] = {"--fix", "labels", NULL};
    for (int i = 0; i < PROGRAMS; i++) {
        printed of_1987, corrected;
        print_case(i, 1, NULL, &of_1987);
        print_case(i, 1, arguments, &corrected);
        const char *was = strstr(of_1987.texts[FILE_TOLERANCES].bytes, " dwx = ");
        const char *is = strstr(corrected.texts[FILE_TOLERANCES].bytes, " dwx = ");
        TEST_ASSERT_NOT_NULL_MESSAGE(was, programs[i].name);
        TEST_ASSERT_NOT_NULL_MESSAGE(is, programs[i].name);
        TEST_ASSERT_EQUAL_STRING_MESSAGE(" dwx =    0.100000\n dwx =    0.100000\n dwx =    0.100000\n\n"
                                         "and\n delta =    0.100000\n",
                                         was, programs[i].name);
        TEST_ASSERT_EQUAL_STRING_MESSAGE(" dwx =    0.100000\n dwy =    0.100000\n dwz =    0.100000\n\n"
                                         "and\n delta =    0.100000\n",
                                         is, programs[i].name);
    }
}

/* The paper prints both without their sign; the programs of 1987 did not. */
static void test_signs_of_the_prismatic_joint(void)
{
    static const char *const arguments[] = {"--fix", "signed-mach", NULL};
    static const char *const labels[] = {"rd[4]", "td[3]"};
    printed of_1987, corrected;
    print_case(1, 1, NULL, &of_1987);
    print_case(1, 1, arguments, &corrected);
    for (int i = 0; i < 2; i++) {
        const string was = line_with(&of_1987.texts[FILE_MACHINING], labels[i]);
        const string is = line_with(&corrected.texts[FILE_MACHINING], labels[i]);
        TEST_ASSERT_TRUE_MESSAGE(strchr(was.text, '-') != NULL, was.text);
        TEST_ASSERT_TRUE_MESSAGE(strchr(is.text, '-') == NULL, is.text);
    }
}

/* ---- several errata ---- */

static void check_same_printed(const printed *one, const printed *other, const char *what)
{
    for (int i = 0; i < PRINTED; i++) {
        text_check(one->texts[i].bytes, one->texts[i].length, &other->texts[i], what);
    }
}

/* All of these say the same: what corrects two errata. */
static const char *const ways_to_fix_two[][6] = {
    {"--fix", "labels,root-of-ratio"},
    {"--fix", "root-of-ratio,labels"},
    {"--fix", "labels,labels,root-of-ratio"},
    {"--fix=labels", "--fix=root-of-ratio"},
    {"--fix", "root-of-ratio", "--fix", "labels"},
    {"-f", "labels", "-f", "root-of-ratio"},
    {"-flabels,root-of-ratio"},
};

static void test_corrections_add_up(void)
{
    static const char *const one[] = {"--fix", "labels", NULL};
    static const char *const other[] = {"--fix", "root-of-ratio", NULL};
    for (int i = 0; i < PROGRAMS; i++) {
        printed first, second;
        print_case(i, 1, one, &first);
        print_case(i, 1, other, &second);
        take_out_what_is_corrected(&first, "labels");
        take_out_what_is_corrected(&second, "root-of-ratio");
        /* each shows in one file, so that both together are these */
        first.texts[FILE_MACHINING] = second.texts[FILE_MACHINING];
        for (size_t j = 0; j < sizeof ways_to_fix_two / sizeof ways_to_fix_two[0]; j++) {
            const string what = command_of(&programs[i], ways_to_fix_two[j]);
            printed both;
            print_case(i, 1, ways_to_fix_two[j], &both);
            take_out_what_is_corrected(&both, "root-of-ratio, labels");
            check_same_printed(&first, &both, what.text);
        }
    }
}

/* The ids are the words that begin the lines of --list-errata. */
static string listed_ids(const tested *program)
{
    static const char *const arguments[] = {"--list-errata", NULL};
    const string folder = folder_new();
    string ids = {""};
    process process;
    run_in(folder.text, program, arguments, "", &process);
    process_check_status(&process, 0, "--list-errata");
    for (const char *line = process.output.bytes; *line != '\0'; line += strcspn(line, "\n") + 1) {
        const int length = (int)strcspn(line, " \n");
        if (length > 0) {
            const string longer =
                string_of("%s%s%.*s", ids.text, ids.text[0] != '\0' ? "," : "", length, line);
            ids = longer;
        }
    }
    return ids;
}

static void test_all_is_the_list_of_all(void)
{
    static const char *const all[] = {"--fix", "all", NULL};
    static const char *const more_than_all[] = {"--fix", "float,all", NULL};
    for (int i = 0; i < PROGRAMS; i++) {
        const string ids = listed_ids(&programs[i]);
        const char *const each[] = {"--fix", ids.text, NULL};
        printed with_all, with_each, with_more;
        print_case(i, 1, all, &with_all);
        print_case(i, 1, each, &with_each);
        print_case(i, 1, more_than_all, &with_more);
        check_same_printed(&with_all, &with_each, ids.text);
        check_same_printed(&with_all, &with_more, "float,all");
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_paper_cases_of_intella);
    RUN_TEST(test_paper_cases_of_adpta);
    RUN_TEST(test_files_go_where_they_are_told);
    RUN_TEST(test_a_draft_s_name_that_is_taken);
    RUN_TEST(test_files_go_to_an_absolute_folder);
    RUN_TEST(test_each_erratum_changes_what_it_should);
    RUN_TEST(test_each_erratum_changes_its_lines_only);
    RUN_TEST(test_labels_are_told_apart_when_corrected);
    RUN_TEST(test_signs_of_the_prismatic_joint);
    RUN_TEST(test_corrections_add_up);
    RUN_TEST(test_all_is_the_list_of_all);
    return UNITY_END();
}
