#ifndef ARMTOL_DRAWING_NAMED_H
#define ARMTOL_DRAWING_NAMED_H

/*
 * Tolerances by name, as drawings have them. Each returns what the name allows, in mm or radians; nan for what is no
 * such name, *why then being as it was, and for a name that does not hold here: *why then says so, as the end of a
 * message that begins with the name in quotes.
 */

/* To either side of a length of that size in mm: IT7, js7, 2768-m. */
double named_length(const char *name, double size, const char **why);

/* To either side of an angle whose shorter side is so long, in mm; nan where nobody said: 2768-m. */
double named_angle(const char *name, double side, const char **why);

/* The width of a grade with its size in mm: 40H7. The size is in the name, and not asked for. */
double named_position(const char *name, double unused, const char **why);

#endif
