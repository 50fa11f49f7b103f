/*
 * The share of reachable wishes that inverse kinematics finds: postures of every built-in arm are drawn, and where each
 * brings the tool is asked for: of FIRST wishes one branch, of ALL wishes all.
 *
 *   inverse_share FIRST ALL [ARM]
 *
 * Exit status: 1 where less than 99.9 % is found, or a branch does not lead there to 1e-9; 2 for wrong usage.
 */

#include "inverse/drawn.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

typedef struct counted {
    long wishes, found, again; /* `again`: the posture drawn is among the branches */
    double branches, starts;
    double distance, angle; /* the worst of all branches; distance as a share of the arm's size */
} counted;

/* Whether one is the other but for whole turns. */
static bool same_posture(const armtol_arm *arm, const double one[], const double other[])
{
    bool same = true;
    size_t j = 0;
    for (size_t i = 0; i < arm->n_links; i++) {
        if (armtol_arm_is_driven(arm, i)) {
            const bool slides = arm->links[i].joint == ARMTOL_PRISMATIC;
            const double apart = one[j] - other[j];
            same = same && (slides ? fabs(apart) < 0.1 : fabs(remainder(apart, 6.28318530717958647693)) < 1e-4);
            j++;
        }
    }
    return same;
}

static void count_wish(const armtol_arm *arm, armtol_inverse *inverse, random_source *random, counted *counted)
{
    armtol_branches branches;
    double q[MOST_JOINTS];
    draw_posture(random, arm, q);
    const armtol_wish wish = {tool_at(arm, q), false};
    const bool found = armtol_inverse_find(inverse, &wish, &branches) == ARMTOL_OK;
    bool again = false;
    counted->wishes++;
    counted->found += found;
    counted->branches += (double)branches.count;
    counted->starts += (double)branches.starts;
    for (size_t i = 0; i < branches.count; i++) {
        const armtol_transform tool = tool_at(arm, branches.branch[i].q);
        counted->distance = fmax(counted->distance, distance_between(&tool, &wish.tool) / armtol_inverse_size(inverse));
        counted->angle = fmax(counted->angle, turn_between(&tool, &wish.tool));
        again = again || same_posture(arm, branches.branch[i].q, q);
    }
    counted->again += again;
}

static bool count_arm(const armtol_arm *arm, long wishes, size_t enough)
{
    const armtol_inverse_setup setup = {.arm = arm, .enough = enough};
    armtol_inverse *inverse;
    random_source random = {1987};
    counted counted = {0};
    if (armtol_inverse_create(&setup, &inverse) != ARMTOL_OK) {
        return false;
    }
    const clock_t began = clock();
    for (long i = 0; i < wishes; i++) {
        count_wish(arm, inverse, &random, &counted);
    }
    const double seconds = (double)(clock() - began) / CLOCKS_PER_SEC;
    armtol_inverse_destroy(inverse);
    printf("%-15s %7ld of %7ld found, the posture drawn %7ld; %5.2f branches, %5.1f starts, %6.0f us; "
           "worst %.1e %.1e\n",
           arm->name, counted.found, counted.wishes, counted.again, counted.branches / (double)wishes,
           counted.starts / (double)wishes, seconds * 1e6 / (double)wishes, counted.distance, counted.angle);
    fflush(stdout);
    return (double)counted.found >= 0.999 * (double)wishes && counted.distance <= 1e-9 && counted.angle <= 1e-9;
}

int main(int argc, char *argv[])
{
    const long first = argc > 2 ? strtol(argv[1], NULL, 10) : 0, all = argc > 2 ? strtol(argv[2], NULL, 10) : 0;
    bool fine = true;
    size_t arms = 0;
    for (size_t i = 0; first > 0 && all > 0 && i < armtol_arm_count(); i++) {
        const armtol_arm *arm = armtol_arm_at(i);
        if (argc < 4 || strcmp(argv[3], arm->name) == 0) {
            fine = count_arm(arm, first, 1) && fine;
            fine = count_arm(arm, all, 0) && fine;
            arms++;
        }
    }
    if (arms == 0) {
        fprintf(stderr, "inverse_share: usage: inverse_share FIRST ALL [ARM]\n");
        return 2;
    }
    return fine ? 0 : 1;
}
