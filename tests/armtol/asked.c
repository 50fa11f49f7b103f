#include "armtol/asked.h"

#include "armtol/ask/arm_source.h"
#include "console/exit_code.h"

#include "unity.h"

#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

cli_options question(const char *arm, const char *joints, const char *accuracy)
{
    return (cli_options){.arm = arm, .joints = joints, .accuracy = accuracy, .sigma = 3, .seed = 1987};
}

int lowest_free_descriptor(void)
{
    int descriptor = 0;
    while (fcntl(descriptor, F_GETFD) != -1) {
        descriptor++;
    }
    return descriptor;
}

void asked_make(asked *asked, const cli_options *options)
{
    const int lowest = lowest_free_descriptor();
    asked->options = *options;
    TEST_ASSERT_EQUAL_INT_MESSAGE(EXIT_OK, arm_source_read(&asked->options, &asked->model), options->arm);
    TEST_ASSERT_EQUAL_INT_MESSAGE(EXIT_OK, request_make(&asked->request, &asked->options, &asked->model),
                                  options->arm);
    TEST_ASSERT_EQUAL_INT_MESSAGE(EXIT_OK, request_answer(&asked->request, &asked->answer), options->arm);
    TEST_ASSERT_EQUAL_INT_MESSAGE(lowest, lowest_free_descriptor(), "a file was left open");
}

void asked_free(asked *asked)
{
    armtol_answer_destroy(asked->answer);
    request_free(&asked->request);
    arm_model_free(&asked->model);
}

size_t asked_column(const asked *asked, size_t link, armtol_parameter parameter)
{
    const armtol_answer *answer = asked->answer;
    for (size_t k = 0; k < answer->n_columns; k++) {
        if (answer->columns[k].link == link && answer->columns[k].parameter == parameter) {
            return k;
        }
    }
    TEST_FAIL_MESSAGE("the link has no such parameter");
    return 0;
}

void draw_joints_text(random_source *random, const armtol_arm *arm, char text[JOINTS_TEXT])
{
    text[0] = '\0';
    for (size_t i = 0; i < arm->n_links; i++) {
        if (arm->links[i].joint == ARMTOL_FIXED) {
            continue;
        }
        const bool slides = arm->links[i].joint == ARMTOL_PRISMATIC;
        const armtol_drive *drive = &arm->drives[i];
        const double low = isfinite(drive->low) ? drive->low : slides ? 100 : -3;
        const double high = isfinite(drive->high) ? drive->high : slides ? 300 : 3;
        char number[40];
        snprintf(number, sizeof number, "%s%.17g", text[0] != '\0' ? "," : "",
                 random_between(random, low, high));
        strcat(text, number);
    }
}
