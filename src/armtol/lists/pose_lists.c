#include "armtol/lists/lists.h"

#include "armtol/tables/cells.h"
#include "console/file_message.h"
#include "console/list_room.h"
#include "console/message.h"

#include <stdlib.h>

enum { MOST_POSES = 1000000 }; /* a pipe may have no end */

/* The poses read so far. */
typedef struct pose_list {
    size_t n_joints;
    size_t n;
    size_t room; /* poses */
    double *values;
} pose_list;

static bool grow(pose_list *list)
{
    const size_t size = (list->n_joints > 0 ? list->n_joints : 1) * sizeof *list->values;
    double *values = list_room(list->values, list->n, &list->room, size);
    list->values = values != NULL ? values : list->values;
    return values != NULL;
}

static bool check_count(const cell_row *row, size_t n_joints)
{
    if (row->n != n_joints) {
        const size_t wrong = row->n < n_joints ? row->n : n_joints;
        cells_message(row, wrong, "%zu value%s; expected %zu, one for each joint", row->n, row->n == 1 ? "" : "s",
                      n_joints);
    }
    return row->n == n_joints;
}

static bool take_pose(const cell_row *row, void *context)
{
    pose_list *list = context;
    if (list->n == MOST_POSES) {
        cells_message(row, 0, "more than %d poses", MOST_POSES);
        return false;
    }
    if (!check_count(row, list->n_joints) || !grow(list)) {
        return false;
    }
    for (size_t i = 0; i < row->n; i++) {
        cell_number number;
        const number_fault fault = cells_number(row, i, &number);
        if (fault != NUMBER_FINE) {
            cells_message(row, i, "%s %s; expected the values of %zu joint%s",
                          message_quote(row->cells[i].text, &(quoted){""}), number_fault_text(fault), list->n_joints,
                          list->n_joints == 1 ? "" : "s");
            return false;
        }
        list->values[list->n * list->n_joints + i] = number.value;
    }
    list->n++;
    return true;
}

bool poses_read(FILE *stream, const char *path, size_t n_joints, double **poses, size_t *n_poses)
{
    pose_list list = {.n_joints = n_joints};
    bool fine = cells_each(stream, path, take_pose, &list);
    if (fine && list.n == 0) {
        message("%s: no poses; expected a line of %zu joint values for each", path, n_joints);
        fine = false;
    }
    if (!fine) {
        free(list.values);
        list = (pose_list){.n_joints = n_joints};
    }
    *poses = list.values;
    *n_poses = list.n;
    return fine;
}
