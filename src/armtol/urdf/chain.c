#include "armtol/urdf/chain.h"

#include "console/exit_code.h"
#include "console/message.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- some links out of many, for messages ---- */

enum { MOST_NAMES = 8 };

typedef struct name_list {
    size_t n;
    size_t last; /* the link added last */
    char text[MOST_NAMES * (sizeof(quoted) + 2) + 32];
} name_list;

static void list_add(name_list *list, const urdf_tree *tree, size_t link)
{
    if (list->n < MOST_NAMES) {
        const size_t at = strlen(list->text);
        snprintf(list->text + at, sizeof list->text - at, "%s%s", list->n > 0 ? ", " : "",
                 message_quote(tree->links[link].name, &(quoted){""}));
    }
    list->n++;
    list->last = link;
}

static const char *list_text(name_list *list)
{
    if (list->n > MOST_NAMES) {
        const size_t at = strlen(list->text);
        snprintf(list->text + at, sizeof list->text - at, " and %zu more", list->n - MOST_NAMES);
    }
    return list->text;
}

/* ---- both ends ---- */

/* The link above, URDF_NONE above a root. */
static size_t parent_of(const urdf_tree *tree, size_t link)
{
    const size_t above = tree->links[link].above;
    return above != URDF_NONE ? tree->joints[above].parent : URDF_NONE;
}

static bool is_below(const urdf_tree *tree, size_t link, size_t base)
{
    while (link != base && link != URDF_NONE) {
        link = parent_of(tree, link);
    }
    return link == base;
}

static bool find_named(const urdf_tree *tree, const char *name, size_t *link)
{
    *link = urdf_tree_link(tree, name);
    if (*link == URDF_NONE) {
        name_list all = {0};
        for (size_t i = 0; i < tree->n_links; i++) {
            list_add(&all, tree, i);
        }
        message("%s has no link %s; it has %s", tree->path, message_quote(name, &(quoted){""}),
                list_text(&all));
    }
    return *link != URDF_NONE;
}

static bool find_root(const urdf_tree *tree, size_t *root)
{
    name_list roots = {0};
    for (size_t i = 0; i < tree->n_links; i++) {
        if (tree->links[i].above == URDF_NONE) {
            list_add(&roots, tree, i);
        }
    }
    *root = roots.last;
    if (roots.n != 1) {
        message("%s is several trees; choose the link to start from with --base: %s", tree->path,
                list_text(&roots));
    }
    return roots.n == 1;
}

static bool find_leaf(const urdf_tree *tree, size_t base, size_t *leaf)
{
    name_list leaves = {0};
    for (size_t i = 0; i < tree->n_links; i++) {
        if (tree->links[i].is_leaf && is_below(tree, i, base)) {
            list_add(&leaves, tree, i);
        }
    }
    *leaf = leaves.last;
    if (leaves.n != 1) {
        message("%s has several links at the end; choose the tool's with --tip: %s", tree->path,
                list_text(&leaves));
    }
    return leaves.n == 1;
}

static bool check_way(const urdf_tree *tree, const urdf_chain *chain)
{
    const bool fine = is_below(tree, chain->tip, chain->base);
    if (!fine) {
        message("%s: link %s is not below link %s", tree->path,
                message_quote(tree->links[chain->tip].name, &(quoted){""}),
                message_quote(tree->links[chain->base].name, &(quoted){""}));
    }
    return fine;
}

/* ---- the way between them ---- */

static bool find_joints(const urdf_tree *tree, urdf_chain *chain)
{
    chain->n_joints = 0;
    for (size_t link = chain->tip; link != chain->base; link = parent_of(tree, link)) {
        chain->n_joints++;
    }
    chain->joints = calloc(chain->n_joints + 1, sizeof *chain->joints);
    if (chain->joints == NULL) {
        out_of_memory();
        return false;
    }
    size_t link = chain->tip;
    for (size_t i = chain->n_joints; i-- > 0;) {
        chain->joints[i] = tree->links[link].above;
        link = parent_of(tree, link);
    }
    return true;
}

bool urdf_chain_find(const urdf_tree *tree, const char *base, const char *tip, urdf_chain *chain)
{
    if (tree->n_links == 0) {
        message("%s has no <link>", tree->path);
        return false;
    }
    return (base != NULL ? find_named(tree, base, &chain->base) : find_root(tree, &chain->base)) &&
           (tip != NULL ? find_named(tree, tip, &chain->tip) : find_leaf(tree, chain->base, &chain->tip)) &&
           check_way(tree, chain) && find_joints(tree, chain);
}

void urdf_chain_free(urdf_chain *chain)
{
    free(chain->joints);
}
