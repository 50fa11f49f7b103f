#include "console/list_room.h"

#include "console/exit_code.h"

#include <stdint.h>
#include <stdlib.h>

void *list_room(void *list, size_t count, size_t *room, size_t size)
{
    if (count < *room) {
        return list;
    }
    const size_t more = *room > 0 ? 2 * *room : 16;
    void *const moved = more <= SIZE_MAX / 2 / size ? realloc(list, more * size) : NULL;
    if (moved == NULL) {
        out_of_memory();
        return NULL;
    }
    *room = more;
    return moved;
}
