/* Lists of poses, and tables with a value for every parameter: what is read, and every message with its place. */

#include "armtol/lists/lists.h"
#include "console/message.h"

#include "support/check.h"
#include "support/random.h"
#include "support/said.h"

#include "unity.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void setUp(void)
{
}

void tearDown(void)
{
}

/* ---- poses ---- */

static bool read_poses(const char *bytes, size_t length, size_t n_joints, double **poses, size_t *n_poses, said *said)
{
    FILE *stream = stream_of(bytes, length);
    said_begin();
    const bool fine = poses_read(stream, "poses.csv", n_joints, poses, n_poses);
    said_end(said);
    fclose(stream);
    return fine;
}

/* Two poses of three joints: 1 -2 0.5, 4 5 600. */
static void check_poses(const char *text)
{
    static const double expected[] = {1, -2, 0.5, 4, 5, 600};
    double *poses;
    size_t n_poses;
    said said;
    const bool fine = read_poses(text, strlen(text), 3, &poses, &n_poses, &said);
    TEST_ASSERT_EQUAL_STRING_MESSAGE("", said.text, text);
    TEST_ASSERT_TRUE_MESSAGE(fine, text);
    TEST_ASSERT_EQUAL_UINT_MESSAGE(2, n_poses, text);
    for (size_t i = 0; i < sizeof expected / sizeof expected[0]; i++) {
        check_same(expected[i], poses[i], "value %zu of %s", i, text);
    }
    free(poses);
}

static void test_poses(void)
{
    check_poses("1 -2 0.5\n4 5 600\n");
    check_poses("# remark\n\n  1, -2.0 ,5e-1 # remark\r\n\r\n4,5,600");
    check_poses("\xef\xbb\xbf" "1;-2;0,5;;\r\n;;;;\r\n\"4\";5;600,0;\r\n\"# one; two\";;;;\r\n");
    check_poses("1\t-2\t0,5\r4\t5\t600\r");
    check_poses("1 -2 0.5\n4;5;6e2"); /* each line says for itself what is between its values */
}

static void test_many_poses(void)
{
    enum { POSES = 5000, LENGTH = 32 };
    char *text = calloc(POSES, LENGTH);
    TEST_ASSERT_NOT_NULL(text);
    size_t length = 0, n_poses;
    for (int i = 0; i < POSES; i++) {
        length += (size_t)snprintf(text + length, LENGTH, "%d,%d\n", i, -i);
    }
    double *poses;
    said said;
    TEST_ASSERT_TRUE(read_poses(text, length, 2, &poses, &n_poses, &said));
    TEST_ASSERT_EQUAL_UINT(POSES, n_poses);
    for (int i = 0; i < POSES; i++) {
        check_same(i, poses[2 * i], "pose %d", i);
        check_same(-i, poses[2 * i + 1], "pose %d", i);
    }
    free(poses);
    free(text);
}

static void check_poses_refused(const char *expected, const char *text)
{
    double *poses;
    size_t n_poses;
    said said;
    char line[1100];
    const bool fine = read_poses(text, strlen(text), 3, &poses, &n_poses, &said);
    snprintf(line, sizeof line, "armtol: poses.csv:%s\n", expected);
    TEST_ASSERT_EQUAL_STRING_MESSAGE(line, said.text, text);
    TEST_ASSERT_FALSE_MESSAGE(fine, text);
    TEST_ASSERT_NULL(poses);
    TEST_ASSERT_EQUAL_UINT(0, n_poses);
}

static void test_a_wrong_pose_of_one_joint(void)
{
    double *poses;
    size_t n_poses;
    said said;
    TEST_ASSERT_FALSE(read_poses("1\nx\n", 4, 1, &poses, &n_poses, &said));
    TEST_ASSERT_EQUAL_STRING("armtol: poses.csv:2:1: \"x\" is not a number; expected the values of 1 joint\n",
                             said.text);
}

