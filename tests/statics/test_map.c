/* Where a scene is planar or level, 3 rows a block say what 6 do: of motions that keep the mirror, or that only press, forces,
 * gradient, slope, sizes and Hessian of the narrow kernel are those of the wide one. Gradient and Hessian of the wide one are
 * compared with differences in test_gradient.c. */
#define SP_API static
#include "../test.h"
#include "../../solvers/base/words.c"
#include "../../solvers/scene/scene.c"
#include "../../solvers/scene/block.c"
#include "../../solvers/statics/interior.c"
#include "../scenes/gen.h"
#include "../scenes/change.h"

/* strong: every other joint has mortar; turned: any way in space */
static const struct { const char *name, *number; double value; sp__mode mode; int32_t faces; int strong, turned; } scene_of[] = {
    { "arch", "n", 7, SP__PLANE, 0, 0, 0 },       { "arch", "n", 9, SP__PLANE, 0, 0, 1 },
    { "arch", "n", 8, SP__PLANE, 8, 0, 1 },       { "wall", "tilt", 20, SP__PLANE, 0, 0, 1 },
    { "wall", "jitter", 0.3, SP__PLANE, 4, 0, 1 }, { "arch", "n", 6, SP__PLANE, 5, 0, 1 },
    { "arch", "n", 11, SP__PLANE, 0, 1, 1 },
    { "wall", "jitter", 0.2, SP__PLANE, 4, 1, 0 }, { "tower", "n", 6, SP__LEVEL_JOINTS, 0, 0, 0 },
    { "diamond", "rows", 4, SP__LEVEL_JOINTS, 0, 0, 1 }, { "wall", "jitter", 0.3, SP__LEVEL_JOINTS, 0, 0, 1 },
    { "overhang", "n", 5, SP__LEVEL_JOINTS, 6, 0, 1 }
};

enum { SCENES = sizeof scene_of / sizeof scene_of[0], POINTS = 3 };

/* The two kernels side by side: [0] in 3 rows, [1] in 6. */
typedef struct both {
    sp_scene scene;
    sp_problem pb[2];
    sp_settings set[2];
    sp_cost cost;
    sp__reduction *o;
    sp__system *w[2];
    size_t n;
    sp_real *y[2], *d[2], *r[2], *x[2], *f[2];
} both;

static void settle(sp_settings *set, int k)
{
    memset(set, 0, sizeof *set);
    set->tol = R(TOL(1e-9, 1e-4f));
    set->penalty.gamma = R(7);
    set->penalty.tau = R(2);
    set->inscribed = 1;
    set->iterations = SP__ITERATIONS;
    set->stage_count = 1;
    set->stage[0] = SP_STAGE_EXACT;
    set->faces = scene_of[k].faces;
    if (scene_of[k].mode == SP__LEVEL_JOINTS) set->effect[SP_EFFECT_DEPTH] = SP_WITH;
}

/* Tangents of joints in another direction than along an edge: any where cones are round, else a quarter turn further. */
static void turn_tangents(sp_scene *s, int quarter)
{
    for (int32_t j = 0; j < s->count.joints; j++) {
        sp_joint *t = &s->joint[j];
        const double a = (double)test_random_real(-3, 3), c = quarter ? 0 : cos(a), r = quarter ? 1 : sin(a);
        for (int q = 0; q < 3; q++) t->t1[q] = R(c * (double)t->t1[q] + r * (double)t->t2[q]);
        sp__cross3(t->n, t->t1, t->t2);
    }
}

static int make_scene(int k, sp_scene *s)
{
    int32_t place[MOST], name[MOST];
    sp_scene made;
    change c = none();
    if (!CHECK_INT(gen_make(scene_of[k].name, scene_of[k].number, scene_of[k].value, &test_arena, &made), SP_OK)) return 0;
    if (!CHECK(made.count.blocks <= MOST && made.count.joints <= MOST)) return 0;
    if (scene_of[k].turned) any_turn(&c);
    c.swap = scene_of[k].turned && scene_of[k].mode == SP__LEVEL_JOINTS;  /* n along the loads and against them */
    copy(&made, &c, s, place, name);
    if (scene_of[k].faces % 2 || !scene_of[k].faces) turn_tangents(s, scene_of[k].faces);
    for (int32_t j = 0; j < s->count.joints && scene_of[k].strong; j += 2) {
        s->joint[j].strength.cohesion = R(3000);
        s->joint[j].strength.tension = R(1000);
        s->joint[j].strength.crushing = R(40000);
    }
    return 1;
}

