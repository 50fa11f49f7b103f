#include "armtol/ask/watched.h"

#include "console/interrupt.h"
#include "console/progress.h"

/* The time that is left is reckoned from the arms: the clock starts with the first of them. */
static bool look_on(void *context, uint64_t done, uint64_t total)
{
    progress *bar = context;
    if (done == 0) {
        progress_start(bar, "arms", total);
    } else {
        progress_show(bar, done);
    }
    return !interrupt_came();
}

armtol_status watched_verify(const armtol_answer *answer, const armtol_draw *draw, armtol_verification *found,
                             armtol_fault *fault)
{
    progress bar;
    struct sigaction before;
    armtol_draw watched = *draw;
    watched.progress = look_on;
    watched.context = &bar;
    progress_start(&bar, "arms", draw->samples);
    interrupt_watch(&before);
    const armtol_status status = armtol_verify(answer, &watched, found, fault);
    interrupt_restore(&before);
    progress_end(&bar);
    return status;
}