static void test_wrong_poses(void)
{
    check_poses_refused(" no poses; expected a line of 3 joint values for each", "");
    check_poses_refused(" no poses; expected a line of 3 joint values for each", "# none\n;;\n");
    check_poses_refused("2:5: 2 values; expected 3, one for each joint", "1 2 3\n4 5 # 6\n");
    check_poses_refused("1:2: 1 value; expected 3, one for each joint", "1\n");
    check_poses_refused("1:7: 4 values; expected 3, one for each joint", "1;2;3;4;;\n");
    check_poses_refused("1:3: \"\" is not a number; expected the values of 3 joints", "1,,3\n");
    check_poses_refused("1:1: \"q1\" is not a number; expected the values of 3 joints", "q1,q2,q3\n1,2,3\n");
    check_poses_refused("2:3: \"inf\" is not a finite number; expected the values of 3 joints", "1,2,3\n1,inf,3\n");
    check_poses_refused("1:5: \"1e400\" is too large a number; expected the values of 3 joints", "1 2 1e400\n");
    check_poses_refused("1:3: \"90deg\" is not a number; expected the values of 3 joints", "0 90deg 0\n");
    check_poses_refused("1:4: the quoted cell does not end on this line", "1, \"2, 3\n");
}

/* ---- positions ---- */

static bool read_wishes(const char *text, typed_wish **wishes, size_t *n_wishes, said *said)
{
    FILE *stream = stream_of(text, strlen(text));
    said_begin();
    const bool fine = wishes_read(stream, "at.csv", wishes, n_wishes);
    said_end(said);
    fclose(stream);
    return fine;
}

/* Two positions, the second without angles. */
static void check_wishes(const char *text)
{
    static const double first[] = {1, -2, 0.5, 10, 20, -30}, second[] = {4, 5, 600};
    typed_wish *wishes;
    size_t n_wishes;
    said said;
    const bool fine = read_wishes(text, &wishes, &n_wishes, &said);
    TEST_ASSERT_EQUAL_STRING_MESSAGE("", said.text, text);
    TEST_ASSERT_TRUE_MESSAGE(fine, text);
    TEST_ASSERT_EQUAL_UINT_MESSAGE(2, n_wishes, text);
    TEST_ASSERT_EQUAL_UINT(6, wishes[0].n);
    TEST_ASSERT_EQUAL_UINT(3, wishes[1].n);
    for (size_t i = 0; i < 6; i++) {
        check_same(first[i], wishes[0].value[i], "value %zu of %s", i, text);
        check_same(i < 3 ? second[i] : 0, wishes[1].value[i], "value %zu of %s", i, text);
    }
    free(wishes);
}

static void test_positions(void)
{
    check_wishes("1 -2 0.5 10 20 -30\n4 5 600\n");
    check_wishes("# x, y, z\n1,-2,.5,10,20,-30 # down\r\n\r\n4, 5, 6e2");
    check_wishes("\xef\xbb\xbf" "1;-2;0,5;10;20;-30;;\r\n4;5;600,0\r\n");
}

static void check_wishes_refused(const char *expected, const char *text)
{
    typed_wish *wishes;
    size_t n_wishes;
    said said;
    char line[1100];
    const bool fine = read_wishes(text, &wishes, &n_wishes, &said);
    snprintf(line, sizeof line, "armtol: at.csv:%s; expected x y z, or x y z gamma beta alpha%s\n", expected,
             expected[0] == ' ' ? " in a line for each" : "");
    TEST_ASSERT_EQUAL_STRING_MESSAGE(line, said.text, text);
    TEST_ASSERT_FALSE_MESSAGE(fine, text);
    TEST_ASSERT_NULL(wishes);
    TEST_ASSERT_EQUAL_UINT(0, n_wishes);
}

static void test_wrong_positions(void)
{
    check_wishes_refused(" no positions", "");
    check_wishes_refused(" no positions", "# none\n;;\n");
    check_wishes_refused("1:2: 1 value", "1\n");
    check_wishes_refused("2:8: 4 values", "1 2 3\n1 2 3 4\n");
    check_wishes_refused("1:13: 7 values", "1 2 3 4 5 6 7\n");
    check_wishes_refused("2:3: \"y\" is not a number", "1 2 3\n1 y 3\n");
    check_wishes_refused("1:1: \"nan\" is not a finite number", "nan,2,3\n");
}

