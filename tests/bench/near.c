/* near: the smallest distance from a limit at which both sides are told, as CSV: real,scene,tol,distance.
 *
 *     near          every scene of ../scenes/near.h at every tol; distances go down in steps of 1, 2, 5 while both verdicts are
 *                   right, to 1e-15, the end of what the limits are known to
 *     near check    instead: are the limits those that sp_limit finds at tol 1e-20, and are both sides told at 1e-12 and
 *                   tol 1e-15? For __float128. Exit status 1: no
 *
 * One file with the library, so that near.sh can make it in any precision.
 */
#ifndef SP_REAL_QUAD
#include <math.h>
#endif
#include <stdio.h>
#include <string.h>

#include "../../stonepack.c"
#include "../scenes/gen.c"
#include "../scenes/near.h"

#if defined SP_REAL_FLOAT
#define NEAR_REAL "float"
static const double tols[] = { 1e-2, 1e-3, 1e-4, 1e-5, 3e-6, 1e-6 };
#elif defined SP_REAL_QUAD
#define NEAR_REAL "quad"
static const double tols[] = { 1e-6, 1e-9, 1e-12, 1e-15, 1e-18 };
#else
#ifdef SP_REAL_MIXED
#define NEAR_REAL "mixed"
#else
#define NEAR_REAL "double"
#endif
static const double tols[] = { 1e-2, 1e-3, 1e-4, 1e-6, 1e-9, 1e-12 };
#endif

static uint64_t room[(4u << 20) / 8];

static sp_verdict verdict_at(const near_case *c, double share, double tol)
{
    sp_arena arena;
    sp_scene s;
    sp_result r;
    sp_settings set = sp_settings_default();
    set.tol = (sp_real)tol;
    set.localise = 0;
    memset(&r, 0, sizeof r);
    sp_arena_init(&arena, room, sizeof room);
    return near_build(c, share, &arena, &s) || sp_check(&s, &set, &arena, &r) ? SP_UNDECIDED : r.verdict;
}

static int both(const near_case *c, double distance, double tol)
{
    return verdict_at(c, -distance, tol) == SP_STABLE && verdict_at(c, distance, tol) == SP_UNSTABLE;
}

/* 0: not even at a half. */
static double nearest(const near_case *c, double tol)
{
    static const double step[3] = { 5, 2, 1 };
    double told = 0, decade = 0.1;
    for (int k = 0; decade > 0.9e-15; k++) {
        const double d = step[k % 3] * decade;
        if (!both(c, d, tol)) break;
        told = d;
        if (k % 3 == 2) decade /= 10;
    }
    return told;
}

/* Is the limit within what sp_limit proves of it? */
static int limit_holds(const near_case *c)
{
    sp_arena arena;
    sp_scene s;
    sp_limit_result r;
    sp_settings set = sp_settings_default();
    memset(&r, 0, sizeof r);
    set.tol = (sp_real)1e-20;
    sp_arena_init(&arena, room, sizeof room);
    if (near_build(c, 0, &arena, &s)) return 0;
    const sp_real limit = s.live, slack = limit * (sp_real)1e-16;
    if (sp_limit(&s, &set, &arena, &r)) return 0;
    return r.kind == SP_LIMIT_FOUND && r.verified && r.lower < limit + slack && r.upper > limit - slack && r.upper - r.lower < slack;
}

int main(int argc, char **argv)
{
    int bad = 0;
    const int check = argc > 1 && !strcmp(argv[1], "check");
    for (int k = 0; k < NEAR_CASES; k++) {
        const near_case *c = &near_cases[k];
        if (check) {
            const int limit = limit_holds(c), told = both(c, 1e-12, 1e-15);
            if (!limit || !told) printf("%s:%s%s\n", c->name, limit ? "" : " another limit", told ? "" : " a side not told");
            bad |= !limit || !told;
        } else for (size_t t = 0; t < sizeof tols / sizeof tols[0]; t++) {
            printf("%s,\"%s\",%.0e,%.0e\n", NEAR_REAL, c->name, tols[t], nearest(c, tols[t]));
            fflush(stdout);
        }
    }
    return bad;
}
