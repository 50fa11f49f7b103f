/* Drawings that name grades and classes, and seats: what they come to, and what is wrong. */

#include "armtol/drawing/drawing_file.h"
#include "console/message.h"

#include "support/check.h"
#include "support/said.h"

#include "unity.h"

#include <math.h>
#include <string.h>

#define PI 3.14159265358979323846

void setUp(void)
{
}

void tearDown(void)
{
}

/* Link 0 is 30 and 40 mm, its axes 50 mm apart; link 1 parallel at 400; 2 slides; 3 meets; 4 is 3 m long. */
static const armtol_link links[] = {
    {.kind = ARMTOL_NPR, .joint = ARMTOL_REVOLUTE, .a = 30, .d = -40, .alpha = 1.5},
    {.kind = ARMTOL_PPR, .joint = ARMTOL_REVOLUTE, .a = -400, .d = 70},
    {.kind = ARMTOL_NPP, .joint = ARMTOL_PRISMATIC, .alpha = -1.5},
    {.kind = ARMTOL_NPR, .joint = ARMTOL_REVOLUTE, .alpha = 1.5},
    {.kind = ARMTOL_NPR, .joint = ARMTOL_FIXED, .a = 3000},
};

enum { N_LINKS = sizeof links / sizeof links[0] };

static const armtol_arm arm = {.name = "named", .links = links, .n_links = N_LINKS};
static const drawing_view in_mm = {&arm, "mm", "deg", 90, ARMTOL_MILLIMETRE};
static const drawing_view in_metres = {&arm, "m", "rad", PI / 2, ARMTOL_METRE};

static bool read_text(const char *text, const drawing_view *view, drawing *drawing, said *said)
{
    FILE *stream = stream_of(text, strlen(text));
    said_begin();
    const bool fine = drawing_read(stream, "parts.csv", view, drawing);
    said_end(said);
    fclose(stream);
    return fine;
}

/* The one row of a drawing: nan where nothing is to be said. */
static void check_row(const char *text, const drawing_view *view, double distance, double angle)
{
    drawing drawing;
    said said;
    TEST_ASSERT_TRUE_MESSAGE(read_text(text, view, &drawing, &said), said.text);
    TEST_ASSERT_EQUAL_STRING("", said.text);
    TEST_ASSERT_EQUAL_UINT(1, drawing.n_rows);
    TEST_ASSERT_EQUAL_INT_MESSAGE(isnan(distance), isnan(drawing.rows[0].distance), text);
    TEST_ASSERT_EQUAL_INT_MESSAGE(isnan(angle), isnan(drawing.rows[0].angle), text);
    if (!isnan(distance)) {
        check_within(1e-15 + 1e-14 * distance, distance, drawing.rows[0].distance, "distance: %s", text);
    }
    if (!isnan(angle)) {
        check_within(1e-15 + 1e-14 * angle, angle, drawing.rows[0].angle, "angle: %s", text);
    }
    drawing_free(&drawing);
}

#define NONE ((double)NAN)
#define DISTANCE "link,distance,split\n"

/* ISO 286: 50 mm IT7 25, IT10 100; 400 mm IT7 57 micrometres, half to either side. ISO 2768: 0.15, 0.3, 0.5, 2. */
static void test_distances_by_name(void)
{
    check_row(DISTANCE "0,IT7,a\n", &in_mm, 0.0125, NONE);
    check_row(DISTANCE "0,js10,even\n", &in_mm, 0.05, NONE);
    check_row(DISTANCE "1,JS7\n", &in_mm, 0.0285, NONE);
    check_row(DISTANCE "0,2768-f,d\n", &in_mm, 0.15, NONE);
    check_row(DISTANCE "0,2768-m,d\n", &in_mm, 0.3, NONE);
    check_row(DISTANCE "1,2768-m\n", &in_mm, 0.5, NONE);
    check_row(DISTANCE "4,2768-m,a\n", &in_mm, 2, NONE);
    check_row(DISTANCE "1,2768-m\n", &in_metres, 0.0005, NONE);
    check_row(DISTANCE "1,IT7\n", &in_metres, 28.5e-6, NONE);
}

/* ISO 2768: 1 degree to 10 mm, 10' to 400. */
static void test_angles_by_name(void)
{
    check_row("link,angle,side\n1,2768-m,10\n", &in_mm, NONE, 1);
    check_row("side,link,angle\n400,1,2768-f\n", &in_mm, NONE, 10.0 / 60);
    check_row("side,link,angle\n0.4,1,2768-f\n", &in_metres, NONE, PI / 180 / 6);
}

