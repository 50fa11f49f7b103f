// Somebody else's program in C++: every header by the umbrella, an object and two routines of the library.

#include <armtol/armtol.h>

#include <iostream>
#include <vector>

int main()
{
    std::vector<armtol_link> links(armtol_intelledex_605t.n_links);
    armtol_intelledex_605t.links(&armtol_errata_none, links.data());
    std::cout << armtol_version() << ' ' << armtol_column_count(links.data(), links.size()) << '\n';
}
