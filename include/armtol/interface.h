#ifndef ARMTOL_INTERFACE_H
#define ARMTOL_INTERFACE_H

/*
 * What a header declares between ARMTOL_INTERFACE_BEGIN and ARMTOL_INTERFACE_END is C, for a C++ compiler too, and is
 * all that the shared library shows: its sources are compiled with -fvisibility=hidden.
 */
#if defined(__GNUC__) && (defined(__ELF__) || defined(__MACH__))
#define ARMTOL_SHOWN_BEGIN _Pragma("GCC visibility push(default)")
#define ARMTOL_SHOWN_END _Pragma("GCC visibility pop")
#else
#define ARMTOL_SHOWN_BEGIN
#define ARMTOL_SHOWN_END
#endif

#ifdef __cplusplus
#define ARMTOL_INTERFACE_BEGIN ARMTOL_SHOWN_BEGIN extern "C" {
#define ARMTOL_INTERFACE_END } ARMTOL_SHOWN_END
#else
#define ARMTOL_INTERFACE_BEGIN ARMTOL_SHOWN_BEGIN
#define ARMTOL_INTERFACE_END ARMTOL_SHOWN_END
#endif

#endif
