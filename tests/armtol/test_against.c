/* armtol --against and --deviations, run as users run it, on arms whose errors are known in closed form. */

#include "armtol/runs.h"
#include "support/check.h"
#include "support/process.h"
#include "unity.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double degree = 3.14159265358979323846 / 180;

/* Two links of 300 and 200 mm in a plane. */
#define HEAD "units: mm deg\nkind joint a alpha d theta\n"
#define NOMINAL HEAD "ppr theta 300 0 0 0\nnpr theta 200 0 0 0\n"

void setUp(void)
{
}

void tearDown(void)
{
    process_clean_up();
}

static string arm_folder(void)
{
    const string folder = folder_new();
    file_write(string_of("%s/arm.csv", folder.text).text, NOMINAL);
    file_write(string_of("%s/long.csv", folder.text).text, HEAD "ppr theta 300 0 0 0\nnpr theta 200.5 0 0 0\n");
    file_write(string_of("%s/turned.csv", folder.text).text, HEAD "ppr theta 300 0 0 0.25\nnpr theta 200 0 0 0\n");
    file_write(string_of("%s/both.csv", folder.text).text, HEAD "ppr theta 300 0 0 0.25\nnpr theta 200.5 0 0 0\n");
    file_write(string_of("%s/poses", folder.text).text, "20 30\n20 -30\n100 170\n");
    return folder;
}

/* The numbers behind "name": in the JSON, from the occurrence on; how far that is. */
static size_t numbers_of(const process *process, size_t from, const char *name, double values[], size_t count)
{
    const string key = string_of("\"%s\": ", name);
    const char *at = strstr(process->output.bytes + from, key.text);
    TEST_ASSERT_NOT_NULL_MESSAGE(at, name);
    const char *number = at + strlen(key.text);
    number += *number == '[';
    for (size_t i = 0; i < count; i++) {
        char *end;
        values[i] = strtod(number, &end);
        TEST_ASSERT_TRUE_MESSAGE(end != number, name);
        number = end + 1;
    }
    return (size_t)(number - process->output.bytes);
}

/* A longer last link: half a millimetre along it, wherever the arm is. */
static void test_a_length(void)
{
    const string folder = arm_folder();
    process process;
    double error[6], sizes[2];
    run_well(&process, folder.text,
             (const char *const[]){"arm.csv", "--against", "long.csv", "--joints", "20,30", "--json", NULL});
    numbers_of(&process, 0, "error", error, 6);
    check_within(1e-12, 0.5 * cos(50 * degree), error[0], "dx");
    check_within(1e-12, 0.5 * sin(50 * degree), error[1], "dy");
    check_within(1e-15, 0, error[5], "wz");
    numbers_of(&process, 0, "distance", sizes, 1);
    check_within(1e-12, 0.5, sizes[0], "distance");
    check_says(&process, "\"of_distance\": 1");
    run_well(&process, folder.text,
             (const char *const[]){"arm.csv", "--against", "long.csv", "--joints", "20,30", NULL});
    check_says(&process, "The tool of long.csv, less that of arm");
    check_says(&process, "\n  a of 1               0.5    mm       0.5      0      100.0 %         -\n");
}

/* A turn of the base by 0.25 degrees: the chord of the reach, and the whole turn. */
static void test_an_angle(void)
{
    const string folder = arm_folder();
    process process;
    run_well(&process, folder.text,
             (const char *const[]){"arm.csv", "--against", "turned.csv", "--poses", "poses", "--json", NULL});
    static const double elbows[3] = {30, -30, 170};
    size_t from = 0;
    double sum = 0, found, largest = 0;
    for (int pose = 0; pose < 3; pose++) {
        double error[6];
        const double reach = sqrt(300 * 300 + 200 * 200 + 2 * 300 * 200 * cos(elbows[pose] * degree));
        const double chord = 2 * reach * sin(0.125 * degree);
        from = numbers_of(&process, from, "error", error, 6);
        from = numbers_of(&process, from, "distance", &found, 1);
        check_within(1e-11, chord, found, "pose %d", pose + 1);
        check_within(1e-12, 0.25, error[5], "turn of pose %d", pose + 1);
        from = numbers_of(&process, from, "error", error, 6); /* the explained one */
        sum += chord;
        largest = fmax(largest, chord);
    }
    from = numbers_of(&process, from, "distance", &found, 1);
    check_within(1e-11, sum / 3, found, "mean");
    numbers_of(&process, from, "distance", &found, 1);
    check_within(1e-11, largest, found, "largest");
}

