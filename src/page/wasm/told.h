#ifndef ARMTOL_PAGE_WASM_TOLD_H
#define ARMTOL_PAGE_WASM_TOLD_H

#include "armtol/forms/json.h"

/* What the page is told: one JSON object, which stays until the next one is begun. */

/* The open object, or NULL after a message where memory is short. */
json *told_begin(void);

/* Its text, "{}" where memory was short. */
const char *told_end(void);

/* An object that says in `error` why there is nothing else. */
const char *told_error(const char *why);

#endif
