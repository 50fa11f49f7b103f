#include "armtol/region.h"

#include "armtol/corners.h"
#include "lib/region/enclose.h"
#include "lib/region/refused.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/*
 * Tolerances for a region are those for poses: the worst of the region are added to the question until none is left
 * that exceeds the accuracy. It is asked for a little less than that, e / (1 + 0.9 gap), and poses are added where
 * that is exceeded by a tenth of the gap: then the boxes have the rest of the gap to end in, and what they end with
 * is within e.
 */
#define TIGHTENED 0.9
#define EXCEEDED 0.1
enum { MOST_ROUNDS = 400, DRAWN = 8, TRIES = 400 };

#define USUAL_GAP 0.01
#define USUAL_MOST 1000000

/* Poses, one after the other. */
typedef struct pose_list {
    double *q;
    size_t count;
} pose_list;

typedef struct work {
    const armtol_question *question;
    const armtol_region *region;
    armtol_enclosing how;
    size_t n_joints, n_columns;
    chain chain;
    loads loads;
    pose_search search;
    armtol_region_answer *made;
    armtol_answer *answer; /* of the poses so far */
    pose_list rows, drawn; /* that hold the tolerances down; that are drawn from the region */
    double accuracy[6];    /* tightened, as are: */
    armtol_norm norms[ARMTOL_MOST_NORMS];
    double *variables, *marks; /* a pose; a column's 1 or 0 */
    region_refusal refusal;
} work;

static bool refuse(work *work, armtol_status status, armtol_subject about, size_t number, armtol_region_fault why)
{
    work->refusal = region_refusal_of(status, about, number, why);
    return false;
}

static bool out_of_memory(work *work)
{
    return refuse(work, ARMTOL_NO_MEMORY, ARMTOL_ABOUT_NOTHING, 0, ARMTOL_REGION_FINE);
}

/* ---- poses ---- */

static bool append(work *work, pose_list *list, const double q[])
{
    const size_t n = work->n_joints;
    double *more = realloc(list->q, (list->count + 1) * (n + 1) * sizeof *more); /* never of no bytes */
    if (more == NULL) {
        return out_of_memory(work);
    }
    list->q = more;
    memcpy(more + list->count * n, q, n * sizeof *more);
    list->count++;
    return true;
}

static bool append_found(work *work, pose_list *list)
{
    return append(work, list, work->variables + CHAIN_DIRECTIONS);
}

static size_t first_infinite(const double tolerances[], size_t n)
{
    size_t k = 0;
    while (k < n && isfinite(tolerances[k])) {
        k++;
    }
    return k;
}

/* ---- measures ---- */

static void add_measure(work *work, unsigned components, double accuracy)
{
    armtol_enclosure *enclosure = &work->made->enclosures[work->made->n_enclosures++];
    *enclosure = (armtol_enclosure){.components = components, .accuracy = accuracy, .high = (double)INFINITY};
}

static void add_measures(work *work)
{
    const armtol_question *question = work->question;
    const bool none = question->accuracy == NULL && question->n_norms == 0;
    for (unsigned i = 0; i < 6; i++) {
        const double accuracy = question->accuracy != NULL ? question->accuracy[i] : (double)INFINITY;
        if (none || isfinite(accuracy)) {
            add_measure(work, 1u << i, accuracy);
        }
    }
    for (size_t i = 0; i < question->n_norms; i++) {
        add_measure(work, question->norms[i].components, question->norms[i].limit);
    }
}

static double sigma_of(const work *work)
{
    return work->question->method == ARMTOL_METHOD_RSS ? work->question->sigma : 0;
}

/* The error with tolerances, and where that is so with drives under a load. */
static void measure_with(work *work, const armtol_enclosure *enclosure, const double tolerances[], bool loaded)
{
    chain_measure(&work->chain, work->region, enclosure->components, tolerances, sigma_of(work), loaded);
}