/* Corners of planar joints out of their planes, images alike: by as much as a joint is wide, where the library knows 1e-6 of it. */
static void warp(both *b)
{
    const sp_problem *pb = &b->pb[0];
    for (int32_t c = 0; c < pb->contacts && b->o->mode == SP__PLANE; c++) {
        const sp_contact *t = &pb->contact[c];
        const sp_real h[2] = { sp__dot3(b->o->e[2], t->joint->t1), sp__dot3(b->o->e[2], t->joint->t2) };
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            const int32_t image = sp__mirror_image(pb, t, v, h, R(1e-4));
            if (image >= v) pb->local[v][0] = pb->local[image][0] = test_random_real(-0.2, 0.2);
        }
    }
}

/* The problem that 6 rows get: level ones without joints that stand upright, which 3 rows leave out. */
static int make_wide(both *b)
{
    const sp_problem *all = &b->pb[0];
    sp_problem *pb = &b->pb[1];
    *pb = *all;
    pb->contacts = 0;
    pb->contact = sp__take(&test_arena, (size_t)all->contacts, sizeof *pb->contact);
    if (!CHECK(pb->contact != NULL)) return 0;
    for (int32_t c = 0; c < all->contacts; c++) {
        const sp_real along = sp__dot3(all->contact[c].joint->n, b->o->e[2]);
        if (b->o->mode == SP__LEVEL_JOINTS && sp__abs(along) < R(0.5)) continue;
        pb->contact[pb->contacts++] = all->contact[c];
    }
    if (b->o->mode == SP__LEVEL_JOINTS) b->set[1].effect[SP_EFFECT_FRICTION] = SP_WITHOUT;
    return 1;
}

/* The same scales of forces in both: a metric and sizes without pattern. */
static void scale_both(both *b, int with_metric)
{
    for (size_t q = 0; q < 2 * (size_t)b->pb[0].blocks; q++)
        b->w[0]->measure.size[q] = b->w[1]->measure.size[q] = test_random_real(0.2, 5);
    for (int i = 0; i < 2; i++) {
        b->w[i]->measure.metric = with_metric ? R(0.2) : 0;
        sp__system_weights(b->w[i]);
    }
    for (size_t q = 0; q < 2 * (size_t)b->pb[0].blocks; q++)
        CHECK_NEAR(b->w[0]->measure.weight[q], b->w[1]->measure.weight[q], TOL(1e-10, 1e-4));
}

/* A motion in 3 rows, and the same in 6. */
static void same_motion(both *b, sp_real **m)
{
    for (size_t q = 0; q < b->n; q++) m[0][q] = 0;
    for (size_t i = 0; i < b->n; i += 6)
        for (int q = 0; q < 3; q++) m[0][i + sp__reduction_row(b->o, q)] = test_random_real(-1, 1);
    memcpy(m[1], m[0], b->n * sizeof **m);
    for (size_t i = 0; i < b->n; i += 3) sp__reduction_turn_back(b->o, m[1] + i);
}

static int begin(both *b, int k, sp__form form)
{
    sp_arena *a = &test_arena;
    memset(b, 0, sizeof *b);
    settle(&b->set[0], k);
    settle(&b->set[1], k);
    if (!make_scene(k, &b->scene) || !CHECK_INT(sp_problem_build(&b->scene, a, &b->pb[0]), SP_OK)) return 0;
    sp__reduction chosen;
    if (!CHECK(sp__reduction_choose(&b->pb[0], &b->set[0], &chosen)) || !CHECK_INT(chosen.mode, scene_of[k].mode)) return 0;
    b->o = &chosen;
    warp(b);
    if (!make_wide(b)) return 0;
    b->n = 6 * (size_t)b->pb[0].blocks;
    sp_real **all[4] = { b->y, b->d, b->r, b->x };
    for (int q = 0; q < 8; q++) all[q / 2][q % 2] = sp__take(a, b->n, sizeof **b->y);
    for (int q = 0; q < 2; q++) b->f[q] = sp__take(a, (size_t)b->pb[0].points, 3 * sizeof **b->f);
    b->w[1] = sp__system_make_full(&b->pb[1], &b->set[1], form, &b->cost, a);
    b->o = sp__take(a, 1, sizeof *b->o);
    if (!CHECK(b->w[1] && b->o)) return 0;
    *b->o = chosen;
    b->w[0] = sp__system_make(&b->pb[0], &b->set[0], form, b->o, &b->cost, a);
    if (!CHECK(b->w[0] != NULL)) return 0;
    scale_both(b, k % 2);
    same_motion(b, b->y);
    same_motion(b, b->d);
    return 1;
}

