#include "armtol/tell/findings.h"

const char *const component_names[6] = {"dx", "dy", "dz", "wx", "wy", "wz"};

static double nominal_of(const armtol_link *link, armtol_parameter parameter)
{
    const double values[ARMTOL_PARAMETER_COUNT] = {
        [ARMTOL_THETA] = link->theta, [ARMTOL_D] = link->d,       [ARMTOL_A] = link->a,
        [ARMTOL_ALPHA] = link->alpha, [ARMTOL_BETA] = link->beta,
    };
    return values[parameter];
}

parameter_row findings_parameter(const findings *findings, size_t column)
{
    const posed_arm *posed = &findings->request->posed;
    const units *units = &findings->request->units;
    const armtol_column *at = &posed->columns[column];
    const armtol_link *link = posed->n_poses == 1 ? &posed->links[at->link] : &posed->arm->links[at->link];
    const bool is_length = armtol_parameter_is_length(at->parameter);
    return (parameter_row){
        .link = at->link,
        .kind = armtol_kind_name(link->kind),
        .parameter = armtol_parameter_name(at->parameter),
        .role = posed_arm_is_motor(posed, column) ? "motor" : "machining",
        .unit = units_name(units, is_length),
        .nominal = units_shown(units, is_length, nominal_of(link, at->parameter)),
        .tolerance = units_shown(units, is_length, findings->answer->tolerances[column]),
    };
}

double findings_shown(const findings *findings, size_t component, double value)
{
    return units_shown(&findings->request->units, component < 3, value);
}
