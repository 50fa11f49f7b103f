/* A program that loses a block of memory: what the test fault_memcheck must not pass. */

#include <stdio.h>
#include <stdlib.h>

static char *volatile kept;

int main(void)
{
    kept = malloc(100);
    const int got = kept != NULL;
    kept = NULL;
    printf("%d\n", got);
    return 0;
}