/* n numbers are the same, relative to the norm of `want`, which is not nothing. */
static void same_numbers(const sp_real *got, const sp_real *want, size_t n, double tol)
{
    double off = 0, size = 0;
    for (size_t q = 0; q < n; q++) {
        off += pow((double)got[q] - (double)want[q], 2);
        size += pow((double)want[q], 2);
    }
    CHECK(size > 1e-6);
    CHECK_WITHIN(sqrt(off), 0, tol * sqrt(size));
}

/* Rows or motions: those of 6 rows in the axes of 3. */
static void same_rows(both *b, sp_real **r, double tol)
{
    for (size_t i = 0; i < b->n; i += 3) sp__reduction_turn(b->o, r[1] + i, r[1] + i);
    same_numbers(r[0], r[1], b->n, tol);
}

/* Is this scene planar, or are only forces along the loads asked for? Level ones have no bilateral friction in 3 rows. */
static int asks(int k, sp__law law) { return scene_of[k].mode == SP__PLANE || law == SP__ADMISSIBLE; }

TEST(gradient_and_forces_in_3_rows_are_those_in_6)
{
    static const sp__form form[] = { SP__EXACT, SP__PENALTY };
    for (int q = 0; q < 2 * SCENES * POINTS; q++) {
        const int k = q / 2 % SCENES;
        const sp_arena mark = test_arena;
        both b;
        NEED(begin(&b, k, form[q % 2]));
        for (sp__law law = SP__BILATERAL; law <= SP__ADMISSIBLE; law = (sp__law)(law + 1)) {
            if (!asks(k, law)) continue;
            for (int i = 0; i < 2; i++) {
                memset(b.f[i], 0, 3 * (size_t)b.pb[0].points * sizeof **b.f);
                sp__system_gradient(b.w[i], law, b.y[i], b.r[i], b.f[i]);
            }
            sp__reduction_copy_forces(b.o, &b.pb[0], b.f[0]);
            same_rows(&b, b.r, TOL(1e-11, 2e-4));
            same_numbers(b.f[0], b.f[1], 3 * (size_t)b.pb[0].points, TOL(1e-11, 2e-4));
        }
        test_arena.used = mark.used;
    }
}

TEST(slope_and_work_in_3_rows_are_those_in_6)
{
    for (int k = 0; k < SCENES; k++) {
        const sp_arena mark = test_arena;
        both b;
        NEED(begin(&b, k, k % 2 ? SP__EXACT : SP__PENALTY));
        double size = 0, y = 0;
        sp__system_load(b.w[1], b.r[1]);
        for (size_t q = 0; q < b.n; q++) { size += fabs((double)(b.r[1][q] * b.y[1][q])); y += fabs((double)(b.r[1][q] * b.d[1][q])); }
        CHECK(size > 1e-3);
        CHECK_WITHIN(sp__system_work(b.w[0], b.y[0]), sp__system_work(b.w[1], b.y[1]), TOL(1e-11, 2e-5) * size);
        for (int p = 0; p < POINTS; p++) {
            const sp_real s = test_random_real(-1, 1), load = sp__system_work(b.w[1], b.d[1]);
            const sp_real at = sp__system_slope(b.w[1], b.y[1], b.d[1], s) + load;
            CHECK_WITHIN(sp__system_slope(b.w[0], b.y[0], b.d[0], s) + load, at, TOL(1e-11, 1e-4) * (fabs((double)at) + y));
            for (int i = 0; i < 2; i++) {               /* gradient . d */
                for (size_t q = 0; q < b.n; q++) b.x[i][q] = b.y[i][q] + s * b.d[i][q];
                sp__system_gradient(b.w[i], SP__ADMISSIBLE, b.x[i], b.r[i], NULL);
                CHECK_WITHIN(sp__dot(b.r[i], b.d[i], b.n), at, TOL(1e-11, 1e-4) * (fabs((double)at) + y));
            }
        }
        test_arena.used = mark.used;
    }
}

