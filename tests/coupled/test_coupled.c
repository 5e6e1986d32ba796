/* The coupled check: what it answers, and what does not change its answer. */
#include "coupled.h"

/* --------------------------------------------------------------------------------------------------------- what is said */

TEST(what_statics_refuse_is_refuted)
{
    const sp_settings set = coupled();
    sp_scene s;
    sp_result r;
    build("two-cubes", "offset", 0.6, &s);
    NEED(sp_check(&s, &set, &test_arena, &r) == SP_OK);
    CHECK_INT(r.verdict, SP_UNSTABLE);
    CHECK_INT(r.coupled.verdict, SP_COUPLING_REFUTED);
    CHECK_INT(r.coupled.reason, SP_COUPLING_STATICS);
}

TEST(what_rests_without_load_is_coupled_as_it_is)
{
    const sp_settings set = coupled();
    sp_scene s;
    sp_result r;
    build("tower", "n", 3, &s);
    s.gravity[2] = 0;
    NEED(sp_check(&s, &set, &test_arena, &r) == SP_OK);
    CHECK_INT(r.verdict, SP_STABLE);
    CHECK_INT(r.level, SP_COUPLED);
    CHECK_NEAR(r.coupled.residual, 0, 0);
}

TEST(the_default_lengths_follow_the_mean_edge)
{
    sp_settings set = sp_settings_default();
    sp_scene s;
    sp_result r;
    build("two-cubes", "offset", 0, &s);
    set.coupled.asked = 1;
    NEED(sp_check(&s, &set, &test_arena, &r) == SP_OK);
    CHECK_NEAR(r.coupled.eps, 1e-4, 1e-6);
    CHECK_NEAR(r.coupled.eta, 1e-2, 1e-6);
    set.coupled.eps = 0;
    NEED(sp_check(&s, &set, &test_arena, &r) == SP_OK);
    CHECK_INT(r.coupled.eps > 0, 0);
    CHECK_NEAR(r.coupled.eta, 1e-2, 1e-6);
}

/* 1e-6, in float 1e-4: what is finer stays, what is coarser does not, where it is asked. */
TEST(a_coupled_check_balances_to_a_millionth_at_least)
{
    const double most = TOL(1e-6, 1e-4), tol[] = { 0.5, 0.99, 1, 1.01, 100 };
    for (int k = 0; k < 5; k++)
        for (int it_is = 0; it_is < 2; it_is++) {
            sp_settings set = sp_settings_default();
            sp_scene s;
            sp_result r;
            test_arena.used = 0;
            build("two-cubes", "offset", 0, &s);
            set.coupled.asked = it_is;
            set.tol = R(most * tol[k]);
            NEED(sp_check(&s, &set, &test_arena, &r) == SP_OK);
            CHECK_NEAR(r.tol, it_is && k > 1 ? most : most * tol[k], TOL(1e-15, 1e-6));
        }
}

static sp_coupling of(const char *name, const char *param, double value)
{
    sp_scene s;
    sp_result r;
    const sp_settings set = asked(100, 0);
    test_arena.used = 0;
    build(name, param, value, &s);
    return answer(&s, &set, &r);
}

TEST(what_stands_by_its_weight_is_coupled)
{
    static const struct { const char *name, *param; double value; } scene[] = {
        { "two-cubes", "offset", 0.4 }, { "incline", "angle", 30 }, { "topple", "angle", 12 }, { "overhang", "factor", 0.95 },
        { "cantilever", "reach", 1.1 }, { "tower", "n", 6 }, { "diamond", "rows", 3 }, { "arch", "n", 12 }, { "arch", "n", TOL(40, 12) },
        { "wall", "rows", 4 } };
    for (size_t k = 0; k < sizeof scene / sizeof scene[0]; k++)
        if (!CHECK_INT(of(scene[k].name, scene[k].param, scene[k].value), SP_COUPLING_COUPLED)) TEST_PRINT("    %s\n", scene[k].name);
}

