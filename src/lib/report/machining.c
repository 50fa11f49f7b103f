#include "armtol/machining.h"

#include "lib/report/arithmetic.h"
#include "lib/report/trigonometry.h"

#include <math.h>

/*
 * Method
 *    Closed forms: Eq. (4.32) as the report writes it, a difference of two lengths, and the same as the difference of
 *    their squares over their sum.
 *
 * Special cases
 *    No parameter has a share of 0. A square that rounding takes below 0 counts as 0. What overflows is infinite or
 *    nan.
 *
 * Accuracy
 *    The report's form loses what h has in front of the share; the other one does not: 1e-12 where h is 5e13
 *    (test_by_sphere_the_distance_does_not_cancel).
 */
static double share_of(double radius, size_t n, const armtol_errata *errata)
{
    if (n == 0) {
        return 0;
    }
    /* Erratum `root-of-ratio`: the root takes in the radius too. */
    const double share = errata->root_of_ratio ? sqrt(radius / (double)n) : radius / sqrt((double)n);
    return store(errata, share);
}

armtol_shares armtol_parameter_shares(const armtol_bounds *bounds, size_t n_lengths, size_t n_angles,
                                      const armtol_errata *errata)
{
    /* Erratum `copied-counts`: the Intelledex's numbers of parameters serve every arm. */
    return (armtol_shares){
        .distance = share_of(bounds->distance, errata->copied_counts ? 14 : n_lengths, errata),
        .angle = share_of(bounds->angle, errata->copied_counts ? 18 : n_angles, errata),
    };
}

double armtol_machining_distance(const armtol_link *link, double share, const armtol_errata *errata)
{
    /* Erratum `signed-mach`: a and d go in with their signs. */
    const double a = errata->signed_mach ? link->a : fabs(link->a);
    const double d = errata->signed_mach ? link->d : fabs(link->d);
    const double h = store(errata, sqrt(a * a + d * d));
    /* (a + share)^2 + (d + share)^2, which rounding alone can take below zero */
    const double square = h * h + 2 * a * share + 2 * d * share + share * share + share * share;
    return store(errata, -h + sqrt(fmax(square, 0)));
}

double armtol_distance_tolerance(double a, double d, double a_tolerance, double d_tolerance)
{
    const double before = length_of(a, d), after = length_of(fabs(a) + a_tolerance, fabs(d) + d_tolerance);
    if (!isfinite(after) || after == 0) {
        return after;
    }
    /* the difference of the squares over the sum of the roots */
    return (a_tolerance * (2 * fabs(a) + a_tolerance) + d_tolerance * (2 * fabs(d) + d_tolerance)) / (before + after);
}

double armtol_motor_tolerance(const armtol_link *link, double machining_distance, const armtol_shares *shares)
{
    switch (link->joint) {
    case ARMTOL_REVOLUTE:
        return shares->angle;
    case ARMTOL_PRISMATIC:
        return machining_distance;
    default:
        return 0;
    }
}
