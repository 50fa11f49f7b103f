#include "lib/norms/cover.h"

#include <math.h>
#include <string.h>

typedef struct cover {
    support *h;
    const void *context;
    double best, accuracy, bound;
} cover;

typedef struct corner {
    double direction[3], value;
} corner;

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static corner corner_at(cover *cover, double x, double y, double z)
{
    const double length = sqrt(x * x + y * y + z * z);
    corner corner = {.direction = {x / length, y / length, z / length}};
    corner.value = cover->h(corner.direction, cover->context);
    cover->best = fmax(cover->best, corner.value);
    return corner;
}

static corner middle_of(cover *cover, const corner *a, const corner *b)
{
    const double *p = a->direction, *q = b->direction;
    return corner_at(cover, p[0] + q[0], p[1] + q[1], p[2] + q[2]);
}

static double distance_of_plane(const double a[3], const double b[3], const double c[3])
{
    double one[3], two[3], normal[3];
    for (int i = 0; i < 3; i++) {
        one[i] = b[i] - a[i];
        two[i] = c[i] - a[i];
    }
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        normal[i] = one[j] * two[k] - one[k] * two[j];
    }
    return fabs(dot(normal, a)) / sqrt(dot(normal, normal));
}

static void search(cover *cover, const corner *a, const corner *b, const corner *c)
{
    const double most = fmax(a->value, fmax(b->value, c->value));
    const double bound = most / distance_of_plane(a->direction, b->direction, c->direction);
    if (!(bound > cover->best * (1 + cover->accuracy))) {
        cover->bound = fmax(cover->bound, bound);
        return;
    }
    const corner ab = middle_of(cover, a, b), bc = middle_of(cover, b, c), ca = middle_of(cover, c, a);
    search(cover, &ab, &bc, &ca);
    search(cover, a, &ab, &ca);
    search(cover, b, &bc, &ab);
    search(cover, c, &ca, &bc);
}

double cover_of_sphere(support *h, const void *context, double accuracy)
{
    cover cover = {h, context, 0, accuracy, 0};
    for (int octant = 0; octant < 4; octant++) { /* the other four have the same values */
        const corner a = corner_at(&cover, octant % 2 ? -1 : 1, 0, 0), b = corner_at(&cover, 0, octant / 2 ? -1 : 1, 0);
        const corner c = corner_at(&cover, 0, 0, 1);
        search(&cover, &a, &b, &c);
    }
    return cover.bound;
}
