#include "armtol/machining.h"

#include "lib/report/arithmetic.h"
#include "lib/report/trigonometry.h"

#include <math.h>

/* Erratum `copied-counts`: the Intelledex's numbers of parameters serve every arm. */
static void counts_of(const armtol_errata *errata, size_t *n_lengths, size_t *n_angles)
{
    if (errata->copied_counts) {
        *n_lengths = 14;
        *n_angles = 18;
    }
}

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
    counts_of(errata, &n_lengths, &n_angles);
    return (armtol_shares){
        .distance = share_of(bounds->distance, n_lengths, errata),
        .angle = share_of(bounds->angle, n_angles, errata),
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
