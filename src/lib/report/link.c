#include "armtol/link.h"

#include "lib/report/arithmetic.h"
#include "lib/report/finite.h"

typedef struct kind_row {
    const char *name;
    size_t count;
    armtol_parameter parameters[ARMTOL_PARAMETER_COUNT];
} kind_row;

static const kind_row kinds[ARMTOL_KIND_COUNT] = {
    [ARMTOL_NPR] = {"npr", 4, {ARMTOL_THETA, ARMTOL_D, ARMTOL_A, ARMTOL_ALPHA}},
    [ARMTOL_NPP] = {"npp", 3, {ARMTOL_THETA, ARMTOL_D, ARMTOL_ALPHA}},
    [ARMTOL_PPR] = {"ppr", 4, {ARMTOL_THETA, ARMTOL_A, ARMTOL_ALPHA, ARMTOL_BETA}},
    [ARMTOL_PPP] = {"ppp", 5, {ARMTOL_D, ARMTOL_THETA, ARMTOL_A, ARMTOL_ALPHA, ARMTOL_BETA}},
};

static const kind_row *row_of(armtol_kind kind)
{
    return (size_t)kind < ARMTOL_KIND_COUNT ? &kinds[kind] : NULL;
}

const armtol_parameter *armtol_kind_parameters(armtol_kind kind, size_t *count)
{
    const kind_row *row = row_of(kind);
    *count = row != NULL ? row->count : 0;
    return row != NULL ? row->parameters : NULL;
}

const char *armtol_kind_name(armtol_kind kind)
{
    const kind_row *row = row_of(kind);
    return row != NULL ? row->name : "?";
}

const char *armtol_parameter_name(armtol_parameter parameter)
{
    static const char *const names[ARMTOL_PARAMETER_COUNT] = {"theta", "d", "a", "alpha", "beta"};
    return (size_t)parameter < ARMTOL_PARAMETER_COUNT ? names[parameter] : "?";
}

bool armtol_parameter_is_length(armtol_parameter parameter)
{
    return parameter == ARMTOL_A || parameter == ARMTOL_D;
}

double *armtol_link_parameter(armtol_link *link, armtol_parameter parameter)
{
    double *const places[ARMTOL_PARAMETER_COUNT] = {
        [ARMTOL_THETA] = &link->theta, [ARMTOL_D] = &link->d,       [ARMTOL_A] = &link->a,
        [ARMTOL_ALPHA] = &link->alpha, [ARMTOL_BETA] = &link->beta,
    };
    return (size_t)parameter < ARMTOL_PARAMETER_COUNT ? places[parameter] : NULL;
}

bool armtol_joint_moves(armtol_joint joint, armtol_parameter parameter)
{
    return (joint == ARMTOL_REVOLUTE && parameter == ARMTOL_THETA) ||
           (joint == ARMTOL_PRISMATIC && parameter == ARMTOL_D);
}

static armtol_status check_link(const armtol_link *link)
{
    if ((size_t)link->kind >= ARMTOL_KIND_COUNT) {
        return ARMTOL_BAD_KIND;
    }
    if ((size_t)link->joint >= ARMTOL_JOINT_COUNT) {
        return ARMTOL_BAD_JOINT;
    }
    const double values[] = {link->a, link->alpha, link->d, link->theta, link->beta};
    return all_finite(values, sizeof values / sizeof values[0]) ? ARMTOL_OK : ARMTOL_NOT_FINITE;
}

armtol_status armtol_links_check(const armtol_link links[], size_t n_links)
{
    armtol_status status = n_links > 0 ? ARMTOL_OK : ARMTOL_NO_LINKS;
    for (size_t i = 0; i < n_links && status == ARMTOL_OK; i++) {
        status = check_link(&links[i]);
    }
    return status;
}

size_t armtol_joint_count(const armtol_link links[], size_t n_links)
{
    size_t count = 0;
    for (size_t i = 0; i < n_links; i++) {
        count += links[i].joint != ARMTOL_FIXED;
    }
    return count;
}

/*
 * The main programs kept each parameter of a link in an array of floats, a[], alpha[], d[], theta[] and beta[],
 * constants and joint values alike. Every later stage reads these; here is where they are stored.
 */
static armtol_link place(const armtol_link *link, const double q[], size_t *joint, const armtol_errata *errata)
{
    const double moved = link->joint == ARMTOL_FIXED ? 0 : q[(*joint)++];
    return (armtol_link){
        .kind = link->kind,
        .joint = link->joint,
        .a = store(errata, link->a),
        .alpha = store(errata, link->alpha),
        .d = store(errata, link->joint == ARMTOL_PRISMATIC ? link->d + moved : link->d),
        .theta = store(errata, link->joint == ARMTOL_REVOLUTE ? link->theta + moved : link->theta),
        .beta = store(errata, link->beta),
    };
}

/* Whether every link keeps finite values when its joint moves and its parameters are stored. placed may be NULL. */
static armtol_status place_all(const armtol_link links[], size_t n_links, const double q[],
                               const armtol_errata *errata, armtol_link placed[])
{
    armtol_status status = ARMTOL_OK;
    size_t joint = 0;
    for (size_t i = 0; i < n_links && status == ARMTOL_OK; i++) {
        const armtol_link link = place(&links[i], q, &joint, errata);
        status = check_link(&link);
        if (placed != NULL) {
            placed[i] = link;
        }
    }
    return status;
}

armtol_status armtol_links_place(const armtol_link links[], size_t n_links, const double q[], size_t n_joints,
                                 const armtol_errata *errata, armtol_link placed[])
{
    armtol_status status = armtol_links_check(links, n_links);
    if (status == ARMTOL_OK && n_joints != armtol_joint_count(links, n_links)) {
        status = ARMTOL_WRONG_SIZE;
    }
    if (status == ARMTOL_OK) {
        status = place_all(links, n_links, q, errata, NULL);
    }
    return status == ARMTOL_OK ? place_all(links, n_links, q, errata, placed) : status;
}
