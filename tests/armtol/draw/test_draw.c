/* Colours, round numbers, contours, and what a page of SVG is made of. */

#include "armtol/draw/contour.h"
#include "armtol/draw/ramp.h"
#include "armtol/draw/scale.h"
#include "armtol/draw/svg.h"
#include "support/check.h"
#include "support/process.h"

#include "unity.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void setUp(void)
{
}

void tearDown(void)
{
    process_clean_up();
}

/* ---- colours ---- */

/* CIE lightness, by the definition of sRGB (IEC 61966-2-1). */
static double lightness_of(const char *colour)
{
    static const double weights[3] = {0.2126, 0.7152, 0.0722};
    double luminance = 0;
    for (int i = 0; i < 3; i++) {
        const char pair[3] = {colour[1 + 2 * i], colour[2 + 2 * i], '\0'};
        const double part = (double)strtol(pair, NULL, 16) / 255;
        luminance += weights[i] * (part <= 0.04045 ? part / 12.92 : pow((part + 0.055) / 1.055, 2.4));
    }
    return luminance > 216.0 / 24389 ? 116 * cbrt(luminance) - 16 : luminance * 24389 / 27;
}

/* Light enough from one to the next to be told apart in grey: the steps are as even as viridis has them. */
static void test_colours_grow_lighter(void)
{
    for (size_t n = 2; n <= RAMP_COLOURS; n++) {
        const double whole = lightness_of(ramp_colour(n - 1, n)) - lightness_of(ramp_colour(0, n));
        TEST_ASSERT_TRUE(whole > 70);
        for (size_t i = 1; i < n; i++) {
            const double step = lightness_of(ramp_colour(i, n)) - lightness_of(ramp_colour(i - 1, n));
            TEST_ASSERT_TRUE(step > 0.4 * whole / (double)(n - 1) && step < 1.9 * whole / (double)(n - 1));
        }
    }
    TEST_ASSERT_EQUAL_INT(7, strlen(ramp_colour(0, 1)));
    TEST_ASSERT_EQUAL_STRING("#440154", ramp_colour(0, 9)); /* the first and the last of the published table */
    TEST_ASSERT_EQUAL_STRING("#fde725", ramp_colour(8, 9));
}

/* ---- round numbers ---- */

static void test_steps_are_round(void)
{
    static const struct {
        double span;
        size_t count;
        double step;
    } cases[] = {{10, 10, 1},     {10, 8, 2},      {1800, 8, 250},  {0.7, 7, 0.1},   {3, 10, 0.5},
                 {9.9, 10, 1},    {1e-7, 4, 2.5e-8}, {6e9, 7, 1e9}, {1, 3, 0.5},     {1e-320, 1, 1e-320}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        check_same(cases[i].step, scale_step(cases[i].span, cases[i].count), "case %zu", i);
    }
    check_within(1e-12, -0.4, scale_first(-0.43, 0.2), "first");
    check_within(1e-12, 0.6, scale_first(0.6000000000000001, 0.2), "first, rounding apart");
}

static void check_bands(double least, double most)
{
    scale scale;
    scale_make(&scale, least, most);
    TEST_ASSERT_TRUE(scale.n_bands >= 1 && scale.n_bands <= SCALE_MOST);
    TEST_ASSERT_TRUE(scale.edges[0] <= least * (1 + 1e-9) && scale.edges[scale.n_bands] >= most * (1 - 1e-9));
    TEST_ASSERT_EQUAL_UINT(0, scale_band(&scale, least));
    TEST_ASSERT_EQUAL_UINT(scale.n_bands - 1, scale_band(&scale, most));
    for (size_t i = 0; i < scale.n_bands; i++) {
        const double edge = scale.edges[i], next = scale.edges[i + 1];
        TEST_ASSERT_TRUE(edge < next || scale.n_bands == 1);
        TEST_ASSERT_EQUAL_UINT(i, scale_band(&scale, edge + (next - edge) / 2));
    }
    if (most > 1.01 * least) {
        TEST_ASSERT_TRUE(scale.n_bands >= 4);
    }
}

static void test_bands_hold_what_they_are_made_for(void)
{
    check_bands(0, 0);
    check_bands(0, 1);
    check_bands(3, 3);
    check_bands(0.3, 0.30000000001);
    check_bands(0.0131, 0.0246);
    check_bands(0.2, 1);
    check_bands(0.999, 1000);
    check_bands(1e-9, 1e9);
    check_bands(0, 1e-300);
    check_bands(7, 8.000001);
    for (int i = 1; i < 2000; i++) {
        check_bands(0.37 * i, 0.37 * i + 0.0173 * i * (i % 71));
    }
}

/* ---- contours ---- */

enum { N_X = 23, N_Y = 17 };

typedef struct traced {
    double length;
    size_t n;
    double worst; /* how far an end is from where it should be */
    int with, against; /* pieces in the middle square of the saddle, on the one and the other pair of its corners */
    double (*exact)(double x, double y);
} traced;

static bool all_joined(const void *context, size_t point, bool above)
{
    (void)context;
    (void)point;
    (void)above;
    return true;
}

static void take(const piece *piece, void *context)
{
    traced *traced = context;
    traced->n++;
    traced->length += hypot(piece->x[1] - piece->x[0], piece->y[1] - piece->y[0]);
    const double x = (piece->x[0] + piece->x[1]) / 2 - 10.5, y = (piece->y[0] + piece->y[1]) / 2 - 8.5;
    if (fabs(x) < 0.5 && fabs(y) < 0.5) {
        traced->with += x * y > 0;
        traced->against += x * y < 0;
    }
    for (int i = 0; i < 2; i++) {
        traced->worst = fmax(traced->worst, fabs(traced->exact(piece->x[i], piece->y[i])));
    }
}

