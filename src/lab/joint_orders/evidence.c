#include "lab/joint_orders/evidence.h"

#include "console/message.h"

#include <stdlib.h>
#include <string.h>

/* The joint of a label, theta[1] or d[4], counted from 0; -1 for any other label. */
static int joint_of(const char *label)
{
    int joint;
    char end;
    if ((sscanf(label, "theta[%d%c", &joint, &end) == 2 || sscanf(label, "d[%d%c", &joint, &end) == 2) &&
        end == ']') {
        return joint - 1;
    }
    return -1;
}

/* The wish and the joint values of the case that begins at `first`. False where one is missing. */
static bool read_case(const published_list *list, size_t first, size_t n_wish_wanted, evidence *evidence)
{
    const size_t at = evidence->n_cases * evidence->n_joints;
    size_t n_wish = 0;
    for (size_t i = first; i < list->count; i++) {
        const published_number *number = &list->numbers[i];
        if (!published_same_case(&list->numbers[first], number)) {
            break;
        }
        const int joint = number->role == ROLE_RESULT ? joint_of(number->quantity) : -1;
        if (number->role == ROLE_POSITION && n_wish < MOST_WISH) {
            evidence->wishes[evidence->n_cases][n_wish++] = stored(strtod(number->value, NULL));
        } else if (joint >= 0 && (size_t)joint < evidence->n_joints) {
            evidence->numbers[at + (size_t)joint] = number;
            evidence->printed[at + (size_t)joint] = printed_of(strtod(number->value, NULL));
        }
    }
    bool complete = n_wish == n_wish_wanted;
    for (size_t j = 0; j < evidence->n_joints; j++) {
        complete = complete && evidence->numbers[at + j] != NULL;
    }
    return complete;
}

bool evidence_find(const published_list *list, const family *family, evidence *evidence)
{
    *evidence = (struct evidence){.n_joints = family->robot->n_joints};
    for (size_t i = 0; i < list->count; i++) {
        if (!published_begins_case(list, i) || strcmp(list->numbers[i].program, family->program) != 0) {
            continue;
        }
        if (evidence->n_cases == MOST_CASES) {
            message("%s: more than %d cases", family->program, MOST_CASES);
            return false;
        }
        if (!read_case(list, i, family->robot->n_wish, evidence)) {
            message("%s, case %d: expected %zu numbers of the position and %zu joint values", family->program,
                    list->numbers[i].case_number, family->robot->n_wish, family->robot->n_joints);
            return false;
        }
        evidence->n_cases++;
    }
    if (evidence->n_cases == 0) {
        message("no case of %s among the published numbers", family->program);
    }
    return evidence->n_cases > 0;
}

size_t evidence_count(const evidence *evidence)
{
    return evidence->n_cases * evidence->n_joints;
}

unsigned long evidence_misses(const evidence *evidence, const family *family, const configuration *how,
                              double q[MOST_VALUES])
{
    unsigned long misses = 0;
    for (size_t i = 0; i < evidence->n_cases; i++) {
        family->solve(how, evidence->wishes[i], &q[i * evidence->n_joints]);
    }
    for (size_t i = 0; i < evidence_count(evidence); i++) {
        misses |= (unsigned long)!(printed_of(q[i]) == evidence->printed[i]) << i;
    }
    return misses;
}
