#include "lib/report/arithmetic.h"

double armtol_stored(const armtol_errata *errata, double value)
{
    return store(errata, value);
}
