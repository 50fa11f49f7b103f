#ifndef ARMTOL_LIB_TOOL_COLUMNS_H
#define ARMTOL_LIB_TOOL_COLUMNS_H

#include "lib/lanes/frame.h"
#include "lib/tool/pose_link.h"

/*
 * A from the axes of the links (lanes.h). A unit error of an angle turns all behind it about its axis, which moves the
 * tool point by axis x (tool point - point of the axis); one of a length moves it along the axis. The axes are z of the
 * frame before the link for theta and d, x turned by theta for a and alpha, y behind the link for beta.
 *
 * The tool point is known when all links are walked. Until then an angle's column keeps the point of its axis where the
 * motion of the tool point will be, so that no other memory is needed.
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

/* The tool point, and the frame along whose axes errors are counted: NULL for the base's. */
typedef struct target {
    triple point;
    const frame *along;
} target;

/* Of the rows of A: of its upper three over lengths and over angles, of its lower three over angles. */
typedef struct squares {
    triple lengths, moving, turning;
} squares;

/* The upper half of a column (half 0) or its lower half (1). */
LANE_INLINE void read_half(const matrix_view *matrix, size_t column, size_t half, triple read)
{
    for (size_t i = 0; i < 3; i++) {
        load(matrix->first + (3 * half + i) * matrix->row + column * matrix->column, &read[i]);
    }
}

LANE_INLINE void write_half(const matrix_view *matrix, size_t column, size_t half, const triple written)
{
    for (size_t i = 0; i < 3; i++) {
        unload(&written[i], matrix->first + (3 * half + i) * matrix->row + column * matrix->column);
    }
}

LANE_INLINE void write_column(const matrix_view *matrix, size_t column, const triple upper, const triple lower)
{
    if (column != NO_COLUMN) {
        write_half(matrix, column, 0, upper);
        write_half(matrix, column, 1, lower);
    }
}

/* Move the frame across the link, and write the link's columns as far as they can be known. */
LANE_INLINE void walk_link(const armtol_pose_link *link, const setting *setting, const matrix_view *matrix,
                           frame *frame)
{
    const real zero = {0}, a = zero + link->a;
    const triple none = {zero, zero, zero};
    const size_t *const columns = link->columns;
    write_column(matrix, columns[ARMTOL_THETA], frame->origin, frame->z);
    write_column(matrix, columns[ARMTOL_D], frame->z, none);
    if (link->turned) {
        turn(frame->x, frame->y, &setting->cosine, &setting->sine);
    }
    if (link->shifted) {
        advance(frame, &a, &setting->d);
    }
    write_column(matrix, columns[ARMTOL_A], frame->x, none);
    write_column(matrix, columns[ARMTOL_ALPHA], frame->origin, frame->x);
    if (link->tilted) {
        turn_all(frame->y, frame->z, link->cos_alpha, link->sin_alpha);
    }
    write_column(matrix, columns[ARMTOL_BETA], frame->origin, frame->y);
    if (link->bent) {
        turn_all(frame->z, frame->x, link->cos_beta, link->sin_beta);
    }
}

LANE_INLINE void finish_length(const matrix_view *matrix, size_t column, const target *target, squares *squares)
{
    if (column == NO_COLUMN) {
        return;
    }
    triple v;
    read_half(matrix, column, 0, v);
    if (target->along != NULL) {
        count_along(target->along, v);
        write_half(matrix, column, 0, v);
    }
    for (int i = 0; i < 3; i++) {
        squares->lengths[i] += v[i] * v[i];
    }
}

LANE_INLINE void finish_angle(const matrix_view *matrix, size_t column, const target *target, squares *squares)
{
    if (column == NO_COLUMN) {
        return;
    }
    triple r, v, w;
    read_half(matrix, column, 0, r);
    read_half(matrix, column, 1, w);
    for (int i = 0; i < 3; i++) {
        r[i] = target->point[i] - r[i];
    }
    cross(w, r, v);
    if (target->along != NULL) {
        count_along(target->along, v);
        count_along(target->along, w);
        write_half(matrix, column, 1, w);
    }
    write_half(matrix, column, 0, v);
    for (int i = 0; i < 3; i++) {
        squares->moving[i] += v[i] * v[i];
        squares->turning[i] += w[i] * w[i];
    }
}

LANE_INLINE void finish_link(const size_t columns[ARMTOL_PARAMETER_COUNT], const matrix_view *matrix,
                             const target *target, squares *squares)
{
    finish_angle(matrix, columns[ARMTOL_THETA], target, squares);
    finish_length(matrix, columns[ARMTOL_D], target, squares);
    finish_length(matrix, columns[ARMTOL_A], target, squares);
    finish_angle(matrix, columns[ARMTOL_ALPHA], target, squares);
    finish_angle(matrix, columns[ARMTOL_BETA], target, squares);
}

#endif
