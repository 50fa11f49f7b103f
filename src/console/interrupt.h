#ifndef ARMTOL_CONSOLE_INTERRUPT_H
#define ARMTOL_CONSOLE_INTERRUPT_H

#include <signal.h>
#include <stdbool.h>

/*
 * From here on a first interrupt (SIGINT, Ctrl-C) is only noted; a second one does what interrupts do by
 * default. A program that was started with interrupts ignored goes on ignoring them. *before is what
 * interrupt_restore puts back.
 */
void interrupt_watch(struct sigaction *before);
bool interrupt_came(void);
void interrupt_restore(const struct sigaction *before);

#endif