TEST(the_price_of_a_certificate_is_told_and_contains_its_judge)
{
    const sp_settings set = asked(100, 0);
    for (int refuted = 0; refuted < 2; refuted++) {
        sp_scene s;
        sp_result r;
        test_arena.used = 0;
        build(refuted ? "h-model" : "incline", NULL, 0, &s);
        answer(&s, &set, &r);
        int64_t sum = r.coupled.cost.flops;
        for (int32_t k = 0; k < set.stage_count; k++) sum += r.spent.by_stage[k].flops;
        CHECK_INT(r.spent.total.flops, sum);
        CHECK(r.coupled.cost.flops > 2 * 90 * (int64_t)s.count.points);
    }
}

TEST(the_h_model_is_never_coupled)                      /* though statics accept it */
{
    static const double mu[] = { 0.01, 0.45, 0.84 };
    for (int k = 0; k < 3; k += SOME_OF(1, 2)) {
        sp_scene s;
        sp_result r;
        test_arena.used = 0;
        build("h-model", "mu", mu[k], &s);
        NEED(sp_check(&s, NULL, &test_arena, &r) == SP_OK);
        CHECK_INT(r.verdict, SP_STABLE);
        for (double ratio = 2; ratio < 3e3; ratio *= SOME_OF(10, 100)) {
            const sp_settings set = asked(ratio, 1);
            test_arena.used = 0;
            build("h-model", "mu", mu[k], &s);
            CHECK(answer(&s, &set, &r) != SP_COUPLING_COUPLED);
        }
    }
}

static sp_coupling squeeze_of(squeeze q, double ratio)
{
    sp_scene s;
    sp_result r;
    sp_settings set = asked(ratio, 1);
    set.coupled.eps *= R(q.unit);
    set.coupled.eta *= R(q.unit);
    squeezed(&q, &s);
    return answer(&s, &set, &r);
}

TEST(a_squeezed_block_jams_across_its_diagonal_from_mu_2h_over_w_on)
{
    static const double h[] = { 0.2, 0.42, 1 };
    for (int k = 0; k < 3; k++) {
        squeeze q = plain;
        q.h = h[k];
        q.mu = 2 * h[k] * (1 + TOL(1e-3, 2e-2));
        CHECK_INT(squeeze_of(q, 100), SP_COUPLING_COUPLED);
        q.mu = 2 * h[k] * (1 - TOL(1e-3, 2e-2));
        CHECK(squeeze_of(q, 100) != SP_COUPLING_COUPLED);
    }
}

TEST(and_from_eta_over_eps_2w_over_h_on)
{
    static const double h[] = { 0.2, 0.42, 1 };
    for (int k = 0; k < 3; k++) {
        squeeze q = plain;
        q.h = h[k];
        q.mu = 4 * h[k];
        CHECK_INT(squeeze_of(q, 2 / h[k] * (1 + TOL(1e-3, 2e-2))), SP_COUPLING_COUPLED);
        CHECK(squeeze_of(q, 2 / h[k] * (1 - TOL(1e-3, 2e-2))) != SP_COUPLING_COUPLED);
    }
}

TEST(without_give_a_squeezed_block_slides_down_and_is_coupled_however_little_it_rubs)
{
    static const double mu[] = { 0.01, 0.1, 0.7 };
    for (int k = 0; k < 6; k++) {
        sp_settings set = asked(1, k % 2);
        squeeze q = plain;
        sp_scene s;
        sp_result r;
        q.mu = mu[k / 2];
        q.h = k % 2 ? 3 : 0.4;
        set.coupled.eps = 0;
        squeezed(&q, &s);
        CHECK_INT(answer(&s, &set, &r), SP_COUPLING_COUPLED);
    }
}

TEST(the_answer_does_not_depend_on_units_axes_order_or_sides)
{
    for (int k = 0; k < 64; k += SOME_OF(1, 5)) {        /* by fives each of the six is met both ways */
        squeeze q = plain;
        q.turn = k & 1 ? 0.7 : 0;
        q.unit = k & 2 ? 1e-3 : 1;
        q.heavy = k & 4 ? TOL(1e6, 1e3) : 1;
        q.swap = k >> 3 & 1;
        q.late = k >> 4 & 1;
        q.mu = k & 32 ? 0.9 : 0.7;                      /* 2 h / w = 0.8 */
        if (k & 32) CHECK_INT(squeeze_of(q, 20), SP_COUPLING_COUPLED);
        else CHECK(squeeze_of(q, 20) != SP_COUPLING_COUPLED);
    }
}

