#ifndef ARMTOL_CONSOLE_ROUNDING_H
#define ARMTOL_CONSOLE_ROUNDING_H

/*
 * To be called first: what is computed from then on, in this thread and in those that it starts, is rounded
 * to double. The x87 and the 68881 compute in long double else, and round twice where a result is stored; on
 * all other machines this does nothing.
 */
void rounding_to_double(void);

#endif
