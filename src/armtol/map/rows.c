#include "armtol/map/rows.h"

#include "armtol/cluster/shard.h"
#include "armtol/map/fingerprint.h"
#include "console/exit_code.h"
#include "console/message.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static size_t joints_of(const map_plan *plan)
{
    return armtol_arm_joint_count(&plan->request->arm);
}

/* ---- a shard ---- */

static uint64_t known_of(const map_share *share, const map_found *found, size_t point)
{
    const unsigned char result = share->searched[point];
    return (map_is_reached(found, point) ? ROWS_REACHED : 0u) | (result == ARMTOL_MAP_FOUND ? ROWS_FOUND : 0u) |
           (result == ARMTOL_MAP_IN_VAIN ? ROWS_IN_VAIN : 0u);
}

/* Joint values that are none are nan, and values too, so that nothing is written of them. */
static void take_rows(const map_share *share, const map_found *found, const tally_rows *rows)
{
    for (size_t k = 0; k < share->count; k++) {
        const size_t point = share->first + k;
        rows->points[k] = known_of(share, found, point);
        rows->values[k] = map_is_reached(found, point) ? found->values[point] : (double)NAN;
        memcpy(rows->q + k * rows->n_joints, found->q + point * rows->n_joints, rows->n_joints * sizeof *rows->q);
    }
}

static int draw(const shard *shard)
{
    const map_plan *plan = shard->asked;
    const shard_range range = tally_head_range(shard->head);
    map_share share = {.first = (size_t)range.first * plan->n[0], .count = (size_t)range.count * plan->n[0]};
    map_found found;
    share.searched = calloc(map_plan_count(plan), sizeof *share.searched);
    const int code = enough_memory(share.searched != NULL) ? map_find(plan, &share, &found) : EXIT_FAILED;
    if (code == EXIT_OK) {
        take_rows(&share, &found, &shard->content->rows);
        map_found_free(&found);
    }
    free(share.searched);
    return code;
}

static bool check_size(const tally_head *head)
{
    if (head->n_shards > head->total) {
        message("--shard: more shards than the %" PRIu64 " rows of the map", head->total);
        return false;
    }
    if (!head->form->is_sound(head)) {
        message("--shard: %" PRIu64 " rows of %" PRIu64 " points, of %" PRIu64 " joints each, are more than %d joint "
                "values; expected fewer points", head->total, head->numbers[ROWS_POINTS], head->numbers[ROWS_JOINTS],
                ROWS_MOST_VALUES);
        return false;
    }
    return true;
}

int rows_shard(const map_plan *plan)
{
    const cli_options *options = plan->request->options;
    tally_content content = {.arms = NULL};
    tally_head head = shard_head(options, &tally_of_rows, plan->n[1]);
    head.numbers[ROWS_POINTS] = plan->n[0];
    head.numbers[ROWS_JOINTS] = joints_of(plan);
    map_fingerprints(plan, head.fingerprints);
    if (!check_size(&head)) {
        return EXIT_WRONG;
    }
    const int code = shard_run(&(shard){&head, &content, draw, plan}, options->tally);
    tally_content_free(&content);
    return code;
}

/* ---- all of them ---- */

/* Numbers that are not the plan's can only be a forged tally's: they are a part of the fingerprints. */
static bool is_of(const map_plan *plan, const merged *merged)
{
    uint64_t fingerprints[TALLY_SUBJECTS];
    const tally_head *head = &merged->head;
    map_fingerprints(plan, fingerprints);
    if (!merged_is_of(merged, fingerprints)) {
        return false;
    }
    const bool same = head->total == plan->n[1] && head->numbers[ROWS_POINTS] == plan->n[0] &&
                      head->numbers[ROWS_JOINTS] == joints_of(plan);
    if (!same) {
        message("%s: its rows are not those of its plane and its arm: the tally is damaged", merged->path);
    }
    return same;
}

static void take_searches(const tally_rows *rows, unsigned char searched[])
{
    for (size_t k = 0; k < rows->n_points; k++) {
        const uint64_t known = rows->points[k];
        searched[k] = (known & ROWS_FOUND) != 0     ? ARMTOL_MAP_FOUND
                      : (known & ROWS_IN_VAIN) != 0 ? ARMTOL_MAP_IN_VAIN
                                                    : ARMTOL_MAP_NOT_SEARCHED;
    }
}

int rows_merge(const map_plan *plan, const merged *merged, map_found *found)
{
    const tally_rows *rows = &merged->content.rows;
    if (!is_of(plan, merged)) {
        return EXIT_WRONG;
    }
    unsigned char *searched = calloc(rows->n_points, sizeof *searched);
    if (searched == NULL) {
        out_of_memory();
        return EXIT_FAILED;
    }
    take_searches(rows, searched);
    const int code = map_find(plan, &(map_share){0, rows->n_points, searched, rows}, found);
    free(searched);
    return code;
}
