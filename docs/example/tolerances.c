/* How precisely the parts of a PUMA 560 have to be made for its tool to be within 0.5 mm and 2 mrad. */

#include <armtol/armtol.h>

#include <stdio.h>
#include <stdlib.h>

int main(void)
{
    const double q[6] = {0.0, 0.8, -3.0, 0.0, 0.8, 0.0}; /* radians */
    const double accuracy[6] = {0.5, 0.5, 0.5, 0.002, 0.002, 0.002}; /* mm, radians; base's axes */
    const armtol_arm *arm = armtol_arm_named("puma560");
    const armtol_question question = {.arm = arm, .q = q, .n_poses = 1, .accuracy = accuracy};

    armtol_answer *answer;
    const armtol_status status = armtol_answer_create(&question, &answer, NULL);
    if (status != ARMTOL_OK) {
        fprintf(stderr, "tolerances: %s\n", armtol_status_text(status));
        return EXIT_FAILURE;
    }
    const char *length = armtol_length_unit_name(arm->unit);
    for (size_t k = 0; k < answer->n_columns; k++) {
        const armtol_column *column = &answer->columns[k];
        printf("link %zu  %-5s  %9.6f %s\n", column->link, armtol_parameter_name(column->parameter),
               answer->tolerances[k], armtol_parameter_is_length(column->parameter) ? length : "rad");
    }
    armtol_answer_destroy(answer);
    return EXIT_SUCCESS;
}
