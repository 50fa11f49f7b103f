/* Draws more arms than anybody can wait for, on two threads; says how many it drew. */

#include "armtol/one_link.h"
#include "console/message.h"

#include <stdio.h>

int main(void)
{
    one_link one;
    verification found;
    verification_task task = one_link_task(&one, UINT64_MAX / 2);
    task.n_threads = 2;
    message_start("endless");
    if (!verification_run(&task, &found)) {
        return 1;
    }
    const double worst = found.components[5].worst_drawn;
    printf("drawn %llu, within %llu, worst %.6f, median %.6f\n", (unsigned long long)found.drawn,
           (unsigned long long)found.within, worst, found.components[5].quantiles[0]);
    return 0;
}