/* Each alone, and together: the parts add up to 1. */
static void test_two_differences(void)
{
    const string folder = arm_folder();
    process process;
    run_well(&process, folder.text,
             (const char *const[]){"arm.csv", "--against", "both.csv", "--joints", "20,30", "--json", NULL});
    size_t from = (size_t)(strstr(process.output.bytes, "\"differences\"") - process.output.bytes);
    double parts[3], sizes[2];
    from = numbers_of(&process, from, "distance", &sizes[0], 1);
    from = numbers_of(&process, from, "of_distance", &parts[0], 1);
    from = numbers_of(&process, from, "distance", &sizes[1], 1);
    from = numbers_of(&process, from, "of_distance", &parts[1], 1);
    numbers_of(&process, from, "of_distance", &parts[2], 1);
    const double reach = sqrt(300 * 300 + 200 * 200 + 2 * 300 * 200 * cos(30 * degree));
    check_within(1e-11, 2 * reach * sin(0.125 * degree), sizes[0], "the turn moves farther and comes first");
    check_within(1e-11, 0.5, sizes[1], "the length");
    check_within(1e-12, 1, parts[0] + parts[1] + parts[2], "all parts");
    TEST_ASSERT_TRUE(fabs(parts[2]) < 0.25 * degree);
}

/* Deviations are of ARM itself, in the units of the command line, with their signs. */
static void test_deviations(void)
{
    const string folder = arm_folder();
    process of_file, of_arm;
    file_write(string_of("%s/off", folder.text).text, "link,parameter,deviation,unit\n0,theta,0.25,deg\n1,a,0.5,mm\n");
    run_well(&of_arm, folder.text,
             (const char *const[]){"arm.csv", "--against", "both.csv", "--joints", "20,30", "--json", NULL});
    run_well(&of_file, folder.text,
             (const char *const[]){"arm.csv", "--deviations", "off", "--joints", "20,30", "--json", NULL});
    const char *same = strstr(of_arm.output.bytes, "\"units\"");
    TEST_ASSERT_EQUAL_STRING(same, strstr(of_file.output.bytes, "\"units\""));
    file_write(string_of("%s/off", folder.text).text, "link,parameter,deviation\n1,a,-0.5\n");
    run_well(&of_file, folder.text, (const char *const[]){"arm.csv", "--deviations", "off", "--joints", "0,0", NULL});
    check_says(&of_file, "1     -0.5    0    0       0.5      0\n");
    check_says(&of_file, "with the deviations of off");
}

/* The other arm may be in other units. */
static void test_the_other_arm_in_metres(void)
{
    const string folder = arm_folder();
    process process;
    file_write(string_of("%s/m.csv", folder.text).text,
               "units: m deg\nkind joint a alpha d theta\nppr theta 0.3 0 0 0\nnpr theta 0.2005 0 0 0\n");
    run_well(&process, folder.text, (const char *const[]){"arm.csv", "--against", "m.csv", "--joints", "0,0", NULL});
    check_says(&process, "1     0.5    0    0       0.5      0\n");
}

static void test_the_same_arm(void)
{
    const string folder = arm_folder();
    process process;
    run_well(&process, folder.text,
             (const char *const[]){"arm.csv", "--against", "arm.csv", "--joints", "20,30", NULL});
    check_says(&process, "No parameter differs.\n");
}

static void test_more_poses_than_a_table_holds(void)
{
    const string folder = arm_folder();
    process process;
    string poses = string_of("1 1\n");
    for (int i = 0; i < 29; i++) {
        poses = string_of("%s%d %d\n", poses.text, i, 2 * i);
    }
    file_write(string_of("%s/poses", folder.text).text, poses.text);
    run_well(&process, folder.text,
             (const char *const[]){"arm.csv", "--against", "long.csv", "--poses", "poses", NULL});
    check_says(&process, "  and 6 more poses (--json has all)\n");
}

/* ---- what is wrong ---- */

static void check_refused(const string *folder, const char *option, const char *value, const char *more,
                          const char *words)
{
    const char *const arguments[] = {"arm.csv", option, value, "--joints", "0,0", more, NULL};
    check_refused_run(folder->text, arguments, words);
}

static void test_arms_that_cannot_be_compared(void)
{
    const string folder = arm_folder();
    file_write(string_of("%s/three.csv", folder.text).text, NOMINAL "npr theta 1 0 0 0\n");
    file_write(string_of("%s/slide.csv", folder.text).text, HEAD "ppr theta 300 0 0 0\nnpp d 0 0 0 0\n");
    file_write(string_of("%s/sign.csv", folder.text).text,
               "units: mm deg\nkind joint a alpha d theta sign\nppr theta 300 0 0 0 -1\nnpr theta 200 0 0 0 1\n");
    check_refused(&folder, "--against", "three.csv", NULL, "three.csv has 3 links, and arm has 2; expected the same");
    check_refused(&folder, "--against", "slide.csv", NULL, "slide.csv: the joint of link 1 is not of the same kind");
    check_refused(&folder, "--against", "sign.csv", NULL, "does not move as that of arm");
    check_refused(&folder, "--against", "nothing.csv", NULL, "nothing.csv: No such file");
}

