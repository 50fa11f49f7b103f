#include "armtol/one_link.h"

verification_task one_link_task(one_link *one, uint64_t samples)
{
    static const armtol_link link[1] = {{ARMTOL_PPR, ARMTOL_REVOLUTE, .a = 400}};
    *one = (one_link){.link = link[0], .tolerances = {0.004}};
    armtol_error_matrix(link, 1, &armtol_errata_none, one->matrix, 4);
    return (verification_task){
        .poses = &one->link,
        .n_poses = 1,
        .n_links = 1,
        .matrices = one->matrix,
        .tolerances = one->tolerances,
        .n_columns = 4,
        .tool = armtol_tool_origin,
        .samples = samples,
        .seed = 1,
        .n_threads = 1,
    };
}
