/* How precisely the parts of a PUMA 560 have to be made for its tool to be within 0.5 mm and 2 mrad. */

#include <armtol/armtol.h>

#include <stdio.h>
#include <stdlib.h>

enum { JOINTS = 6, LINKS = 8, COLUMNS = LINKS * ARMTOL_PARAMETER_COUNT };

static void check(armtol_status status, const char *routine)
{
    if (status != ARMTOL_OK) {
        fprintf(stderr, "tolerances: %s: %s\n", routine, armtol_status_text(status));
        exit(EXIT_FAILURE);
    }
}

int main(void)
{
    const double q[JOINTS] = {0.0, 0.8, -3.0, 0.0, 0.8, 0.0}; /* radians */
    const double accuracy[6] = {0.5, 0.5, 0.5, 0.002, 0.002, 0.002}; /* mm, radians; base's axes */

    const armtol_arm *arm = armtol_arm_named("puma560");
    if (arm == NULL || arm->n_links > LINKS) {
        fprintf(stderr, "tolerances: expected an arm puma560 of at most %d links\n", (int)LINKS);
        return EXIT_FAILURE;
    }

    armtol_link placed[LINKS];
    check(armtol_links_place(arm->links, arm->n_links, q, JOINTS, &armtol_errata_none, placed),
          "armtol_links_place");

    double matrix[6 * COLUMNS];
    armtol_column columns[COLUMNS];
    const size_t n = armtol_column_count(placed, arm->n_links);
    check(armtol_columns(placed, arm->n_links, columns, n), "armtol_columns");
    check(armtol_tool_matrix(placed, arm->n_links, &armtol_tool_origin, matrix, n), "armtol_tool_matrix");

    double weights[COLUMNS], tolerances[COLUMNS], multipliers[6];
    for (size_t k = 0; k < n; k++) {
        weights[k] = 1.0; /* precision costs the same everywhere */
    }
    double *workspace = malloc(armtol_allocation_workspace(6, n) * sizeof *workspace);
    if (workspace == NULL) {
        fputs("tolerances: out of memory\n", stderr);
        return EXIT_FAILURE;
    }
    check(armtol_allocate(ARMTOL_WORST_CASE, matrix, 6, n, accuracy, weights, tolerances, multipliers,
                          workspace),
          "armtol_allocate");
    free(workspace);

    const char *length = armtol_length_unit_name(arm->unit);
    for (size_t k = 0; k < n; k++) {
        printf("link %zu  %-5s  %9.6f %s\n", columns[k].link, armtol_parameter_name(columns[k].parameter),
               tolerances[k], armtol_parameter_is_length(columns[k].parameter) ? length : "rad");
    }
    return EXIT_SUCCESS;
}
