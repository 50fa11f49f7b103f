/*
 * Put before a legacy program with -include: has it say, when it ends, what stood on the diagonal of the
 * skew matrix in each call of getj. Not of 1987. The words are only copied while the program runs; a call
 * of printf there would write over the very stack that the next getj shows.
 */

#include <stdio.h>
#include <string.h>

static float shown[16][3];
static int shown_count;

#define SHOW(matrix) \
	if (shown_count < 16) { \
		shown[shown_count][0] = matrix[0][0]; \
		shown[shown_count][1] = matrix[1][1]; \
		shown[shown_count][2] = matrix[2][2]; \
		shown_count++; \
	}

static unsigned int word_of(float *value)
{
	unsigned int word;

	memcpy(&word, value, sizeof word);
	return word;
}

__attribute__((destructor)) static void show_diagonals(void)
{
	int i;

	for (i = 0; i < shown_count; i++)
		fprintf(stderr, "\nskew diagonal of getj call %d: %g %g %g (words %08x %08x %08x)", i,
		        shown[i][0], shown[i][1], shown[i][2], word_of(&shown[i][0]), word_of(&shown[i][1]),
		        word_of(&shown[i][2]));
	fprintf(stderr, "\n");
}
