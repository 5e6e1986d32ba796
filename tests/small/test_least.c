/* Work of the smallest build, counted to the flop as check/test_tally.c counts that of the others, and the numbers it answers:
 * checks, limits, build orders. Its one search goes another way if a place of it is changed, which verdicts hardly ever tell. */
#include "../scenes/tally.h"

#if defined SP_SMALL && !defined SP_EXACT_ONLY && COUNTED
#define sp_scene_of_family least_of_family              /* host/test_kit.c holds them, too */
#define sp_scene_at least_at
#include "../../port/fuzz/families.c"

/* iterations: no more than so many; 0: the default. uneven: weights of the stones are 1 to 10^(2 uneven) times what they were.
 * held: directions in which all of them are. */
typedef struct least {
    tally_scene of;
    int iterations, uneven, held;
    tally is;
} least;

/* A sum that tells a sign and a place: every number times 1 to 5. */
static double mixed(const sp_real *x, size_t n)
{
    double sum = 0;
    for (size_t k = 0; k < n; k++) sum += (double)x[k] * (double)(1 + k % 5);
    return sum;
}

static sp_scene scene_of(const least *c)
{
    static const double weight[] = { 1, 10, 100, 1000, 10000, 100000, 1000000 };
    sp_scene s = tally_make(&c->of);
    for (int32_t b = 0; b < s.count.blocks; b++) {
        s.block[b].mass *= R(weight[b % (2 * c->uneven + 1)]);
        s.block[b].fixed |= (uint32_t)c->held;
    }
    return s;
}

static sp_cost checked(const sp_scene *s, int iterations, int *kind, size_t *bytes, double found[TALLY_FOUND])
{
    sp_settings set = sp_settings_default();
    sp_result r;
    memset(&r, 0, sizeof r);
    if (iterations) set.iterations = iterations;
    CHECK_INT(sp_check(s, &set, &test_arena, &r), SP_OK);
    *kind = (int)r.verdict + 10 * r.final;
    *bytes = r.spent.peak_bytes;
    found[0] = (double)r.imbalance;
    found[1] = (double)r.least_imbalance;
    found[2] = mixed(r.f, 3 * (size_t)s->count.points);
    found[3] = mixed(r.dq, 6 * (size_t)s->count.blocks);
    found[4] = mixed(r.y0, 12 * (size_t)r.counts.free_blocks);
    CHECK(r.spent.total.flops == r.spent.by_stage[1].flops && r.spent.by_stage[0].flops == 0);
    return r.spent.total;
}

static void compare(const least *rows, size_t n)
{
    for (size_t k = 0; k < n; k++) {
        const sp_scene s = scene_of(&rows[k]);
        double found[TALLY_FOUND];
        int kind;
        size_t bytes;
        const sp_cost cost = checked(&s, rows[k].iterations, &kind, &bytes, found);
        tally_compare(rows[k].of.name, k, &rows[k].is, kind, &cost, bytes, found);
    }
}

#define COMPARE(rows) compare(rows, sizeof (rows) / sizeof *(rows))

