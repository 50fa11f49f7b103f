#ifndef FUZZ_BYTES_H
#define FUZZ_BYTES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* An input that is used up piece by piece; what is not there any more is 0. */
typedef struct bytes {
    const uint8_t *at;
    size_t left;
    bool tame; /* all numbers are of an arm's size */
    bool wild; /* one came out that is not */
} bytes;

/* The first byte says whether numbers stay tame: in three inputs of four. */
bytes bytes_start(const uint8_t *data, size_t size);

/* A whole number from 0 to count - 1, of one byte. */
unsigned bytes_below(bytes *bytes, unsigned count);

/*
 * A number: mostly one that arms have (0, parts of scale), now and then a very small or large one, or any double at
 * all, which may be nan, where they need not be tame.
 */
double bytes_number(bytes *bytes, double scale);

/* The same for angles, with quarter turns and what is nearly one. */
double bytes_angle(bytes *bytes);

/* A number that tells this input from others, to draw from. */
uint64_t bytes_hash(const uint8_t *data, size_t size);

#endif
