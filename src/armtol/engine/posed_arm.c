#include "armtol/engine/posed_arm.h"

#include "console/exit_code.h"
#include "console/message.h"

#include <stdlib.h>
#include <string.h>

static bool get_memory(posed_arm *posed)
{
    const size_t n_poses = posed->n_poses;
    posed->q = calloc(n_poses * posed->n_joints + 1, sizeof *posed->q);
    posed->links = calloc(n_poses * posed->n_links, sizeof *posed->links);
    posed->columns = calloc(posed->n_columns, sizeof *posed->columns);
    posed->matrices = calloc(n_poses * 6 * posed->n_columns, sizeof *posed->matrices);
    return posed->q != NULL && posed->links != NULL && posed->columns != NULL && posed->matrices != NULL;
}

static armtol_status place(posed_arm *posed, size_t pose)
{
    const size_t n = posed->n_columns;
    armtol_link *links = posed->links + pose * posed->n_links;
    const armtol_status status =
        armtol_links_place(posed->arm->links, posed->n_links, posed->q + pose * posed->n_joints, posed->n_joints,
                           &armtol_errata_none, links);
    if (status != ARMTOL_OK) {
        return status;
    }
    return armtol_tool_matrix(links, posed->n_links, &posed->tool, posed->matrices + pose * 6 * n, n);
}

static armtol_status place_all(posed_arm *posed)
{
    armtol_status status = armtol_columns(posed->arm->links, posed->n_links, posed->columns, posed->n_columns);
    for (size_t pose = 0; pose < posed->n_poses && status == ARMTOL_OK; pose++) {
        status = place(posed, pose);
    }
    return status;
}

bool posed_arm_make(posed_arm *posed, const armtol_arm *arm, const armtol_tool_point *tool, const double q[],
                    size_t n_poses)
{
    *posed = (posed_arm){
        .arm = arm,
        .tool = *tool,
        .n_links = arm->n_links,
        .n_joints = armtol_joint_count(arm->links, arm->n_links),
        .n_columns = armtol_column_count(arm->links, arm->n_links),
        .n_poses = n_poses,
    };
    if (!get_memory(posed)) {
        out_of_memory();
        posed_arm_free(posed);
        return false;
    }
    memcpy(posed->q, q, n_poses * posed->n_joints * sizeof *q);
    const armtol_status status = place_all(posed);
    if (status != ARMTOL_OK) {
        message("%s in these poses: %s", arm->name, armtol_status_text(status));
        posed_arm_free(posed);
    }
    return status == ARMTOL_OK;
}

void posed_arm_free(posed_arm *posed)
{
    free(posed->q);
    free(posed->links);
    free(posed->columns);
    free(posed->matrices);
    *posed = (posed_arm){.arm = NULL};
}

const armtol_link *posed_arm_links(const posed_arm *posed, size_t pose)
{
    return posed->links + pose * posed->n_links;
}

const double *posed_arm_matrix(const posed_arm *posed, size_t pose)
{
    return posed->matrices + pose * 6 * posed->n_columns;
}

void posed_arm_tool(const posed_arm *posed, size_t pose, double point[3])
{
    const armtol_transform last =
        armtol_chain_transform(posed_arm_links(posed, pose), posed->n_links, &armtol_errata_none);
    for (int i = 0; i < 3; i++) {
        point[i] = last.m[i][3];
        for (int j = 0; j < 3; j++) {
            point[i] += last.m[i][j] * posed->tool.offset[j];
        }
    }
}

bool posed_arm_is_motor(const posed_arm *posed, size_t column)
{
    const armtol_column *at = &posed->columns[column];
    const armtol_joint joint = posed->arm->links[at->link].joint;
    return (joint == ARMTOL_REVOLUTE && at->parameter == ARMTOL_THETA) ||
           (joint == ARMTOL_PRISMATIC && at->parameter == ARMTOL_D);
}
