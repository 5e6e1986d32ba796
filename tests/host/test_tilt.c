/* Gravity turned, and how far it may turn: closed forms. Host only. */
#include "../test.h"
#include "../../port/host/run.h"
#include "../../port/host/tilt.h"
#include "../scenes/gen.h"

#include <math.h>
#include <stdlib.h>

#define DEGREE (3.14159265358979323846 / 180)
#define NEAR (sizeof(sp_real) == 8 ? 1e-6 : 2e-2)       /* [degree] */

TEST(azimuths_turn_from_x_to_y)
{
    const sp_real down[3] = { 0, 0, -2 };
    double h[2][3];
    tilt_level(down, h);
    for (int k = 0; k < 3; k++) {
        CHECK_NEAR(h[0][k], 2 * (k == 0), 1e-12);
        CHECK_NEAR(h[1][k], 2 * (k == 1), 1e-12);
    }
}

TEST(level_is_across_any_gravity_and_as_long)
{
    static const sp_real gravity[4][3] = { { 1, 2, 3 }, { 9, 0, 0 }, { 0, -9, 0 },
                                          { (sp_real)-0.1, (sp_real)0.2, (sp_real)0.05 } };
    for (int i = 0; i < 4; i++) {
        const sp_real *g = gravity[i];
        const double size = sqrt((double)(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]));
        double h[2][3], across = 0;
        tilt_level(g, h);
        for (int q = 0; q < 2; q++) {
            double dot = 0, length = 0;
            for (int k = 0; k < 3; k++) { dot += h[q][k] * (double)g[k]; length += h[q][k] * h[q][k]; }
            CHECK_NEAR(dot, 0, 1e-6 * size * size);
            CHECK_NEAR(sqrt(length), size, 1e-6 * size);
        }
        for (int k = 0; k < 3; k++) across += h[0][k] * h[1][k];
        CHECK_NEAR(across, 0, 1e-6 * size * size);
    }
}

TEST(gravity_turned_keeps_its_length_and_leans_as_asked)
{
    sp_real g[3] = { 0, 0, -10 };
    tilt_turn(30, 90, g);
    CHECK_NEAR(g[0], 0, 1e-5);
    CHECK_NEAR(g[1], 10 * sin(30 * DEGREE), 1e-5);
    CHECK_NEAR(g[2], -10 * cos(30 * DEGREE), 1e-5);
}

/* About z. Normals stay; the directions t1, t2 of a joint may be any two in its plane. */
static void turn_scene(sp_scene *s, double degrees)
{
    const double c = cos(degrees * DEGREE), d = sin(degrees * DEGREE);
    for (int32_t k = 0; k < s->count.points + s->count.blocks; k++) {
        sp_real *x = k < s->count.points ? s->point[k] : s->block[k - s->count.points].centroid;
        const double a = (double)x[0], b = (double)x[1];
        x[0] = (sp_real)(c * a - d * b);
        x[1] = (sp_real)(d * a + c * b);
    }
}

/* The margin of two cubes of side 1, the upper one shifted along x, both turned about z. `heap` times the upper one's weight is
 * on a mast, 2.5 above its centroid and so far to its left.              returns what tilt_measure does */
static sp_status measure_with(double offset, double mu, double degrees, double heap, double left, tilt_margin *m)
{
    const sp_settings settings = sp_settings_default();
    gen_scene g;
    sp_capacity cap;
    sp_arena arena;
    sp_scene scene;
    sp_load on_top;
    void *memory = NULL, *limit = NULL;
    sp_status status = SP_E_ARGUMENT;
    if (gen_open(&g, "two-cubes") && gen_set(&g, "offset", offset) == 1 && gen_set(&g, "mu", mu) == 1)
        status = gen_capacity(&g, &cap);
    if (!status) status = run_arena(sp_scene_memory(&cap), &arena, &memory);
    if (!status) status = gen_build(&g, &arena, &scene);
    if (!status) turn_scene(&scene, degrees);
    if (!status && heap > 0) {
        const sp_block *upper = &scene.block[scene.count.blocks - 1];
        sp_load load = { 0 };
        load.block = scene.count.blocks - 1;
        load.mass = (sp_real)heap * upper->mass;
        load.point[0] = upper->centroid[0] - (sp_real)(left * sin(degrees * DEGREE));
        load.point[1] = upper->centroid[1] + (sp_real)(left * cos(degrees * DEGREE));
        load.point[2] = upper->centroid[2] + (sp_real)2.5;
        scene.load = &on_top;                           /* scenes by formula have no room for one */
        scene.capacity.loads = 1;
        status = sp_scene_load(&scene, &load, NULL);
    }
    if (!status) status = tilt_measure(&scene, &settings, m, &limit);
    free(limit);
    free(memory);
    return status;
}

