#include "armtol/corners.h"

#include "lib/pi.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>

/* What a parameter moves the component by at the most. */
static double most_of(double element, double tolerance)
{
    return element != 0 ? fabs(element) * tolerance : 0;
}

double armtol_worst_error(const double matrix[], size_t n_columns, size_t row, const double tolerances[])
{
    const double *elements = matrix + row * n_columns;
    double sum = 0;
    for (size_t k = 0; k < n_columns; k++) {
        sum += most_of(elements[k], tolerances[k]);
    }
    return sum;
}

double armtol_rss_error(const double matrix[], size_t n_columns, size_t row, const double tolerances[])
{
    const double *elements = matrix + row * n_columns;
    double sum = 0;
    for (size_t k = 0; k < n_columns; k++) {
        const double part = most_of(elements[k], tolerances[k]);
        sum += part * part;
    }
    return sqrt(sum);
}

void armtol_corner(const double matrix[], size_t n_columns, size_t row, int sign, const double tolerances[],
                   double parameter_errors[])
{
    const double *elements = matrix + row * n_columns;
    for (size_t k = 0; k < n_columns; k++) {
        parameter_errors[k] = elements[k] != 0 ? sign * copysign(tolerances[k], elements[k]) : 0;
    }
}

/*
 * The remainder.
 *
 * Method
 *    A bound of the second derivatives of the tool's motion along the way from the arm as meant to the arm as built, in
 *    closed form; the proof is below.
 *
 * Special cases
 *    Angles that sum to pi or more leave the angular components without a bound, tolerances that are not finite all
 *    six.
 *
 * Accuracy
 *    Never less than the truth in random boxes; where angles are up to 1e-3 the truth is more than 90 % of it in the
 *    best of them (test_the_remainder_holds_in_random_boxes). The series of the exponential leaves out less than 1e-21.
 *
 * Column k of A is (v_k; w_k): the motion of the tool point and the turn of the tool for a unit error of
 * parameter k; |w_k| is 1 for an angle and 0 for a length, and |v_k| the distance of the tool point from axis
 * k, or 1. Parameters count in the order of the chain. Let e be the errors, |e_k| <= t_k, and follow the arm
 * whose errors are s e as s goes from 0 to 1; v_k(s), w_k(s) are its columns, v_k and w_k those at 0. Then
 *
 *     dv_k/de_m = w_m x v_k, m <= k;  w_k x v_m, m > k;      dw_k/de_m = w_m x w_k, m < k;  0, m >= k.
 *
 * Let T be the sum of the tolerances of all angles, T_k of those before k. Along the way
 *
 *     |v_k(s)| <= r_k = |v_k| + |w_k| B_k,     B_k = sum over m > k of t_m r_m,
 *
 * since what comes before k only turns v_k.
 *
 * Linear. The tool point moves by the integral of sum e_k v_k(s). By Taylor its component i leaves out at
 * most
 *
 *     sum over k, j <= k of t_j t_k |(w_j x v_k)_i at its largest|,    half of it for j = k,
 *
 * and w_j x v_k changes no faster than by D_k = (T_k + t_k |w_k|) r_k + |w_k| B_k: the parameters up to k
 * turn it, or one factor of it, and those behind change v_k. With the weight 1 - s of Taylor's integral a
 * change that grows as s counts a third: the pair counts |(w_j x v_k)_i| + D_k / 3, or r_k where that is
 * less.
 *
 * Angular. Let w(s) = sum e_k w_k(s), and W its value at 0, which is A's prediction. Then
 *
 *     |w(s) - W| <= s P,                      P = sum t_k |w_k| T_k,
 *     |(w(s) - W)_i| <= s Q_i + s^2 R / 2,    Q_i = sum over j < k of t_j t_k |(w_j x w_k)_i|,
 *                                             R = sum t_k |w_k| T_k^2,
 *
 * R since the second derivative of w_k along the way is at most T_k^2. The rotation vector f(s) is no longer
 * than s T, the sum of what the single rotations turn by, and as long as T < pi it follows
 *
 *     f' = w - (f x w) / 2 + g f x (f x w),      g = (1 - (f / 2) cot(f / 2)) / f^2 < 1 / pi^2.
 *
 * With c = T (1/2 + T / pi^2), |f' - w| <= c |f x w| / T. Since f x w = (f - s W) x w + s W x (w - W), that
 * is <= c (|f - s W| + s^2 P), and so d = |f - s W| grows no faster than c d + P (s + c s^2). Hence
 *
 *     d <= s^2 P E,      E = e^c (1/2 + c / 3),
 *
 * and of f - W component i is, at s = 1, at most Q_i / 2 + R / 6 + c P (1 + E) / 3; nor is it more than P E.
 */

