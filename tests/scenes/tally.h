/* What the suites that count work to the flop share: small generated scenes, pushed and glued, and counts beside those written.
 * In double, with nothing left out, counts are the same on every machine. All of it is static. */
#ifndef TALLY_H
#define TALLY_H

#include "../test.h"
#include "gen.h"

#include <math.h>
#include <string.h>

#if defined SP_NO_PLAN || defined SP_REAL_MIXED || defined SP_REAL_QUAD || defined SP_REAL_FLOAT || defined SP_NO_IPM
#define COUNTED 0
#else
#define COUNTED 1
#endif

#if !defined SP_NO_IPM && !defined SP_SMALL && !defined SP_NO_CRA && !defined SP_NO_STRONG && !defined SP_NO_SLIDING \
 && !defined SP_NO_QP && !defined SP_NO_ADMM && !defined SP_NO_DYKSTRA && !defined SP_QP_NO_CG && !defined SP_QP_NO_POLISH \
 && !defined SP_QP_NO_INTERIOR && !defined SP_EXACT_ONLY && !defined SP_QP_ONLY
#define TALLY_ALL
#endif

/* A generated scene. live: acceleration of all its blocks / g; glue: 1 cohesion, 2 tension, 4 crushing, of 3, 1/2, 20 times the
 * weight over the area of all joints. */
typedef struct tally_scene {
    const char *name, *number; double value, mu, live[3]; int glue;
} tally_scene;

/* kind: what was answered, as each suite numbers it. bytes: the arena's, with pointers of 64 bits. found: numbers of the
 * answer. */
enum { TALLY_FOUND = 5 };
typedef struct tally {
    int kind, factorisations, iterations, interior;
    int64_t flops;
    int bytes;
    double found[TALLY_FOUND];
} tally;

/* The strength of tally_scene.glue for all joints. */
static void tally_glue(sp_scene *s, int glue)
{
    double mass = 0, area = 0;
    for (int32_t b = 0; b < s->count.blocks; b++) mass += s->block[b].fixed == SP_FIXED ? 0 : (double)s->block[b].mass;
    for (int32_t i = 0; i < s->count.joints; i++) area += (double)s->joint[i].area;
    for (int32_t i = 0; i < s->count.joints; i++) {
        sp_strength *k = &s->joint[i].strength;
        if (glue & 1) k->cohesion = R(3 * 9.80665 * mass / area);
        if (glue & 2) k->tension = R(0.5 * 9.80665 * mass / area);
        if (glue & 4) k->crushing = R(20 * 9.80665 * mass / area);
    }
}

static sp_scene tally_make(const tally_scene *t)
{
    gen_scene g;
    sp_scene s;
    test_renew();
    memset(&s, 0, sizeof s);
    if (!CHECK_INT(gen_open(&g, t->name), 1) || !CHECK_INT(gen_set(&g, t->number, t->value), 1)) return s;
    CHECK_INT(gen_set(&g, "mu", t->mu), 1);
    CHECK_INT(gen_build(&g, &test_arena, &s), SP_OK);
    for (int k = 0; k < 3; k++) s.body[k] = R(9.80665 * t->live[k]);
    tally_glue(&s, t->glue);
    return s;
}

static void tally_add(sp_cost *sum, const sp_cost *more)
{
    sum->flops += more->flops;
    sum->factorisations += more->factorisations;
    sum->iterations += more->iterations;
    sum->interior += more->interior;
}

/* |x| of n numbers. */
static double tally_size(const sp_real *x, size_t n)
{
    double sum = 0;
    for (size_t k = 0; k < n; k++) sum += (double)x[k] * (double)x[k];
    return sqrt(sum);
}

/* Is it what row k of `what` says? Of numbers found 7 digits count. */
static void tally_compare(const char *what, size_t k, const tally *written, int kind, const sp_cost *cost, size_t bytes,
                          const double found[TALLY_FOUND])
{
    int same = written->kind == kind && written->factorisations == cost->factorisations && written->flops == cost->flops
            && written->iterations == cost->iterations && written->interior == cost->interior;
    if (sizeof(void *) == 8) same = same && (size_t)written->bytes == bytes;
    for (int e = 0; e < TALLY_FOUND; e++) same = same && fabs(found[e] - written->found[e]) <= 2e-7 * fabs(found[e]) + 1e-13;
    if (!COUNTED || CHECK(same)) return;
    TEST_PRINT("    %s, row %d: { %d, %d, %d, %d, %lld, %d, { %.8g, %.8g, %.8g, %.8g, %.8g } }\n", what, (int)k, kind,
               (int)cost->factorisations, (int)cost->iterations, (int)cost->interior, (long long)cost->flops, (int)bytes,
               found[0], found[1], found[2], found[3], found[4]);
}

#endif /* TALLY_H */
