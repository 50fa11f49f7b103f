#include "armtol/tell/arm_list.h"

#include "armtol/arm.h"

#include <stdio.h>

void arm_list_print(void)
{
    for (size_t i = 0; i < armtol_arm_count(); i++) {
        const armtol_arm *arm = armtol_arm_at(i);
        printf("%-16s %s, %zu joints, %s\n%-16s %s\n", arm->name, arm->title,
               armtol_arm_joint_count(arm), armtol_length_unit_name(arm->unit), "", arm->source);
    }
}
