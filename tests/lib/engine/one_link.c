#include "lib/engine/one_link.h"

void one_link_make(one_link *one, uint64_t samples)
{
    *one = (one_link){
        .link = {ARMTOL_PPR, ARMTOL_REVOLUTE, .a = 400},
        .drive = armtol_drive_unknown,
        .arm = {.name = "one", .title = "one link", .source = "the test", .n_links = 1},
        .tolerances = {0.004},
        .draw = {.samples = samples, .seed = 1, .n_threads = 1},
    };
    one->arm.links = &one->link;
    one->arm.drives = &one->drive;
    one->question = (armtol_question){.arm = &one->arm, .q = one->q, .n_poses = 1, .tolerances = one->tolerances};
}