TEST(checks_of_the_smallest_build_take_the_work_written_here)
{
    static const least rows[] = {
        { { "two-cubes", "offset", 0.3, 0.84, { 0, 0, 0 }, 0 }, 0, 0, 0, { 1, 1, 0, 0, 23131,
          3936, { 5.2892961e-17, 0, 70607.88, 0, -18732.703 } } },
        { { "two-cubes", "offset", 0.6, 0.84, { 0, 0, 0 }, 0 }, 0, 0, 0, { 12, 2, 1, 0, 31502,
          3936, { 0.19611495, 0.047871791, 88259.85, 1.6, -185345.68 } } },
        { { "arch", "n", 5, 0.84, { 0, 0, 0 }, 0 }, 0, 0, 0, { 1, 3, 2, 0, 242421,
          14176, { 1.3523464e-13, 0, 24130.972, 0, 29874.66 } } },
        { { "incline", "angle", 45, 0.84, { 0, 0, 0 }, 0 }, 0, 0, 0, { 2, 4, 2, 0, 51844,
          3936, { 0.044481196, 0.043205585, 2118.7102, 1.1754525, 1913.2222 } } },
        { { "incline", "turn", 30, 0.84, { 0, 0, 0 }, 0 }, 0, 0, 0, { 1, 1, 0, 0, 23131,
          3936, { 9.0961531e-17, 0, 7503.7763, 0, 2726.8072 } } },
        { { "keystone", "angle", 20, 0.3, { 0, 0, 0 }, 0 }, 0, 0, 0, { 12, 2, 1, 0, 62822,
          4912, { 1, 0.5, 0, -2.7332603, 2206.4963 } } },
        { { "flat-arch", "n", 4, 0.84, { 0, 0, 0 }, 0 }, 0, 0, 0, { 1, 3, 2, 0, 417504,
          11824, { 3.3417097e-10, 0, 69065.706, 0, 54067.909 } } },
        { { "tower", "lean", 0.2, 0.84, { 0, 0, 0 }, 0 }, 0, 0, 0, { 2, 15, 13, 0, 3176430,
          24752, { 0.049112516, 0.0094807678, 4172623.9, 14.767386, -1.6314282e+08 } } },
        { { "diamond", "rows", 3, 0.84, { 0, 0, 0 }, 0 }, 0, 0, 0, { 1, 4, 3, 0, 776124,
          27680, { 5.4062501e-15, 0, 268715.96, 0, 356424.7 } } },
        { { "diamond", "rows", 4, 0.1, { 0, 0, 0 }, 0 }, 0, 0, 0, { 1, 21, 20, 0, 10359552,
          52176, { 7.0355222e-10, 0, 640346.24, 0, 1254500.4 } } },
        { { "inverted-triangle", "rows", 3, 0.84, { 0, 0, 0 }, 0 }, 0, 0, 0, { 2, 4, 2, 0, 399480,
          17728, { 0.16155955, 0.019470679, 134762.78, -3.0305385, 147243.39 } } },
        { { "cantilever", "reach", 1.5, 0.84, { 0, 0, 0 }, 0 }, 0, 0, 0, { 2, 3, 1, 0, 73950,
          6224, { 0.49116707, 0.07397846, 42082.296, 2.75, -46469.399 } } },
        { { "overhang", "factor", 1.1, 0.84, { 0, 0, 0 }, 0 }, 0, 0, 0, { 12, 2, 1, 0, 164854,
          13200, { 0.099503217, 0.01323007, 212908.02, 8.5070825, -422687.91 } } },
        { { "h-model", "mu", 0.84, 0.84, { 0, 0, 0 }, 0 }, 0, 0, 0, { 1, 2, 1, 0, 62102,
          4912, { 7.0582434e-14, 0, 4912.2911, 0, 635.47092 } } },
        { { "arch", "t", 0.1, 0.84, { 0, 0, 0 }, 0 }, 0, 0, 0, { 2, 5, 3, 0, 1716760,
          48880, { 0.085611359, 0.0011571127, 82797.118, 3.7083394, 233884.21 } } },
        { { "arch", "t", 0.09, 0.84, { 0, 0, 0 }, 0 }, 0, 0, 0, { 2, 13, 11, 0, 4335056,
          48880, { 0.0078186485, 0.0027824484, 72076.196, 3.3153796, 228692.67 } } },
        { { "rubble", "bricks", 2, 0.5, { 0, 0, 0 }, 0 }, 0, 0, 0, { 1, 3, 2, 0, 1315251,
          52608, { 5.0439454e-15, 0, 139973.8, 0, 130368.44 } } },
        { { "rubble", "bricks", 2, 0.3, { 0.4, 0.1, 0 }, 0 }, 0, 0, 0, { 2, 73, 71, 0, 44890521,
          53328, { 0.07603375, 0.019633005, 166853.21, 16.559032, -466037.19 } } },
        { { "diamond", "rows", 5, 0.27, { 0, 0, 0 }, 0 }, 0, 0, 0, { 12, 20, 19, 0, 15898100,
          86720, { 0.0032155176, 0.00054196901, 1254710.7, 0.35164891, 3396127.8 } } },
        { { "diamond", "rows", 5, 0.29, { 0, 0, 0 }, 0 }, 0, 0, 0, { 1, 18, 17, 0, 14227110,
          86720, { 2.3343037e-13, 0, 1256311.9, 0, 3396127.8 } } },
        { { "wall", "rows", 2, 0, { 0, 0, 0 }, 0 }, 0, 0, 0, { 1, 1, 0, 0, 1077335,
          72704, { 9.1676864e-16, 0, 27442.929, 0, 10967.757 } } },
        { { "flat-arch", "n", 6, 0.1, { 0, 0, 0 }, 0 }, 0, 0, 0, { 1, 15, 14, 0, 2223090,
          16464, { 1.6362845e-10, 0, 140138.12, 0, 116260.87 } } },
        { { "h-model", "mu", 0.1, 0.05, { 0, 0, 0 }, 0 }, 0, 0, 0, { 1, 2, 1, 0, 62102,
          4912, { 2.0000057e-11, 0, 92566.931, 0, 635.47092 } } },
        { { "tower", "n", 4, 0.84, { 0.05, 0.02, 0 }, 0 }, 0, 0, 0, { 1, 1, 0, 0, 93928,
          11040, { 4.7505495e-15, 0, 619484.32, 0, -1011575.4 } } }
    };
    COMPARE(rows);
}

