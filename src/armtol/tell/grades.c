#include "armtol/tell/grades.h"

#include "armtol/grades.h"

#include <math.h>
#include <stdio.h>

static const char *class_named(armtol_general of)
{
    return of == ARMTOL_GENERAL_COUNT ? NULL : armtol_general_name(of);
}

/* Both in the arm's unit. */
static grades_held of_length(const findings *findings, double size, double tolerance)
{
    static const char *const grades[] = {
        [ARMTOL_GRADE_FINER] = "finer than IT5", "IT5", "IT6", "IT7", "IT8", "IT9", "IT10", "IT11", "IT12",
        [ARMTOL_GRADE_WIDER] = "wider than IT12",
    };
    const double unit = arm_model_millimetres(findings->request->units.arm);
    const double size_mm = fabs(size) * unit, tolerance_mm = tolerance * unit;
    const int grade = armtol_grade_within(size_mm, tolerance_mm);
    return (grades_held){
        .iso_286 = grade != ARMTOL_GRADE_NONE ? grades[grade] : size_mm > 0 ? "over 500 mm" : "size 0",
        .iso_2768 = class_named(armtol_general_within(size_mm, tolerance_mm)),
        .side = (double)NAN,
    };
}

grades_held grades_of_angle(double tolerance)
{
    const double side = armtol_general_side(tolerance);
    if (isinf(side)) {
        return (grades_held){.side = (double)NAN};
    }
    return (grades_held){.iso_2768 = armtol_general_name(ARMTOL_GENERAL_MEDIUM), .side = side};
}

bool grades_has_parameter(const findings *findings, size_t column)
{
    const armtol_column *at = &findings->answer->columns[column];
    return armtol_role_of(&findings->answer->links[at->link], at->parameter) == ARMTOL_MACHINING;
}

grades_held grades_of_parameter(const findings *findings, size_t column)
{
    const armtol_answer *answer = findings->answer;
    const armtol_column *at = &answer->columns[column];
    armtol_link link = answer->links[at->link];
    if (!grades_has_parameter(findings, column)) {
        return (grades_held){.side = (double)NAN};
    }
    return armtol_parameter_is_length(at->parameter)
               ? of_length(findings, *armtol_link_parameter(&link, at->parameter), answer->tolerances[column])
               : grades_of_angle(answer->tolerances[column]);
}

/* The axis of a slide has no place, whatever method sphere says of its distance. */
bool grades_has_distance(const findings *findings, size_t link)
{
    return findings->answer->links[link].joint != ARMTOL_PRISMATIC;
}

/* Parallel axes are |a| apart. */
double grades_distance(const findings *findings, size_t link)
{
    const armtol_link *of = &findings->answer->links[link];
    const bool parallel = of->kind == ARMTOL_PPR || of->kind == ARMTOL_PPP;
    return parallel ? fabs(of->a) : sqrt(of->a * of->a + of->d * of->d);
}

grades_held grades_of_distance(const findings *findings, size_t link)
{
    return of_length(findings, grades_distance(findings, link), findings->answer->parts[link].distance);
}

const char *grades_class(const grades_held *held, const char *none, char text[GRADES_CLASS])
{
    if (held->iso_2768 == NULL) {
        snprintf(text, GRADES_CLASS, "%s", none);
    } else if (held->side > 0) {
        snprintf(text, GRADES_CLASS, "%s over %g mm", held->iso_2768, held->side);
    } else {
        snprintf(text, GRADES_CLASS, "%s", held->iso_2768);
    }
    return text;
}