/* ---- the poses' own answer ---- */

static bool is_asked(const work *work)
{
    return work->question->tolerances == NULL;
}

/* Rows first, and then those that are drawn, of which there is one at least; to be freed. NULL after a refusal. */
static double *all_poses(work *work)
{
    const size_t n = work->n_joints, rows = work->rows.count, drawn = work->drawn.count;
    double *q = calloc(rows + drawn, (n + 1) * sizeof *q);
    if (q == NULL) {
        out_of_memory(work);
        return NULL;
    }
    if (rows > 0) {
        memcpy(q, work->rows.q, rows * n * sizeof *q);
    }
    memcpy(q + rows * n, work->drawn.q, drawn * n * sizeof *q);
    return q;
}

static bool ask(work *work, const double tolerances[], armtol_answer **answer)
{
    armtol_question question = *work->question;
    double *q = all_poses(work);
    if (q == NULL) {
        return false;
    }
    question.q = q;
    question.n_poses = work->rows.count + work->drawn.count;
    question.accuracy = is_asked(work) && question.accuracy != NULL ? work->accuracy : question.accuracy;
    question.norms = is_asked(work) ? work->norms : question.norms;
    question.tolerances = tolerances;
    question.least = tolerances != NULL ? NULL : question.least;
    question.largest = tolerances != NULL ? NULL : question.largest;
    armtol_answer_destroy(*answer);
    armtol_fault fault;
    const armtol_status status = armtol_answer_create(&question, answer, &fault);
    free(q);
    return status == ARMTOL_OK || refuse(work, status, fault.about, fault.number, ARMTOL_REGION_FINE);
}

/* ---- some pose of the region ---- */

static void mark(work *work, double value)
{
    for (size_t k = 0; k < work->n_columns; k++) {
        work->marks[k] = value;
    }
}

/* Where drawing does not find any the boxes do, or tell that there is none. */
static bool find_first(work *work)
{
    const enclose_target target = {.gap = 10, .limit = (double)INFINITY, .too_much = -1, .most = work->how.most,
                                   .progress = work->how.progress, .context = work->how.context};
    armtol_enclosure found = work->made->enclosures[0];
    mark(work, 1);
    measure_with(work, &found, work->marks, false);
    const armtol_status status = enclose(&work->search, &target, work->variables, &found);
    if (status == ARMTOL_OK) {
        return append_found(work, &work->drawn);
    }
    const bool empty = status == ARMTOL_OUT_OF_REACH, short_of_memory = status == ARMTOL_NO_MEMORY;
    return short_of_memory ? out_of_memory(work) : refuse(work, status, ARMTOL_ABOUT_QUESTION, 0,
                                                          empty ? ARMTOL_REGION_EMPTY : ARMTOL_REGION_NOT_FOUND);
}

/* From all of the ranges, symmetry apart. */
static bool draw_poses(work *work)
{
    memcpy(work->chain.low + CHAIN_DIRECTIONS, work->region->low, work->n_joints * sizeof *work->chain.low);
    memcpy(work->chain.high + CHAIN_DIRECTIONS, work->region->high, work->n_joints * sizeof *work->chain.high);
    for (int i = 0; i < TRIES && work->drawn.count < DRAWN; i++) {
        if (pose_draw(&work->search, work->variables) && !append_found(work, &work->drawn)) {
            return false;
        }
    }
    return work->drawn.count > 0 || find_first(work);
}

/* ---- columns without a bound ---- */

