/* Whole runs of armtol that ask for grades: the numbers of ISO 286 and ISO 2768 are those of docs/grades.md. */

#include "armtol/runs.h"
#include "support/process.h"

#include "unity.h"

#include <stddef.h>
#include <string.h>

/* Two turning joints, the first link 100 and 40 mm, the second 600 mm along its axis; and a slide. */
#define LINKS "joint,kind,a,alpha,d,theta\ntheta,npr,%s,30,%s,0\ntheta,npr,0,90,%s,0\nd,ppp,%s,0,0,0\n"
#define POSE "--joints", "10,20,30"
#define TOLERANCES "0.a=.0175,0.d=.0775,0.alpha=.5,1.d=.3,1.a=1,1.alpha=.0834,2.a=.3,2.alpha=1,2.beta=.333"
#define ASKED "my.csv", POSE, "--tolerances", TOLERANCES, "--grades"

static string folder;

void setUp(void)
{
    folder = folder_new();
    file_write(string_of("%s/my.csv", folder.text).text,
               string_of("units: mm deg\n" LINKS, "100", "40", "600", "50").text);
    file_write(string_of("%s/metres.csv", folder.text).text,
               string_of("units: m deg\n" LINKS, "-0.1", "0.04", "0.6", "0.05").text);
}

void tearDown(void)
{
    process_clean_up();
}

static void check_table(const process *process, const char *const rows[], size_t n)
{
    for (size_t i = 0; i < n; i++) {
        check_says(process, rows[i]);
    }
}

/*
 * 40 mm: IT10 100 micrometres, IT11 160. 100 mm: IT7 35. 107.7 mm: IT9 87, and 0.045051 is hypot(100.0175, 40.0775) -
 * hypot(100, 40). 600 mm: f 0.3. 50 mm: IT12 250 and IT13 390; f 0.15, m 0.3.
 */
static void test_grades_are_told(void)
{
    static const char *const rows[] = {
        "\n  link        of  nominal  tolerance  unit          ISO 286       ISO 2768\n",
        "\n  0            d       40     0.0775    mm             IT10              -\n",
        "\n  0            a      100     0.0175    mm              IT7              -\n",
        "\n  0        alpha       30        0.5   deg                -   m over 10 mm\n",
        "\n  0     distance  107.703   0.045051    mm              IT9              -\n",
        "\n  1            d      600        0.3    mm      over 500 mm              f\n",
        "\n  1            a        0          1    mm           size 0              -\n",
        "\n  1        alpha       90     0.0834   deg                -  m over 400 mm\n",
        "\n  2            a       50        0.3    mm  wider than IT12              m\n",
        "\n  2        alpha        0          1   deg                -              m\n",
        "\n  2         beta        0      0.333   deg                -  m over 120 mm\n",
        "\nISO 286: the widest of the grades IT5 to IT12 with half its width within the\ntolerance",
    };
    process process;
    run_well(&process, folder.text, (const char *const[]){ASKED, NULL});
    check_table(&process, rows, sizeof rows / sizeof rows[0]);
    TEST_ASSERT_NULL(strstr(process.output.bytes, "\n  2     distance")); /* a slide has none */
    run_well(&process, folder.text, (const char *const[]){"my.csv", POSE, "--tolerances", TOLERANCES, NULL});
    TEST_ASSERT_NULL(strstr(process.output.bytes, "IT"));
}

/* Sizes are in mm whatever the arm's unit and the user's are; a length below 0 is as long. */
static void test_units(void)
{
    process process;
    run_well(&process, folder.text,
             (const char *const[]){"metres.csv", POSE, "--mm", "--tolerances", TOLERANCES, "--grades", NULL});
    check_says(&process, "\n  0            a     -100     0.0175    mm              IT7              -\n");
    check_says(&process, "\n  1            d      600        0.3    mm      over 500 mm              f\n");
    run_well(&process, folder.text,
             (const char *const[]){"metres.csv", POSE, "--inches", "--tolerances", "0.a=.000688976378,1.d=.0118110237",
                                   "--grades", NULL});
    check_says(&process, "\n  0            a  -3.93701  0.000688976    in             IT7         -\n");
}

/* Parallel axes are |a| apart, whatever d is: 100 mm, IT5 15 micrometres. */
static void test_parallel_axes(void)
{
    process process;
    file_write(string_of("%s/flat.csv", folder.text).text,
               "units: mm deg\njoint,kind,a,alpha,d,theta\ntheta,ppr,-100,0,70,0\ntheta,npr,0,0,0,0\n");
    run_well(&process, folder.text, (const char *const[]){"flat.csv", "--joints", "0,0", "--tolerances", "0.a=.0074",
                                                          "--grades", NULL});
    check_says(&process, "\n  0            a     -100     0.0074    mm  finer than IT5         -\n");
    check_says(&process, "\n  0     distance      100     0.0074    mm  finer than IT5         -\n");
}