TEST(stones_of_very_different_weight_take_the_work_written_here)
{
    static const least rows[] = {
        { { "tower", "n", 4, 0.84, { 0, 0, 0 }, 0 }, 0, 3, 0, { 1, 1, 0, 0, 93928,
          10848, { 5.4062856e-16, 0, 2.8725025e+09, 0, -2.5962594e+09 } } },
        { { "arch", "n", 5, 0.84, { 0, 0, 0 }, 0 }, 0, 2, 0, { 2, 15, 12, 0, 1592265,
          14176, { 0.18179307, 0.035930493, 75882024, -3.2082412, 3.8039535e+08 } } },
        { { "arch", "n", 7, 0.4, { 0.1, 0, 0 }, 0 }, 0, 2, 0, { 2, 3, 1, 0, 315615,
          19136, { 0.29199719, 0.027590491, 1.1090844e+08, 1.9639407, 1.5192699e+08 } } },
        { { "diamond", "rows", 3, 0.84, { 0, 0, 0 }, 0 }, 0, 3, 0, { 2, 4, 2, 0, 1267524,
          27680, { 0.78277875, 0.013213342, 5.4331392e+10, 22.105243, -2.4293103e+11 } } },
        { { "overhang", "factor", 1.01, 0.84, { 0, 0, 0 }, 0 }, 0, 2, 0, { 12, 11, 8, 0, 961597,
          13200, { 0.01852151, 0.013876354, 6.1010602e+08, 14.97178, -9.4056494e+08 } } },
        { { "flat-arch", "n", 5, 0.3, { 0, 0, 0 }, 0 }, 0, 2, 0, { 1, 12, 11, 0, 1272084,
          14176, { 9.5721855e-11, 0, 3.4428724e+08, 0, 2.2422002e+08 } } },
        { { "rubble", "bricks", 2, 0.5, { 0.2, 0.3, 0 }, 0 }, 0, 2, 0, { 2, 4, 2, 0, 1772268,
          53328, { 0.35477881, 0.0069687434, 4.9043385e+08, -0.40540954, -36984204 } } },
        { { "tower", "n", 5, 0.84, { 0.3, 0, 0 }, 0 }, 0, 3, 0, { 2, 11, 9, 0, 921997,
          13440, { 0.062162254, 0.022033555, 3.7139853e+10, 10.928467, -5.6767438e+11 } } },
        { { "inverted-triangle", "rows", 3, 0.5, { 0, 0, 0 }, 0 }, 0, 3, 0, { 2, 15, 13, 0, 1951650,
          17728, { 0.58208394, 0.096483113, 1.8241913e+10, 3.3331548, -1.5199447e+11 } } },
        { { "arch", "t", 0.12, 0.84, { 0, 0, 0 }, 0 }, 0, 3, 0, { 2, 22, 20, 0, 7886384,
          48880, { 0.011042628, 0.0051285576, 1.6087048e+10, 1.0293247, 3.205987e+10 } } },
        { { "keystone", "angle", 20, 0.3, { 0, 0, 0 }, 0 }, 0, 3, 0, { 12, 2, 1, 0, 62822,
          4912, { 1, 0.5, 0, -2.7332603, 22064.963 } } }
    };
    COMPARE(rows);
}

TEST(stones_held_in_part_take_the_work_written_here)
{
    static const least rows[] = {
        { { "arch", "n", 5, 0.84, { 0.3, 0, 0 }, 0 }, 0, 0, 1, { 1, 1, 0, 0, 140567,
          14416, { 7.2269597e-16, 0, 27799.917, 0, 19405.218 } } },
        { { "arch", "n", 5, 0.84, { 0.3, 0, 0 }, 0 }, 0, 0, 2, { 2, 5, 3, 0, 681235,
          14416, { 0.25541468, 0.018229757, 33136.951, 6.3529798, -97695.769 } } },
        { { "arch", "n", 5, 0.84, { 0.3, 0, 0 }, 0 }, 0, 0, 8, { 2, 5, 3, 0, 681235,
          14416, { 0.25541468, 0.018229757, 33136.951, 6.3529798, -97695.769 } } },
        { { "arch", "n", 5, 0.84, { 0.3, 0, 0 }, 0 }, 0, 0, 16, { 1, 3, 2, 0, 523221,
          14416, { 1.0379614e-10, 0, 26030.675, 0, 8144.8206 } } },
        { { "arch", "n", 5, 0.84, { 0.3, 0, 0 }, 0 }, 0, 0, 42, { 2, 5, 3, 0, 681235,
          14416, { 0.25541468, 0.018229757, 33136.951, 6.3529798, -97695.769 } } },
        { { "arch", "n", 5, 0.84, { 0.3, 0, 0 }, 0 }, 0, 0, 56, { 1, 3, 2, 0, 523221,
          14416, { 1.0379643e-10, 0, 26030.675, 0, 8144.8206 } } },
        { { "diamond", "rows", 3, 0.3, { 0.2, 0.1, 0 }, 0 }, 0, 1, 4, { 1, 13, 12, 0, 2499003,
          28112, { 2.3105024e-14, 0, 5501523.7, 0, -2295244 } } },
        { { "diamond", "rows", 3, 0.3, { 0.2, 0.1, 0 }, 0 }, 0, 1, 21, { 1, 7, 6, 0, 1334817,
          28112, { 1.2066689e-14, 0, 2804604.5, 0, 871839.47 } } },
        { { "diamond", "rows", 3, 0.3, { 0.2, 0.1, 0 }, 0 }, 0, 1, 32, { 1, 31, 30, 0, 8434521,
          28112, { 1.1749488e-12, 0, 6946546.7, 0, 2675868.5 } } },
        { { "tower", "lean", 0.2, 0.84, { 0, 0, 0 }, 0 }, 0, 0, 16, { 1, 1, 0, 0, 235522,
          24752, { 3.663736e-15, 0, 3824593.5, 0, 6531228.9 } } },
        { { "tower", "lean", 0.2, 0.84, { 0, 0, 0 }, 0 }, 0, 0, 7, { 1, 1, 0, 0, 300322,
          24752, { 0, 0, 0, 0, 0 } } }
    };
    COMPARE(rows);
}

