/* Whole runs of armtol with drawings: what they say is taken, told, written, refused. */

#include "armtol/runs.h"
#include "support/check.h"
#include "support/process.h"

#include "unity.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Two parallel axes 100 apart, and one that leans, of 30 and 40. */
#define ARM "units: mm rad\nname,joint,kind,a,alpha,d,theta,beta\n" \
            "upper,theta,ppr,100,0,0,0,0\nlower,theta,npr,30,1,40,0,0\n"
#define AT_0 "my.csv", "--joints", "0,0"
#define DRAWN AT_0, "--drawing", "drawing.csv"

static string folder;

void setUp(void)
{
    folder = folder_new();
    file_write(string_of("%s/my.csv", folder.text).text, ARM);
    file_write(string_of("%s/drawing.csv", folder.text).text,
               "link,distance,angle,split,unit\nupper,.1,.001,-,mm rad\nlower,.2,.002,even,mm rad\n");
}

void tearDown(void)
{
    process_clean_up();
}

static void check_says_all(const process *process, const char *const says[], size_t n)
{
    for (size_t i = 0; i < n; i++) {
        check_says(process, says[i]);
    }
}

static void check_message(const char *expected, const char *const arguments[])
{
    check_refused_line(folder.text, arguments, expected);
}

/* ---- forward ---- */

static void test_a_drawing_is_told(void)
{
    static const char *const says[] = {
        "\nThe drawing drawing.csv, and the accuracy that it gives in this pose; elsewhere\nis unknown.\n",
        "\n  0 upper   ppr          a  machining      100        0.1    mm\n",
        "\n  0 upper   ppr       beta  machining        0      0.001   rad\n",
        "\n  1 lower   npr          d  machining       40   0.142863    mm\n",
        "\n  1 lower   npr      alpha  machining        1      0.002   rad\n",
        "\nalpha and beta are off by no more than that together, in a disc: link 0 (upper)\n",
        "\n  0 upper machining  49.5  100.0  17.4  33.3  100.0  0.0\n",
    };
    process process;
    run_well(&process, folder.text, (const char *const[]){DRAWN, "--budget", NULL});
    check_says_all(&process, says, sizeof says / sizeof says[0]);
}

/* wx: alpha of both links, to first order; of the disc alone its radius. */
static void test_a_disc_counts_once(void)
{
    process process;
    run_well(&process, folder.text, (const char *const[]){DRAWN, "--json", NULL});
    const char *wx = text_after(process.output.bytes, "\"name\": \"wx\"");
    check_within(1e-8, 0.003, strtod(text_after(wx, "\"worst_case\": "), NULL), "wx");
    const char *wy = text_after(process.output.bytes, "\"name\": \"wy\"");
    check_within(1e-8, 0.001, strtod(text_after(wy, "\"worst_case\": "), NULL), "wy");
    check_says(&process, "\"method\": \"given\"");
    check_says(&process, "\"within\": \"disc\"");
    check_says(&process, "\"drawing\": [\n    {\n      \"link\": 0,\n      \"name\": \"upper\",\n"
                         "      \"distance\": 0.1,\n      \"angle\": 0.001,\n      \"split\": \"a\"\n    },");
}

static void test_beside_tolerances(void)
{
    process process;
    run_well(&process, folder.text,
             (const char *const[]){DRAWN, "--tolerances", "theta=.01,lengths=7", "--accuracy", "r=9", "--csv", NULL});
    check_says(&process, "0,ppr,theta,motor,0,0.01,rad,upper\n0,ppr,a,machining,100,0.1,mm,upper\n");
    run_well(&process, folder.text,
             (const char *const[]){DRAWN, "--tolerances", "theta=.01", "--accuracy", "r=9", "--verify", "1000", NULL});
    check_says(&process, "The drawing drawing.csv, with the tolerances of theta=.01, and the accuracy "
                         "that\nthey give in");
    check_says(&process, "1000 of 1000 arms are within the accuracy");
}

/* Given, as --given gives them; what --given says of others holds. */
static void test_beside_an_accuracy(void)
{
    process process;
    run_well(&process, folder.text,
             (const char *const[]){DRAWN, "--accuracy", "r=2,w=.1", "--given", "0.theta=.001,0.a=7", NULL});
    check_says(&process, "\n  0 upper   ppr      theta      motor        0      0.001   rad    given\n"
                         "  0 upper   ppr          a  machining      100        0.1    mm  drawing\n");
    check_says(&process, "\n  1 lower   npr      theta      motor        0 ");
    check_message("no tolerances: what is given uses 101.7 % of w in pose 1: machining of link 0 (upper) 33.9 %, "
                  "machining of link 1 (lower) 67.8 %",
                  (const char *const[]){DRAWN, "--accuracy", "w=.00295", "--given", "theta=0", NULL});
}

