#include "console/rounding.h"

#include <float.h>
#include <stdlib.h> /* whether the C library is glibc */

#if FLT_EVAL_METHOD != 0 && FLT_EVAL_METHOD != 1 && defined(__GLIBC__)
#include <fpu_control.h>
#endif

void rounding_to_double(void)
{
#if defined(_FPU_EXTENDED) && defined(_FPU_DOUBLE)
    fpu_control_t word;
    _FPU_GETCW(word);
    word &= (fpu_control_t) ~(_FPU_EXTENDED | _FPU_DOUBLE | _FPU_SINGLE);
    word |= _FPU_DOUBLE;
    _FPU_SETCW(word);
#endif
}
