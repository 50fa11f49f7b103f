#ifndef ARMTOL_LIB_PI_H
#define ARMTOL_LIB_PI_H

/* To all digits of a double; what the report has in its place is an erratum (report/arithmetic.h). */
#define PI 3.14159265358979323846

#endif
