/* A kernel (lanes.h): what is not an operator of C. */

LANE_INLINE void LANED(choose)(const BITS *mask, const REAL *where_set, const REAL *elsewhere, REAL *chosen)
{
    BITS one, other;
    memcpy(&one, where_set, sizeof one);
    memcpy(&other, elsewhere, sizeof other);
    one = other ^ ((one ^ other) & *mask);
    memcpy(chosen, &one, sizeof one);
}

LANE_INLINE void LANED(make_larger)(REAL *value, const REAL *other)
{
    BITS mask;
    LANED(less)(value, other, &mask);
    LANED(choose)(&mask, other, value, value);
}

LANE_INLINE void LANED(take_root)(REAL *value)
{
    double lanes[LANES];
    LANED(write)(value, lanes);
    for (int l = 0; l < LANES; l++) {
        lanes[l] = sqrt(lanes[l]);
    }
    LANED(read)(lanes, value);
}
