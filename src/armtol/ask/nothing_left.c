#include "armtol/ask/nothing_left.h"

#include "armtol/budget.h"
#include "armtol/names/link_name.h"
#include "console/exit_code.h"
#include "console/message.h"

#include <math.h>
#include <stdint.h>
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

/* Of what least is left: a component or a norm, where, and what it comes to by the method's sum. */
typedef struct exceeded {
    const char *name;
    size_t place;
    size_t component, norm; /* one of them; the norm is SIZE_MAX where it is a component */
    double accuracy;
} exceeded;

static exceeded exceeded_of(const request *request, const armtol_fault *fault)
{
    const size_t n_norms = request->question.n_norms;
    if (fault->about != ARMTOL_ABOUT_NORM_PLACE) {
        const size_t i = fault->number % 6;
        return (exceeded){armtol_component_name(i), fault->number / 6, i, SIZE_MAX, request->accuracy[i]};
    }
    const size_t i = fault->number % n_norms;
    const armtol_norm *norm = &request->norms[i];
    return (exceeded){armtol_norm_name(norm->components), fault->number / n_norms, 0, i, norm->limit};
}

static double whole_of(const armtol_answer *answer, const exceeded *exceeded)
{
    const bool is_norm = exceeded->norm != SIZE_MAX;
    const armtol_predicted *of = is_norm ? &answer->norms[exceeded->norm].of : &answer->components[exceeded->component];
    if (answer->method != ARMTOL_METHOD_RSS) {
        return of->worst;
    }
    return is_norm ? answer->norms[exceeded->norm].spread : of->shift + answer->sigma * of->deviation;
}

static double share_of(const armtol_budget_row *row, const exceeded *exceeded)
{
    return exceeded->norm != SIZE_MAX ? row->norm_shares[exceeded->norm] : row->shares[exceeded->component];
}

static void list_sources(const armtol_arm *arm, const armtol_budget *budget, const exceeded *exceeded, double percent,
                         char *text, size_t size)
{
    size_t n = 0, length = 0;
    for (size_t r = 0; r < budget->n_rows; r++) {
        const armtol_budget_row *row = &budget->rows[r];
        if (fabs(share_of(row, exceeded)) < 5e-4) {
            continue;
        }
        if (n++ < NAMED) {
            length += (size_t)snprintf(text + length, size - length, "%s%s of %s %.3g %%", n > 1 ? ", " : "",
                                       armtol_role_name(row->role), link_words(arm, row->link, &(link_text){""}),
                                       percent * share_of(row, exceeded));
        }
    }
    if (n > NAMED) {
        snprintf(text + length, size - length, " and %zu more", n - NAMED);
    }
}

static void say(const request *request, const armtol_answer *answer, const armtol_budget *budget,
                const exceeded *exceeded)
{
    const size_t n_loads = request->loading.n_payloads, place = exceeded->place;
    const double percent = 100 * whole_of(answer, exceeded) / exceeded->accuracy;
    const cli_options *options = request->options;
    const bool given = options->given != NULL || options->drawing != NULL || request->question.spreads != NULL;
    char sources[NAMED * (sizeof(link_text) + 40) + 32] = "", load[32] = "";
    if (n_loads > 1) {
        snprintf(load, sizeof load, " with load %zu", place % n_loads + 1);
    }
    list_sources(&request->arm, budget, exceeded, percent, sources, sizeof sources);
    message("no tolerances: %s %.4g %% of %s in pose %zu%s: %s",
            given ? "what is given uses" : "the drives alone use", percent, exceeded->name,
            place / (n_loads > 0 ? n_loads : 1) + 1, load, sources);
}

int nothing_left(const request *request, const armtol_fault *fault)
{
    const exceeded exceeded = exceeded_of(request, fault);
    armtol_answer *answer = NULL;
    armtol_budget *budget = NULL;
    if (ask_for_the_known(request, exceeded.place, &answer) != ARMTOL_OK ||
        armtol_budget_create(answer, &budget) != ARMTOL_OK) {
        armtol_answer_destroy(answer);
        out_of_memory();
        return EXIT_FAILED;
    }
    say(request, answer, budget, &exceeded);
    armtol_budget_destroy(budget);
    armtol_answer_destroy(answer);
    return EXIT_WRONG;
}
