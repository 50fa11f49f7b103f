#ifndef TEST_COVER_H
#define TEST_COVER_H

/* A function of directions that is convex and in proportion to their length, as the support of a convex body is. */
typedef double support(const double direction[3], const void *context);

/*
 * A bound of its largest value on the sphere, by branch and bound: no more than 1 + accuracy times the value somewhere.
 * A direction within three others, u = sum of l_i u_i with l_i >= 0, has h(u) <= sum of l_i h(u_i) <= largest h(u_i)
 * sum of l_i, and the sum is no more than 1 by the distance of the three's plane from the origin.
 */
double cover_of_sphere(support *h, const void *context, double accuracy);

#endif
