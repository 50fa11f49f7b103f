/* A kernel (lanes.h): what is not done to each component of a point or direction alike. */

LANE_INLINE void LANED(set_triple)(double x, double y, double z, TRIPLE triple)
{
    const REAL zero = {0};
    triple[0] = zero + x;
    triple[1] = zero + y;
    triple[2] = zero + z;
}

LANE_INLINE void LANED(get_triple)(const TRIPLE triple, REAL components[3])
{
    for (int i = 0; i < 3; i++) {
        components[i] = triple[i];
    }
}

/* From and to memory, components `step` apart. */
LANE_INLINE void LANED(read_triple)(const double from[], size_t step, TRIPLE triple)
{
    for (size_t i = 0; i < 3; i++) {
        LANED(read)(from + i * step, &triple[i]);
    }
}

LANE_INLINE void LANED(write_triple)(const TRIPLE triple, double to[], size_t step)
{
    for (size_t i = 0; i < 3; i++) {
        LANED(write)(&triple[i], to + i * step);
    }
}

LANE_INLINE void LANED(cross)(const TRIPLE one, const TRIPLE other, TRIPLE product)
{
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        product[i] = one[j] * other[k] - one[k] * other[j];
    }
}

/* What the components of a direction are along three axes; in place. */
LANE_INLINE void LANED(along_axes)(const TRIPLE x, const TRIPLE y, const TRIPLE z, TRIPLE direction)
{
    const REAL along_x = x[0] * direction[0] + x[1] * direction[1] + x[2] * direction[2];
    const REAL along_y = y[0] * direction[0] + y[1] * direction[1] + y[2] * direction[2];
    const REAL along_z = z[0] * direction[0] + z[1] * direction[1] + z[2] * direction[2];
    direction[0] = along_x;
    direction[1] = along_y;
    direction[2] = along_z;
}
