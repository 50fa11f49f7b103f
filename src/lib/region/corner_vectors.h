#ifndef ARMTOL_LIB_REGION_CORNER_VECTORS_H
#define ARMTOL_LIB_REGION_CORNER_VECTORS_H

#include "lib/region/arcs.h"

/* Vectors side by side, one for each choice of corners, and how links turn one. */
typedef struct vectors {
    double *x, *y, *z;
} vectors;

typedef struct vector {
    double x, y, z;
} vector;

/* From the frame behind the link, bent and tilted, to its turned frame. */
static inline vector tilted(const chain_link *link, vector v)
{
    const double x = link->cos_beta * v.x + link->sin_beta * v.z, z = link->cos_beta * v.z - link->sin_beta * v.x;
    return (vector){x, link->cos_alpha * v.y - link->sin_alpha * z, link->sin_alpha * v.y + link->cos_alpha * z};
}

static inline vector tilted_back(const chain_link *link, vector v)
{
    const double y = link->cos_alpha * v.y + link->sin_alpha * v.z, z = link->cos_alpha * v.z - link->sin_alpha * v.y;
    return (vector){link->cos_beta * v.x - link->sin_beta * z, y, link->sin_beta * v.x + link->cos_beta * z};
}

static inline vector turned(const arc *arc, size_t corner, vector v)
{
    const double x = arc->x[corner], y = arc->y[corner];
    return (vector){x * v.x - y * v.y, y * v.x + x * v.y, v.z};
}

static inline vector turned_back(const arc *arc, size_t corner, vector v)
{
    const double x = arc->x[corner], y = arc->y[corner];
    return (vector){x * v.x + y * v.y, x * v.y - y * v.x, v.z};
}

static inline vector get(const vectors *from, size_t i)
{
    return (vector){from->x[i], from->y[i], from->z[i]};
}

static inline void put(const vectors *to, size_t i, vector v)
{
    to->x[i] = v.x;
    to->y[i] = v.y;
    to->z[i] = v.z;
}

static inline vector cross(vector a, vector b)
{
    return (vector){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/* From memory, which is moved on behind them. */
static inline vectors cut(double **from, size_t count)
{
    const vectors made = {*from, *from + count, *from + 2 * count};
    *from += 3 * count;
    return made;
}

/* Along the frame behind `before`, or the base's, to that of the link, turned. */
static inline void step_on(const chain_link *before, const arc *arc, size_t count, const vectors *from,
                           const vectors *to)
{
    for (size_t i = 0; i < count; i++) {
        const vector seen = before != NULL ? tilted_back(before, get(from, i)) : get(from, i);
        for (size_t c = 0; c < arc->count; c++) {
            put(to, i * arc->count + c, turned_back(arc, c, seen));
        }
    }
}

#endif
