#ifndef ARMTOL_LIB_TOOL_COLUMNS_H
#define ARMTOL_LIB_TOOL_COLUMNS_H

#include "lib/lanes/frame.h"
#include "lib/tool/pose_link.h"

/*
 * A from the axes of the links (lanes.h). A unit error of an angle turns all behind it about its axis, which moves the
 * tool point by axis x (tool point - point of the axis); one of a length moves it along the axis. The axes are z of the
 * frame before the link for theta and d, x turned by theta for a and alpha, y behind the link for beta.
 *
 * The tool point is known when all links are walked. Until then A keeps what is needed then, so that no other memory
 * is: the columns of theta, alpha and beta their axes, in their lower halves, and that of theta the point before the
 * link in its upper half. Every kind of link counts theta and alpha. The axes of alpha and beta go through the point
 * before the next link; d and a have the axes of theta and alpha.
 */

/* A, or lanes of a block of them: element (i, k) of the first lane at first[i * row + k * column]. */
typedef struct matrix_view {
    double *first;
    size_t row, column;
} matrix_view;

/* What the joint of a link sets. */
typedef struct setting {
    real cosine, sine; /* of theta */
    real d;
} setting;

/* The tool point, and whether errors are counted along the axes of a frame instead of the base's. */
typedef struct target {
    triple point;
    bool turned;
    const frame *along;
} target;

/* The upper half of a column (half 0) or its lower half (1). Rows by addition: a compiler adds for 2 and scales. */
LANE_INLINE double *half_of(const matrix_view *matrix, size_t column, size_t half)
{
    return matrix->first + 3 * half * matrix->row + column * matrix->column;
}

LANE_INLINE void read_half(const matrix_view *matrix, size_t column, size_t half, triple read)
{
    const double *const at = half_of(matrix, column, half);
    load(at, &read[0]);
    load(at + matrix->row, &read[1]);
    load(at + 2 * matrix->row, &read[2]);
}

LANE_INLINE void write_half(const matrix_view *matrix, size_t column, size_t half, const triple written)
{
    double *const at = half_of(matrix, column, half);
    unload(&written[0], at);
    unload(&written[1], at + matrix->row);
    unload(&written[2], at + 2 * matrix->row);
}

/* Move the frame across the link, and write into the link's columns what can be known of them. */
LANE_INLINE void walk_link(const armtol_pose_link *link, const setting *setting, const matrix_view *matrix,
                           frame *frame)
{
    const real zero = {0}, a = zero + link->a;
    const size_t *const columns = link->columns;
    write_half(matrix, columns[ARMTOL_THETA], 0, frame->origin);
    write_half(matrix, columns[ARMTOL_THETA], 1, frame->z);
    if (link->turned) {
        turn(frame->x, frame->y, &setting->cosine, &setting->sine);
    }
    if (link->shifted) {
        advance(frame, &a, &setting->d);
    }
    write_half(matrix, columns[ARMTOL_ALPHA], 1, frame->x);
    if (link->tilted) {
        turn_all(frame->y, frame->z, link->cos_alpha, link->sin_alpha);
    }
    if (columns[ARMTOL_BETA] != NO_COLUMN) {
        write_half(matrix, columns[ARMTOL_BETA], 1, frame->y);
    }
    if (link->bent) {
        turn_all(frame->z, frame->x, link->cos_beta, link->sin_beta);
    }
}

/* From a point to the tool point. */
LANE_INLINE void way_from(const triple point, const target *target, triple way)
{
    for (int i = 0; i < 3; i++) {
        way[i] = target->point[i] - point[i];
    }
}

/* From the point before the link whose columns these are; they are not yet those of A. */
LANE_INLINE void way_before(const size_t columns[ARMTOL_PARAMETER_COUNT], const matrix_view *matrix,
                            const target *target, triple way)
{
    triple point;
    read_half(matrix, columns[ARMTOL_THETA], 0, point);
    way_from(point, target, way);
}

/* The axis of an angle's column, and how a turn about it moves the tool point, to which `way` leads from the axis. */
LANE_INLINE void finish_axis(const matrix_view *matrix, size_t column, const target *target, const triple way,
                             triple axis, triple about)
{
    read_half(matrix, column, 1, axis);
    cross(axis, way, about);
    if (target->turned) {
        count_along(target->along, about);
        count_along(target->along, axis);
    }
}

/* The columns of an angle and of the length along its axis, if that is counted. */
LANE_INLINE void write_axis(const matrix_view *matrix, size_t angle, size_t length, const target *target,
                            const triple axis, const triple about)
{
    const real zero = {0};
    const triple none = {zero, zero, zero};
    write_half(matrix, angle, 0, about);
    if (target->turned) {
        write_half(matrix, angle, 1, axis);
    }
    if (length != NO_COLUMN) {
        write_half(matrix, length, 0, axis);
        write_half(matrix, length, 1, none);
    }
}

#endif
