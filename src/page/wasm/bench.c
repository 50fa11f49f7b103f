/* The 66 numbers, computed with the errata and the words on the stack that a reader chooses. */

#include "armtol/armtol.h"
#include "console/message.h"
#include "lab/published.h"
#include "lab/recompute.h"
#include "lab/reproduce/compare.h"
#include "page/wasm/page.h"
#include "page/wasm/told.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static published_list published;

int page_open(const char *path)
{
    message_start("page");
    return published_read(path, &published);
}

const char *page_errata(void)
{
    json *json = told_begin();
    if (json == NULL) {
        return "{}";
    }
    json_open_array(json, "errata");
    for (size_t i = 0; i < armtol_errata_count(); i++) {
        const armtol_erratum_info *info = armtol_erratum(i);
        json_open_object(json, NULL);
        json_text(json, "id", info->id);
        json_text(json, "slip", info->slip);
        json_text(json, "touches", info->touches);
        json_close_object(json);
    }
    json_close_array(json);
    return told_end();
}

/* Names with a blank between each. */
static armtol_errata errata_without(const char *corrected)
{
    armtol_errata errata = armtol_errata_1987;
    char names[1024];
    snprintf(names, sizeof names, "%s", corrected);
    for (char *name = strtok(names, " "); name != NULL; name = strtok(NULL, " ")) {
        armtol_erratum_keep(&errata, name, false);
    }
    return errata;
}

static double float_of_word(uint32_t word)
{
    float seen;
    memcpy(&seen, &word, sizeof seen);
    return (double)seen;
}

static void tell_number(json *json, const published_number *number, const char *files)
{
    static const char *const verdicts[] = {"agrees", "agrees without its sign", "differs", "missing"};
    const comparison comparison = compare_number(number, files);
    json_open_object(json, NULL);
    json_text(json, "quantity", number->quantity);
    json_text(json, "published", number->value);
    json_text(json, "computed", comparison.computed);
    json_text(json, "verdict", verdicts[comparison.verdict]);
    json_close_object(json);
}

static void tell_case(json *json, size_t first, const armtol_errata *errata, const armtol_residue *residue)
{
    analysis analysis;
    const published_number *number = &published.numbers[first];
    json_open_object(json, NULL);
    json_text(json, "program", number->program);
    json_count(json, "number", (uint64_t)number->case_number);
    if (recompute(&published, first, errata, residue, &analysis)) {
        char *files = recompute_text(&analysis, program_named(number->program));
        json_number(json, "distance", analysis.bounds.distance);
        json_number(json, "angle", analysis.bounds.angle);
        json_number(json, "distanceShare", analysis.shares.distance);
        json_number(json, "angleShare", analysis.shares.angle);
        json_open_array(json, "results");
        for (size_t i = first; files != NULL && i < published.count; i++) {
            if (published.numbers[i].role == ROLE_RESULT && published_same_case(&published.numbers[i], number)) {
                tell_number(json, &published.numbers[i], files);
            }
        }
        json_close_array(json);
        free(files);
        analysis_free(&analysis);
    }
    json_close_object(json);
}

static const char *tell_cases(const armtol_errata *errata, const armtol_residue *of_adept)
{
    json *json = told_begin();
    if (json == NULL) {
        return "{}";
    }
    json_open_array(json, "cases");
    for (size_t i = 0; i < published.count; i++) {
        if (published_begins_case(&published, i)) {
            const bool adept = strcmp(published.numbers[i].program, "adpta") == 0;
            tell_case(json, i, errata, adept ? of_adept : NULL);
        }
    }
    json_close_array(json);
    return told_end();
}

const char *page_bench(const char *corrected)
{
    const armtol_errata errata = errata_without(corrected);
    return tell_cases(&errata, NULL);
}

const char *page_stack(uint32_t first, uint32_t second, uint32_t third)
{
    const armtol_residue residue = {{float_of_word(first), float_of_word(second), float_of_word(third)}};
    return tell_cases(&armtol_errata_1987, &residue);
}

/* The links of the Adept as adpta stores them, all joints at 0: its tool has none. */
static void adept_links(armtol_link links[6])
{
    static const double rest[4] = {0};
    armtol_adept_one.links(&armtol_errata_1987, links);
    armtol_links_place(links, 6, rest, 4, &armtol_errata_1987, links);
}

double page_tool_alpha(void)
{
    armtol_link links[6];
    adept_links(links);
    return links[5].alpha;
}

double page_tool_residue(int place)
{
    armtol_link links[6];
    adept_links(links);
    return armtol_skew_residue(links, 6, &armtol_errata_1987).diagonal[place];
}
