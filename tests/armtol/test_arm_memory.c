/* Memory that runs out, at every place where it can: a message, and nothing is kept. Built with the linker's --wrap. */

#include "armtol/lists/lists.h"
#include "armtol/tables/arm_file.h"
#include "armtol/tables/arm_laying.h"
#include "console/message.h"

#include "support/said.h"
#include "support/short_memory.h"

#include "unity.h"

#include <stdlib.h>
#include <string.h>

void setUp(void)
{
}

void tearDown(void)
{
}

/* Reads, and frees what it has read. */
typedef bool reader(FILE *stream);

/* With no allocation that succeeds, with one, with two ... until there are enough. */
static void check_lack(reader *read, const char *text, memory_lack lack, long least)
{
    bool fine = false;
    long n = 0;
    for (; !fine; n++) {
        FILE *stream = stream_of(text, strlen(text));
        said said;
        said_begin();
        memory_is_left(n, lack);
        fine = read(stream);
        TEST_ASSERT_TRUE(fine != memory_was_short());
        memory_is_enough();
        said_end(&said);
        fclose(stream);
        TEST_ASSERT_EQUAL_STRING(fine ? "" : "armtol: out of memory\n", said.text);
    }
    TEST_ASSERT_TRUE(n > least);
}

static void check_out_of_memory(reader *read, const char *text, long least)
{
    for (memory_lack lack = LACK_FOR_GOOD; lack < LACKS; lack++) {
        check_lack(read, text, lack, least);
    }
}

static bool read_arm(FILE *stream)
{
    arm_model model;
    const bool fine = arm_file_read(stream, "arm.csv", &model);
    arm_model_free(&model);
    return fine;
}

static void test_arm(void)
{
    static const char rest[] = "units: mm rad\n"
                               "joint,a,alpha,d,theta,beta,low,high,backlash,compliance,moment,kind,,,,,,\n"
                               "d,0,0,0,0\nd,0,0,0,0\nd,0,0,0,0\nd,0,0,0,0\nd,0,0,0,0\n"
                               "d,0,0,0,0\nd,0,0,0,0\nd,0,0,0,0\nd,0,0,0,0\nd,0,0,0,0\n";
    static char text[4000] = "name: n\ntitle: t\nsource: s\n# ";
    memset(text + strlen(text), '#', 1000); /* the line's memory has to grow */
    strcat(text, "\n");
    strcat(text, rest);
    check_out_of_memory(read_arm, text, 15);
    check_out_of_memory(read_arm, rest, 10);
    memset(text, '#', 256); /* it has to grow for the zero behind the line */
    text[256] = '\n';
    strcpy(text + 257, rest);
    check_out_of_memory(read_arm, text, 10);
    check_out_of_memory(read_arm, "units: mm rad\nname,joint,a,alpha,d,theta\none,d,0,0,0,0\ntwo,d,0,0,0,0\n", 12);
}

static bool read_laid(FILE *stream)
{
    arm_model model;
    const bool fine = arm_file_read(stream, "far.csv", &model) && arm_laying_gather(&model);
    arm_model_free(&model);
    return fine;
}

/* Two axes 300 apart and 0.05 degrees from parallel, in plain Denavit-Hartenberg: frames far off the arm. */
static void test_an_arm_laid_anew(void)
{
    static const char far[] = "units: mm deg\njoint a alpha d theta mass\n"
                              "theta 0 0.05 -343774.5898120269 90 2\ntheta 250 0 343774.7207117291 -90 3\n";
    static const char named[] = "units: mm deg\nname joint a alpha d theta\n"
                                "one theta 0 0.05 -343774.5898120269 90\ntwo theta 250 0 343774.7207117291 -90\n";
    check_out_of_memory(read_laid, far, 20);
    check_out_of_memory(read_laid, named, 20);
}

/* Read, and shown in the same order. */
static bool read_craig(FILE *stream)
{
    arm_model model;
    bool fine = arm_file_read(stream, "arm.csv", &model);
    FILE *const shown = fine ? fopen("/dev/null", "w") : NULL;
    if (shown != NULL) {
        fine = arm_file_write(&model.arm, ORDER_CRAIG, UNIT_RADIAN, shown);
        fclose(shown);
    }
    arm_model_free(&model);
    return fine;
}

static void test_a_table_in_craigs_order(void)
{
    check_out_of_memory(read_craig,
                        "name: n\norder: craig\nunits: mm rad\njoint,a,alpha,d,theta,couple\n"
                        "theta,1,2,0,0\ntheta,0,0,0,0,0\nfixed,3,0,0,0\n",
                        20);
}

static bool read_poses(FILE *stream)
{
    double *poses;
    size_t n_poses;
    const bool fine = poses_read(stream, "poses.csv", 1, &poses, &n_poses);
    free(poses);
    return fine;
}

static void test_poses(void)
{
    check_out_of_memory(read_poses, "1\n2\n3\n4\n5\n6\n7\n8\n9\n10\n11\n12\n13\n14\n15\n16\n17\n", 4);
}

static bool read_wishes(FILE *stream)
{
    typed_wish *wishes;
    size_t n_wishes;
    const bool fine = wishes_read(stream, "at.csv", &wishes, &n_wishes);
    free(wishes);
    return fine;
}

static void test_positions(void)
{
    check_out_of_memory(read_wishes, "1 2 3\n1 2 3\n1 2 3\n1 2 3\n1 2 3\n1 2 3\n1 2 3\n1 2 3\n1 2 3\n1 2 3\n1 2 3\n"
                                     "1 2 3\n1 2 3\n1 2 3\n1 2 3\n1 2 3\n1 2 3 4 5 6\n", 4);
}

static bool read_parameters(FILE *stream)
{
    static const armtol_link links[] = {{ARMTOL_NPR, ARMTOL_REVOLUTE}};
    static const armtol_column columns[] = {{0, ARMTOL_THETA}, {0, ARMTOL_D}};
    const armtol_arm arm = {.links = links, .n_links = 1};
    const parameter_table table = {&arm, columns, 2, "weight", true};
    double values[2];
    return parameters_read(stream, "weights.csv", &table, false, values);
}

static void test_parameters(void)
{
    check_out_of_memory(read_parameters, "link,parameter,weight\n0,d,1\n0,theta,1\n", 3);
}

static bool read_spreads(FILE *stream)
{
    static const armtol_link links[] = {{ARMTOL_NPR, ARMTOL_REVOLUTE}};
    static const armtol_column columns[] = {{0, ARMTOL_THETA}, {0, ARMTOL_D}};
    const armtol_arm arm = {.links = links, .n_links = 1};
    const parameter_table table = {.arm = &arm, .columns = columns, .n_columns = 2, .value = "distribution"};
    armtol_error_spread spreads[2] = {{ARMTOL_UNIFORM, 0, 0, 0}};
    group_name groups[2] = {{""}};
    return spreads_read(stream, "spread.csv", &table, spreads, groups);
}

static void test_spreads(void)
{
    check_out_of_memory(read_spreads, "link,parameter,distribution\n0,d,ends\n0,theta,normal:3\n", 3);
}

int main(void)
{
    message_start("armtol");
    UNITY_BEGIN();
    RUN_TEST(test_arm);
    RUN_TEST(test_an_arm_laid_anew);
    RUN_TEST(test_a_table_in_craigs_order);
    RUN_TEST(test_poses);
    RUN_TEST(test_positions);
    RUN_TEST(test_parameters);
    RUN_TEST(test_spreads);
    return UNITY_END();
}
