/* Draws more arms than anybody can wait for, on two threads; says how many it drew. */

#include "armtol/ask/watched.h"
#include "lib/engine/one_link.h"

#include <stdio.h>

int main(void)
{
    one_link one;
    armtol_answer *answer;
    armtol_verification found;
    one_link_make(&one, UINT64_MAX / 2);
    one.draw.n_threads = 2;
    if (armtol_answer_create(&one.question, &answer, NULL) != ARMTOL_OK ||
        watched_verify(answer, &one.draw, &found, NULL) != ARMTOL_OK) {
        return 1;
    }
    const double worst = found.components[5].worst_drawn;
    printf("drawn %llu, within %llu, worst %.6f, median %.6f\n", (unsigned long long)found.drawn,
           (unsigned long long)found.within, worst, found.components[5].quantiles[0]);
    armtol_answer_destroy(answer);
    return 0;
}
