#include "lib/region/boxes.h"

#include <stdlib.h>
#include <string.h>

enum { FIRST_ROOM = 256 };

void boxes_start(boxes *boxes, size_t n_variables)
{
    *boxes = (struct boxes){.n_variables = n_variables};
}

void boxes_free(boxes *boxes)
{
    for (size_t i = 0; i < boxes->room; i++) {
        free(boxes->heap[i].range);
    }
    free(boxes->heap);
}

/* Places beyond the last keep their memory for the next box. */
static bool grow(boxes *boxes)
{
    const size_t room = boxes->room > 0 ? 2 * boxes->room : FIRST_ROOM;
    open_box *heap = realloc(boxes->heap, room * sizeof *heap);
    if (heap == NULL) {
        return false;
    }
    memset(heap + boxes->room, 0, (room - boxes->room) * sizeof *heap);
    boxes->heap = heap;
    boxes->room = room;
    return true;
}

static void swap(open_box *one, open_box *other)
{
    const open_box kept = *one;
    *one = *other;
    *other = kept;
}

bool boxes_add(boxes *boxes, double bound, size_t halve, const double range[])
{
    const size_t size = 2 * boxes->n_variables * sizeof *range;
    if (boxes->count == boxes->room && !grow(boxes)) {
        return false;
    }
    size_t i = boxes->count;
    if (boxes->heap[i].range == NULL) {
        boxes->heap[i].range = malloc(size);
    }
    if (boxes->heap[i].range == NULL) {
        return false;
    }
    boxes->heap[i].bound = bound;
    boxes->heap[i].halve = halve;
    memcpy(boxes->heap[i].range, range, size);
    boxes->count++;
    for (; i > 0 && boxes->heap[(i - 1) / 2].bound < bound; i = (i - 1) / 2) {
        swap(&boxes->heap[i], &boxes->heap[(i - 1) / 2]);
    }
    return true;
}

static size_t larger_child(const boxes *boxes, size_t i)
{
    const size_t left = 2 * i + 1, right = left + 1;
    return right < boxes->count && boxes->heap[right].bound > boxes->heap[left].bound ? right : left;
}

open_box boxes_take(boxes *boxes, double range[])
{
    const open_box first = boxes->heap[0];
    memcpy(range, first.range, 2 * boxes->n_variables * sizeof *range);
    boxes->count--;
    swap(&boxes->heap[0], &boxes->heap[boxes->count]);
    for (size_t i = 0; 2 * i + 1 < boxes->count;) {
        const size_t child = larger_child(boxes, i);
        if (boxes->heap[child].bound <= boxes->heap[i].bound) {
            break;
        }
        swap(&boxes->heap[i], &boxes->heap[child]);
        i = child;
    }
    return first;
}
