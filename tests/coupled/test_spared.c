/* What a coupled check is spared: the search of a forest, the third dimension, friction. */
#include "../scenes/planned.h"

#ifndef SP_NO_CRA
/* A tree of square slabs on a support: slab k rests on slab (k - 1) / 2, two side by side, each a little askew; gravity leans. halves:
 * every joint is two, the second from its other side. */
static void tree(int32_t n, double lean, int halves, sp_scene *s)
{
    const sp_strength strength = sp_strength_friction(R(0.6));
    double x[16] = { 0 }, z[16] = { 0 }, half[16] = { 2 };
    const sp_real ground[3] = { 0, 0, R(-1) };
    test_arena.used = 0;
    *s = room(n + 1, 2 * n, 8 * n);
    CHECK_INT(sp_scene_body(s, 0, ground, SP_FIXED, NULL), SP_OK);
    for (int32_t k = 0; k < n; k++) {
        const int32_t on = k ? (k - 1) / 2 : 0;
        if (k) {
            half[k] = 0.45 * half[on];
            x[k] = x[on] + (k % 2 ? -0.5 : 0.5) * half[on] * 1.02;
            z[k] = z[on] + 0.3;
        }
        const double c = 1.1 * half[k] / 2, y = (double)test_random_real(-0.05, 0.05), l = -y, d = half[k] / 2;
        const sp_real at[3] = { R(x[k] + y), R(y), R(z[k] + 0.15) };
        const sp_real corner[12] = { R(x[k] - d), R(-c), R(z[k]), R(x[k] + d), R(l - c), R(z[k]), R(x[k] + d), R(c), R(z[k]),
                                     R(x[k] - d), R(l + c), R(z[k]) };
        CHECK_INT(sp_scene_body(s, R(100 * half[k]), at, 0, NULL), SP_OK);
        for (int part = 0; part < 1 + halves; part++) {         /* corners 0, 1 below, 2, 3 above: cut across the middle */
            sp_real xyz[12];
            for (int v = 0; v < 4; v++)
                for (int i = 0; i < 3; i++) {
                    const int q = part ? 3 - v : v, cut = halves && (part ? q < 2 : q > 1);
                    xyz[3 * v + i] = cut ? (corner[3 * q + i] + corner[3 * (3 - q) + i]) / 2 : corner[3 * q + i];
                }
            const int32_t below = k ? on + 1 : 0;
            CHECK_INT(sp_scene_joint(s, part ? k + 1 : below, part ? below : k + 1, 4, xyz, &strength, NULL), SP_OK);
        }
    }
    s->gravity[0] = R(9.8 * lean);
}

/* The coupled check with and without its search. Without: fewer iterations than 300 leave nothing out. */
static sp_result with_search(const sp_scene *s, sp_settings set, sp_arena *a)
{
    set.iterations = 299;
    return check(s, &set, a);
}

static void agree_coupled(const sp_scene *s, const sp_settings *set, int *told)
{
    sp_arena a = test_arena;
    const sp_result r = check(s, set, &a), all = with_search(s, *set, &a);
    sp_evidence e;
    *told += r.effect[SP_EFFECT_COUPLED] == SP_WHY_FOREST;
    CHECK_INT(all.effect[SP_EFFECT_COUPLED] == SP_WHY_FOREST, all.coupled.verdict == SP_COUPLING_COUPLED && !all.coupled.rounds);
    if (r.verdict && all.verdict) CHECK_INT(r.verdict, all.verdict);
    if (all.verdict) CHECK(r.verdict);
    if (r.level != SP_COUPLED) return;
    CHECK_INT(sp_verify(s, set, &r, a, &e), SP_OK);
    CHECK_INT(e.level, SP_COUPLED);
    CHECK(e.residual <= 1);
}

