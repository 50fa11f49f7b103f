#include "lib/engine/drives.h"

#include "armtol/tool_error.h"
#include "lib/arms/motion.h"
#include "lib/engine/check.h"
#include "lib/report/finite.h"

#include <math.h>
#include <stdbool.h>

const armtol_loading *question_loading(const armtol_question *question)
{
    return question->loading != NULL ? question->loading : &armtol_loading_standard;
}

size_t question_load_count(const armtol_question *question)
{
    const size_t n = question_loading(question)->n_payloads;
    return n > 0 ? n : 1;
}

/* ---- what is wrong ---- */

static bool is_size(double value)
{
    return value >= 0 && isfinite(value);
}

static bool is_drive(const armtol_drive *drive)
{
    return (isnan(drive->backlash) || is_size(drive->backlash)) && is_size(drive->compliance) &&
           is_size(drive->moment) && is_size(drive->resolution) && is_size(drive->friction) &&
           is_size(drive->noise);
}

/* Something that can bear on a joint beside what its drive's `moment` says. */
static bool is_loaded(const armtol_question *question)
{
    const armtol_loading *loading = question_loading(question);
    const bool force = loading->force[0] != 0 || loading->force[1] != 0 || loading->force[2] != 0;
    return question->arm->masses != NULL || loading->n_payloads > 0 || force;
}

static armtol_fault check_each(const armtol_question *question)
{
    const armtol_arm *arm = question->arm;
    for (size_t i = 0; i < arm->n_links; i++) {
        const armtol_drive *drive = &arm->drives[i];
        const bool moves = arm->links[i].joint != ARMTOL_FIXED;
        if (moves && (!is_drive(drive) || (drive->compliance > 0 && drive->moment == 0 && !is_loaded(question)))) {
            return fault_of(ARMTOL_BAD_LOAD, ARMTOL_ABOUT_DRIVES, i);
        }
    }
    return fault_of(ARMTOL_OK, ARMTOL_ABOUT_NOTHING, 0);
}

static bool is_mass(const armtol_mass *mass)
{
    return is_size(mass->mass) && all_finite(mass->center, 3);
}

static armtol_fault check_loading(const armtol_question *question)
{
    const armtol_loading *loading = question_loading(question);
    const double share = loading->compensated;
    bool fine = all_finite(loading->gravity, 3) && all_finite(loading->force, 3) && share >= 0 && share <= 1;
    for (size_t i = 0; i < loading->n_payloads && fine; i++) {
        fine = is_mass(&loading->payloads[i]);
    }
    return fault_of(fine ? ARMTOL_OK : ARMTOL_BAD_LOAD, ARMTOL_ABOUT_LOADING, 0);
}

static armtol_fault check_masses(const armtol_arm *arm)
{
    for (size_t i = 0; i < arm->n_links && arm->masses != NULL; i++) {
        if (!is_mass(&arm->masses[i])) {
            return fault_of(ARMTOL_BAD_LOAD, ARMTOL_ABOUT_ARM, i);
        }
    }
    return fault_of(ARMTOL_OK, ARMTOL_ABOUT_NOTHING, 0);
}

armtol_fault question_check_drives(const armtol_question *question)
{
    armtol_fault fault = check_loading(question);
    if (fault.status == ARMTOL_OK) {
        fault = check_masses(question->arm);
    }
    return fault.status == ARMTOL_OK ? check_each(question) : fault;
}

/* ---- Eq. (4.20) ---- */

static armtol_status find_moments(armtol_answer *answer, const armtol_question *question, size_t pose)
{
    const armtol_arm *arm = question->arm;
    const armtol_loading *loading = question_loading(question);
    const armtol_mass *payload = loading->n_payloads > 0 ? &loading->payloads[pose % answer->n_loads] : NULL;
    double *moments = answer->moments + pose * answer->n_links;
    const armtol_status status = armtol_moments(armtol_answer_links(answer, pose), answer->n_links, arm->masses,
                                                &answer->tool, payload, loading, moments);
    for (size_t i = 0; i < answer->n_links && status == ARMTOL_OK; i++) {
        moments[i] *= arm->links[i].joint == ARMTOL_REVOLUTE ? arm_metres(arm->unit) : 1;
    }
    return status;
}