static void test_csv_is_read_again(void)
{
    process process;
    run_well(&process, folder.text, (const char *const[]){ASKED, "--csv", NULL});
    static const char *const lines[] = {
        "link,kind,parameter,role,nominal,tolerance,unit,iso_286,iso_2768\n",
        "\n0,npr,theta,motor,10,0,deg,,\n",
        "\n0,npr,a,machining,100,0.0175,mm,IT7,\n",
        "\n0,npr,alpha,machining,30,0.5,deg,,\"m over 10 mm\"\n",
        "\n1,npr,d,machining,600,0.3,mm,\"over 500 mm\",f\n",
    };
    check_table(&process, lines, sizeof lines / sizeof lines[0]);
    file_write(string_of("%s/made.csv", folder.text).text, process.output.bytes);
    run_well(&process, folder.text,
             (const char *const[]){"my.csv", POSE, "--tolerances", "made.csv", "--grades", NULL});
    check_says(&process, "\n  0            a      100     0.0175    mm              IT7              -\n");
}

static void test_json(void)
{
    static const char *const members[] = {
        "\"tolerance\": 0.0175,\n      \"set_by\": \"accuracy\",\n      \"held\": 0,\n      \"grades\": {\n"
        "        \"iso_286\": \"IT7\"\n      }\n",
        "\"grades\": {\n        \"iso_286\": \"over 500 mm\",\n        \"iso_2768\": \"f\"\n      }\n",
        "\"grades\": {\n        \"iso_2768\": \"m\",\n        \"side\": 10\n      }\n",
        "\"distance_grades\": {\n        \"iso_286\": \"IT9\"\n      },\n"
        "      \"angle_grades\": {\n        \"iso_2768\": \"m\",\n        \"side\": 10\n      }\n",
    };
    process process;
    run_well(&process, folder.text, (const char *const[]){ASKED, "--json", NULL});
    check_table(&process, members, sizeof members / sizeof members[0]);
}

/* Of the bounds of 1987 too, which have distances of slides: they have no axis in a place. */
static void test_method_sphere(void)
{
    process process;
    run_well(&process, folder.text,
             (const char *const[]){"my.csv", POSE, "--accuracy", ".5,.5,.5,.1,.1,.1", "--method", "sphere", "--grades",
                                   NULL});
    check_says(&process, "\n  1     distance      600");
    TEST_ASSERT_NULL(strstr(process.output.bytes, "\n  2     distance"));
}

static void answer_drawing(const char *drawing, process *process)
{
    file_write(string_of("%s/drawing.csv", folder.text).text, drawing);
    run_well(process, folder.text,
             (const char *const[]){"metres.csv", POSE, "--inches", "--drawing", "drawing.csv", NULL});
}

/*
 * 107.7 mm: IT7 35 micrometres; 40 mm: IT6 16; 600 mm: f 0.3 mm, 50 mm: 0.15 mm; 10' up to 400 mm; in inches. What is
 * said by name is what is said in numbers.
 */
static void test_a_drawing_by_names_is_that_of_numbers(void)
{
    process named, numbers;
    answer_drawing("link,distance,angle,split,side,seat,position,play\n"
              "0,IT7,.01,a,,2.5,40H6,.0001\nothers,2768-f,2768-f,d,10\n", &named);
    answer_drawing(string_of("link,distance,angle,split\n0,%.17g,%.17g,a\n1,%.17g,%.17g,d\n2,%.17g,%.17g,a\n",
                        0.0175 / 25.4 + (0.016 / 25.4 + 1e-4) / 2,
                        0.01 + (0.016 / 25.4 + 1e-4) / 2.5 * 180 / 3.14159265358979323846, 0.3 / 25.4, 1 / 6.0,
                        0.15 / 25.4, 1 / 6.0).text, &numbers);
    TEST_ASSERT_NOT_NULL(strstr(named.output.bytes, "0.00113515"));
    TEST_ASSERT_EQUAL_STRING(numbers.output.bytes, named.output.bytes);
}

static void check_refused(const char *const arguments[], const char *why)
{
    check_refused_run(folder.text, arguments, why);
}

static void test_where_there_are_no_tolerances(void)
{
    check_refused((const char *const[]){"my.csv", POSE, "--against", "metres.csv", "--grades", NULL},
                  "--grades is for tolerances, which --against and --deviations have not");
    check_refused((const char *const[]){"map", "my.csv", "--plane", "xz", "--range", "0..1,0..1", "--tolerances",
                                        "a=1", "--grades", NULL},
                  "--grades is not for a map");
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_grades_are_told);
    RUN_TEST(test_units);
    RUN_TEST(test_parallel_axes);
    RUN_TEST(test_csv_is_read_again);
    RUN_TEST(test_json);
    RUN_TEST(test_method_sphere);
    RUN_TEST(test_a_drawing_by_names_is_that_of_numbers);
    RUN_TEST(test_where_there_are_no_tolerances);
    return UNITY_END();
}