TEST(a_hair_from_their_limits_checks_take_the_work_written_here)
{
    static const least rows[] = {
        { { "arch", "n", 7, 0.84, { 0.0913808169, 0, 0 }, 0 }, 0, 0, 0, { 1, 17, 16, 0, 2826245,
          19136, { 2.5273951e-10, 0, 32218.3, 0, 22479.323 } } },
        { { "arch", "n", 7, 0.84, { 0.092294625, 0, 0 }, 0 }, 0, 0, 0, { 1, 16, 15, 0, 2410960,
          19136, { 2.5557273e-10, 0, 32202.828, 0, 21988.994 } } },
        { { "arch", "n", 7, 0.84, { 0.0923037631, 0, 0 }, 0 }, 0, 0, 0, { 1, 16, 15, 0, 2266960,
          19136, { 2.5559782e-10, 0, 32202.673, 0, 21984.091 } } },
        { { "arch", "n", 7, 0.84, { 0.0923039477, 0, 0 }, 0 }, 0, 0, 0, { 12, 18, 17, 0, 2475450,
          19136, { 1.6604433e-08, 8.4592643e-09, 32202.671, 2.5405334, 21983.992 } } },
        { { "arch", "n", 7, 0.84, { 0.0923130858, 0, 0 }, 0 }, 0, 0, 0, { 12, 17, 16, 0, 2379845,
          19136, { 1.660693e-06, 9.6158477e-07, 32202.676, 2.5405334, 21979.088 } } },
        { { "arch", "n", 7, 0.84, { 0.093226894, 0, 0 }, 0 }, 0, 0, 0, { 12, 16, 15, 0, 2252560,
          19136, { 0.0001660339, 9.6202494e-05, 32203.102, 2.5405334, 21488.759 } } },
        { { "diamond", "rows", 3, 0.5, { 0.375211268, 0.11256338, 0 }, 0 }, 0, 0, 0, { 1, 26, 25, 0, 4258566,
          28112, { 5.5087999e-13, 0, 122714.81, 0, -352081.66 } } },
        { { "diamond", "rows", 3, 0.5, { 0.375583099, 0.11267493, 0 }, 0 }, 0, 0, 0, { 1, 31, 30, 0, 5121081,
          28112, { 3.4491053e-12, 0, 122804.21, 0, -352783.78 } } },
        { { "diamond", "rows", 3, 0.5, { 0.375624414, 0.112687324, 0 }, 0 }, 0, 0, 0, { 12, 30, 29, 0, 5034690,
          28112, { 1.0517562e-05, 3.6628183e-06, 122820.53, 14.227594, -352861.8 } } },
        { { "rubble", "bricks", 2, 0.5, { 0.409009673, 0.204504836, 0 }, 0 }, 0, 0, 0, { 1, 37, 36, 0, 16541349,
          53328, { 1.0032806e-12, 0, 176390.11, 0, -436048.15 } } },
        { { "rubble", "bricks", 2, 0.5, { 0.409091483, 0.204545742, 0 }, 0 }, 0, 0, 0, { 2, 38, 36, 0, 19196886,
          53328, { 1.8898539e-05, 1.5205509e-05, 176417.34, 1.0894273, -436161.45 } } },
        { { "tower", "n", 4, 0.84, { 0.1499985, 0, 0 }, 0 }, 0, 0, 0, { 1, 2, 1, 0, 127376,
          11040, { 2.1678888e-13, 0, 531032.12, 0, -2024587.1 } } },
        { { "tower", "n", 4, 0.84, { 0.1500015, 0, 0 }, 0 }, 0, 0, 0, { 12, 3, 2, 0, 257304,
          11040, { 2.6017874e-06, 2.7727078e-07, 531028.61, 11.614135, -2024621.3 } } },
        { { "flat-arch", "n", 5, 0.4, { 17.8763143, 0, 0 }, 0 }, 0, 0, 0, { 1, 12, 11, 0, 1358484,
          14416, { 1.7620099e-10, 0, 1461682.9, 0, -308963.62 } } },
        { { "flat-arch", "n", 5, 0.4, { 17.9121028, 0, 0 }, 0 }, 0, 0, 0, { 12, 12, 11, 0, 1362804,
          14416, { 2.7921034e-05, 1.5454564e-05, 1464385.2, 6.5912271, -309744.08 } } },
        { { "cantilever", "reach", 1.2, 0.84, { 0.12903213, 0.025806426, 0 }, 0 }, 0, 0, 0, { 1, 6, 5, 0, 132060,
          6320, { 4.6145386e-15, 0, 23660.48, 0, -7828.8206 } } },
        { { "cantilever", "reach", 1.2, 0.84, { 0.129032388, 0.0258064776, 0 }, 0 }, 0, 0, 0, { 12, 6, 5, 0, 178140,
          6320, { 6.2575447e-08, 1.500791e-08, 23660.467, 5.45, -7828.8241 } } },
        { { "diamond", "rows", 4, 0.4, { 0.169115458, 0, 0 }, 0 }, 0, 0, 0, { 1, 23, 22, 0, 10074176,
          52944, { 1.3920517e-13, 0, 513955.33, 0, -708932.46 } } },
        { { "diamond", "rows", 4, 0.4, { 0.169149285, 0, 0 }, 0 }, 0, 0, 0, { 12, 23, 22, 0, 10101176,
          52944, { 4.7751344e-06, 1.2695142e-06, 513934.5, 17.293363, -709325.19 } } },
        { { "wall", "rows", 2, 0.84, { 0.82286408, 0.164572816, 0 }, 0 }, 0, 0, 0, { 1, 36, 35, 0, 24687900,
          73520, { 1.1581486e-13, 0, 1778.0809, 0, 21228.865 } } },
        { { "wall", "rows", 2, 0.84, { 0.824511455, 0.164902291, 0 }, 0 }, 0, 0, 0, { 2, 96, 94, 0, 99198120,
          73520, { 0.0002506214, 1.7422197e-05, 1763.5241, 18.156763, 21249.408 } } }
    };
    COMPARE(rows);
}

