/* Work of small questions, counted to the flop, bytes and numbers of their answers: checks by every stage and plan, coupled
 * checks, strong verdicts, sliding limits, building sequences. A search that is changed goes another way, which its verdict
 * hardly ever tells. Found by checks: imbalances, |f|, |dq|, the help that joints want. */
#include "../scenes/tally.h"

#if !defined SP_NO_IPM && !defined SP_SMALL && !defined SP_NO_CRA && !defined SP_NO_STRONG && !defined SP_NO_SLIDING \
 && !defined SP_NO_QP && !defined SP_NO_ADMM && !defined SP_NO_DYKSTRA && !defined SP_QP_NO_CG && !defined SP_QP_NO_POLISH \
 && !defined SP_QP_NO_INTERIOR && !defined SP_EXACT_ONLY && !defined SP_QP_ONLY
#define TALLY_ALL

/* How a scene is asked. */
typedef enum ask { PLANNED, IN_SPACE, TOGETHER, FINE, IN_4, AROUND_8, IN_16, NO_HELP, LESS_BOUND, LEAST_SQUARES, DENSE, POLISH,
                   BY_ADMM, NET, SEEDED, COUPLED, COUPLED_8, COUPLED_TREE, COUPLED_BOX, COUPLED_SOFT, COUPLED_WIDE, ROUNDS } ask;

typedef struct count {
    tally_scene of;
    ask how;
    int budget;                                         /* share of the flops of the whole, in hundredths; 0: all of it */
    tally is;
} count;

static void alone(sp_settings *set, sp_stage_id stage)
{
    set->stage_count = 1;
    set->stage[0] = stage;
}

static sp_settings asked(ask how)
{
    sp_settings set = how == SEEDED ? sp_settings_seed() : sp_settings_default();
    if (how == IN_SPACE || how == TOGETHER || how == COUPLED_WIDE)
        set.effect[SP_EFFECT_DEPTH] = set.effect[SP_EFFECT_FRICTION] = SP_WITH;
    if (how == TOGETHER) set.effect[SP_EFFECT_TOGETHER] = SP_WITH;
    if (how == FINE) set.tol = R(TOL(1e-12, 1e-5));
    if (how == IN_4 || how == AROUND_8 || how == IN_16 || how == COUPLED_8) set.faces = how == IN_4 ? 4 : how == IN_16 ? 16 : 8;
    set.inscribed = how == IN_4 || how == IN_16;
    set.localise = how != NO_HELP;
    if (how == LESS_BOUND) set.force_bound = 10;
    if (how == LEAST_SQUARES) alone(&set, SP_STAGE_LEAST_SQUARES);
    if (how == DENSE) alone(&set, SP_STAGE_DENSE);
    if (how == POLISH) alone(&set, SP_STAGE_POLISH);
    if (how == BY_ADMM || how == NET) alone(&set, SP_STAGE_ADMM);
    set.penalty.net = how == NET;
    if (how >= COUPLED) set.coupled.asked = 1;
    if (how == COUPLED_TREE) set.coupled.eps = 0;
    if (how == COUPLED_BOX) set.coupled.box = 1;
    if (how == COUPLED_SOFT) set.coupled.eta = R(1e-6);
    if (how == ROUNDS) set.coupled.rounds = 3;
    return set;
}

static void compare(const count *rows, size_t n)
{
    for (size_t k = 0; k < n; k++) {
        const count *c = &rows[k];
        const sp_scene s = tally_make(&c->of);
        const sp_arena mark = test_arena;
        sp_settings set = asked(c->how);
        sp_result r;
        CHECK_INT(sp_check(&s, &set, &test_arena, &r), SP_OK);
        if (c->budget) {
            set.budget = r.spent.total.flops * c->budget / 100;
            test_arena = mark;
            CHECK_INT(sp_check(&s, &set, &test_arena, &r), SP_OK);
        }
        sp_real help = 0;
        for (int32_t i = 0; i < s.count.joints && set.localise; i++) help += r.demand[i].tension + r.demand[i].friction;
        const double found[] = { (double)r.imbalance, (double)r.least_imbalance, tally_size(r.f, 3 * (size_t)s.count.points),
                                 tally_size(r.coupled.dq ? r.coupled.dq : r.dq, 6 * (size_t)s.count.blocks), (double)help };
        tally_compare(c->of.name, k, &c->is, (int)r.verdict + 10 * (int)r.coupled.verdict, &r.spent.total,
                      r.spent.peak_bytes, found);
    }
}

#define COMPARE(rows) compare(rows, sizeof (rows) / sizeof *(rows))

TEST(planned_checks_take_the_work_written_here)
{
    static const count rows[] = {
        { { "two-cubes", "offset", 0.3, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 1, 1, 0, 0, 1209,
          4784, { 1.110223e-16, 0, 12803.181, 0, 0 } } },
        { { "two-cubes", "offset", 0.6, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 2, 6, 4, 0, 4832,
          4784, { 0.19611495, 0.047871791, 20803.046, 1.1224972, 2941.995 } } },
        { { "arch", "n", 5, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 1, 3, 2, 0, 20111,
          13824, { 6.6558095e-16, 0, 2362.6245, 0, 0 } } },
        { { "incline", "angle", 20, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 1, 1, 0, 0, 1209,
          4784, { 9.3082242e-17, 0, 2359.0959, 0, 0 } } },
        { { "incline", "angle", 45, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 2, 7, 5, 0, 7229,
          4784, { 0.044481196, 0.043205987, 2358.5695, 0.71414284, 133.37753 } } },
        { { "keystone", "angle", 20, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 1, 2, 1, 0, 4316,
          6032, { 3.9613304e-16, 0, 6073.5918, 0, 0 } } },
        { { "keystone", "angle", 20, 0.3, { 0, 0, 0 }, 0 }, PLANNED, 0, { 2, 5, 3, 0, 7437,
          6032, { 1, 0.5, 0, 0.68331507, 4300.909 } } },
        { { "flat-arch", "n", 4, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 1, 4, 3, 0, 27664,
          11744, { 6.3617145e-16, 0, 7998.6273, 0, 0 } } },
        { { "tower", "n", 4, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 1, 1, 0, 0, 5823,
          10640, { 2.9499412e-16, 0, 67269.986, 0, 0 } } },
        { { "tower", "lean", 0.2, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 2, 9, 7, 2, 179193,
          22896, { 0.1003861, 0.0020966639, 491088.5, 1.5296897, 257424.43 } } },
        { { "diamond", "rows", 3, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 1, 4, 3, 0, 63844,
          26016, { 8.3673724e-16, 0, 20703.649, 0, 0 } } },
        { { "diamond", "rows", 4, 0.1, { 0, 0, 0 }, 0 }, PLANNED, 0, { 1, 6, 5, 3, 640205,
          48560, { 1.7715102e-16, 0, 43271.371, 0, 0 } } },
        { { "inverted-triangle", "rows", 3, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 2, 8, 6, 0, 73544,
          15952, { 0.059190412, 0.019470922, 15132.461, 1.8075786, 726.51306 } } },
        { { "h-model", "mu", 0.84, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 1, 2, 1, 0, 4316,
          6032, { 2.1773181e-16, 0, 931.49114, 0, 0 } } },
        { { "cantilever", "reach", 1.2, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 1, 1, 0, 0, 2747,
          6640, { 1.9535892e-16, 0, 5351.5204, 0, 0 } } },
        { { "cantilever", "reach", 1.5, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 2, 6, 4, 0, 13846,
          6640, { 0.49116707, 0.073978487, 8374.5695, 1.5467708, 2071.1645 } } },
        { { "overhang", "n", 4, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 1, 1, 0, 0, 5823,
          10640, { 2.4949159e-15, 0, 17692.65, 0, 0 } } },
        { { "overhang", "factor", 1.1, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 2, 6, 4, 0, 36072,
          12752, { 0.099503217, 0.013230946, 26153.065, 1.1499072, 2225.3216 } } },
        { { "incline", "turn", 30, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 1, 1, 0, 0, 5313,
          4608, { 4.050314e-17, 0, 2359.0959, 0, 0 } } }
    };
    COMPARE(rows);
}

