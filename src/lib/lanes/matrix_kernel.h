/*
 * A kernel (lanes.h): A from the axes of the links. A unit error of an angle turns all behind it about its
 * axis, which moves the tool point by axis x (tool point - point of the axis); one of a length moves it along
 * the axis. The axes are z of the frame before the link for theta and d, x turned by theta for a and alpha, y
 * behind the link for beta.
 *
 * The tool point is known when all links are walked. Until then an angle's column keeps the point of its axis
 * where the motion of the tool point will be, so that no other memory is needed.
 */

/* What the joint of a link sets. */
typedef struct LANED(setting) {
    REAL cosine, sine; /* of theta */
    REAL d;
} LANED(setting);

/* The tool point, and the frame along whose axes errors are counted: NULL for the base's. */
typedef struct LANED(target) {
    TRIPLE point;
    const LANED(frame) *along;
} LANED(target);

/* Of the rows of A: of its upper three over lengths and over angles, of its lower three over angles. */
typedef struct LANED(squares) {
    TRIPLE lengths, moving, turning;
} LANED(squares);

LANE_INLINE double *LANED(column_at)(const matrix_view *matrix, size_t column)
{
    return matrix->first + column * matrix->column;
}

LANE_INLINE void LANED(write_column)(const matrix_view *matrix, size_t column, const TRIPLE upper,
                                     const TRIPLE lower)
{
    if (column != NO_COLUMN) {
        double *const at = LANED(column_at)(matrix, column);
        LANED(write_triple)(upper, at, matrix->row);
        LANED(write_triple)(lower, at + 3 * matrix->row, matrix->row);
    }
}

/* Move the frame across the link, and write the link's columns as far as they can be known. */
LANE_INLINE void LANED(walk_link)(const armtol_pose_link *link, const LANED(setting) *setting,
                                  const matrix_view *matrix, LANED(frame) *frame)
{
    const REAL zero = {0}, a = zero + link->a;
    TRIPLE none;
    LANED(set_triple)(0, 0, 0, none);
    const size_t *const columns = link->columns;
    LANED(write_column)(matrix, columns[ARMTOL_THETA], frame->origin, frame->z);
    LANED(write_column)(matrix, columns[ARMTOL_D], frame->z, none);
    if (link->turned) {
        LANED(turn)(frame->x, frame->y, &setting->cosine, &setting->sine);
    }
    if (link->shifted) {
        LANED(advance)(frame, &a, &setting->d);
    }
    LANED(write_column)(matrix, columns[ARMTOL_A], frame->x, none);
    LANED(write_column)(matrix, columns[ARMTOL_ALPHA], frame->origin, frame->x);
    if (link->tilted) {
        LANED(turn_all)(frame->y, frame->z, link->cos_alpha, link->sin_alpha);
    }
    LANED(write_column)(matrix, columns[ARMTOL_BETA], frame->origin, frame->y);
    if (link->bent) {
        LANED(turn_all)(frame->z, frame->x, link->cos_beta, link->sin_beta);
    }
}

LANE_INLINE void LANED(count_along)(const LANED(frame) *axes, TRIPLE direction)
{
    LANED(along_axes)(axes->x, axes->y, axes->z, direction);
}

LANE_INLINE void LANED(finish_length)(const matrix_view *matrix, size_t column, const LANED(target) *target,
                                      LANED(squares) *squares)
{
    if (column == NO_COLUMN) {
        return;
    }
    TRIPLE v;
    double *const at = LANED(column_at)(matrix, column);
    LANED(read_triple)(at, matrix->row, v);
    if (target->along != NULL) {
        LANED(count_along)(target->along, v);
        LANED(write_triple)(v, at, matrix->row);
    }
    for (int i = 0; i < PARTS; i++) {
        squares->lengths[i] += v[i] * v[i];
    }
}

LANE_INLINE void LANED(finish_angle)(const matrix_view *matrix, size_t column, const LANED(target) *target,
                                     LANED(squares) *squares)
{
    if (column == NO_COLUMN) {
        return;
    }
    TRIPLE r, v, w;
    double *const at = LANED(column_at)(matrix, column);
    LANED(read_triple)(at, matrix->row, r);
    LANED(read_triple)(at + 3 * matrix->row, matrix->row, w);
    for (int i = 0; i < PARTS; i++) {
        r[i] = target->point[i] - r[i];
    }
    LANED(cross)(w, r, v);
    if (target->along != NULL) {
        LANED(count_along)(target->along, v);
        LANED(count_along)(target->along, w);
        LANED(write_triple)(w, at + 3 * matrix->row, matrix->row);
    }
    LANED(write_triple)(v, at, matrix->row);
    for (int i = 0; i < PARTS; i++) {
        squares->moving[i] += v[i] * v[i];
        squares->turning[i] += w[i] * w[i];
    }
}

LANE_INLINE void LANED(finish_link)(const size_t columns[ARMTOL_PARAMETER_COUNT], const matrix_view *matrix,
                                    const LANED(target) *target, LANED(squares) *squares)
{
    LANED(finish_angle)(matrix, columns[ARMTOL_THETA], target, squares);
    LANED(finish_length)(matrix, columns[ARMTOL_D], target, squares);
    LANED(finish_length)(matrix, columns[ARMTOL_A], target, squares);
    LANED(finish_angle)(matrix, columns[ARMTOL_ALPHA], target, squares);
    LANED(finish_angle)(matrix, columns[ARMTOL_BETA], target, squares);
}

LANE_INLINE void LANED(clear_squares)(LANED(squares) *squares)
{
    LANED(set_triple)(0, 0, 0, squares->lengths);
    LANED(set_triple)(0, 0, 0, squares->moving);
    LANED(set_triple)(0, 0, 0, squares->turning);
}
