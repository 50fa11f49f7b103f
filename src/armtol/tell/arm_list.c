#include "armtol/tell/arm_list.h"

#include "armtol/names/link_name.h"
#include "armtol/forms/wrap.h"

#include <stdio.h>

enum { INDENT = 17 };

static void print_joints(const armtol_arm *arm)
{
    wrap wrap;
    if (!links_have_names(arm)) {
        return;
    }
    wrap_start(&wrap, stdout, INDENT, INDENT);
    wrap_say(&wrap, "joints:");
    for (size_t i = 0, left = armtol_arm_joint_count(arm); i < arm->n_links; i++) {
        if (armtol_arm_is_driven(arm, i)) {
            wrap_say(&wrap, "%s%s", link_name(arm, i) != NULL ? link_name(arm, i) : "-", --left > 0 ? "," : "");
        }
    }
    wrap_end(&wrap);
}

void arm_list_print(void)
{
    for (size_t i = 0; i < armtol_arm_count(); i++) {
        const armtol_arm *arm = armtol_arm_at(i);
        wrap wrap;
        printf("%-16s ", arm->name);
        wrap_start(&wrap, stdout, 0, INDENT);
        wrap.column = INDENT;
        wrap_say(&wrap, "%s, %zu joints, %s", arm->title, armtol_arm_joint_count(arm),
                 armtol_length_unit_name(arm->unit));
        wrap_end(&wrap);
        wrap_start(&wrap, stdout, INDENT, INDENT);
        wrap_say(&wrap, "%s", arm->source);
        wrap_end(&wrap);
        print_joints(arm);
    }
}
