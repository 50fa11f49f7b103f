#include "lib/norms/norm_discs.h"

#include "lib/norms/discs.h"
#include "lib/norms/farthest_ellipsoid.h"
#include "lib/norms/farthest_round.h"
#include "lib/norms/farthest_vertex.h"
#include "lib/norms/spread_norm.h"

#include <math.h>
#include <string.h>

/* ---- names ---- */

static const struct {
    const char *name;
    unsigned components;
} names[ARMTOL_MOST_NORMS] = {{"r", 007},  {"xy", 003},  {"xz", 005},  {"yz", 006},
                              {"w", 070}, {"wxy", 030}, {"wxz", 050}, {"wyz", 060}};

const char *armtol_norm_name(unsigned components)
{
    size_t i = 0;
    while (i < ARMTOL_MOST_NORMS && names[i].components != components) {
        i++;
    }
    return i < ARMTOL_MOST_NORMS ? names[i].name : "?";
}

unsigned armtol_norm_of_name(const char *name)
{
    size_t i = 0;
    while (i < ARMTOL_MOST_NORMS && strcmp(names[i].name, name) != 0) {
        i++;
    }
    return i < ARMTOL_MOST_NORMS ? names[i].components : 0;
}

bool armtol_norm_is_known(unsigned components)
{
    return armtol_norm_name(components)[0] != '?';
}

bool armtol_norm_is_length(unsigned components)
{
    return components <= 7;
}

/* ---- vectors of the components that count ---- */

static bool counts(unsigned components, size_t i)
{
    return (components >> i & 1) != 0;
}

/* Where the first of them is, in rows of A: 0 or 3. */
static size_t first_of(unsigned components)
{
    return armtol_norm_is_length(components) ? 0 : 3;
}

double armtol_norm_of(const double error[6], unsigned components)
{
    double largest = 0, sum = 0;
    for (size_t i = 0; i < 6; i++) {
        largest = counts(components, i) ? fmax(largest, fabs(error[i])) : largest;
    }
    if (largest == 0 || isinf(largest)) {
        return largest;
    }
    for (size_t i = 0; i < 6; i++) {
        const double part = counts(components, i) ? error[i] / largest : 0;
        sum += part * part;
    }
    return largest * sqrt(sum);
}

void armtol_norm_row(const double matrix[], size_t n_columns, const double direction[6], double row[])
{
    memset(row, 0, n_columns * sizeof *row);
    for (size_t i = 0; i < 6; i++) {
        for (size_t k = 0; k < n_columns && direction[i] != 0; k++) {
            row[k] += direction[i] * matrix[i * n_columns + k];
        }
    }
}

/* One A and one norm, and what is looked at of them. */
typedef struct sight {
    const double *matrix;
    size_t n_columns;
    unsigned components;
    const double *shifts, *tolerances;
    const bool *discs;
    const armtol_answer *spread; /* whose spreads count; NULL: none */
    double scale;     /* the largest number among shift and columns times tolerances */
    double center[3]; /* A shifts, in scales */
} sight;

static void column_of(const sight *sight, size_t k, double vector[3])
{
    const size_t first = first_of(sight->components);
    for (size_t i = 0; i < 3; i++) {
        const double element = sight->matrix[(first + i) * sight->n_columns + k];
        vector[i] = counts(sight->components, first + i) ? element : 0;
    }
}

static double largest_of(const double vector[3])
{
    return fmax(fabs(vector[0]), fmax(fabs(vector[1]), fabs(vector[2])));
}

/* Finds scale and center. False where the scale is 0 or not finite: it is the norm then. */
static bool look(sight *sight)
{
    double column[3];
    memset(sight->center, 0, sizeof sight->center);
    sight->scale = 0;
    for (size_t k = 0; k < sight->n_columns; k++) {
        column_of(sight, k, column);
        const double largest = largest_of(column);
        sight->scale = fmax(sight->scale, largest == 0 ? 0 : largest * sight->tolerances[k]);
        for (int i = 0; i < 3 && sight->shifts != NULL; i++) {
            sight->center[i] += column[i] * sight->shifts[k];
        }
    }
    sight->scale = fmax(sight->scale, largest_of(sight->center));
    for (int i = 0; i < 3; i++) {
        sight->center[i] /= sight->scale;
    }
    return sight->scale > 0 && isfinite(sight->scale);
}

/* In scales; false for a column that does nothing. */
static bool generator_of(const sight *sight, size_t k, double generator[3])
{
    const double tolerance = sight->tolerances[k];
    column_of(sight, k, generator);
    if (largest_of(generator) == 0 || tolerance == 0) {
        return false;
    }
    for (int i = 0; i < 3; i++) {
        generator[i] = generator[i] * tolerance / sight->scale;
    }
    return largest_of(generator) > 0;
}

/* The norm of a point, and its direction; of either sign the one whose first part is positive. */
static double told(const sight *sight, const double point[3], double direction[6])
{
    const size_t first = first_of(sight->components);
    const double norm = sqrt(point[0] * point[0] + point[1] * point[1] + point[2] * point[2]);
    double sign = 0;
    for (size_t i = 0; i < 3; i++) {
        sign = sign != 0 || point[i] == 0 ? sign : point[i] < 0 ? -1 : 1;
        direction[first + i] = norm > 0 && point[i] != 0 ? sign * point[i] / norm : 0;
    }
    return norm * sight->scale;
}

