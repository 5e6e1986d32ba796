/* Reading a result: the help a falling scene would need, resultants, reactions, utilisation, the weakest joint, the mechanism
 * and what it cost, against statics by hand. */
#include "../test.h"
#include "../scenes/gen.h"

#include <math.h>
#include <string.h>

static const double deg = 57.295779513082320877, gravity = 9.80665, density = 2400;

#define NEAR TOL(1e-9, 1e-4)            /* what balance at the default tolerance is good for */
#define HELP TOL(1e-6, 1e-2)            /* the penalty form is solved less far */

static sp_result check(const sp_scene *scene, const sp_settings *settings, sp_verdict want)
{
    sp_result r;
    memset(&r, 0, sizeof r);
    CHECK_INT(sp_check(scene, settings, &test_arena, &r), SP_OK);
    CHECK_INT(r.verdict, want);
    CHECK_INT(r.verified, r.verdict != SP_UNDECIDED);
    CHECK_INT(r.level, r.verdict == SP_STABLE ? SP_ADMISSIBLE : SP_NONE);
    return r;
}

static void build(const char *name, const char *param, double value, sp_scene *scene)
{
    CHECK_INT(gen_make(name, param, value, &test_arena, scene), SP_OK);
}

/* A box by opposite corners. */
static void box(sp_scene *s, const double lo[3], const double hi[3], uint32_t fixed)
{
    static const int32_t size[6] = { 4, 4, 4, 4, 4, 4 };
    static const int32_t corner[24] = { 0, 2, 3, 1,  4, 5, 7, 6,  0, 1, 5, 4,  2, 6, 7, 3,  0, 4, 6, 2,  1, 3, 7, 5 };
    sp_real xyz[24];
    for (int k = 0; k < 8; k++)
        for (int c = 0; c < 3; c++) xyz[3 * k + c] = R((k >> c & 1) ? hi[c] : lo[c]);
    const sp_mesh mesh = { 8, 6, xyz, size, corner };
    CHECK_INT(sp_scene_block(s, &mesh, R(density), fixed, NULL), SP_OK);
}

/* A level joint at height z. */
static void level(sp_scene *s, int32_t a, int32_t b, double x0, double x1, double y0, double y1, double z, double mu)
{
    const sp_real p[12] = { R(x0), R(y0), R(z), R(x1), R(y0), R(z), R(x1), R(y1), R(z), R(x0), R(y1), R(z) };
    const sp_strength strength = sp_strength_friction(R(mu));
    CHECK_INT(sp_scene_joint(s, a, b, 4, p, &strength, NULL), SP_OK);
}

static void start(sp_scene *s, int32_t blocks, int32_t joints)
{
    const sp_capacity cap = { blocks, 8 * blocks, 6 * blocks, 24 * blocks, joints, 4 * joints, 0 };
    CHECK_INT(sp_scene_create(s, &cap, &test_arena), SP_OK);
}

/* Three boxes, the lowest held, with room for two joints. */
static sp_scene three(const double low[2][3], const double middle[2][3], const double top[2][3])
{
    sp_scene s;
    start(&s, 3, 2);
    box(&s, low[0], low[1], SP_FIXED);
    box(&s, middle[0], middle[1], 0);
    box(&s, top[0], top[1], 0);
    return s;
}

static double norm(const sp_real v[3])
{
    return sqrt((double)v[0] * (double)v[0] + (double)v[1] * (double)v[1] + (double)v[2] * (double)v[2]);
}

/* 1 ----------------------------------------------------------------------------------------------------- demanded help */

static sp_settings helped(void)
{
    sp_settings set = sp_settings_default();
    set.localise = 1;
    return set;
}

/* A box 1 long that overhangs its support by more than half: about the outer edge of the joint, of width w, its weight has the
 * arm d, so the inner edge pulls W d / w and the outer one presses W (1 + d / w), half of it at either corner. That is
 * equilibrium alone, whatever tension costs. */
TEST(tension_of_an_overhanging_box_follows_from_its_moments)
{
    static const struct { double offset, height, pull; } table[] = { { 0.8, 0.5, 1.5 }, { 0.75, 1, 1 }, { 0.6, 1, 0.25 } };
    static const double gamma[] = { 1, 10, 1e3, 1e5 };
    for (size_t k = 0; k < sizeof table / sizeof table[0]; k++)
        for (size_t i = 0; i < sizeof gamma / sizeof gamma[0] - TOL(0, 1); i++) {
            const double x = table[k].offset, h = table[k].height, W = density * h * gravity;
            const double ground[2][3] = { { 0, 0, -h }, { 1, 1, 0 } }, top[2][3] = { { x, 0, 0 }, { 1 + x, 1, h } };
            sp_settings set = helped();
            sp_scene s;
            test_arena.used = 0;
            set.penalty.gamma = R(gamma[i]);
            start(&s, 2, 1);
            box(&s, ground[0], ground[1], SP_FIXED);
            box(&s, top[0], top[1], 0);
            level(&s, 0, 1, x, 1, 0, 1, 0, 0.84);
            const sp_result r = check(&s, &set, SP_UNSTABLE);
            CHECK_NEAR(r.demand[0].tension, 0.5 * table[k].pull * W, HELP);
            CHECK_WITHIN((double)r.demand[0].friction / W, 0, HELP);
            CHECK_NEAR(r.extremes.tension, r.demand[0].tension, 0);
            CHECK_INT(r.extremes.weakest, 0);
        }
}

/* Friction on the net normal: no joint can pull, so there is no help to be had. */
TEST(net_friction_shows_no_tension)
{
    sp_scene s;
    sp_settings set = helped();
    set.penalty.net = 1;
    build("two-cubes", "offset", 0.75, &s);
    const sp_result r = check(&s, &set, SP_UNSTABLE);
    CHECK_WITHIN(r.demand[0].tension, 0, 0);
    CHECK_WITHIN(r.demand[0].friction / R(density * gravity), 0, HELP);
    CHECK_WITHIN(r.extremes.tension, 0, 0);
}

