/* Somebody else's program: every header by the umbrella, one routine of the library. */

#include <armtol/armtol.h>

#include <stdio.h>

int main(void)
{
    armtol_link links[8];
    armtol_intelledex_605t.links(&armtol_errata_none, links);
    printf("%s %zu\n", armtol_version(), armtol_column_count(links, 8));
    return 0;
}
