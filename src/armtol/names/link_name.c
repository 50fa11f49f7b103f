#include "armtol/names/link_name.h"

#include <stdio.h>
#include <string.h>

/* A cell of a table has to hold it, with what stands beside it: so many characters, and so many bytes of UTF-8. */
enum { SHOWN = 20, DOTS = 3, SHOWN_BYTES = 45 };

const char *link_name(const armtol_arm *arm, size_t link)
{
    return arm->names != NULL ? arm->names[link] : NULL;
}

bool links_have_names(const armtol_arm *arm)
{
    bool any = false;
    for (size_t i = 0; i < arm->n_links; i++) {
        any = any || link_name(arm, i) != NULL;
    }
    return any;
}

size_t link_named(const armtol_arm *arm, const char *name)
{
    size_t link = 0;
    while (link < arm->n_links && (link_name(arm, link) == NULL || strcmp(link_name(arm, link), name) != 0)) {
        link++;
    }
    return link;
}

/* How many bytes the first characters have, `most` at the most. */
static size_t bytes_of(const char *text, size_t most)
{
    size_t n = 0, characters = 0;
    for (size_t i = 0; text[i] != '\0'; i++) {
        const bool begins = ((unsigned char)text[i] & 0xc0) != 0x80;
        if (begins && characters++ == most) {
            break;
        }
        const bool ends = ((unsigned char)text[i + 1] & 0xc0) != 0x80;
        n = ends && i < SHOWN_BYTES ? i + 1 : n;
    }
    return n;
}

/* The number and the name between three texts. */
static const char *put_together(const armtol_arm *arm, size_t link, const char *before, const char *between,
                                const char *behind, link_text *room)
{
    const char *name = link_name(arm, link);
    if (name == NULL) {
        snprintf(room->text, sizeof room->text, "%s%zu", before, link);
        return room->text;
    }
    const bool whole = bytes_of(name, SHOWN) == strlen(name);
    const size_t n = bytes_of(name, whole ? SHOWN : SHOWN - DOTS);
    snprintf(room->text, sizeof room->text, "%s%zu%s%.*s%s%s", before, link, between, (int)n, name, whole ? "" : "...",
             behind);
    return room->text;
}

const char *link_cell(const armtol_arm *arm, size_t link, link_text *room)
{
    return put_together(arm, link, "", " ", "", room);
}

const char *link_words(const armtol_arm *arm, size_t link, link_text *room)
{
    return put_together(arm, link, "link ", " (", ")", room);
}
