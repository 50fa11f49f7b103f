#include "built_arm.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

bool built_arm_start(built_arm *arm, const armtol_link links[], size_t n_links, const armtol_column columns[],
                     size_t n_columns)
{
    *arm = (built_arm){
        .links = links,
        .n_links = n_links,
        .columns = columns,
        .n_columns = n_columns,
        .drawn = armtol_chain_transform(links, n_links, &armtol_errata_none),
        .built = calloc(n_links, sizeof *links),
    };
    return arm->built != NULL;
}

void built_arm_free(built_arm *arm)
{
    free(arm->built);
    arm->built = NULL;
}

static double *field_of(armtol_link *link, armtol_parameter parameter)
{
    switch (parameter) {
    case ARMTOL_THETA:
        return &link->theta;
    case ARMTOL_D:
        return &link->d;
    case ARMTOL_A:
        return &link->a;
    case ARMTOL_ALPHA:
        return &link->alpha;
    default:
        return &link->beta;
    }
}

/* Element (i, j) of R R', R of the arm as built, R' the transpose of that as drawn. */
static double turn(const armtol_transform *built, const armtol_transform *drawn, int i, int j)
{
    double sum = 0;
    for (int n = 0; n < 3; n++) {
        sum += built->m[i][n] * drawn->m[j][n];
    }
    return sum;
}

static void rotation_vector(const armtol_transform *built, const armtol_transform *drawn, double vector[3])
{
    double cosine = -0.5;
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        cosine += turn(built, drawn, i, i) / 2;
        vector[i] = (turn(built, drawn, k, j) - turn(built, drawn, j, k)) / 2;
    }
    const double sine = sqrt(vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2]);
    const double factor = sine > 0 ? atan2(sine, cosine) / sine : 1;
    for (int i = 0; i < 3; i++) {
        vector[i] *= factor;
    }
}

void built_arm_error(const built_arm *arm, const double errors[], double error[6])
{
    memcpy(arm->built, arm->links, arm->n_links * sizeof *arm->built);
    for (size_t k = 0; k < arm->n_columns; k++) {
        *field_of(&arm->built[arm->columns[k].link], arm->columns[k].parameter) += errors[k];
    }
    const armtol_transform tool = armtol_chain_transform(arm->built, arm->n_links, &armtol_errata_none);
    for (int i = 0; i < 3; i++) {
        error[i] = tool.m[i][3] - arm->drawn.m[i][3];
    }
    rotation_vector(&tool, &arm->drawn, error + 3);
}
