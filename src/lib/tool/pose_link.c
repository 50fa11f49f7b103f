#include "lib/tool/pose_link.h"

#include "lib/lanes/lanes.h"

#define LANES 1
#include "lib/lanes/sincos_kernel.h"
#undef LANES
#if LANES_ARE_VECTORS
#define LANES 2
#include "lib/lanes/sincos_kernel.h"
#undef LANES
#endif
#if LANES_HAVE_MACHINES
#define LANES 4
#include "lib/lanes/sincos_kernel.h"
#undef LANES
#define LANES 8
#include "lib/lanes/sincos_kernel.h"
#undef LANES
#endif

/* theta, alpha and beta of some links: the angles of many are done side by side. */
typedef struct angles {
    double theta[BLOCK], alpha[BLOCK], beta[BLOCK];
} angles;

LANE_INLINE void take_sines(const angles *of, angles *sines, angles *cosines, int lanes)
{
    LANES_CALL(sines_cosines, lanes, (of->theta, sines->theta, cosines->theta));
    LANES_CALL(sines_cosines, lanes, (of->alpha, sines->alpha, cosines->alpha));
    LANES_CALL(sines_cosines, lanes, (of->beta, sines->beta, cosines->beta));
}

LANES_MACHINES(take_sines, (const angles *of, angles *sines, angles *cosines), of, sines, cosines)

void columns_of_link(armtol_kind kind, size_t *column, size_t columns[ARMTOL_PARAMETER_COUNT])
{
    size_t count;
    const armtol_parameter *parameters = armtol_kind_parameters(kind, &count);
    for (size_t i = 0; i < ARMTOL_PARAMETER_COUNT; i++) {
        columns[i] = NO_COLUMN;
    }
    for (size_t i = 0; i < count; i++) {
        columns[parameters[i]] = (*column)++;
    }
}

static armtol_pose_link pose_link_of(const armtol_link *link, const angles *sines, const angles *cosines,
                                     size_t i)
{
    return (armtol_pose_link){
        .joint = link->joint,
        .turned = link->joint == ARMTOL_REVOLUTE || link->theta != 0,
        .shifted = link->joint == ARMTOL_PRISMATIC || link->a != 0 || link->d != 0,
        .tilted = link->alpha != 0,
        .bent = link->beta != 0,
        .a = link->a,
        .d = link->d,
        .theta = link->theta,
        .cos_theta = cosines->theta[i],
        .sin_theta = sines->theta[i],
        .cos_alpha = cosines->alpha[i],
        .sin_alpha = sines->alpha[i],
        .cos_beta = cosines->beta[i],
        .sin_beta = sines->beta[i],
    };
}

size_t pose_links_of(const armtol_link links[], size_t n_links, size_t *column, armtol_pose_link made[])
{
    const size_t n = n_links < POSE_LINKS ? n_links : POSE_LINKS;
    angles of = {{0}, {0}, {0}}, sines, cosines;
    for (size_t i = 0; i < n; i++) {
        of.theta[i] = links[i].theta;
        of.alpha[i] = links[i].alpha;
        of.beta[i] = links[i].beta;
    }
    take_sines_on_machine(&of, &sines, &cosines);
    for (size_t i = 0; i < n; i++) {
        made[i] = pose_link_of(&links[i], &sines, &cosines, i);
        columns_of_link(links[i].kind, column, made[i].columns);
    }
    return n;
}