static void test_units_of_the_command_line(void)
{
    process process;
    file_write(string_of("%s/d.csv", folder.text).text, "link,distance,angle,unit\n0,.0001,0.1,m deg\n");
    run_well(&process, folder.text,
             (const char *const[]){AT_0, "--metres", "--degrees", "--drawing", "d.csv", "--json", NULL});
    check_says(&process, "\"distance\": 0.0001,\n      \"angle\": 0.1,\n      \"split\": \"a\"");
    check_message("d.csv:2:13: unit \"m deg\"; expected mm rad, as on the command line",
                  (const char *const[]){AT_0, "--drawing", "d.csv", NULL});
}

static void test_maps_have_discs(void)
{
    process process;
    run_well(&process, folder.text,
             (const char *const[]){"map", "my.csv", "--plane", "xy", "--offset", "40", "--range", "120..130,-10..0",
                                   "--grid", "2,2", "--drawing", "drawing.csv", "--tsv", "-", "--of", "wy", NULL});
    check_says(&process, "\t");
}

#define MAP_OF "map", "my.csv", "--plane", "xy", "--offset", "40", "--range", "120..130,-10..0", "--grid", "2,2"

/* Rows of one drawing are not those of another in a file of the same name. */
static void test_shards_of_maps_know_discs(void)
{
    process process;
    const string drawing = string_of("%s/shard.csv", folder.text);
    file_write(drawing.text, "link,angle\n1,.002\n");
    run_well(&process, folder.text, (const char *const[]){MAP_OF, "--drawing", "shard.csv", "--shard", "1/2", "--tally",
                                                          "1.tally", NULL});
    file_write(drawing.text, "link,angle\n0,.002\n");
    run_well(&process, folder.text, (const char *const[]){MAP_OF, "--drawing", "shard.csv", "--shard", "2/2", "--tally",
                                                          "2.tally", NULL});
    run(&process, folder.text, (const char *const[]){"merge", "1.tally", "2.tally", NULL});
    process_check_status(&process, 2, "two drawings");
    TEST_ASSERT_NOT_NULL(strstr(process.errors.bytes, "tolerances"));
}

/* ---- back ---- */

static void test_a_drawing_is_written_and_read(void)
{
    process process;
    run_well(&process, folder.text,
             (const char *const[]){AT_0, "--accuracy", "1,1,1,.01,.01,.01", "--write-drawing", "new.csv", NULL});
    check_says(&process, "The largest tolerances that guarantee the accuracy");
    run_well(&process, folder.text,
             (const char *const[]){AT_0, "--drawing", "new.csv", "--tolerances", "theta=0", "--csv", NULL});
    run_well(&process, folder.text,
             (const char *const[]){AT_0, "--tolerances", "lengths=.1,alpha=.003,beta=.002", "--write-drawing", "-",
                                   NULL});
    static const char written[] = "link,distance,angle,split,unit\n0,0.0999995,0.00199999,a,mm rad\n"
                                  "1,0.139995,0.00299999,even,mm rad\n";
    text_check(written, sizeof written - 1, &process.output, "on standard output");
}

/* Seen from above the slide of a SCARA may lean as it likes. */
static void test_what_has_no_bound_is_a_dash(void)
{
    process process;
    run_well(&process, folder.text, (const char *const[]){"scara", "--joints", "0,1,.1,0", "--accuracy",
                                                          "dx=.02,dy=.02", "--write-drawing", "open.csv", NULL});
    run_well(&process, folder.text,
             (const char *const[]){"scara", "--joints", "0,1,.1,0", "--accuracy", "dx=.02,dy=.02", "--write-drawing",
                                   "-", NULL});
    check_says(&process, ",-,a,mm rad\n3,");
    run_well(&process, folder.text,
             (const char *const[]){"scara", "--joints", "0,1,.1,0", "--drawing", "open.csv", NULL});
}

/* ---- what is refused ---- */