TEST(a_coarse_tol_neither_couples_what_slides_nor_leaves_the_h_model_open)
{
    static const double past[] = { TOL(1.0005, 1.0005), TOL(1.00001, 1.0005), 0 };
    for (int k = 0; k < 3; k++) {
        sp_settings set = asked(100, 0);
        sp_scene s;
        sp_result r;
        set.tol = R(1e-3);
        test_arena.used = 0;
        build(past[k] > 0 ? "incline" : "h-model", past[k] > 0 ? "angle" : NULL, 40, &s);
        for (int32_t i = 0; i < s.count.joints && past[k] > 0; i++)
            s.joint[i].strength.mu = R(tan(40 * 3.14159265358979323846 / 180) / past[k]);
        set.coupled.asked = 0;
        CHECK_INT(sp_check(&s, &set, &test_arena, &r), SP_OK);
        CHECK_INT(r.verdict, SP_STABLE);                /* within that tol */
        set.coupled.asked = 1;
        CHECK_INT(answer(&s, &set, &r), k < 2 || sizeof(sp_real) == 8 ? SP_COUPLING_REFUTED : SP_COUPLING_NOT_FOUND);
        CHECK_NEAR(r.tol, TOL(1e-6, 1e-4), SP_EPSILON);
    }
}

/* Without friction a keystone sinks by eps / sin of its sides' angle. */
TEST(a_frictionless_keystone_is_coupled_if_it_may_sink_deep_enough)
{
    static const double angle[] = { -30, -5, -1 };
    for (int k = 0; k < 3; k++)
        for (int far = 0; far < 2; far++) {
            sp_scene s;
            sp_result r;
            gen_scene g;
            test_arena.used = 0;
            CHECK(gen_open(&g, "keystone") && gen_set(&g, "angle", angle[k]) && gen_set(&g, "mu", 0));
            CHECK_INT(gen_build(&g, &test_arena, &s), SP_OK);
            const sp_settings set = asked((far ? 1.01 : 0.99) / tan(-angle[k] * 3.14159265358979323846 / 180), 1);
            const sp_coupling found = answer(&s, &set, &r);
            if (far) CHECK_INT(found, SP_COUPLING_COUPLED);
            else CHECK(found != SP_COUPLING_COUPLED);
        }
}

/* A beam snug between a wall and an upright block that stands free on the ground: nothing squeezes it, and it is too high to
 * jam across its diagonal, but statics let the upright's weight press it. low, top: of the beam; end: of the upright; `order`:
 * of the blocks and joints, which side is A. */
typedef struct snug_beam { double mu, low, top, width, end, mass, post; } snug_beam;

static void snug_of(const snug_beam *beam, int order, sp_scene *s)
{
    const double low = beam->low, top = beam->top, y = beam->width / 2;
    /* ground wall beam post */
    const double at[4][3] = { { 0, 0, -1 }, { -2, 0, 1 }, { 0, 0, (low + top) / 2 }, { (0.5 + beam->end) / 2, 0, 1 } };
    const double mass[4] = { 0, 0, beam->mass, beam->post };
    const double corner[3][12] = {
        { -0.5, -y, low, -0.5, y, low, -0.5, y, top, -0.5, -y, top }, { 0.5, -y, low, 0.5, y, low, 0.5, y, top, 0.5, -y, top },
        { 0.5, -y, 0, beam->end, -y, 0, beam->end, y, 0, 0.5, y, 0 } };
    static const int pair[3][2] = { { 1, 2 }, { 2, 3 }, { 0, 3 } };
    const sp_capacity cap = { 4, 0, 0, 0, 3, 12, 0 };
    const sp_strength strength = sp_strength_friction(R(beam->mu));
    int32_t id[4];
    test_arena.used = 0;
    CHECK_INT(sp_scene_create(s, &cap, &test_arena), SP_OK);
    for (int k = 0; k < 4; k++) {
        const int i = (k + order) % 4;
        const sp_real c[3] = { R(at[i][0]), R(at[i][1]), R(at[i][2]) };
        CHECK_INT(sp_scene_body(s, R(mass[i]), c, mass[i] > 0 ? 0 : SP_FIXED, &id[i]), SP_OK);
    }
    for (int k = 0; k < 3; k++) {
        const int j = (k + order) % 3, swap = order >> k & 1;
        sp_real xyz[12];
        for (int q = 0; q < 12; q++) {
            const int v = (q / 3 + order) % 4;
            xyz[q] = R(corner[j][3 * (swap ? 3 - v : v) + q % 3]);
        }
        CHECK_INT(sp_scene_joint(s, id[pair[j][swap]], id[pair[j][!swap]], 4, xyz, &strength, NULL), SP_OK);
    }
}