/* Where one of them is seen, if that is anywhere: true then, and it is in work->variables. */
static bool is_seen(work *work, const armtol_enclosure *enclosure)
{
    for (size_t k = 0; k < work->n_columns; k++) {
        work->marks[k] = isfinite(work->answer->tolerances[k]) ? 0 : 1;
    }
    measure_with(work, enclosure, work->marks, false);
    if (first_infinite(work->answer->tolerances, work->n_columns) == work->n_columns || enclose_unseen(&work->search)) {
        return false;
    }
    for (int i = 0; i < TRIES; i++) {
        if (pose_draw(&work->search, work->variables) && pose_climb(&work->search, work->variables) > 0) {
            return true;
        }
    }
    /* Drawing may not get into the region: this pose is in it. */
    memcpy(work->variables + CHAIN_DIRECTIONS, work->drawn.q, work->n_joints * sizeof *work->variables);
    return true;
}

/* ---- to the tolerances ---- */

/* An enclosure of one measure for the answer's tolerances, in work->variables its pose. */
static bool enclose_measure(work *work, armtol_enclosure *enclosure)
{
    const double accuracy = enclosure->accuracy, tightened = accuracy / (1 + TIGHTENED * work->how.gap);
    const bool asked = is_asked(work);
    const enclose_target target = {
        .gap = work->how.gap,
        .limit = asked ? accuracy : (double)INFINITY,
        .too_much = asked ? tightened * (1 + EXCEEDED * work->how.gap) : (double)INFINITY,
        .most = work->how.most,
        .progress = work->how.progress,
        .context = work->how.context,
    };
    measure_with(work, enclosure, work->answer->tolerances, true);
    const armtol_status status = enclose(&work->search, &target, work->variables, enclosure);
    if (status == ARMTOL_NO_MEMORY) {
        return out_of_memory(work);
    }
    return status == ARMTOL_OK || refuse(work, status, ARMTOL_ABOUT_QUESTION, 0, ARMTOL_REGION_NOT_FOUND);
}

static bool exceeds(const work *work, const armtol_enclosure *enclosure)
{
    const double gap = work->how.gap;
    return is_asked(work) && enclosure->low > enclosure->accuracy / (1 + TIGHTENED * gap) * (1 + EXCEEDED * gap);
}

/* Adds what a measure still lacks to the rows; `more` is set where something was. */
static bool hold_measure(work *work, size_t i, pose_list *worst, bool *more)
{
    armtol_enclosure *enclosure = &work->made->enclosures[i];
    if (is_seen(work, enclosure)) {
        if (!is_asked(work)) {
            return refuse(work, ARMTOL_UNBOUNDED, ARMTOL_ABOUT_ACCURACY, i, ARMTOL_REGION_FINE);
        }
        *more = true;
        return append_found(work, &work->rows);
    }
    if (!enclose_measure(work, enclosure)) {
        return false;
    }
    if (exceeds(work, enclosure) && enclosure->ended != ARMTOL_ENDED_CALLER) {
        *more = true;
        return append_found(work, &work->rows);
    }
    enclosure->pose = worst->count;
    return append_found(work, worst);
}

static bool ended_early(const work *work)
{
    bool ended = false;
    for (size_t i = 0; i < work->made->n_enclosures; i++) {
        ended = ended || work->made->enclosures[i].ended == ARMTOL_ENDED_CALLER;
    }
    return ended;
}

/* One round: false after a refusal; *more where there are new rows. */
static bool hold_all(work *work, pose_list *worst, bool *more)
{
    *more = false;
    worst->count = 0;
    bool fine = ask(work, work->question->tolerances, &work->answer);
    for (size_t i = 0; i < work->made->n_enclosures && fine; i++) {
        fine = hold_measure(work, i, worst, more);
    }
    return fine;
}

/* ---- what is told ---- */

static void copy_binds(const armtol_predicted *from, size_t place, size_t more, armtol_predicted *to)
{
    to->binds = from->binds;
    to->binds_pose = from->binds_pose + (from->binds_pose >= place ? more : 0);
}

/* What held the first answer, of whose places `more` new ones stand before `place` in the last; and the accuracy
   asked for. */
