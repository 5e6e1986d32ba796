/* config: what of the library is built, as 0 or 1, from the switches of stonepack.h.
 *
 * A part that a switch leaves out has its whole body under one of these, with an empty body for each function that others call:
 * the same face. Inside a function they stand in expressions only, `if (SP__WITH_PLAN && ...)`, never after #if.
 */
#ifndef SP__CONFIG_C
#define SP__CONFIG_C

#include "../../stonepack.h"

#ifdef SP_QP_ONLY
#define SP__WITH_STONES 0
#else
#define SP__WITH_STONES 1
#endif
#ifdef SP_NO_QP
#define SP__WITH_QP 0
#else
#define SP__WITH_QP 1
#endif
#if defined SP_NO_QP || defined SP_QP_NO_CG
#define SP__WITH_QP_CG 0
#else
#define SP__WITH_QP_CG 1
#endif
#if defined SP_NO_QP || defined SP_QP_NO_POLISH
#define SP__WITH_QP_POLISH 0
#else
#define SP__WITH_QP_POLISH 1
#endif
#if defined SP_NO_QP || defined SP_QP_NO_INTERIOR
#define SP__WITH_QP_INTERIOR 0
#else
#define SP__WITH_QP_INTERIOR 1
#endif
#if defined SP_NO_QP || defined SP_NO_DYKSTRA
#define SP__WITH_DYKSTRA 0
#else
#define SP__WITH_DYKSTRA 1
#endif
#ifdef SP_SMALL
#define SP__WITH_SMALL 1                                /* one search, the smallest */
#else
#define SP__WITH_SMALL 0
#endif
#if defined SP_QP_ONLY || defined SP_SMALL
#define SP__WITH_LARGE 0
#else
#define SP__WITH_LARGE 1                                /* the search in all its forms, and what stands on it */
#endif
#if !SP__WITH_STONES || !SP__WITH_QP || defined SP_NO_ADMM
#define SP__WITH_ADMM 0
#else
#define SP__WITH_ADMM 1                                 /* the seed's preset; of the large build a stage, too */
#endif
#if !SP__WITH_STONES || defined SP_NO_PLAN
#define SP__WITH_PLAN 0
#else
#define SP__WITH_PLAN 1
#endif
#if SP__WITH_LARGE && SP__WITH_PLAN
#define SP__WITH_REDUCTION 1                            /* planar and level scenes in 3 rows a block */
#else
#define SP__WITH_REDUCTION 0
#endif
#if defined SP_QP_ONLY || defined SP_NO_CRA
#define SP__WITH_COUPLED 0
#else
#define SP__WITH_COUPLED 1
#endif
#if defined SP_QP_ONLY || defined SP_NO_IPM
#define SP__WITH_LIMIT 0
#else
#define SP__WITH_LIMIT 1
#endif
#if SP__WITH_LARGE && SP__WITH_LIMIT
#define SP__WITH_INTERIOR 1
#else
#define SP__WITH_INTERIOR 0
#endif
#if defined SP_QP_ONLY || defined SP_EXACT_ONLY
#define SP__WITH_SEQUENCE 0
#else
#define SP__WITH_SEQUENCE 1
#endif

#if !SP__WITH_LARGE || defined SP_NO_STRONG
#define SP__WITH_STRONG 0
#else
#define SP__WITH_STRONG 1
#endif
#if !SP__WITH_INTERIOR || defined SP_NO_SLIDING
#define SP__WITH_SLIDING 0
#else
#define SP__WITH_SLIDING 1
#endif

/* A function whose frame stays its own: merged into its only caller it would cost that caller's whole call tree its stack. */
#ifdef __GNUC__
#define SP__NOINLINE __attribute__((noinline))
#else
#define SP__NOINLINE
#endif

/* A function that the smallest build calls wherever it is used: there that is shorter. */
#ifdef SP_SMALL
#define SP__NOINLINE_SMALL SP__NOINLINE
#else
#define SP__NOINLINE_SMALL
#endif

/* Does the certificate check know pyramids and strength? For use in expressions: what they exclude is compiled and removed. */
#ifdef SP_SMALL
enum { SP__HAS_STRENGTH = 0 };
#else
enum { SP__HAS_STRENGTH = 1 };
#endif

#endif /* SP__CONFIG_C */
