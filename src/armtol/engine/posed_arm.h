#ifndef ARMTOL_ENGINE_POSED_ARM_H
#define ARMTOL_ENGINE_POSED_ARM_H

#include "armtol/armtol.h"

#include <stdbool.h>
#include <stddef.h>

/* An arm in one or more poses, and what follows from that alone. Inside units (units.h). */
typedef struct posed_arm {
    const armtol_arm *arm;
    armtol_tool_point tool;
    size_t n_links, n_joints, n_columns, n_poses;
    double *q;              /* n_poses x n_joints */
    armtol_link *links;     /* n_poses x n_links, placed */
    armtol_column *columns; /* n_columns */
    double *matrices;       /* n_poses x 6 x n_columns: A of every pose, one below the other */
} posed_arm;

/* q is copied. False after a message (memory, numbers too large to compute with); nothing is then to be freed. */
bool posed_arm_make(posed_arm *posed, const armtol_arm *arm, const armtol_tool_point *tool, const double q[],
                    size_t n_poses);
void posed_arm_free(posed_arm *posed);

/* Of one pose: its placed links; A; and where the tool point is, in the base's coordinates. */
const armtol_link *posed_arm_links(const posed_arm *posed, size_t pose);
const double *posed_arm_matrix(const posed_arm *posed, size_t pose);
void posed_arm_tool(const posed_arm *posed, size_t pose, double point[3]);

/* Whether the column's parameter is the one that its link's joint moves. */
bool posed_arm_is_motor(const posed_arm *posed, size_t column);

#endif
