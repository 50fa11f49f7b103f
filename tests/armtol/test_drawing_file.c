/* Drawings of links: what is read, and every message with its place. */

#include "armtol/drawing/drawing_file.h"
#include "console/message.h"

#include "support/check.h"
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

static const double pi = 3.14159265358979323846;

/*
 * An arm with a link of every sort: 0 has a and d to be made, 1 parallel axes, 2 slides and is not parallel, 3 slides
 * and is, 4 is fixed and called tool.
 */
static const armtol_link links[] = {
    {.kind = ARMTOL_NPR, .joint = ARMTOL_REVOLUTE, .a = 100, .d = 300, .alpha = 1.5},
    {.kind = ARMTOL_PPR, .joint = ARMTOL_REVOLUTE, .a = 400},
    {.kind = ARMTOL_NPP, .joint = ARMTOL_PRISMATIC, .alpha = -1.5},
    {.kind = ARMTOL_PPP, .joint = ARMTOL_PRISMATIC, .a = 50},
    {.kind = ARMTOL_NPR, .joint = ARMTOL_FIXED, .d = 20},
};
static const char *const link_names[] = {NULL, NULL, NULL, NULL, "tool"};

enum { N_LINKS = sizeof links / sizeof links[0] };

static const armtol_arm arm = {.name = "all", .links = links, .n_links = N_LINKS, .names = link_names};

static bool read_text(const char *text, drawing *drawing, said *said)
{
    const drawing_view view = {&arm, "mm", "deg", 90};
    FILE *stream = stream_of(text, strlen(text));
    said_begin();
    const bool fine = drawing_read(stream, "parts.csv", &view, drawing);
    said_end(said);
    fclose(stream);
    return fine;
}

static void check_row(const drawing_row *row, size_t link, double distance, double angle, drawing_split split)
{
    TEST_ASSERT_EQUAL_UINT(link, row->link);
    TEST_ASSERT_EQUAL_STRING(drawing_split_name(split), drawing_split_name(row->split));
    TEST_ASSERT_EQUAL_INT(isnan(distance), isnan(row->distance));
    TEST_ASSERT_EQUAL_INT(isnan(angle), isnan(row->angle));
    if (!isnan(distance)) {
        check_same(distance, row->distance, "distance of link %zu", link);
    }
    if (!isnan(angle)) {
        check_same(angle, row->angle, "angle of link %zu", link);
    }
}

static void check_read(const char *text)
{
    drawing drawing;
    said said;
    TEST_ASSERT_TRUE_MESSAGE(read_text(text, &drawing, &said), said.text);
    TEST_ASSERT_EQUAL_STRING("", said.text);
    TEST_ASSERT_EQUAL_UINT(4, drawing.n_rows);
    check_row(&drawing.rows[0], 0, 0.05, 0.02, DRAWING_SPLIT_EVEN);
    check_row(&drawing.rows[1], 1, 0.1, (double)NAN, DRAWING_SPLIT_A);
    check_row(&drawing.rows[2], 3, (double)NAN, 0, DRAWING_SPLIT_NONE);
    check_row(&drawing.rows[3], 4, 0, 89, DRAWING_SPLIT_D);
    drawing_free(&drawing);
}

static void test_drawings(void)
{
    check_read("link,distance,angle,split\n0,.05,.02,even\n1,.1,-,-\n3,-,0,-\ntool,0,89,d\n");
    check_read("# parts\r\nlink;angle;distance;split;unit\r\n"
               "0;0,02;0,05;EVEN;mm deg\r\n1;;0,1;;\r\n3;0\r\n4;89;0;D\r\n");
    check_read("Split\tremark\tLink\tDistance\tAngle\n"
               "even\tcast\t0\t.05\t.02\n-\t-\t1\t.1\n-\t\t3\t-\t0\nd\t\t4\t0\t89\n");
}

static void test_a_drawing_of_angles_alone(void)
{
    drawing drawing;
    said said;
    TEST_ASSERT_TRUE(read_text("angle link\n1 0\n", &drawing, &said));
    TEST_ASSERT_EQUAL_UINT(1, drawing.n_rows);
    check_row(&drawing.rows[0], 0, (double)NAN, 1, DRAWING_SPLIT_NONE);
    drawing_free(&drawing);
}