/* Sums and largest arm of what forces put on blocks: sp__carry_add is asked once for a vertex that stands for two. */
TEST(blocks_bear_the_same_in_3_rows_as_in_6)
{
    for (int k = 0; k < SCENES; k++) {
        const sp_arena mark = test_arena;
        both b;
        NEED(begin(&b, k, SP__EXACT));
        for (int i = 0; i < 2; i++) {
            sp__carry_begin(b.w[i]);
            sp__system_gradient(b.w[i], SP__ADMISSIBLE, b.y[i], b.r[i], NULL);
        }
        same_numbers(b.w[0]->carried, b.w[1]->carried, b.n / 2, TOL(1e-11, 2e-4));
        for (int i = 0; i < 2; i++) {
            b.w[i]->carried = NULL;
            b.w[i]->measure.metric = 0;
            memcpy(b.w[i]->d, b.d[i], b.n * sizeof **b.d);
            sp__system_sizes(b.w[i], b.y[i]);
        }
        if (scene_of[k].mode == SP__PLANE) same_numbers(b.w[0]->measure.size, b.w[1]->measure.size, b.n / 3, TOL(1e-11, 2e-4));
        test_arena.used = mark.used;
    }
}

/* D of every vertex, symmetric as the scene is: along n, and in the plane where there is one. */
static int give_law(both *b)
{
    sp_real *D = sp__take(&test_arena, (size_t)b->pb[0].points, 6 * sizeof *D);
    if (!CHECK(D != NULL)) return 0;
    memset(D, 0, 6 * (size_t)b->pb[0].points * sizeof *D);
    for (int32_t c = 0; c < b->pb[0].contacts; c++) {
        const sp_contact *t = &b->pb[0].contact[c];
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            const int32_t image = b->o->image[v];
            if (image < v) continue;
            D[6 * v] = D[6 * image] = test_random_real(0.1, 1);
            if (b->o->mode != SP__PLANE) continue;
            D[6 * v + 3] = D[6 * image + 3] = test_random_real(0.1, 1);
            D[6 * v + 5] = D[6 * image + 5] = D[6 * v + 3];
        }
    }
    b->w[0]->law.given = b->w[1]->law.given = D;
    return 1;
}

TEST(Hessian_in_3_rows_is_that_in_6)
{
    static const sp__law law[] = { SP__BILATERAL, SP__ADMISSIBLE, SP__GIVEN };
    for (int q = 0; q < 3 * SCENES * POINTS; q++) {
        const int k = q / 3 % SCENES;
        const sp_arena mark = test_arena;
        both b;
        if (law[q % 3] == SP__BILATERAL && !asks(k, SP__BILATERAL)) continue;
        NEED(begin(&b, k, q % 2 ? SP__EXACT : SP__PENALTY));
        NEED(give_law(&b));
        for (int i = 0; i < 2; i++) {
            sp__system_factor(b.w[i], law[q % 3], b.y[i], R(0.05));
            sp__system_solve(b.w[i], b.d[i], b.x[i]);
        }
        same_rows(&b, b.x, TOL(1e-10, 2e-3));
        test_arena.used = mark.used;
    }
}

/* Gradient at y + h x. */
static void gradient_at(both *b, int i, const sp_real *x, sp_real h, sp_real *r)
{
    for (size_t k = 0; k < b->n; k++) b->d[!i][k] = b->y[i][k] + h * x[k];
    sp__system_gradient(b->w[i], SP__ADMISSIBLE, b->d[!i], r, NULL);
}

/* (H + shift) x = d for what the factor makes of d, H x by differences of gradients to both sides; in either kernel and form.
 * Where those differ a vertex comes to an edge of its cone in between, and there is no H to compare with. */
