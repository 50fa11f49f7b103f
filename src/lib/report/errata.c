#include "armtol/errata.h"

#include <string.h>

typedef struct row {
    armtol_erratum_info info;
    size_t field;
} row;

#define FIELD(name) offsetof(armtol_errata, name)

#define BOTH "intella adpta"
#define ADPTA "adpta"
#define NEITHER ""

/* The one table of errata, in the order of the struct's fields. */
static const row table[] = {
    {{"mtransf-typo", "the link transform has sin(theta) for cos(theta) in row 1, column 2",
      "every link with alpha != 0; all bounds of the Intelledex", BOTH},
     FIELD(mtransf_typo)},
    {{"parallel-arm", "the theta column of a parallel revolute link has d, which is 0, for the length a",
      "the angle bounds of both arms", BOTH},
     FIELD(parallel_arm)},
    {{"adept-shift", "the Adept's lengths 425 and 375 are links 2 and 3's, in Figure 5.3 too, not links 1 and 2's",
      "the Adept's angle bounds and rd[1] to rd[3]", ADPTA},
     FIELD(adept_shift)},
    {{"skew-residue", "the diagonal of a skew matrix is never set: it holds what lay on the stack, not 0",
      "the Adept's angle bounds", ADPTA},
     FIELD(skew_residue)},
    {{"root-of-ratio", "the share of a sphere of radius r over n parameters is sqrt(r/n), not r/sqrt(n)",
      "every machining and motor tolerance", BOTH},
     FIELD(root_of_ratio)},
    {{"copied-counts", "the Intelledex's 14 lengths and 18 angles serve the Adept, which has 9 and 16",
      "the Adept's machining and motor tolerances", ADPTA},
     FIELD(copied_counts)},
    {{"signed-mach", "a negative d gives a negative tolerance; magnitudes of a and d are meant",
      "the Adept's rd[4] and td[3]", ADPTA},
     FIELD(signed_mach)},
    {{"short-pi", "pi is 3.14159", "last digits, of the joint values above all", BOTH},
     FIELD(short_pi)},
    {{"prismatic-alpha", "the G of a parallel prismatic link has the angle alpha for the length a",
      "nothing published: both are 0 in the Adept", NEITHER},
     FIELD(prismatic_alpha)},
    {{"beta-sign", "the G of a parallel link is written for -beta, the link transform for +beta",
      "the sign of the beta columns; no bound while beta is 0", BOTH},
     FIELD(beta_sign)},
    {{"half-turns", "in A, not in the check, the Adept's base and tool turn by pi (Eqs 5.3, 5.4) and its tool tilts by "
                    "pi/2 (the program alone)",
      "where the tool of A is: (-200, -200) for a wish of (200, 200); and the stack residue", ADPTA},
     FIELD(half_turns)},
    {{"base-twist", "dx, dy, dz bound the motion of the body point at the base's origin, not of the tool",
      "A itself, and so all four files", BOTH},
     FIELD(base_twist)},
    {{"float", "every value is stored as a float, not a double", "last digits", BOTH},
     FIELD(float_storage)},
    {{"labels", "the tolerance file says dwx three times, not dwx, dwy, dwz", "labels of one file", BOTH},
     FIELD(labels)},
    {{"gppp-clearing", "the G of a parallel prismatic link is cleared in 3 of its 5 columns, as the scan reads",
      "nothing published: what the rest of it held was 0", NEITHER},
     FIELD(gppp_clearing)},
    {{"distance-share", "the distance bound leaves lengths delta, not all that angles leave them, as Eq. (4.31) does",
      "the distance bound, never smaller by the equation, and all distance tolerances", BOTH},
     FIELD(distance_share)},
};

#define ROWS (sizeof table / sizeof table[0])

const armtol_errata armtol_errata_1987 = {true, true, true, true, true, true, true, true,
                                          true, true, true, true, true, true, true, true};
const armtol_errata armtol_errata_none = {false};

static bool *field_of(armtol_errata *errata, size_t index)
{
    return (bool *)((char *)errata + table[index].field);
}

size_t armtol_errata_count(void)
{
    return ROWS;
}

const armtol_erratum_info *armtol_erratum(size_t index)
{
    return index < ROWS ? &table[index].info : NULL;
}

bool armtol_erratum_is_kept(const armtol_errata *errata, size_t index)
{
    armtol_errata copy = *errata;
    return index < ROWS && *field_of(&copy, index);
}

armtol_status armtol_erratum_keep(armtol_errata *errata, const char *id, bool keep)
{
    const bool all = strcmp(id, "all") == 0;
    bool found = false;
    for (size_t i = 0; i < ROWS; i++) {
        if (all || strcmp(id, table[i].info.id) == 0) {
            *field_of(errata, i) = keep;
            found = true;
        }
    }
    return found ? ARMTOL_OK : ARMTOL_UNKNOWN_ERRATUM;
}