static void snug(double mu, int order, sp_scene *s)
{
    const snug_beam q = { mu, 1.2, 1.8, 1, 1, 100, 5000 };
    snug_of(&q, order, s);
}

TEST(a_beam_snug_between_a_wall_and_a_free_upright_is_refuted_however_it_is_numbered)
{
    for (int order = SOME_OF(0, 1); order < SOME_OF(5, 3); order++) {
        const sp_settings set = asked(100, 0);
        sp_scene s;
        sp_result r;
        snug(order ? 0.3 : 0.7, order, &s);
        NEED(sp_check(&s, NULL, &test_arena, &r) == SP_OK);
        CHECK_INT(r.verdict, SP_STABLE);
        snug(order ? 0.3 : 0.7, order, &s);
        if (sizeof(sp_real) == 8) CHECK_INT(answer(&s, &set, &r), SP_COUPLING_REFUTED);
        else CHECK(answer(&s, &set, &r) != SP_COUPLING_COUPLED);
    }
}

/* Half as high as wide and mu = 0.84, less than 2h/w = 1: in its plane it cannot jam. In space it can, by a motion that only
 * the search by cases finds. */
TEST(a_snug_beam_that_cannot_jam_in_its_plane_is_coupled_in_space)
{
    static const snug_beam q = { 0.84, 0.75, 1.25, 0.5, 1.5, 600, 2400 };
    const sp_settings set = asked(100, 0);
    for (int order = 0; order < SOME_OF(3, 1); order++) {
        sp_scene s;
        sp_result r;
        snug_of(&q, order, &s);
        const sp_coupling found = answer(&s, &set, &r);
        CHECK(found != SP_COUPLING_REFUTED);
        if (sizeof(sp_real) == 8) CHECK_INT(found, SP_COUPLING_COUPLED);
        CHECK(r.coupled.cost.flops < 7000000000);
    }
}

/* ---------------------------------------------------------------------------------------------------- monotone, invariant */

/* Scenes with their answers at eta/eps 100, slip bounded by its length. */
typedef struct known { const char *name; double angle, mu, tilt; sp_coupling answer; } known;
static const known sample[] = {
    { "h-model", 0, 0.84, 0, SP_COUPLING_REFUTED },         { "h-model", 0, 0.45, 0, SP_COUPLING_REFUTED },
    { "squeezed", 0, 0.9, 0, SP_COUPLING_COUPLED },         { "squeezed", 0, 0.7, 0, SP_COUPLING_REFUTED },
    { "arch", 0, 0.84, 0, SP_COUPLING_COUPLED },            { "flat-arch", 0, 0.5, 0, SP_COUPLING_COUPLED },
    { "keystone", -1, 0, 0, SP_COUPLING_COUPLED },          { "keystone", -0.5, 0, 0, SP_COUPLING_REFUTED },
    { "keystone", 20, 0.84, 0, SP_COUPLING_REFUTED },       { "keystone", -20, 0.84, 50, SP_COUPLING_COUPLED },
    { "keystone", -20, 0.84, 80, SP_COUPLING_COUPLED },     { "snug", 0, 0.7, 0, SP_COUPLING_REFUTED }
};
enum { SAMPLES = sizeof sample / sizeof sample[0] };

