#include "armtol/engine/parts.h"

#include <math.h>

/* The tolerances of one link, nan for a parameter that it does not count. */
typedef struct link_tolerances {
    double of[ARMTOL_PARAMETER_COUNT];
} link_tolerances;

static link_tolerances of_link(const posed_arm *posed, const double tolerances[], size_t link)
{
    link_tolerances found;
    for (int i = 0; i < ARMTOL_PARAMETER_COUNT; i++) {
        found.of[i] = (double)NAN;
    }
    for (size_t k = 0; k < posed->n_columns; k++) {
        if (posed->columns[k].link == link) {
            found.of[posed->columns[k].parameter] = tolerances[k];
        }
    }
    return found;
}

static double or_exact(double tolerance)
{
    return isnan(tolerance) ? 0 : tolerance;
}

static part part_of(const armtol_link *link, const link_tolerances *tolerances)
{
    const double *of = tolerances->of;
    const bool turns = link->joint == ARMTOL_REVOLUTE, slides = link->joint == ARMTOL_PRISMATIC;
    const double made_theta = turns ? (double)NAN : of[ARMTOL_THETA];
    const double made_d = slides ? 0 : or_exact(of[ARMTOL_D]);
    return (part){
        .distance = armtol_distance_tolerance(link->a, link->d, or_exact(of[ARMTOL_A]), made_d),
        .angle = fmin(made_theta, fmin(of[ARMTOL_ALPHA], of[ARMTOL_BETA])), /* fmin passes nan over */
        .motor = turns ? of[ARMTOL_THETA] : slides ? of[ARMTOL_D] : (double)NAN,
    };
}

/* As the programs of 1987 have it, corrected. */
static part part_of_sphere(const armtol_link *link, const link_tolerances *tolerances)
{
    const double *of = tolerances->of;
    const armtol_shares shares = {fmin(of[ARMTOL_A], of[ARMTOL_D]), of[ARMTOL_ALPHA]};
    const double distance = isinf(shares.distance)
                                ? shares.distance
                                : armtol_machining_distance(link, shares.distance, &armtol_errata_none);
    return (part){
        .distance = distance,
        .angle = shares.angle,
        .motor = link->joint == ARMTOL_FIXED ? (double)NAN : armtol_motor_tolerance(link, distance, &shares),
    };
}

void parts_make(const request *request, const double tolerances[], part parts[])
{
    const posed_arm *posed = &request->posed;
    const bool sphere = request->tolerances == NULL && request->options->method == METHOD_SPHERE;
    for (size_t i = 0; i < posed->n_links; i++) {
        const armtol_link *link = &posed->links[i];
        const link_tolerances of = of_link(posed, tolerances, i);
        parts[i] = sphere ? part_of_sphere(link, &of) : part_of(link, &of);
        parts[i].drive = link->joint == ARMTOL_FIXED ? (double)NAN : armtol_drive_error(&posed->arm->drives[i]);
    }
}

double parts_lever(const posed_arm *posed)
{
    const double *offset = posed->tool.offset;
    double longest = 0;
    for (size_t pose = 0; pose < posed->n_poses; pose++) {
        double length = sqrt(offset[0] * offset[0] + offset[1] * offset[1] + offset[2] * offset[2]);
        for (size_t i = 0; i < posed->n_links; i++) {
            const armtol_link *link = &posed_arm_links(posed, pose)[i];
            length += sqrt(link->a * link->a + link->d * link->d);
        }
        longest = fmax(longest, length);
    }
    return longest > 0 ? longest : 1;
}
