#ifndef ARMTOL_TELL_ARM_LIST_H
#define ARMTOL_TELL_ARM_LIST_H

/* What --list prints on standard output: every built-in arm, its joints and its source. */
void arm_list_print(void);

#endif