TEST(walls_and_shells_take_the_work_written_here)
{
    static const count rows[] = {
        { { "wall", "bricks", 2, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 1, 1, 0, 0, 72601,
          65632, { 7.8992911e-15, 0, 3082.4022, 0, 0 } } },
        { { "wall", "rows", 3, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 1, 1, 0, 0, 95968,
          89552, { 9.8420646e-16, 0, 1805.992, 0, 0 } } },
        { { "arch", "t", 0.1, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 2, 9, 7, 0, 300239,
          44320, { 0.085611359, 0.0012172009, 3791.3926, 2.4617194, 105.65357 } } },
        { { "rubble", "bricks", 2, 0.5, { 0, 0, 0 }, 0 }, PLANNED, 0, { 1, 3, 2, 0, 113130,
          50544, { 2.7839383e-15, 0, 6447.3167, 0, 0 } } },
        { { "wall", "rows", 2, 0, { 0, 0, 0 }, 0 }, PLANNED, 0, { 1, 1, 0, 0, 56466,
          55200, { 1.2540048e-15, 0, 1129.7261, 0, 0 } } },
        { { "vault", "around", 3, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 1, 1, 0, 0, 279192,
          60176, { 8.8240645e-16, 0, 3267.8326, 0, 0 } } }
    };
    COMPARE(rows);
}

TEST(checks_in_space_and_together_take_the_work_written_here)
{
    static const count rows[] = {
        { { "two-cubes", "offset", 0.3, 0.84, { 0, 0, 0 }, 0 }, IN_SPACE, 0, { 1, 1, 0, 0, 5313,
          4608, { 9.4617805e-17, 0, 12803.181, 0, 0 } } },
        { { "two-cubes", "offset", 0.6, 0.84, { 0, 0, 0 }, 0 }, IN_SPACE, 0, { 2, 5, 4, 0, 17645,
          4608, { 0.19611495, 0.047871791, 20803.046, 1.1224972, 2941.995 } } },
        { { "arch", "n", 5, 0.84, { 0, 0, 0 }, 0 }, IN_SPACE, 0, { 1, 3, 2, 0, 70203,
          13824, { 3.8160638e-16, 0, 2362.6245, 0, 0 } } },
        { { "incline", "angle", 45, 0.84, { 0, 0, 0 }, 0 }, IN_SPACE, 0, { 2, 6, 5, 0, 27272,
          4608, { 0.044481196, 0.043205987, 2358.5695, 0.71414284, 133.37753 } } },
        { { "keystone", "angle", 20, 0.84, { 0, 0, 0 }, 0 }, IN_SPACE, 0, { 1, 2, 1, 0, 14988,
          5680, { 2.9642968e-16, 0, 6073.5918, 0, 0 } } },
        { { "flat-arch", "n", 4, 0.84, { 0, 0, 0 }, 0 }, IN_SPACE, 0, { 1, 4, 3, 0, 101336,
          11744, { 1.1080946e-15, 0, 7998.6273, 0, 0 } } },
        { { "tower", "lean", 0.2, 0.84, { 0, 0, 0 }, 0 }, IN_SPACE, 0, { 2, 8, 7, 2, 515612,
          22896, { 0.1003861, 0.0020966639, 491088.5, 1.5296897, 257424.43 } } },
        { { "diamond", "rows", 3, 0.84, { 0, 0, 0 }, 0 }, IN_SPACE, 0, { 1, 4, 3, 0, 241194,
          26016, { 1.8692424e-15, 0, 20703.649, 0, 0 } } },
        { { "inverted-triangle", "rows", 3, 0.84, { 0, 0, 0 }, 0 }, IN_SPACE, 0, { 2, 7, 6, 0, 233718,
          15952, { 0.059190412, 0.019472027, 15132.461, 1.8075785, 726.51306 } } },
        { { "h-model", "mu", 0.84, 0.84, { 0, 0, 0 }, 0 }, IN_SPACE, 0, { 1, 2, 1, 0, 14988,
          5680, { 1.1902347e-16, 0, 931.49114, 0, 0 } } },
        { { "cantilever", "reach", 1.5, 0.84, { 0, 0, 0 }, 0 }, TOGETHER, 0, { 2, 5, 4, 0, 44558,
          6608, { 0.49116707, 0.073978487, 8374.5695, 1.5467708, 2071.1645 } } },
        { { "overhang", "factor", 1.1, 0.84, { 0, 0, 0 }, 0 }, TOGETHER, 0, { 2, 5, 4, 0, 105217,
          12752, { 0.099503217, 0.013228464, 26153.065, 1.1499402, 2225.3216 } } },
        { { "keystone", "angle", 20, 0.3, { 0, 0, 0 }, 0 }, TOGETHER, 0, { 2, 4, 3, 0, 24530,
          5680, { 1, 0.5, 0, 0.68331507, 4300.909 } } },
        { { "incline", "turn", 30, 0.84, { 0, 0, 0 }, 0 }, TOGETHER, 0, { 1, 1, 0, 0, 5313,
          4608, { 4.050314e-17, 0, 2359.0959, 0, 0 } } }
    };
    COMPARE(rows);
}

