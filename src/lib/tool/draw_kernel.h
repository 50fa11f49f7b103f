/* A kernel (lanes.h): draws, uniform in [-1, 1). bits are states of splitmix64 before they are mixed. */

/*
 * The upper 53 bits, over 2^52, less 1; exactly, and without a conversion, which not every machine has for
 * vectors: as the lowest bits of 1 and of 2^32 their lower 32 count 2^-52 each, the upper 21 2^-20.
 */
LANE_INLINE void LANED(unit)(const BITS *mixed, REAL *draw)
{
    const BITS bits = *mixed >> 11;
    const BITS lower_bits = (bits & 0xffffffffu) | 0x3ff0000000000000u;
    const BITS upper_bits = (bits >> 32) | 0x41f0000000000000u;
    REAL lower, upper;
    memcpy(&lower, &lower_bits, sizeof lower);
    memcpy(&upper, &upper_bits, sizeof upper);
    *draw = (upper - (0x1p32 + 2)) + lower;
}

/* n at once. */
LANE_INLINE void LANED(uniform)(size_t n, BITS bits[], REAL draws[])
{
    for (size_t k = 0; k < n; k++) {
        bits[k] = SPLITMIX_FIRST(bits[k]);
    }
    for (size_t k = 0; k < n; k++) {
        bits[k] = SPLITMIX_SECOND(bits[k]);
    }
    for (size_t k = 0; k < n; k++) {
        bits[k] = SPLITMIX_LAST(bits[k]);
        LANED(unit)(&bits[k], &draws[k]);
    }
}