static void build_known(const known *k, sp_scene *s)
{
    squeeze q = plain;
    gen_scene g;
    test_arena.used = 0;
    q.mu = k->mu;
    if (k->name[0] == 's') {
        if (k->name[1] == 'q') squeezed(&q, s);
        else snug(k->mu, 0, s);
        return;
    }
    CHECK(gen_open(&g, k->name));
    CHECK_INT(gen_set(&g, "mu", k->mu), 1);
    if (k->name[0] == 'k') CHECK_INT(gen_set(&g, "angle", k->angle), 1);
    if (k->tilt > 0) CHECK(gen_set(&g, "tilt", k->tilt) == 1 && gen_set(&g, "azimuth", 40) == 1);
    if (k->name[0] == 'a') CHECK_INT(gen_set(&g, "n", 12), 1);
    CHECK_INT(gen_build(&g, &test_arena, s), SP_OK);
}

/* In float an answer may be missing; it is never the other one. */
static void same_answer(const known *k, const sp_scene *s, double unit)
{
    sp_settings set = asked(100, 0);
    sp_result r;
    set.coupled.eps *= R(unit);
    set.coupled.eta *= R(unit);
    const sp_coupling found = answer(s, &set, &r);
    if (sizeof(sp_real) == 8 || found != SP_COUPLING_NOT_FOUND) {
        if (!CHECK_INT(found, k->answer)) TEST_PRINT("    %s angle %g mu %g tilt %g\n", k->name, k->angle, k->mu, k->tilt);
    }
}

TEST(a_turn_with_gravity_units_order_sides_and_first_corners_leave_the_answer)
{
    for (int k = 0; k < SAMPLES; k++)
        for (int way = sample[k].name[1] == 'n' ? SOME_OF(5, 6) : 0; way < 6; way++) {         /* what takes a second: all at once only */
            sp_scene s, other;
            int32_t place[MOST], name[MOST];
            change c = none();
            if (way < 5 && (k + way) % SOME_OF(1, 3)) continue;         /* each way of a third of them, all at once of all */
            if (way == 0 || way == 5) any_turn(&c);
            if (way == 1 || way == 5) c.scale = 12.5, c.density = 4e-3, c.gravity = 3;
            if (way == 2 || way == 5) c.permute = 1;
            if (way == 3 || way == 5) c.swap = 1;
            if (way == 4 || way == 5) c.turn = 1;
            build_known(&sample[k], &s);
            copy(&s, &c, &other, place, name);
            same_answer(&sample[k], &other, c.scale);
        }
}

/* Of one triple (f, dq, alpha) the conditions ask  f in K,  dn <= eta, |dt| <= eta,  and besides only what is linear in f for
 * one dq, or in dq for one f. So it is one still
 *     with more friction, or a cone around that one:     f in K stays
 *     with a larger eta, or its bound per component:     |dt1|, |dt2| <= |dt|
 *     in another length:  eps, eta, dq  times s,  alpha / s:     ft = -alpha dt, dn + eps
 *     with other weights: p, f, alpha times s:           Aeq f + p, ft = -alpha dt */
TEST(a_triple_stays_one_where_more_is_allowed_or_all_is_scaled)
{
    for (int k = 0; k < SAMPLES; k++)
        for (int way = 0; way < 8; way++) {
            sp_settings set = asked(100, 0);
            sp_scene s;
            sp_result r;
            sp_evidence e;
            if (sample[k].answer != SP_COUPLING_COUPLED) continue;
            build_known(&sample[k], &s);
            if (answer(&s, &set, &r) != SP_COUPLING_COUPLED) { CHECK(sizeof(sp_real) == 4); continue; }
            if (way == 1) CHECK_INT(sp_scene_friction(&s, R(sample[k].mu * 1.5 + 0.1)), SP_OK);
            if (way == 2) set.coupled.eta *= 10;
            if (way == 3) set.coupled.box = 1;
            if (way == 4 || way == 5) { set.faces = way == 4 ? 5 : 8; set.inscribed = 0; }
            if (way == 6) { set.coupled.eps *= 7; set.coupled.eta *= 7; }
            for (int32_t i = 0; i < 6 * s.count.blocks && way == 6; i++) r.coupled.dq[i] *= 7;
            for (int32_t v = 0; v < s.count.points && way == 6; v++) r.coupled.alpha[v] /= 7;
            for (int i = 0; i < 3 && way == 7; i++) s.gravity[i] *= 3;
            for (int32_t v = 0; v < s.count.points && way == 7; v++) r.coupled.alpha[v] *= 3;
            for (int32_t i = 0; i < 3 * s.count.points && way == 7; i++) r.f[i] *= 3;
            CHECK_INT(sp_verify(&s, &set, &r, test_arena, &e), SP_OK);
            if (!CHECK_INT(e.level, SP_COUPLED)) TEST_PRINT("    %s mu %g, way %d\n", sample[k].name, sample[k].mu, way);
        }
}