static void test_what_is_refused(void)
{
    check_message("--drawing: none.csv: No such file or directory",
                  (const char *const[]){AT_0, "--drawing", "none.csv", NULL});
    check_message("--given is for tolerances that are asked for; expected --accuracy, or --tolerances beside --drawing",
                  (const char *const[]){DRAWN, "--given", "theta=0", NULL});
    check_message("--weights is for the methods worst and rss",
                  (const char *const[]){DRAWN, "--weights", "theta=2", NULL});
    check_message("--against and --deviations compare two arms; expected no --accuracy, --tolerances, --given, "
                  "--drawing, --weights, --spread, --budget, --verify or --iso9283 beside them",
                  (const char *const[]){DRAWN, "--against", "my.csv", NULL});
    check_message("--write-drawing is not for a map",
                  (const char *const[]){"map", "my.csv", "--plane", "xy", "--range", "1..2,1..2", "--drawing",
                                        "drawing.csv", "--write-drawing", "-", NULL});
    check_message("--svg - and --write-drawing - exclude each other",
                  (const char *const[]){DRAWN, "--budget", "--svg", "-", "--write-drawing", "-", NULL});
    check_message("--region: alpha and beta of a drawing move in a disc, which is not bounded over a region; expected "
                  "poses, or the two in --given or --tolerances, as a square",
                  (const char *const[]){"my.csv", "--region", "q1=0..1;q2=0..1", "--drawing", "drawing.csv", NULL});
}

/* The upper arm may be 0.1 longer, all along dx, which has 0.05. */
static void test_a_drawing_that_is_too_coarse(void)
{
    file_write(string_of("%s/d.csv", folder.text).text, "link,distance\nupper,.1\n");
    check_message("no tolerances: what is given uses 200 % of dx in pose 1: machining of link 0 (upper) 200 %",
                  (const char *const[]){AT_0, "--drawing", "d.csv", "--accuracy", ".05,-,-,-,-,-", NULL});
}

/* The drawing holds to both sides: not about the middle that the table says of the same a, but of what is on paper. */
static void test_a_drawing_has_no_mean(void)
{
    process process;
    file_write(string_of("%s/ends.csv", folder.text).text, "link,parameter,upper,lower\n0,a,.3,.1\n");
    run_well(&process, folder.text, (const char *const[]){DRAWN, "--tolerances", "ends.csv", NULL});
    check_says(&process, "\n  0 upper   ppr          a  machining      100        0.1    mm\n");
    run_well(&process, folder.text, (const char *const[]){DRAWN, "--tolerances", "ends.csv", "--csv", NULL});
    TEST_ASSERT_NULL(strstr(process.output.bytes, "shift"));
    check_message("--write-drawing: the mean of a of link 0 (upper) is not 0, and a drawing says the same to both "
                  "sides; expected no shift, and no upper and lower that differ",
                  (const char *const[]){AT_0, "--tolerances", "ends.csv", "--write-drawing", "-", NULL});
    file_write(string_of("%s/motors.csv", folder.text).text, "link,parameter,shift\n0,theta,.1\n");
    run_well(&process, folder.text,
             (const char *const[]){AT_0, "--accuracy", "1,1,1,1,1,1", "--drawing", "drawing.csv", "--tolerances",
                                   "theta=.001", "--spread", "motors.csv", "--write-drawing", "-", NULL});
    check_says(&process, "link,distance,angle,split,unit\n0,0.09999"); /* motors are in no drawing */
}

static void test_a_distance_beyond_doubles(void)
{
    file_write(string_of("%s/d.csv", folder.text).text, "link,distance\n0,1e306\n");
    check_message("--drawing: d.csv: the distance of link 0 (upper) is too large",
                  (const char *const[]){AT_0, "--metres", "--drawing", "d.csv", NULL});
    file_write(string_of("%s/d.csv", folder.text).text, "link,distance\n0,1e300\n");
    check_message("--drawing: d.csv: the distance of link 0 (upper) is too large",
                  (const char *const[]){AT_0, "--drawing", "d.csv", NULL});
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_drawing_is_told);
    RUN_TEST(test_a_disc_counts_once);
    RUN_TEST(test_beside_tolerances);
    RUN_TEST(test_beside_an_accuracy);
    RUN_TEST(test_units_of_the_command_line);
    RUN_TEST(test_maps_have_discs);
    RUN_TEST(test_shards_of_maps_know_discs);
    RUN_TEST(test_a_drawing_is_written_and_read);
    RUN_TEST(test_what_has_no_bound_is_a_dash);
    RUN_TEST(test_what_is_refused);
    RUN_TEST(test_a_drawing_that_is_too_coarse);
    RUN_TEST(test_a_drawing_has_no_mean);
    RUN_TEST(test_a_distance_beyond_doubles);
    return UNITY_END();
}
