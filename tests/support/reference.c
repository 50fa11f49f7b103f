#include "support/reference.h"

#include <math.h>
#include <string.h>

typedef long double matrix[4][4];

static void identity(matrix m)
{
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            m[i][j] = i == j;
        }
    }
}

static void times(matrix left, matrix right)
{
    matrix product;
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            product[i][j] = 0;
            for (int n = 0; n < 4; n++) {
                product[i][j] += left[i][n] * right[n][j];
            }
        }
    }
    memcpy(left, product, sizeof product);
}

/* Append a rotation about axis 0, 1 or 2. */
static void rotate(matrix m, int axis, long double angle)
{
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    matrix r;
    identity(r);
    r[i][i] = r[j][j] = cosl(angle);
    r[j][i] = sinl(angle);
    r[i][j] = -r[j][i];
    times(m, r);
}

static void translate(matrix m, int axis, long double length)
{
    matrix t;
    identity(t);
    t[axis][3] = length;
    times(m, t);
}

static void append(matrix m, const armtol_link *link, const long double error[ARMTOL_PARAMETER_COUNT])
{
    rotate(m, 2, link->theta + error[ARMTOL_THETA]);
    translate(m, 0, link->a + error[ARMTOL_A]);
    translate(m, 2, link->d + error[ARMTOL_D]);
    rotate(m, 0, link->alpha + error[ARMTOL_ALPHA]);
    rotate(m, 1, link->beta + error[ARMTOL_BETA]);
}

/* The chain with one parameter off by `error`. */
static void chain(const armtol_link links[], size_t n_links, armtol_column column, long double error, matrix m)
{
    identity(m);
    for (size_t i = 0; i < n_links; i++) {
        long double errors[ARMTOL_PARAMETER_COUNT] = {0};
        if (i == column.link) {
            errors[column.parameter] = error;
        }
        append(m, &links[i], errors);
    }
}

void reference_chain(const armtol_link links[], size_t n_links, double transform[4][4])
{
    matrix m;
    chain(links, n_links, (armtol_column){0, ARMTOL_THETA}, 0, m);
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            transform[i][j] = (double)m[i][j];
        }
    }
}

void reference_link(const armtol_link *link, double transform[4][4])
{
    reference_chain(link, 1, transform);
}

/*
 * Central differences of fourth order: with this step neither what they leave out nor rounding reaches 1e-10 of
 * the chain's length, even where long double is double.
 */
static void differentiate(const armtol_link links[], size_t n_links, armtol_column column,
                          long double slope[3][4])
{
    const long double h = 1e-3L;
    matrix t[4];
    for (int n = 0; n < 4; n++) {
        static const int steps[4] = {-2, -1, 1, 2};
        chain(links, n_links, column, steps[n] * h, t[n]);
    }
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 4; j++) {
            slope[i][j] = (t[0][i][j] - 8 * t[1][i][j] + 8 * t[2][i][j] - t[3][i][j]) / (12 * h);
        }
    }
}

void reference_column(const armtol_link links[], size_t n_links, armtol_column column, bool of_tool_point,
                      double twist[6])
{
    matrix here;
    long double slope[3][4], w[3];
    chain(links, n_links, column, 0, here);
    differentiate(links, n_links, column, slope);
    for (int i = 0; i < 3; i++) { /* w from the skew matrix dR R' */
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        w[i] = 0;
        for (int n = 0; n < 3; n++) {
            w[i] += slope[k][n] * here[j][n];
        }
        twist[i + 3] = (double)w[i];
    }
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const long double turning = w[j] * here[k][3] - w[k] * here[j][3];
        twist[i] = (double)(of_tool_point ? slope[i][3] : slope[i][3] - turning);
    }
}