static void copy_held(work *work, size_t place, size_t more, armtol_answer *last)
{
    armtol_answer *first = work->answer;
    for (size_t i = 0; i < 6; i++) {
        copy_binds(&first->components[i], place, more, &last->components[i]);
        last->accuracy[i] = work->question->accuracy != NULL ? work->question->accuracy[i] : (double)INFINITY;
    }
    for (size_t i = 0; i < last->n_norms; i++) {
        copy_binds(&first->norms[i].of, place, more, &last->norms[i].of);
        last->norms[i].limit = work->question->norms[i].limit;
    }
    for (size_t i = 0; i < first->n_held; i++) {
        first->held_directions[i].pose += first->held_directions[i].pose >= place ? more : 0;
    }
    free(last->held_directions);
    last->held_directions = first->held_directions;
    last->n_held = first->n_held;
    first->held_directions = NULL;
    memcpy(last->held, first->held, work->n_columns * sizeof *last->held);
    memcpy(last->given, first->given, work->n_columns * sizeof *last->given);
}

/*
 * The answer once more, for the rows, the worst poses and those that are drawn, with the tolerances that were found;
 * what held them down is copied.
 */
static bool tell_poses(work *work, const pose_list *worst)
{
    const size_t n_rows = work->rows.count, n_loads = work->answer->n_loads;
    armtol_answer *first = work->answer, *last = NULL;
    for (size_t i = 0; i < worst->count; i++) {
        if (!append(work, &work->rows, worst->q + i * work->n_joints)) {
            return false;
        }
    }
    if (!ask(work, first->tolerances, &last)) {
        return false;
    }
    copy_held(work, n_rows * n_loads, worst->count * n_loads, last);
    for (size_t i = 0; i < work->made->n_enclosures; i++) {
        work->made->enclosures[i].pose += n_rows;
    }
    work->made->answer = last;
    return true;
}

static bool tell_joints(work *work)
{
    work->made->q = all_poses(work);
    work->made->n_worst = work->rows.count;
    work->made->n_poses = work->rows.count + work->drawn.count;
    return work->made->q != NULL;
}

/* What each parameter can be off by anywhere in the region: a drive under a load by what its moment could be too. */
static void take_reaches(work *work)
{
    for (size_t k = 0; k < work->n_columns; k++) {
        work->marks[k] = isfinite(work->answer->tolerances[k]) ? work->answer->tolerances[k] : 0;
    }
    for (size_t i = 0; i < work->loads.n_drives; i++) {
        const load_drive *drive = &work->loads.drives[i];
        const double held = fmax(work->marks[drive->column], drive->held);
        work->marks[drive->column] = held + drive->play + drive->give * drive->most;
    }
}

/*
 * The remainder of corners.c grows with the lengths of the columns and with those of their products. Here each motion
 * by an angle is as long as the arm can be and across all axes. The angular one does not depend on the pose: P E.
 */
static bool tell_remainder(work *work)
{
    const size_t n = work->n_columns;
    double *matrix = calloc(n, 6 * sizeof *matrix), found[6], before = 0, p = 0;
    if (matrix == NULL) {
        return out_of_memory(work);
    }
    take_reaches(work);
    for (size_t k = 0; k < n; k++) {
        const bool is_length = armtol_parameter_is_length(work->answer->columns[k].parameter);
        const double t = work->marks[k];
        matrix[n + k] = is_length ? 1 : work->chain.reach;
        matrix[3 * n + k] = is_length ? 0 : 1;
        p += is_length ? 0 : t * before;
        before += is_length ? 0 : t;
    }
    armtol_remainder(matrix, n, work->marks, found);
    free(matrix);
    const double c = before * (0.5 + before / 9.8); /* 9.8 < pi^2 */
    work->made->remainder[0] = found[2] + work->chain.blur;
    work->made->remainder[1] = c < 1 ? p / (1 - c) * (0.5 + c / 3) : (double)INFINITY; /* e^c <= 1 / (1 - c) */
    return true;
}

