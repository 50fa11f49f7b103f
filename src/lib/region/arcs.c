#include "lib/region/arcs.h"

#include "lib/report/trigonometry.h"

#include <math.h>

static void add(arc *arc, double angle, double radius, double d, double value)
{
    const size_t i = arc->count++;
    arc->x[i] = radius * cosine_of(&armtol_errata_none, angle);
    arc->y[i] = radius * sine_of(&armtol_errata_none, angle);
    arc->d[i] = d;
    arc->values[i] = value;
    arc->stretch = fmax(arc->stretch, radius);
}

/*
 * The tangents at the ends of an arc of half width h meet at 1 / cos h on its middle ray. Cut into `between` + 1 arcs
 * of half width h: the point where two of them join lies between the corners on either side, so that all are in the
 * hull. Tangents that are half a turn apart do not meet: no piece is wider than 2.1, and one turn has three.
 */
static const double widest = 2.1;

static void add_corners(arc *arc, double angle, double turned, double low, double high, size_t between, double d)
{
    const size_t least = (size_t)ceil(fabs(turned) / widest), n = between + 1 > least ? between + 1 : least;
    const double step = (high - low) / (double)n, radius = 1 / cosine_of(&armtol_errata_none, turned / (double)n / 2);
    add(arc, angle, 1, d, low);
    for (size_t i = 0; i < n; i++) {
        const double part = ((double)i + 0.5) / (double)n;
        add(arc, angle + turned * part, radius, d, low + step * ((double)i + 0.5));
    }
    add(arc, angle + turned, 1, d, high);
}

void arc_of_angle(double low, double high, size_t between, arc *arc)
{
    arc->count = 0;
    arc->stretch = 1;
    if (low < high) {
        add_corners(arc, low, high - low, low, high, between, 0);
    } else {
        add(arc, low, 1, 0, low);
    }
}

void arc_of_link(const chain_link *link, double low, double high, size_t between, arc *arc)
{
    const double moved = link->joint != ARMTOL_FIXED ? link->plus + link->times * low : 0;
    const double turned = link->joint != ARMTOL_FIXED ? link->times * (high - low) : 0;
    const double whole = 6.283185307179587; /* one turn, rounded up, is all angles */
    arc->count = 0;
    arc->stretch = 1;
    if (link->joint == ARMTOL_PRISMATIC) {
        add(arc, link->theta, 1, link->d + moved, low);
        if (turned != 0) {
            add(arc, link->theta, 1, link->d + moved + turned, high);
        }
    } else if (turned != 0) {
        add_corners(arc, link->theta + moved, fmax(-whole, fmin(turned, whole)), low, high, between, link->d);
    } else {
        add(arc, link->theta + moved, 1, link->d, low);
    }
}

size_t arc_tangents(double half)
{
    const size_t most = ARC_CORNERS - 3;
    for (size_t between = 0; between < most; between++) {
        const double most_half = between == 0 ? 0.06 : 0.3 * (double)(between + 1);
        if (half <= most_half) {
            return between;
        }
    }
    return most;
}
