#ifndef TEST_ASKED_H
#define TEST_ASKED_H

#include "armtol/ask/request.h"
#include "support/random.h"

/* A question to armtol and its answer, without the program around them. */
typedef struct asked {
    cli_options options;
    arm_model model;
    request request;
    armtol_answer *answer;
} asked;

/* What most tests ask: an accuracy, and nothing else but the defaults. */
cli_options question(const char *arm, const char *joints, const char *accuracy);

/* Asks it; what does not work fails the test. The options' texts have to stay until asked_free. */
void asked_make(asked *asked, const cli_options *options);
void asked_free(asked *asked);

/* The column of a link's parameter; fails the test where there is none. */
size_t asked_column(const asked *asked, size_t link, armtol_parameter parameter);

/* Joint values as the command line has them: within the limits, or within what most joints can do. */
enum { JOINTS_TEXT = 512 };
void draw_joints_text(random_source *random, const armtol_arm *arm, char text[JOINTS_TEXT]);

/* The one that the next file to be opened gets. */
int lowest_free_descriptor(void);

#endif
