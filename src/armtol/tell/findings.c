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
    parameter_row row = {
        .link = at->link,
        .name = link_name(findings->request->question.arm, at->link),
        .kind = armtol_kind_name(link.kind),
        .parameter = armtol_parameter_name(at->parameter),
        .role = armtol_role_name(armtol_role_of(&link, at->parameter)),
        .unit = units_name(units, is_length),
        .nominal = units_typed(units, is_length, *armtol_link_parameter(&link, at->parameter)),
        .given = answer->given[column],
        .drawn = findings->request->drawn[column],
        .in_disc = answer->discs[column] || (column > 0 && answer->discs[column - 1]),
        .held = answer->held[column],
        .tolerance = units_shown(units, is_length, answer->tolerances[column]),
        .shift = units_shown(units, is_length, answer->spreads[column].shift),
        .group = "",
    };
    distribution_words(&answer->spreads[column], &row.distribution);
    if (answer->spreads[column].group != 0) {
        row.group = findings->request->groups[answer->spreads[column].group - 1].text;
    }
    return row;
}

bool findings_are_spread(const findings *findings)
{
    return findings->request->question.spreads != NULL;
}

bool findings_are_shifted(const findings *findings)
{
    bool any = false;
    for (size_t k = 0; k < findings->answer->n_columns; k++) {
        any = any || findings->answer->spreads[k].shift != 0;
    }
    return any;
}

size_t findings_measures(const findings *findings)
{
    return 6 + findings->answer->n_norms;
}

const char *findings_name(const findings *findings, size_t measure)
{
    return measure < 6 ? armtol_component_name(measure)
                       : armtol_norm_name(findings->answer->norms[measure - 6].components);
}

const armtol_predicted *findings_predicted(const findings *findings, size_t measure)
{
    const armtol_answer *answer = findings->answer;
    return measure < 6 ? &answer->components[measure] : &answer->norms[measure - 6].of;
}

const armtol_verified *findings_verified(const findings *findings, size_t measure)
{
    const armtol_verification *found = findings->verification;
    return measure < 6 ? &found->components[measure] : &found->norms[measure - 6];
}

bool findings_is_length(const findings *findings, size_t measure)
{
    return measure < 6 ? measure < 3 : armtol_norm_is_length(findings->answer->norms[measure - 6].components);
}

bool findings_is_ap(const findings *findings, size_t norm)
{
    return findings->request->as_ap && findings->answer->norms[norm].components == armtol_norm_of_name("r");
}

double findings_accuracy(const findings *findings, size_t measure)
{
    const armtol_answer *answer = findings->answer;
    return findings->request->question.accuracy == NULL ? (double)NAN
           : measure < 6                                ? answer->accuracy[measure]
                                                        : answer->norms[measure - 6].limit;
}

double findings_sigmas(const findings *findings, size_t measure)
{
    const armtol_predicted *of = findings_predicted(findings, measure);
    return measure < 6 ? of->shift + findings->request->options->sigma * of->deviation
                       : findings->answer->norms[measure - 6].spread;
}

double findings_share(const armtol_budget_row *row, size_t measure)
{
    return measure < 6 ? row->shares[measure] : row->norm_shares[measure - 6];
}

double findings_motors(const armtol_budget *budget, size_t measure)
{
    return measure < 6 ? budget->motors[measure] : budget->norm_motors[measure - 6];
}

double findings_loads(const armtol_budget *budget, size_t measure)
{
    return measure < 6 ? budget->loads[measure] : budget->norm_loads[measure - 6];
}

double findings_shifts(const armtol_budget *budget, size_t measure)
{
    return measure < 6 ? budget->shifts[measure] : budget->norm_shifts[measure - 6];
}

size_t findings_pose(const findings *findings, size_t measure)
{
    const armtol_predicted *predicted = findings_predicted(findings, measure);
    const size_t pose = predicted->binds > 0                              ? predicted->binds_pose
                        : findings->answer->method == ARMTOL_METHOD_RSS ? predicted->deviation_pose
                                                                          : predicted->worst_pose;
    return pose / findings->answer->n_loads;
}

double findings_shown(const findings *findings, size_t measure, double value)
{
    return units_shown(&findings->request->units, findings_is_length(findings, measure), value);
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

const char *findings_enclosure_name(const armtol_enclosure *enclosure)
{
    size_t i = 0;
    while (i < 6 && enclosure->components != 1u << i) {
        i++;
    }
    return i < 6 ? armtol_component_name(i) : armtol_norm_name(enclosure->components);
}

bool findings_enclosure_is_length(const armtol_enclosure *enclosure)
{
    return enclosure->components < 1u << 3;
}

double findings_gap(const armtol_enclosure *enclosure)
{
    return enclosure->high > enclosure->low ? enclosure->high / enclosure->low - 1 : 0;
}
