#ifndef ARMTOL_CONSOLE_LIST_ROOM_H
#define ARMTOL_CONSOLE_LIST_ROOM_H

#include <stddef.h>

/*
 * The list, moved where it had to be, with room for one item of that size behind its first count: *room items, twice
 * as many where it was short. NULL after a message where memory is short; list and *room are then as they were.
 */
void *list_room(void *list, size_t count, size_t *room, size_t size);

#endif
