/* The processor's square root where a compiler without optimisation would call that of the C library, which rounds otherwise. */
#include <emmintrin.h>
static inline double processor_sqrt(double x) { return _mm_cvtsd_f64(_mm_sqrt_sd(_mm_set_sd(x), _mm_set_sd(x))); }
#define SP_SQRT processor_sqrt