TEST(checks_that_may_not_go_on_take_the_work_written_here)
{
    static const least rows[] = {
        { { "arch", "t", 0.1, 0.84, { 0, 0, 0 }, 0 }, 1, 0, 0, { 0, 2, 1, 0, 1314184,
          48880, { 0.085611359, 0, 82797.118, -5.1977593, 233884.21 } } },
        { { "arch", "t", 0.1, 0.84, { 0, 0, 0 }, 0 }, 2, 0, 0, { 0, 3, 2, 0, 1498776,
          48880, { 0.085611359, 0, 82797.118, -5.1977593, 233884.21 } } },
        { { "arch", "t", 0.1, 0.84, { 0, 0, 0 }, 0 }, 3, 0, 0, { 2, 5, 3, 0, 1716760,
          48880, { 0.085611359, 0.0011571127, 82797.118, 3.7083394, 233884.21 } } },
        { { "tower", "lean", 0.2, 0.84, { 0, 0, 0 }, 0 }, 1, 0, 0, { 0, 2, 1, 0, 841844,
          24752, { 0.1003861, 0, 5222041.1, 11.511829, -1.6314282e+08 } } },
        { { "diamond", "rows", 5, 0.29, { 0, 0, 0 }, 0 }, 4, 0, 0, { 0, 5, 4, 0, 6871175,
          86720, { 0.44925224, 0, 1390602.9, -36.495461, 3396127.8 } } },
        { { "diamond", "rows", 4, 0.1, { 0, 0, 0 }, 0 }, 2, 0, 0, { 0, 3, 2, 0, 3324936,
          52176, { 0.38697815, 0, 698590.32, -24.044776, 1254500.4 } } },
        { { "flat-arch", "n", 6, 0.1, { 0, 0, 0 }, 0 }, 5, 0, 0, { 0, 6, 5, 0, 1229436,
          16464, { 0.38319863, 0, 39213.583, -5.5568944, 116260.87 } } }
    };
    COMPARE(rows);
}

/* `count` scenes of a family from seed `first` on, pushed sideways by `live` times their weight; counts and numbers are sums. */
typedef struct drawn {
    sp_fuzz_family family;
    int first, count;
    double live;
    tally is;
} drawn;

static void compare_drawn(const drawn *rows, size_t n)
{
    for (size_t k = 0; k < n; k++) {
        const drawn *d = &rows[k];
        sp_cost sum;
        int kinds = 0, kind;
        size_t bytes = 0, more;
        double found[TALLY_FOUND] = { 0 }, one[TALLY_FOUND];
        memset(&sum, 0, sizeof sum);
        for (int i = 0; i < d->count; i++) {
            sp_scene s;
            test_renew();
            CHECK_INT(sp_scene_of_family(d->family, (uint64_t)(d->first + i), &test_arena, &s), SP_OK);
            s.gravity[0] += R(9.80665 * d->live);
            s.gravity[1] += R(9.80665 * d->live / 3);
            const sp_cost cost = checked(&s, 0, &kind, &more, one);
            tally_add(&sum, &cost);
            kinds += kind;
            bytes += more;
            for (int e = 0; e < TALLY_FOUND; e++) found[e] += one[e];
        }
        tally_compare("family", k, &d->is, kinds, &sum, bytes, found);
    }
}

TEST(drawn_scenes_take_the_work_written_here)
{
    static const drawn rows[] = {
        { SP_FUZZ_STACK, 1, 4, 0, { 4, 4, 0, 0, 422910,
          203712, { 5.7788806e-15, 0, 1476984.3, 0, 1997094.1 } } },
        { SP_FUZZ_STACK, 11, 4, 0.1, { 5, 8, 3, 0, 1129482,
          215744, { 0.14770397, 0.023905564, 2308486.5, 10.48978, -9968504.3 } } },
        { SP_FUZZ_STACK, 21, 4, 0.4, { 17, 30, 22, 0, 3202941,
          212352, { 0.17205933, 0.018672342, 817733.35, 32.356846, -9734327.5 } } },
        { SP_FUZZ_WALL, 1, 4, 0, { 4, 15, 11, 0, 4603266,
          280768, { 1.3822186e-13, 0, 14407537, 0, 7524171.9 } } },
        { SP_FUZZ_WALL, 11, 4, 0.1, { 6, 48, 42, 0, 37432203,
          346352, { 0.7630715, 0.46326069, 22981682, -1.8446056, 11197453 } } },
        { SP_FUZZ_WALL, 21, 4, 0.4, { 4, 52, 48, 0, 38052901,
          387248, { 3.0737513e-11, 0, 13087235, 0, -20781336 } } },
        { SP_FUZZ_RUBBLE, 1, 4, 0, { 4, 13, 9, 0, 4274943,
          283952, { 1.7579587e-14, 0, 2398880, 0, 2139647 } } },
        { SP_FUZZ_RUBBLE, 11, 4, 0.1, { 4, 22, 18, 0, 9605437,
          339520, { 3.876766e-12, 0, 1737797.1, 0, 841663.54 } } },
        { SP_FUZZ_RUBBLE, 21, 4, 0.4, { 4, 29, 25, 0, 7538528,
          280480, { 3.3758481e-13, 0, 914735.55, 0, 257382.97 } } },
        { SP_FUZZ_ARCH, 1, 4, 0, { 4, 8, 4, 0, 1788152,
          263536, { 2.4033414e-13, 0, 4892018.2, 0, 6761629.6 } } },
        { SP_FUZZ_ARCH, 11, 4, 0.1, { 5, 57, 52, 0, 10395759,
          239392, { 0.007464649, 0.0054084132, 2772572.3, 11.316086, 590644.5 } } },
        { SP_FUZZ_ARCH, 21, 4, 0.4, { 8, 132, 124, 0, 25127882,
          232512, { 0.13224696, 0.076275246, 2907806.1, 59.272519, -3962976.9 } } }
    };
    compare_drawn(rows, sizeof rows / sizeof *rows);
}