TEST(nothing_is_demanded_where_it_stands_or_nobody_asks)
{
    sp_scene s;
    const sp_settings set = helped();
    build("two-cubes", "offset", 0.4, &s);
    const sp_result stands = check(&s, &set, SP_STABLE);
    CHECK_WITHIN(stands.demand[0].tension, 0, 0);
    CHECK_WITHIN(stands.demand[0].friction, 0, 0);
    build("two-cubes", "offset", 0.6, &s);
    const sp_result silent = check(&s, NULL, SP_UNSTABLE);
    CHECK_WITHIN(silent.demand[0].tension, 0, 0);
    const sp_result told = check(&s, &set, SP_UNSTABLE);
    CHECK(told.demand[0].tension > 0);
    CHECK(told.spent.total.flops > silent.spent.total.flops);
}

/* A block of height h that slides: its four corners carry N = W cos a and T = W sin a, the lower edge more by
 * d = T h / 2 a corner's pair (base 1). At a corner with normal n and friction t the price is
 *
 *   1/2 fp^2 + gamma/2 (fp - n)^2 + tau/2 t^2,  fp = t / mu       so  t_1 - t_2 = gamma mu d / (1 + gamma + tau mu^2)
 *
 * and the most friction is missing at the upper edge: (T - mu N) / 4 + mu d / 2 (1 - gamma / (1 + gamma + tau mu^2)). */
TEST(missing_friction_of_a_sliding_block_follows_from_its_price)
{
    static const double gamma[] = { 10, 1e3 }, tau[] = { 1, 7 }, angle[] = { 40, 50 };
    for (int i = 0; i < 8; i++) {
        const double g = gamma[i & 1], t = tau[i >> 1 & 1], a = angle[i >> 2] / deg, mu = 0.6, h = 0.2;
        gen_scene scene;
        sp_scene s;
        sp_settings set = helped();
        test_arena.used = 0;
        set.penalty.gamma = R(g);
        set.penalty.tau = R(t);
        gen_open(&scene, "incline");
        gen_set(&scene, "mu", mu);
        gen_set(&scene, "height", h);
        gen_set(&scene, "angle", angle[i >> 2]);
        CHECK_INT(gen_build(&scene, &test_arena, &s), SP_OK);
        const sp_result r = check(&s, &set, SP_UNSTABLE);
        const double W = density * h * gravity, T = W * sin(a), N = W * cos(a), d = 0.5 * T * h;
        const double missing = (T - mu * N) / 4 + 0.5 * mu * d * (1 - g / (1 + g + t * mu * mu));
        CHECK_NEAR(r.demand[0].friction, missing, HELP);
        CHECK_WITHIN((double)r.demand[0].tension / W, 0, HELP);
    }
}

/* 2 ---------------------------------------------------------------------------------------------- resultants and reactions */

/* Boxes of different size upon each other, each joint inside the one below: a tree, so statics alone gives every resultant. */
TEST(a_joint_of_a_stack_carries_the_weight_above_it_below_its_centre)
{
    static const double w[5] = { 3, 2, 1.6, 1.2, 0.7 }, h[5] = { 1, 0.4, 0.5, 0.3, 0.6 }, x[5] = { 0, 0.2, 0.1, 0.15, 0.1 };
    sp_scene s;
    double z[6] = { -1 };
    start(&s, 5, 4);
    for (int k = 0; k < 5; k++) {
        const double lo[3] = { x[k] - w[k] / 2, 0.1 * k, z[k] }, hi[3] = { x[k] + w[k] / 2, 1 - 0.05 * k, z[k] + h[k] };
        z[k + 1] = hi[2];
        box(&s, lo, hi, k ? 0 : SP_FIXED);
    }
    for (int k = 1; k < 5; k++)                         /* the upper face is the smaller */
        level(&s, k - 1, k, x[k] - w[k] / 2, x[k] + w[k] / 2, 0.1 * k, 1 - 0.05 * k, z[k], 0.5);
    const sp_result r = check(&s, NULL, SP_STABLE);
    for (int k = 1; k < 5; k++) {
        double weight = 0, mx = 0, my = 0;
        for (int i = k; i < 5; i++) {
            const double one = (double)s.block[i].mass * gravity;
            weight += one;
            mx += one * x[i];
            my += one * (0.5 + 0.025 * i);
        }
        sp_joint_force f;
        CHECK_INT(sp_joint_resultant(&s, &r, k - 1, &f), SP_OK);
        CHECK_NEAR(f.force[2], weight, NEAR);
        CHECK_WITHIN(f.force[0] / R(weight), 0, NEAR);
        CHECK_WITHIN(f.force[1] / R(weight), 0, NEAR);
        CHECK_WITHIN(f.point[0], mx / weight, NEAR);
        CHECK_WITHIN(f.point[1], my / weight, NEAR);
        CHECK_NEAR(f.point[2], z[k], NEAR);
        CHECK_WITHIN(f.utilisation, 0, NEAR);
        CHECK(f.min_fn > 0 && f.min_fn <= f.max_fn && f.max_fn <= r.extremes.compression);
    }
}

/* Weight at e off the middle of a joint w wide: its four corners carry W / 4 (1 +- 2 e / w). */
TEST(corners_of_an_offset_cube_share_its_weight_by_the_lever)
{
    for (int k = 0; k < 5; k++) {
        const double offset = 0.1 * k, width = 1 - offset, e = 0.5 * offset, W = density * gravity;
        sp_scene s;
        sp_joint_force f;
        test_arena.used = 0;
        build("two-cubes", "offset", offset, &s);
        const sp_result r = check(&s, NULL, SP_STABLE);
        CHECK_INT(sp_joint_resultant(&s, &r, 0, &f), SP_OK);
        CHECK_NEAR(f.max_fn, W / 4 * (1 + 2 * e / width), NEAR);
        CHECK_NEAR(f.min_fn, W / 4 * (1 - 2 * e / width), NEAR);
        CHECK_NEAR(r.extremes.compression, f.max_fn, 0);
        CHECK_NEAR(f.point[0], 0.5 + offset, NEAR);
        CHECK_NEAR(f.point[1], 0.5, NEAR);
        CHECK_INT(r.extremes.weakest, 0);
    }
}