TEST(factor_inverts_differences_of_the_gradient)
{
    const sp_real h = R(TOL(1e-6, 1e-3f)), shift = R(0.5);
    int compared = 0;
    for (int q = 0; q < 4 * SCENES; q++) {
        const sp_arena mark = test_arena;
        const int i = q % 2;
        both b;
        NEED(begin(&b, q / 4, q / 2 % 2 ? SP__EXACT : SP__PENALTY));
        sp_real *x = b.x[i], *here = b.x[!i], *above = b.r[i], *below = b.r[!i];
        sp__system_factor(b.w[i], SP__ADMISSIBLE, b.y[i], shift);
        sp__system_solve(b.w[i], b.d[i], x);
        gradient_at(&b, i, x, 0, here);
        gradient_at(&b, i, x, h, above);
        gradient_at(&b, i, x, -h, below);
        double kink = 0, size = 0;
        for (size_t k = 0; k < b.n; k++) {
            kink += pow((double)(above[k] - here[k] - (here[k] - below[k])) / (double)h, 2);
            size += pow((double)b.d[i][k], 2);
            above[k] = (above[k] - below[k]) / (2 * h) + shift * x[k];
        }
        test_arena.used = mark.used;
        if (kink > TOL(1e-8, 4e-4) * size) continue;
        same_numbers(above, b.d[i], b.n, TOL(1e-5, 3e-2));
        compared++;
    }
    CHECK(compared > 3 * SCENES);
}

/* The product that the factor inverts; of the exact form, which is all it is asked for. */
TEST(product_with_the_Hessian_in_3_rows_is_that_in_6)
{
    for (int k = 0; k < SCENES; k++) {
        const sp_arena mark = test_arena;
        both b;
        NEED(begin(&b, k, SP__EXACT));
        for (int i = 0; i < 2; i++) sp__system_apply(b.w[i], NULL, b.y[i], b.d[i], b.r[i]);
        same_rows(&b, b.r, TOL(1e-11, 2e-4));
        test_arena.used = mark.used;
    }
}

#if SP__WITH_INTERIOR
/* Interior points in 3 rows: f = sum x_k e_k over the n sides of a wedge, e = S (1, +- mu) / 2 in (fn, fs), z = theta / n - e.u;
 * of level joints f = x S alone. All of it by this, without what the library makes of sides. */
typedef struct side {
    const sp_contact *t;
    sp_real e[2], lever[2], times, *x, z;
    sp_real u[3];                       /* along e of y, the predictor and the step */
    int n;                              /* sides of its vertex */
} side;

enum { SIDES = 1024 };

static side sides[SIDES];

/* Side i of vertex v of a contact at motions m. */
static side side_of(const both *b, const sp__view *k, int32_t v, int i, const sp_real *const m[3])
{
    const sp__system *w = b->w[0];
    const int n = b->o->mode == SP__PLANE ? 2 : 1;
    const sp_real S = w->inner->force_scale * sp__system_scale(w, k->c) / (sp_real)n, mu = sp__system_mu(w, k->c);
    side s = { k->t, { S, n == 1 ? 0 : i ? -S * mu / k->g[5] : S * mu / k->g[4] }, { 0, 0 }, sp__system_multiplicity(w, v),
               w->inner->x + n * v + i, 0, { 0, 0, 0 }, n };
    sp__wedge_levers(w, k->g, b->pb[0].local[v], s.lever);
    for (int q = 0; q < 3; q++) {
        sp_real X[3], u[3];
        sp__reduction_motion(w, k->t, k->g, m[q], X);
        sp__wedge_rates(w, s.lever, X, u);
        s.u[q] = s.e[0] * u[0] + s.e[1] * u[1];
    }
    s.z = w->inner->theta / (sp_real)n - s.u[0];
    return s;
}