/* `live` is a force on the last stone, beside its middle, and nothing else is. */
static void load_the_last(sp_scene *s)
{
    static sp_load load[1];
    const int32_t last = s->count.blocks - 1 - (s->block[s->count.blocks - 1].fixed == SP_FIXED);
    memset(load, 0, sizeof load);
    load->block = last;
    load->live = 1;
    for (int c = 0; c < 3; c++) {
        load->force[c] = s->body[c];
        load->point[c] = s->block[last].centroid[c] + R(0.01 * c);
        s->body[c] = 0;
    }
    s->load = load;
    s->capacity.loads = s->count.loads = 1;
}

static void compare_limits(const least *rows, size_t n, int one)
{
    for (size_t k = 0; k < n; k++) {
        sp_scene s = scene_of(&rows[k]);
        if (one) load_the_last(&s);
        sp_settings set = sp_settings_default();
        sp_limit_result x;
        memset(&x, 0, sizeof x);
        if (rows[k].iterations) set.iterations = rows[k].iterations;
        CHECK_INT(sp_limit(&s, &set, &test_arena, &x), SP_OK);
        const double found[] = { (double)x.lower, (double)x.upper, mixed(x.f, 3 * (size_t)s.count.points) + (double)x.lowest,
                                 mixed(x.dq, 6 * (size_t)s.count.blocks), (double)(x.least_imbalance + x.imbalance) };
        tally_compare(rows[k].of.name, k, &rows[k].is, (int)x.kind + 10 * (int)x.dead, &x.cost, x.peak_bytes, found);
    }
}

TEST(limits_of_the_smallest_build_take_the_work_written_here)
{
    static const least rows[] = {
        { { "two-cubes", "offset", 0.3, 0.84, { 1, 0, 0 }, 0 }, 0, 0, 0, { 11, 5, 2, 0, 81095,
          5408, { 0.39999999, 0.4, 32950.345, 2.8, 1.1065487e-09 } } },
        { { "arch", "n", 5, 0.84, { 1, 0, 0 }, 0 }, 0, 0, 0, { 11, 69, 60, 0, 5796003,
          18112, { 0.080693647, 0.080693665, 26673.823, 6.0066031, 1.16888e-09 } } },
        { { "arch", "n", 5, 0.84, { 1, 0, 0 }, 0 }, 3, 0, 0, { 10, 55, 40, 0, 4316225,
          18112, { 0.080693209, -1, 26673.809, 0, 2.6215387e-13 } } },
        { { "keystone", "angle", 20, 0.84, { 0, 0, -1 }, 0 }, 0, 0, 0, { 13, 4, 2, 0, 119884,
          6608, { 0, -1, 32029.559, 0, 3.7624765e-13 } } },
        { { "keystone", "angle", 20, 0.3, { 0, 0, 1 }, 0 }, 0, 0, 0, { 23, 8, 4, 0, 236168,
          6608, { 1, -1, 1.000108, 0, 8.9810108e-14 } } },
        { { "tower", "n", 3, 0.84, { 1, 0.3, 0.1 }, 0 }, 0, 0, 0, { 11, 35, 27, 0, 1645035,
          11152, { 0.22164276, 0.22164277, 240345.65, 8.6620332, 1.0675567e-09 } } },
        { { "incline", "angle", 45, 0.84, { -1, 0, 0 }, 0 }, 0, 0, 0, { 21, 23, 14, 0, 346253,
          5408, { 11.5, 11.5, 213589.12, 2.7221005, 1.1237934e-09 } } },
        { { "diamond", "rows", 3, 0.3, { 0, 1, 0 }, 0 }, 0, 0, 0, { 11, 583, 571, 0, 195352353,
          34336, { 0.29999995, 0.30000025, 203181.33, 20.013192, 1.4515576e-08 } } },
        { { "rubble", "bricks", 1, 0.5, { 1, 1, 0 }, 0 }, 0, 0, 0, { 11, 96, 86, 0, 16524288,
          33776, { 0.22441199, 0.224412, 72527.44, 1.8890366, 4.2666034e-09 } } },
        { { "flat-arch", "n", 4, 0.84, { 0, 0, 1 }, 0 }, 0, 0, 0, { 13, 8, 6, 0, 948344,
          15200, { 0, -1, 69065.706, 0, 3.3417097e-10 } } },
        { { "inverted-triangle", "rows", 3, 0.84, { 1, 0, 0 }, 0 }, 0, 0, 0, { 0, 111, 89, 0, 15510690,
          22176, { -1, -1, -1, -3.0213646, 0 } } },
        { { "two-cubes", "offset", 0.3, 0.84, { 0, 0, -1 }, 0 }, 0, 0, 0, { 13, 2, 0, 0, 44822,
          5408, { 0, -1, 70607.88, 0, 5.2892961e-17 } } }
    };
    compare_limits(rows, sizeof rows / sizeof *rows, 0);
}

