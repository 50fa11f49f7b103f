#ifndef ARMTOL_LAB_UNIFORM_DRAW_H
#define ARMTOL_LAB_UNIFORM_DRAW_H

#include <stdint.h>

/*
 * Draw number `index` of a seed, uniform in [-1, 1): the same on every machine, whatever was drawn before it.
 * Source: splitmix64 (Steele, Lea, Flood 2014). Its state only counts, so that any draw can be had at once.
 */
double uniform_draw(uint64_t seed, uint64_t index);

#endif