/* All sides of vertices that count at motions y, predictor and step, into `sides`.     returns how many */
static int all_sides(const both *b, const sp_real *y, const sp_real *predictor, const sp_real *step)
{
    const sp_real *const m[3] = { y, predictor, step };
    int count = 0;
    for (int32_t c = 0; c < b->pb[0].contacts; c++) {
        const sp__view k = sp__view_of(b->w[0], c);
        for (int32_t v = k.t->point; v < k.t->point + k.t->points; v++) {
            if (!(sp__system_multiplicity(b->w[0], v) > 0) || !CHECK(count + 2 <= SIDES)) continue;
            sides[count++] = side_of(b, &k, v, 0, m);
            if (sides[count - 1].n == 2) { sides[count] = side_of(b, &k, v, 1, m); count++; }
        }
    }
    return count;
}

/* x between a half and 3 halves, y so small that z n lies between a half and 3 halves of theta. */
static void begin_inside(both *b)
{
    sp__ipm *m = b->w[0]->inner;
    sp_real *y = b->y[0];
    memset(m, 0, sizeof *m);
    m->x = b->w[0]->x;
    m->theta = R(0.7);
    m->force_scale = R(0.3);
    for (size_t q = 0; q < 2 * (size_t)b->pb[0].points; q++) m->x[q] = test_random_real(0.5, 1.5);
    for (int more = 1; more; ) {
        const int count = all_sides(b, y, y, y);
        more = 0;
        for (int i = 0; i < count; i++) more |= fabs((double)(sides[i].z * (sp_real)sides[i].n / m->theta) - 1) > 0.5;
        for (size_t q = 0; q < b->n && more; q++) y[q] /= 2;
    }
}

/* out = Aeq sum a_k e_k, a_k = what(side, m) */
static void gather_sides(const both *b, int count, sp_real (*what)(const side *, const sp__ipm *), sp_real *out)
{
    const sp__system *w = b->w[0];
    memset(out, 0, b->n * sizeof *out);
    for (int i = 0; i < count; i++) {
        const side *s = &sides[i];
        const sp_real a = s->times * what(s, w->inner), f[2] = { a * s->e[0], a * s->e[1] };
        sp_real Y[3] = { 0, 0, 0 };
        sp__wedge_gather(w, s->lever, f, Y);
        sp__reduction_gather(w, s->t, sp__reduction_frame(w, s->t), Y, out);
    }
}

/* The logarithm of z in 0.1 .. 2, which boards lack. */
static double ln(double z)
{
    const double t = (z - 1) / (z + 1);
    double sum = 0, power = t;
    for (int k = 1; k < 300; k += 2, power *= t * t) sum += power / k;
    return 2 * sum;
}

static sp_real potential(const side *s, const sp__ipm *m) { (void)m; return R(-(double)*s->x * ln((double)s->z)); }

/* -(1 - sigma) x - dx, dx = h - x / z dz, h = -x, dz = -(1 - sigma) theta / n; corrected: h = -x + (sigma mu / n - dx dz) / z of
 * the predictor dz = -theta / n - u1, dx = -x - x / z dz. */
static sp_real aim(const side *s, const sp__ipm *m)
{
    const sp_real keep = 1 - m->sigma, theta = m->theta / (sp_real)s->n, x = *s->x;
    const sp_real dz = -theta - s->u[1], dx = -x - x / s->z * dz;
    const sp_real h = m->corrected ? -x + (m->sigma * m->mu / (sp_real)s->n - dx * dz) / s->z : -x;
    return -(keep * x + h + x / s->z * keep * theta);
}

/* Changes of a step: dz = -(1 - sigma) theta / n - u2, dx = h - x / z dz, where `aim` knows all but u2. */
static void change_of(const side *s, const sp__ipm *m, sp_real *dx, sp_real *dz)
{
    const sp_real keep = 1 - m->sigma;
    *dz = -keep * m->theta / (sp_real)s->n - s->u[2];
    *dx = -aim(s, m) - keep * *s->x + *s->x / s->z * s->u[2];
}

