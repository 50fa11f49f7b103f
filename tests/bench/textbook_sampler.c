#include "bench/textbook.h"

#include <math.h>

enum { LINKS = 8, COLUMNS = 32 };

static uint64_t mixed(uint64_t z)
{
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/* The axes are the columns: r[i][j] is component i of axis j. */
typedef struct frame {
    double r[3][3], p[3];
} frame;

static const frame base = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};

/* Turn axis j towards axis k. */
static inline void turn(frame *f, int j, int k, double cosine, double sine)
{
    for (int i = 0; i < 3; i++) {
        const double new_j = f->r[i][j] * cosine + f->r[i][k] * sine;
        f->r[i][k] = f->r[i][k] * cosine - f->r[i][j] * sine;
        f->r[i][j] = new_j;
    }
}

static inline void slide(frame *f, int axis, double length)
{
    for (int i = 0; i < 3; i++) {
        f->p[i] += f->r[i][axis] * length;
    }
}

static inline double sine_of(double e)
{
    const double z = e * e;
    return e - e * z * (1.0 / 6 - z * (1.0 / 120 - z * (1.0 / 5040)));
}

static inline double cosine_of(double e)
{
    const double z = e * e;
    return 1 - z * (0.5 - z * (1.0 / 24 - z * (1.0 / 720)));
}

static inline void turn_sum(frame *f, int j, int k, double cosine, double sine, double e)
{
    const double c = cosine_of(e), s = sine_of(e);
    turn(f, j, k, cosine * c - sine * s, sine * c + cosine * s);
}

/* alpha is 0 or a quarter turn up or down */
static inline void tilt(frame *f, int quarter, double e)
{
    const double c = cosine_of(e), s = sine_of(e);
    turn(f, 1, 2, quarter == 0 ? c : -quarter * s, quarter == 0 ? s : quarter * c);
}

static inline void npr(frame *f, double cosine, double sine, int quarter, double d, const double e[4])
{
    turn_sum(f, 0, 1, cosine, sine, e[0]);
    slide(f, 2, d + e[1]);
    slide(f, 0, e[2]);
    tilt(f, quarter, e[3]);
}

static inline void ppr(frame *f, double cosine, double sine, double a, const double e[4])
{
    turn_sum(f, 0, 1, cosine, sine, e[0]);
    slide(f, 0, a + e[1]);
    tilt(f, 0, e[2]);
    turn(f, 2, 0, cosine_of(e[3]), sine_of(e[3]));
}

static inline frame chain(const textbook_arm *arm, const double e[COLUMNS])
{
    const double *const c = arm->cosines, *const s = arm->sines;
    frame f = base;
    npr(&f, c[0], s[0], 0, 359.7, e);
    npr(&f, c[1], s[1], -1, 0, e + 4);
    npr(&f, c[2], s[2], 1, 0, e + 8);
    ppr(&f, c[3], s[3], 373.4, e + 12);
    ppr(&f, c[4], s[4], 279.4, e + 16);
    npr(&f, c[5], s[5], 1, 0, e + 20);
    npr(&f, c[6], s[6], 0, 0, e + 24);
    npr(&f, c[7], s[7], 0, 100, e + 28);
    return f;
}

void textbook_arm_start(textbook_arm *arm, const double q[6], const double tolerances[COLUMNS], uint64_t seed)
{
    static const double none[COLUMNS] = {0};
    *arm = (textbook_arm){.tolerances = tolerances, .key = mixed(seed)};
    for (int i = 0; i < LINKS; i++) {
        const double theta = i == 0 ? 0 : i == LINKS - 1 ? acos(-1) / 2 : q[i - 1];
        arm->cosines[i] = cos(theta);
        arm->sines[i] = sin(theta);
    }
    const frame meant = chain(arm, none);
    for (int i = 0; i < 3; i++) {
        arm->point[i] = meant.p[i];
        for (int j = 0; j < 3; j++) {
            arm->rotation[i][j] = meant.r[i][j];
        }
    }
}

/* Element (i, j) of the turn from the tool as meant to the tool as built. */
static inline double turned(const frame *f, const textbook_arm *arm, int i, int j)
{
    const double *const built = f->r[i], *const meant = arm->rotation[j];
    return built[0] * meant[0] + built[1] * meant[1] + built[2] * meant[2];
}

static inline void rotation_vector(const frame *f, const textbook_arm *arm, double vector[3])
{
    double cosine = -0.5;
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        cosine += turned(f, arm, i, i) / 2;
        vector[i] = (turned(f, arm, k, j) - turned(f, arm, j, k)) / 2;
    }
    const double sine = sqrt(vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2]);
    const double factor = sine > 0 ? atan2(sine, cosine) / sine : 1;
    for (int i = 0; i < 3; i++) {
        vector[i] *= factor;
    }
}

void textbook_sample(const textbook_arm *arm, uint64_t number, double error[6])
{
    double e[COLUMNS];
    for (uint64_t k = 0; k < COLUMNS; k++) {
        const uint64_t bits = mixed(arm->key + 0x9e3779b97f4a7c15u * (number * COLUMNS + k + 1));
        e[k] = arm->tolerances[k] * ((double)(bits >> 11) / 4503599627370496.0 - 1);
    }
    const frame f = chain(arm, e);
    for (int i = 0; i < 3; i++) {
        error[i] = f.p[i] - arm->point[i];
    }
    rotation_vector(&f, arm, error + 3);
}
