/* What the suites of the coupled check share: its settings, questions and answers. All of it is static. */
#ifndef COUPLED_H
#define COUPLED_H

#include "../test.h"
#include "../scenes/gen.h"
#include "../scenes/change.h"

#include <math.h>

#define EPS R(1e-3)                     /* [m] */
#define ETA R(2e-2)

static void build(const char *name, const char *param, double value, sp_scene *scene)
{
    CHECK_INT(gen_make(name, param, value, &test_arena, scene), SP_OK);
}

static sp_settings coupled(void)
{
    sp_settings set = sp_settings_default();
    set.coupled.asked = set.localise = 1;
    set.coupled.eps = EPS;
    set.coupled.eta = ETA;
    return set;
}

/* ------------------------------------------------------------------------------------------------------- what is found */

static sp_settings asked(double ratio, int box)
{
    sp_settings set = sp_settings_default();
    set.coupled.asked = set.localise = 1;
    set.coupled.eps = R(1e-4);
    set.coupled.eta = R(1e-4 * ratio);
    set.coupled.box = box;
    return set;
}

/* The answer, checked: what is coupled is admissible and passes sp_verify. */
static sp_coupling answer(const sp_scene *s, const sp_settings *set, sp_result *r)
{
    sp_evidence e = { SP_UNDECIDED, 0, 0, 0, SP_NONE, 0, 0 };
    if (!CHECK_INT(sp_check(s, set, &test_arena, r), SP_OK)) return SP_COUPLING_NOT_ASKED;
    CHECK((r->level == SP_COUPLED) == (r->coupled.verdict == SP_COUPLING_COUPLED));
    if (r->coupled.verdict == SP_COUPLING_COUPLED) {
        CHECK_INT(r->verdict, SP_STABLE);
        CHECK(r->imbalance <= r->tol && r->coupled.residual <= 1);
        CHECK_INT(sp_verify(s, set, r, test_arena, &e), SP_OK);
        CHECK_INT(e.level, SP_COUPLED);
        sp_settings statics = *set;
        statics.coupled.asked = 0;
        CHECK_INT(sp_verify(s, &statics, r, test_arena, &e), SP_OK);
        CHECK(e.verdict == SP_STABLE && e.level == SP_ADMISSIBLE);          /* coupled implies admissible */
    } else CHECK(r->verdict != SP_STABLE);
    return r->coupled.verdict;
}

/* A block w wide and h high between two walls, a metre deep, in world axes turned by `turn` about z; everything `unit` times as
 * long, `heavy` times as heavy; `swap`: the block is A of its joints; `late`: it is added first. */
typedef struct squeeze { double w, h, mu, turn, unit, heavy; int swap, late; } squeeze;

static void squeezed(const squeeze *q, sp_scene *s)
{
    const sp_capacity cap = { 3, 0, 0, 0, 2, 8, 0 };
    const sp_strength strength = sp_strength_friction(R(q->mu));
    const double c = cos(q->turn), d = sin(q->turn);
    int32_t wall[2], block = 0;
    test_arena.used = 0;
    CHECK_INT(sp_scene_create(s, &cap, &test_arena), SP_OK);
    for (int k = 0; k < 3; k++) {
        const double x = (k == (q->late ? 0 : 2) ? 0 : k == 1 ? 1 : -1) * (q->w / 2 + 1) * q->unit;
        const sp_real at[3] = { R(c * x), R(d * x), 0 };
        int32_t *id = k == (q->late ? 0 : 2) ? &block : &wall[k == 1];
        CHECK_INT(sp_scene_body(s, R(1000 * q->heavy), at, id == &block ? 0 : SP_FIXED, id), SP_OK);
    }
    for (int side = 0; side < 2; side++) {
        sp_real xyz[12];
        const int back = (side == 0) == (q->swap != 0);  /* seen from B anticlockwise */
        for (int k = 0; k < 4; k++) {
            const int v = back ? 3 - k : k;
            const double x = (side ? 0.5 : -0.5) * q->w * q->unit, y = (v == 1 || v == 2 ? 0.5 : -0.5) * q->unit;
            xyz[3 * k] = R(c * x - d * y);
            xyz[3 * k + 1] = R(d * x + c * y);
            xyz[3 * k + 2] = R((v >= 2 ? 0.5 : -0.5) * q->h * q->unit);
        }
        CHECK_INT(q->swap ? sp_scene_joint(s, block, wall[side], 4, xyz, &strength, NULL)
                          : sp_scene_joint(s, wall[side], block, 4, xyz, &strength, NULL), SP_OK);
    }
}

static const squeeze plain = { 1, 0.4, 1, 0, 1, 1, 0, 0 };

#endif /* COUPLED_H */
