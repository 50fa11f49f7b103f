#include "armtol/ask/nothing_left.h"

#include "armtol/budget.h"
#include "armtol/names/link_name.h"
#include "console/exit_code.h"
#include "console/message.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { NAMED = 8 };

/* What is known alone, in the one pose and load: what is asked for counts as exact, or as little as it may be. */
static armtol_status ask_for_the_known(const request *request, size_t place, armtol_answer **answer)
{
    const size_t n_loads = request->loading.n_payloads > 0 ? request->loading.n_payloads : 1;
    const size_t n_joints = armtol_arm_joint_count(&request->arm);
    armtol_loading loading = request->loading;
    armtol_question question = request->question;
    question.q = request->q + place / n_loads * n_joints;
    question.n_poses = 1;
    question.tolerances = request->least;
    question.least = question.largest = NULL;
    loading.payloads += place % n_loads;
    loading.n_payloads = loading.n_payloads > 0 ? 1 : 0;
    question.loading = &loading;
    return armtol_answer_create(&question, answer, NULL);
}

/* What the component comes to, by the method's sum. */
static double whole_of(const armtol_answer *answer, size_t i)
{
    const armtol_predicted *component = &answer->components[i];
    return answer->method == ARMTOL_METHOD_RSS ? component->shift + answer->sigma * component->deviation
                                               : component->worst;
}

static void list_sources(const armtol_arm *arm, const armtol_budget *budget, size_t i, double percent, char *text,
                         size_t size)
{
    size_t n = 0, length = 0;
    for (size_t r = 0; r < budget->n_rows; r++) {
        const armtol_budget_row *row = &budget->rows[r];
        if (fabs(row->shares[i]) < 5e-4) {
            continue;
        }
        if (n++ < NAMED) {
            length += (size_t)snprintf(text + length, size - length, "%s%s of %s %.3g %%", n > 1 ? ", " : "",
                                       armtol_role_name(row->role), link_words(arm, row->link, &(link_text){""}),
                                       percent * row->shares[i]);
        }
    }
    if (n > NAMED) {
        snprintf(text + length, size - length, " and %zu more", n - NAMED);
    }
}

static void say(const request *request, const armtol_answer *answer, const armtol_budget *budget, size_t row)
{
    const size_t i = row % 6, n_loads = request->loading.n_payloads, place = row / 6;
    const double percent = 100 * whole_of(answer, i) / request->accuracy[i];
    char sources[NAMED * (sizeof(link_text) + 40) + 32] = "", load[32] = "";
    if (n_loads > 1) {
        snprintf(load, sizeof load, " with load %zu", place % n_loads + 1);
    }
    list_sources(&request->arm, budget, i, percent, sources, sizeof sources);
    message("no tolerances: %s %.4g %% of %s in pose %zu%s: %s",
            request->options->given != NULL ? "what is given uses" : "the drives alone use", percent,
            armtol_component_name(i), place / (n_loads > 0 ? n_loads : 1) + 1, load, sources);
}

int nothing_left(const request *request, size_t row)
{
    armtol_answer *answer = NULL;
    armtol_budget *budget = NULL;
    if (ask_for_the_known(request, row / 6, &answer) != ARMTOL_OK ||
        armtol_budget_create(answer, &budget) != ARMTOL_OK) {
        armtol_answer_destroy(answer);
        out_of_memory();
        return EXIT_FAILED;
    }
    say(request, answer, budget, row);
    armtol_budget_destroy(budget);
    armtol_answer_destroy(answer);
    return EXIT_WRONG;
}
