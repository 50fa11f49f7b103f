#include "armtol/lists/lists.h"

#include "armtol/tables/cells.h"
#include "console/list_room.h"
#include "console/message.h"

#include <stdlib.h>

enum { MOST_WISHES = 1000000 }; /* a pipe may have no end */

static const char expected[] = "expected x y z, or x y z gamma beta alpha";

/* The wishes read so far. */
typedef struct wish_list {
    size_t n, room;
    typed_wish *wishes;
} wish_list;

static bool take_wish(wish_list *list, const cell_row *row)
{
    typed_wish *wishes;
    if (list->n == MOST_WISHES) {
        cells_message(row, 0, "more than %d positions", MOST_WISHES);
        return false;
    }
    if (row->n != 3 && row->n != 6) {
        cells_message(row, row->n < 6 ? row->n : 6, "%zu value%s; %s", row->n, row->n == 1 ? "" : "s", expected);
        return false;
    }
    wishes = list_room(list->wishes, list->n, &list->room, sizeof *wishes);
    if (wishes == NULL) {
        return false;
    }
    list->wishes = wishes;
    wishes[list->n] = (typed_wish){.n = row->n};
    for (size_t i = 0; i < row->n; i++) {
        cell_number number;
        const number_fault fault = cells_number(row, i, &number);
        if (fault != NUMBER_FINE) {
            cells_message(row, i, "%s %s; %s", message_quote(row->cells[i].text, &(quoted){""}),
                          number_fault_text(fault), expected);
            return false;
        }
        wishes[list->n].value[i] = number.value;
    }
    list->n++;
    return true;
}

static bool read_all(wish_list *list, text_lines *lines, cell_row *row)
{
    line_result result;
    do {
        result = cells_next(row, lines, CELLS_ANY);
    } while (result == LINE_THERE && take_wish(list, row));
    if (result == LINE_NONE && list->n == 0) {
        message("%s: no positions; %s in a line for each", lines->path, expected);
        return false;
    }
    return result == LINE_NONE;
}

bool wishes_read(FILE *stream, const char *path, typed_wish **wishes, size_t *n_wishes)
{
    wish_list list = {.n = 0};
    text_lines lines;
    cell_row row;
    text_lines_start(&lines, stream, path);
    cells_start(&row);
    const bool fine = read_all(&list, &lines, &row);
    text_lines_free(&lines);
    cells_free(&row);
    if (!fine) {
        free(list.wishes);
        list = (wish_list){.n = 0};
    }
    *wishes = list.wishes;
    *n_wishes = list.n;
    return fine;
}
