#ifndef ARMTOL_NAMES_LINK_NAME_H
#define ARMTOL_NAMES_LINK_NAME_H

#include "armtol/arm.h"

#include <stdbool.h>
#include <stddef.h>

/* The names of an arm's links, which are those of their joints too, as people are shown them and as they type them. */

/* NULL where it has none. */
const char *link_name(const armtol_arm *arm, size_t link);

/* Whether any joint, or fixed link, has one. */
bool links_have_names(const armtol_arm *arm);

/* The link of that name, n_links where there is none. */
size_t link_named(const armtol_arm *arm, const char *name);

/* Room for the text of a link. */
typedef struct link_text {
    char text[96];
} link_text;

/*
 * For tables "3 elbow", and "3" where it has no name; for sentences "link 3 (elbow)" and "link 3". A name of more than
 * 20 characters ends in three dots. Returns room->text.
 */
const char *link_cell(const armtol_arm *arm, size_t link, link_text *room);
const char *link_words(const armtol_arm *arm, size_t link, link_text *room);

#endif
