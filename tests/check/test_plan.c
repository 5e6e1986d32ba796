/* Only the effects a scene calls for: what is left out changes no verdict, and says so. */
#include "../scenes/planned.h"

/* Rows 1, 2, 3, 4, 5, 4, 3, 2, 1: all joints level, all loads plumb, and yet only friction holds it. */
TEST(a_diamond_of_five_rows_without_friction_is_undecided_and_of_four_stands)
{
    sp_settings set = sp_settings_default();
    set.effect[SP_EFFECT_FRICTION] = SP_WITHOUT;
    for (int32_t rows = 4; rows <= 5; rows++) {
        test_arena.used = 0;
        const sp_scene s = part("diamond", "rows", rows, 0.84);
        sp_arena a = test_arena;
        const sp_result planned = check(&s, NULL, &a), all = full(&s, NULL, &a), without = check(&s, &set, &a);
        CHECK_INT(planned.verdict, SP_STABLE);
        CHECK_INT(all.verdict, SP_STABLE);
        CHECK_INT(without.verdict, rows == 4 ? SP_STABLE : SP_UNDECIDED);
        CHECK_INT(without.reason, rows == 4 ? SP_REASON_FORCES : SP_REASON_EFFECT);
        CHECK_INT(without.missing, SP_EFFECT_FRICTION);
        CHECK_INT(without.effect[SP_EFFECT_FRICTION], SP_WHY_LEFT_OUT);
    }
}

/* Walls, arches and rubble lie in a plane, what stands and what falls: a third of the flops or less, the forces as good. Least of
 * all where the first guess is right and its proof, always in 3 dimensions, is much of the work; but for the wall that falls, which
 * in space the bilateral factor alone proves. */
TEST(what_has_a_mirror_is_decided_in_the_plane_with_a_third_of_the_work)
{
    static const struct { const char *name, *param; double value; sp_verdict verdict; int at_once; } scene[] = {
        { "wall", "size", 54, SP_STABLE, 0 }, { "wall", "jitter", 0.3, SP_STABLE, 0 }, { "arch", "n", 12, SP_STABLE, 0 },
        { "rubble", NULL, 0, SP_STABLE, 0 }, { "wall", "tilt", 5, SP_STABLE, 0 }, { "flat-arch", NULL, 0, SP_STABLE, 0 },
        { "wall", "tilt", 45, SP_UNSTABLE, 1 }, { "arch", "t", 0.09, SP_UNSTABLE, 0 }, { "tower", "lean", 0.1, SP_UNSTABLE, 0 },
        { "overhang", "factor", 1.1, SP_UNSTABLE, 0 }, { "diamond", "mu", 0.1, SP_UNSTABLE, 0 }
    };
    for (int inscribed = 0; inscribed < 2; inscribed++) {
        sp_real planned = 0, whole = 0;
        for (size_t k = 0; k < sizeof scene / sizeof scene[0]; k++) {
            sp_settings set = sp_settings_default();
            test_arena.used = 0;
            const sp_scene s = part(scene[k].name, scene[k].param, scene[k].value, -1);
            sp_arena a = test_arena;
            set.faces = inscribed ? 8 : 0;
            const sp_result all = full(&s, &set, &a), r = check(&s, &set, &a);
            if (OPEN && !all.verdict) continue;
#ifdef SP_NO_IPM                        /* there Newton goes on in the plane for 74 steps */
            if (scene[k].at_once) continue;
#endif
            CHECK_INT(all.verdict, scene[k].verdict);
            CHECK_INT(r.verdict, scene[k].verdict);
            CHECK_INT(r.effect[SP_EFFECT_DEPTH], SP_WHY_MIRROR);
            CHECK_INT(all.effect[SP_EFFECT_DEPTH], SP_WHY_ASKED);
            if (!CHECK((scene[k].at_once ? R(1.2) : R(2.2)) * (sp_real)r.spent.total.flops <= (sp_real)all.spent.total.flops))
                TEST_PRINT("    %s: %ld of %ld flops\n", scene[k].name, (long)r.spent.total.flops, (long)all.spent.total.flops);
            CHECK(scene[k].verdict == SP_UNSTABLE || r.imbalance <= r.tol / 2);
            if (scene[k].at_once) continue;
            planned += (sp_real)r.spent.total.flops;
            whole += (sp_real)all.spent.total.flops;
        }
        CHECK((OPEN ? R(2.5) : 3) * planned <= whole);
    }
}