TEST(limits_of_uneven_stones_take_the_work_written_here)
{
    static const least rows[] = {
        { { "rubble", "bricks", 1, 0.5, { 1, 0.3, 0 }, 0 }, 0, 1, 0, { 11, 426, 415, 0, 79148358,
          33776, { 0.27081438, 0.27081451, 2616328.9, 1.9458618, 1.9115976e-09 } } },
        { { "diamond", "rows", 3, 0.84, { 1, 0, 0 }, 0 }, 0, 1, 0, { 11, 263, 252, 0, 67648833,
          34336, { 0.46457607, 0.46457611, 4467379.8, 16.646053, 2.8248693e-09 } } },
        { { "tower", "n", 5, 0.5, { 1, 0.3, -0.1 }, 0 }, 0, 3, 0, { 11, 74, 66, 0, 5363398,
          16912, { 0.024870629, 0.024870646, 3.6067272e+10, 10.928467, 1.4384183e-09 } } },
        { { "arch", "n", 7, 0.84, { 1, 0, 0 }, 0 }, 0, 2, 0, { 22, 38, 32, 0, 4833950,
          23856, { -1, 0, -1, 0.46995812, 0.033024098 } } },
        { { "wall", "rows", 2, 0.6, { 0, 1, 0 }, 0 }, 0, 0, 0, { 11, 76, 68, 0, 51129860,
          87008, { 0.49999999, 0.50000002, 12808.27, -27.420722, 1.1407785e-09 } } },
        { { "flat-arch", "n", 4, 0.5, { 0, 1, -0.2 }, 0 }, 0, 1, 0, { 13, 36, 34, 0, 2754648,
          15200, { 0, -1, 3059593.6, 0, 1.0823963e-10 } } },
        { { "cantilever", "reach", 1.2, 0.84, { 0, 0, -1 }, 0 }, 0, 2, 0, { 13, 2, 0, 0, 90580,
          8256, { 0, -1, 1694589.1, 0, 1.2156272e-16 } } },
        { { "cantilever", "reach", 1.5, 0.84, { 0, 0, 1 }, 0 }, 0, 1, 0, { 11, 4, 1, 0, 149480,
          8256, { 0.99999999, 1, 0.013556713, 5.1780788, 0.5 } } },
        { { "h-model", "mu", 0.84, 0.84, { 0.2, 0, -1 }, 0 }, 0, 1, 42, { 13, 5, 3, 0, 134375,
          6608, { 0, -1, 491229.11, 0, 7.0554673e-14 } } },
        { { "inverted-triangle", "rows", 3, 0.84, { 0, 0, -1 }, 0 }, 0, 0, 0, { 22, 8, 4, 0, 763680,
          22176, { -1, 0, -1, -3.0305385, 0.019470679 } } }
    };
    compare_limits(rows, sizeof rows / sizeof *rows, 0);
}

TEST(limits_of_a_load_on_one_stone_take_the_work_written_here)
{
    static const least rows[] = {
        { { "tower", "n", 3, 0.84, { 10000, 300, -100 }, 0 }, 0, 0, 0, { 11, 70, 62, 0, 2842950,
          11152, { 0.097243186, 0.097243191, 287769.08, 8.6620332, 1.3323808e-09 } } },
        { { "arch", "n", 5, 0.84, { 0.01, 0, -1 }, 0 }, 0, 1, 0, { 0, 311, 256, 0, 32181937,
          18112, { -1, -1, -1, 3.0804167, 0 } } },
        { { "diamond", "rows", 3, 0.84, { 0.001, 0, 0 }, 0 }, 0, 1, 0, { 11, 173, 164, 0, 38486043,
          34336, { 302334.39, 302334.6, 10134885, 2.9148804, 4.664924e-09 } } },
        { { "rubble", "bricks", 1, 0.5, { 1000, 0, 500 }, 0 }, 0, 0, 0, { 11, 70, 61, 0, 13315050,
          33776, { 0.016250617, 0.016250618, 70236.223, 1.2975078, 1.5054017e-09 } } },
        { { "overhang", "n", 4, 0.84, { 0, 0, -1 }, 0 }, 0, 2, 0, { 22, 6, 2, 0, 289968,
          14000, { -1, 0, -1, 15.61426, 0.040161403 } } },
        { { "inverted-triangle", "rows", 3, 0.84, { 0, 0, -100000 }, 0 }, 0, 0, 0, { 22, 17, 13, 0, 1904430,
          22176, { -1, 0, -1, -3.0305385, 0.019470679 } } },
        { { "flat-arch", "n", 4, 0.5, { 1, 1, 0 }, 0 }, 0, 3, 0, { 13, 36, 34, 0, 2551248,
          15200, { 0, -1, 2.1529056e+08, 0, 1.1468941e-10 } } },
        { { "two-cubes", "offset", 0.3, 0.84, { 0.0001, 0, 0 }, 0 }, 0, 0, 0, { 11, 7, 4, 0, 95677,
          5408, { 9230769.1, 9230769.3, 34579.758, 2.8, 1.7060566e-09 } } }
    };
    compare_limits(rows, sizeof rows / sizeof *rows, 1);
}