static void check_refused(const char *expected, const char *text)
{
    char line[600];
    drawing drawing;
    said said;
    const bool fine = read_text(text, &drawing, &said);
    snprintf(line, sizeof line, "armtol: parts.csv:%s\n", expected);
    TEST_ASSERT_EQUAL_STRING(line, said.text);
    TEST_ASSERT_FALSE_MESSAGE(fine, text);
    drawing_free(&drawing);
}

static void test_wrong_heads(void)
{
    check_refused(" no table; expected a head row with link, distance, angle, split", "# nothing\n");
    check_refused("1:1: the head row has no column \"link\"; expected link, distance, angle, split",
                  "distance angle\n");
    check_refused("1:7: a second column \"angle\"", "angle,Angle,link\n");
    check_refused("1:1: the head row has neither \"distance\" nor \"angle\" nor \"seat\"", "link,split\n");
}

#define HEAD "link,distance,angle,split,unit\n"

static void test_wrong_rows(void)
{
    check_refused("2:1: link \"5\": expected a whole number from 0 to 4, the last link, or the name of one",
                  HEAD "5\n");
    check_refused("2:1: link \"gun\": expected a whole number from 0 to 4, the last link, or the name of one",
                  HEAD "gun,1\n");
    check_refused("2:1: link \"\": expected a whole number from 0 to 4, the last link, or the name of one",
                  HEAD ",1\n");
    check_refused("2:3: distance: \"x\" is not a number", HEAD "0,x,1,a\n");
    check_refused("2:3: distance: \"-1\" is negative", HEAD "0,-1,1,a\n");
    check_refused("2:5: angle: \"-1\" is negative", HEAD "0,1,-1,a\n");
    check_refused("2:5: angle: \"90\" is not less than a right angle", HEAD "0,1,90,a\n");
    check_refused("2:7: split: unknown word \"both\"; expected a, d or even", HEAD "0,1,2,both\n");
    check_refused("2:9: unit \"in deg\"; expected mm deg, as on the command line", HEAD "0,1,2,a,in deg\n");
    check_refused("3:1: link 0 a second time; the first is in line 2", HEAD "0,1,2,a\n0,1,2,d\n");
}

static void test_splits_that_a_link_does_not_have(void)
{
    check_refused("2:6: split - of link 0, of kind npr: expected a, d or even", HEAD "0,1,,-\n");
    check_refused("2:4: split - of link 0, of kind npr: expected a, d or even", HEAD "0,1\n");
    check_refused("2:6: split even of link 1, of kind ppr: expected a", HEAD "1,1,,even\n");
    check_refused("2:6: split d of link 1, of kind ppr: expected a", HEAD "1,1,,d\n");
    check_refused("2:3: link 2, of kind npp, has no distance that is made; expected -", HEAD "2,1,2\n");
    check_refused("2:7: split a of link 1 without a distance", HEAD "1,-,1,a\n");
}

static void test_radians(void)
{
    const drawing_view view = {&arm, "m", "rad", pi / 2};
    drawing drawing;
    said said;
    static const char text[] = "link,angle,unit\n0,1.57,m rad\n1,1.58,m rad\n";
    FILE *stream = stream_of(text, sizeof text - 1);
    said_begin();
    TEST_ASSERT_FALSE(drawing_read(stream, "parts.csv", &view, &drawing));
    said_end(&said);
    fclose(stream);
    TEST_ASSERT_EQUAL_STRING("armtol: parts.csv:3:3: angle: \"1.58\" is not less than a right angle\n", said.text);
    TEST_ASSERT_EQUAL_UINT(1, drawing.n_rows);
    drawing_free(&drawing);
}

int main(void)
{
    message_start("armtol");
    UNITY_BEGIN();
    RUN_TEST(test_drawings);
    RUN_TEST(test_a_drawing_of_angles_alone);
    RUN_TEST(test_wrong_heads);
    RUN_TEST(test_wrong_rows);
    RUN_TEST(test_splits_that_a_link_does_not_have);
    RUN_TEST(test_radians);
    return UNITY_END();
}