TEST(a_mirror_is_found_in_any_direction_and_none_where_there_is_none)
{
    for (int k = 0; k < 4; k++) {
        test_arena.used = 0;
        sp_scene s = part("arch", "n", 9, -1);
        sp_arena a = test_arena;
        if (k == 1) { s.gravity[0] = R(0.3); }                          /* along the arch's own plane */
        if (k == 2) { s.gravity[1] = R(0.3); }                          /* across it */
        if (k == 3) s.block[4].centroid[1] += R(1e-3);
        const sp_result r = check(&s, NULL, &a), all = full(&s, NULL, &a);
        CHECK_INT(r.verdict, all.verdict);
        CHECK_INT(r.effect[SP_EFFECT_DEPTH], k < 2 ? SP_WHY_MIRROR : SP_WHY_CALLED);
    }
}

/* A board across two others: no mirror once it is moved along and across; level joints, so pressure alone decides. */
TEST(level_joints_without_a_mirror_stand_by_pressure_alone)
{
    const sp_real ground[3] = { 0, 0, R(-1) }, top[3] = { R(0.13), R(0.07), R(1.25) };
    const sp_strength strength = sp_strength_friction(R(0.6));
    sp_scene s = room(4, 4, 16);
    CHECK_INT(sp_scene_body(&s, 0, ground, SP_FIXED, NULL), SP_OK);
    for (int k = 0; k < 2; k++) {
        const double x = 2 * k - 1;
        const sp_real c[3] = { R(x), R(0.1 * k), R(0.5) };
        const sp_real foot[12] = { R(x - 0.3), R(-0.5), 0, R(x + 0.3), R(-0.5), 0, R(x + 0.3), R(0.5), 0, R(x - 0.3), R(0.5), 0 };
        CHECK_INT(sp_scene_body(&s, R(1000), c, 0, NULL), SP_OK);
        CHECK_INT(sp_scene_joint(&s, 0, 1 + k, 4, foot, &strength, NULL), SP_OK);
    }
    CHECK_INT(sp_scene_body(&s, R(1500), top, 0, NULL), SP_OK);
    for (int k = 0; k < 2; k++) {
        const double x = 2 * k - 1;
        const sp_real seat[12] = { R(x - 0.3), R(-0.4), R(1), R(x + 0.3), R(-0.4), R(1), R(x + 0.3), R(0.45), R(1), R(x - 0.3), R(0.45), R(1) };
        CHECK_INT(sp_scene_joint(&s, 1 + k, 3, 4, seat, &strength, NULL), SP_OK);
    }
    sp_arena a = test_arena;
    const sp_result r = check(&s, NULL, &a), all = full(&s, NULL, &a);
    CHECK_INT(r.verdict, SP_STABLE);
    CHECK_INT(r.effect[SP_EFFECT_FRICTION], SP_WHY_PRESSURE);
    CHECK_INT(all.effect[SP_EFFECT_FRICTION], SP_WHY_ASKED);
    if (sizeof(sp_real) == 8) CHECK(2 * r.spent.total.flops <= all.spent.total.flops);
}

TEST(the_third_dimension_left_out_of_a_scene_without_a_mirror_is_undecided)
{
    sp_settings set = sp_settings_default();
    const sp_scene s = part("dome", NULL, 0, -1);
    sp_arena a = test_arena;
    set.effect[SP_EFFECT_DEPTH] = SP_WITHOUT;
    const sp_result r = check(&s, &set, &a);
    CHECK_INT(r.verdict, SP_UNDECIDED);
    CHECK_INT(r.reason, SP_REASON_EFFECT);
    CHECK_INT(r.missing, SP_EFFECT_DEPTH);
}

/* Random scenes of every kind on both sides of their limits: the verdict as planned is that of the full simulation, and what the
 * plan told of flops is right within a factor of 5 where forces are found without interior points. */