/* The reactions of all supports carry all free weight; so do the moments about the origin. */
TEST(supports_carry_the_weight_of_everything_free)
{
    static const char *const name[] = { "two-cubes", "arch", "wall", "vault", "h-model", "rubble", "flat-arch" };
    for (size_t k = 0; k < sizeof name / sizeof name[0]; k++) {
        sp_scene s;
        test_arena.used = 0;
        build(name[k], NULL, 0, &s);
        const sp_result r = check(&s, NULL, SP_STABLE);
        double weight = 0, sum[3] = { 0, 0, 0 }, turn[3] = { 0, 0, 0 }, arm = 0;
        for (int32_t b = 0; b < s.count.blocks; b++) {
            sp_real F[3], M[3];
            const sp_real *c = s.block[b].centroid;
            const double own = (double)s.block[b].mass * gravity;
            CHECK_INT(sp_block_resultant(&s, &r, b, F, M), SP_OK);
            if (s.block[b].fixed != SP_FIXED) {
                CHECK_NEAR(F[2], own, TOL(1e-7, 2e-2)); /* a block's forces may be many times its weight */
                weight += own;
                turn[0] += (double)c[1] * own;          /* minus that of weight: minus c x (0, 0, -own) */
                turn[1] -= (double)c[0] * own;
                arm += own * norm(c);
                continue;
            }
            for (int i = 0; i < 3; i++) {
                const int j = (i + 1) % 3, l = (i + 2) % 3;
                sum[i] += (double)F[i];
                turn[i] += (double)M[i] + (double)c[j] * (double)F[l] - (double)c[l] * (double)F[j];
            }
        }
        CHECK_NEAR(sum[2], -weight, TOL(1e-8, 1e-3));   /* what the contacts do to the supports: press them down */
        CHECK_WITHIN(sum[0] / weight, 0, TOL(1e-8, 1e-3));
        CHECK_WITHIN(sum[1] / weight, 0, TOL(1e-8, 1e-3));
        for (int i = 0; i < 3; i++) CHECK_WITHIN(turn[i] / arm, 0, TOL(1e-8, 1e-3));
    }
}

TEST(both_sides_of_a_joint_feel_opposite_forces)
{
    sp_scene s;
    sp_real F[2][3], M[2][3];
    sp_joint_force f;
    build("two-cubes", NULL, 0, &s);
    const sp_result r = check(&s, NULL, SP_STABLE);
    for (int b = 0; b < 2; b++) CHECK_INT(sp_block_resultant(&s, &r, b, F[b], M[b]), SP_OK);
    CHECK_INT(sp_joint_resultant(&s, &r, 0, &f), SP_OK);
    for (int c = 0; c < 3; c++) {
        CHECK_NEAR(F[1][c], f.force[c], NEAR);
        CHECK_NEAR(F[0][c], -f.force[c], NEAR);
    }
    CHECK_NEAR(M[0][1], 0.3 * density * gravity, NEAR);     /* .3 to the right of the lower centroid, pressing down */
    CHECK_WITHIN(M[1][1] / R(density * gravity), 0, NEAR);
}

TEST(resultants_say_which_argument_they_cannot_use)
{
    sp_scene s;
    sp_real F[3], M[3];
    sp_joint_force f;
    build("two-cubes", NULL, 0, &s);
    sp_result r = check(&s, NULL, SP_STABLE);
    CHECK_INT(sp_joint_resultant(NULL, &r, 0, &f), SP_E_ARGUMENT);
    CHECK_INT(sp_joint_resultant(&s, NULL, 0, &f), SP_E_ARGUMENT);
    CHECK_INT(sp_joint_resultant(&s, &r, 0, NULL), SP_E_ARGUMENT);
    CHECK_INT(sp_joint_resultant(&s, &r, -1, &f), SP_E_INDEX);
    CHECK_INT(sp_joint_resultant(&s, &r, 1, &f), SP_E_INDEX);
    CHECK_INT(sp_block_resultant(NULL, &r, 0, F, M), SP_E_ARGUMENT);
    CHECK_INT(sp_block_resultant(&s, NULL, 0, F, M), SP_E_ARGUMENT);
    CHECK_INT(sp_block_resultant(&s, &r, 0, NULL, M), SP_E_ARGUMENT);
    CHECK_INT(sp_block_resultant(&s, &r, 0, F, NULL), SP_E_ARGUMENT);
    CHECK_INT(sp_block_resultant(&s, &r, -1, F, M), SP_E_INDEX);
    CHECK_INT(sp_block_resultant(&s, &r, 2, F, M), SP_E_INDEX);
    r.f = NULL;
    CHECK_INT(sp_joint_resultant(&s, &r, 0, &f), SP_E_ARGUMENT);
    CHECK_INT(sp_block_resultant(&s, &r, 0, F, M), SP_E_ARGUMENT);
}

/* 3 -------------------------------------------------------------------------------------------- utilisation, weakest joint */

TEST(utilisation_on_a_slope_is_its_tangent_over_mu)
{
    static const double angle[] = { 1, 10, 20, 30, 40 }, turn[] = { 0, 33, 100 };
    for (size_t k = 0; k < sizeof angle / sizeof angle[0]; k++)
        for (size_t i = 0; i < sizeof turn / sizeof turn[0]; i++) {
            gen_scene g;
            sp_scene s;
            sp_joint_force f;
            test_arena.used = 0;
            gen_open(&g, "incline");
            gen_set(&g, "angle", angle[k]);
            gen_set(&g, "turn", turn[i]);
            CHECK_INT(gen_build(&g, &test_arena, &s), SP_OK);
            const sp_result r = check(&s, NULL, SP_STABLE);
            CHECK_INT(sp_joint_resultant(&s, &r, 0, &f), SP_OK);
            CHECK_NEAR(f.utilisation, tan(angle[k] / deg) / 0.84, TOL(1e-8, 1e-3));
            CHECK_NEAR(r.extremes.utilisation, f.utilisation, 0);
            CHECK_NEAR(norm(f.force), density * 0.2 * gravity, NEAR);
        }
}

