#include "armtol/tables/arm_head.h"

#include "console/exit_code.h"
#include "console/file_message.h"
#include "console/message.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { KEY_UNITS = ARM_TEXTS, KEY_ORDER, KEYS };
static const char *const key_names[KEYS] = {
    [TEXT_NAME] = "name", [TEXT_TITLE] = "title", [TEXT_SOURCE] = "source", [KEY_UNITS] = "units",
    [KEY_ORDER] = "order"};

static const char expected_units[] = "expected a unit of length, mm, m or in, and one of angles, deg or rad";

void arm_head_start(arm_head *head)
{
    *head = (arm_head){.has_units = false};
}

void arm_head_free(arm_head *head)
{
    for (int i = 0; i < ARM_TEXTS; i++) {
        free(head->texts[i]);
    }
    arm_head_start(head);
}

/* ---- keys ---- */

/* The word that a text begins with, and what is behind it and its colon. */
typedef struct key_word {
    char *begin;
    size_t length;
    bool colon;
    char *rest;
} key_word;

static key_word word_of(char *text)
{
    key_word word = {.begin = text + strspn(text, " \t")};
    word.length = strcspn(word.begin, " \t,;:#\"");
    char *behind = word.begin + word.length + strspn(word.begin + word.length, " ");
    word.colon = word.length > 0 && *behind == ':';
    word.rest = word.colon ? behind + 1 + strspn(behind + 1, " ") : behind;
    return word;
}

static int key_of(const key_word *word)
{
    int key = 0;
    while (key < KEYS && (strncasecmp(key_names[key], word->begin, word->length) != 0 ||
                          key_names[key][word->length] != '\0')) {
        key++;
    }
    return key;
}

static file_place place_of(const text_lines *lines, const char *at)
{
    return (file_place){lines->path, lines->number, 1 + text_characters(lines->text, at)};
}

static bool is_given(const arm_head *head, int key)
{
    switch (key) {
    case KEY_UNITS:
        return head->has_units;
    case KEY_ORDER:
        return head->has_order;
    default:
        return head->texts[key] != NULL;
    }
}

static bool check_key(const arm_head *head, text_lines *lines, const key_word *word, int key)
{
    const file_place place = place_of(lines, word->begin);
    if (key == KEYS) {
        word->begin[word->length] = '\0';
        file_message(&place, "unknown key %s; expected name, title, source, units or order",
                     message_quote(word->begin, &(quoted){""}));
        return false;
    }
    if (is_given(head, key)) {
        file_message(&place, "a second \"%s\"", key_names[key]);
        return false;
    }
    return true;
}

/* ---- values ---- */

/* The row's cells from `first` on have to be one. */
static bool take_text(char **text, const cell_row *row, size_t first, const char *key)
{
    if (row->n <= first) {
        return true;
    }
    if (row->n > first + 1) {
        cells_message(row, first + 1, "a cell too many behind \"%s\"; put a text with separators in quotes", key);
        return false;
    }
    *text = strdup(row->cells[first].text);
    return enough_memory(*text != NULL);
}

typedef struct found_units {
    int lengths, angles;
} found_units;

static bool take_unit(arm_head *head, const char *word, size_t length, found_units *found)
{
    static const struct {
        const char *name;
        bool is_length;
        int value;
    } units[] = {{"mm", true, ARMTOL_MILLIMETRE}, {"m", true, ARMTOL_METRE}, {"in", true, ARMTOL_INCH},
                 {"deg", false, UNIT_DEGREE},
                 {"rad", false, UNIT_RADIAN}};
    for (size_t i = 0; i < sizeof units / sizeof units[0]; i++) {
        if (strncasecmp(units[i].name, word, length) == 0 && units[i].name[length] == '\0') {
            if (units[i].is_length) {
                head->length_unit = (armtol_length_unit)units[i].value;
                found->lengths++;
            } else {
                head->angle_unit = (angle_unit)units[i].value;
                found->angles++;
            }
            return true;
        }
    }
    return false;
}

/* The units in one cell, which may be all of them or one. */
static bool take_units_of_cell(arm_head *head, const cell_row *row, size_t index, found_units *found)
{
    static const char between[] = " \t,;";
    const cell *cell = &row->cells[index];
    const char *word = cell->text + strspn(cell->text, between);
    while (*word != '\0') {
        const size_t length = strcspn(word, between);
        if (!take_unit(head, word, length, found)) {
            const size_t column = cell->column + cell->quoted + text_characters(cell->text, word);
            const file_place place = {row->path, row->line, column};
            file_message(&place, "unknown unit %s; %s", message_quote(word, &(quoted){""}), expected_units);
            return false;
        }
        word += length;
        word += strspn(word, between);
    }
    return true;
}

static bool take_units(arm_head *head, const cell_row *row, size_t first)
{
    found_units found = {0, 0};
    for (size_t i = first; i < row->n; i++) {
        if (!take_units_of_cell(head, row, i, &found)) {
            return false;
        }
    }
    if (found.lengths != 1 || found.angles != 1) {
        cells_message(row, first, "%s, as in \"units: mm deg\"", expected_units);
        return false;
    }
    head->has_units = true;
    return true;
}