TEST(planned_and_full_simulation_agree_on_random_scenes)
{
    int32_t plane[3] = { 0, 0, 0 }, plumb[3] = { 0, 0, 0 }, verdict[3] = { 0, 0, 0 };
    for (int k = 0; k < 300; k += SOME_OF(1, 4)) {       /* by fours still every kind, in several cones */
        sp_scene s;
        sp_settings set;
        sp_outlook o;
        test_arena.used = 0;
        NEED(kinds_make(k, &test_arena, &s, &set) == SP_OK);
        sp_arena a = test_arena;
        CHECK_INT(sp_plan(&s, &set, a, &o), SP_OK);
        const sp_result r = check(&s, &set, &a), all = full(&s, &set, &a);
        const int near = sizeof(sp_real) == 4 && (!r.verdict || !all.verdict);          /* float is undecided sooner */
        if (!CHECK(r.verdict == all.verdict || near))
            TEST_PRINT("    %d, %s: %d as planned, %d\n", k, kinds_table[k % KINDS].name, (int)r.verdict, (int)all.verdict);
        if (TELLS && r.verdict == SP_STABLE && !r.spent.total.interior && !CHECK(o.flops < 5 * r.spent.total.flops && r.spent.total.flops < 5 * o.flops))
            TEST_PRINT("    %d, %s: %ld flops of %ld\n", k, kinds_table[k % KINDS].name, (long)r.spent.total.flops, (long)o.flops);
        plane[r.verdict] += r.effect[SP_EFFECT_DEPTH] == SP_WHY_MIRROR;
        plumb[r.verdict] += r.effect[SP_EFFECT_FRICTION] == SP_WHY_PRESSURE;
        verdict[r.verdict]++;
    }
    CHECK(verdict[SP_STABLE] > SOME_OF(80, 15) && verdict[SP_UNSTABLE] > SOME_OF(80, 15));
    CHECK(plane[SP_STABLE] > SOME_OF(60, 12) && plane[SP_UNSTABLE] > SOME_OF(30, 6));
    CHECK(plumb[SP_STABLE] > SOME_OF(30, 6) && plumb[SP_UNSTABLE] > SOME_OF(3, 0));
}

/* Piles, each block moved along and across on the one below: no friction can hold what falls, whatever mu is. The same piles with
 * the world tilted may want friction, and so may piers under slabs, cycles. */
TEST(a_forest_of_level_joints_falls_by_pressure_alone_and_nothing_else_does)
{
    int32_t fell = 0;
    for (int k = 11; k < 300; k += k % KINDS == 11 ? 1 : KINDS - 1) {
        sp_scene s;
        sp_settings set;
        test_arena.used = 0;
        NEED(kinds_make(k, &test_arena, &s, &set) == SP_OK);
        for (int32_t q = 0; q < s.count.joints; q++) s.joint[q].strength.mu = R(q % 2 ? 50 : 0.6);
        sp_arena a = test_arena;
        const sp_result r = check(&s, NULL, &a), all = full(&s, NULL, &a);
        CHECK_INT(r.verdict, all.verdict);
        if (sizeof(sp_real) == 8) CHECK_INT(r.effect[SP_EFFECT_FRICTION], SP_WHY_PRESSURE);
        CHECK(r.final || !all.final);
        fell += r.verdict == SP_UNSTABLE;
        gen_gravity(1, 30, s.gravity);
        CHECK(check(&s, NULL, &a).effect[SP_EFFECT_FRICTION] != SP_WHY_PRESSURE);
    }
    CHECK(fell > 4);
    for (int k = 14; k < 300; k += KINDS) {
        sp_scene s;
        sp_settings set;
        test_arena.used = 0;
        NEED(kinds_make(k, &test_arena, &s, &set) == SP_OK);
        sp_arena a = test_arena;
        const sp_result r = check(&s, NULL, &a);
        CHECK(r.verdict == SP_STABLE || r.effect[SP_EFFECT_FRICTION] != SP_WHY_PRESSURE);
    }
}

/* Piers under slabs have cycles: what pressure does not hold friction may. Where there is none nothing may, and both answers are
 * told, without a search in 6 rows; the same as its. */
