#ifndef ARMTOL_LIB_REPORT_COLUMNS_H
#define ARMTOL_LIB_REPORT_COLUMNS_H

#include "armtol/link.h"
#include "armtol/status.h"
#include "lib/private_names.h"

/* The errors of armtol_links_check; ARMTOL_WRONG_SIZE where n_columns is not armtol_column_count (error_matrix.h). */
armtol_status columns_check(const armtol_link links[], size_t n_links, size_t n_columns);

#endif