/* Where a joint is pressed and how much of its friction it uses does not depend on whether that is kilonewtons or nothing a scale
 * would show. */
TEST(a_joint_of_feathers_reads_as_one_of_stones)
{
    sp_joint_force f[2];
    for (int light = 0; light < 2; light++) {
        sp_scene s;
        test_arena.used = 0;
        build("two-cubes", "offset", 0.3, &s);
        for (int c = 0; c < 3; c++) s.gravity[c] *= light ? R(1.0 / (1 << 30)) : 1;
        s.gravity[0] = s.gravity[2] / 4;
        const sp_result r = check(&s, NULL, SP_STABLE);
        CHECK_INT(sp_joint_resultant(&s, &r, 0, &f[light]), SP_OK);
    }
    CHECK(f[0].utilisation > R(0.1) && fabs((double)(f[0].point[0] - f[0].point[1])) > 0.1);
    CHECK_NEAR(f[1].utilisation, f[0].utilisation, 0);
    CHECK_NEAR(f[1].corner_utilisation, f[0].corner_utilisation, 0);
    for (int c = 0; c < 3; c++) CHECK_NEAR(f[1].point[c], f[0].point[c], 0);
}

/* A box by its sides and height on the ground. */
static void box_on_ground(double a, double h, double mu, sp_scene *s)
{
    const double ground[2][3] = { { -2, -2, -1 }, { 2, 2, 0 } }, lo[3] = { -a / 2, -a / 2, 0 }, hi[3] = { a / 2, a / 2, h };
    const sp_capacity cap = { 2, 16, 12, 48, 1, 4, 1 };
    test_arena.used = 0;
    CHECK_INT(sp_scene_create(s, &cap, &test_arena), SP_OK);
    box(s, ground[0], ground[1], SP_FIXED);
    box(s, lo, hi, 0);
    level(s, 0, 1, -a / 2, a / 2, -a / 2, a / 2, 0, mu);
}

/* On a slope of angle b the corners share the tangent evenly, and the pressure by the lever of the height: the upper two carry
 * N/4 (1 - h/a tan b), so they use tan b / (mu (1 - h/a tan b)) where the joint as a whole uses tan b / mu.      [seed 1.6] */
TEST(on_a_slope_the_upper_corners_use_more_friction_than_the_joint)
{
    static const double angle[] = { 5, 12, 20, 30 }, h = 0.5, mu = 0.84;
    for (size_t k = 0; k < sizeof angle / sizeof angle[0]; k++) {
        const double slope = tan(angle[k] / deg);
        sp_scene s;
        sp_joint_force f;
        box_on_ground(1, h, mu, &s);
        gen_gravity(angle[k], 0, s.gravity);
        const sp_result r = check(&s, NULL, SP_STABLE);
        CHECK_INT(sp_joint_resultant(&s, &r, 0, &f), SP_OK);
        CHECK_NEAR(f.utilisation, slope / mu, TOL(1e-8, 1e-3));
        CHECK_NEAR(f.corner_utilisation, slope / (mu * (1 - h * slope)), TOL(1e-8, 1e-3));
        CHECK_NEAR(r.extremes.utilisation, f.utilisation, 0);
        CHECK_NEAR(r.extremes.corner_utilisation, f.corner_utilisation, 0);
    }
}

/* Twisted about the vertical by T the corners' friction goes round and sums to nothing: the joint uses none, each corner
 * T / (mu W r), r half the diagonal.                                                                            [seed 1.6] */
TEST(a_twisted_joint_uses_friction_at_its_corners_alone)
{
    static const double part[] = { 0.1, 0.5, 0.9 }, a = 0.8, h = 0.3, mu = 0.6;
    const double W = density * a * a * h * gravity, most = mu * W * a / sqrt(2.);
    for (size_t k = 0; k < sizeof part / sizeof part[0]; k++) {
        const sp_load twist = { 1, 0, { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, R(part[k] * most) }, 0 };
        sp_scene s;
        sp_joint_force f;
        box_on_ground(a, h, mu, &s);
        CHECK_INT(sp_scene_load(&s, &twist, NULL), SP_OK);
        const sp_result r = check(&s, NULL, SP_STABLE);
        CHECK_INT(sp_joint_resultant(&s, &r, 0, &f), SP_OK);
        CHECK_WITHIN(f.utilisation, 0, TOL(1e-9, 1e-4));
        CHECK_NEAR(f.corner_utilisation, part[k], TOL(1e-8, 1e-3));
        CHECK_NEAR(r.extremes.corner_utilisation, f.corner_utilisation, 0);
    }
}

/* Held by cohesion alone, mu = 0: joint and corners alike use W sin b / C, C = cohesion area.                   [seed 1.6] */
TEST(a_corner_has_its_share_of_the_cohesion)
{
    const double a = 0.5, h = 0.5, W = density * a * a * h * gravity;
    const sp_strength glue = { 0, R(4 * W / (a * a)), 0, 0 };
    sp_scene s;
    sp_joint_force f;
    box_on_ground(a, h, 0, &s);
    s.joint[0].strength = glue;
    gen_gravity(30, 0, s.gravity);                      /* sin 30 of the weight across the joint, its corners alike */
    const sp_result r = check(&s, NULL, SP_STABLE);
    CHECK_INT(sp_joint_resultant(&s, &r, 0, &f), SP_OK);
    CHECK_NEAR(f.utilisation, 0.5 / 4, TOL(1e-8, 1e-3));
    CHECK_NEAR(f.corner_utilisation, 0.5 / 4, TOL(1e-6, 1e-2));
}