/* Up, down again; at every step what to hold and what is next. Numbers are sums over the steps of all that a step tells. */
static void ordered(sp_sequence *q, const sp_scene *s, sp_cost *sum, int *kind, double found[TALLY_FOUND])
{
    for (int32_t i = 0; i < 2 * s->count.blocks; i++) {
        const int32_t b = i % s->count.blocks;
        sp_step step;
        sp_held held;
        sp_suggestion next;
        if (s->block[b].fixed == SP_FIXED) continue;
        CHECK_INT(sp_sequence_set(q, b, i == b ? SP_PRESENT : b % 3 ? SP_HELD : SP_ABSENT, &step), SP_OK);
        tally_add(sum, &step.cost);
        *kind += (int)step.verdict + 10 * step.final;
        found[0] += step.islands + 2 * step.checked + 3 * step.blocks + 5 * step.again + 7 * step.block + 11 * (int)step.reason;
        found[1] += (double)(step.imbalance + step.least_imbalance);
        found[2] += mixed(step.f, 3 * (size_t)s->count.points) + mixed(step.dq, 6 * (size_t)s->count.blocks);
        CHECK_INT(sp_sequence_hold(q, i % 2 ? 0 : 100000, &held), SP_OK);
        tally_add(sum, &held.cost);
        found[3] += held.count + 3 * (int)held.proof + 7 * held.checks;
        for (int32_t h = 0; h < held.count; h++) found[3] += (h + 1) * (held.block[h] + 100 * held.must[h]);
        CHECK_INT(sp_sequence_suggest(q, b % 2, i % 3 ? 0 : 50000, &next), SP_OK);
        tally_add(sum, &next.cost);
        found[4] += next.block + 5 * next.tried + 7 * next.all;
    }
}

static void compare_orders(const least *rows, size_t n)
{
    for (size_t k = 0; k < n; k++) {
        const sp_scene s = scene_of(&rows[k]);
        sp_sequence *q = NULL;
        sp_cost sum;
        int kind = 0;
        double found[TALLY_FOUND] = { 0 };
        memset(&sum, 0, sizeof sum);
        NEED(sp_sequence_open(&s, NULL, &test_arena, &q) == SP_OK);
        const size_t bytes = test_arena.used;
        ordered(q, &s, &sum, &kind, found);
        tally_compare(rows[k].of.name, k, &rows[k].is, kind, &sum, bytes, found);
    }
}

TEST(build_orders_of_the_smallest_build_take_the_work_written_here)
{
    static const least rows[] = {
        { { "arch", "n", 5, 0.84, { 0, 0, 0 }, 0 }, 0, 0, 0, { 65, 69, 39, 0, 7341484,
          16640, { 521, 2.7609488, 297548.96, 444, 125 } } },
        { { "tower", "lean", 0.2, 0.84, { 0, 0, 0 }, 0 }, 0, 0, 0, { 63, 626, 452, 0, 125925829,
          28112, { 2175, 5.1011534, 25697865, 2398, 377 } } },
        { { "diamond", "rows", 3, 0.3, { 0, 0, 0 }, 0 }, 0, 0, 0, { 54, 298, 216, 0, 71012228,
          31328, { 1135, 5.2441712, 1853229.5, 736, 307 } } },
        { { "inverted-triangle", "rows", 3, 0.84, { 0, 0, 0 }, 0 }, 0, 0, 0, { 58, 72, 37, 0, 9058098,
          20320, { 778, 5.3585489, 555466.12, 535, 156 } } },
        { { "keystone", "angle", 20, 0.3, { 0, 0, 0 }, 0 }, 0, 0, 0, { 13, 4, 2, 0, 125644,
          6480, { 66, 1.5, -2.7332603, 109, 12 } } },
        { { "two-cubes", "offset", 0.6, 0.84, { 0, 0, 0 }, 0 }, 0, 0, 0, { 13, 4, 2, 0, 63004,
          5280, { 66, 0.24398674, 88261.45, 109, 12 } } },
        { { "flat-arch", "n", 4, 0.84, { 0, 0, 0 }, 0 }, 0, 1, 0, { 42, 75, 46, 0, 6594869,
          14064, { 378, 2.0927609, 9181696.8, 380, 117 } } },
        { { "overhang", "n", 4, 0.84, { 0.3, 0.1, 0 }, 0 }, 0, 0, 0, { 22, 51, 27, 0, 3772253,
          13056, { 420, 1.6647482, 239991.52, 321, 94 } } }
    };
    compare_orders(rows, sizeof rows / sizeof *rows);
}

#endif

TEST_LIST(least)
#if defined SP_SMALL && !defined SP_EXACT_ONLY && COUNTED
    RUN(checks_of_the_smallest_build_take_the_work_written_here)
    RUN(stones_of_very_different_weight_take_the_work_written_here)
    RUN(stones_held_in_part_take_the_work_written_here)
    RUN(a_hair_from_their_limits_checks_take_the_work_written_here)
    RUN(checks_that_may_not_go_on_take_the_work_written_here)
    RUN(drawn_scenes_take_the_work_written_here)
    RUN(limits_of_the_smallest_build_take_the_work_written_here)
    RUN(limits_of_uneven_stones_take_the_work_written_here)
    RUN(limits_of_a_load_on_one_stone_take_the_work_written_here)
    RUN(build_orders_of_the_smallest_build_take_the_work_written_here)
#endif
TEST_END