/* ... so no answer turns back: refuted, perhaps not found, then coupled; in double it turns once. */
TEST(as_friction_or_eta_grows_the_answer_turns_once)
{
    for (int what = 0; what < 3; what++) {
        int turned = 0;
        for (int step = 0; step <= 24; step += SOME_OF(1, 3)) {
            const double by = 0.5 + step * 0.0625 + 1e-3;
            const double mu = what == 2 ? 0 : what == 1 ? 1.6 : 0.8 * by;
            const known k = { what == 2 ? "keystone" : "squeezed", -1, mu, 0, SP_COUPLING_NOT_FOUND };
            const double ratio = what == 0 ? 20 : (what == 1 ? 5 : 1 / tan(3.14159265358979323846 / 180)) * by;
            const sp_settings set = asked(ratio, what == 1);
            sp_scene s;
            sp_result r;
            build_known(&k, &s);
            const sp_coupling found = answer(&s, &set, &r);
            if (found == SP_COUPLING_COUPLED) turned = 1;
            CHECK(!turned || found != SP_COUPLING_REFUTED);
            if (sizeof(sp_real) == 8) CHECK_INT(found, by > 1 ? SP_COUPLING_COUPLED : SP_COUPLING_REFUTED);
        }
        CHECK_INT(turned, 1);
    }
}

/* Two stones of 2400 kg, 1.3 m from each other, held by four triangles, three corners each; one is between the stones. */
typedef struct held { double mu; double corner[4][9]; } held;

static const held pair[] = {
    { 0.65, { { -.03, -.21, .48, -.15, -.02, .5, .03, .02, .52 },   { -.21, .64, -.29, -.4, .39, -.48, -.02, .48, -.56 },
              { .62, -.07, .28, .64, -.28, -.08, .68, .12, -.27 },  { 1.81, -.11, -.34, 1.74, -.4, .2, 1.85, .28, .09 } } },
    { 1.09, { { .2, 0, -.59, .47, -.38, -.15, .56, .23, -.12 },     { -.51, .26, .01, -.53, .05, -.19, -.4, .31, -.27 },
              { .66, -.04, .27, .67, -.21, -.18, .62, .28, 0 },     { 1.8, .09, .05, 1.78, -.04, .18, 1.75, .14, .2 } } },
    { 2.16, { { .48, -.02, .2, .36, -.19, .33, .38, .02, .36 },     { -.53, .21, -.09, -.44, -.2, -.32, -.37, .36, -.26 },
              { .63, -.1, .15, .67, -.12, -.13, .67, .08, -.16 },   { .98, .1, -.46, .95, -.28, -.36, 1.24, -.33, -.46 } } },
    { 0.51, { { .45, .39, -.17, .34, .32, -.41, .51, .28, -.23 },   { -.27, .16, .52, -.43, -.33, .26, -.52, .29, .12 },
              { .73, .01, .31, .58, -.22, -.21, .61, .24, -.21 },   { 1.69, .14, -.37, 1.83, -.03, -.14, 1.72, .32, -.17 } } },
    { 1.96, { { -.63, .02, -.08, -.08, -.2, -.6, -.37, .35, -.38 }, { .51, .09, .03, .49, -.1, .15, .46, .14, .2 },
              { .71, -.1, .36, .62, -.38, -.02, .67, .38, -.02 },   { 1.15, .51, -.35, .8, .07, -.39, 1.45, .25, -.56 } } } };

