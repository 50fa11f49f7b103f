/* A kernel (lanes.h): one pose alone. */

/*
 * As many links as a block has lanes, of which the sines and cosines are given: they are done side by side.
 * Returns the joint values of the links behind.
 */
LANE_INLINE const double *LANED(walk_some)(const armtol_pose_link links[], size_t n_links, const double q[],
                                           const double sines[BLOCK], const double cosines[BLOCK],
                                           const matrix_view *matrix, LANED(frame) *frame)
{
    for (size_t i = 0; i < n_links && i < BLOCK; i++) {
        const armtol_pose_link *const link = &links[i];
        LANED(setting) setting = {cosines[i], sines[i], link->d};
        if (link->joint == ARMTOL_PRISMATIC) {
            setting.d += *q;
        }
        LANED(walk_link)(link, &setting, matrix, frame);
        q += link->joint != ARMTOL_FIXED;
    }
    return q;
}

LANE_INLINE void LANED(one_pose)(const armtol_poses *poses, const double q[], double matrix[],
                                 armtol_bounds *bounds, int lanes)
{
    const matrix_view view = {matrix, poses->n_columns, 1};
    LANED(frame) frame;
    LANED(put_frame)(&base, &frame);
    for (size_t i = 0; i < poses->n_links; i += BLOCK) {
        double sines[BLOCK], cosines[BLOCK];
        sines_of(poses->links + i, poses->n_links - i, q, sines, cosines, lanes);
        q = LANED(walk_some)(poses->links + i, poses->n_links - i, q, sines, cosines, &view, &frame);
    }
    /* compiled once for each way of counting: here a question at every column would be felt */
    if (poses->tool.frame == ARMTOL_TOOL_FRAME) {
        LANED(finish)(poses, &frame, &frame, &view, bounds);
    } else {
        LANED(finish)(poses, &frame, NULL, &view, bounds);
    }
}