static sp_status measure(double offset, double mu, double degrees, tilt_margin *m)
{
    return measure_with(offset, mu, degrees, 0, 0, m);
}

TEST(a_cube_slides_at_the_angle_of_friction)
{
    tilt_margin m;
    NEED(measure(0, 0.5, 0, &m) == SP_OK && m.stands);
    CHECK_NEAR(m.least, atan(0.5) / DEGREE, NEAR);
    CHECK_INT(m.undecided, 0);
    CHECK(!tilt_at_least(&m));
    for (int k = 0; k < TILT_AZIMUTHS; k++) CHECK_NEAR(m.angle[k], atan(0.5) / DEGREE, NEAR);
}

/* It tips about the edge of its base where the weight leaves it: 0.5 - offset before that edge, at height 0.5. */
TEST(a_shifted_cube_tips_towards_its_overhang)
{
    tilt_margin m;
    NEED(measure(0.2, 2, 0, &m) == SP_OK && m.stands);
    CHECK_NEAR(m.angle[0], atan(0.3 / 0.5) / DEGREE, NEAR);
    CHECK_NEAR(m.least, atan(0.3 / 0.5) / DEGREE, NEAR);
    CHECK_NEAR(m.azimuth, 0, 1e-3);
    CHECK_NEAR(m.angle[TILT_AZIMUTHS / 4], 45, NEAR);   /* towards y it tips about an edge 0.5 away */
}

/* 12.3 degrees lie between two of the 72 azimuths: the lines of their mechanisms lead there. */
TEST(the_worst_azimuth_need_not_be_one_of_those_asked)
{
    tilt_margin m;
    NEED(measure(0.2, 2, 12.3, &m) == SP_OK && m.stands);
    CHECK_NEAR(m.least, atan(0.3 / 0.5) / DEGREE, NEAR);
    CHECK_NEAR(m.azimuth, 12.3, 1e-2);
    CHECK(m.angle[2] > m.least + 1e-3 && m.angle[3] > m.least + 1e-3);
    CHECK(m.worst.verified);
}

/* With four times its weight on a mast the upper cube has its centroid 2.5 above the joint. It tips towards its overhang, where
 * 0.3 is left, but to the left where the mast stands there and leaves 0.14. */
TEST(a_weight_laid_on_turns_with_its_block)
{
    tilt_margin m;
    NEED(measure_with(0.2, 2, 12.3, 4, 0, &m) == SP_OK && m.stands);
    CHECK_NEAR(m.least, atan(0.3 / 2.5) / DEGREE, NEAR);
    CHECK_NEAR(m.azimuth, 12.3, 1e-2);
    NEED(measure_with(0.2, 2, 12.3, 4, 0.45, &m) == SP_OK && m.stands);
    CHECK_NEAR(m.least, atan(0.14 / 2.5) / DEGREE, NEAR);
    CHECK_NEAR(m.azimuth, 102.3, 1e-2);
}

TEST(what_falls_while_level_has_no_margin)
{
    tilt_margin m;
    NEED(measure(0.6, 0.84, 0, &m) == SP_OK);
    CHECK_INT(m.stands, 0);
    CHECK_NEAR(m.least, 0, 0);
}

