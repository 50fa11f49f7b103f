/*
 * Put before a copy of a legacy program with -include: the words that getj is to find on the diagonal of its
 * skew matrix. The environment's variable of the program's name (intella, adpta) holds three, each a number
 * or, after an x, the eight digits of a word: "x3ff921f9 1 0".
 */

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static float word(index)
int index;
{
	char texts[3][32];
	unsigned int bits;
	float value;

	sscanf(getenv(PROGRAM), "%31s %31s %31s", texts[0], texts[1], texts[2]);
	if (sscanf(texts[index], "x%8x", &bits) == 1)
		memcpy(&value, &bits, sizeof value);
	else
		value = atof(texts[index]);
	return(value);
}
