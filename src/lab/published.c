#include "lab/published.h"

#include "console/exit_code.h"
#include "console/input_file.h"
#include "console/list_room.h"
#include "console/message.h"
#include "console/number.h"
#include "console/word.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { FIELDS = 6, ALL_CASES = -1 };

static const char *const role_names[ROLE_COUNT] = {"position", "tolerance", "delta", "result"};

/* Cut a line at its tabs; the number of fields, at most FIELDS + 1. */
static int split(char *line, char *fields[FIELDS + 1])
{
    int n = 0;
    line[strcspn(line, "\r\n")] = '\0';
    while (line != NULL && n <= FIELDS) {
        fields[n++] = line;
        line = strchr(line, '\t');
        if (line != NULL) {
            *line++ = '\0';
        }
    }
    return n;
}

static bool copy(char *to, size_t size, const char *from)
{
    const size_t length = strlen(from);
    if (length == 0 || length >= size) {
        return false;
    }
    memcpy(to, from, length + 1);
    return true;
}

/* Printed once, for all cases of all programs. */
static bool is_common(const published_number *number)
{
    return number->case_number == ALL_CASES;
}

static bool parse(char *line, published_number *number)
{
    char *fields[FIELDS + 1];
    if (split(line, fields) != FIELDS) {
        return false;
    }
    uint64_t case_number = 0;
    const bool common = strcmp(fields[1], "*") == 0, numbered = whole_number_of(fields[1], 1, 999, &case_number);
    number->case_number = common ? ALL_CASES : (int)case_number;
    number->role = (published_role)word_among(fields[2], role_names, ROLE_COUNT);
    number->without_sign = strcmp(fields[5], "unsigned") == 0;
    return copy(number->program, sizeof number->program, fields[0]) && (common || numbered) &&
           (strcmp(fields[0], "*") == 0) == common &&
           number->role < ROLE_COUNT && copy(number->quantity, sizeof number->quantity, fields[3]) &&
           copy(number->value, sizeof number->value, fields[4]);
}

static bool append(published_list *list, const published_number *number)
{
    published_number *numbers = list_room(list->numbers, list->count, &list->room, sizeof *numbers);
    if (numbers != NULL) {
        list->numbers = numbers;
        list->numbers[list->count++] = *number;
    }
    return numbers != NULL;
}

static bool read_all(FILE *stream, const char *path, published_list *list)
{
    char line[256];
    for (int at = 1; fgets(line, sizeof line, stream) != NULL; at++) {
        published_number number;
        if (line[0] == '#') {
            continue;
        }
        if (!parse(line, &number)) {
            message("%s:%d: expected program, case, role, quantity, value and remark, "
                    "a tab between each", path, at);
            return false;
        }
        if (!append(list, &number)) {
            return false;
        }
    }
    return true;
}

/* The numbers that are common to all cases, behind those of a case. */
static bool append_common(const published_list *all, const published_number *of_case, published_list *list)
{
    bool fine = true;
    for (size_t i = 0; i < all->count && fine; i++) {
        published_number number = all->numbers[i];
        if (is_common(&number)) {
            memcpy(number.program, of_case->program, sizeof number.program);
            number.case_number = of_case->case_number;
            fine = append(list, &number);
        }
    }
    return fine;
}

/* Put the common numbers into each case in place of where they stand. */
static bool spread_common(published_list *list)
{
    published_list spread = {.numbers = NULL};
    bool fine = true;
    for (size_t i = 0; i < list->count && fine; i++) {
        const published_number *number = &list->numbers[i];
        if (!is_common(number)) {
            const bool last = i + 1 == list->count || published_begins_case(list, i + 1);
            fine = append(&spread, number) && (!last || append_common(list, number, &spread));
        }
    }
    published_free(list);
    *list = spread;
    return fine;
}

bool published_read(const char *path, published_list *list)
{
    *list = (published_list){.numbers = NULL};
    FILE *stream = input_file_open("", path, "");
    if (stream == NULL) {
        return false;
    }
    errno = 0;
    bool fine = read_all(stream, path, list);
    if (fine && ferror(stream)) {
        exit_code_note_error(errno);
        message("%s: cannot be read", path);
        fine = false;
    }
    fclose(stream);
    fine = fine && spread_common(list);
    if (fine && list->count == 0) {
        message("%s: holds no numbers", path);
        fine = false;
    }
    return fine;
}

void published_free(published_list *list)
{
    free(list->numbers);
    *list = (published_list){.numbers = NULL};
}

bool published_same_case(const published_number *one, const published_number *other)
{
    return one->case_number == other->case_number && strcmp(one->program, other->program) == 0;
}

bool published_begins_case(const published_list *list, size_t i)
{
    return i == 0 || !published_same_case(&list->numbers[i - 1], &list->numbers[i]);
}
