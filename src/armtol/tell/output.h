#ifndef ARMTOL_TELL_OUTPUT_H
#define ARMTOL_TELL_OUTPUT_H

#include "armtol/tell/findings.h"
#include "armtol/forms/json.h"

#include <stdbool.h>

/* On standard output, for people, for programs, for spreadsheets. False, after a message, where memory is short. */
bool output_text(const findings *findings);
bool output_json(const findings *findings);
bool output_csv(const findings *findings);

/* The parts of JSON about arms that come back, and about the noise of their drives. */
void json_arrivals(json *json, const findings *findings);
void json_noises(json *json, const findings *findings);

/*
 * What noise drives may have for the request's repeatability, to be freed with noises_free. False: see the fault, and
 * nothing is to be freed; after ARMTOL_NOTHING_LEFT there was a message.
 */
bool noises_find(const request *request, const armtol_answer *answer, noises *noises, armtol_fault *fault);
void noises_free(noises *noises);

#endif
