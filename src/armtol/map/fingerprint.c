#include "armtol/map/fingerprint.h"

#include "armtol/cluster/tally_file.h"

#include <math.h>
#include <string.h>

/* By value, the low byte first, so that the order of bytes in memory does not matter. */
static void take_word(uint64_t *hash, uint64_t word)
{
    char bytes[8];
    for (int i = 0; i < 8; i++) {
        bytes[i] = (char)(unsigned char)(word >> (8 * i) & 0xff);
    }
    *hash = tally_checksum(*hash, bytes, sizeof bytes);
}

/* Machines differ in the bits of a nan. What is not given is no numbers. */
static void take_numbers(uint64_t *hash, const double numbers[], size_t n)
{
    take_word(hash, numbers != NULL);
    for (size_t i = 0; i < n && numbers != NULL; i++) {
        uint64_t bits = UINT64_MAX;
        if (!isnan(numbers[i])) {
            memcpy(&bits, &numbers[i], sizeof bits);
        }
        take_word(hash, bits);
    }
}

static void take_mass(uint64_t *hash, const armtol_mass *mass)
{
    take_numbers(hash, &mass->mass, 1);
    take_numbers(hash, mass->center, 3);
}

static void take_motion(uint64_t *hash, const armtol_motion *motion)
{
    const double numbers[] = {motion->multiplier, motion->offset, motion->sign};
    take_word(hash, motion->follows);
    take_numbers(hash, numbers, sizeof numbers / sizeof numbers[0]);
}

static void take_arm(uint64_t *hash, const request *request)
{
    const armtol_arm *arm = &request->arm;
    take_word(hash, request->options->ignore_limits);
    take_word(hash, (uint64_t)arm->unit);
    take_word(hash, arm->n_links);
    for (size_t i = 0; i < arm->n_links; i++) {
        const armtol_link *link = &arm->links[i];
        const armtol_drive *drive = &arm->drives[i];
        const double numbers[] = {link->a, link->alpha, link->d, link->theta, link->beta,
                                  drive->low, drive->high, drive->backlash, drive->compliance, drive->moment,
                                  drive->resolution, drive->friction, drive->noise};
        take_word(hash, (uint64_t)link->kind);
        take_word(hash, (uint64_t)link->joint);
        take_numbers(hash, numbers, sizeof numbers / sizeof numbers[0]);
        if (arm->masses != NULL) {
            take_mass(hash, &arm->masses[i]);
        }
        if (arm->motions != NULL && link->joint != ARMTOL_FIXED) {
            take_motion(hash, &arm->motions[i]);
        }
    }
}

/* The poses of the command line: where to begin, and what tolerances are asked for. */
static void take_poses(uint64_t *hash, const request *request)
{
    const armtol_question *question = &request->question;
    take_word(hash, question->n_poses);
    take_word(hash, request->taken != NULL && request->taken[0].own);
    take_numbers(hash, question->n_poses > 0 ? question->q : NULL,
                 question->n_poses * armtol_arm_joint_count(&request->arm));
}

static void take_plane(uint64_t *hash, const map_plan *plan)
{
    const double ends[] = {plan->first[0], plan->first[1], plan->last[0], plan->last[1], plan->offset};
    take_word(hash, plan->right);
    take_word(hash, plan->up);
    take_word(hash, plan->n[0]);
    take_word(hash, plan->n[1]);
    take_numbers(hash, ends, sizeof ends / sizeof ends[0]);
    take_word(hash, plan->keeps_axes);
    take_numbers(hash, plan->keeps_axes ? plan->axes[0] : NULL, 9);
}

static void take_value(uint64_t *hash, const map_plan *plan)
{
    take_word(hash, (uint64_t)plan->map.value);
    take_word(hash, plan->map.component);
    for (size_t k = 0; k < plan->request->n_columns && plan->columns != NULL; k++) {
        take_word(hash, plan->columns[k]);
    }
}

static void take_tool(uint64_t *hash, const request *request)
{
    take_word(hash, (uint64_t)request->question.tool.frame);
    take_numbers(hash, request->question.tool.offset, 3);
}

/* Those given, and how others are asked for. */
static void take_tolerances(uint64_t *hash, const request *request)
{
    const armtol_question *question = &request->question;
    take_word(hash, (uint64_t)question->method);
    take_numbers(hash, &question->sigma, 1);
    take_numbers(hash, &question->delta, 1);
    take_numbers(hash, question->tolerances, request->n_columns);
    take_numbers(hash, question->weights, request->n_columns);
    take_numbers(hash, question->least, request->n_columns);
    take_numbers(hash, question->largest, request->n_columns);
    for (size_t k = 0; k < request->n_columns; k++) {
        if (request->discs[k]) { /* without any it is that of a question without drawings */
            take_word(hash, k);
        }
    }
}

static void take_loads(uint64_t *hash, const armtol_question *question)
{
    const armtol_loading *loading = question->loading;
    take_word(hash, question->drives_apart);
    take_numbers(hash, loading->gravity, 3);
    take_numbers(hash, loading->force, 3);
    take_numbers(hash, &loading->compensated, 1);
    for (size_t i = 0; i < loading->n_payloads; i++) {
        take_mass(hash, &loading->payloads[i]);
    }
}

static void take_accuracy(uint64_t *hash, const armtol_question *question)
{
    take_numbers(hash, question->accuracy, 6);
    for (size_t i = 0; i < question->n_norms; i++) {
        take_word(hash, question->norms[i].components);
        take_numbers(hash, &question->norms[i].limit, 1);
    }
}

void map_fingerprints(const map_plan *plan, uint64_t fingerprints[])
{
    const request *request = plan->request;
    for (size_t i = 0; i < ROWS_SUBJECTS; i++) {
        fingerprints[i] = TALLY_CHECKSUM_START;
    }
    take_arm(&fingerprints[ROWS_ARM], request);
    take_poses(&fingerprints[ROWS_POSE], request);
    take_plane(&fingerprints[ROWS_PLANE], plan);
    take_value(&fingerprints[ROWS_VALUE], plan);
    take_tool(&fingerprints[ROWS_TOOL], request);
    take_tolerances(&fingerprints[ROWS_TOLERANCES], request);
    take_loads(&fingerprints[ROWS_LOADS], &request->question);
    take_accuracy(&fingerprints[ROWS_ACCURACY], &request->question);
}
