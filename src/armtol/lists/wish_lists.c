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

static bool take_wish(const cell_row *row, void *context)
{
    wish_list *list = context;
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

bool wishes_read(FILE *stream, const char *path, typed_wish **wishes, size_t *n_wishes)
{
    wish_list list = {.n = 0};
    bool fine = cells_each(stream, path, take_wish, &list);
    if (fine && list.n == 0) {
        message("%s: no positions; %s in a line for each", path, expected);
        fine = false;
    }
    if (!fine) {
        free(list.wishes);
        list = (wish_list){.n = 0};
    }
    *wishes = list.wishes;
    *n_wishes = list.n;
    return fine;
}
