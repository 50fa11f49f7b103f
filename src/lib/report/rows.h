#ifndef ARMTOL_LIB_REPORT_ROWS_H
#define ARMTOL_LIB_REPORT_ROWS_H

#include "armtol/conventions.h"
#include "armtol/errata.h"
#include "lib/private_names.h"

/* A transform with these upper three rows, each element stored. */
armtol_transform transform_of_rows(const double rows[3][4], const armtol_errata *errata);

#endif
