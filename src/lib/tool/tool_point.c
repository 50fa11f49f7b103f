#include "armtol/tool_point.h"

#include "armtol/link_transform.h"

const armtol_tool_point armtol_tool_origin = {{0, 0, 0}, ARMTOL_BASE_FRAME};

void armtol_tool_frame(const armtol_link links[], size_t n_links, const armtol_tool_point *tool,
                       armtol_transform *frame)
{
    const armtol_transform last = armtol_chain_transform(links, n_links, &armtol_errata_none);
    *frame = last;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            frame->m[i][3] += last.m[i][j] * tool->offset[j];
        }
    }
}
