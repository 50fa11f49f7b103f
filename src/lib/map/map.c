#include "armtol/map.h"

#include "armtol/error_matrix.h"
#include "lib/engine/check.h"
#include "lib/map/values.h"
#include "lib/norms/discs.h"

#include <math.h>

const char *armtol_map_value_name(armtol_map_value value)
{
    static const char *const names[ARMTOL_MAP_VALUE_COUNT] = {"worst", "droop", "repeatability", "tolerance"};
    return (size_t)value < ARMTOL_MAP_VALUE_COUNT ? names[value] : "?";
}

bool map_is_left_out(const double q[], size_t n_joints)
{
    return n_joints > 0 && isnan(q[0]);
}

static bool has_what_it_needs(const armtol_question *question, const armtol_map *map)
{
    switch (map->value) {
    case ARMTOL_MAP_WORST:
        return question->tolerances != NULL && map->component < ARMTOL_MAP_COMPONENT_COUNT;
    case ARMTOL_MAP_DROOP:
    case ARMTOL_MAP_REPEATABILITY:
        return map->component < ARMTOL_MAP_COMPONENT_COUNT;
    case ARMTOL_MAP_TOLERANCE:
        return question->tolerances == NULL && (question->accuracy != NULL || question->n_norms > 0) &&
               map->columns != NULL;
    default:
        return false;
    }
}

/* Whether the drives are in no error, whatever the pose. */
static bool is_without_drives(const armtol_question *question)
{
    bool known = false;
    for (size_t i = 0; i < question->arm->n_links; i++) {
        known = known || (question->arm->links[i].joint != ARMTOL_FIXED &&
                          armtol_drive_is_known(&question->arm->drives[i]));
    }
    return question->drives_apart || !known;
}

static bool all_bounded(const armtol_question *question, size_t n_columns)
{
    bool bounded = true;
    for (size_t k = 0; k < n_columns; k++) {
        bounded = bounded && isfinite(question->tolerances[k]);
    }
    return bounded;
}

static armtol_fault find(const armtol_question *question, const armtol_map *map, double values[])
{
    if (question->arm == NULL || question->n_poses == 0 || !has_what_it_needs(question, map)) {
        return fault_of(ARMTOL_BAD_QUESTION, ARMTOL_ABOUT_QUESTION, 0);
    }
    if (question->spreads != NULL) {
        return fault_of(ARMTOL_BAD_SPREAD, ARMTOL_ABOUT_SPREADS, 0);
    }
    if (map->value != ARMTOL_MAP_WORST) {
        return map_answers(question, map, values);
    }
    armtol_fault fault = question_check(question);
    if (fault.status != ARMTOL_OK) {
        return fault;
    }
    const size_t n = armtol_column_count(question->arm->links, question->arm->n_links);
    fault = question_check_columns(question, n);
    if (fault.status != ARMTOL_OK) {
        return fault;
    }
    const bool boxes = discs_count(question->discs, n) == 0 && all_bounded(question, n);
    return is_without_drives(question) && boxes ? map_blocks(question, map, values)
                                                : map_answers(question, map, values);
}

armtol_status armtol_map_values(const armtol_question *question, const armtol_map *map, double values[],
                                armtol_fault *fault)
{
    const armtol_fault found = find(question, map, values);
    if (fault != NULL) {
        *fault = found;
    }
    return found.status;
}