/* ---- parameters ---- */

static const armtol_link links[] = {{ARMTOL_NPR, ARMTOL_REVOLUTE}, {ARMTOL_PPR, ARMTOL_REVOLUTE}};

enum { COLUMNS = 8 }; /* 0: theta d a alpha, 1: theta a alpha beta */
static armtol_column columns[COLUMNS];

static bool read_parameters(const char *bytes, size_t length, bool zero, bool infinite, double values[], said *said)
{
    const parameter_table table = {&(armtol_arm){.links = links, .n_links = 2}, columns, COLUMNS, "tolerance", zero,
                                   .length_unit = "mm", .angle_unit = "rad"};
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_columns(links, 2, columns, COLUMNS));
    FILE *stream = stream_of(bytes, length);
    said_begin();
    const bool fine = parameters_read(stream, "given.csv", &table, infinite, values);
    said_end(said);
    fclose(stream);
    return fine;
}

static void check_parameters(const double expected[COLUMNS], const char *text, bool zero, bool infinite)
{
    double values[COLUMNS] = {-1, -1, -1, -1, -1, -1, -1, -1};
    said said;
    const bool fine = read_parameters(text, strlen(text), zero, infinite, values, &said);
    TEST_ASSERT_EQUAL_STRING_MESSAGE("", said.text, text);
    TEST_ASSERT_TRUE_MESSAGE(fine, text);
    for (size_t k = 0; k < COLUMNS; k++) {
        check_same(expected[k], values[k], "column %zu of %s", k, text);
    }
}

static void test_parameters(void)
{
    static const double every[COLUMNS] = {0.5, 1, 2, 3, 4, 5, 6, 7e-3};
    static const double some[COLUMNS] = {-1, -1, -1, 2, -1, -1, -1, 9};
    const double free_ones[COLUMNS] = {-1, (double)INFINITY, -1, -1, (double)INFINITY, 8, -1, -1};
    check_parameters(every, "link,kind,parameter,role,nominal,tolerance,unit\n"
                            "0,npr,theta,motor,0,0.5,rad\n0,npr,d,machining,0,1,mm\n0,npr,a,machining,0,2,mm\n"
                            "0,npr,alpha,machining,0,3,rad\n1,ppr,theta,motor,0,4,rad\n1,ppr,a,machining,0,5,mm\n"
                            "1,ppr,alpha,machining,0,6,rad\n1,ppr,beta,machining,0,7e-3,rad\n", true, false);
    check_parameters(some, "\xef\xbb\xbfParameter;Link;Tolerance;;\r\nBETA;1;9,0;;\r\n;;;;\r\nalpha;00;2;;", false,
                     true);
    check_parameters(free_ones, "link tolerance parameter\n0 - d # free\n1 inf theta\n1 8 a\n", false, true);
}

static void check_parameters_refused(const char *expected, const char *text)
{
    double values[COLUMNS];
    said said;
    char line[1100];
    const bool fine = read_parameters(text, strlen(text), false, false, values, &said);
    snprintf(line, sizeof line, "armtol: given.csv:%s\n", expected);
    TEST_ASSERT_EQUAL_STRING_MESSAGE(line, said.text, text);
    TEST_ASSERT_FALSE_MESSAGE(fine, text);
}

/* ---- ends of tolerances ---- */

static bool read_ends(const char *text, double values[], double means[], said *said)
{
    const parameter_table table = {&(armtol_arm){.links = links, .n_links = 2}, columns, COLUMNS, "tolerance", true,
                                   .means = means};
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_columns(links, 2, columns, COLUMNS));
    FILE *stream = stream_of(text, strlen(text));
    said_begin();
    const bool fine = parameters_read(stream, "ends.csv", &table, true, values);
    said_end(said);
    fclose(stream);
    return fine;
}