/* At the tip of a cone moved down, fn = -C / mu, nothing is left to use: what rounding leaves there is no share.    [seed 1.6] */
TEST(rounding_at_the_tip_of_a_glued_cone_was_told_as_use)
{
    const double a = 0.5, mu = 0.8, C = 16000 * a * a / 4;
    const sp_strength glue = { R(mu), R(16000), R(1e6), 0 };
    sp_scene s;
    sp_joint_force f;
    box_on_ground(a, 0.5, mu, &s);
    s.joint[0].strength = glue;
    sp_result r = check(&s, NULL, SP_STABLE);
    for (int k = 0; k < 3; k++) {
        for (int v = 0; v < 4; v++) {
            r.f[3 * v] = R(-C / mu * (1 - (k == 1) * (double)SP_EPSILON));
            r.f[3 * v + 1] = R(k * C * (double)SP_EPSILON);
            r.f[3 * v + 2] = 0;
        }
        CHECK_INT(sp_joint_resultant(&s, &r, 0, &f), SP_OK);
        CHECK_NEAR(f.corner_utilisation, 0, 0);
        CHECK_NEAR(f.utilisation, 0, 0);
    }
    r.f[1] = R(C / 10);                                 /* this is more than rounding */
    CHECK_INT(sp_joint_resultant(&s, &r, 0, &f), SP_OK);
    CHECK((double)f.corner_utilisation > 1e3);
}

#if !defined(SP_NO_QP) && !defined(SP_NO_ADMM)
/* Of two stones one is twisted, the other pushed: by its resultant the second joint is weaker, by its corners the first. */
TEST(the_weakest_joint_of_the_preset_is_that_of_its_corners)
{
    const double W = density * 0.5 * gravity, mu = 0.8, ground[2][3] = { { -2, -2, -1 }, { 4, 2, 0 } };
    const sp_capacity cap = { 3, 24, 18, 72, 2, 8, 2 };
    const sp_settings preset = sp_settings_seed();
    const sp_load load[2] = { { 1, 0, { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, R(0.5 * mu * W / sqrt(2.)) }, 0 },
                              { 2, 0, { R(1.5), R(0.5), 0 }, { R(0.3 * mu * W), 0, 0 }, { 0, 0, 0 }, 0 } };
    sp_scene s;
    test_arena.used = 0;
    CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
    box(&s, ground[0], ground[1], SP_FIXED);
    for (int k = 0; k < 2; k++) {
        const double lo[3] = { k, 0, 0 }, hi[3] = { k + 1., 1, 0.5 };
        box(&s, lo, hi, 0);
        level(&s, 0, k + 1, k, k + 1., 0, 1, 0, mu);
        CHECK_INT(sp_scene_load(&s, &load[k], NULL), SP_OK);
    }
    const sp_result ours = check(&s, NULL, SP_STABLE), seed = check(&s, &preset, SP_STABLE);
    CHECK_INT(ours.extremes.weakest, 1);
    CHECK_INT(seed.extremes.weakest, 0);
    CHECK_NEAR(ours.extremes.utilisation, 0.3, TOL(1e-8, 1e-3));
    CHECK_NEAR(seed.extremes.corner_utilisation, 0.5, TOL(1e-6, 1e-2));
}
#endif

/* Four cubes in a world that leans: every joint carries the same slope, the one with least friction is the weakest. */
TEST(the_weakest_joint_has_the_least_friction_left)
{
    static const double mu[3][3] = { { 0.5, 0.4, 0.6 }, { 0.3, 0.4, 0.6 }, { 0.9, 0.8, 0.7 } };
    static const int32_t weakest[3] = { 1, 0, 2 };
    for (int k = 0; k < 3; k++) {
        sp_scene s;
        test_arena.used = 0;
        start(&s, 4, 3);
        for (int i = 0; i < 4; i++) {
            const double lo[3] = { 0, 0, 0.2 * i }, hi[3] = { 1, 1, 0.2 * i + 0.2 };
            box(&s, lo, hi, i ? 0 : SP_FIXED);
        }
        for (int i = 0; i < 3; i++) level(&s, i, i + 1, 0, 1, 0, 1, 0.2 * i + 0.2, mu[k][i]);
        gen_gravity(12, 70, s.gravity);
        const sp_result r = check(&s, NULL, SP_STABLE);
        CHECK_INT(r.extremes.weakest, weakest[k]);
        CHECK_NEAR(r.extremes.utilisation, tan(12 / deg) / mu[k][weakest[k]], TOL(1e-8, 1e-3));
    }
}

/* Of two joints one of which would have to pull, that one is the weakest, however well used the other is. */
TEST(tension_counts_before_utilisation)
{
    const double low[2][3] = { { 0, 0, -1 }, { 1, 1, 0 } }, middle[2][3] = { { 0, 0, 0 }, { 1, 1, 0.2 } };
    const double top[2][3] = { { 0.7, 0, 0.2 }, { 1.7, 1, 0.3 } };
    sp_scene s = three(low, middle, top);
    level(&s, 0, 1, 0, 1, 0, 1, 0, 0.05);
    level(&s, 1, 2, 0.7, 1, 0, 1, 0.2, 0.84);
    gen_gravity(2, 90, s.gravity);
    const sp_settings set = helped();
    const sp_result r = check(&s, &set, SP_UNSTABLE);
    CHECK_INT(r.extremes.weakest, 1);
    CHECK(r.demand[1].tension > r.demand[0].tension);
}

/* Of a wall of rubble from which one stone falls, the joint that lacked most was far from that stone. */
TEST(the_weakest_joint_of_what_falls_touches_what_moves)
{
    sp_scene s;
    int falls = 0;
    for (int k = 0; k < 4; k++) {
        sp_result r;
        test_arena.used = 0;
        NEED(gen_make("rubble", "tilt", 38 + 2 * k, &test_arena, &s) == SP_OK);
        NEED(sp_check(&s, NULL, &test_arena, &r) == SP_OK);
        if (r.verdict != SP_UNSTABLE) continue;
        falls++;
        NEED(r.extremes.weakest >= 0);
        const sp_joint *t = &s.joint[r.extremes.weakest];
        double here = 0, all = 0;
        for (int32_t i = 0; i < 6 * s.count.blocks; i++) {
            all = fmax(all, fabs((double)r.dq[i]));
            if (i / 6 == t->a || i / 6 == t->b) here = fmax(here, fabs((double)r.dq[i]));
        }
        CHECK(here >= 1e-6 * all);
    }
    CHECK(falls > 0);
}

