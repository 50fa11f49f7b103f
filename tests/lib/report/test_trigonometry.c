/* The library's own sine, arc tangent and so on, against libm's in long double. */

#include "lib/report/trigonometry.h"

#include "support/check.h"
#include "support/random.h"
#include "unity.h"

#include <float.h>
#include <math.h>

void setUp(void)
{
}

void tearDown(void)
{
}

static const armtol_errata *const own = &armtol_errata_none;

/* Two units in the last place of a result, and less than a rounding of 1 where it is next to 0. */
static void check_close(long double expected, double actual, const char *what, double y, double x)
{
    const double e = (double)expected;
    check_within(2 * DBL_EPSILON * fabs(e), e, actual, "%s of %.17g, %.17g", what, y, x);
}

static void check_angle(double angle)
{
    check_close(sinl((long double)angle), sine_of(own, angle), "sine", angle, 0);
    check_close(cosl((long double)angle), cosine_of(own, angle), "cosine", angle, 0);
}

static void check_direction(double y, double x)
{
    check_close(atan2l((long double)y, (long double)x), angle_of(own, y, x), "angle", y, x);
    check_close(hypotl((long double)y, (long double)x), length_of(x, y), "length", y, x);
}

static void test_sines_of_all_sizes(void)
{
    random_source random = {1};
    for (int i = 0; i < 20000; i++) {
        check_angle(random_between(&random, -7, 7));
        check_angle(ldexp(random_between(&random, -1, 1), i % 60 - 40)); /* up to 5e5 */
    }
}

static void test_directions_of_all_quadrants_and_sizes(void)
{
    random_source random = {2};
    for (int i = 0; i < 20000; i++) {
        const double y = random_between(&random, -1, 1), x = random_between(&random, -1, 1);
        check_direction(y, x);
        check_direction(ldexp(y, i % 40 - 20), x);
        check_direction(1e-200 * y, 1e-200 * x);
        check_direction(1e200 * y, 1e200 * x);
    }
}

/* Where the nearest of 0, pi/4 and pi/2 changes. */
static void test_directions_where_the_way_changes(void)
{
    for (int i = -2000; i <= 2000; i++) {
        const double y = 0.41421356237309504880 + i * DBL_EPSILON;
        check_direction(y, 1);
        check_direction(1, y);
        check_direction(-1, -y);
        check_direction(1 + i * DBL_EPSILON, 1);
    }
}

static void check_zero(double expected, double y, double x)
{
    check_same(expected, angle_of(own, y, x), "angle of %g, %g", y, x);
    TEST_ASSERT_EQUAL_INT(signbit(expected) != 0, signbit(angle_of(own, y, x)) != 0);
}

static void test_angles_along_the_axes(void)
{
    const double pi = 3.14159265358979323846;
    check_zero(0, 0, 1);
    check_zero(-0.0, -0.0, 1);
    check_zero(pi, 0, -1);
    check_zero(-pi, -0.0, -1);
    check_zero(pi / 2, 3, 0);
    check_zero(-pi / 2, -3, 0);
    check_zero(0, 0, 0);
    check_same(0, sine_of(own, 0), "sine");
    check_same(1, cosine_of(own, 0), "cosine");
    check_same(0, length_of(0, 0), "no length");
    check_same((double)INFINITY, length_of(-(double)INFINITY, 1), "an infinite length");
}

static void test_arc_sines_and_cosines(void)
{
    random_source random = {3};
    for (int i = 0; i < 20000; i++) {
        const double x = random_between(&random, -1, 1);
        check_within(4 * DBL_EPSILON, (double)asinl((long double)x), arc_sine_of(own, x), "arc sine of %.17g", x);
        check_within(4 * DBL_EPSILON, (double)acosl((long double)x), arc_cosine_of(own, x), "arc cosine of %.17g", x);
    }
    check_same(3.14159265358979323846, arc_cosine_of(own, -1), "arc cosine of -1");
    check_same(0, arc_cosine_of(own, 1), "arc cosine of 1");
    check_same(-3.14159265358979323846 / 2, arc_sine_of(own, -1), "arc sine of -1");
}

/* As of 1987 they are libm's, to the bit. */
static void test_1987_has_libm(void)
{
    const armtol_errata *const as_1987 = &armtol_errata_1987;
    random_source random = {4};
    for (int i = 0; i < 1000; i++) {
        const double x = random_between(&random, -1, 1), y = random_between(&random, -1, 1);
        check_same(sin(x), sine_of(as_1987, x), "sine of %.17g", x);
        check_same(cos(x), cosine_of(as_1987, x), "cosine of %.17g", x);
        check_same(atan2(y, x), angle_of(as_1987, y, x), "angle of %.17g, %.17g", y, x);
        check_same(acos(x), arc_cosine_of(as_1987, x), "arc cosine of %.17g", x);
        check_same(asin(x), arc_sine_of(as_1987, x), "arc sine of %.17g", x);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_sines_of_all_sizes);
    RUN_TEST(test_directions_of_all_quadrants_and_sizes);
    RUN_TEST(test_directions_where_the_way_changes);
    RUN_TEST(test_angles_along_the_axes);
    RUN_TEST(test_arc_sines_and_cosines);
    RUN_TEST(test_1987_has_libm);
    return UNITY_END();
}