TEST(what_hangs_on_its_supports_as_a_forest_is_coupled_without_a_search)
{
    static const double ratio[] = { TOL(1e-2, 1e-1), 1, 100, 1e6 };
    int told = 0;
    for (int k = 0; k < 24; k++) {
        sp_settings set = sp_settings_default();
        sp_scene s;
        set.coupled.asked = 1;
        set.coupled.eps = k % 5 == 4 ? 0 : R(1e-4);
        set.coupled.eta = R(1e-4 * ratio[k % 4]);
        set.coupled.box = k % 3 == 1;
        set.faces = k % 6 == 5 ? 8 : 0;
        tree(1 + k % 15, k % 2 ? 0 : 0.05, k % 7 > 3, &s);
        int here = 0;
        agree_coupled(&s, &set, &here);
        CHECK_INT(here, 1);
        told += here;
    }
    CHECK_INT(told, 24);
    sp_settings set = sp_settings_default();
    set.coupled.asked = 1;
    test_arena.used = 0;
    const sp_scene s = part("tower", "n", 10, -1);
    sp_arena a = test_arena;
    const sp_result r = check(&s, &set, &a), all = with_search(&s, set, &a);
    CHECK_INT(r.level, SP_COUPLED);
    CHECK(5 * r.coupled.cost.flops < all.coupled.cost.flops && r.coupled.cost.factorisations == 0);
    sp_outlook o;
    CHECK_INT(sp_plan(&s, &set, test_arena, &o), SP_OK);
    CHECK_INT(o.effect[SP_EFFECT_COUPLED].why, SP_WHY_FOREST);
    CHECK(o.effect[SP_EFFECT_COUPLED].flops > 0 && o.flops + o.effect[SP_EFFECT_COUPLED].flops <= o.full_flops);
}

/* A couple about the upright on three corners, whose pressure is given: friction holds 0.445 mu W m, and spread as the pressure
 * 0.275 mu W m, where the far corner is at the rim of its cone. In between only the search finds a motion. */
TEST(a_twisted_slab_is_searched_where_friction_spread_as_pressure_does_not_do)
{
    static const struct { double twist; int told; sp_verdict verdict; } ask[] = {
        { 0, 1, SP_STABLE }, { 0.27, 1, SP_STABLE }, { 0.3, 0, SP_STABLE }, { 0.43, 0, SP_STABLE }, { 0.46, 0, SP_UNSTABLE } };
    const sp_real ground[3] = { 0, 0, R(-1) }, at[3] = { 0, 0, R(0.2) };
    const sp_real corner[9] = { 0, 1, 0, R(-0.3), R(-0.2), 0, R(0.3), R(-0.2), 0 };
    const sp_strength strength = sp_strength_friction(R(0.5));
    for (int k = 0; k < 5; k++) {
        const sp_load load = { 1, 0, { at[0], at[1], at[2] }, { 0, 0, 0 }, { 0, 0, R(ask[k].twist * 0.5 * 100 * 9.80665) }, 0 };
        sp_settings set = sp_settings_default();
        int told = 0;
        set.coupled.asked = 1;
        test_arena.used = 0;
        sp_scene s = room(2, 1, 3);
        CHECK_INT(sp_scene_body(&s, 0, ground, SP_FIXED, NULL), SP_OK);
        CHECK_INT(sp_scene_body(&s, 100, at, 0, NULL), SP_OK);
        CHECK_INT(sp_scene_joint(&s, 0, 1, 3, corner, &strength, NULL), SP_OK);
        CHECK_INT(sp_scene_load(&s, &load, NULL), SP_OK);
        agree_coupled(&s, &set, &told);
        CHECK_INT(told, ask[k].told);
        sp_arena a = test_arena;
        CHECK_INT(check(&s, &set, &a).verdict, ask[k].verdict);
    }
}

TEST(a_coupled_check_agrees_with_its_search_on_random_scenes)
{
    static const struct { const char *name, *param; double low, high; } kind[] = {
        { "tower", "lean", 0.02, 0.12 }, { "incline", "angle", -45, 45 }, { "overhang", "factor", 0.7, 1.1 }, { "topple", "angle", -20, 20 },
        { "cantilever", "reach", 0.8, 1.5 }, { "incline", "turn", -90, 90 }, { "keystone", "angle", -30, 30 }, { "arch", "t", 0.09, 0.2 }
    };
    int told = 0;
    for (int k = 0; k < 64; k += SOME_OF(1, 3)) {
        sp_settings set = sp_settings_default();
        set.coupled.asked = 1;
        set.coupled.nodes = 0;
        set.coupled.box = k / 8 % 2;
        set.faces = k / 16 % 2 ? 8 : 0;
        test_arena.used = 0;
        const double value = (double)test_random_real(kind[k % 8].low, kind[k % 8].high);
        const sp_scene s = part(kind[k % 8].name, kind[k % 8].param, value, k / 8 % 3 ? -1 : (double)test_random_real(0.1, 0.9));
        agree_coupled(&s, &set, &told);
    }
    CHECK(told > SOME_OF(20, 6));
}