/* +a/-b: half of a + b about the middle of a and -b. */
static void test_ends_of_tolerances(void)
{
    double values[COLUMNS] = {0}, means[COLUMNS] = {0};
    said said;
    TEST_ASSERT_TRUE(read_ends("upper,link,parameter,lower\n0.5,0,d,-0.25\n-1,0,a,-2\n0.125,1,alpha,0.125\n", values,
                               means, &said));
    const double half[COLUMNS] = {0, 0.375, 0.5}, middle[COLUMNS] = {0, 0.125, -1.5, 0, 0, 0, 0.125};
    for (size_t k = 0; k < COLUMNS; k++) {
        check_same(half[k], values[k], "half of column %zu", k);
        check_same(middle[k], means[k], "middle of column %zu", k);
    }
    TEST_ASSERT_TRUE(read_ends("link,parameter,tolerance\n0,d,3\n", values, means, &said));
    check_same(3, values[1], "without ends");
}

static void check_ends_refused(const char *expected, const char *text)
{
    double values[COLUMNS], means[COLUMNS];
    said said;
    TEST_ASSERT_FALSE_MESSAGE(read_ends(text, values, means, &said), text);
    TEST_ASSERT_EQUAL_STRING_MESSAGE(expected, said.text, text);
}

static void test_wrong_ends_of_tolerances(void)
{
    check_ends_refused("armtol: ends.csv:2:5: upper: 0.1 is below lower, 0.2; expected both with their signs, as in "
                       "0.1 and -0.05\n", "link,parameter,upper,lower\n0,d,0.1,0.2\n");
    check_ends_refused("armtol: ends.csv:1:1: the head row has no column \"lower\"; expected link, parameter, "
                       "tolerance\n", "link,parameter,upper\n0,d,0.1\n");
    check_ends_refused("armtol: ends.csv:1:1: columns for tolerance and for its ends; expected either tolerance, or "
                       "upper and lower\n", "link,parameter,tolerance,lower\n0,d,0.1,0\n");
    check_ends_refused("armtol: ends.csv:2:9: lower: \"x\" is not a number\n",
                       "link,parameter,upper,lower\n0,d,0.1,x\n");
    check_ends_refused("armtol: ends.csv:2:5: upper: \"inf\" is not a finite number\n",
                       "link,parameter,upper,lower\n0,d,inf,x\n");
    check_ends_refused("armtol: ends.csv:2:8: no value for \"lower\"\n", "link,parameter,upper,lower\n0,d,0.1\n");
}

/* ---- distributions ---- */

static bool read_spreads(const char *text, armtol_error_spread spreads[], group_name groups[], said *said)
{
    const parameter_table table = {.arm = &(armtol_arm){.links = links, .n_links = 2}, .columns = columns,
                                   .n_columns = COLUMNS, .value = "distribution", .length_unit = "mm",
                                   .angle_unit = "rad"};
    memset(spreads, 0, COLUMNS * sizeof *spreads);
    memset(groups, 0, COLUMNS * sizeof *groups);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_columns(links, 2, columns, COLUMNS));
    FILE *stream = stream_of(text, strlen(text));
    said_begin();
    const bool fine = spreads_read(stream, "spread.csv", &table, spreads, groups);
    said_end(said);
    fclose(stream);
    return fine;
}

static void check_spread(armtol_error_spread expected, armtol_error_spread actual)
{
    TEST_ASSERT_EQUAL_INT(expected.distribution, actual.distribution);
    TEST_ASSERT_EQUAL_INT(expected.group, actual.group);
    check_same(expected.sigmas, actual.sigmas, "sigmas");
    check_same(expected.shift, actual.shift, "shift");
}

