#include "fuzz/bytes.h"

#include <math.h>
#include <string.h>

#define QUARTER 1.57079632679489661923

static uint8_t next(bytes *bytes)
{
    if (bytes->left == 0) {
        return 0;
    }
    bytes->left--;
    return *bytes->at++;
}

bytes bytes_start(const uint8_t *data, size_t size)
{
    bytes bytes = {data, size, false, false};
    bytes.tame = bytes_below(&bytes, 4) != 0;
    return bytes;
}

unsigned bytes_below(bytes *bytes, unsigned count)
{
    return next(bytes) % count;
}

/* In [-1, 1), of two bytes. */
static double fraction(bytes *bytes)
{
    const int low = next(bytes), high = next(bytes);
    return (256 * high + low - 32768) / 32768.0;
}

static double any_double(bytes *bytes)
{
    uint8_t raw[sizeof(double)];
    double value;
    for (size_t i = 0; i < sizeof raw; i++) {
        raw[i] = next(bytes);
    }
    memcpy(&value, raw, sizeof value);
    bytes->wild = bytes->wild || !(fabs(value) < 1e6 && (value == 0 || fabs(value) > 1e-12));
    return value;
}

double bytes_number(bytes *bytes, double scale)
{
    switch (next(bytes) % 16) {
    case 0:
    case 1:
    case 2:
        return 0;
    case 3:
        return scale;
    case 4:
        return -scale;
    case 5:
        return scale * fraction(bytes) * pow(10, (int)bytes_below(bytes, 16) - 12);
    case 6:
        return bytes->tame ? scale : any_double(bytes);
    default:
        return scale * fraction(bytes);
    }
}

double bytes_angle(bytes *bytes)
{
    const unsigned kind = bytes_below(bytes, 16);
    if (kind < 5) {
        return ((int)bytes_below(bytes, 9) - 4) * QUARTER;
    }
    if (kind == 5) { /* nearly parallel, about a degree, about what counts as rounding */
        return ((int)bytes_below(bytes, 5) - 2) * QUARTER + fraction(bytes) * pow(10, -(int)bytes_below(bytes, 18));
    }
    const double angle = bytes_number(bytes, 2 * QUARTER);
    bytes->wild = bytes->wild || !(fabs(angle) < 100); /* what is added to it then loses digits */
    return angle;
}

/* FNV-1a. */
uint64_t bytes_hash(const uint8_t *data, size_t size)
{
    uint64_t hash = 0xcbf29ce484222325u;
    for (size_t i = 0; i < size; i++) {
        hash = (hash ^ data[i]) * 0x100000001b3u;
    }
    return hash;
}
