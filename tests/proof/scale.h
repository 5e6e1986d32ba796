/* What the suites of scales share: the certificate check from the inside, on one block and on a chain of four. All of it
 * static; they include the parts of the library first. */
#ifndef SCALE_H
#define SCALE_H

/* A block of mass m, side a, its centroid h above a joint of four corners on fixed ground, the joint tilted by `angle`. */
typedef struct one_block {
    sp_scene scene;
    sp_problem pb;
    sp_settings set;
    sp__certifier j;
} one_block;

static int place(one_block *o, double mass, double a, double h, double angle, double mu)
{
    const sp_capacity room = { 2, 0, 0, 0, 1, 4, 0 };
    const double c = cos(angle), s = sin(angle);
    const sp_real ground[3] = { 0, 0, -1 }, at[3] = { R(-s * h), 0, R(c * h) };
    sp_real corner[12];
    for (int k = 0; k < 4; k++) {
        const double x = (k == 1 || k == 2 ? a : -a) / 2, y = (k > 1 ? a : -a) / 2;
        corner[3 * k] = R(c * x);
        corner[3 * k + 1] = R(y);
        corner[3 * k + 2] = R(s * x);
    }
    memset(o, 0, sizeof *o);
    o->set.tol = R(TOL(1e-9, 1e-4f));
    o->set.force_bound = 100;
    o->set.iterations = 300;
    const sp_strength strength = { R(mu), 0, 0, 0 };
    if (!CHECK_INT(sp_scene_create(&o->scene, &room, &test_arena), SP_OK)) return 0;
    if (!CHECK_INT(sp_scene_body(&o->scene, 0, ground, SP_FIXED, NULL), SP_OK)) return 0;
    if (!CHECK_INT(sp_scene_body(&o->scene, R(mass), at, 0, NULL), SP_OK)) return 0;
    if (!CHECK_INT(sp_scene_joint(&o->scene, 0, 1, 4, corner, &strength, NULL), SP_OK)) return 0;
    return CHECK_INT(sp_problem_build(&o->scene, &test_arena, &o->pb), SP_OK);
}

static int judge(one_block *o, const sp_real *hint)
{
    return CHECK(sp__certifier_open(&o->j, &o->pb, &o->set, hint, INT32_MAX, &test_arena));
}

/* A chain of four blocks of unlike weight on few points near each other, one of them loaded; `draws` is where its
 * numbers come from. */
static int chain(one_block *o, uint32_t *draws)
{
    const sp_capacity room = { 5, 0, 0, 0, 4, 12, 1 };
    const sp_load load = { 3, 0, { R(0.3), R(-0.2), 3 }, { 5, -20, 9 }, { 4, 8, -7 }, 0 };
    const sp_real ground[3] = { 0, 0, 0 };
    const sp_strength rough = { R(0.5), 0, 0, 0 };
    const double spread = pow(10, test_draw(draws, -7, 0));
    memset(o, 0, sizeof *o);
    o->set.tol = R(TOL(1e-9, 1e-4f));
    o->set.force_bound = 100;
    if (!CHECK_INT(sp_scene_create(&o->scene, &room, &test_arena), SP_OK)) return 0;
    if (!CHECK_INT(sp_scene_body(&o->scene, 0, ground, SP_FIXED, NULL), SP_OK)) return 0;
    for (int b = 1; b < 5; b++) {
        const sp_real at[3] = { R(test_draw(draws, -1, 1)), R(test_draw(draws, -1, 1)), R(b) };
        const sp_real n[3] = { R(test_draw(draws, -1, 1)), R(test_draw(draws, -1, 1)), 1 };
        sp_real x[9];
        for (int k = 0; k < 9; k++) x[k] = R(k % 3 == 2 ? b - 0.5 : spread * test_draw(draws, -1, 1));
        if (!CHECK_INT(sp_scene_body(&o->scene, R(pow(10, test_draw(draws, 0, 4))), at, 0, NULL), SP_OK)) return 0;
        const int32_t points = 1 + (int32_t)(3 * test_draw(draws, 0, 1));
        if (!CHECK_INT(sp_scene_points(&o->scene, b - 1, b, n, points, x, &rough, NULL), SP_OK)) return 0;
    }
    if (!CHECK_INT(sp_scene_load(&o->scene, &load, NULL), SP_OK)) return 0;
    return CHECK_INT(sp_problem_build(&o->scene, &test_arena, &o->pb), SP_OK);
}

/* a x b, and |a|, in double. */
static void cross(const double a[3], const double b[3], double c[3])
{
    for (int k = 0; k < 3; k++) c[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}
static double length(const double a[3]) { return sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]); }

/* r - c of scene block b at point v of a chain; points of joint b - 1 and of joint b are its own. */
static int arm_of(const one_block *o, int32_t b, int32_t v, double arm[3])
{
    for (int k = 0; k < 3; k++) arm[k] = (double)o->scene.point[v][k] - (double)o->scene.block[b].centroid[k];
    for (int32_t q = b - 1; q <= b && q < 4; q++) {
        const sp_joint *j = &o->scene.joint[q];
        if (v >= j->point && v < j->point + j->points) return 1;
    }
    return 0;
}

#endif