/* Rings with a mirror: the motion found in the plane is judged in space, and what is not found there is decided in space. */
TEST(a_motion_is_looked_for_in_the_plane_first_and_what_is_not_there_is_decided_in_space)
{
    static const struct { const char *name, *param; double low, high; } kind[] = {
        { "arch", "t", 0.11, 0.2 }, { "keystone", "angle", -30, 30 }, { "h-model", NULL, 0, 0 }, { "wall", "rows", 2, 5 },
        { "diamond", "rows", 2, 4 }
    };
    int plane = 0, refuted = 0, told = 0;
    int64_t flops = 0, most = 0;
    for (int k = 0; k < 60; k += SOME_OF(1, 3)) {        /* by threes still every kind in every cone */
        sp_settings set = sp_settings_default();
        set.localise = 0;
        set.coupled.asked = 1;
        set.coupled.box = k / 5 % 2;
        set.faces = k / 10 % 2 ? 8 : 0;
        set.inscribed = k / 20 % 2;
        test_arena.used = 0;
        const double value = (double)test_random_real(kind[k % 5].low, kind[k % 5].high);
        const double mu = (double)test_random_real(0.4, 1.3);
        const sp_scene s = part(kind[k % 5].name, kind[k % 5].param, k % 5 < 3 ? value : (int)value, mu);
        if (k % 5 != 2 && s.count.points <= SP_EXACT_POINTS) set.coupled.nodes = 200;
        agree_coupled(&s, &set, &told);
        sp_arena a = test_arena;
        const sp_result r = check(&s, &set, &a), all = with_search(&s, set, &a);
        const int lies = r.effect[SP_EFFECT_DEPTH] == SP_WHY_MIRROR;
        refuted += r.coupled.reason == SP_COUPLING_NO_MOTION;
        if (r.coupled.reason == SP_COUPLING_STATICS) continue;
        CHECK_INT(lies, r.level == SP_COUPLED);
        if (!lies) continue;
        plane++;
        flops += r.coupled.cost.flops;
        most += all.coupled.cost.flops;
    }
    CHECK_INT(told, 0);
    if (TELLS) CHECK(plane > SOME_OF(25, 8) && refuted > SOME_OF(3, 0) && 2 * flops < most);
}

/* Its tree does not hang on the rounding of the search before it, so any number of nodes is enough for both or for none. */
TEST(a_coupled_check_is_decided_by_one_tree_in_the_plane_and_in_space)
{
    int decided = 0;
    for (int k = 0; k < 20; k += SOME_OF(1, 3)) {
        sp_settings set = sp_settings_default();
        set.localise = 0;
        set.coupled.asked = 1;
        test_arena.used = 0;
        const sp_scene s = part("keystone", "angle", 25 + k, 0.03 * k + 0.5);
        sp_arena a = test_arena;
        const sp_result r = check(&s, &set, &a), all = with_search(&s, set, &a);
#ifdef SP_REAL_FLOAT                    /* its scales keep what the search before rounded: one may be left open */
        CHECK(r.verdict == all.verdict || !r.verdict || !all.verdict);
#else
        CHECK_INT(r.verdict, all.verdict);
        CHECK_INT(r.coupled.proof.nodes, all.coupled.proof.nodes);
        CHECK_INT(r.coupled.proof.entries, all.coupled.proof.entries);
#endif
        decided += r.coupled.proof.nodes > 0;
    }
    if (TOL(1, 0)) CHECK(decided > SOME_OF(5, 1));                   /* float refutes none of them */
}