TEST(checks_of_other_accuracy_take_the_work_written_here)
{
    static const count rows[] = {
        { { "arch", "n", 5, 0.84, { 0, 0, 0 }, 0 }, FINE, 0, { 1, 3, 2, 0, 20111,
          13824, { 6.6282393e-16, 0, 2362.6245, 0, 0 } } },
        { { "keystone", "angle", 20, 0.84, { 0, 0, 0 }, 0 }, FINE, 0, { 1, 3, 2, 0, 4997,
          6032, { 3.9442651e-16, 0, 6073.5918, 0, 0 } } },
        { { "two-cubes", "offset", 0.6, 0.84, { 0, 0, 0 }, 0 }, FINE, 0, { 2, 6, 4, 0, 4832,
          4784, { 0.19493987, 0.047783903, 20803.046, 1.1224972, 2941.995 } } },
        { { "h-model", "mu", 0.84, 0.84, { 0, 0, 0 }, 0 }, FINE, 0, { 1, 2, 1, 0, 4316,
          6032, { 2.1689805e-16, 0, 931.49114, 0, 0 } } },
        { { "arch", "n", 5, 0.84, { 0, 0, 0 }, 0 }, LESS_BOUND, 0, { 1, 3, 2, 0, 20111,
          13824, { 6.6558095e-16, 0, 2362.6245, 0, 0 } } },
        { { "keystone", "angle", 20, 0.3, { 0, 0, 0 }, 0 }, LESS_BOUND, 0, { 2, 5, 3, 0, 7437,
          6032, { 1, 0.5, 0, 0.68331507, 4300.909 } } },
        { { "h-model", "mu", 0.84, 0.84, { 0, 0, 0 }, 0 }, LESS_BOUND, 0, { 1, 2, 1, 0, 4316,
          6032, { 2.1773181e-16, 0, 931.49114, 0, 0 } } },
        { { "incline", "angle", 45, 0.84, { 0, 0, 0 }, 0 }, LESS_BOUND, 0, { 2, 7, 5, 0, 7229,
          4784, { 0.044481196, 0.043205987, 2358.5695, 0.71414284, 133.37753 } } },
        { { "two-cubes", "offset", 0.6, 0.84, { 0, 0, 0 }, 0 }, NO_HELP, 0, { 2, 2, 1, 0, 3000,
          4784, { 0.19611495, 0.047871791, 20803.046, 1.1224972, 0 } } },
        { { "tower", "lean", 0.2, 0.84, { 0, 0, 0 }, 0 }, NO_HELP, 0, { 2, 5, 4, 2, 149669,
          22896, { 0.1003861, 0.0020966639, 491088.5, 1.5296897, 0 } } },
        { { "keystone", "angle", 20, 0.3, { 0, 0, 0 }, 0 }, NO_HELP, 0, { 2, 1, 0, 0, 3949,
          6032, { 1, 0.5, 0, 0.68331507, 0 } } },
        { { "inverted-triangle", "rows", 3, 0.84, { 0, 0, 0 }, 0 }, NO_HELP, 0, { 2, 4, 3, 0, 53588,
          15952, { 0.059190412, 0.019470922, 15132.461, 1.8075786, 0 } } }
    };
    COMPARE(rows);
}

TEST(checks_with_pyramids_take_the_work_written_here)
{
    static const count rows[] = {
        { { "arch", "n", 5, 0.84, { 0, 0, 0 }, 0 }, IN_4, 0, { 1, 3, 2, 0, 20111,
          14080, { 4.6967847e-16, 0, 2362.6245, 0, 0 } } },
        { { "incline", "turn", 30, 0.84, { 0, 0, 0 }, 0 }, IN_4, 0, { 1, 1, 0, 0, 5313,
          4704, { 4.050314e-17, 0, 2359.0959, 0, 0 } } },
        { { "incline", "angle", 45, 0.84, { 0, 0, 0 }, 0 }, IN_4, 0, { 2, 6, 4, 0, 6908,
          4880, { 0.12536286, 0.12311308, 2298.6466, 0.71414284, 174.21848 } } },
        { { "keystone", "angle", 20, 0.84, { 0, 0, 0 }, 0 }, IN_4, 0, { 1, 2, 1, 0, 4316,
          6160, { 6.8663502e-16, 0, 11195.18, 0, 0 } } },
        { { "inverted-triangle", "rows", 3, 0.84, { 0, 0, 0 }, 0 }, IN_4, 0, { 2, 8, 6, 0, 76456,
          16240, { 0.082277196, 0.025939136, 15200.828, 1.9850287, 901.95911 } } },
        { { "arch", "n", 5, 0.84, { 0, 0, 0 }, 0 }, AROUND_8, 0, { 1, 3, 2, 0, 20111,
          14912, { 8.8073666e-16, 0, 2362.6245, 0, 0 } } },
        { { "incline", "angle", 45, 0.84, { 0, 0, 0 }, 0 }, AROUND_8, 0, { 2, 7, 5, 0, 7229,
          5072, { 0.044481196, 0.043205987, 2358.5695, 0.71414284, 133.37753 } } },
        { { "keystone", "angle", 20, 0.3, { 0, 0, 0 }, 0 }, AROUND_8, 0, { 2, 5, 3, 0, 7437,
          6480, { 1, 0.5, 0, 0.68331507, 4300.909 } } },
        { { "tower", "lean", 0.2, 0.84, { 0, 0, 0 }, 0 }, AROUND_8, 0, { 2, 9, 7, 2, 179193,
          24624, { 0.1003861, 0.0020966639, 491088.5, 1.5296897, 257424.43 } } },
        { { "incline", "turn", 30, 0.84, { 0, 0, 0 }, 0 }, IN_16, 0, { 1, 1, 0, 0, 5313,
          5280, { 4.050314e-17, 0, 2359.0959, 0, 0 } } },
        { { "flat-arch", "n", 4, 0.84, { 0, 0, 0 }, 0 }, IN_16, 0, { 1, 4, 3, 0, 27664,
          14080, { 6.3617145e-16, 0, 7998.6273, 0, 0 } } },
        { { "h-model", "mu", 0.84, 0.84, { 0, 0, 0 }, 0 }, IN_16, 0, { 1, 2, 1, 0, 4316,
          7120, { 1.5869796e-16, 0, 942.23346, 0, 0 } } }
    };
    COMPARE(rows);
}

TEST(checks_by_other_stages_take_the_work_written_here)
{
    static const count rows[] = {
        { { "two-cubes", "offset", 0.3, 0.84, { 0, 0, 0 }, 0 }, LEAST_SQUARES, 0, { 1, 1, 0, 0, 3283,
          4512, { 9.4617805e-17, 0, 12803.181, 0, 0 } } },
        { { "arch", "n", 5, 0.84, { 0, 0, 0 }, 0 }, LEAST_SQUARES, 0, { 0, 1, 0, 0, 22991,
          13248, { 0.076121962, 0, 2339.42, 0, 0 } } },
        { { "two-cubes", "offset", 0.6, 0.84, { 0, 0, 0 }, 0 }, LEAST_SQUARES, 0, { 0, 1, 0, 0, 3643,
          4512, { 0.19611495, 0, 20803.046, 0, 0 } } },
        { { "two-cubes", "offset", 0.3, 0.84, { 0, 0, 0 }, 0 }, DENSE, 0, { 1, 1, 0, 0, 3264,
          4688, { 9.4617805e-17, 0, 12803.181, 0, 0 } } },
        { { "arch", "n", 5, 0.84, { 0, 0, 0 }, 0 }, DENSE, 0, { 0, 1, 0, 0, 32256,
          16976, { 0.076121962, 0, 2339.42, 0, 0 } } },
        { { "wall", "rows", 2, 0, { 0, 0, 0 }, 0 }, DENSE, 0, { 1, 1, 0, 0, 532224,
          93488, { 7.3407163e-16, 0, 1129.7261, 0, 0 } } },
        { { "two-cubes", "offset", 0.3, 0.84, { 0, 0, 0 }, 0 }, POLISH, 0, { 1, 1, 0, 0, 3987,
          4512, { 9.4617805e-17, 0, 12803.181, 0, 0 } } },
        { { "keystone", "angle", 20, 0.84, { 0, 0, 0 }, 0 }, POLISH, 0, { 1, 1, 171, 0, 140363,
          5488, { 2.3842418e-10, 0, 6073.5918, 0, 0 } } },
        { { "two-cubes", "offset", 0.6, 0.84, { 0, 0, 0 }, 0 }, POLISH, 0, { 0, 1, 250, 0, 110347,
          4512, { 0.19611495, 0, 20803.046, 0, 0 } } }
    };
    COMPARE(rows);
}