static void test_distributions(void)
{
    armtol_error_spread spreads[COLUMNS];
    group_name groups[COLUMNS];
    said said;
    TEST_ASSERT_TRUE(read_spreads("group;link;parameter;shift;distribution;unit\nmill;0;d;-0,5;normal:2.5;mm\n"
                                  "-;0;theta;;ends;rad\nlathe;1;a;-;triangular;mm\nmill;1;beta;2\n", spreads, groups,
                                  &said));
    check_spread((armtol_error_spread){ARMTOL_ENDS, 0, 0, 0}, spreads[0]);
    check_spread((armtol_error_spread){ARMTOL_NORMAL, 2.5, -0.5, 1}, spreads[1]);
    check_spread((armtol_error_spread){ARMTOL_UNIFORM, 0, 0, 0}, spreads[2]);
    check_spread((armtol_error_spread){ARMTOL_TRIANGULAR, 0, 0, 2}, spreads[5]);
    check_spread((armtol_error_spread){ARMTOL_UNIFORM, 0, 2, 1}, spreads[7]);
    TEST_ASSERT_EQUAL_STRING("mill", groups[0].text);
    TEST_ASSERT_EQUAL_STRING("lathe", groups[1].text);
    TEST_ASSERT_TRUE(read_spreads("link,parameter,shift\n0,a,7\n", spreads, groups, &said));
    check_spread((armtol_error_spread){ARMTOL_UNIFORM, 0, 7, 0}, spreads[2]);
}

static void check_spreads_refused(const char *expected, const char *text)
{
    armtol_error_spread spreads[COLUMNS];
    group_name groups[COLUMNS];
    said said;
    char line[300];
    TEST_ASSERT_FALSE_MESSAGE(read_spreads(text, spreads, groups, &said), text);
    snprintf(line, sizeof line, "armtol: spread.csv:%s\n", expected);
    TEST_ASSERT_EQUAL_STRING_MESSAGE(line, said.text, text);
}

#define EXPECTED "expected uniform, normal:K (K from 0.01 to 30), triangular or ends"

static void test_wrong_distributions(void)
{
    static const char *const wrong[] = {"normal", "normal:", "normal:0", "normal:31", "normal:x", "ends:3", "even",
                                        "norm:3", "normal:3:4"};
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        char text[80], expected[160];
        snprintf(text, sizeof text, "link,parameter,distribution\n0,d,%s\n", wrong[i]);
        snprintf(expected, sizeof expected, "2:5: unknown distribution \"%s\"; " EXPECTED, wrong[i]);
        check_spreads_refused(expected, text);
    }
    check_spreads_refused("1:1: the head row has no column \"distribution\", \"shift\" or \"group\"",
                          "link,parameter,tolerance\n0,d,1\n");
    check_spreads_refused("2:5: shift: \"1e999\" is too large a number", "link,parameter,shift\n0,d,1e999\n");
    check_spreads_refused("2:5: group: \"abcdefghijklmnopqrstuvwxyzabcdef\" is too long; expected at most 31 "
                          "characters",
                          "link,parameter,group\n0,d,abcdefghijklmnopqrstuvwxyzabcdef\n");
    check_spreads_refused("2:5: unit \"m\"; expected mm, as on the command line",
                          "link,parameter,unit,shift\n0,d,m,1\n");
}

#define HEAD "link,parameter,tolerance\n"

static void test_wrong_heads_of_parameters(void)
{
    check_parameters_refused(" no table; expected a head row with link, parameter, tolerance", "# none");
    check_parameters_refused("1:1: the head row has no column \"tolerance\"; expected link, parameter, tolerance",
                             "link,parameter,weight\n");
    check_parameters_refused("1:1: the head row has no column \"link\"; expected link, parameter, tolerance",
                             "0,theta,1\n");
    check_parameters_refused("1:16: a second column \"parameter\"", "link,parameter,Parameter,tolerance\n");
}