/* Without the third dimension what the plane does not explain stays open: the H model has no motion there. */
TEST(without_the_third_dimension_a_motion_is_found_or_nothing_is_said)
{
    for (int k = 0; k < 2; k++) {
        sp_settings set = sp_settings_default();
        set.coupled.asked = 1;
        set.effect[SP_EFFECT_DEPTH] = SP_WITHOUT;
        test_arena.used = 0;
        const sp_scene s = k ? part("h-model", NULL, 0, 0.84) : part("wall", "rows", 3, -1);
        sp_arena a = test_arena;
        const sp_result r = check(&s, &set, &a);
        CHECK_INT(r.verdict, k ? SP_UNDECIDED : SP_STABLE);
        CHECK_INT(r.coupled.verdict, k ? SP_COUPLING_NOT_FOUND : SP_COUPLING_COUPLED);
        CHECK_INT(r.reason, k ? SP_REASON_EFFECT : SP_REASON_FORCES);
        if (k) CHECK_INT(r.missing, SP_EFFECT_DEPTH);
    }
}

/* mu = 0, rings or not: the least sum of fn and its multipliers tell either way what a search leaves open. */
TEST(without_friction_a_coupled_check_is_decided_by_one_linear_programme)
{
    int told = 0, refuted = 0;
    for (int k = 0; k < 100; k++) {
        sp_settings set = sp_settings_default(), own;
        sp_scene s;
        test_arena.used = 0;
        if (k % 3) NEED(kinds_make(14 + KINDS * k, &test_arena, &s, &own) == SP_OK);
        else s = part("keystone", "angle", 0.3 * k - 35, 0);
        if (s.count.points > SP_EXACT_POINTS) continue;
        for (int32_t q = 0; q < s.count.joints; q++) s.joint[q].strength.mu = 0;
        set.localise = 0;
        set.coupled.asked = 1;
        set.coupled.box = k % 4 == 1;
        set.coupled.eta = k % 5 > 2 ? R(k % 5 == 4 ? 2e-4 : 3e-6) : 0;
        set.coupled.eps = k % 5 > 2 ? R(1e-4) : -1;
        sp_arena a = test_arena;
        const sp_result r = check(&s, &set, &a), all = with_search(&s, set, &a);
        CHECK_INT(r.verdict, all.verdict);
        if (sizeof(sp_real) == 8) CHECK(r.verdict != SP_UNDECIDED);
        refuted += r.coupled.reason == SP_COUPLING_NO_MOTION;
        told += r.level == SP_COUPLED;
        if (r.level == SP_COUPLED) for (int32_t v = 0; v < s.count.points; v++) CHECK(r.coupled.alpha[v] <= 0);
    }
    if (TELLS) CHECK(told > 20 && refuted > 8);
}

/* Rings are no forests: their answers are the search's, whatever they are. */
TEST(a_ring_is_never_told_without_a_search)
{
    static const struct { const char *name, *param; double value; } scene[] = {
        { "h-model", NULL, 0 }, { "keystone", "angle", 20 }, { "keystone", "angle", -20 }, { "arch", "n", 6 }, { "wall", "rows", 3 },
        { "diamond", "rows", 3 }
    };
    for (size_t k = 0; k < sizeof scene / sizeof scene[0]; k++) {
        sp_settings set = sp_settings_default();
        sp_outlook o;
        int told = 0;
        set.coupled.asked = 1;
        test_arena.used = 0;
        const sp_scene s = part(scene[k].name, scene[k].param, scene[k].value, -1);
        agree_coupled(&s, &set, &told);
        CHECK_INT(told, 0);
        CHECK_INT(sp_plan(&s, &set, test_arena, &o), SP_OK);
        CHECK_INT(o.effect[SP_EFFECT_COUPLED].why, SP_WHY_CALLED);
    }
}
#endif

TEST_LIST(spared)
#ifndef SP_NO_CRA
    RUN(what_hangs_on_its_supports_as_a_forest_is_coupled_without_a_search)
    RUN(a_twisted_slab_is_searched_where_friction_spread_as_pressure_does_not_do)
    RUN(a_coupled_check_agrees_with_its_search_on_random_scenes)
    RUN(a_motion_is_looked_for_in_the_plane_first_and_what_is_not_there_is_decided_in_space)
    RUN(a_coupled_check_is_decided_by_one_tree_in_the_plane_and_in_space)
    RUN(without_the_third_dimension_a_motion_is_found_or_nothing_is_said)
    RUN(without_friction_a_coupled_check_is_decided_by_one_linear_programme)
    RUN(a_ring_is_never_told_without_a_search)
#endif
TEST_END
