/* The generators themselves: every scene builds at its defaults, with the capacity foretold, and its joints fit its blocks. */
#include "../test.h"
#include "../scenes/gen.h"

#include <string.h>

/* Largest distance of a contact vertex from the nearest face plane of a block, relative to the block's size: 0 when the
 * joint lies in one of the block's faces. */
static double off_faces(const sp_scene *s, const sp_block *b, const sp_joint *j, const double n[3])
{
    double best = 1e30;
    for (int32_t f = b->face; f < b->face + b->faces; f++) {
        const sp_face *face = &s->face[f];
        double worst = 0, normal[3] = { 0, 0, 0 };
        const sp_real *o = s->vertex[s->corner[face->corner]];
        for (int32_t k = 0; k < face->corners; k++) {       /* Newell */
            const sp_real *p = s->vertex[s->corner[face->corner + k]];
            const sp_real *q = s->vertex[s->corner[face->corner + (k + 1) % face->corners]];
            for (int c = 0; c < 3; c++) {
                const int d = (c + 1) % 3, e = (c + 2) % 3;
                normal[c] += 0.5 * ((double)p[d] - (double)q[d]) * ((double)p[e] + (double)q[e] - 2 * (double)o[e]);
            }
        }
        double size = 0, along = 0;
        for (int c = 0; c < 3; c++) size += normal[c] * normal[c], along += normal[c] * n[c];
        if (along < 0 || along * along < 0.99 * size) continue;
        for (int32_t k = j->point; k < j->point + j->points; k++) {
            double h = 0;
            for (int c = 0; c < 3; c++) h += n[c] * ((double)s->point[k][c] - (double)o[c]);
            if (h < 0) h = -h;
            if (h > worst) worst = h;
        }
        if (worst < best) best = worst;
    }
    return best / (double)b->diameter;
}

static void same_capacity(const sp_capacity *a, const sp_capacity *b)
{
    CHECK_INT(a->blocks, b->blocks);
    CHECK_INT(a->vertices, b->vertices);
    CHECK_INT(a->faces, b->faces);
    CHECK_INT(a->corners, b->corners);
    CHECK_INT(a->joints, b->joints);
    CHECK_INT(a->points, b->points);
}

static void fits(const gen_scene *g)
{
    sp_scene s;
    sp_capacity cap;
    const size_t mark = test_arena.used;
    CHECK_INT(gen_capacity(g, &cap), SP_OK);
    const sp_status status = gen_build(g, &test_arena, &s);
    if (!CHECK_INT(status, SP_OK)) {
        CHECK_TEXT("does not build", g->entry->name);
        return;
    }
    same_capacity(&s.count, &cap);
    same_capacity(&s.capacity, &cap);
    for (int32_t k = 0; k < s.count.joints; k++) {
        const sp_joint *j = &s.joint[k];
        double n[3], m[3];
        for (int c = 0; c < 3; c++) n[c] = (double)j->n[c], m[c] = -n[c];
        if (!(off_faces(&s, &s.block[j->a], j, n) < TOL(1e-12, 1e-5)) || !(off_faces(&s, &s.block[j->b], j, m) < TOL(1e-12, 1e-5))) {
            CHECK_TEXT("a joint lies off its blocks' faces", g->entry->name);
            CHECK_INT(k, -1);
            break;
        }
    }
    test_arena.used = mark;
}

TEST(every_scene_builds_with_joints_in_its_blocks_faces)
{
    for (const gen_entry *e = gen_table; e->name; e++) {
        gen_scene g;
        NEED(gen_open(&g, e->name));
        fits(&g);
    }
}

TEST(jitter_and_odd_numbers_build_too)
{
    static const struct { const char *name, *param; double value; } odd[] = {
        { "wall", "jitter", 0.49 }, { "rubble", "jitter", 1 }, { "vault", "jitter", 0.45 }, { "wall", "rows", 1 },
        { "wall", "bricks", 1 }, { "vault", "around", 2 }, { "vault", "n", 1 }, { "dome", "segments", 3 }, { "dome", "segments", 128 },
        { "arch", "ends", 1 }, { "arch", "half", 60 }, { "arch", "facets", 60 }, { "keystone", "angle", -20 }, { "two-cubes", "offset", -0.4 },
        { "incline", "turn", 22.5 }, { "overhang", "n", 30 }, { "flat-arch", "n", 1 }, { "rubble", "rows", 1 }
    };
    for (size_t k = 0; k < sizeof odd / sizeof odd[0]; k++) {
        gen_scene g;
        NEED(gen_open(&g, odd[k].name));
        CHECK_INT(gen_set(&g, odd[k].param, odd[k].value), 1);
        fits(&g);
    }
}