static void tell_end(armtol_region_answer *made)
{
    for (size_t i = 0; i < made->n_enclosures; i++) {
        made->ended = made->enclosures[i].ended > made->ended ? made->enclosures[i].ended : made->ended;
    }
}

/* ---- all of it ---- */

static bool hold(work *work, pose_list *worst)
{
    bool more = true;
    for (int round = 0; round < MOST_ROUNDS && more; round++) {
        if (!hold_all(work, worst, &more)) {
            return false;
        }
        more = more && !ended_early(work);
    }
    return !more || refuse(work, ARMTOL_NOT_SOLVED, ARMTOL_ABOUT_METHOD, 0, ARMTOL_REGION_FINE);
}

static void take_accuracy(work *work)
{
    const armtol_question *question = work->question;
    const double less = 1 / (1 + TIGHTENED * work->how.gap);
    for (size_t i = 0; i < 6 && question->accuracy != NULL; i++) {
        work->accuracy[i] = question->accuracy[i] * less;
    }
    for (size_t i = 0; i < question->n_norms; i++) {
        work->norms[i] = question->norms[i];
        work->norms[i].limit *= less;
    }
}

static bool start(work *work)
{
    const armtol_question *question = work->question;
    const armtol_arm *arm = question->arm;
    work->n_joints = armtol_arm_joint_count(arm);
    work->n_columns = armtol_column_count(arm->links, arm->n_links);
    work->made = calloc(1, sizeof *work->made);
    const bool made = chain_make(&work->chain, arm, &question->tool, work->region) &&
                      loads_make(&work->loads, question) && chain_take_loads(&work->chain, &work->loads) &&
                      pose_search_make(&work->search, &work->chain, work->region);
    work->variables = calloc(CHAIN_DIRECTIONS + work->n_joints, sizeof *work->variables);
    work->marks = calloc(work->n_columns + 1, sizeof *work->marks);
    take_accuracy(work);
    return (made && work->made != NULL && work->variables != NULL && work->marks != NULL) || out_of_memory(work);
}

static bool answer_region(work *work)
{
    pose_list worst = {NULL, 0};
    add_measures(work);
    const bool fine = draw_poses(work) && hold(work, &worst) && tell_remainder(work) && tell_poses(work, &worst) &&
                      tell_joints(work);
    tell_end(work->made);
    free(worst.q);
    return fine;
}

static void finish(work *work)
{
    armtol_answer_destroy(work->answer);
    pose_search_free(&work->search);
    chain_free(&work->chain);
    loads_free(&work->loads);
    free(work->variables);
    free(work->marks);
    free(work->rows.q);
    free(work->drawn.q);
}

armtol_status armtol_region_answer_create(const armtol_question *question, const armtol_region *region,
                                          const armtol_enclosing *how, armtol_region_answer **answer,
                                          armtol_fault *fault, armtol_region_fault *why)
{
    work work = {.question = question, .region = region, .refusal = region_check(question, region, how)};
    bool fine = work.refusal.fault.status == ARMTOL_OK;
    if (fine) {
        work.how = how != NULL ? *how : (armtol_enclosing){.gap = 0};
        work.how.gap = work.how.gap > 0 ? work.how.gap : USUAL_GAP;
        work.how.most = work.how.most > 0 ? work.how.most : USUAL_MOST;
        fine = start(&work) && answer_region(&work);
        finish(&work);
    }
    if (!fine) {
        armtol_region_answer_destroy(work.made);
        work.made = NULL;
    }
    *answer = work.made;
    if (fault != NULL) {
        *fault = work.refusal.fault;
    }
    if (why != NULL) {
        *why = work.refusal.why;
    }
    return work.refusal.fault.status;
}

void armtol_region_answer_destroy(armtol_region_answer *answer)
{
    if (answer != NULL) {
        armtol_answer_destroy(answer->answer);
        free(answer->q);
        free(answer);
    }
}