/* What no double holds: a length in the other's unit, a slide at its joint value. */
static void test_what_is_too_large(void)
{
    const string folder = arm_folder();
    process process;
    file_write(string_of("%s/m.csv", folder.text).text,
               "units: m deg\nkind joint a alpha d theta\nppr theta 1e307 0 0 0\nnpr theta 1 0 0 0\n");
    check_refused(&folder, "--against", "m.csv", NULL, "link 0: a length is too large in mm");
    file_write(string_of("%s/slide.csv", folder.text).text, HEAD "npp d 0 0 1.7e308 0\nnpr theta 200 0 0 0\n");
    run(&process, folder.text,
        (const char *const[]){"slide.csv", "--against", "slide.csv", "--joints", "1.7e308,0", NULL});
    process_check_status(&process, 2, "too large");
    TEST_ASSERT_TRUE(strstr(process.errors.bytes, "--against: slide.csv, pose 1: ") != NULL);
}

/* Parameters that explain the same stand in their order. */
static void test_what_explains_nothing_keeps_its_order(void)
{
    const string folder = arm_folder();
    process process;
    file_write(string_of("%s/arm.csv", folder.text).text,
               HEAD "npr theta 0 0 0 0\nnpr theta 200 0 0 0\nnpr theta 0 0 0 0\nnpr theta 0 0 0 0\n");
    file_write(string_of("%s/off", folder.text).text,
               "link,parameter,deviation\n1,alpha,0.5\n2,alpha,0.5\n2,theta,0.5\n3,alpha,0.5\n3,theta,0.5\n1,a,0.1\n");
    run_well(&process, folder.text,
             (const char *const[]){"arm.csv", "--deviations", "off", "--joints", "0,0,0,0", NULL});
    const char *at = strstr(process.output.bytes, "of distance");
    static const char *const rows[] = {"\n  a of 1",     "\n  alpha of 1", "\n  theta of 2",
                                       "\n  alpha of 2", "\n  theta of 3", "\n  alpha of 3"};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        TEST_ASSERT_NOT_NULL_MESSAGE(at, rows[i]);
        at = strstr(at, rows[i]);
        TEST_ASSERT_NOT_NULL_MESSAGE(at, rows[i]);
    }
}

static void test_tables_of_deviations_that_are_wrong(void)
{
    const string folder = arm_folder();
    file_write(string_of("%s/off", folder.text).text, "link,parameter,deviation\n0,beta,x\n");
    check_refused(&folder, "--deviations", "off", NULL, "off:2:8: deviation: \"x\" is not a number");
    file_write(string_of("%s/off", folder.text).text, "link,parameter,deviation\n0,d,1\n");
    check_refused(&folder, "--deviations", "off", NULL, "has no parameter \"d\"");
    file_write(string_of("%s/off", folder.text).text, "link,parameter,tolerance\n0,a,1\n");
    check_refused(&folder, "--deviations", "off", NULL, "no column \"deviation\"");
    file_write(string_of("%s/off", folder.text).text, "link,parameter,deviation\n0,a,1.8e308\n");
    check_refused(&folder, "--deviations", "off", NULL, "deviation");
    check_refused(&folder, "--deviations", "gone", NULL, "--deviations: gone: No such file");
    /* both finite, and their sum not */
    file_write(string_of("%s/off", folder.text).text, "link,parameter,deviation\n0,a,1.7e308\n1,a,1.7e308\n");
    file_write(string_of("%s/arm.csv", folder.text).text, HEAD "ppr theta 1.7e308 0 0 0\nnpr theta 200 0 0 0\n");
    check_refused(&folder, "--deviations", "off", NULL, "not finite");
}

static void test_what_does_not_go_with_it(void)
{
    const string folder = arm_folder();
    process process;
    check_refused(&folder, "--against", "long.csv", "--budget", "compare two arms");
    check_refused(&folder, "--against", "long.csv", "--csv", "--csv writes tolerances only");
    run(&process, folder.text,
        (const char *const[]){"arm.csv", "--against", "long.csv", "--deviations", "off", "--joints", "0,0", NULL});
    process_check_status(&process, 2, "both");
    check_refused(&folder, "--against", "long.csv", "--accuracy=1,1,1,1,1,1", "expected no --accuracy");
    run(&process, folder.text, (const char *const[]){"arm.csv", "--against", "long.csv", "--region", "q1=0..1", NULL});
    process_check_status(&process, 2, "a region");
    TEST_ASSERT_TRUE(strstr(process.errors.bytes, "expected no --region") != NULL);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_length);
    RUN_TEST(test_an_angle);
    RUN_TEST(test_two_differences);
    RUN_TEST(test_deviations);
    RUN_TEST(test_the_other_arm_in_metres);
    RUN_TEST(test_the_same_arm);
    RUN_TEST(test_more_poses_than_a_table_holds);
    RUN_TEST(test_arms_that_cannot_be_compared);
    RUN_TEST(test_what_is_too_large);
    RUN_TEST(test_what_explains_nothing_keeps_its_order);
    RUN_TEST(test_tables_of_deviations_that_are_wrong);
    RUN_TEST(test_what_does_not_go_with_it);
    return UNITY_END();
}