TEST(checks_by_programs_take_the_work_written_here)
{
    static const count rows[] = {
        { { "two-cubes", "offset", 0.3, 0.84, { 0, 0, 0 }, 0 }, BY_ADMM, 0, { 1, 4, 100, 0, 938742,
          21728, { 7.4801943e-17, 0, 12803.181, 0, 0 } } },
        { { "two-cubes", "offset", 0.6, 0.84, { 0, 0, 0 }, 0 }, BY_ADMM, 0, { 0, 12, 103, 0, 978188,
          21728, { 0.19611495, 0, 20803.046, 1.1226763, 2941.995 } } },
        { { "incline", "angle", 20, 0.84, { 0, 0, 0 }, 0 }, BY_ADMM, 0, { 1, 4, 100, 0, 417294,
          22688, { 1.3875881e-17, 0, 2359.0959, 0, 0 } } },
        { { "two-cubes", "offset", 0.3, 0.84, { 0, 0, 0 }, 0 }, NET, 0, { 1, 4, 100, 0, 437302,
          23008, { 8.4365175e-17, 0, 12803.181, 0, 0 } } },
        { { "two-cubes", "offset", 0.6, 0.84, { 0, 0, 0 }, 0 }, NET, 0, { 2, 43, 140, 0, 607223,
          23008, { 1, 0.047871791, 0, 1.1224972, 0 } } },
        { { "two-cubes", "offset", 0.3, 0.84, { 0, 0, 0 }, 0 }, SEEDED, 0, { 1, 1, 0, 0, 5281,
          4640, { 9.4618301e-17, 0, 12803.181, 0, 0 } } },
        { { "incline", "angle", 20, 0.84, { 0, 0, 0 }, 0 }, SEEDED, 0, { 1, 1, 0, 0, 5281,
          4640, { 4.1627644e-17, 0, 2359.0959, 0, 0 } } },
        { { "keystone", "angle", 20, 0.84, { 0, 0, 0 }, 0 }, SEEDED, 0, { 1, 2, 133, 0, 119332,
          5616, { 9.6972398e-07, 0, 6800.1295, 0, 0 } } }
    };
    COMPARE(rows);
}

TEST(glued_and_crushed_checks_take_the_work_written_here)
{
    static const count rows[] = {
        { { "two-cubes", "offset", 0.6, 0.84, { 0, 0, 0 }, 1 }, PLANNED, 0, { 2, 6, 4, 0, 7708,
          5648, { 0.19611495, 0.047871791, 20803.046, 1.1224972, 2941.995 } } },
        { { "two-cubes", "offset", 0.6, 0.84, { 0, 0, 0 }, 3 }, PLANNED, 0, { 1, 1, 0, 0, 1476,
          5648, { 1.3663065e-16, 0, 21215.028, 0, 0 } } },
        { { "two-cubes", "offset", 0.6, 0.84, { 0, 0, 0 }, 7 }, PLANNED, 0, { 1, 1, 0, 0, 1476,
          5648, { 1.3663065e-16, 0, 21215.028, 0, 0 } } },
        { { "incline", "angle", 45, 0.84, { 0, 0, 0 }, 1 }, PLANNED, 0, { 1, 1, 0, 0, 1476,
          5648, { 2.4299743e-16, 0, 2377.0154, 0, 0 } } },
        { { "keystone", "angle", 20, 0.3, { 0, 0, 0 }, 1 }, PLANNED, 0, { 1, 2, 1, 0, 5736,
          7216, { 9.903326e-17, 0, 2213.8139, 0, 0 } } },
        { { "inverted-triangle", "rows", 3, 0.84, { 0, 0, 0 }, 2 }, PLANNED, 0, { 2, 8, 6, 0, 95272,
          18976, { 0.059190412, 0.019470922, 15132.461, 1.8075786, 726.51306 } } },
        { { "inverted-triangle", "rows", 3, 0.84, { 0, 0, 0 }, 7 }, PLANNED, 0, { 1, 2, 1, 0, 26704,
          18976, { 1.8310117e-15, 0, 14328.206, 0, 0 } } },
        { { "tower", "lean", 0.2, 0.84, { 0, 0, 0 }, 4 }, PLANNED, 0, { 2, 42, 40, 0, 1581948,
          27072, { 0.1550138, 0.008540577, 374581.94, 1.5427495, 0 } } },
        { { "arch", "n", 5, 0.84, { 0, 0, 0 }, 4 }, PLANNED, 0, { 1, 3, 2, 0, 26897,
          16480, { 6.5686798e-16, 0, 2362.6245, 0, 0 } } },
        { { "flat-arch", "n", 4, 0.84, { 0, 0, 0 }, 5 }, PLANNED, 0, { 1, 4, 3, 0, 37448,
          14032, { 5.6330484e-16, 0, 7900.6652, 0, 0 } } },
        { { "overhang", "factor", 1.1, 0.84, { 0, 0, 0 }, 3 }, PLANNED, 0, { 1, 1, 0, 0, 9004,
          15088, { 1.3310627e-15, 0, 26194.923, 0, 0 } } },
        { { "cantilever", "reach", 1.5, 0.84, { 0, 0, 0 }, 6 }, PLANNED, 0, { 2, 6, 4, 0, 18216,
          7872, { 0.49116707, 0.073978487, 8374.5695, 1.5467708, 2071.1645 } } },
        { { "keystone", "angle", 20, 0.3, { 0, 0, 0 }, 1 }, IN_SPACE, 0, { 1, 2, 1, 0, 14988,
          6864, { 2.4758315e-16, 0, 2213.8139, 0, 0 } } },
        { { "inverted-triangle", "rows", 3, 0.84, { 0, 0, 0 }, 3 }, IN_SPACE, 0, { 1, 2, 1, 0, 68336,
          18976, { 1.1546224e-15, 0, 14328.206, 0, 0 } } },
        { { "arch", "n", 5, 0.84, { 0, 0, 0 }, 4 }, IN_SPACE, 0, { 1, 3, 2, 0, 70203,
          16480, { 3.8160638e-16, 0, 2362.6245, 0, 0 } } },
        { { "incline", "angle", 45, 0.84, { 0, 0, 0 }, 1 }, IN_4, 0, { 1, 1, 0, 0, 1476,
          4880, { 2.4299743e-16, 0, 2377.0154, 0, 0 } } },
        { { "arch", "n", 5, 0.84, { 0, 0, 0 }, 5 }, IN_4, 0, { 1, 2, 1, 0, 21312,
          14080, { 8.7024952e-16, 0, 2358.474, 0, 0 } } }
    };
    COMPARE(rows);
}