static void test_wrong_rows_of_parameters(void)
{
    check_parameters_refused("2:1: link \"2\": expected a whole number from 0 to 1, the last link", HEAD "2,theta,1\n");
    check_parameters_refused("2:1: link \"-1\": expected a whole number from 0 to 1, the last link", HEAD "-1,d,1\n");
    check_parameters_refused("2:1: link \"18446744073709551616\": expected a whole number from 0 to 1, the last link",
                             HEAD "18446744073709551616,theta,1\n");
    check_parameters_refused("2:1: link \"0.0\": expected a whole number from 0 to 1, the last link", HEAD "0.0,d,1\n");
    check_parameters_refused("2:3: link 0, of kind npr, has no parameter \"beta\"; expected theta, d, a, alpha",
                             HEAD "0,beta,1\n");
    check_parameters_refused("3:3: link 1, of kind ppr, has no parameter \"gamma\"; expected theta, a, alpha, beta",
                             HEAD "0,a,1\n1,gamma,1\n");
    check_parameters_refused("2:9: unit \"deg\"; expected rad, as on the command line",
                             "link,parameter,unit,tolerance\n0,alpha,deg,1\n");
    check_parameters_refused("4:1: d of link 0 a second time; the first is in line 2", HEAD "0,d,1\n\n0,d,1\n");
    check_parameters_refused("2:5: tolerance: \"-2\" is not greater than zero", HEAD "0,d,-2\n");
    check_parameters_refused("2:5: tolerance: \"-\" is not a number", HEAD "0,d,-\n");
    check_parameters_refused("2:5: tolerance: \"inf\" is not a finite number", HEAD "0,d,inf\n");
    check_parameters_refused("2:5: tolerance: \"1mm\" is not a number", HEAD "0,d,1mm\n");
    check_parameters_refused("2:4: no value for \"tolerance\"", HEAD "0,d\n");
    check_parameters_refused("2:3: no value for \"parameter\"", HEAD "0,,1\n");
}

/* The reader has -1 in the places of all before it reads. */
static void test_what_has_no_row_stays_and_zero_is_exact(void)
{
    const double exact[COLUMNS] = {1, -1, 0, -1, -1, -1, -1, -1};
    check_parameters(exact, HEAD "0,theta,1\n0,a,0\n", true, false);
    check_parameters_refused("2:5: tolerance: \"0\" is not greater than zero", HEAD "0,d,0\n");
}

/* ---- anything at all ---- */

static void check_said(bool fine, const said *said, const char *path)
{
    if (fine) {
        TEST_ASSERT_EQUAL_STRING("", said->text);
    } else {
        TEST_ASSERT_EQUAL_STRING_LEN(path, said->text, strlen(path));
        TEST_ASSERT_EQUAL_PTR(strrchr(said->text, '\n'), strchr(said->text, '\n'));
    }
}

static void test_anything_at_all(void)
{
    static const char alphabet[] = "\n\r\t ,;#\"-.:01eainf\xff";
    static const char seed[] = "link,parameter,tolerance\n0,\"d\",1\n1;a;2,5;\n1 2 3\n0,alpha,-\n";
    random_source random = {11};
    for (int i = 0; i < TEST_FUZZ; i++) {
        char text[sizeof seed];
        double values[COLUMNS], *poses;
        size_t n_poses;
        said said;
        memcpy(text, seed, sizeof seed);
        for (int k = (int)random_between(&random, 0, 8); k > 0; k--) {
            text[(size_t)random_between(&random, 0, sizeof seed - 1)] =
                alphabet[(size_t)random_between(&random, 0, sizeof alphabet)];
        }
        const bool parameters = read_parameters(text, sizeof seed - 1, false, i % 2 == 0, values, &said);
        check_said(parameters, &said, "armtol: given.csv:");
        const size_t first = i % 2 == 0 ? 0 : strlen("link,parameter,tolerance\n");
        const bool posed = read_poses(text + first, sizeof seed - 1 - first, 3, &poses, &n_poses, &said);
        check_said(posed, &said, "armtol: poses.csv:");
        free(poses);
    }
}

int main(void)
{
    message_start("armtol");
    UNITY_BEGIN();
    RUN_TEST(test_poses);
    RUN_TEST(test_many_poses);
    RUN_TEST(test_a_wrong_pose_of_one_joint);
    RUN_TEST(test_wrong_poses);
    RUN_TEST(test_positions);
    RUN_TEST(test_wrong_positions);
    RUN_TEST(test_parameters);
    RUN_TEST(test_ends_of_tolerances);
    RUN_TEST(test_wrong_ends_of_tolerances);
    RUN_TEST(test_distributions);
    RUN_TEST(test_wrong_distributions);
    RUN_TEST(test_wrong_heads_of_parameters);
    RUN_TEST(test_wrong_rows_of_parameters);
    RUN_TEST(test_what_has_no_row_stays_and_zero_is_exact);
    RUN_TEST(test_anything_at_all);
    return UNITY_END();
}