/* The matrix is the derivative of Aeq sum -x_k log z_k e_k. */
TEST(interior_matrix_in_3_rows_is_the_derivative_of_forces_along_sides)
{
    for (int k = 0; k < SCENES; k++) {
        const sp_arena mark = test_arena;
        both b;
        if (scene_of[k].strong) continue;
        NEED(begin(&b, k, SP__EXACT));
        begin_inside(&b);
        sp__system_factor(b.w[0], SP__INTERIOR, b.y[0], SP__IPM_SHIFT);
        CHECK(!b.w[0]->inner->outside && b.w[0]->inner->gap > 0);
        sp__system_solve(b.w[0], b.d[0], b.x[0]);
        const sp_real h = R(TOL(1e-4, 1e-2)) / sp__max(1, SP_SQRT(sp__dot(b.x[0], b.x[0], b.n)));
        sp_real *at = b.x[1];
        for (int below = 0; below < 2; below++) {
            for (size_t q = 0; q < b.n; q++) at[q] = b.y[0][q] + (below ? -h : h) * b.x[0][q];
            gather_sides(&b, all_sides(&b, at, at, at), potential, b.r[below]);
        }
        for (size_t q = 0; q < b.n; q++) b.r[0][q] = (b.r[0][q] - b.r[1][q]) / (2 * h);
        same_numbers(b.r[0], b.d[0], b.n, TOL(1e-5, 5e-2));
        test_arena.used = mark.used;
    }
}

/* Right-hand sides of predictor and corrector. */
static void compare_aims(both *b, int count)
{
    sp__ipm *m = b->w[0]->inner;
    for (int corrected = 0; corrected < 2; corrected++) {
        m->corrected = corrected;
        m->sigma = corrected ? R(0.3) : 0;
        m->mu = R(0.2);
        sp__ipm_sweep(b->w[0], m, SP__AIM, b->r[0]);
        gather_sides(b, count, aim, b->r[1]);
        same_numbers(b->r[0], b->r[1], b->n, TOL(1e-12, 1e-4));
    }
}

/* The longest step, and half of it. */
static void compare_step(both *b, int count)
{
    static sp_real want[SIDES];
    sp__ipm *m = b->w[0]->inner;
    sp_real longest = 1000, dx, dz;
    for (int i = 0; i < count; i++) {
        change_of(&sides[i], m, &dx, &dz);
        if (-dx * longest > *sides[i].x) longest = *sides[i].x / -dx;
        if (-dz * longest > sides[i].z) longest = sides[i].z / -dz;
    }
    m->reach = 1000;
    sp__ipm_sweep(b->w[0], m, SP__REACH, NULL);
    CHECK(longest < 1000);
    CHECK_NEAR(m->reach, (double)longest, TOL(1e-11, 1e-3));
    m->reach = longest / 2;
    for (int i = 0; i < count; i++) {
        change_of(&sides[i], m, &dx, &dz);
        want[i] = *sides[i].x + m->reach * dx;
    }
    sp__ipm_sweep(b->w[0], m, SP__MOVE, NULL);
    for (int i = 0; i < count; i++) CHECK_NEAR(*sides[i].x, (double)want[i], TOL(1e-11, 1e-3));
}

TEST(interior_passes_in_3_rows_are_sums_over_sides)
{
    for (int k = 0; k < SCENES; k++) {
        const sp_arena mark = test_arena;
        both b;
        if (scene_of[k].strong) continue;
        NEED(begin(&b, k, SP__EXACT));
        begin_inside(&b);
        const sp_real *const along[3] = { b.y[0], b.d[0], b.d[0] };
        const int count = all_sides(&b, along[0], along[1], along[2]);
        CHECK(count > 0);
        for (int q = 0; q < 3; q++) b.w[0]->inner->along[q] = along[q];
        compare_aims(&b, count);
        compare_step(&b, count);
        test_arena.used = mark.used;
    }
}
#endif

TEST_LIST(map)
    RUN_FULL(gradient_and_forces_in_3_rows_are_those_in_6)
    RUN_FULL(slope_and_work_in_3_rows_are_those_in_6)
    RUN_FULL(blocks_bear_the_same_in_3_rows_as_in_6)
    RUN_FULL(Hessian_in_3_rows_is_that_in_6)
    RUN_FULL(factor_inverts_differences_of_the_gradient)
    RUN_FULL(product_with_the_Hessian_in_3_rows_is_that_in_6)
#if SP__WITH_INTERIOR
    RUN_FULL(interior_matrix_in_3_rows_is_the_derivative_of_forces_along_sides)
    RUN_FULL(interior_passes_in_3_rows_are_sums_over_sides)
#endif
TEST_END
