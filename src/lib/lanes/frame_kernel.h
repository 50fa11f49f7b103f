/* A kernel (lanes.h): a frame that is carried along a chain. */

/* Its axes and its origin. */
typedef struct LANED(frame) {
    TRIPLE x, y, z, origin;
} LANED(frame);

/* At that place, in every lane. */
LANE_INLINE void LANED(put_frame)(const armtol_transform *place, LANED(frame) *frame)
{
    const double(*m)[4] = place->m;
    LANED(set_triple)(m[0][0], m[1][0], m[2][0], frame->x);
    LANED(set_triple)(m[0][1], m[1][1], m[2][1], frame->y);
    LANED(set_triple)(m[0][2], m[1][2], m[2][2], frame->z);
    LANED(set_triple)(m[0][3], m[1][3], m[2][3], frame->origin);
}

/* Turn two of its axes, from the first to the second: x and y about z, y and z about x, z and x about y. */
LANE_INLINE void LANED(turn)(TRIPLE first, TRIPLE second, const REAL *cosine, const REAL *sine)
{
    for (int i = 0; i < PARTS; i++) {
        const PART turned = first[i] * *cosine + second[i] * *sine;
        second[i] = second[i] * *cosine - first[i] * *sine;
        first[i] = turned;
    }
}

/* By an angle that all lanes share. */
LANE_INLINE void LANED(turn_all)(TRIPLE first, TRIPLE second, double cosine, double sine)
{
    const REAL zero = {0};
    const REAL c = zero + cosine, s = zero + sine;
    LANED(turn)(first, second, &c, &s);
}

LANE_INLINE void LANED(advance)(LANED(frame) *frame, const REAL *a, const REAL *d)
{
    for (int i = 0; i < PARTS; i++) {
        frame->origin[i] += frame->x[i] * *a + frame->z[i] * *d;
    }
}

/* A point that is fixed in the frame. */
LANE_INLINE void LANED(point_of)(const LANED(frame) *frame, const double offset[3], TRIPLE point)
{
    for (int i = 0; i < PARTS; i++) {
        point[i] = frame->origin[i] +
                   (frame->x[i] * offset[0] + frame->y[i] * offset[1] + frame->z[i] * offset[2]);
    }
}