/* Velocity of corner v of a joint's B, seen from its A. */
static double speed(const sp_scene *s, const sp_real *dq, const sp_joint *t, int32_t v)
{
    double u[3] = { 0, 0, 0 };
    for (int side = 0; side < 2; side++) {
        const int32_t b = side ? t->a : t->b;
        const sp_real *m = dq + 6 * b;
        double r[3];
        for (int k = 0; k < 3; k++) r[k] = (double)(s->point[v][k] - s->block[b].centroid[k]);
        for (int k = 0; k < 3; k++)
            u[k] += (side ? -1 : 1) * ((double)m[k] + (double)m[3 + (k + 1) % 3] * r[(k + 2) % 3] - (double)m[3 + (k + 2) % 3] * r[(k + 1) % 3]);
    }
    return sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
}

TEST(where_help_is_not_known_the_weakest_joint_opens_or_slides_fastest)
{
    static const struct { const char *name, *param; double value; } falling[] = {
        { "overhang", "n", 8 }, { "arch", "t", 0.09 }, { "incline", "angle", 45 }, { "rubble", "tilt", 40 }, { "wall", "tilt", 50 }
    };
    for (size_t k = 0; k < sizeof falling / sizeof *falling; k++) {
        sp_scene s;
        sp_result r;
        double most = 0, there = 0;
        test_arena.used = 0;
        build(falling[k].name, falling[k].param, falling[k].value, &s);
        if (!k) gen_gravity(30, 0, s.gravity);
        NEED(CHECK_INT(sp_check(&s, NULL, &test_arena, &r), SP_OK));
        if (!CHECK_INT(r.verdict, SP_UNSTABLE) || !CHECK(r.extremes.weakest >= 0)) continue;
        for (int32_t i = 0; i < s.count.joints; i++)
            for (int32_t v = s.joint[i].point; v < s.joint[i].point + s.joint[i].points; v++) {
                const double u = speed(&s, r.dq, &s.joint[i], v);
                most = fmax(most, u);
                if (i == r.extremes.weakest) there = fmax(there, u);
            }
        CHECK(most > 0);
        CHECK_NEAR(there, most, TOL(1e-12, 1e-4));
    }
}

/* Two slabs on a slope: the lower one slides and takes the upper one along, whose joint uses more of its friction. */
TEST(a_joint_that_rides_along_is_not_the_weakest)
{
    const double low[2][3] = { { 0, 0, -1 }, { 4, 1, 0 } }, middle[2][3] = { { 1, 0, 0 }, { 2, 1, 0.1 } };
    const double top[2][3] = { { 1, 0, 0.1 }, { 2, 1, 0.2 } };
    sp_scene s = three(low, middle, top);
    level(&s, 1, 2, 1, 2, 0, 1, 0.1, 0.5);
    level(&s, 0, 1, 1, 2, 0, 1, 0, 0.3);
    gen_gravity(20, 0, s.gravity);
    const sp_result r = check(&s, NULL, SP_UNSTABLE);
    CHECK_INT(r.extremes.weakest, 1);
}

TEST(without_joints_there_is_no_weakest)
{
    sp_scene s;
    const double lo[3] = { 0, 0, 0 }, hi[3] = { 1, 1, 1 };
    start(&s, 2, 1);
    box(&s, lo, hi, SP_FIXED);
    CHECK_INT(check(&s, NULL, SP_STABLE).extremes.weakest, -1);
    const double up[3] = { 0, 0, 2 }, over[3] = { 1, 1, 3 };
    box(&s, up, over, 0);
    const sp_result r = check(&s, NULL, SP_UNSTABLE);
    CHECK_INT(r.extremes.weakest, -1);
    CHECK_INT(r.counts.joints, 0);
    CHECK_WITHIN(r.extremes.compression, 0, 0);
    CHECK_WITHIN(r.extremes.utilisation, 0, 0);
}

/* 4 --------------------------------------------------------------------------------------------------------- mechanism */

/* Largest distance of a joint's vertex from the centroid of free block b. */
static double reach(const sp_scene *s, int32_t b)
{
    double most = 0;
    for (int32_t k = 0; k < s->count.joints; k++) {
        const sp_joint *t = &s->joint[k];
        if (t->a != b && t->b != b) continue;
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            sp_real arm[3];
            for (int c = 0; c < 3; c++) arm[c] = s->point[v][c] - s->block[b].centroid[c];
            if (norm(arm) > most) most = norm(arm);
        }
    }
    return most;
}

/* A cube beyond its limit turns about the right edge of the one below: v = w x (c - edge), and nothing resists. */
TEST(a_toppling_cube_turns_about_the_edge)
{
    for (int k = 0; k < 3; k++) {
        const double offset = 0.55 + 0.1 * k;
        sp_scene s;
        test_arena.used = 0;
        build("two-cubes", "offset", offset, &s);
        const sp_result r = check(&s, NULL, SP_UNSTABLE);
        const sp_real *dq = r.dq + 6;
        CHECK_TEXT(sp_reason_text(r.reason), "mechanism");
        CHECK_INT(r.stage, SP_STAGE_EXACT);
        CHECK_INT(r.final, 1);
        for (int i = 0; i < 6; i++) CHECK_WITHIN(r.dq[i], 0, 0);
        const double w = (double)dq[4];
        CHECK(w > 0);                                   /* x to the right, z up: falling right turns z towards x */
        CHECK_WITHIN(dq[3], 0, TOL(1e-6, 1e-3));
        CHECK_WITHIN(dq[5], 0, TOL(1e-6, 1e-3));
        CHECK_WITHIN(dq[0], 0.5 * w, TOL(1e-6, 1e-3));
        CHECK_WITHIN(dq[1], 0, TOL(1e-6, 1e-3));
        CHECK_WITHIN(dq[2], -(offset - 0.5) * w, TOL(1e-6, 1e-3));
        CHECK(r.least_imbalance > r.tol && r.least_imbalance <= 1);
    }
}

