/* A kernel (lanes.h): A of placed links, nothing of which was prepared. */

LANE_INLINE void LANED(walk_all)(const armtol_link links[], size_t n_links, const matrix_view *matrix,
                                 LANED(frame) *frame)
{
    size_t column = 0, n = 0;
    for (size_t done = 0; done < n_links; done += n) {
        armtol_pose_link some[POSE_LINKS];
        n = pose_links_of(links + done, n_links - done, &column, some);
        for (size_t i = 0; i < n; i++) {
            const LANED(setting) setting = {some[i].cos_theta, some[i].sin_theta, some[i].d};
            LANED(walk_link)(&some[i], &setting, matrix, frame);
        }
    }
}

LANE_INLINE void LANED(finish_all)(const armtol_link links[], size_t n_links, const LANED(target) *target,
                                   const matrix_view *matrix)
{
    LANED(squares) unused;
    size_t column = 0;
    LANED(clear_squares)(&unused);
    for (size_t i = 0; i < n_links; i++) {
        size_t columns[ARMTOL_PARAMETER_COUNT];
        columns_of_link(links[i].kind, &column, columns);
        LANED(finish_link)(columns, matrix, target, &unused);
    }
}

LANE_INLINE void LANED(tool_matrix)(const armtol_link links[], size_t n_links, const armtol_tool_point *tool,
                                    const matrix_view *matrix)
{
    LANED(frame) frame;
    LANED(target) target;
    LANED(put_frame)(&base, &frame);
    LANED(walk_all)(links, n_links, matrix, &frame);
    target.along = tool->frame == ARMTOL_TOOL_FRAME ? &frame : NULL;
    LANED(point_of)(&frame, tool->offset, target.point);
    LANED(finish_all)(links, n_links, &target, matrix);
}
