#include "armtol/tell/text_tables.h"

#include "armtol/forms/wrap.h"

#include <math.h>
#include <stdio.h>

enum { MOST_TOLD = 4 };

/* "(dx, dy)": what the norm is of; or a unit vector of these components. */
static void say_components(wrap *wrap, unsigned components, const double direction[6], const char *end)
{
    const char *before = "(";
    for (size_t i = 0; i < 6; i++) {
        if ((components >> i & 1) != 0) {
            const char *behind = components >> (i + 1) == 0 ? end : ",";
            if (direction == NULL) {
                wrap_say(wrap, "%s%s%s", before, armtol_component_name(i), behind);
            } else {
                wrap_say(wrap, "%s%.3f%s", before, fabs(direction[i]) < 5e-4 ? 0 : direction[i], behind);
            }
            before = "";
        }
    }
}

/* Which of several poses. */
static void say_place(wrap *wrap, const findings *findings, size_t place)
{
    if (findings->request->question.n_poses > 1) {
        wrap_say(wrap, "in pose %zu", place / findings->answer->n_loads + 1);
    }
}

static void say_held(wrap *wrap, const findings *findings, size_t norm)
{
    const armtol_answer *answer = findings->answer;
    const armtol_held_direction *told[MOST_TOLD];
    size_t n = 0;
    for (size_t i = 0; i < answer->n_held && n < MOST_TOLD; i++) {
        const armtol_held_direction *held = &answer->held_directions[i];
        if (held->norm == norm && held->share > 5e-4) {
            told[n++] = held;
        }
    }
    for (size_t i = 0; i < n; i++) {
        wrap_say(wrap, i == 0 ? "It holds the tolerances down along" : "and along");
        say_components(wrap, answer->norms[norm].components, told[i]->direction, ")");
        say_place(wrap, findings, told[i]->pose);
        wrap_say(wrap, "(%.1f%%)%s", 100 * told[i]->share, i + 1 == n ? "." : "");
    }
}

static void print_norm(const findings *findings, size_t i)
{
    const armtol_predicted_norm *norm = &findings->answer->norms[i];
    const bool rss = findings->answer->method == ARMTOL_METHOD_RSS;
    wrap wrap;
    wrap_start(&wrap, stdout, 0, 0);
    wrap_say(&wrap, "%s, the length of", armtol_norm_name(norm->components));
    say_components(&wrap, norm->components, NULL, "),");
    if (isinf(norm->of.worst)) {
        wrap_say(&wrap, "has no bound.");
    } else {
        wrap_say(&wrap, rss ? "by sigma is largest along" : "is largest along");
        say_components(&wrap, norm->components, rss ? norm->spread_direction : norm->worst_direction, ")");
        say_place(&wrap, findings, rss ? norm->of.deviation_pose : norm->of.worst_pose);
        wrap_say(&wrap, "(or against it).");
    }
    if (findings_is_ap(findings, i)) {
        wrap_say(&wrap, "It was asked for as ap: one arrival keeps to it, and the mean of several is nearer.");
    }
    say_held(&wrap, findings, i);
    wrap_end(&wrap);
}

void text_norms(const findings *findings)
{
    if (findings->answer->n_norms > 0) {
        printf("\n");
    }
    for (size_t i = 0; i < findings->answer->n_norms; i++) {
        print_norm(findings, i);
    }
}
