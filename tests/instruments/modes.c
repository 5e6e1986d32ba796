/* modes: linked into the program, sets its arithmetic before main.     MODE=up | down | zero | traps | flush */
#define _GNU_SOURCE
#include <fenv.h>
#include <stdlib.h>
#include <string.h>
#ifdef __x86_64__
#include <xmmintrin.h>
#define MODES_FLUSH() _mm_setcsr(_mm_getcsr() | 0x8040)         /* FTZ and DAZ */
#else
#define MODES_FLUSH() ((void)0)
#endif

__attribute__((constructor)) static void modes(void)
{
    const char *mode = getenv("MODE");
    if (!mode) return;
    if (!strcmp(mode, "up")) fesetround(FE_UPWARD);
    if (!strcmp(mode, "down")) fesetround(FE_DOWNWARD);
    if (!strcmp(mode, "zero")) fesetround(FE_TOWARDZERO);
    if (!strcmp(mode, "flush")) MODES_FLUSH();
#ifdef __GLIBC__
    if (!strcmp(mode, "traps")) feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
#endif
}
