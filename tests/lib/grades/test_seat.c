#include "armtol/seat.h"

#include "support/check.h"
#include "support/random.h"
#include "unity.h"

#include <math.h>

#define PI 3.14159265358979323846

void setUp(void)
{
}

void tearDown(void)
{
}

/* L 80, p 0.02, c 0.005: by hand. */
static void test_by_hand(void)
{
    const armtol_seat seat = armtol_seat_errors(80, 0.02, 0.005);
    check_within(1e-17, 0.0125, seat.offset, "offset");
    check_within(1e-18, 0.0003125, seat.angle, "angle");
}

/* Where an axis crosses the middle plane of a seat: a bore off by up to p / 2, and the axis in it by up to c / 2. */
static void draw_crossing(random_source *random, double position, double play, double at[2])
{
    const double of_bore = random_between(random, 0, 2 * PI), of_axis = random_between(random, 0, 2 * PI);
    at[0] = position / 2 * cos(of_bore) + play / 2 * cos(of_axis);
    at[1] = position / 2 * sin(of_bore) + play / 2 * sin(of_axis);
}

/* How far a line through both crossings is off, a part of the way from the one to the other, and its angle. */
static void test_lines_through_two_seats_are_within(void)
{
    random_source random = {80};
    double most_offset = 0, most_angle = 0;
    const double apart = 5, position = 0.02, play = 0.01;
    const armtol_seat seat = armtol_seat_errors(apart, position, play);
    for (int i = 0; i < 200000; i++) {
        double one[2], other[2];
        draw_crossing(&random, position, play, one);
        draw_crossing(&random, position, play, other);
        const double part = random_between(&random, 0, 1);
        const double offset = hypot(one[0] + part * (other[0] - one[0]), one[1] + part * (other[1] - one[1]));
        const double angle = atan(hypot(other[0] - one[0], other[1] - one[1]) / apart);
        most_offset = fmax(most_offset, offset);
        most_angle = fmax(most_angle, angle);
    }
    TEST_ASSERT_TRUE(most_offset <= seat.offset && most_angle <= seat.angle);
    check_within(0.02, 1, most_offset / seat.offset, "the offset is reached");
    check_within(0.02, 1, most_angle / seat.angle, "the angle is reached");
}

static void check_none(double apart, double position, double play)
{
    const armtol_seat seat = armtol_seat_errors(apart, position, play);
    TEST_ASSERT_TRUE(isnan(seat.offset) && isnan(seat.angle));
}

static void test_what_is_no_seat(void)
{
    check_none(0, 1, 1);
    check_none(-1, 1, 1);
    check_none((double)NAN, 1, 1);
    check_none(1, -1, 1);
    check_none(1, 1, -1);
    check_none(1, (double)NAN, 1);
    check_none(1, 1, (double)NAN);
    check_same(0, armtol_seat_errors(1, 0, 0).offset, "exact seats");
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_by_hand);
    RUN_TEST(test_lines_through_two_seats_are_within);
    RUN_TEST(test_what_is_no_seat);
    return UNITY_END();
}
