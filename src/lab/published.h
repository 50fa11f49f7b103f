#ifndef ARMTOL_LAB_PUBLISHED_H
#define ARMTOL_LAB_PUBLISHED_H

#include <stdbool.h>
#include <stddef.h>

/* golden/published.tsv: the numbers that the paper prints. Its head says what the columns mean. */

typedef enum published_role { ROLE_POSITION, ROLE_TOLERANCE, ROLE_DELTA, ROLE_RESULT, ROLE_COUNT } published_role;

typedef struct published_number {
    char program[16];
    int case_number;
    published_role role;
    char quantity[64];
    char value[24];
    bool without_sign;
} published_number;

typedef struct published_list {
    published_number *numbers;
    size_t count, room;
} published_list;

/*
 * The numbers, case by case; those that the paper prints once for all cases are listed in each. False, after a message
 * that says file and line. The caller frees the list either way.
 */
bool published_read(const char *path, published_list *list);
void published_free(published_list *list);

/* Whether number i is the first of its program and case. */
bool published_begins_case(const published_list *list, size_t i);

/* Whether two numbers are of the same program and case. */
bool published_same_case(const published_number *one, const published_number *other);

#endif