#define SEAT "link,distance,angle,split,seat,position,play\n"

/* (p + c) / L and (p + c) / 2 beside what the row says; 40H7 and 40IT7 are 25 micrometres wide, 40h12 250. */
static void test_seats(void)
{
    check_row(SEAT "0,.1,.05,even,80,.02,.005\n", &in_mm, 0.1125, 0.05 + 0.025 / 80 * 180 / PI);
    check_row(SEAT "0,,,a,80,.02\n", &in_mm, 0.01, 0.02 / 80 * 180 / PI);
    check_row(SEAT "0,IT7,-,a,80,40H7,0\n", &in_mm, 0.0125 + 0.0125, 0.025 / 80 * 180 / PI);
    check_row(SEAT "1,-,-,-,80,40IT7,.015\n", &in_mm, 0.02, 0.04 / 80 * 180 / PI);
    check_row(SEAT "1,-,-,-,.08,40h12,.00005\n", &in_metres, 0.00015, 0.0003 / 0.08);
    check_row(SEAT "2,,,,50,.1,0\n", &in_mm, NONE, 0.1 / 50 * 180 / PI); /* a slide's axis has no place */
    check_row("seat,link,position\n50,2,.1\n", &in_mm, NONE, 0.1 / 50 * 180 / PI);
    check_row(SEAT "0,.1,.05,even,,,\n", &in_mm, 0.1, 0.05);
}

static void check_refused(const char *expected, const char *text)
{
    char line[600];
    drawing drawing;
    said said;
    const bool fine = read_text(text, &in_mm, &drawing, &said);
    snprintf(line, sizeof line, "armtol: parts.csv:%s\n", expected);
    TEST_ASSERT_EQUAL_STRING(line, said.text);
    TEST_ASSERT_FALSE_MESSAGE(fine, text);
    drawing_free(&drawing);
}

#define TO_BOTH "is no grade to both sides; expected IT, JS or js with a number from 5 to 12, 2768-f or 2768-m"

static void test_names_that_do_not_hold(void)
{
    check_refused("2:3: distance: \"H7\" " TO_BOTH, DISTANCE "0,H7,a\n");
    check_refused("2:3: distance: \"g6\" " TO_BOTH, DISTANCE "0,g6,a\n");
    check_refused("2:3: distance: \"IT13\" " TO_BOTH, DISTANCE "0,IT13,a\n");
    check_refused("2:3: distance: \"2768-c\" " TO_BOTH, DISTANCE "0,2768-c,a\n");
    check_refused("2:3: distance: \"2768-mK\" " TO_BOTH, DISTANCE "0,2768-mK,a\n");
    check_refused("2:3: distance: \"7IT\" is not a number", DISTANCE "0,7IT,a\n");
    check_refused("2:3: distance: \"IT7\" is for lengths above 0, to 500 mm", DISTANCE "3,IT7,a\n");
    check_refused("2:3: distance: \"IT7\" is for lengths above 0, to 500 mm", DISTANCE "4,IT7,a\n");
    check_refused("2:3: distance: \"2768-f\" is for lengths from 0.5 to 4000 mm (2768-f: 2000 mm)",
                  DISTANCE "4,2768-f,a\n");
    check_refused("2:3: angle: \"2768-m\" needs the length of the shorter side, in a column side",
                  "link,angle\n0,2768-m\n");
    check_refused("2:3: angle: \"IT7\" is not a number", "link,angle,side\n0,IT7,5\n");
    check_refused("2:5: side: \"long\" is not a number", "link,angle,side\n0,1,long\n");
}

#define WITH_SIZE \
    "is no grade with its size in mm; expected such as 40H7: a size to 500, IT, H, h, JS or js, 5 to 12"

#define TOO_FREE "seat: with it the link may be off by a right angle or more, or by too large a number"

