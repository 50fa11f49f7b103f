#include "armtol/tell/findings.h"

#include "armtol/names/link_name.h"

#include <math.h>

parameter_row findings_parameter(const findings *findings, size_t column)
{
    const armtol_answer *answer = findings->answer;
    const units *units = &findings->request->units;
    const armtol_column *at = &answer->columns[column];
    armtol_link link = findings->request->question.n_poses == 1 ? answer->links[at->link]
                                                                : findings->request->question.arm->links[at->link];
    const bool is_length = armtol_parameter_is_length(at->parameter);
    return (parameter_row){
        .link = at->link,
        .name = link_name(findings->request->question.arm, at->link),
        .kind = armtol_kind_name(link.kind),
        .parameter = armtol_parameter_name(at->parameter),
        .role = armtol_role_name(armtol_role_of(&link, at->parameter)),
        .unit = units_name(units, is_length),
        .nominal = units_typed(units, is_length, *armtol_link_parameter(&link, at->parameter)),
        .given = answer->given[column],
        .held = answer->held[column],
        .tolerance = units_shown(units, is_length, answer->tolerances[column]),
    };
}

size_t findings_pose(const findings *findings, size_t component)
{
    const armtol_predicted *predicted = &findings->answer->components[component];
    const size_t pose = predicted->binds > 0                              ? predicted->binds_pose
                        : findings->answer->method == ARMTOL_METHOD_RSS ? predicted->deviation_pose
                                                                          : predicted->worst_pose;
    return pose / findings->answer->n_loads;
}

double findings_shown(const findings *findings, size_t component, double value)
{
    return units_shown(&findings->request->units, component < 3, value);
}

void findings_load_difference(const findings *findings, size_t pose, double difference[6])
{
    const armtol_answer *answer = findings->answer;
    for (size_t i = 0; i < 6; i++) {
        double least = (double)INFINITY, most = -(double)INFINITY;
        for (size_t load = 0; load < answer->n_loads; load++) {
            const double droop = answer->droops[6 * (pose * answer->n_loads + load) + i];
            least = fmin(least, droop);
            most = fmax(most, droop);
        }
        difference[i] = findings_shown(findings, i, most - least);
    }
}