/* A typed moment says the most that bears on a joint, in either sense, where the arm's masses do not say it. */
static double doubt_of(const armtol_question *question, size_t link)
{
    return question->arm->masses == NULL ? question->arm->drives[link].moment : 0;
}

static armtol_drive_offset offset_of(const armtol_answer *answer, const armtol_question *question, size_t pose,
                                     size_t link)
{
    const armtol_drive *drive = &question->arm->drives[link];
    return armtol_drive_offset_under(drive, answer->moments[pose * answer->n_links + link], doubt_of(question, link),
                                     question_loading(question)->compensated);
}

size_t answer_motor_column(const armtol_answer *answer, size_t link)
{
    size_t k = 0;
    while (k < answer->n_columns && !(answer->columns[k].link == link &&
                                      armtol_joint_moves(answer->links[link].joint, answer->columns[k].parameter))) {
        k++;
    }
    return k;
}

static armtol_status take_drive(armtol_answer *answer, const armtol_question *question, size_t pose, size_t link)
{
    const size_t k = answer_motor_column(answer, link);
    const bool moves = question->arm->links[link].joint != ARMTOL_FIXED;
    if (!moves || !armtol_drive_is_known(&question->arm->drives[link])) {
        return ARMTOL_OK;
    }
    if (k == answer->n_columns) { /* a kind that does not count what the joint moves has no place for its error */
        return ARMTOL_BAD_LOAD;
    }
    const armtol_drive_offset offset = offset_of(answer, question, pose, link);
    const size_t place = pose * answer->n_links + link;
    answer->arrivals[place] =
        armtol_drive_arrival_under(&question->arm->drives[link], answer->moments[place], doubt_of(question, link));
    answer->shifts[pose * answer->n_columns + k] = offset.shift;
    answer->bounded[pose * answer->n_columns + k] = offset.half;
    answer->tolerances[k] = fmax(answer->tolerances[k], offset.half);
    answer->given[k] = true;
    answer->loaded = answer->loaded || offset.shift != 0;
    answer->shifted = answer->loaded;
    return isfinite(offset.shift) && isfinite(offset.half) ? ARMTOL_OK : ARMTOL_NOT_FINITE;
}

static armtol_fault take_pose(armtol_answer *answer, const armtol_question *question, size_t pose)
{
    armtol_status status = find_moments(answer, question, pose);
    if (status != ARMTOL_OK) {
        return fault_of(status, ARMTOL_ABOUT_LOADING, 0);
    }
    size_t link = 0;
    while (link < answer->n_links && !question->drives_apart &&
           (status = take_drive(answer, question, pose, link)) == ARMTOL_OK) {
        link++;
    }
    return fault_of(status, ARMTOL_ABOUT_DRIVES, link);
}

armtol_fault answer_take_drives(armtol_answer *answer, const armtol_question *question)
{
    armtol_fault fault = fault_of(ARMTOL_OK, ARMTOL_ABOUT_NOTHING, 0);
    for (size_t pose = 0; pose < answer->n_poses && fault.status == ARMTOL_OK; pose++) {
        fault = take_pose(answer, question, pose);
    }
    return fault;
}

void answer_find_droops(armtol_answer *answer)
{
    for (size_t pose = 0; pose < answer->n_poses && answer->loaded; pose++) {
        armtol_tool_error(armtol_answer_links(answer, pose), answer->n_links, armtol_answer_shifts(answer, pose),
                          answer->n_columns, &answer->tool, answer->droops + 6 * pose);
    }
}

double answer_drive_error(const armtol_answer *answer, const armtol_question *question, size_t link)
{
    const armtol_drive *drive = &question->arm->drives[link];
    double most = 0;
    if (answer->links[link].joint == ARMTOL_FIXED || !armtol_drive_is_known(drive)) {
        return (double)NAN;
    }
    for (size_t pose = 0; pose < answer->n_poses; pose++) {
        const armtol_drive_offset offset = offset_of(answer, question, pose, link);
        most = fmax(most, fabs(offset.shift) + offset.half);
    }
    return most;
}
