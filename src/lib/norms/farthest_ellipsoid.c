#include "lib/norms/farthest_ellipsoid.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

/*
 * Method
 *    Axes by Jacobi's rotations; along them the farthest point by its multiplier, one unknown, found by halving.
 *
 * Special cases
 *    Half axes of 0, and a center that has nothing of the longest one: that axis takes what the others leave.
 *
 * Accuracy
 *    Within 1e-13 along its own direction, and within 2e-10 of a bound over all directions, which is how fine the bound
 *    is (test_no_direction_is_worse).
 */

/* ---- axes: Jacobi's rotations ---- */

/* One element off the diagonal becomes 0; the columns of `axes` turn with it. */
static void rotate(double m[3][3], double axes[3][3], int p, int q)
{
    if (m[p][q] == 0) {
        return;
    }
    const double ratio = (m[q][q] - m[p][p]) / (2 * m[p][q]);
    const double tangent = (ratio < 0 ? -1 : 1) / (fabs(ratio) + sqrt(ratio * ratio + 1));
    const double cosine = 1 / sqrt(tangent * tangent + 1), sine = tangent * cosine;
    const int r = 3 - p - q;
    const double change = tangent * m[p][q], rp = m[r][p], rq = m[r][q];
    m[p][p] -= change;
    m[q][q] += change;
    m[p][q] = m[q][p] = 0;
    m[r][p] = m[p][r] = cosine * rp - sine * rq;
    m[r][q] = m[q][r] = sine * rp + cosine * rq;
    for (int i = 0; i < 3; i++) {
        const double ap = axes[i][p], aq = axes[i][q];
        axes[i][p] = cosine * ap - sine * aq;
        axes[i][q] = sine * ap + cosine * aq;
    }
}

/* It converges as the square; a few sweeps are enough for every matrix. */
static void find_axes(double m[3][3], double axes[3][3])
{
    enum { SWEEPS = 12 };
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            axes[i][j] = i == j;
        }
    }
    for (int sweep = 0; sweep < SWEEPS; sweep++) {
        rotate(m, axes, 0, 1);
        rotate(m, axes, 0, 2);
        rotate(m, axes, 1, 2);
    }
}

/* ---- the farthest point, along the axes ---- */

/* Half axes, the center's magnitudes along them, and the longest of them. */
typedef struct along_axes {
    double half[3], center[3];
    int longest;
} along_axes;

static double gap(const along_axes *along, int i)
{
    const double longest = along->half[along->longest];
    return (longest - along->half[i]) * (longest + along->half[i]);
}

/* What of the unit sphere goes into axis i where the multiplier is `more` above the square of the longest half axis. */
static double part(const along_axes *along, int i, double more)
{
    const double pull = along->half[i] * along->center[i];
    return pull == 0 ? 0 : pull / (more + gap(along, i));
}

static double squares_of_parts(const along_axes *along, double more)
{
    double sum = 0;
    for (int i = 0; i < 3; i++) {
        const double of = part(along, i, more);
        sum += of * of;
    }
    return sum;
}

/*
 * The largest sum of (center + half z)^2 with |z| = 1: half (center + half z) = m z with the largest m for which |z| =
 * 1, no less than the square of the longest half axis. |z| falls with m, so m is found by halving.
 */
static double find_multiplier(const along_axes *along)
{
    double low = 0, high = 0;
    for (int i = 0; i < 3; i++) {
        high += along->center[i];
    }
    high *= along->half[along->longest];
    for (bool moves = high > 0; moves;) {
        const double middle = low + (high - low) / 2;
        moves = middle > low && middle < high;
        if (squares_of_parts(along, middle) > 1) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return high;
}

/* The longest axis takes what the others leave, also where the center has nothing of it. */
static void place_farthest(const along_axes *along, double magnitudes[3])
{
    const double more = find_multiplier(along);
    double left = 1;
    for (int i = 0; i < 3; i++) {
        const double of = i == along->longest ? 0 : part(along, i, more);
        magnitudes[i] = along->center[i] + along->half[i] * of;
        left -= of * of;
    }
    magnitudes[along->longest] += along->half[along->longest] * sqrt(fmax(left, 0));
}

void farthest_of_ellipsoid(const double squares[3][3], const double center[3], double point[3])
{
    double diagonal[3][3], axes[3][3], magnitudes[3], signs[3];
    along_axes along = {.longest = 0};
    memcpy(diagonal, squares, sizeof diagonal);
    find_axes(diagonal, axes);
    for (int i = 0; i < 3; i++) {
        const double at = axes[0][i] * center[0] + axes[1][i] * center[1] + axes[2][i] * center[2];
        along.half[i] = sqrt(fmax(diagonal[i][i], 0));
        along.center[i] = fabs(at);
        signs[i] = at < 0 ? -1 : 1;
        along.longest = along.half[i] > along.half[along.longest] ? i : along.longest;
    }
    place_farthest(&along, magnitudes);
    for (int i = 0; i < 3; i++) {
        point[i] = 0;
        for (int j = 0; j < 3; j++) {
            point[i] += axes[i][j] * signs[j] * magnitudes[j];
        }
    }
}