#ifndef SP_NO_SLIDING
/* A scene by formula, turned about z with its joints' frames: how it slides when tilted along its plane. */
static sp_status slides_of(const char *name, double mu, double degrees, tilt_slide *slide, int *n)
{
    const sp_settings settings = sp_settings_default();
    const double c = cos(degrees * DEGREE), d = sin(degrees * DEGREE);
    gen_scene g;
    sp_capacity cap;
    sp_arena arena;
    sp_scene scene;
    void *memory = NULL;
    sp_status status = SP_E_ARGUMENT;
    if (gen_open(&g, name) && gen_set(&g, "mu", mu) == 1) status = gen_capacity(&g, &cap);
    if (!status) status = run_arena(sp_scene_memory(&cap), &arena, &memory);
    if (!status) status = gen_build(&g, &arena, &scene);
    if (!status) turn_scene(&scene, degrees);
    for (int32_t i = 0; !status && i < scene.count.joints; i++) {
        sp_real *frame[3] = { scene.joint[i].n, scene.joint[i].t1, scene.joint[i].t2 };
        for (int q = 0; q < 3; q++) {
            const double x = (double)frame[q][0], y = (double)frame[q][1];
            frame[q][0] = (sp_real)(c * x - d * y);
            frame[q][1] = (sp_real)(d * x + c * y);
        }
    }
    if (!status) status = tilt_slides(&scene, &settings, slide, n);
    free(memory);
    return status;
}

/* Level beds alone: both axes of the table are asked, and slide at the angle of friction. */
TEST(cubes_slide_both_ways_at_the_angle_of_friction)
{
    tilt_slide slide[TILT_SLIDES];
    int n = 0, states = 0;
    NEED(slides_of("two-cubes", 0.25, 0, slide, &n) == SP_OK);
    CHECK_INT(n, TILT_SLIDES);
    for (int k = 0; k < n; k++) {
        CHECK_NEAR(slide[k].azimuth, 90 * k, 1e-9);
        if (slide[k].kind != SP_SLIDING_STATE) continue;
        states++;
        CHECK_NEAR(slide[k].upper, atan(0.25) / DEGREE, NEAR);
    }
    CHECK(states >= 2);
}

/* The plane of an arch is found by its joints, and turns with it. */
TEST(an_arch_slides_along_its_own_plane_wherever_it_looks)
{
    tilt_slide here[TILT_SLIDES], there[TILT_SLIDES];
    int n = 0, m = 0;
    NEED(slides_of("arch", 0.84, 0, here, &n) == SP_OK && slides_of("arch", 0.84, 12.3, there, &m) == SP_OK);
    CHECK_INT(n, 2);
    CHECK_INT(m, 2);
    CHECK_NEAR(fmod(there[0].azimuth - here[0].azimuth + 360, 180), 12.3, 1e-3);
    for (int k = 0; k < 2; k++) {
        CHECK_INT(there[k].reason, here[k].reason);
        CHECK(here[k].reason != SP_SLIDING_NOT_ASKED);
        CHECK(here[k].upper > 0 && here[k].upper <= here[k].associative);
        CHECK_NEAR(there[k].associative, here[k].associative, NEAR);
        CHECK(here[k].lower_strong <= here[k].lower && here[k].lower <= here[k].upper);
    }
}
#endif

TEST_LIST(tilt)
    RUN(azimuths_turn_from_x_to_y)
    RUN(level_is_across_any_gravity_and_as_long)
    RUN(gravity_turned_keeps_its_length_and_leans_as_asked)
    RUN(a_cube_slides_at_the_angle_of_friction)
    RUN(a_shifted_cube_tips_towards_its_overhang)
    RUN(the_worst_azimuth_need_not_be_one_of_those_asked)
    RUN(a_weight_laid_on_turns_with_its_block)
    RUN(what_falls_while_level_has_no_margin)
#ifndef SP_NO_SLIDING
    RUN(cubes_slide_both_ways_at_the_angle_of_friction)
    RUN(an_arch_slides_along_its_own_plane_wherever_it_looks)
#endif
TEST_END