TEST(without_friction_pressure_alone_tells_what_falls_although_joints_form_rings)
{
    int32_t told[3] = { 0, 0, 0 };
    for (int k = 14; k < 600; k += KINDS) {
        sp_scene s;
        sp_settings set;
        test_arena.used = 0;
        NEED(kinds_make(k, &test_arena, &s, &set) == SP_OK);
        for (int32_t q = 0; q < s.count.joints; q++) s.joint[q].strength.mu = 0;
        sp_arena a = test_arena;
        const sp_result r = check(&s, &set, &a), all = full(&s, &set, &a);
        CHECK(r.verdict == all.verdict || (OPEN && !all.verdict));
        if (sizeof(sp_real) == 8 && r.stage == SP_STAGE_EXACT && r.islands.count < 2) CHECK_INT(r.effect[SP_EFFECT_FRICTION], SP_WHY_PRESSURE);
        CHECK(r.final || !all.final);
        told[r.verdict]++;
    }
    CHECK(told[SP_STABLE] > 5 && told[SP_UNSTABLE] > 5);
}

TEST(an_effect_left_out_by_force_never_makes_a_wrong_verdict)
{
    static const struct { const char *name, *param; double value; } scene[] = {
        { "arch", "n", 7 }, { "arch", "t", 0.09 }, { "incline", NULL, 0 }, { "keystone", NULL, 0 }, { "wall", "size", 54 },
        { "overhang", "factor", 1.1 }, { "overhang", NULL, 0 }, { "diamond", "mu", 0.1 }, { "tower", "lean", 0.1 }
    };
    for (size_t k = 0; k < sizeof scene / sizeof scene[0]; k++) {
        test_arena.used = 0;
        const sp_scene s = part(scene[k].name, scene[k].param, scene[k].value, -1);
        sp_arena a = test_arena;
        const sp_result all = full(&s, NULL, &a);
        for (int q = 0; q < SP_EFFECTS_FORCED; q++) {
            sp_settings set = sp_settings_default();
            set.effect[q] = SP_WITHOUT;
            const sp_result r = check(&s, &set, &a);
            CHECK(r.verdict == all.verdict || (r.verdict == SP_UNDECIDED && r.reason == SP_REASON_EFFECT));
        }
    }
}

TEST(a_plan_names_every_effect_and_its_bytes_are_those_of_the_check)
{
    sp_scene s = two("wall", "wall", NULL, 0, plain);
    sp_outlook o;
    size_t bytes = 0;
    sp_settings set = sp_settings_default();
    CHECK_INT(sp_plan(&s, NULL, test_arena, &o), SP_OK);
    CHECK_INT(sp_memory(&s, SP_FOR_CHECK, NULL, test_arena, &bytes), SP_OK);
    CHECK_INT(o.bytes, bytes);
    set.effect[SP_EFFECT_TOGETHER] = SP_WITH;
    CHECK_INT(sp_memory(&s, SP_FOR_CHECK, &set, test_arena, &bytes), SP_OK);
    CHECK_INT(o.full_bytes, bytes);
    CHECK_INT(o.islands, 2);
    CHECK(o.bytes < o.full_bytes);
    CHECK_INT(o.effect[SP_EFFECT_FRICTION].why, SP_WHY_CALLED);
    CHECK_INT(o.effect[SP_EFFECT_DEPTH].why, SP_WHY_MIRROR);
    CHECK(o.effect[SP_EFFECT_DEPTH].flops > 0 && 3 * o.flops < o.full_flops && o.unknowns < o.full_unknowns);
    CHECK_INT(o.effect[SP_EFFECT_TOGETHER].why, SP_WHY_APART);
    CHECK_INT(o.effect[SP_EFFECT_STRENGTH].why, SP_WHY_ABSENT);
    CHECK_INT(o.effect[SP_EFFECT_LOADS].why, SP_WHY_ABSENT);
    CHECK_INT(o.effect[SP_EFFECT_COUPLED].why, SP_WHY_NOT_ASKED);
    CHECK_INT(o.effect[SP_EFFECT_DYNAMICS].why, SP_WHY_STATICS);
    CHECK_INT(o.full_unknowns, 6 * free_blocks(&s) + 3 * s.count.points);
    s.live = 1;
    s.body[0] = R(0.1);
    set.coupled.asked = 1;
    set.effect[SP_EFFECT_FRICTION] = SP_WITHOUT;
    CHECK_INT(sp_plan(&s, &set, test_arena, &o), SP_OK);
    CHECK_INT(o.effect[SP_EFFECT_TOGETHER].why, SP_WHY_ASKED);
    CHECK_INT(o.effect[SP_EFFECT_LIVE].why, SP_WHY_CALLED);
    CHECK_INT(o.effect[SP_EFFECT_COUPLED].why, SP_WHY_CALLED);
    CHECK_INT(o.effect[SP_EFFECT_FRICTION].why, SP_WHY_LEFT_OUT);
}

