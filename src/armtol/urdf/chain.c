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
    char text[MOST_NAMES * (sizeof(quoted) + 32) + 32];
} name_list;

static void list_add(name_list *list, const urdf_tree *tree, size_t link, const char *remark)
{
    if (list->n < MOST_NAMES) {
        const size_t at = strlen(list->text);
        snprintf(list->text + at, sizeof list->text - at, "%s%s%s", list->n > 0 ? ", " : "",
                 message_quote(tree->links[link].name, &(quoted){""}), remark);
    }
    list->n++;
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
            list_add(&all, tree, i, "");
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
            list_add(&roots, tree, i, "");
            *root = i;
        }
    }
    if (roots.n != 1) {
        message("%s is several trees; choose the link to start from with --base: %s", tree->path,
                list_text(&roots));
    }
    return roots.n == 1;
}

/* ---- the tip ---- */

/* A link at the end, and how many joints move it. */
typedef struct leaf {
    size_t link;
    size_t n_moving;
} leaf;

/* The joints that move on the way up to the base. */
static size_t count_moving(const urdf_tree *tree, size_t link, size_t base)
{
    size_t count = 0;
    for (; link != base; link = parent_of(tree, link)) {
        count += urdf_joint_moves(&tree->joints[tree->links[link].above]);
    }
    return count;
}

/* The longest chain first, and links in the order of their names. */
static int compare_leaves(const void *one, const void *other)
{
    const leaf *a = one, *b = other;
    if (a->n_moving != b->n_moving) {
        return a->n_moving < b->n_moving ? 1 : -1;
    }
    return a->link < b->link ? -1 : a->link > b->link;
}

static void say_leaves(const urdf_tree *tree, const leaf leaves[], size_t n)
{
    name_list names = {0};
    for (size_t i = 0; i < n; i++) {
        char remark[32];
        snprintf(remark, sizeof remark, " (%zu joint%s)", leaves[i].n_moving, leaves[i].n_moving == 1 ? "" : "s");
        list_add(&names, tree, leaves[i].link, remark);
    }
    message("%s has several links at the end; choose the tool's with --tip: %s", tree->path, list_text(&names));
}

/*
 * What no joint moves is no tool: a camera on the base, a frame for reference. Where nothing moves any of them is as
 * good.
 */
static bool find_leaf(const urdf_tree *tree, size_t base, size_t *tip)
{
    size_t n = 0, n_moved = 0;
    leaf *leaves = calloc(tree->n_links, sizeof *leaves);
    if (leaves == NULL) {
        out_of_memory();
        return false;
    }
    for (size_t i = 0; i < tree->n_links; i++) {
        if (tree->links[i].is_leaf && is_below(tree, i, base)) {
            leaves[n] = (leaf){i, count_moving(tree, i, base)};
            n_moved += leaves[n++].n_moving > 0;
        }
    }
    qsort(leaves, n, sizeof *leaves, compare_leaves);
    *tip = leaves[0].link;
    if (n_moved > 1) {
        say_leaves(tree, leaves, n_moved);
    }
    free(leaves);
    return n_moved <= 1;
}

/* ---- the way between them ---- */

static size_t depth_of(const urdf_tree *tree, size_t link)
{
    size_t depth = 0;
    while ((link = parent_of(tree, link)) != URDF_NONE) {
        depth++;
    }
    return depth;
}

/* How many joints are above each end, up to the first link that is above both; false where there is none. */
static bool meet(const urdf_tree *tree, const urdf_chain *chain, size_t *n_up, size_t *n_down)
{
    size_t base = chain->base, tip = chain->tip;
    size_t base_depth = depth_of(tree, base), tip_depth = depth_of(tree, tip);
    *n_up = *n_down = 0;
    while (base != tip && base != URDF_NONE && tip != URDF_NONE) {
        const bool up = base_depth >= tip_depth, down = tip_depth >= base_depth;
        base = up ? parent_of(tree, base) : base;
        tip = down ? parent_of(tree, tip) : tip;
        base_depth -= up;
        tip_depth -= down;
        *n_up += up;
        *n_down += down;
    }
    if (base == URDF_NONE || tip == URDF_NONE) {
        message("%s: no joints lead from link %s to link %s; they are in different trees", tree->path,
                message_quote(tree->links[chain->base].name, &(quoted){""}),
                message_quote(tree->links[chain->tip].name, &(quoted){""}));
        return false;
    }
    return true;
}

static bool find_joints(const urdf_tree *tree, urdf_chain *chain)
{
    size_t n_down;
    if (!meet(tree, chain, &chain->n_up, &n_down)) {
        return false;
    }
    chain->n_joints = chain->n_up + n_down;
    chain->joints = calloc(chain->n_joints + 1, sizeof *chain->joints);
    if (chain->joints == NULL) {
        out_of_memory();
        return false;
    }
    size_t link = chain->base;
    for (size_t i = 0; i < chain->n_up; i++) {
        chain->joints[i] = tree->links[link].above;
        link = parent_of(tree, link);
    }
    link = chain->tip;
    for (size_t i = chain->n_joints; i-- > chain->n_up;) {
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
           find_joints(tree, chain);
}

void urdf_chain_free(urdf_chain *chain)
{
    free(chain->joints);
}