/* ---- worst case ---- */

size_t armtol_norm_workspace(size_t n_columns)
{
    return 6 * (n_columns + 1);
}

size_t norm_discs_workspace(size_t n_columns, size_t n_discs)
{
    const size_t of_ellipses = n_discs * sizeof(ellipse) / sizeof(double);
    return armtol_norm_workspace(n_columns) +
           (n_discs > 0 ? of_ellipses + farthest_round_workspace(n_columns + 1, n_discs) : 0);
}

/* Generators, the center as one of them; returns how many. */
static size_t gather(const sight *sight, double generators[])
{
    size_t n = 0;
    for (size_t k = 0; k < sight->n_columns; k++) {
        n += !discs_have(sight->discs, k) && generator_of(sight, k, generators + 3 * n);
    }
    if (largest_of(sight->center) > 0) {
        memcpy(generators + 3 * n++, sight->center, sizeof sight->center);
    }
    return n;
}

/* The discs that the norm sees; returns how many. */
static size_t gather_ellipses(const sight *sight, ellipse ellipses[])
{
    size_t n = 0;
    for (size_t k = 0; k < sight->n_columns && sight->discs != NULL; k++) {
        if (sight->discs[k]) {
            const bool one = generator_of(sight, k, ellipses[n].one);
            const bool other = generator_of(sight, k + 1, ellipses[n].other);
            n += one || other;
        }
    }
    return n;
}

/* The component that a norm of two leaves out; -1 for one of three. */
static int left_out(unsigned components)
{
    const size_t first = first_of(components);
    for (int i = 0; i < 3; i++) {
        if (!counts(components, first + (size_t)i)) {
            return i;
        }
    }
    return -1;
}

double norm_discs_worst(const double matrix[], size_t n_columns, unsigned components, const double shifts[],
                        const double tolerances[], const bool discs[], double direction[6], double workspace[])
{
    sight sight = {matrix, n_columns, components, shifts, tolerances, discs, NULL, 0, {0, 0, 0}};
    double vertex[3];
    memset(direction, 0, 6 * sizeof *direction);
    if (!look(&sight)) {
        return sight.scale;
    }
    double *const generators = workspace;
    const size_t n = gather(&sight, generators);
    ellipse *const ellipses = (ellipse *)(void *)(workspace + armtol_norm_workspace(n_columns));
    const size_t n_ellipses = gather_ellipses(&sight, ellipses);
    if (n_ellipses > 0) {
        farthest_round(generators, n, ellipses, n_ellipses, left_out(components), (double *)(ellipses + n_ellipses),
                       vertex);
    } else {
        farthest_vertex(generators, n, left_out(components), NULL, (crossing *)(void *)(workspace + 3 * n), vertex);
    }
    return told(&sight, vertex, direction);
}

double armtol_worst_norm(const double matrix[], size_t n_columns, unsigned components, const double shifts[],
                         const double tolerances[], double direction[6], double workspace[])
{
    return norm_discs_worst(matrix, n_columns, components, shifts, tolerances, NULL, direction, workspace);
}

/* ---- standard deviations ---- */

/* Times `factor`, of a column and all that it leads, by their factors. 0 where another one leads it. */
static void spread_generator(const sight *sight, size_t column, double factor, double generator[3])
{
    const armtol_answer *of = sight->spread;
    const size_t end = of != NULL && of->grouped ? sight->n_columns : column + 1;
    double part[3];
    memset(generator, 0, 3 * sizeof *generator);
    for (size_t k = column; k < end; k++) {
        if ((of == NULL || of->leaders[k] == column) && generator_of(sight, k, part)) {
            const double by = of != NULL ? of->factors[k] * factor : factor;
            for (int i = 0; i < 3; i++) {
                generator[i] += by * part[i];
            }
        }
    }
}

static double deviations_of(sight seen, double factor, double direction[6])
{
    sight sight = seen;
    double squares[3][3] = {{0}}, generator[3], point[3];
    memset(direction, 0, 6 * sizeof *direction);
    if (!look(&sight)) {
        return sight.scale;
    }
    for (size_t k = 0; k < sight.n_columns; k++) {
        spread_generator(&sight, k, factor, generator);
        for (int i = 0; i < 9; i++) {
            squares[i / 3][i % 3] += generator[i / 3] * generator[i % 3];
        }
    }
    farthest_of_ellipsoid((const double(*)[3])squares, sight.center, point);
    return told(&sight, point, direction);
}

double armtol_rss_norm(const double matrix[], size_t n_columns, unsigned components, const double shifts[],
                       const double tolerances[], double factor, double direction[6])
{
    return deviations_of((sight){matrix, n_columns, components, shifts, tolerances, NULL, NULL, 0, {0, 0, 0}}, factor,
                         direction);
}

double spread_norm(const armtol_answer *answer, size_t pose, unsigned components, const double shifts[],
                   const double tolerances[], double factor, double direction[6])
{
    const double *matrix = armtol_answer_matrix(answer, pose);
    return deviations_of((sight){matrix, answer->n_columns, components, shifts, tolerances, NULL, answer, 0, {0, 0, 0}},
                         factor, direction);
}
