/*
 * Put before a copy of adpta.c with -include: look, called by getj before it writes, prints the nine words of
 * skew, the first time.
 */

#include <stdio.h>
#include <string.h>

static look(matrix)
float matrix[9];
{
	static int looked;
	unsigned int word;
	int i;

	for (i = 0; i < 9 && !looked; i++) {
		memcpy(&word, &matrix[i], sizeof word);
		printf("word %d %08x\n", i, word);
	}
	looked = 1;
}
