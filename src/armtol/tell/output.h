#ifndef ARMTOL_TELL_OUTPUT_H
#define ARMTOL_TELL_OUTPUT_H

#include "armtol/tell/findings.h"
#include "armtol/forms/json.h"

#include <stdbool.h>

/* On standard output, for people, for programs, for spreadsheets. False, after a message, where memory is short. */
bool output_text(const findings *findings);
bool output_json(const findings *findings);
bool output_csv(const findings *findings);

/* The part of JSON about arms that come back. */
void json_arrivals(json *json, const findings *findings);

#endif
