#include "armtol/urdf/urdf.h"

#include "armtol/urdf/arm.h"
#include "armtol/urdf/chain.h"
#include "armtol/urdf/parse.h"
#include "armtol/urdf/tree.h"

static bool make_arm(const urdf_tree *tree, const char *base, const char *tip, arm_model *model)
{
    urdf_chain chain;
    if (!urdf_chain_find(tree, base, tip, &chain)) {
        return false;
    }
    const bool fine = urdf_arm_make(tree, &chain, model);
    urdf_chain_free(&chain);
    return fine;
}

bool urdf_read(FILE *stream, const char *path, const char *base, const char *tip, arm_model *model)
{
    urdf_tree tree;
    *model = (arm_model){.arm = {.name = NULL}};
    urdf_tree_start(&tree, path);
    const bool fine =
        urdf_parse(stream, &tree) && urdf_tree_connect(&tree) && make_arm(&tree, base, tip, model);
    urdf_tree_free(&tree);
    return fine;
}

bool urdf_draw(FILE *stream, const char *path, const urdf_units *units, FILE *drawn)
{
    urdf_tree tree;
    urdf_tree_start(&tree, path);
    const bool fine = urdf_parse(stream, &tree) && urdf_tree_connect(&tree) && urdf_tree_draw(&tree, units, drawn);
    urdf_tree_free(&tree);
    return fine;
}

bool urdf_is_built_in(void)
{
    return true;
}