static void test_seats_that_are_none(void)
{
    check_refused("2:9: position: \"40g6\" " WITH_SIZE, SEAT "0,,,a,9,40g6,0\n");
    check_refused("2:9: position: \"501H7\" " WITH_SIZE, SEAT "0,,,a,9,501H7,0\n");
    check_refused("2:9: position: \"4.0.H7\" " WITH_SIZE, SEAT "0,,,a,9,4.0.H7,0\n");
    check_refused("2:9: position: \"0000000000000000000000000000000040H7\" " WITH_SIZE,
                  SEAT "0,,,a,9,0000000000000000000000000000000040H7,0\n");
    check_refused("2:9: position: \"H7\" is not a number", SEAT "0,,,a,9,H7,0\n");
    check_refused("2:9: position: \"40H\" is not a number", SEAT "0,,,a,9,40H,0\n");
    check_refused("2:7: seat: the two seats are 0 apart", SEAT "0,,,a,0,1,0\n");
    check_refused("2:7: seat: \"-9\" is negative", SEAT "0,,,a,-9,1,0\n");
    check_refused("2:9: seat and position go together", SEAT "0,,,a,9,-,1\n");
    check_refused("2:8: seat and position go together", SEAT "0,,,a,,9,1\n");
    check_refused("2:9: play without a seat", SEAT "0,,,a,,,1\n");
    check_refused("2:11: play: \"IT7\" is not a number", SEAT "0,,,a,9,1,IT7\n");
    check_refused("2:7: " TOO_FREE, SEAT "0,,,a,1,1,9\n");
    check_refused("2:14: " TOO_FREE, SEAT "0,1.5e308,,a,1e308,1e308,0\n");
    check_refused("2:5: split - of link 0, of kind npr: expected a, d or even", SEAT "0,,,,9,1\n");
}

static void check_others(const drawing *drawing, size_t row, size_t link, double distance, drawing_split split)
{
    TEST_ASSERT_EQUAL_UINT(link, drawing->rows[row].link);
    TEST_ASSERT_EQUAL_STRING(drawing_split_name(split), drawing_split_name(drawing->rows[row].split));
    TEST_ASSERT_EQUAL_INT(isnan(distance), isnan(drawing->rows[row].distance));
    if (!isnan(distance)) {
        check_same(distance, drawing->rows[row].distance, "link %zu", link);
    }
    check_within(1e-15, 0.5, drawing->rows[row].angle, "link %zu", link);
}

/* Links 1 and 3 have rows of their own; of the others the slide has no distance, and 0 and 4 have what m says. */
static void test_others(void)
{
    drawing drawing;
    said said;
    TEST_ASSERT_TRUE_MESSAGE(read_text("link,distance,angle,split,side\n1,1,1,a\n3,1,1,a\n"
                                       "Others,2768-m,2768-m,even,50\n", &in_mm, &drawing, &said), said.text);
    TEST_ASSERT_EQUAL_UINT(5, drawing.n_rows);
    check_others(&drawing, 2, 0, 0.3, DRAWING_SPLIT_EVEN);
    check_others(&drawing, 3, 2, NONE, DRAWING_SPLIT_NONE);
    check_others(&drawing, 4, 4, 2, DRAWING_SPLIT_EVEN);
    drawing_free(&drawing);
    /* an even split is what a link of parallel axes has not: it has its own */
    TEST_ASSERT_TRUE_MESSAGE(read_text("link,distance,angle,split\n0,-,-,-\n3,-,-,-\n4,-,-\nothers,1,.5,even\n", &in_mm,
                                       &drawing, &said), said.text);
    check_others(&drawing, 3, 1, 1, DRAWING_SPLIT_A);
    check_others(&drawing, 4, 2, NONE, DRAWING_SPLIT_NONE);
    drawing_free(&drawing);
}

static void test_others_that_are_wrong(void)
{
    check_refused("3:8: distance of link 3: \"2768-m\" is for lengths from 0.5 to 4000 mm (2768-f: 2000 mm)",
                  DISTANCE "1,1\nothers,2768-m,a\n");
    check_refused("2:10: split - of link 0, of kind npr: expected a, d or even", DISTANCE "others,1,\n");
    check_refused("3:1: link 4 a second time; the first is in line 2", DISTANCE "others,1,a\n4,1,a\n");
    check_refused("4:1: others a second time; the first is in line 3", DISTANCE "4,1,a\nothers,1,a\nothers,x,a\n");
}

int main(void)
{
    message_start("armtol");
    UNITY_BEGIN();
    RUN_TEST(test_distances_by_name);
    RUN_TEST(test_angles_by_name);
    RUN_TEST(test_seats);
    RUN_TEST(test_names_that_do_not_hold);
    RUN_TEST(test_seats_that_are_none);
    RUN_TEST(test_others);
    RUN_TEST(test_others_that_are_wrong);
    return UNITY_END();
}
