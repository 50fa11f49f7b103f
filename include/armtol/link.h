#ifndef ARMTOL_LINK_H
#define ARMTOL_LINK_H

#include "armtol/conventions.h"
#include "armtol/errata.h"
#include "armtol/interface.h"
#include "armtol/status.h"

#include <stdbool.h>
#include <stddef.h>

ARMTOL_INTERFACE_BEGIN

/* The parameters of Eq. (4.1). */
typedef enum armtol_parameter {
    ARMTOL_THETA,
    ARMTOL_D,
    ARMTOL_A,
    ARMTOL_ALPHA,
    ARMTOL_BETA,
    ARMTOL_PARAMETER_COUNT
} armtol_parameter;

/*
 * The kinds of link, by joint and by the axis of the next joint (Hahn 1987, after Hayati 1983). The
 * kind says which parameters can be in error, in the order of their columns:
 *   npr  theta, d, a, alpha          non-parallel axes, revolute
 *   npp  theta, d, alpha             non-parallel axes, prismatic
 *   ppr  theta, a, alpha, beta       (nearly) parallel axes, revolute
 *   ppp  d, theta, a, alpha, beta    (nearly) parallel axes, prismatic
 */
typedef enum armtol_kind {
    ARMTOL_NPR,
    ARMTOL_NPP,
    ARMTOL_PPR,
    ARMTOL_PPP,
    ARMTOL_KIND_COUNT
} armtol_kind;

/* Which parameter the joint moves. */
typedef enum armtol_joint {
    ARMTOL_FIXED,
    ARMTOL_REVOLUTE,  /* theta */
    ARMTOL_PRISMATIC, /* d */
    ARMTOL_JOINT_COUNT
} armtol_joint;

/*
 * One row of an arm's table. Every field holds for each kind: a parameter that the kind does not count as an
 * error source still has its nominal value. theta (or d) of a joint is its value at joint value 0.
 */
typedef struct armtol_link {
    armtol_kind kind;
    armtol_joint joint;
    double a;
    double alpha;
    double d;
    double theta;
    double beta;
} armtol_link;

/*
 * The parameters of a kind in column order; *count is their number, at most ARMTOL_PARAMETER_COUNT.
 * NULL, and *count 0, for a value that is no kind.
 */
const armtol_parameter *armtol_kind_parameters(armtol_kind kind, size_t *count);

/* "npr" and so on; "theta" and so on; "?" for a value that is none. */
const char *armtol_kind_name(armtol_kind kind);
const char *armtol_parameter_name(armtol_parameter parameter);

/* Whether the parameter is a length (a, d) rather than an angle. */
bool armtol_parameter_is_length(armtol_parameter parameter);

/* Where the link keeps the parameter; NULL for a value that is none. */
double *armtol_link_parameter(armtol_link *link, armtol_parameter parameter);

/* Whether it is the parameter that such a joint moves. */
bool armtol_joint_moves(armtol_joint joint, armtol_parameter parameter);

/*
 * Whether links are fit for use.
 *
 * Errors, the first that is found:
 *    ARMTOL_NO_LINKS     n_links is 0
 *    ARMTOL_BAD_KIND     a kind, or
 *    ARMTOL_BAD_JOINT    a joint, that is none
 *    ARMTOL_NOT_FINITE   a parameter that is not
 */
armtol_status armtol_links_check(const armtol_link links[], size_t n_links);

/* The number of links that a joint moves. */
size_t armtol_joint_count(const armtol_link links[], size_t n_links);

/*
 * Put joint values into a table.
 *
 * Given:
 *    links, n_links   the table
 *    q, n_joints      one value a joint, in link order
 *    errata           float
 *
 * Returned:
 *    placed           n_links: the value of its joint, if it has one, added to theta or d, and every parameter stored;
 *                     may be links
 *
 * Errors:
 *    those of armtol_links_check
 *    ARMTOL_WRONG_SIZE   n_joints is not the number of joints
 *    ARMTOL_NOT_FINITE   a q that is not, or a sum or a float that overflows
 */
armtol_status armtol_links_place(const armtol_link links[], size_t n_links, const double q[], size_t n_joints,
                                 const armtol_errata *errata, armtol_link placed[]);

ARMTOL_INTERFACE_END

#endif