TEST(where_nothing_is_free_a_plan_has_no_island_as_a_check)
{
    const sp_capacity cap = { 2, 0, 0, 0, 0, 0, 0 };
    const sp_real at[3] = { 0, 0, 0 };
    for (int free_one = 0; free_one < 2; free_one++) {
        sp_scene s;
        sp_outlook o;
        test_arena.used = 0;
        NEED(sp_scene_create(&s, &cap, &test_arena) == SP_OK);
        CHECK_INT(sp_scene_body(&s, 1, at, SP_FIXED, NULL), SP_OK);
        CHECK_INT(sp_scene_body(&s, 1, at, free_one ? 0 : SP_FIXED, NULL), SP_OK);
        CHECK_INT(sp_plan(&s, NULL, test_arena, &o), SP_OK);
        CHECK_INT(o.islands, free_one);
        CHECK_INT(check(&s, NULL, &test_arena).islands.count, free_one);
    }
}

#ifndef SP_NO_CRA
TEST(a_forest_is_planned_without_a_search_only_with_all_iterations)
{
    const sp_scene s = part("two-cubes", NULL, 0, -1);
    sp_settings set = sp_settings_default();
    const int32_t all = set.iterations;
    sp_outlook o;
    set.coupled.asked = 1;
    for (int fewer = 0; fewer < 2; fewer++) {
        set.iterations = all - fewer;
        CHECK_INT(sp_plan(&s, &set, test_arena, &o), SP_OK);
        CHECK_INT(o.effect[SP_EFFECT_COUPLED].why, fewer ? SP_WHY_CALLED : SP_WHY_FOREST);
        CHECK_INT(o.effect[SP_EFFECT_COUPLED].flops > 0, !fewer);
    }
}
#endif

TEST(a_plan_with_unusable_arguments_is_refused)
{
    sp_scene s = part("two-cubes", NULL, 0, -1);
    sp_settings set = sp_settings_default();
    sp_outlook o;
    const sp_arena tiny = { test_arena.base, 64, 0, 0 };
    sp_arena a = test_arena;
    CHECK_INT(sp_plan(NULL, NULL, test_arena, &o), SP_E_ARGUMENT);
    CHECK_INT(sp_plan(&s, NULL, test_arena, NULL), SP_E_ARGUMENT);
    CHECK_INT(sp_plan(&s, NULL, tiny, &o), SP_E_MEMORY);
    sp_result r;
    set.effect[0] = (sp_choice)3;
    CHECK_INT(sp_plan(&s, &set, test_arena, &o), SP_E_ARGUMENT);
    CHECK_INT(sp_check(&s, &set, &a, &r), SP_E_ARGUMENT);
    a = test_arena;
    a.base += (a.used + SP_ALIGN - 1) / SP_ALIGN * SP_ALIGN;
    a.used = a.peak = 0;
    a.capacity = test_bytes(&s, SP_FOR_PLAN, NULL);
    CHECK_INT(sp_plan(&s, NULL, a, &o), SP_OK);
}

TEST_LIST(plan)
    RUN(a_diamond_of_five_rows_without_friction_is_undecided_and_of_four_stands)
    RUN(what_has_a_mirror_is_decided_in_the_plane_with_a_third_of_the_work)
    RUN(a_mirror_is_found_in_any_direction_and_none_where_there_is_none)
    RUN(level_joints_without_a_mirror_stand_by_pressure_alone)
    RUN(the_third_dimension_left_out_of_a_scene_without_a_mirror_is_undecided)
    RUN(planned_and_full_simulation_agree_on_random_scenes)
    RUN(a_forest_of_level_joints_falls_by_pressure_alone_and_nothing_else_does)
    RUN(without_friction_pressure_alone_tells_what_falls_although_joints_form_rings)
    RUN(an_effect_left_out_by_force_never_makes_a_wrong_verdict)
    RUN(a_plan_names_every_effect_and_its_bytes_are_those_of_the_check)
    RUN(where_nothing_is_free_a_plan_has_no_island_as_a_check)
#ifndef SP_NO_CRA
    RUN(a_forest_is_planned_without_a_search_only_with_all_iterations)
#endif
    RUN(a_plan_with_unusable_arguments_is_refused)
TEST_END
