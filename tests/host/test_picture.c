/* Pictures of checked scenes: what is drawn, and from where. Host only. */
#include "../test.h"
#include "../../port/host/motion.h"
#include "../../port/host/run.h"
#include "../../port/host/picture/mechanism.h"
#include "../../port/host/picture/model.h"
#include "../../port/host/picture/seen.h"
#include "../../port/host/picture/sheet.h"
#include "../../port/host/picture/svg.h"
#include "../../port/host/picture/through.h"
#include "../scenes/gen.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A scene made by formula, checked. */
typedef struct checked {
    host_scene host;
    sp_result result;
    void *scene, *memory;
    char name[128][8];
    const char *names[128];
} checked;

static int make(checked *k, const char *name, const char *param, double value)
{
    const sp_settings settings = sp_settings_default();
    sp_arena arena;
    run_cost cost;
    memset(k, 0, sizeof *k);
    if (run_arena(4u << 20, &arena, &k->scene) != SP_OK || gen_make(name, param, value, &arena, &k->host.scene) != SP_OK) return 0;
    for (int i = 0; i < 128; i++) {
        snprintf(k->name[i], sizeof k->name[i], "b%d", i);
        k->names[i] = k->name[i];
    }
    k->host.path = k->name[0];
    k->host.name = k->names;
    return k->host.scene.count.blocks <= 128 && run_check(&k->host.scene, &settings, &k->result, &cost, &k->memory) == SP_OK;
}

static void let_go(checked *k)
{
    free(k->scene);
    free(k->memory);
}

/* What a stream holds, malloc's. */
static char *read_back(FILE *f)
{
    const long n = ftell(f);
    char *text = n >= 0 ? malloc((size_t)n + 1) : NULL;
    rewind(f);
    if (text) text[fread(text, 1, (size_t)n, f)] = 0;
    fclose(f);
    return text;
}

static char *draw(const checked *k, int names)
{
    subject of;
    FILE *f = tmpfile();
    memset(&of, 0, sizeof of);
    of.scene = &k->host;
    of.result = &k->result;
    of.names = names;
    if (!f || !svg_write(f, &of)) return NULL;
    return read_back(f);
}

static int count(const char *text, const char *what)
{
    int n = 0;
    for (; (text = strstr(text, what)) != NULL; text += strlen(what)) n++;
    return n;
}

static double along(const double a[3], const sp_real b[3])
{
    return a[0] * (double)b[0] + a[1] * (double)b[1] + a[2] * (double)b[2];
}

