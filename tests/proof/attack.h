/* What the suites of scenes and claims made to mislead share: blocks by their numbers, a check whose answer is verified, and a
 * verdict on forces, motions and hints that are given. All of it is static. */
#ifndef ATTACK_H
#define ATTACK_H

#include "../test.h"
#include "../scenes/gen.h"

#include <math.h>

/* ------------------------------------------------------------------------------------------------ scenes and verdicts */

static int number(sp_real x) { return x - x >= 0; }

static int numbers(const sp_real *x, int32_t n)
{
    for (int32_t k = 0; k < n; k++) if (!number(x[k])) return 0;
    return 1;
}

static void start(sp_scene *s, int32_t blocks, int32_t joints, int32_t points)
{
    const sp_capacity cap = { blocks, 0, 0, 0, joints, points, 0 };
    test_arena.used = 0;
    CHECK_INT(sp_scene_create(s, &cap, &test_arena), SP_OK);
}

static int32_t body(sp_scene *s, double mass, double x, double y, double z, unsigned held)
{
    const sp_real c[3] = { R(x), R(y), R(z) };
    int32_t id = -1;
    CHECK_INT(sp_scene_body(s, R(mass), c, held, &id), SP_OK);
    return id;
}

/* A rectangle about c with half sides p and q; its normal is p x q. */
static void quad(sp_scene *s, int32_t a, int32_t b, const double c[3], const double p[3], const double q[3], double mu)
{
    const sp_strength strength = sp_strength_friction(R(mu));
    sp_real x[12];
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 3; i++)
            x[3 * k + i] = R(c[i] + (k == 1 || k == 2 ? p[i] : -p[i]) + (k >= 2 ? q[i] : -q[i]));
    CHECK_INT(sp_scene_joint(s, a, b, 4, x, &strength, NULL), SP_OK);
}

/* A level rectangle about (x, y, z), 2 p by 2 q: b stands on a. */
static void bed(sp_scene *s, int32_t a, int32_t b, double x, double y, double z, double p, double q, double mu)
{
    const double c[3] = { x, y, z }, u[3] = { p, 0, 0 }, v[3] = { 0, q, 0 };
    quad(s, a, b, c, u, v, mu);
}

static void generated(const char *name, const char *param, double value, sp_scene *s)
{
    gen_scene g;
    test_arena.used = 0;
    CHECK_INT(gen_open(&g, name), 1);
    if (param) CHECK_INT(gen_set(&g, param, value), 1);
    CHECK_INT(gen_build(&g, &test_arena, s), SP_OK);
}

/* A claim of nothing, in the arena. */
static sp_result empty_claim(const sp_scene *s)
{
    const int32_t nf = 3 * s->count.points, nq = 6 * s->count.blocks, hint = 2 * nq;
    sp_result r;
    unsigned char *raw = (unsigned char *)&r;
    for (size_t k = 0; k < sizeof r; k++) raw[k] = 0;
    sp_real *x = (sp_real *)(void *)(test_arena.base + test_arena.used);
    test_arena.used += ((size_t)(nf + nq + hint) * sizeof *x + SP_ALIGN - 1) / SP_ALIGN * SP_ALIGN;
    for (int32_t k = 0; k < nf + nq + hint; k++) x[k] = 0;
    r.f = x;
    r.dq = x + nf;
    r.y0 = x + nf + nq;
    return r;
}

/* What a claim proves; what cannot be judged proves nothing. */
static sp_verdict judged(const sp_scene *s, const sp_result *claim, const sp_settings *settings)
{
    sp_evidence e = { SP_UNDECIDED, 0, 0, 0, SP_NONE, 0, 0 };
    const sp_status status = sp_verify(s, settings, claim, test_arena, &e);
    if (status != SP_E_NOT_FINITE) CHECK_INT(status, SP_OK);
    CHECK(number(e.imbalance) && number(e.least_imbalance));
    return e.verdict;
}

/* Check with everything a check promises: numbers only, evidence that holds with its hint, and without one unless weights are so
 * uneven that the small ones' share of the forces is lost in rounding. */
static sp_status checked(const sp_scene *s, const sp_settings *settings, sp_result *r)
{
    const sp_status status = sp_check(s, settings, &test_arena, r);
    if (status) return status;
    CHECK(numbers(r->f, 3 * s->count.points) && numbers(r->dq, 6 * s->count.blocks) && numbers(r->y0, 6 * r->counts.free_blocks));
    CHECK(number(r->imbalance) && number(r->least_imbalance) && number(r->extremes.compression) && number(r->extremes.tension) &&
          number(r->extremes.utilisation));
    for (int32_t k = 0; k < s->count.joints; k++) {
        sp_joint_force f;
        CHECK_INT(sp_joint_resultant(s, r, k, &f), SP_OK);
        CHECK(numbers(f.force, 3) && numbers(f.point, 3) && number(f.utilisation));
        CHECK(number(r->demand[k].tension) && number(r->demand[k].friction));
    }
    if (r->verdict != SP_UNDECIDED) CHECK(r->verified);
    sp_real light = 0, heavy = 0;
    for (int32_t b = 0; b < s->count.blocks; b++) {
        const sp_block *k = &s->block[b];
        if (k->fixed == SP_FIXED) continue;
        if (!(light > 0) || k->mass < light) light = k->mass;
        if (k->mass > heavy) heavy = k->mass;
    }
    const int even = heavy / TOL(R(1e8), R(1e3)) <= light;
    sp_result plain = *r;
    plain.y0 = NULL;
    CHECK_INT(judged(s, r, settings), r->verdict);
    const sp_verdict alone = judged(s, &plain, settings);
    if (even) CHECK_INT(alone, r->verdict);
    else CHECK(alone == SP_UNDECIDED || alone == r->verdict);
    return SP_OK;
}

static sp_verdict verdict(const sp_scene *s)
{
    sp_result r;
    const size_t mark = test_arena.used;
    const sp_status status = checked(s, NULL, &r);
    test_arena.used = mark;
    CHECK_INT(status, SP_OK);
    return status ? SP_UNDECIDED : r.verdict;
}

/* sure 0: may be left undecided (by the float build), never wrong. */
static int verdict_is(const sp_scene *s, sp_verdict want, int sure)
{
    const sp_verdict got = verdict(s);
    return !sure && got == SP_UNDECIDED ? 1 : CHECK_INT(got, want);
}

#endif /* ATTACK_H */
