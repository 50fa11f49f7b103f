/* What noise drives may have for a wished repeatability, as text and as JSON: docs/iso9283.md. */

#include "armtol/forms/wrap.h"
#include "armtol/names/link_name.h"
#include "armtol/tell/output.h"
#include "armtol/tell/text_tables.h"
#include "console/message.h"
#include "console/table.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { NAMED = 8 };

static bool slides(const findings *findings, size_t link)
{
    return findings->answer->links[link].joint == ARMTOL_PRISMATIC;
}

static bool moves(const findings *findings, size_t link)
{
    return findings->answer->links[link].joint != ARMTOL_FIXED;
}

/* In the user's units; what a drive that is not known has is 0. */
static double noise_of(const findings *findings, size_t link)
{
    const double noise = findings->answer->arrivals[link].noise;
    return units_shown(&findings->request->units, slides(findings, link), noise);
}

static double largest_of(const findings *findings, size_t link)
{
    return units_shown(&findings->request->units, slides(findings, link), findings->noises->largest[link]);
}

static double wish_of(const findings *findings)
{
    return units_shown(&findings->request->units, true, findings->request->repeatability);
}

static double bound_of(const findings *findings)
{
    return units_shown(&findings->request->units, true, findings->noises->bound);
}

/* ---- finding ---- */

static void say_nothing_left(const request *request, const armtol_answer *answer, size_t place,
                             const double none[], double shares[])
{
    const double bound = armtol_arrivals_bound(answer, place, none, shares);
    char sources[NAMED * (sizeof(link_text) + 20) + 32] = "", load[32] = "";
    size_t n = 0, length = 0;
    for (size_t i = 0; i < answer->n_links; i++) {
        if (shares[i] >= 5e-4 && n++ < NAMED) {
            length += (size_t)snprintf(sources + length, sizeof sources - length, "%s%s %.3g %%", n > 1 ? ", " : "",
                                       link_words(&request->arm, i, &(link_text){""}), 100 * shares[i]);
        }
    }
    if (n > NAMED) {
        snprintf(sources + length, sizeof sources - length, " and %zu more", n - NAMED);
    }
    if (answer->n_loads > 1) {
        snprintf(load, sizeof load, " with load %zu", place % answer->n_loads + 1);
    }
    message("no noise: steps and plays alone make an RP of %.4g %% of rp in pose %zu%s; of its square: %s",
            100 * bound / request->repeatability, place / answer->n_loads + 1, load, sources);
}

static bool get_memory(noises *noises, size_t n_links)
{
    noises->largest = calloc(n_links, sizeof *noises->largest);
    noises->shares = calloc(n_links, sizeof *noises->shares);
    return noises->largest != NULL && noises->shares != NULL;
}

bool noises_find(const request *request, const armtol_answer *answer, noises *noises, armtol_fault *fault)
{
    *fault = (armtol_fault){ARMTOL_NO_MEMORY, ARMTOL_ABOUT_NOTHING, 0};
    *noises = (struct noises){.bound = 0};
    if (get_memory(noises, answer->n_links)) {
        armtol_arrivals_noise(answer, request->repeatability, noises->largest, fault);
    }
    if (fault->status == ARMTOL_NOTHING_LEFT) { /* the noises are all 0 */
        say_nothing_left(request, answer, fault->number, noises->largest, noises->shares);
    }
    for (size_t pose = 0; pose < answer->n_poses && fault->status == ARMTOL_OK; pose++) {
        noises->bound = fmax(noises->bound, armtol_arrivals_bound(answer, pose, NULL, noises->shares));
    }
    if (fault->status != ARMTOL_OK) {
        noises_free(noises);
    }
    return fault->status == ARMTOL_OK;
}

void noises_free(noises *noises)
{
    free(noises->largest);
    free(noises->shares);
}

/* ---- telling ---- */

static void say_noises(const findings *findings)
{
    const units *units = &findings->request->units;
    wrap wrap;
    printf("\n");
    wrap_start(&wrap, stdout, 0, 0);
    wrap_say(&wrap, "The largest noise that the joints may come to rest with, a standard deviation, for a pose "
                    "repeatability RP of %.6g %s or less",
             wish_of(findings), units_name(units, true));
    wrap_say(&wrap, findings->answer->n_poses > 1 ? "in each pose, steps and free plays counted:"
                                                  : "in the pose, steps and free plays counted:");
    wrap_end(&wrap);
    printf("\n");
}

bool text_noises(const findings *findings)
{
    const armtol_answer *answer = findings->answer;
    const units *units = &findings->request->units;
    table table = TABLE_EMPTY;
    table_add(&table, "link\tnoise\tlargest\tunit");
    for (size_t i = 0; i < answer->n_links; i++) {
        const double largest = moves(findings, i) ? largest_of(findings, i) : 0;
        if (moves(findings, i)) {
            table_add(&table, "%s\t%.6g", link_cell(findings->request->question.arm, i, &(link_text){""}),
                      noise_of(findings, i));
            table_add_cells(&table, isinf(largest) ? "any" : "%.6g", largest);
            table_add_cells(&table, "%s", units_name(units, slides(findings, i)));
        }
    }
    say_noises(findings);
    const bool fine = table_finish(&table, NULL, NULL, FORMAT_TEXT, stdout);
    printf("\nWith the noise that the drives have RP is at most %.4g %s.\n", bound_of(findings),
           units_name(units, true));
    return fine;
}

void json_noises(json *json, const findings *findings)
{
    json_open_object(json, "rp");
    json_number(json, "wish", wish_of(findings));
    json_number(json, "bound", bound_of(findings));
    json_open_array(json, "joints");
    for (size_t i = 0; i < findings->answer->n_links; i++) {
        if (moves(findings, i)) {
            json_open_object(json, NULL);
            json_count(json, "link", i);
            json_text_if(json, "name", link_name(findings->request->question.arm, i));
            json_text(json, "unit", units_name(&findings->request->units, slides(findings, i)));
            json_number(json, "noise", noise_of(findings, i));
            json_number(json, "largest", largest_of(findings, i));
            json_close_object(json);
        }
    }
    json_close_array(json);
    json_close_object(json);
}
