#include "lib/report/trigonometry.h"

#include "armtol/conventions.h"
#include "lib/pi.h"

#define LANES 1
#include "lib/lanes/rotation.h"
#include "lib/lanes/sincos.h"

/*
 * Method
 *    Sine and cosine are those of lanes/sincos.h. The arc tangent takes off the nearest of 0, pi/4 and pi/2, and has
 *    the polynomial of lanes/rotation.h for the rest; arc sine and cosine are its, of roots of products that do not
 *    cancel. A length divides by the longer side before it squares.
 *
 * Special cases
 *    Those of atan2 and hypot, signed zeros too (test_angles_along_the_axes). Angles beyond 1e6 are libm's, and with
 *    the erratum `float` all is.
 *
 * Accuracy
 *    4.5e-16 of the result, against long double (test_sines_of_all_sizes, test_directions_of_all_quadrants_and_sizes);
 *    arc sine and cosine to 9e-16 (test_arc_sines_and_cosines).
 */
double sine_of(const armtol_errata *errata, double angle)
{
    double sine, cosine;
    if (errata->float_storage) {
        return sin(angle);
    }
    sine_cosine(&angle, &sine, &cosine);
    return sine;
}

double cosine_of(const armtol_errata *errata, double angle)
{
    double sine, cosine;
    if (errata->float_storage) {
        return cos(angle);
    }
    sine_cosine(&angle, &sine, &cosine);
    return cosine;
}

/* The angle of (x, y), x and y >= 0: what is left of the nearest of 0, pi/4 and pi/2 has a small tangent. */
static double angle_of_quadrant(double y, double x)
{
    static const double tan_eighth = 0.41421356237309504880; /* of pi */
    double tangent = 0, nearest = 0, terms;
    if (y > x / tan_eighth) {
        nearest = PI / 2;
        tangent = -x / y;
    } else if (y > x * tan_eighth) {
        nearest = PI / 4;
        tangent = (y - x) / (y + x);
    } else if (y > 0) {
        tangent = y / x;
    }
    const double square = tangent * tangent;
    arctangent_terms(&square, &terms);
    return nearest + (tangent + tangent * square * terms);
}

double angle_of(const armtol_errata *errata, double y, double x)
{
    if (errata->float_storage) {
        return atan2(y, x);
    }
    const double upper = angle_of_quadrant(fabs(y), fabs(x));
    return copysign(x < 0 ? PI - upper : upper, y);
}

double arc_cosine_of(const armtol_errata *errata, double cosine)
{
    return errata->float_storage ? acos(cosine) : angle_of(errata, sqrt((1 - cosine) * (1 + cosine)), cosine);
}

double arc_sine_of(const armtol_errata *errata, double sine)
{
    return errata->float_storage ? asin(sine) : angle_of(errata, sine, sqrt((1 - sine) * (1 + sine)));
}

double length_of(double x, double y)
{
    const double longer = fmax(fabs(x), fabs(y)), shorter = fmin(fabs(x), fabs(y));
    const double ratio = shorter / longer;
    return longer == 0 || isinf(longer) ? longer : longer * sqrt(1 + ratio * ratio);
}

double length_of_vector(const double v[3])
{
    return length_of(length_of(v[0], v[1]), v[2]);
}
