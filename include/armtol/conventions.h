#ifndef ARMTOL_CONVENTIONS_H
#define ARMTOL_CONVENTIONS_H

/*
 * Conventions of the library, said once. Every other header means these.
 *
 * Units        Lengths in one unit of the caller's choice, the same throughout (the arms of 1987 are in
 *              millimetres). Angles in radians, right-handed: counter-clockwise, seen against the axis.
 *
 * Links        Denavit-Hartenberg parameters in Paul's order (Robot Manipulators, 1981), modified by Hayati's
 *              beta for parallel axes (CDC 1983); not Craig's, which are called modified too. Hahn 1987, Eq. (4.1):
 *
 *                  T = Rot(z, theta) Trans(a, 0, d) Rot(x, alpha) Rot(y, beta)
 *
 *              takes coordinates in the frame behind the link to coordinates in the frame before it.
 *              A chain is T_0 T_1 ... T_(n-1), from the base (link 0) to the tool (link n-1).
 *
 * Second view  The forward kinematics behind the `check` lines of 1987 is in Craig's order
 *              (Introduction to Robotics, 1986): Rot(x, alpha) Trans(a, 0, 0) Rot(z, theta) Trans(0, 0, d),
 *              alpha and a being those of the link before. See craig.h.
 *
 * Twists       A small motion is (v; w): three linear components, then three rotations, both in the
 *              coordinates of one frame; v is the motion of the body point that lies at that frame's origin.
 *
 * Storage      Matrices are row-major. A matrix A of 6 rows and n columns is an array of 6 n doubles, its
 *              element (i, j) at A[i * n + j].
 *
 * Arithmetic   Values are doubles. With the erratum `float` every stored result is a float's value, as in
 *              K&R C: expressions in double, one rounding to float at each assignment. See errata.h.
 *
 * Aliasing     An output array may not overlap any input, unless its routine says that it may. Results that
 *              are structs are returned by value and know no aliasing.
 *
 * Errors       Routines that can fail return an armtol_status and leave their outputs untouched when they
 *              do, unless they say otherwise. Nothing here prints, exits or keeps state. Memory is the
 *              caller's, but for what a create routine makes and a destroy routine frees (answer.h,
 *              budget.h), and while armtol_verify runs, which alone begins threads.
 */

/* A homogeneous transform; the last row is 0 0 0 1. */
typedef struct armtol_transform {
    double m[4][4];
} armtol_transform;

/* A map of twists from one frame to another (the adjoint of a transform). */
typedef struct armtol_adjoint {
    double m[6][6];
} armtol_adjoint;

#endif
