#include "console/interrupt.h"

#include <stddef.h>

static volatile sig_atomic_t came;

static void note(int number)
{
    (void)number;
    came = 1;
}

void interrupt_watch(struct sigaction *before)
{
    struct sigaction noting = {.sa_handler = note, .sa_flags = (int)SA_RESETHAND};
    sigemptyset(&noting.sa_mask);
    came = 0;
    sigaction(SIGINT, NULL, before);
    if (before->sa_handler != SIG_IGN) {
        sigaction(SIGINT, &noting, NULL);
    }
}

bool interrupt_came(void)
{
    return came != 0;
}

void interrupt_restore(const struct sigaction *before)
{
    sigaction(SIGINT, before, NULL);
}