/* Largest displacement, speed or rotation times the block's reach, equals the largest reach. */
TEST(mechanisms_have_one_size)
{
    static const struct { const char *name, *param; double value; } table[] = {
        { "two-cubes", "offset", 0.6 }, { "arch", "t", 0.09 }, { "incline", "angle", 45 }, { "keystone", "mu", 0.2 },
        { "wall", "tilt", 50 }, { "overhang", "factor", 1.1 }, { "dome", "t", 0.02 }
    };
    for (size_t k = 0; k < sizeof table / sizeof table[0]; k++) {
        sp_scene s;
        double most = 0, size = 0;
        test_arena.used = 0;
        build(table[k].name, table[k].param, table[k].value, &s);
        const sp_result r = check(&s, NULL, SP_UNSTABLE);
        for (int32_t b = 0; b < s.count.blocks; b++) {
            const sp_real *m = r.dq + 6 * b;
            if (s.block[b].fixed == SP_FIXED) {
                for (int i = 0; i < 6; i++) CHECK_WITHIN(m[i], 0, 0);
                continue;
            }
            if (reach(&s, b) > size) size = reach(&s, b);
            if (norm(m) > most) most = norm(m);
            if (norm(m + 3) * reach(&s, b) > most) most = norm(m + 3) * reach(&s, b);
        }
        CHECK_NEAR(most, size, TOL(1e-12, 1e-5));
    }
}

/* Weight does work on every mechanism, and with forces of the state at hand no more is done by them. */
TEST(weight_drives_the_mechanism)
{
    sp_scene s;
    double work = 0;
    build("arch", "t", 0.09, &s);
    const sp_result r = check(&s, NULL, SP_UNSTABLE);
    for (int32_t b = 0; b < s.count.blocks; b++) work -= (double)s.block[b].mass * gravity * (double)r.dq[6 * b + 2];
    CHECK(work > 0);
}

/* The search leaves its own motions where the answer will be. */
TEST(what_stands_has_no_mechanism)
{
    static const char *const names[] = { "arch", "dome", "wall" };
    for (int k = 0; k < 3; k++) {
        sp_scene s;
        test_arena.used = 0;
        build(names[k], NULL, 0, &s);
        const sp_result r = check(&s, NULL, SP_STABLE);
        for (int32_t i = 0; i < 6 * s.count.blocks; i++) CHECK_WITHIN(r.dq[i], 0, 0);
    }
}

TEST(only_cones_that_reach_around_friction_make_it_final)
{
    for (int k = 0; k < 3; k++) {
        sp_scene s;
        sp_settings set = sp_settings_default();
        test_arena.used = 0;
        build("two-cubes", "offset", 0.6, &s);
        set.faces = k ? 8 : 0;
        set.inscribed = k == 2;
        CHECK_INT(check(&s, &set, SP_UNSTABLE).final, k < 2);
        build("two-cubes", "offset", 0.4, &s);
        CHECK_INT(check(&s, &set, SP_STABLE).final, 0);
    }
}

/* 5 --------------------------------------------------------------------------------------------------- costs, sameness */

static const struct { const char *name, *param; double value; } sample[] = {
    { "two-cubes", NULL, 0 }, { "two-cubes", "offset", 0.7 }, { "arch", NULL, 0 }, { "arch", "t", 0.09 }, { "wall", "jitter", 0.3 },
    { "wall", "tilt", 40 }, { "vault", NULL, 0 }, { "h-model", "mu", 0 }, { "rubble", "tilt", 30 }
};

static int same_bytes(const void *a, const void *b, size_t n) { return memcmp(a, b, n) == 0; }

TEST(two_runs_give_the_same_bits)
{
    for (size_t k = 0; k < sizeof sample / sizeof sample[0]; k++) {
        sp_scene s, t;
        sp_result a, b;
        const sp_settings set = helped();
        test_arena.used = 0;
        build(sample[k].name, sample[k].param, sample[k].value, &s);
        CHECK_INT(sp_check(&s, &set, &test_arena, &a), SP_OK);
        memset(test_arena.base + test_arena.used, 0xa5, 1u << 20);      /* nothing may depend on what memory held */
        build(sample[k].name, sample[k].param, sample[k].value, &t);
        CHECK_INT(sp_check(&t, &set, &test_arena, &b), SP_OK);
        CHECK_INT(a.verdict, b.verdict);
        CHECK(same_bytes(a.f, b.f, 3 * (size_t)s.count.points * sizeof *a.f));
        CHECK(same_bytes(a.dq, b.dq, 6 * (size_t)s.count.blocks * sizeof *a.dq));
        CHECK(same_bytes(a.y0, b.y0, 6 * (size_t)a.counts.free_blocks * sizeof *a.y0));
        CHECK(same_bytes(a.demand, b.demand, (size_t)s.count.joints * sizeof *a.demand));
        CHECK(same_bytes(&a.imbalance, &b.imbalance, sizeof a.imbalance) && same_bytes(&a.least_imbalance, &b.least_imbalance, sizeof a.imbalance));
        CHECK_INT(a.spent.total.flops, b.spent.total.flops);
        CHECK_INT(a.spent.total.iterations, b.spent.total.iterations);
        CHECK_INT(a.spent.total.factorisations, b.spent.total.factorisations);
        CHECK_INT(a.extremes.weakest, b.extremes.weakest);
    }
}

TEST(costs_add_up_and_are_not_nothing)
{
    for (size_t k = 0; k < sizeof sample / sizeof sample[0]; k++) {
        sp_scene s;
        sp_settings set = sp_settings_default();
        test_arena.used = 0;
        build(sample[k].name, sample[k].param, sample[k].value, &s);
        for (set.localise = 0; set.localise < 2; set.localise++) {
            sp_result r;
            int64_t flops = 0;
            int32_t iterations = 0, factorisations = 0;
            CHECK_INT(sp_check(&s, &set, &test_arena, &r), SP_OK);
            for (int i = 0; i < SP_STAGES_MAX; i++) {
                flops += r.spent.by_stage[i].flops;
                iterations += r.spent.by_stage[i].iterations;
                factorisations += r.spent.by_stage[i].factorisations;
                CHECK(i < 2 || (!r.spent.by_stage[i].flops && !r.spent.by_stage[i].iterations && !r.spent.by_stage[i].factorisations));
            }
            CHECK(r.spent.by_stage[1].flops > 0 && r.spent.by_stage[1].factorisations > 0);
            if (set.localise && r.verdict != SP_STABLE) CHECK(r.spent.total.flops > flops && r.spent.total.factorisations > factorisations);
            else CHECK(r.spent.total.flops == flops && r.spent.total.factorisations == factorisations && r.spent.total.iterations == iterations);
            CHECK(r.spent.peak_bytes > 0 && r.spent.peak_bytes <= test_arena.capacity);
        }
    }
}