static double values[N_X * N_Y];

static void fill(double of(double x, double y))
{
    for (size_t k = 0; k < N_X * N_Y; k++) {
        const size_t column = k % N_X, row = k / N_X;
        values[k] = of((double)column, (double)row);
    }
}

static double slope(double x, double y)
{
    return 3 * x - 2 * y - 10.5;
}

static double bowl(double x, double y)
{
    return hypot(x - 10.7, y - 8.2) - 6.3;
}

static double saddle(double x, double y)
{
    return (x - 10.5) * (y - 8.5);
}

/* Of a plane the line is exact, from border to border: y = (3 x - 10.5) / 2 from (3.5, 0) to (14.1666, 16). */
static void test_a_contour_of_a_plane_is_its_line(void)
{
    const field field = {N_X, N_Y, values, all_joined, NULL};
    traced traced = {.exact = slope};
    fill(slope);
    contour_trace(&field, 0, take, &traced);
    check_within(1e-9, hypot(42.5 / 3 - 3.5, 16), traced.length, "length");
    TEST_ASSERT_TRUE(traced.worst < 1e-12);
}

static void test_a_contour_of_a_cone_is_a_circle(void)
{
    const field field = {N_X, N_Y, values, all_joined, NULL};
    traced traced = {.exact = bowl};
    fill(bowl);
    contour_trace(&field, 0, take, &traced);
    check_within(0.2, 2 * 3.14159265358979323846 * 6.3, traced.length, "circumference");
    TEST_ASSERT_TRUE(traced.worst < 0.05);
}

/* In the square in the middle two lines go by each other, on the side of the corners that are not as the middle is. */
static void test_lines_that_meet_in_a_square_do_not_cross(void)
{
    const field field = {N_X, N_Y, values, all_joined, NULL};
    traced above = {.exact = saddle}, below = {.exact = saddle};
    fill(saddle);
    contour_trace(&field, 0.01, take, &above);
    contour_trace(&field, -0.01, take, &below);
    TEST_ASSERT_TRUE(above.with == 2 && above.against == 0);
    TEST_ASSERT_TRUE(below.with == 0 && below.against == 2);
    TEST_ASSERT_EQUAL_UINT(above.n, below.n);
    check_within(1e-9, above.length, below.length, "length");
}

static bool not_the_fifth(const void *context, size_t point, bool above)
{
    (void)context;
    return !(point % N_X == 5 && !above);
}

static void test_no_line_crosses_a_seam(void)
{
    const field whole = {N_X, N_Y, values, all_joined, NULL}, cut = {N_X, N_Y, values, not_the_fifth, NULL};
    traced traced_whole = {.exact = slope}, traced_cut = {.exact = slope};
    fill(slope);
    contour_trace(&whole, 0, take, &traced_whole);
    contour_trace(&cut, 0, take, &traced_cut);
    check_within(1e-9, traced_whole.length - hypot(1, 1.5), traced_cut.length, "but for the squares from 5 to 6");
    values[3 * N_X + 6] = (double)NAN;
    contour_trace(&whole, 0, take, &traced_cut);
    TEST_ASSERT_TRUE(traced_cut.worst < 1e-9);
}

/* ---- a page ---- */

/* What was put on a stream. */
static string put_of(const char *text)
{
    string out;
    FILE *stream = tmpfile();
    TEST_ASSERT_NOT_NULL(stream);
    svg_put(stream, text);
    rewind(stream);
    out.text[fread(out.text, 1, sizeof out.text - 1, stream)] = '\0';
    fclose(stream);
    return out;
}

static void check_put(const char *text, const char *expected)
{
    const string out = put_of(text);
    TEST_ASSERT_EQUAL_STRING(expected, out.text);
}

static void test_texts_are_fit_for_xml(void)
{
    check_put("a < b & \"c\" > d", "a &lt; b &amp; &quot;c&quot; &gt; d");
    check_put("Roboterarm f\xc3\xbcr \xe2\x82\xac, \xf0\x9f\xa4\x96",
              "Roboterarm f\xc3\xbcr \xe2\x82\xac, \xf0\x9f\xa4\x96");
    check_put("tab\there\x1b", "tab?here?");
    check_put("\xff\xc3(\xc3", "?\?(?");
    check_put("\xe2\x82", "?\?");               /* cut off */
    check_put("\xc0\xaf\xe0\x80\xaf", "?\?\?\?\?"); /* longer than need be */
    check_put("\xed\xa0\x80", "?\?\?");           /* half of a surrogate pair */
    check_put("\xef\xbf\xbf", "?\?\?");           /* U+FFFF */
    check_put("\xf4\x90\x80\x80", "?\?\?\?");      /* beyond U+10FFFF */
}

static void test_places_are_to_a_tenth(void)
{
    TEST_ASSERT_EQUAL_STRING("0.0", svg_px(-0.04, &(pixel){""}));
    TEST_ASSERT_EQUAL_STRING("12.3", svg_px(12.34, &(pixel){""}));
    TEST_ASSERT_EQUAL_STRING("-7.5", svg_px(-7.5, &(pixel){""}));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_colours_grow_lighter);
    RUN_TEST(test_steps_are_round);
    RUN_TEST(test_bands_hold_what_they_are_made_for);
    RUN_TEST(test_a_contour_of_a_plane_is_its_line);
    RUN_TEST(test_a_contour_of_a_cone_is_a_circle);
    RUN_TEST(test_lines_that_meet_in_a_square_do_not_cross);
    RUN_TEST(test_no_line_crosses_a_seam);
    RUN_TEST(test_texts_are_fit_for_xml);
    RUN_TEST(test_places_are_to_a_tenth);
    return UNITY_END();
}
