/* adpta: how precisely the parts of an Adept AdeptOne have to be made (Hahn 1987). */

#include "program.h"

static const char *const wish_names[] = {"x", "y", "z", "theta"};
static const char *const wish_letters[] = {"x", "y", "z", "t"};

static const program adpta = {
    .name = "adpta",
    .robot = &armtol_adept_one,
    .title = "the Adept AdeptOne",
    .file_prefix = "adpt",
    .wish_names = wish_names,
    .wish_letters = wish_letters,
    .reach_subject = "(x, y)",
    .reach_origin = "the axis of joint 1",
    .singular_text = "any joint 1 would do",
};

int main(int argc, char *argv[])
{
    return program_main(argc, argv, &adpta);
}
