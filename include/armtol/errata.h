#ifndef ARMTOL_ERRATA_H
#define ARMTOL_ERRATA_H

#include "armtol/interface.h"
#include "armtol/status.h"

#include <stdbool.h>
#include <stddef.h>

ARMTOL_INTERFACE_BEGIN

/*
 * The slips of the programs of 1987. A field that is true keeps the slip, false corrects it. Each field is
 * read in one place of the code, which carries its id; armtol_erratum_info describes it.
 */
typedef struct armtol_errata {
    bool mtransf_typo;    /* mtransf-typo */
    bool parallel_arm;    /* parallel-arm */
    bool adept_shift;     /* adept-shift */
    bool skew_residue;    /* skew-residue */
    bool root_of_ratio;   /* root-of-ratio */
    bool copied_counts;   /* copied-counts */
    bool signed_mach;     /* signed-mach */
    bool short_pi;        /* short-pi */
    bool prismatic_alpha; /* prismatic-alpha */
    bool beta_sign;       /* beta-sign */
    bool half_turns;      /* half-turns */
    bool base_twist;      /* base-twist */
    bool float_storage;   /* float */
    bool labels;          /* labels */
    bool gppp_clearing;   /* gppp-clearing */
    bool distance_share;  /* distance-share */
} armtol_errata;

extern const armtol_errata armtol_errata_1987; /* every slip kept */
extern const armtol_errata armtol_errata_none; /* every slip corrected */

typedef struct armtol_erratum_info {
    const char *id;      /* the name that `--fix` takes */
    const char *slip;    /* what the programs of 1987 do and what is right, one line */
    const char *touches; /* which results show it, one line */
    const char *changes; /* the programs whose results it can change: "intella adpta", "adpta", or "" for neither */
} armtol_erratum_info;

/* The number of errata, and the row of each: index 0 to armtol_errata_count() - 1, NULL beyond. */
size_t armtol_errata_count(void);
const armtol_erratum_info *armtol_erratum(size_t index);

/* Whether the erratum of that index is kept; false beyond the last. */
bool armtol_erratum_is_kept(const armtol_errata *errata, size_t index);

/*
 * Keep an erratum, or correct it.
 *
 * Given:
 *    id        its name; "all": every one
 *    keep      true to keep it, false to correct it
 *
 * Given and returned:
 *    *errata   as it was after an error
 *
 * Errors:
 *    ARMTOL_UNKNOWN_ERRATUM   no row has the name
 */
armtol_status armtol_erratum_keep(armtol_errata *errata, const char *id, bool keep);

/*
 * A value as a variable keeps it: rounded to float with the erratum `float`, as it is without. For the input
 * of the other routines, which the programs of 1987 kept in floats too.
 */
double armtol_stored(const armtol_errata *errata, double value);

ARMTOL_INTERFACE_END

#endif