static bool set_order(arm_head *head, const cell_row *row, size_t first, const char *word)
{
    static const struct {
        const char *word;
        row_order order;
    } orders[] = {{"paul", ORDER_PAUL},   {"standard", ORDER_PAUL},  {"distal", ORDER_PAUL},
                  {"craig", ORDER_CRAIG}, {"modified", ORDER_CRAIG}, {"proximal", ORDER_CRAIG}};
    for (size_t i = 0; i < sizeof orders / sizeof orders[0]; i++) {
        if (strcasecmp(orders[i].word, word) == 0) {
            head->order = orders[i].order;
            return head->has_order = true;
        }
    }
    cells_message(row, first,
                  "unknown order %s; expected paul (standard: a row has a and alpha of its own link, often 0 in "
                  "the last row) or craig (modified: of the link before, often 0 in the first row)",
                  message_quote(word, &(quoted){""}));
    return false;
}

static bool take_order(arm_head *head, const cell_row *row, size_t first)
{
    char *word = NULL;
    const bool fine = take_text(&word, row, first, key_names[KEY_ORDER]) &&
                      set_order(head, row, first, word != NULL ? word : "");
    free(word);
    return fine;
}

static bool take_value(arm_head *head, int key, const cell_row *row, size_t first)
{
    switch (key) {
    case KEY_UNITS:
        return take_units(head, row, first);
    case KEY_ORDER:
        return take_order(head, row, first);
    default:
        return take_text(&head->texts[key], row, first, key_names[key]);
    }
}

/* A typed text, which does not begin with a separator, may have some in it; those at its end are of empty cells. */
static void drop_separators(cell_row *row)
{
    char *text = row->cells[0].text;
    size_t length = strlen(text);
    while (length > 0 && strchr(" \t,;", text[length - 1]) != NULL) {
        length--;
    }
    text[length] = '\0';
}

/* What is behind a key on its line: cells, a quoted text or a plain one. */
static bool split_rest(text_lines *lines, cell_row *row, char *rest)
{
    const bool has_cells = *rest != '\0' && strchr("\t,;", *rest) != NULL;
    if (has_cells || *rest == '"') {
        return cells_split(row, lines, rest + has_cells, has_cells ? *rest : CELLS_ANY);
    }
    const bool fine = cells_split(row, lines, rest, CELLS_WHOLE);
    if (fine && row->n > 0) {
        drop_separators(row);
    }
    return fine;
}

/* ---- lines ---- */

static bool has_key(const key_word *word)
{
    return word->length > 0 && (word->colon || key_of(word) < KEYS);
}

static head_result take(arm_head *head, text_lines *lines, cell_row *row, const key_word *word)
{
    const int key = key_of(word);
    const bool fine =
        check_key(head, lines, word, key) && split_rest(lines, row, word->rest) && take_value(head, key, row, 0);
    return fine ? HEAD_TAKEN : HEAD_WRONG;
}

/* The key is in a quoted cell: alone, or with its value. */
static head_result take_quoted(arm_head *head, text_lines *lines, cell_row *row)
{
    const key_word word = row->n > 0 ? word_of(row->cells[0].text) : (key_word){.length = 0};
    if (!has_key(&word)) {
        cells_drop_comment(row);
        return HEAD_ENDS;
    }
    if (row->n == 1) {
        return take(head, lines, row, &word);
    }
    const int key = key_of(&word);
    if (*word.rest != '\0') {
        cells_message(row, 1, "a cell too many behind \"%s\"", row->cells[0].text);
        return HEAD_WRONG;
    }
    return check_key(head, lines, &word, key) && take_value(head, key, row, 1) ? HEAD_TAKEN : HEAD_WRONG;
}

/* Whether a line is a table's head row whose first column is called as a key is: a link has a name, as the arm has. */
static bool is_head_row(const char *line)
{
    static const char *const needed[] = {"joint", "theta", "alpha"};
    static const char between[] = " \t,;\"";
    size_t n = 0, found = 0;
    for (const char *at = line + strspn(line, between); *at != '\0' && *at != '#' && *at != ':'; n++) {
        const size_t length = strcspn(at, between);
        if (n == 0 && (length != strlen("name") || strncasecmp(at, "name", length) != 0)) {
            return false;
        }
        for (size_t i = 0; i < sizeof needed / sizeof needed[0]; i++) {
            found += strncasecmp(at, needed[i], strlen(needed[i])) == 0;
        }
        at += length;
        at += strspn(at, between);
    }
    return found >= sizeof needed / sizeof needed[0];
}

static head_result take_head_row(text_lines *lines, cell_row *row)
{
    if (!cells_split(row, lines, lines->text, CELLS_ANY)) {
        return HEAD_WRONG;
    }
    cells_drop_comment(row);
    return HEAD_ENDS;
}

head_result arm_head_take(arm_head *head, text_lines *lines, cell_row *row)
{
    const key_word word = word_of(lines->text);
    if (is_head_row(lines->text)) {
        return take_head_row(lines, row);
    }
    if (has_key(&word)) {
        return take(head, lines, row, &word);
    }
    return cells_split(row, lines, lines->text, CELLS_ANY) ? take_quoted(head, lines, row) : HEAD_WRONG;
}
