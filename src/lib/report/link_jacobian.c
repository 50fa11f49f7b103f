#include "armtol/link_jacobian.h"

#include "lib/report/arithmetic.h"
#include "lib/report/trigonometry.h"

#include <stdbool.h>

/* What the columns are made of. */
typedef struct ingredients {
    double ca, sa;   /* cos, sin alpha */
    double cb, sb;   /* cos beta, and sin beta as the columns take it */
    double unit_y;   /* the direction of a rotation about y */
    double lever;    /* the distance from the joint's axis to the frame behind the link */
} ingredients;

static double lever_of(const armtol_link *link, const armtol_errata *errata)
{
    /* Erratum `parallel-arm`: d stands where the length a belongs. */
    if (link->kind == ARMTOL_PPR && errata->parallel_arm) {
        return link->d;
    }
    /* Erratum `prismatic-alpha`: alpha stands where the length a belongs. */
    if (link->kind == ARMTOL_PPP && errata->prismatic_alpha) {
        return link->alpha;
    }
    return link->a;
}

static ingredients ingredients_of(const armtol_link *link, const armtol_errata *errata)
{
    /* Erratum `beta-sign`: the columns turn by -beta while the link transform turns by +beta. */
    const double sense = errata->beta_sign ? -1.0 : 1.0;
    return (ingredients){
        .ca = store(errata, cosine_of(errata, link->alpha)),
        .sa = store(errata, sine_of(errata, link->alpha)),
        .cb = store(errata, cosine_of(errata, link->beta)),
        .sb = sense * store(errata, sine_of(errata, link->beta)),
        .unit_y = sense,
        .lever = lever_of(link, errata),
    };
}

/* The link turns or slides along z of the frame before it, which the frame behind sees through alpha, beta. */
static void column_of(armtol_parameter parameter, const ingredients *g, double twist[6])
{
    const double axis_z[3] = {-g->ca * g->sb, g->sa, g->ca * g->cb};
    const double axis_x[3] = {g->cb, 0, g->sb};
    const double about_z[6] = {g->lever * g->sa * g->sb, g->lever * g->ca, -g->lever * g->sa * g->cb,
                               axis_z[0], axis_z[1], axis_z[2]};
    const double along_z[6] = {axis_z[0], axis_z[1], axis_z[2], 0, 0, 0};
    const double along_x[6] = {axis_x[0], axis_x[1], axis_x[2], 0, 0, 0};
    const double about_x[6] = {0, 0, 0, axis_x[0], axis_x[1], axis_x[2]};
    const double about_y[6] = {0, 0, 0, 0, g->unit_y, 0};
    const double *const twists[ARMTOL_PARAMETER_COUNT] = {
        [ARMTOL_THETA] = about_z, [ARMTOL_D] = along_z, [ARMTOL_A] = along_x,
        [ARMTOL_ALPHA] = about_x, [ARMTOL_BETA] = about_y,
    };
    for (int i = 0; i < 6; i++) {
        twist[i] = twists[parameter][i];
    }
}

/*
 * Whether an element stays what it was. gppp, as the scan reads, clears columns 0 to 2 of its five; in the other two,
 * those of alpha and beta, it sets but what turns the frame.
 */
static bool is_left_alone(armtol_kind kind, armtol_parameter parameter, int i, const armtol_errata *errata)
{
    const bool set = parameter == ARMTOL_ALPHA ? i == 3 || i == 5 : parameter != ARMTOL_BETA || i == 4;
    /* Erratum `gppp-clearing`: what is not set is not cleared either. */
    return errata->gppp_clearing && kind == ARMTOL_PPP && !set;
}

armtol_status armtol_link_jacobian(const armtol_link *link, const armtol_errata *errata,
                                   double g[6][ARMTOL_PARAMETER_COUNT], size_t *count)
{
    size_t n = 0;
    const armtol_parameter *parameters = armtol_kind_parameters(link->kind, &n);
    if (parameters == NULL) {
        return ARMTOL_BAD_KIND;
    }
    const ingredients made_of = ingredients_of(link, errata);
    for (size_t k = 0; k < n; k++) {
        double twist[6];
        column_of(parameters[k], &made_of, twist);
        for (int i = 0; i < 6; i++) {
            if (!is_left_alone(link->kind, parameters[k], i, errata)) {
                g[i][k] = store(errata, twist[i]);
            }
        }
    }
    *count = n;
    return ARMTOL_OK;
}
