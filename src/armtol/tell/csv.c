#include "armtol/tell/output.h"

#include "armtol/names/link_name.h"
#include "armtol/tell/grades.h"
#include "console/number.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* In quotes where it needs them: RFC 4180, and a # begins a comment in tables that are read again. */
static void put_text(const char *name)
{
    const bool quotes = strpbrk(name, "\",;#\t ") != NULL;
    putchar(',');
    fputs(quotes ? "\"" : "", stdout);
    for (; *name != '\0'; name++) {
        fputs(*name == '"' ? "\"\"" : (const char[]){*name, '\0'}, stdout);
    }
    fputs(quotes ? "\"" : "", stdout);
}

static void put_grades(const findings *findings, size_t column)
{
    const grades_held held = grades_of_parameter(findings, column);
    put_text(held.iso_286 != NULL ? held.iso_286 : "");
    put_text(grades_class(&held, "", (char[GRADES_CLASS]){""}));
}

/* Poses that were asked for by their positions: a remark for each, which whoever reads the table passes over. */
static void print_taken(const findings *findings)
{
    const request *request = findings->request;
    const armtol_arm *arm = request->question.arm;
    for (size_t pose = 0; pose < request->question.n_poses && request->taken != NULL; pose++) {
        const double *q = request->q + pose * findings->answer->n_joints;
        printf("# pose %zu: branch 1 of %zu, joints", pose + 1, request->taken[pose].n_branches);
        for (size_t i = 0; i < arm->n_links; i++) {
            if (armtol_arm_is_driven(arm, i)) {
                const double shown = units_typed(&request->units, arm->links[i].joint == ARMTOL_PRISMATIC, *q++);
                printf(" %s", number_shortest(shown, &armtol_errata_none, &(number_text){""}));
            }
        }
        printf("\n");
    }
}

bool output_csv(const findings *findings)
{
    const bool grades = findings->request->options->grades;
    const bool names = links_have_names(findings->request->question.arm);
    print_taken(findings);
    printf("link,kind,parameter,role,nominal,tolerance,unit%s%s%s\n", grades ? ",iso_286,iso_2768" : "",
           names ? ",name" : "", findings_are_spread(findings) ? ",distribution,shift,group" : "");
    for (size_t k = 0; k < findings->answer->n_columns; k++) {
        const parameter_row row = findings_parameter(findings, k);
        const char *tolerance = isfinite(row.tolerance)
                                    ? number_shortest(row.tolerance, &armtol_errata_none, &(number_text){""})
                                    : "inf";
        printf("%zu,%s,%s,%s,%s,%s,%s", row.link, row.kind, row.parameter, row.role,
               number_shortest(row.nominal, &armtol_errata_none, &(number_text){""}), tolerance, row.unit);
        if (grades) {
            put_grades(findings, k);
        }
        if (names) {
            put_text(row.name != NULL ? row.name : "");
        }
        if (findings_are_spread(findings)) {
            printf(",%s,%s", row.distribution.text,
                   number_shortest(row.shift, &armtol_errata_none, &(number_text){""}));
            put_text(row.group);
        }
        putchar('\n');
    }
    return true;
}
