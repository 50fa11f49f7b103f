/* intella: how precisely the parts of an Intelledex 605T have to be made (Hahn 1987). */

#include "program.h"

static const char *const wish_names[] = {"x", "y", "z", "gamma", "beta", "alpha"};
static const char *const wish_letters[] = {"x", "y", "z", "g", "b", "a"};

static const program intella = {
    .name = "intella",
    .robot = &armtol_intelledex_605t,
    .title = "the Intelledex 605T",
    .file_prefix = "int",
    .wish_names = wish_names,
    .wish_letters = wish_letters,
    .reach_subject = "the wrist (100 mm behind the tool point)",
    .reach_origin = "the shoulder at (0, 0, 359.7)",
    .singular_text = "the shoulder at (0, 0, 359.7) lies on the tool's axis, so that any joint 6 would do; "
                     "expected a position or direction that keeps it off that axis",
};

int main(int argc, char *argv[])
{
    return program_main(argc, argv, &intella);
}
