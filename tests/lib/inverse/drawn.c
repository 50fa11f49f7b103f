#include "inverse/drawn.h"

#include "support/reference.h"

#include <math.h>
#include <string.h>

void draw_posture(random_source *random, const armtol_arm *arm, double q[])
{
    static const double pi = 3.14159265358979323846;
    for (size_t i = 0; i < arm->n_links; i++) {
        if (armtol_arm_is_driven(arm, i)) {
            const bool slides = arm->links[i].joint == ARMTOL_PRISMATIC;
            const armtol_drive *drive = &arm->drives[i];
            *q++ = random_between(random, isfinite(drive->low) ? drive->low : slides ? 100 : -pi,
                                  isfinite(drive->high) ? drive->high : slides ? 300 : pi);
        }
    }
}

armtol_transform tool_at(const armtol_arm *arm, const double q[])
{
    armtol_link placed[MOST_LINKS];
    armtol_transform tool;
    double rows[4][4];
    armtol_arm_place(arm, q, armtol_arm_joint_count(arm), placed);
    reference_chain(placed, arm->n_links, rows);
    memcpy(tool.m, rows, sizeof rows);
    return tool;
}

double distance_between(const armtol_transform *one, const armtol_transform *other)
{
    double sum = 0;
    for (int i = 0; i < 3; i++) {
        sum += (one->m[i][3] - other->m[i][3]) * (one->m[i][3] - other->m[i][3]);
    }
    return sqrt(sum);
}

double turn_between(const armtol_transform *one, const armtol_transform *other)
{
    double most = 0;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            most = fmax(most, fabs(one->m[i][j] - other->m[i][j]));
        }
    }
    return most;
}
