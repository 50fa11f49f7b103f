#include "1987/program.h"

#include "armtol/errata.h"

#include <string.h>

static const char *const intella_names[] = {"x", "y", "z", "gamma", "beta", "alpha"};
static const char *const intella_letters[] = {"x", "y", "z", "g", "b", "a"};

const program program_intella = {
    .name = "intella",
    .robot = &armtol_intelledex_605t,
    .title = "the Intelledex 605T",
    .file_prefix = "int",
    .wish_names = intella_names,
    .wish_letters = intella_letters,
    .reach_subject = "the wrist (100 mm behind the tool point)",
    .reach_origin = "the shoulder at (0, 0, 359.7)",
    .singular_text = "the shoulder at (0, 0, 359.7) lies on the tool's axis, so that any joint 6 would do; "
                     "expected a position or direction that keeps it off that axis",
};

static const char *const adpta_names[] = {"x", "y", "z", "theta"};
static const char *const adpta_letters[] = {"x", "y", "z", "t"};

const program program_adpta = {
    .name = "adpta",
    .robot = &armtol_adept_one,
    .title = "the Adept AdeptOne",
    .file_prefix = "adpt",
    .wish_names = adpta_names,
    .wish_letters = adpta_letters,
    .reach_subject = "(x, y)",
    .reach_origin = "the axis of joint 1",
};

size_t errata_kept(const armtol_errata *errata)
{
    size_t kept = 0;
    for (size_t i = 0; i < armtol_errata_count(); i++) {
        kept += armtol_erratum_is_kept(errata, i);
    }
    return kept;
}

bool program_shows_erratum(const program *program, size_t index)
{
    return strstr(armtol_erratum(index)->changes, program->name) != NULL;
}

const program *program_named(const char *name)
{
    static const program *const programs[] = {&program_intella, &program_adpta};
    for (size_t i = 0; i < sizeof programs / sizeof programs[0]; i++) {
        if (strcmp(name, programs[i]->name) == 0) {
            return programs[i];
        }
    }
    return NULL;
}
