#include "armtol/tell/findings.h"

parameter_row findings_parameter(const findings *findings, size_t column)
{
    const armtol_answer *answer = findings->answer;
    const units *units = &findings->request->units;
    const armtol_column *at = &answer->columns[column];
    armtol_link link = answer->n_poses == 1 ? answer->links[at->link] : findings->request->question.arm->links[at->link];
    const bool is_length = armtol_parameter_is_length(at->parameter);
    return (parameter_row){
        .link = at->link,
        .kind = armtol_kind_name(link.kind),
        .parameter = armtol_parameter_name(at->parameter),
        .role = armtol_role_name(armtol_role_of(&link, at->parameter)),
        .unit = units_name(units, is_length),
        .nominal = units_shown(units, is_length, *armtol_link_parameter(&link, at->parameter)),
        .tolerance = units_shown(units, is_length, answer->tolerances[column]),
    };
}

double findings_shown(const findings *findings, size_t component, double value)
{
    return units_shown(&findings->request->units, component < 3, value);
}