TEST(known_walls_have_the_joints_of_the_speed_tables)
{
    static const struct { double size; int32_t free_blocks, joints; } want[] = {
        { 54, 26, 64 }, { 95, 37, 95 }, { 147, 57, 150 }, { 500, 170, 474 }, { 2000, 693, 2004 }, { 10000, 3384, 9986 }
    };
    for (size_t k = 0; k < sizeof want / sizeof want[0]; k++) {
        gen_scene g;
        sp_capacity cap;
        NEED(gen_open(&g, "wall"));
        CHECK_INT(gen_set(&g, "size", want[k].size), 1);
        CHECK_INT(gen_set(&g, "jitter", 0.35), 1);
        CHECK_INT(gen_capacity(&g, &cap), SP_OK);
        CHECK_INT(cap.blocks, want[k].free_blocks + 1);
        CHECK_INT(cap.joints, want[k].joints);
    }
}

TEST(unknown_names_and_numbers_out_of_range_are_refused)
{
    gen_scene g;
    CHECK_INT(gen_open(&g, "cathedral"), 0);
    NEED(gen_open(&g, "arch"));
    CHECK_INT(gen_set(&g, "nave", 1), 0);
    CHECK_INT(gen_set(&g, "n", 1), -1);
    CHECK_INT(gen_set(&g, "t", 0), -1);
    CHECK_INT(gen_set(&g, "mu", 0.5), 1);
}

/* What the contact search finds is what the generator said: the same pairs, the same areas. */
static void found_as_given(const gen_scene *g)
{
    sp_scene s;
    sp_contact_report report = { 0, 0, 0, 0, NULL };
    const sp_contact_settings settings = sp_contact_settings_default();
    test_arena.used = 0;
    NEED(gen_build(g, &test_arena, &s) == SP_OK);
    const int32_t given = s.count.joints, points = s.count.points;
    sp_joint *want = s.joint, *found;           /* room for the found ones besides */
    sp_capacity cap = s.count;
    sp_scene t;
    cap.joints *= 2;
    cap.points *= 4;
    NEED(sp_scene_create(&t, &cap, &test_arena) == SP_OK);
    for (int32_t b = 0; b < s.count.blocks; b++) {
        sp_real xyz[3 * 512];
        int32_t size[512], corner[2048], n = 0;
        const sp_block *k = &s.block[b];
        for (int32_t v = 0; v < k->vertices; v++)
            for (int c = 0; c < 3; c++) xyz[3 * v + c] = s.vertex[k->vertex + v][c];
        for (int32_t f = 0; f < k->faces; f++) {
            size[f] = s.face[k->face + f].corners;
            for (int32_t i = 0; i < size[f]; i++) corner[n++] = s.corner[s.face[k->face + f].corner + i] - k->vertex;
        }
        const sp_mesh mesh = { k->vertices, k->faces, xyz, size, corner };
        NEED(sp_scene_block(&t, &mesh, k->density, k->fixed, NULL) == SP_OK);
    }
    const sp_status status = sp_contacts_find(&t, &settings, test_arena, &report);
    NEED(status == SP_OK);
    CHECK_INT(report.overlaps, 0);
    found = t.joint;
    if (!CHECK_INT(report.joints, given) || !CHECK(report.points >= points)) CHECK_TEXT("", g->entry->name);
    for (int32_t i = 0; i < given; i++) {
        double area = 0;
        const int32_t a = want[i].a < want[i].b ? want[i].a : want[i].b, b = want[i].a + want[i].b - a;
        for (int32_t j = 0; j < t.count.joints; j++) if (found[j].a == a && found[j].b == b) area += (double)found[j].area;
        CHECK_NEAR(area, want[i].area, TOL(1e-9, 1e-3));
    }
}

TEST(contacts_found_are_the_joints_given)
{
    static const char *const name[] = { "two-cubes", "incline", "overhang", "tower", "arch", "flat-arch", "keystone", "h-model", "wall",
                                        "rubble", "vault", "dome" };
    for (size_t k = 0; k < sizeof name / sizeof name[0]; k++) {
        gen_scene g;
        NEED(gen_open(&g, name[k]));
        if (gen_set(&g, "jitter", 0.3) >= 0) found_as_given(&g);
    }
}

TEST_LIST(gen)
    RUN(every_scene_builds_with_joints_in_its_blocks_faces)
    RUN(jitter_and_odd_numbers_build_too)
    RUN(known_walls_have_the_joints_of_the_speed_tables)
    RUN(contacts_found_are_the_joints_given)
    RUN(unknown_names_and_numbers_out_of_range_are_refused)
TEST_END