static double inner(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

TEST(gravity_points_down_on_paper_whatever_the_axes)
{
    checked k;
    NEED(make(&k, "wall", "rows", 3));
    for (int axis = 0; axis < 6; axis++) {
        const view_wish wish[2] = { { 0, 0, 0 }, { 1, 70, 30 } };
        for (int c = 0; c < 3; c++) k.host.scene.gravity[c] = R(c != axis / 2 ? 0.5 : axis % 2 ? 10 : -10);
        const view_axes level = view_level(&k.host.scene);
        CHECK_NEAR(view_height(&level, k.host.scene.gravity), -10, 1e-12);
        for (int i = 0; i < 2; i++) {
            const view v = view_choose(&k.host.scene, &wish[i]);
            CHECK(along(v.up, k.host.scene.gravity) < -6);
            CHECK(fabs(along(v.right, k.host.scene.gravity)) < 1);
            CHECK_WITHIN(inner(v.right, v.up), 0, 1e-12);
            const double turned = v.right[1] * v.up[2] - v.right[2] * v.up[1];
            CHECK_WITHIN(turned, v.toward[0], 1e-12);                     /* right-handed: nothing is mirrored */
        }
    }
    let_go(&k);
}

TEST(views_by_name_are_along_the_axes)
{
    static const struct { view_wish wish; double right[3], up[3]; } is[3] = {
        { { 1, 0, 0 }, { 1, 0, 0 }, { 0, 0, 1 } }, { { 1, 90, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
        { { 1, 0, 90 }, { 1, 0, 0 }, { 0, 1, 0 } } };
    checked k;
    NEED(make(&k, "two-cubes", NULL, 0));
    for (int i = 0; i < 3; i++) {
        const view v = view_choose(&k.host.scene, &is[i].wish);
        for (int c = 0; c < 3; c++) {
            CHECK_WITHIN(v.right[c], is[i].right[c], 1e-12);
            CHECK_WITHIN(v.up[c], is[i].up[c], 1e-12);
        }
    }
    let_go(&k);
}

/* A scene of z up, turned to y up with its gravity, is seen as before. */
TEST(a_scene_with_y_up_is_seen_as_with_z_up)
{
    checked k;
    NEED(make(&k, "arch", "n", 9));
    const view before = view_choose(&k.host.scene, NULL);
    sp_scene *s = &k.host.scene;
    for (int32_t i = 0; i < s->count.vertices + s->count.joints + 1; i++) {
        sp_real *x = i < s->count.vertices ? s->vertex[i] : i < s->count.vertices + s->count.joints
                   ? s->joint[i - s->count.vertices].n : s->gravity;
        const sp_real y = x[1];
        x[1] = x[2];
        x[2] = -y;
    }
    const view after = view_choose(s, NULL);
    const double *a[3] = { before.right, before.up, before.toward }, *b[3] = { after.right, after.up, after.toward };
    for (int i = 0; i < 3; i++) {
        CHECK_WITHIN(b[i][0], a[i][0], 1e-6);
        CHECK_WITHIN(b[i][1], a[i][2], 1e-6);
        CHECK_WITHIN(b[i][2], -a[i][1], 1e-6);
    }
    let_go(&k);
}

TEST(a_stable_scene_has_one_picture_a_falling_one_two)
{
    checked stands, falls;
    NEED(make(&stands, "overhang", "factor", 0.9) && make(&falls, "overhang", "factor", 1.1));
    char *one = draw(&stands, 0), *two = draw(&falls, 0);
    NEED(one && two);
    CHECK_INT(count(one, "How it starts to move"), 0);
    CHECK_INT(count(two, "How it starts to move"), 1);
    CHECK_INT(count(one, "<g stroke-linejoin"), 1);                     /* the faces of a picture */
    CHECK_INT(count(two, "<g stroke-linejoin"), 2);
    CHECK_INT(count(one, "class=\"through\""), 0);
    CHECK_INT(count(two, "class=\"through\""), 0);     /* what moves is in front */
    CHECK(count(two, "weakest joint") == 1 && count(two, ">moves</text>") == 1);
    for (int i = 0; i < 2; i++) {
        const char *svg = i ? two : one;
        CHECK_INT(count(svg, "<svg "), 1);
        CHECK_INT(count(svg, "<g"), count(svg, "</g>"));
        CHECK(strcmp(svg + strlen(svg) - 7, "</svg>\n") == 0);
    }
    free(one);
    free(two);
    let_go(&stands);
    let_go(&falls);
}

/* Those of the weakest joint where it stands, those that move where it moves. */
TEST(blocks_told_of_have_their_names)
{
    checked k;
    char text[32];
    NEED(make(&k, "overhang", "factor", 1.1));
    char *svg = draw(&k, 0);
    NEED(svg);
    const sp_joint *weakest = &k.host.scene.joint[k.result.extremes.weakest];
    const char *end = strstr(svg, "How it starts to move");
    NEED(end);
    for (int i = 0; i < 2; i++) {
        snprintf(text, sizeof text, ">%s</text>", k.names[i ? weakest->b : weakest->a]);
        const char *at = strstr(svg, text);
        CHECK(at && at < end);
    }
    for (int32_t b = 0; b < k.host.scene.count.blocks; b++) {
        snprintf(text, sizeof text, ">%s</text>", k.names[b]);
        CHECK_INT(strstr(end, text) != NULL, fabs((double)k.result.dq[6 * b + 2]) > 1e-6);
    }
    free(svg);
    let_go(&k);
}

/* Of those that move the six that go farthest, wherever they are in the file: here the last six. */
TEST(the_fastest_blocks_have_their_names)
{
    checked k;
    char text[32];
    int32_t fastest[MOTION_NAMED];
    NEED(make(&k, "arch", "t", 0.09));
    sp_real *dq = (sp_real *)k.result.dq;
    const int32_t blocks = k.host.scene.count.blocks;
    memset(dq, 0, 6 * (size_t)blocks * sizeof *dq);
    for (int32_t b = 3; b < blocks; b++) dq[6 * b + 2] = R(-1.0 * b / blocks);
    CHECK_INT(motion_fastest(&k.host.scene, &k.result, MOTION_NAMED, fastest), blocks - 3);
    for (int i = 0; i < MOTION_NAMED; i++) CHECK_INT(fastest[i], blocks - 1 - i);
    for (int32_t b = 3; b < blocks; b++) dq[6 * b + 2] = R(-0.5 - 1e-9 * b);
    CHECK_INT(motion_fastest(&k.host.scene, &k.result, 2, fastest), blocks - 3);
    CHECK(fastest[0] == 3 && fastest[1] == 4);          /* as fast to rounding: the first */
    for (int32_t b = 3; b < blocks; b++) dq[6 * b + 2] = R(-1.0 * b / blocks);
    char *svg = draw(&k, 0);
    NEED(svg);
    const char *end = strstr(svg, "How it starts to move");
    NEED(end);
    for (int32_t b = 0; b < blocks; b++) {
        snprintf(text, sizeof text, ">%s</text>", k.names[b]);
        CHECK_INT(strstr(end, text) != NULL, b >= blocks - MOTION_NAMED);
    }
    free(svg);
    let_go(&k);
}

/* The first block of a tower goes inside the second, out of sight, with its joint to that. */
static void hide_first(checked *k)
{
    sp_scene *s = &k->host.scene;
    const sp_joint *j = &s->joint[1];
    sp_real *from = s->block[1].centroid, *to = s->block[2].centroid;
    for (int32_t i = 0; i < s->block[1].vertices; i++)
        for (int c = 0; c < 3; c++) {
            sp_real *v = s->vertex[s->block[1].vertex + i];
            v[c] = to[c] + (v[c] - from[c]) / 4;
        }
    for (int32_t i = 0; i < j->points; i++)
        for (int c = 0; c < 3; c++) s->point[j->point + i][c] = to[c] + (s->point[j->point + i][c] - from[c]) / 4;
    memcpy(from, to, sizeof s->block[1].centroid);
}

/* A block out of sight has none. */
TEST(names_asked_for_stand_on_what_is_seen)
{
    checked k;
    NEED(make(&k, "tower", "lean", 0));
    char *with = draw(&k, 1), *without = draw(&k, 0);
    NEED(with && without);
    CHECK_INT(count(without, "class=\"name\""), 0);
    CHECK_INT(count(with, "class=\"name\""), k.host.scene.count.blocks);
    CHECK_INT(count(with, "names on 11 of 11"), 1);
    hide_first(&k);
    char *hidden = draw(&k, 1);
    NEED(hidden);
    CHECK_INT(count(hidden, ">b1</text>"), 0);
    CHECK_INT(count(hidden, ">b2</text>"), 1);
    free(with);
    free(without);
    free(hidden);
    let_go(&k);
}

TEST(marked_blocks_show_through_what_hides_them)
{
    checked k;
    drawing d;
    faces f;
    seen look;
    unsigned char mark[128];
    double at[2];
    const view_wish wish = { 1, -20, 20 };
    NEED(make(&k, "tower", "lean", 0));
    hide_first(&k);
    memset(&d, 0, sizeof d);
    d.out = tmpfile();
    d.s = &k.host.scene;
    d.v = view_choose(d.s, &wish);
    d.scale = 100;
    drawing_clear(&d);
    for (int32_t i = 0; i < d.s->count.vertices; i++) drawing_cover(&d, d.s->vertex[i]);
    NEED(d.out && faces_find(&f, &d) && seen_begin(&look, &d));
    for (int32_t b = 0; b < d.s->count.blocks; b++) {
        CHECK_INT(seen_spot(&look, b, at, at), b != 1);
        if (b != 1) CHECK_INT(seen_block_at(&look, b, at), 1);
    }
    for (int32_t j = 0; j < 3; j++) CHECK_INT(seen_joint(&look, &d.s->joint[j]), j != 1);
    memset(mark, MARK_PLAIN, sizeof mark);
    for (int i = 1; i < 4; i++) {                       /* the hidden one; it and others; others alone */
        mark[i] = MARK_HELD;
        mark[1] = i < 3 ? MARK_HELD : MARK_PLAIN;
        CHECK_INT(through_draw(&d, &f, mark), 1);
    }
    char *svg = read_back(d.out);
    NEED(svg);
    CHECK_INT(count(svg, "class=\"through\""), 2);
    CHECK_INT(count(svg, "<path"), 2);
    free(svg);
    seen_end(&look);
    faces_free(&f);
    let_go(&k);
}

/* A moved block keeps its shape, and what rests stays. */
TEST(moved_blocks_keep_their_shape)
{
    checked k;
    drawing d;
    mechanism m;
    sp_scene moved;
    NEED(make(&k, "overhang", "factor", 1.1));
    memset(&d, 0, sizeof d);
    d.s = &k.host.scene;
    d.v = view_choose(d.s, NULL);
    drawing_clear(&d);
    mechanism_scale(&m, &d, &k.result, 5, 0.5);
    CHECK(m.largest > 0.3 && m.largest < 0.7);
    NEED(mechanism_move(&m, d.s, &moved));
    for (int32_t b = 0; b < d.s->count.blocks; b++) {
        const sp_block *of = &d.s->block[b];
        double gone = 0;
        for (int32_t i = of->vertex; i < of->vertex + of->vertices; i++) {
            sp_real was[3], is[3], way[3];
            for (int c = 0; c < 3; c++) {
                was[c] = d.s->vertex[i][c] - d.s->vertex[of->vertex][c];
                is[c] = moved.vertex[i][c] - moved.vertex[of->vertex][c];
                way[c] = moved.vertex[i][c] - d.s->vertex[i][c];
            }
            CHECK_WITHIN(view_length(is), view_length(was), 1e-5);
            gone = fmax(gone, view_length(way));
        }
        CHECK_INT(gone > 1e-5, fabs((double)k.result.dq[6 * b + 2]) > 1e-6);
    }
    mechanism_free(&moved);
    let_go(&k);
}

/* What a model has in it. */
typedef struct in_model { int v, f, l, blocks, moved, wrong; } in_model;

static in_model read_model(const char *text)
{
    in_model n = { 0, 0, 0, 0, 0, 0 };
    int used[4096] = { 0 };
    for (const char *at = text; *at; at += strcspn(at, "\n") + 1) {
        n.v += strncmp(at, "v ", 2) == 0;
        n.blocks += strncmp(at, "g blocks\n", 9) == 0;
        n.moved += strncmp(at, "g moved\n", 8) == 0;
        if (strncmp(at, "f ", 2) && strncmp(at, "l ", 2)) continue;
        *at == 'f' ? n.f++ : n.l++;
        for (const char *p = at + 1; *p == ' ';) {
            char *end;
            const long i = strtol(p, &end, 10);
            if (end == p || i < 1 || i > n.v || i >= 4096) n.wrong++;
            else used[i] = 1;
            p = end;
        }
    }
    for (int i = 1; i <= n.v && i < 4096; i++) n.wrong += !used[i];
    return n;
}

static char *model_of(const checked *k)
{
    subject of;
    FILE *f = tmpfile();
    memset(&of, 0, sizeof of);
    of.scene = &k->host;
    of.result = &k->result;
    return f && model_write(f, &of) ? read_back(f) : NULL;
}

/* A line through each stone from joint to joint, every vertex used and there before it is; nothing moved. */
TEST(a_model_of_an_arch_has_its_thrust_line)
{
    checked k;
    NEED(make(&k, "arch", "n", 15));
    char *text = model_of(&k);
    NEED(text && k.result.verdict == SP_STABLE);
    const in_model n = read_model(text);
    const sp_capacity *all = &k.host.scene.count;
    CHECK_INT(n.wrong, 0);
    CHECK_INT(n.blocks, all->blocks);
    CHECK_INT(n.moved, 0);
    CHECK_INT(n.f, all->faces);
    CHECK_INT(n.l, 2 * all->joints + 15);
    CHECK_INT(n.v, all->vertices + 4 * all->joints + 2 * 15);
    const char *thrust = strstr(text, "g thrust\n");
    NEED(thrust);
    double lowest = 1, highest = 0;
    for (const char *at = thrust; (at = strstr(at, "v ")) != NULL; at++) {
        char *end;
        const double x = strtod(at + 2, &end), y = strtod(end, &end), z = strtod(end, NULL), radius = sqrt(x * x + z * z);
        CHECK(radius > 0.9399 && radius < 1.0601 && y > 0.24 && y < 0.26);  /* within the stones, amid their depth */
        lowest = fmin(lowest, z);
        highest = fmax(highest, z);
    }
    CHECK(lowest < 0.01 && highest > 0.9);
    free(text);
    let_go(&k);
}

TEST(a_model_of_what_falls_has_moved_blocks_and_is_no_scene)
{
    checked k;
    host_scene s;
    failure error = { 0, "" };
    const scene_settings set = scene_settings_default();
    int moving = 0;
    NEED(make(&k, "overhang", "factor", 1.1));
    for (int32_t b = 0; b < k.host.scene.count.blocks; b++) moving += fabs((double)k.result.dq[6 * b + 2]) > 1e-6;
    char *text = model_of(&k);
    NEED(text);
    const in_model n = read_model(text);
    CHECK_INT(n.wrong, 0);
    CHECK_INT(n.moved, moving);
    CHECK_INT(n.f, 6 * (k.host.scene.count.blocks + moving));
    CHECK_INT(count(text, "_moved\n"), moving);
    CHECK_INT(scene_parse("m.obj", text, strlen(text), &set, &s, &error), EXIT_SCENE);
    CHECK_TEXT(error.line, "m.obj:1: this is a picture that --out-obj wrote, not a scene");
    scene_free(&s);
    let_go(&k);
}

TEST_LIST(picture)
    RUN(gravity_points_down_on_paper_whatever_the_axes)
    RUN(views_by_name_are_along_the_axes)
    RUN(a_scene_with_y_up_is_seen_as_with_z_up)
    RUN(a_stable_scene_has_one_picture_a_falling_one_two)
    RUN(blocks_told_of_have_their_names)
    RUN(the_fastest_blocks_have_their_names)
    RUN(names_asked_for_stand_on_what_is_seen)
    RUN(marked_blocks_show_through_what_hides_them)
    RUN(moved_blocks_keep_their_shape)
    RUN(a_model_of_an_arch_has_its_thrust_line)
    RUN(a_model_of_what_falls_has_moved_blocks_and_is_no_scene)
TEST_END
