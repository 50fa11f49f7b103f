/*
 * From the drawing to the parameters.
 *
 * Method:
 *    With x the error of a, (4.13) is a quadratic equation, (s + x)^2 = s^2 + gained for the longest distance and
 *    s^2 - lost for the shortest; s is a, or a + d where both have the error. Its roots are taken in the form that
 *    does not cancel, gained / (s + sqrt(s^2 + gained)).
 * Special cases:
 *    A negative s is the mirror image of its opposite. Without a shortest distance that s could reach (s^2 <= lost),
 *    the other end is the longest distance on the other side.
 *    The way back is halving, between 0 and what is too much.
 * Accuracy:
 *    The distances of the ends keep to the tolerance but for a few roundings of the distance, and what is tiny keeps
 *    its digits: test_drawing.c, on parts drawn at random and in closed form.
 */

#include "armtol/drawing.h"

#include "armtol/errata.h"
#include "lib/report/trigonometry.h"

#include <math.h>
#include <stdbool.h>

static armtol_range range_about(double s, double gained, double lost)
{
    const double size = fabs(s), longest = sqrt(size * size + gained), square = size * size - lost;
    const double high = gained == 0 ? 0 : gained / (size + longest);
    const double low = lost == 0 ? 0 : square > 0 ? -lost / (size + sqrt(square)) : -size - longest;
    return s < 0 ? (armtol_range){-high, -low} : (armtol_range){low, high};
}

/* parts: 1 for a alone, 2 for both, of which each then has half of what the line a + d has. */
static armtol_range range_of(double s, double r, double tolerance, double parts)
{
    if (!(tolerance >= 0)) {
        return (armtol_range){(double)NAN, (double)NAN};
    }
    const double lost = tolerance > r ? (double)INFINITY : tolerance * (2 * r - tolerance);
    const armtol_range range = range_about(s, parts * tolerance * (2 * r + tolerance), parts * lost);
    return (armtol_range){range.low / parts, range.high / parts};
}

armtol_range armtol_drawing_length(double a, double d, double tolerance)
{
    return range_of(a, length_of(a, d), tolerance, 1);
}

armtol_range armtol_drawing_length_both(double a, double d, double tolerance)
{
    return range_of(a + d, length_of(a, d), tolerance, 2);
}

double armtol_drawing_angle_even(double tolerance)
{
    return angle_of(&armtol_errata_none, sine_of(&armtol_errata_none, tolerance) / sqrt(2),
                    cosine_of(&armtol_errata_none, tolerance));
}

void armtol_drawing_angle_at(double tolerance, double phi, double *alpha, double *beta)
{
    const armtol_errata *const none = &armtol_errata_none;
    const double sine = sine_of(none, tolerance), cosine = cosine_of(none, tolerance);
    *alpha = angle_of(none, cosine_of(none, phi) * sine, cosine);
    *beta = angle_of(none, sine_of(none, phi) * sine, cosine);
}

double armtol_drawing_radius(double tolerance)
{
    return sqrt(2) * armtol_drawing_angle_even(tolerance);
}

/* ---- the way back ---- */

static double farther(armtol_range range)
{
    return fmax(-range.low, range.high);
}

static double error_of_a(double a, double d, double tolerance)
{
    return farther(armtol_drawing_length(a, d, tolerance));
}

static double error_of_both(double a, double d, double tolerance)
{
    return farther(armtol_drawing_length_both(a, d, tolerance));
}

static double error_of_angle(double unused, double none, double tolerance)
{
    (void)unused;
    (void)none;
    return armtol_drawing_radius(tolerance);
}

/* The largest tolerance, up to `most`, whose error is within. Errors grow with tolerances. */
static double largest(double (*error_of)(double a, double d, double tolerance), double a, double d, double error,
                      double most)
{
    double low = 0, high = most;
    if (!(error >= 0)) {
        return (double)NAN;
    }
    if (error_of(a, d, most) <= error) {
        return most;
    }
    double middle = high / 2;
    while (middle > low && middle < high) {
        const bool within = error_of(a, d, middle) <= error;
        low = within ? middle : low;
        high = within ? high : middle;
        middle = low + (high - low) / 2;
    }
    return low;
}

double armtol_drawing_distance(double a, double d, double error)
{
    return largest(error_of_a, a, d, error, 2 * error);
}

double armtol_drawing_distance_both(double a, double d, double error)
{
    return largest(error_of_both, a, d, error, 2 * error);
}

double armtol_drawing_angle(double error)
{
    return largest(error_of_angle, 0, 0, error, 1.57);
}