TEST(budgets_end_checks_where_written_here)
{
    static const count rows[] = {
        { { "arch", "n", 5, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 30, { 0, 1, 0, 0, 5904,
          13824, { 1, 0, 0, 0, 0 } } },
        { { "arch", "n", 5, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 60, { 0, 3, 2, 0, 11757,
          13824, { 1, 0, 0, 0, 0 } } },
        { { "arch", "n", 5, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 90, { 0, 4, 3, 0, 15104,
          13824, { 1, 0, 0, 0, 1.1601217 } } },
        { { "keystone", "angle", 20, 0.3, { 0, 0, 0 }, 0 }, PLANNED, 30, { 0, 2, 1, 0, 2019,
          6032, { 1, 0, 0, 0, 0 } } },
        { { "keystone", "angle", 20, 0.3, { 0, 0, 0 }, 0 }, PLANNED, 60, { 0, 4, 3, 0, 3488,
          6032, { 1, 0, 0, 0, 4300.909 } } },
        { { "keystone", "angle", 20, 0.3, { 0, 0, 0 }, 0 }, PLANNED, 90, { 0, 4, 3, 0, 3488,
          6032, { 1, 0, 0, 0, 4300.909 } } },
        { { "inverted-triangle", "rows", 3, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 30, { 0, 4, 3, 0, 19956,
          15952, { 1, 0, 0, 0, 726.51306 } } },
        { { "inverted-triangle", "rows", 3, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 60, { 0, 4, 2, 0, 43238,
          16624, { 0.30723451, 0, 14015.701, 1.2340529, 0 } } },
        { { "inverted-triangle", "rows", 3, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 90, { 2, 7, 5, 0, 65599,
          16624, { 0.059190412, 0.019471529, 15132.461, 1.8075785, 0 } } },
        { { "inverted-triangle", "rows", 3, 0.84, { 0, 0, 0 }, 2 }, PLANNED, 30, { 0, 2, 1, 0, 27426,
          19648, { 1, 0, 0, 0, 0 } } },
        { { "inverted-triangle", "rows", 3, 0.84, { 0, 0, 0 }, 2 }, PLANNED, 60, { 0, 5, 3, 0, 57105,
          19648, { 0.059190412, 0, 15132.461, 1.3047504, 0 } } },
        { { "inverted-triangle", "rows", 3, 0.84, { 0, 0, 0 }, 2 }, PLANNED, 90, { 2, 6, 4, 0, 83617,
          19648, { 0.059190412, 0.019470922, 15132.461, 1.8075786, 0 } } }
    };
    COMPARE(rows);
}

TEST(coupled_checks_take_the_work_written_here)
{
    static const count rows[] = {
        { { "two-cubes", "offset", 0.3, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 0, { 11, 1, 0, 0, 3609,
          332496, { 1.110223e-16, 0, 12803.181, 8.5e-05, 0 } } },
        { { "two-cubes", "offset", 0.6, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 0, { 22, 32, 25, 0, 89614,
          332496, { 0.19611495, 0.047871791, 20803.046, 0.00099087714, 2941.995 } } },
        { { "arch", "n", 5, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 0, { 11, 11, 6, 0, 72483,
          9974016, { 1.8473738e-16, 0, 2362.6245, 0.00051845712, 0 } } },
        { { "keystone", "angle", 20, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 0, { 22, 1122, 1101, 0, 27700664,
          2543264, { 3.9613304e-16, 0, 6073.5918, 0.00030487802, 4300.909 } } },
        { { "flat-arch", "n", 4, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 0, { 11, 15, 10, 0, 87399,
          9929808, { 1.4947523e-16, 0, 9083.7542, 0.0004735439, 0 } } },
        { { "h-model", "mu", 0.84, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 0, { 22, 7260, 7186, 0, 41302688,
          2543264, { 2.1773181e-16, 0, 931.49114, 0.00055792974, 136.41358 } } },
        { { "diamond", "rows", 3, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 0, { 11, 11, 6, 0, 186398,
          42448, { 2.4462976e-16, 0, 21365.274, 0.00050072802, 0 } } },
        { { "two-cubes", "offset", 0.3, 0.84, { 0, 0, 0 }, 0 }, COUPLED_8, 0, { 11, 1, 0, 0, 3609,
          332624, { 1.110223e-16, 0, 12803.181, 8.5e-05, 0 } } },
        { { "keystone", "angle", 20, 0.84, { 0, 0, 0 }, 0 }, COUPLED_8, 0, { 22, 1122, 1101, 0, 22818488,
          2543392, { 3.9613304e-16, 0, 6073.5918, 0.00030487802, 4300.909 } } }
    };
    COMPARE(rows);
}

TEST(coupled_checks_of_other_lengths_take_the_work_written_here)
{
    static const count rows[] = {
        { { "two-cubes", "offset", 0.3, 0.84, { 0, 0, 0 }, 0 }, COUPLED_TREE, 0, { 11, 1, 0, 0, 1929,
          332496, { 1.110223e-16, 0, 12803.181, 0, 0 } } },
        { { "h-model", "mu", 0.84, 0.84, { 0, 0, 0 }, 0 }, COUPLED_TREE, 0, { 11, 11, 7, 0, 19817,
          2543264, { 1.5426005e-16, 0, 931.49114, 0.0021875, 0 } } },
        { { "keystone", "angle", 20, 0.84, { 0, 0, 0 }, 0 }, COUPLED_BOX, 0, { 22, 1122, 1101, 0, 19256480,
          2543264, { 3.9613304e-16, 0, 6073.5918, 0.00030487802, 4300.909 } } },
        { { "keystone", "angle", 20, 0.84, { 0, 0, 0 }, 0 }, COUPLED_SOFT, 0, { 22, 2419, 1650, 0, 8932843,
          2543264, { 3.9613304e-16, 0, 6073.5918, 0, 0 } } },
        { { "h-model", "mu", 0.84, 0.84, { 0, 0, 0 }, 0 }, COUPLED_SOFT, 0, { 22, 3692, 3491, 0, 11817906,
          2543264, { 2.1773181e-16, 0, 931.49114, 0, 0 } } },
        { { "h-model", "mu", 0.84, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 40, { 30, 1236, 1218, 0, 16520992,
          2543456, { 2.1773181e-16, 0, 931.49114, 0, 0 } } },
        { { "keystone", "angle", 20, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 40, { 30, 1108, 1090, 0, 11080189,
          2543456, { 3.9613304e-16, 0, 6073.5918, 0, 0 } } },
        { { "keystone", "angle", 20, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 80, { 30, 1108, 1091, 0, 22160528,
          2543456, { 3.9613304e-16, 0, 6073.5918, 0, 0 } } }
    };
    COMPARE(rows);
}

TEST(coupled_trees_and_rings_take_the_work_written_here)
{
    static const count rows[] = {
        { { "tower", "n", 3, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 0, { 11, 1, 0, 0, 11485,
          8534896, { 6.1433301e-16, 0, 45182.026, 0.0003718064, 0 } } },
        { { "incline", "turn", 30, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 0, { 11, 1, 0, 0, 7713,
          332496, { 4.2754456e-17, 0, 2359.8236, 0.00014142136, 0 } } },
        { { "incline", "angle", 40, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 0, { 11, 2, 1, 0, 4632,
          332496, { 1.7554167e-16, 0, 2386.5087, 0.00014142136, 0 } } },
        { { "overhang", "n", 3, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 0, { 11, 1, 0, 0, 11485,
          8534896, { 9.0205621e-16, 0, 12064.024, 0.00033108628, 0 } } },
        { { "cantilever", "reach", 1.2, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 0, { 11, 1, 0, 0, 7547,
          2550992, { 1.9535892e-16, 0, 5351.5204, 0.00017197384, 0 } } },
        { { "incline", "angle", 20, 0.84, { 0, 0, 0 }, 0 }, COUPLED_8, 0, { 11, 1, 0, 0, 3609,
          332624, { 6.2063354e-17, 0, 2359.8236, 0.00014142136, 0 } } },
        { { "overhang", "factor", 0.99, 0.84, { 0, 0, 0 }, 0 }, COUPLED_BOX, 0, { 11, 1, 0, 0, 19361,
          9942832, { 1.8277104e-15, 0, 24541.353, 0.00069840481, 0 } } },
        { { "topple", "angle", 10, 0.84, { 0, 0, 0 }, 0 }, COUPLED_TREE, 0, { 11, 1, 0, 0, 3609,
          332496, { 1.2794254e-15, 0, 3600.1404, 0.003125, 0 } } },
        { { "inverted-triangle", "rows", 2, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 0, { 11, 1, 0, 0, 11485,
          8534896, { 9.3521724e-16, 0, 6364.5083, 0.0001844662, 0 } } },
        { { "inverted-triangle", "rows", 2, 0.84, { 0, 0, 0 }, 0 }, COUPLED_SOFT, 0, { 11, 1, 0, 0, 11485,
          8534896, { 9.3521724e-16, 0, 6364.5083, 0.00017500071, 0 } } },
        { { "keystone", "angle", -10, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 0, { 11, 10, 5, 0, 20384,
          2543264, { 2.220446e-16, 0, 2714.4423, 0.00029015948, 0 } } },
        { { "keystone", "angle", -10, 0.3, { 0, 0, 0 }, 0 }, COUPLED_8, 0, { 11, 10, 5, 0, 20384,
          2543392, { 2.0543079e-16, 0, 4630.0272, 0.00029015948, 0 } } },
        { { "two-cubes", "offset", 0.45, 0.84, { 0, 0, 0 }, 0 }, COUPLED_BOX, 0, { 11, 1, 0, 0, 3609,
          332496, { 1.6653345e-16, 0, 15204.947, 7.75e-05, 0 } } },
        { { "arch", "n", 3, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 50, { 30, 6, 4, 0, 24712,
          9891280, { 8.8886213e-16, 0, 1535.2356, 0, 0 } } },
        { { "arch", "n", 3, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 0, { 11, 13, 8, 0, 49465,
          9890896, { 7.0145672e-17, 0, 2071.3321, 0.00039012165, 0 } } },
        { { "flat-arch", "n", 2, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 70, { 30, 10, 7, 0, 28308,
          8525648, { 1.4135164e-15, 0, 7029.8917, 0, 0 } } },
        { { "flat-arch", "n", 2, 0.84, { 0, 0, 0 }, 0 }, COUPLED_BOX, 0, { 11, 14, 9, 0, 40608,
          8525360, { 1.9620938e-16, 0, 7617.0885, 0.00020332722, 0 } } },
        { { "tower", "n", 3, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 50, { 30, 1, 0, 0, 3851,
          8470144, { 1, 0, 0, 0, 0 } } }
    };
    COMPARE(rows);
}

TEST(coupled_searches_in_space_and_rounds_take_the_work_written_here)
{
    static const count rows[] = {
        { { "arch", "n", 4, 0.84, { 0, 0, 0 }, 0 }, COUPLED_WIDE, 0, { 11, 14, 9, 0, 241996,
          9929808, { 9.5867264e-17, 0, 2112.7124, 0.00059372496, 0 } } },
        { { "flat-arch", "n", 3, 0.84, { 0, 0, 0 }, 0 }, COUPLED_WIDE, 0, { 11, 12, 7, 0, 162630,
          9890896, { 1.4445766e-16, 0, 8485.6973, 0.00033139885, 0 } } },
        { { "diamond", "rows", 3, 0.84, { 0, 0, 0 }, 0 }, COUPLED_WIDE, 0, { 11, 11, 6, 0, 622287,
          42448, { 6.6899068e-17, 0, 21365.274, 0.00050072802, 0 } } },
        { { "keystone", "angle", 20, 0.84, { 0, 0, 0 }, 0 }, COUPLED_WIDE, 0, { 22, 1130, 1105, 0, 89914492,
          2543264, { 2.9642968e-16, 0, 6073.5918, 0.00030487802, 4300.909 } } },
        { { "keystone", "angle", 15, 0.5, { 0, 0, 0 }, 0 }, COUPLED_WIDE, 0, { 22, 1002, 977, 0, 76938192,
          2543264, { 2.4789255e-16, 0, 10376.6, 0.0003048427, 5683.4979 } } },
        { { "dome", "segments", 3, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 0, { 11, 52, 43, 0, 9745872,
          133104, { 6.8121971e-15, 0, 3396.6884, 0.0061587543, 0 } } },
        { { "vault", "around", 3, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 0, { 11, 33, 26, 0, 4788420,
          105584, { 3.8753965e-13, 0, 4464.1862, 0.00085714774, 0 } } },
        { { "rubble", "rows", 1, 0.84, { 0, 0, 0 }, 0 }, COUPLED_WIDE, 0, { 11, 14, 9, 0, 445436,
          10183344, { 1.2440553e-16, 0, 1483.5468, 9.6700225e-05, 0 } } },
        { { "wall", "rows", 2, 0.84, { 0, 0, 0 }, 0 }, COUPLED_WIDE, 0, { 11, 12, 7, 0, 1580910,
          97808, { 8.6436457e-17, 0, 1129.7261, 0.00014627166, 0 } } },
        { { "arch", "n", 2, 0.84, { 0, 0, 0 }, 0 }, COUPLED_WIDE, 0, { 11, 13, 8, 0, 111482,
          8525360, { 2.2736283e-16, 0, 1583.7274, 0.00043750073, 0 } } },
        { { "flat-arch", "n", 2, 0.4, { 0, 0, 0 }, 0 }, COUPLED_WIDE, 0, { 11, 14, 9, 0, 151228,
          8525360, { 1.675229e-16, 0, 7617.0885, 0.00020332722, 0 } } },
        { { "incline", "turn", 30, 0.84, { 0, 0, 0 }, 0 }, COUPLED_WIDE, 0, { 11, 1, 0, 0, 7713,
          332496, { 4.2754456e-17, 0, 2359.8236, 0.00014142136, 0 } } },
        { { "arch", "n", 4, 0.84, { 0, 0, 0 }, 0 }, ROUNDS, 0, { 11, 7, 3, 0, 75072,
          9929808, { 5.3052279e-16, 0, 2112.7124, 0.00023638941, 0 } } },
        { { "flat-arch", "n", 3, 0.84, { 0, 0, 0 }, 0 }, ROUNDS, 0, { 11, 5, 1, 0, 52171,
          9890896, { 5.8305129e-16, 0, 7042.8729, 0.00029554506, 0 } } },
        { { "diamond", "rows", 3, 0.84, { 0, 0, 0 }, 0 }, ROUNDS, 0, { 11, 54, 63, 0, 4486015,
          295264, { 1.517883e-16, 0, 21656.295, 0.00050072802, 0 } } },
        { { "h-model", "mu", 0.84, 0.84, { 0, 0, 0 }, 0 }, ROUNDS, 0, { 22, 6033, 5981, 0, 40011961,
          2551792, { 2.1773181e-16, 0, 931.49114, 0.00055792974, 136.41358 } } },
        { { "incline", "angle", 35, 0.84, { 0, 0, 0 }, 0 }, ROUNDS, 0, { 11, 6, 0, 0, 13544,
          340544, { 7.1291293e-17, 0, 2370.2001, 0.00014135073, 0 } } },
        { { "overhang", "n", 3, 0.84, { 0, 0, 0 }, 0 }, ROUNDS, 0, { 11, 6, 0, 0, 49138,
          8534896, { 9.5939624e-17, 0, 12064.024, 0.00031985974, 0 } } },
        { { "cantilever", "reach", 1.2, 0.84, { 0, 0, 0 }, 0 }, ROUNDS, 0, { 11, 6, 0, 0, 31341,
          2556304, { 1.7488594e-16, 0, 5351.5204, 0.00014534442, 0 } } },
        { { "flat-arch", "n", 2, 0.4, { 0, 0, 0 }, 0 }, ROUNDS, 0, { 11, 6, 2, 0, 43883,
          8530592, { 4.11683e-16, 0, 7029.8917, 0.00020279281, 0 } } },
        { { "inverted-triangle", "rows", 2, 0.84, { 0, 0, 0 }, 0 }, ROUNDS, 0, { 11, 44, 0, 0, 266572,
          8534896, { 8.9063831e-14, 0, 6364.5083, 0.000175, 0 } } },
        { { "wall", "rows", 2, 0.84, { 0, 0, 0 }, 0 }, ROUNDS, 0, { 30, 153, 20, 0, 14282902,
          826272, { 8.1636297e-16, 0, 1129.7261, 0.0001556916, 1.1478761e-14 } } }
    };
    COMPARE(rows);
}

TEST(alternations_take_the_work_written_here)
{
    static const count rows[] = {
        { { "two-cubes", "offset", 0.3, 0.84, { 0, 0, 0 }, 0 }, ROUNDS, 0, { 11, 4, 0, 0, 10538,
          339584, { 1.110223e-16, 0, 12803.181, 8.5e-05, 0 } } },
        { { "keystone", "angle", 20, 0.84, { 0, 0, 0 }, 0 }, ROUNDS, 0, { 22, 31, 59, 0, 26829199,
          2553712, { 3.9613304e-16, 0, 6073.5918, 0.00030487802, 4300.909 } } }
    };
    COMPARE(rows);
}

/* kind: the verdict and its reason; iterations: starts that were tried. */
TEST(strong_verdicts_take_the_work_written_here)
{
    static const struct { tally_scene of; tally is; } rows[] = {
        { { "two-cubes", "offset", 0.3, 0.84, { 0, 0, 0 }, 0 }, { 14, 0, 0, 0, 2880,
          1017920, { 1.110223e-16, 0, 0, 12803.181, 0 } } },
        { { "incline", "angle", 20, 0.84, { 0, 0, 0 }, 0 }, { 64, 0, 0, 0, 3240,
          1017920, { 0, 0, 0.99999999, 2359.0959, 0 } } },
        { { "keystone", "angle", 20, 0.84, { 0, 0, 0 }, 0 }, { 22, 0, 22, 0, 2701920,
          21531552, { 0, 1, 0, 6073.5918, 9.80665 } } },
        { { "h-model", "mu", 0.84, 0.84, { 0, 0, 0 }, 0 }, { 22, 0, 22, 0, 2898720,
          21531552, { 0, 1, 0, 931.49114, 9.80665 } } },
        { { "flat-arch", "n", 2, 0.84, { 0, 0, 0 }, 0 }, { 53, 0, 28, 0, 20411868,
          21556960, { 0, 0, 1.916173e-11, 7029.8917, 0 } } },
        { { "keystone", "angle", -10, 0.84, { 0, 0, 0 }, 0 }, { 53, 0, 28, 0, 6138492,
          21531552, { 0, 0, 4.6137903e-11, 2714.4423, 0 } } },
        { { "cantilever", "reach", 1.2, 0.84, { 0, 0, 0 }, 0 }, { 14, 0, 0, 0, 7920,
          21536256, { 1.9535892e-16, 0, 0, 5351.5204, 0 } } },
        { { "inverted-triangle", "rows", 2, 0.84, { 0, 0, 0 }, 0 }, { 14, 0, 0, 0, 9720,
          21563472, { 9.1550583e-16, 0, 0, 6364.5083, 0 } } }
    };
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        const sp_scene s = tally_make(&rows[k].of);
        sp_strong_settings how = sp_strong_settings_default();
        sp_strong_result x;
        sp_result r;
        how.starts = 6;
        CHECK_INT(sp_check(&s, NULL, &test_arena, &r), SP_OK);
        CHECK_INT(sp_strong(&s, NULL, &how, r.f, NULL, &test_arena, &x), SP_OK);
        sp_cost cost = x.cost;
        cost.iterations = x.starts;
        const double found[] = { (double)x.residual, (double)x.moves, (double)x.margin,
                                 tally_size(x.f, 3 * (size_t)s.count.points), tally_size(x.a, 6 * (size_t)s.count.blocks) };
        tally_compare(rows[k].of.name, k, &rows[k].is, (int)x.kind + 10 * (int)x.reason, &cost, x.peak_bytes, found);
    }
}

TEST(sliding_limits_take_the_work_written_here)
{
    static const struct { tally_scene of; tally is; } rows[] = {
        { { "two-cubes", "offset", 0.3, 0.84, { 1, 0, 0 }, 0 }, { 1, 0, 0, 0, 43242,
          10920, { 0.4, 0.4, 0.92847669, 17924.453, 0.90357938 } } },
        { { "arch", "n", 5, 0.84, { 1, 0, 0 }, 0 }, { 1, 0, 0, 0, 757664,
          59864, { 0, 0, 0.89036664, 2579.9183, 0.94225615 } } },
        { { "tower", "n", 4, 0.84, { 1, 0, 0 }, 0 }, { 1, 0, 0, 0, 505288,
          41760, { 0.15, 0.15, 0.97452198, 85801.407, 0.99661462 } } },
        { { "incline", "angle", 20, 0.84, { 1, 0, 0 }, 0 }, { 1, 0, 0, 0, 85126,
          10920, { 0, 0, 0.93969262, 2540.2328, 0.50990195 } } },
        { { "flat-arch", "n", 4, 0.84, { 1, 0, 0 }, 0 }, { 10, 0, 0, 0, 7782924,
          46176, { 0, 0, 0, 0, 0 } } },
        { { "diamond", "rows", 3, 0.84, { 1, 0, 0 }, 0 }, { 1, 0, 0, 0, 3484668,
          140728, { 0, 0, 0.54734398, 29818.092, 0.96847713 } } },
        { { "keystone", "angle", 10, 0.5, { 1, 0, 0 }, 0 }, { 1, 0, 0, 0, 6780604,
          15320, { 0, 0, 0.17364818, 12357.32, 0.59573941 } } },
        { { "cantilever", "reach", 1, 0.84, { 0, 0, -1 }, 0 }, { 10, 0, 0, 0, 6683546,
          19552, { 0, 0, 0, 0, 0 } } },
        { { "tower", "n", 3, 0.1, { 1, 0, 0 }, 0 }, { 1, 0, 0, 0, 307650,
          30040, { 0.1, 0.1, 1, 49828.651, 1 } } },
        { { "inverted-triangle", "rows", 2, 0.84, { 1, 0, 0.2 }, 0 }, { 1, 0, 0, 0, 215496,
          30040, { 0, 0, 0.98058068, 6364.5083, 0.9462198 } } },
        { { "overhang", "n", 3, 0.84, { 1, 0, 0 }, 0 }, { 1, 0, 0, 0, 280950,
          30040, { 0.083333333, 0.083333333, 0.69440208, 12431.662, 1.2048178 } } },
        { { "arch", "n", 7, 0.3, { 1, 0, 0 }, 0 }, { 10, 0, 0, 0, 275744,
          91656, { 0, 0, 0, 0, 0 } } }
    };
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        const sp_scene s = tally_make(&rows[k].of);
        sp_sliding_settings how = sp_sliding_settings_default();
        sp_sliding_result x;
        sp_limit_result limit;
        how.starts = 2;
        CHECK_INT(sp_limit(&s, NULL, &test_arena, &limit), SP_OK);
        CHECK_INT(sp_sliding(&s, NULL, &how, &limit, &test_arena, &x), SP_OK);
        const double found[] = { (double)x.lower, (double)x.lower_strong, (double)x.share,
                                 tally_size(x.f, 3 * (size_t)s.count.points), tally_size(x.v, 6 * (size_t)s.count.blocks) };
        tally_compare(rows[k].of.name, k, &rows[k].is, (int)x.kind + 10 * (int)x.reason, &x.cost, x.peak_bytes, found);
    }
}

/* Block after block; then what must be held, and what may come or go next. kind: steps that do not stand, stones held. */
TEST(building_takes_the_work_written_here)
{
    static const struct { tally_scene of; int backward; tally is; } rows[] = {
        { { "arch", "n", 5, 0.84, { 0, 0, 0 }, 0 }, 0, { 404, 69, 39, 0, 293369,
          20464, { 3.1363385, 0.17205206, 3117.8385, 3.6795178, -958985 } } },
        { { "diamond", "rows", 3, 0.84, { 0, 0, 0 }, 0 }, 0, { 303, 98, 62, 5, 884245,
          36944, { 0.5170982, 0.1445668, 109112.6, 5.0132129, 9000648 } } },
        { { "diamond", "rows", 3, 0.84, { 0, 0, 0 }, 0 }, 1, { 1508, 72, 28, 0, 560685,
          36944, { 8, 4, 20703.649, 9.8589883, 9158345 } } },
        { { "overhang", "n", 4, 0.84, { 0, 0, 0 }, 0 }, 0, { 0, 5, 0, 0, 24589,
          15888, { 3.30251e-15, 0, 35466.509, 0, 4000010 } } },
        { { "flat-arch", "n", 4, 0.84, { 0, 0, 0 }, 0 }, 0, { 303, 55, 35, 3, 213820,
          17648, { 1.1545297, 0.40919243, 24308.23, 2.685412, -969390 } } },
        { { "inverted-triangle", "rows", 3, 0.84, { 0, 0, 0 }, 0 }, 0, { 202, 61, 37, 5, 462884,
          23120, { 0.44115462, 0.13406034, 52223.05, 3.1612109, 4000424 } } },
        { { "cantilever", "reach", 1.2, 0.84, { 0, 0, 0 }, 0 }, 0, { 101, 7, 3, 0, 13673,
          10288, { 0.62468787, 0.16435056, 9512.1297, 1.0246951, -989897 } } },
        { { "cantilever", "reach", 1.2, 0.84, { 0, 0, 0 }, 0 }, 1, { 101, 3, 1, 0, 7445,
          10288, { 1, 0.5, 5351.5204, 1, -989797 } } },
        { { "wall", "rows", 3, 0.84, { 0, 0, 0 }, 0 }, 0, { 0, 41, 15, 0, 246223,
          128336, { 1.9707458e-13, 0, 23709.344, 0, 18000063 } } },
        { { "keystone", "angle", 20, 0.84, { 0, 0, 0 }, 0 }, 0, { 0, 2, 1, 0, 5276,
          9632, { 3.9613304e-16, 0, 6073.5918, 0, 1000001 } } }
    };
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        const sp_scene s = tally_make(&rows[k].of);
        const int32_t n = s.count.blocks;
        sp_cost cost;
        sp_sequence *q;
        sp_suggestion next;
        double found[TALLY_FOUND] = { 0 };
        int falls = 0, held = 0;
        memset(&cost, 0, sizeof cost);
        test_arena.peak = test_arena.used;
        CHECK_INT(sp_sequence_open(&s, NULL, &test_arena, &q), SP_OK);
        for (int32_t i = 0; i < n; i++) {
            const int32_t b = rows[k].backward ? n - 1 - i : i;
            sp_held hold;
            sp_step step;
            if (s.block[b].fixed == SP_FIXED) continue;
            CHECK_INT(sp_sequence_set(q, b, SP_PRESENT, &step), SP_OK);
            tally_add(&cost, &step.cost);
            found[0] += (double)step.imbalance;
            found[1] += (double)step.least_imbalance;
            found[2] += tally_size(step.f, 3 * (size_t)s.count.points);
            found[3] += tally_size(step.dq, 6 * (size_t)n);
            found[4] += step.again;
            if (step.verdict == SP_STABLE) continue;
            falls++;
            CHECK_INT(sp_sequence_hold(q, 0, &hold), SP_OK);
            tally_add(&cost, &hold.cost);
            held += hold.count;
            for (int32_t h = 0; h < hold.count; h++) found[4] += 100 * hold.block[h] + 1e4 * hold.must[h];
        }
        CHECK_INT(sp_sequence_suggest(q, 0, 0, &next), SP_OK);
        tally_add(&cost, &next.cost);
        found[4] += 1e6 * next.block;
        tally_compare(rows[k].of.name, k, &rows[k].is, falls + 100 * held, &cost, test_arena.peak, found);
    }
}

#endif

TEST_LIST(tally)
#ifdef TALLY_ALL
    RUN(planned_checks_take_the_work_written_here)
    RUN(walls_and_shells_take_the_work_written_here)
    RUN(checks_in_space_and_together_take_the_work_written_here)
    RUN(checks_of_other_accuracy_take_the_work_written_here)
    RUN(checks_with_pyramids_take_the_work_written_here)
    RUN(checks_by_other_stages_take_the_work_written_here)
    RUN(checks_by_programs_take_the_work_written_here)
    RUN(glued_and_crushed_checks_take_the_work_written_here)
    RUN(budgets_end_checks_where_written_here)
    RUN(coupled_checks_take_the_work_written_here)
    RUN(coupled_checks_of_other_lengths_take_the_work_written_here)
    RUN(coupled_trees_and_rings_take_the_work_written_here)
    RUN(coupled_searches_in_space_and_rounds_take_the_work_written_here)
    RUN(alternations_take_the_work_written_here)
    RUN(strong_verdicts_take_the_work_written_here)
    RUN(sliding_limits_take_the_work_written_here)
    RUN(building_takes_the_work_written_here)
#endif
TEST_END