static void build_pair(const held *h, double unit, sp_scene *s)
{
    static const int32_t side[4][2] = { { 0, 1 }, { 0, 1 }, { 1, 2 }, { 0, 2 } };
    const sp_capacity cap = { 3, 0, 0, 0, 4, 12, 0 };
    const sp_strength strength = sp_strength_friction(R(h->mu));
    test_arena.used = 0;
    CHECK_INT(sp_scene_create(s, &cap, &test_arena), SP_OK);
    for (int k = 0; k < 3; k++) {
        const sp_real at[3] = { R(unit * (k ? 1.3 * (k - 1) : -9)), 0, 0 };
        CHECK_INT(sp_scene_body(s, R(2400), at, k ? 0 : SP_FIXED, NULL), SP_OK);
    }
    for (int q = 0; q < 4; q++) {
        sp_real xyz[9];
        for (int k = 0; k < 9; k++) xyz[k] = R(unit * h->corner[q][k]);
        CHECK_INT(sp_scene_joint(s, side[q][0], side[q][1], 3, xyz, &strength, NULL), SP_OK);
    }
}

TEST(triples_that_springs_and_cases_miss_are_found_by_reflections)
{
    for (size_t k = 0; k < sizeof pair / sizeof *pair; k++)
        for (int unit = 0; unit < 2; unit++) {
            sp_settings asked_for = sp_settings_default();
            sp_scene s;
            sp_result r;
            build_pair(&pair[k], unit ? 1024 : 1, &s);
            asked_for.coupled.asked = 1;
            const sp_coupling told = answer(&s, &asked_for, &r);
#if !defined SP_REAL_FLOAT && !defined SP_REAL_MIXED
            CHECK_INT(told, SP_COUPLING_COUPLED);
#else
            CHECK(told != SP_COUPLING_REFUTED);
#endif
        }
}

TEST(proofs_have_room_by_the_cube_of_the_corners_up_to_ten_megabytes)
{
    static const int n[] = { 1, 2, 4, 11, 12 };
    for (int k = 0; k < 5; k++) {
        sp_settings set = asked(100, 0);
        size_t bytes[2];
        for (int own = 0; own < 2; own++) {
            sp_scene s;
            test_arena.used = 0;
            build("tower", "n", n[k], &s);
            set.coupled.nodes = own ? -1 : 0;
            CHECK_INT(sp_memory(&s, SP_FOR_CHECK, &set, test_arena, &bytes[own]), SP_OK);
        }
        const double corners = 4 * n[k], cube = 24 * corners * corners * corners, nodes = cube < 48000 ? cube : 48000;
        CHECK((double)(bytes[1] - bytes[0]) < 300 * nodes + 200000 && bytes[1] - bytes[0] <= (size_t)12 << 20);
        CHECK((double)(bytes[1] - bytes[0]) > 100 * nodes);
    }
}

TEST_LIST(coupled)
    RUN(what_statics_refuse_is_refuted)
    RUN(what_rests_without_load_is_coupled_as_it_is)
    RUN(the_default_lengths_follow_the_mean_edge)
    RUN(a_coupled_check_balances_to_a_millionth_at_least)
    RUN(what_stands_by_its_weight_is_coupled)
    RUN(the_price_of_a_certificate_is_told_and_contains_its_judge)
    RUN(the_h_model_is_never_coupled)
    RUN(a_squeezed_block_jams_across_its_diagonal_from_mu_2h_over_w_on)
    RUN(and_from_eta_over_eps_2w_over_h_on)
    RUN(without_give_a_squeezed_block_slides_down_and_is_coupled_however_little_it_rubs)
    RUN(the_answer_does_not_depend_on_units_axes_order_or_sides)
    RUN(a_coarse_tol_neither_couples_what_slides_nor_leaves_the_h_model_open)
    RUN(a_frictionless_keystone_is_coupled_if_it_may_sink_deep_enough)
    RUN(a_beam_snug_between_a_wall_and_a_free_upright_is_refuted_however_it_is_numbered)
    RUN(a_snug_beam_that_cannot_jam_in_its_plane_is_coupled_in_space)
    RUN(a_turn_with_gravity_units_order_sides_and_first_corners_leave_the_answer)
    RUN(a_triple_stays_one_where_more_is_allowed_or_all_is_scaled)
    RUN(as_friction_or_eta_grows_the_answer_turns_once)
    RUN(triples_that_springs_and_cases_miss_are_found_by_reflections)
    RUN(proofs_have_room_by_the_cube_of_the_corners_up_to_ten_megabytes)
TEST_END