/* Work goes with the number of joints: a wall ten times as long costs about ten times as much, not a hundred. */
TEST(work_on_walls_grows_in_proportion)
{
    double per_joint[2];
    for (int k = 0; k < 2; k++) {
        gen_scene g;
        sp_scene s;
        test_arena.used = 0;
        gen_open(&g, "wall");
        gen_set(&g, "rows", 5);
        gen_set(&g, "bricks", k ? 60 : 6);
        CHECK_INT(gen_build(&g, &test_arena, &s), SP_OK);
        const sp_result r = check(&s, NULL, SP_STABLE);
        per_joint[k] = (double)r.spent.total.flops / s.count.joints;
    }
    CHECK(per_joint[1] < 3 * per_joint[0]);
}

TEST(counts_are_of_what_took_part)
{
    sp_scene s;
    const double ground[2][3] = { { 0, 0, -1 }, { 4, 1, 0 } }, pier[2][3] = { { 0, 0, 0 }, { 1, 1, 1 } };
    const double top[2][3] = { { 0, 0, 1 }, { 1, 1, 2 } };
    start(&s, 3, 2);
    box(&s, ground[0], ground[1], SP_FIXED);
    box(&s, pier[0], pier[1], SP_FIXED);
    box(&s, top[0], top[1], 0);
    level(&s, 0, 1, 0, 1, 0, 1, 0, 0.84);               /* between two supports: takes no part, carries nothing */
    level(&s, 1, 2, 0, 1, 0, 1, 1, 0.84);
    const sp_result r = check(&s, NULL, SP_STABLE);
    CHECK_INT(r.counts.free_blocks, 1);
    CHECK_INT(r.counts.joints, 1);
    CHECK_INT(r.counts.points, 4);
    for (int32_t k = 0; k < 12; k++) CHECK_WITHIN(r.f[k], 0, 0);
    for (int32_t k = 12; k < 24; k += 3) CHECK_NEAR(r.f[k], density * gravity / 4, NEAR);
}

/* No pull at a joint holds what has no path to a support: where to help is not asked, nor what bilateral forces there are. The
 * wall's first block is its support. */
TEST(stones_without_a_path_to_a_support_cost_no_factorisation)
{
    sp_scene s;
    test_arena.used = 0;
    build("wall", "size", 30, &s);
    for (int32_t k = 0; k < s.count.blocks; k++) s.block[k].fixed = 0;
    const sp_result r = check(&s, NULL, SP_UNSTABLE);
    CHECK_INT(r.reason, SP_REASON_NO_SUPPORT);
    CHECK_INT(r.spent.total.factorisations, 0);
    CHECK_INT(r.final, 1);
    const int64_t few = 300 * (int64_t)s.count.points;  /* 6,300 a corner by least squares that settle */
    CHECK(r.spent.total.flops < few);
#ifndef SP_NO_CRA
    sp_settings set = sp_settings_default();            /* by a search for where help is wanted: hundreds of them */
    set.coupled.asked = set.localise = 1;
    const sp_result c = check(&s, &set, SP_UNSTABLE);
    CHECK_INT(c.spent.total.factorisations, 0);
    CHECK(c.spent.total.flops < 2 * few);
#endif
}

TEST_LIST(result)
    RUN(tension_of_an_overhanging_box_follows_from_its_moments)
    RUN(net_friction_shows_no_tension)
    RUN(nothing_is_demanded_where_it_stands_or_nobody_asks)
    RUN(missing_friction_of_a_sliding_block_follows_from_its_price)
    RUN(a_joint_of_a_stack_carries_the_weight_above_it_below_its_centre)
    RUN(corners_of_an_offset_cube_share_its_weight_by_the_lever)
    RUN(supports_carry_the_weight_of_everything_free)
    RUN(both_sides_of_a_joint_feel_opposite_forces)
    RUN(resultants_say_which_argument_they_cannot_use)
    RUN(utilisation_on_a_slope_is_its_tangent_over_mu)
    RUN(a_joint_of_feathers_reads_as_one_of_stones)
    RUN(on_a_slope_the_upper_corners_use_more_friction_than_the_joint)
    RUN(a_twisted_joint_uses_friction_at_its_corners_alone)
    RUN(a_corner_has_its_share_of_the_cohesion)
    RUN(rounding_at_the_tip_of_a_glued_cone_was_told_as_use)
#if !defined(SP_NO_QP) && !defined(SP_NO_ADMM)
    RUN(the_weakest_joint_of_the_preset_is_that_of_its_corners)
#endif
    RUN(the_weakest_joint_has_the_least_friction_left)
    RUN(tension_counts_before_utilisation)
    RUN(the_weakest_joint_of_what_falls_touches_what_moves)
    RUN(where_help_is_not_known_the_weakest_joint_opens_or_slides_fastest)
    RUN(a_joint_that_rides_along_is_not_the_weakest)
    RUN(without_joints_there_is_no_weakest)
    RUN(a_toppling_cube_turns_about_the_edge)
    RUN(mechanisms_have_one_size)
    RUN(weight_drives_the_mechanism)
    RUN(what_stands_has_no_mechanism)
    RUN(only_cones_that_reach_around_friction_make_it_final)
    RUN(two_runs_give_the_same_bits)
    RUN(costs_add_up_and_are_not_nothing)
    RUN(work_on_walls_grows_in_proportion)
    RUN(counts_are_of_what_took_part)
    RUN(stones_without_a_path_to_a_support_cost_no_factorisation)
TEST_END
