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

typedef struct watch {
    progress bar;
    struct sigaction before;
    armtol_draw draw; /* with somebody who looks on */
} watch;

static void begin(watch *watch, const armtol_draw *draw)
{
    watch->draw = *draw;
    watch->draw.progress = look_on;
    watch->draw.context = &watch->bar;
    progress_start(&watch->bar, "arms", draw->samples);
    interrupt_watch(&watch->before);
}

static void end(watch *watch)
{
    interrupt_restore(&watch->before);
    progress_end(&watch->bar);
}

armtol_status watched_verify(const armtol_answer *answer, const armtol_draw *draw, armtol_verification *found,
                             armtol_fault *fault)
{
    watch watch;
    begin(&watch, draw);
    const armtol_status status = armtol_verify(answer, &watch.draw, found, fault);
    end(&watch);
    return status;
}

armtol_status watched_tally_draw(const armtol_answer *answer, const armtol_draw *draw, uint64_t first,
                                 armtol_tally *tally, armtol_fault *fault)
{
    watch watch;
    begin(&watch, draw);
    const armtol_status status = armtol_tally_draw(answer, &watch.draw, first, tally, fault);
    end(&watch);
    return status;
}

armtol_status watched_tally_verify(const armtol_answer *answer, const armtol_draw *draw, const armtol_tally *tally,
                                   armtol_verification *found, armtol_fault *fault)
{
    watch watch;
    begin(&watch, draw);
    const armtol_status status = armtol_tally_verify(answer, &watch.draw, tally, found, fault);
    end(&watch);
    return status;
}

armtol_status watched_arrivals(const armtol_answer *answer, const armtol_draw *draw, size_t cycles,
                               armtol_arrivals **arrivals, armtol_fault *fault)
{
    watch watch;
    begin(&watch, draw);
    const armtol_status status = armtol_arrivals_create(answer, &watch.draw, cycles, arrivals, fault);
    end(&watch);
    return status;
}