typedef struct column {
    double v[3], w[3];
    double length_of_v, length_of_w;
} column;

static double length_of(const double vector[3])
{
    return sqrt(vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2]);
}

static column column_of(const double matrix[], size_t n_columns, size_t k)
{
    column column;
    for (size_t i = 0; i < 3; i++) {
        column.v[i] = matrix[i * n_columns + k];
        column.w[i] = matrix[(i + 3) * n_columns + k];
    }
    column.length_of_v = length_of(column.v);
    column.length_of_w = length_of(column.w);
    return column;
}

static double cross(const double a[3], const double b[3], size_t i)
{
    const size_t j = (i + 1) % 3, k = (i + 2) % 3;
    return a[j] * b[k] - a[k] * b[j];
}

/* The sum of the angles' tolerances among the first `count` columns. */
static double angles_before(const double matrix[], size_t n_columns, const double tolerances[], size_t count)
{
    double sum = 0;
    for (size_t k = 0; k < count; k++) {
        sum += tolerances[k] * column_of(matrix, n_columns, k).length_of_w;
    }
    return sum;
}

static void linear_remainder(const double matrix[], size_t n_columns, const double tolerances[],
                             double remainder[3])
{
    double behind = 0; /* B_k */
    for (size_t k = n_columns; k-- > 0;) {
        const column of_k = column_of(matrix, n_columns, k);
        const double growth = of_k.length_of_w * behind, longest = of_k.length_of_v + growth;
        const double drift = angles_before(matrix, n_columns, tolerances, k + 1) * longest + growth;
        for (size_t j = 0; j <= k; j++) {
            const column of_j = column_of(matrix, n_columns, j);
            const double pair = tolerances[j] * of_j.length_of_w * tolerances[k] * (j < k ? 1 : 0.5);
            for (size_t i = 0; i < 3; i++) {
                remainder[i] += pair * fmin(longest, fabs(cross(of_j.w, of_k.v, i)) + drift / 3);
            }
        }
        behind += tolerances[k] * longest;
    }
}

/* For 0 <= x < 3, to the last digits: libm's exp is not the same on every machine. */
static double exponential(double x)
{
    enum { TERMS = 32 };
    double sum = 1;
    for (int n = TERMS; n > 0; n--) {
        sum = 1 + x * sum / n;
    }
    return sum;
}

static void angular_remainder(const double matrix[], size_t n_columns, const double tolerances[],
                              double remainder[3])
{
    double before = 0, p = 0, r = 0, q[3] = {0, 0, 0};
    for (size_t k = 0; k < n_columns; k++) {
        const column of_k = column_of(matrix, n_columns, k);
        const double angle = tolerances[k] * of_k.length_of_w;
        for (size_t j = 0; j < k; j++) {
            const column of_j = column_of(matrix, n_columns, j);
            for (size_t i = 0; i < 3; i++) {
                q[i] += tolerances[j] * tolerances[k] * fabs(cross(of_j.w, of_k.w, i));
            }
        }
        p += angle * before;
        r += angle * before * before;
        before += angle;
    }
    const double c = before * (0.5 + before / (PI * PI)), e = exponential(c) * (0.5 + c / 3);
    for (size_t i = 0; i < 3; i++) {
        remainder[i] = before < PI ? fmin(q[i] / 2 + r / 6 + c * p * (1 + e) / 3, p * e) : (double)INFINITY;
    }
}

static bool all_bounded(const double tolerances[], size_t n_columns)
{
    double sum = 0;
    for (size_t k = 0; k < n_columns; k++) {
        sum += tolerances[k];
    }
    return sum <= DBL_MAX;
}

void armtol_remainder(const double matrix[], size_t n_columns, const double tolerances[], double remainder[6])
{
    const bool bounded = all_bounded(tolerances, n_columns);
    for (size_t i = 0; i < 6; i++) {
        remainder[i] = bounded ? 0 : INFINITY;
    }
    if (bounded) {
        linear_remainder(matrix, n_columns, tolerances, remainder);
        angular_remainder(matrix, n_columns, tolerances, remainder + 3);
    }
    for (size_t i = 0; i < 6; i++) {
        remainder[i] = remainder[i] <= DBL_MAX ? remainder[i] : (double)INFINITY; /* nan: squares overflow */
    }
}
