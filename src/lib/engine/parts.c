#include "lib/engine/parts.h"

#include "armtol/machining.h"
#include "lib/engine/drives.h"

#include <math.h>
#include <stdbool.h>

/* The tolerances of one link, nan for a parameter that it does not count. */
typedef struct link_tolerances {
    double of[ARMTOL_PARAMETER_COUNT];
} link_tolerances;

static link_tolerances of_link(const armtol_answer *answer, size_t link)
{
    link_tolerances found;
    for (int i = 0; i < ARMTOL_PARAMETER_COUNT; i++) {
        found.of[i] = (double)NAN;
    }
    for (size_t k = 0; k < answer->n_columns; k++) {
        if (answer->columns[k].link == link) {
            found.of[answer->columns[k].parameter] = answer->tolerances[k];
        }
    }
    return found;
}

static double or_exact(double tolerance)
{
    return isnan(tolerance) ? 0 : tolerance;
}

/*
 * The distance between the link's axis and the next: of parallel axes it is |a|, so that a d which is no error source
 * is none of it. The axis of a slide is a direction without a place, and has no distance.
 */
static double distance_of(const armtol_link *link, const link_tolerances *tolerances)
{
    const double *of = tolerances->of;
    const bool parallel = link->kind == ARMTOL_PPR || link->kind == ARMTOL_PPP;
    if (link->joint == ARMTOL_PRISMATIC) {
        return (double)NAN;
    }
    return parallel ? of[ARMTOL_A]
                    : armtol_distance_tolerance(link->a, link->d, or_exact(of[ARMTOL_A]), or_exact(of[ARMTOL_D]));
}

static armtol_part part_of(const armtol_link *link, const link_tolerances *tolerances)
{
    const double *of = tolerances->of;
    const bool turns = link->joint == ARMTOL_REVOLUTE, slides = link->joint == ARMTOL_PRISMATIC;
    const double made_theta = turns ? (double)NAN : of[ARMTOL_THETA];
    return (armtol_part){
        .distance = distance_of(link, tolerances),
        .angle = fmin(made_theta, fmin(of[ARMTOL_ALPHA], of[ARMTOL_BETA])), /* fmin passes nan over */
        .motor = turns ? of[ARMTOL_THETA] : slides ? of[ARMTOL_D] : (double)NAN,
    };
}

/* Eq. (4.32) in every pose, since the d of a slide changes: the strictest. */
static double strictest_distance(const armtol_answer *answer, size_t i, double share)
{
    double strictest = (double)INFINITY;
    for (size_t pose = 0; pose < answer->n_poses; pose++) {
        const armtol_link *link = &armtol_answer_links(answer, pose)[i];
        strictest = fmin(strictest, armtol_distance_tolerance(link->a, link->d, share, share));
    }
    return strictest;
}

/* As the programs of 1987 have it, corrected. */
static armtol_part part_of_sphere(const armtol_answer *answer, size_t i, const link_tolerances *tolerances)
{
    const double *of = tolerances->of;
    const armtol_link *link = &answer->links[i];
    const armtol_shares shares = {fmin(of[ARMTOL_A], of[ARMTOL_D]), of[ARMTOL_ALPHA]};
    const double distance = strictest_distance(answer, i, shares.distance);
    return (armtol_part){
        .distance = distance,
        .angle = shares.angle,
        .motor = link->joint == ARMTOL_FIXED ? (double)NAN : armtol_motor_tolerance(link, distance, &shares),
    };
}

void answer_make_parts(armtol_answer *answer, const armtol_question *question)
{
    const bool sphere = question->tolerances == NULL && question->method == ARMTOL_METHOD_SPHERE;
    for (size_t i = 0; i < answer->n_links; i++) {
        const armtol_link *link = &answer->links[i];
        const link_tolerances of = of_link(answer, i);
        armtol_part *part = &answer->parts[i];
        *part = sphere ? part_of_sphere(answer, i, &of) : part_of(link, &of);
        part->drive = answer_drive_error(answer, question, i);
    }
}

double answer_lever(const armtol_answer *answer)
{
    const double *offset = answer->tool.offset;
    double longest = 0;
    for (size_t pose = 0; pose < answer->n_poses; pose++) {
        const armtol_link *links = armtol_answer_links(answer, pose);
        double length = sqrt(offset[0] * offset[0] + offset[1] * offset[1] + offset[2] * offset[2]);
        for (size_t i = 0; i < answer->n_links; i++) {
            length += sqrt(links[i].a * links[i].a + links[i].d * links[i].d);
        }
        longest = fmax(longest, length);
    }
    return longest > 0 ? longest : 1;
}
