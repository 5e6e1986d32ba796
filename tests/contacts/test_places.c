/* Contacts and overlaps of small drawn scenes: where cells of a grid are shared out among blocks, and how deep a point lies in
 * such a block, follows from the cells; what all blocks of a scene find is what each pair finds alone; sums over blocks of many
 * shapes, pushed and turned, are those written here. */
#include "../scenes/tally.h"

#if defined TALLY_ALL && COUNTED
#include "contacts.h"

enum { GRID = 3, OWNERS = 4, MANY_CORNERS = 4096, SEEN = 256 };

static sp_overlap seen[SEEN];
static uint32_t draws;

static double draw(double low, double high) { return test_draw(&draws, low, high); }
static int32_t draw_int(int32_t low, int32_t high) { return low + (int32_t)draw(0, high - low + 1); }

/* The mesh being made; each face has corners of its own. */
static struct {
    sp_real xyz[MANY_CORNERS][3];
    int32_t vertices, faces, corners, size[MANY_CORNERS / 3], corner[MANY_CORNERS];
} made;

static void forget(void) { made.vertices = made.faces = made.corners = 0; }

static void face(const frame *f, int32_t n, double (*x)[3])
{
    made.size[made.faces++] = n;
    for (int32_t k = 0; k < n; k++) {
        place(f, x[k][0], x[k][1], x[k][2], made.xyz[made.vertices]);
        made.corner[made.corners++] = made.vertices++;
    }
}

/* A face of four corners: 0 as it is, 1 and 2 cut into triangles along a diagonal. */
static void four(const frame *f, double (*x)[3], int cut)
{
    double half[3][3];
    if (!cut) { face(f, 4, x); return; }
    for (int side = 0; side < 2; side++) {
        for (int k = 0; k < 3; k++) memcpy(half[k], x[(cut - 1 + 2 * side + k) % 4], sizeof *half);
        face(f, 3, half);
    }
}

static int32_t finish(uint32_t fixed)
{
    const sp_mesh mesh = { made.vertices, made.faces, made.xyz[0], made.size, made.corner };
    int32_t id = -1;
    CHECK_INT(sp_scene_block(&scene, &mesh, 2400, fixed, &id), SP_OK);
    forget();
    return id;
}

/* A rotation by twice the angle whose tangent is up to `most` about each axis, and a shift of up to `far` each way. */
static frame tilted(double most, double far)
{
    double x[3], shift[3];                              /* one after the other: arguments are evaluated in any order */
    for (int k = 0; k < 3; k++) x[k] = draw(-most, most);
    for (int k = 0; k < 3; k++) shift[k] = draw(-far, far);
    frame f = turned(1, x[0], x[1], x[2], 0, 1);
    memcpy(f.shift, shift, sizeof shift);
    return f;
}

static frame any_frame(double far) { return tilted(2, far); }

static sp_status look(const sp_contact_settings *set)
{
    report.overlap = seen;
    report.overlap_capacity = SEEN;
    return sp_contacts_find(&scene, set, test_arena, &report);
}

/* ------------------------------------------------------------------------------------------------------- cells of a grid */

/* Cells between planes x, y, z = plane[0 .. 2][0 .. GRID], each of an owner or of none, -1; a rim of none is about them. */
static struct { double plane[3][GRID + 1]; int owner[GRID + 2][GRID + 2][GRID + 2]; } cells;

static int *owner_of(const int32_t at[3]) { return &cells.owner[at[0] + 1][at[1] + 1][at[2] + 1]; }

/* Widths between 0.06 and 1; `owners` of them, and some of none. */
static void share_out(int owners, double none)
{
    memset(&cells, -1, sizeof cells);
    for (int c = 0; c < 3; c++) {
        cells.plane[c][0] = 0;
        for (int k = 0; k < GRID; k++) cells.plane[c][k + 1] = cells.plane[c][k] + (draw(0, 1) < 0.2 ? 0.06 : draw(0.2, 1));
    }
    for (int32_t k = 0; k < GRID * GRID * GRID; k++) {
        const int32_t at[3] = { k % GRID, k / GRID % GRID, k / GRID / GRID };
        *owner_of(at) = draw(0, 1) < none ? -1 : draw_int(0, owners - 1);
    }
}

/* Corners of the square of a cell that looks along axis c, outwards. */
static void square_of(const int32_t at[3], int c, int side, double x[4][3])
{
    const int d = (c + 1) % 3, e = (c + 2) % 3;
    for (int k = 0; k < 4; k++) {
        const int q = side ? k : 3 - k;
        x[k][c] = cells.plane[c][at[c] + side];
        x[k][d] = cells.plane[d][at[d] + (q == 1 || q == 2)];
        x[k][e] = cells.plane[e][at[e] + (q > 1)];
    }
}

/* Square k of all: its cell, its axis and side, and who owns the cell beyond it. 0: there is none. */
static int square(int32_t k, int32_t at[3], int *c, int *side, int *beyond)
{
    if (k >= 6 * GRID * GRID * GRID) return 0;
    *side = k % 2;
    *c = k / 2 % 3;
    for (int i = 0, n = k / 6; i < 3; i++, n /= GRID) at[i] = n % GRID;
    int32_t next[3] = { at[0], at[1], at[2] };
    next[*c] += *side ? 1 : -1;
    *beyond = *owner_of(next);
    return 1;
}

/* All cells of an owner as one block; -1: it has none. */
static int32_t block_of(const frame *f, int owner, int cut, uint32_t fixed)
{
    int32_t at[3];
    int c, side, beyond;
    double x[4][3];
    for (int32_t k = 0; square(k, at, &c, &side, &beyond); k++) {
        if (*owner_of(at) != owner || beyond == owner) continue;
        square_of(at, c, side, x);
        four(f, x, cut < 3 ? cut : draw_int(0, 2));
    }
    return made.faces ? finish(fixed) : -1;
}

/* Area of the squares between the cells of two owners. */
static double area_between(int a, int b)
{
    int32_t at[3];
    int c, side, beyond;
    double area = 0, x[4][3];
    for (int32_t k = 0; square(k, at, &c, &side, &beyond); k++) {
        const int d = (c + 1) % 3, e = (c + 2) % 3;
        if (*owner_of(at) != a || beyond != b) continue;
        square_of(at, c, side, x);
        area += fabs((x[2][d] - x[0][d]) * (x[2][e] - x[0][e]));
    }
    return area;
}

static int open_scene(int32_t blocks, int32_t corners)
{
    const sp_capacity cap = { blocks, corners, corners / 3, corners, 400, 4000, 0 };
    test_renew();
    return CHECK_INT(sp_scene_create(&scene, &cap, &test_arena), SP_OK);
}

TEST(blocks_of_cells_touch_in_the_squares_between_them)
{
    draws = 11;
    for (int k = 0; k < 5; k++) {
        const frame f = any_frame(k % 3 == 2 ? 1000 : 5);
        double area[OWNERS][OWNERS] = { { 0 } };
        int32_t id[OWNERS];
        NEED(open_scene(OWNERS, OWNERS * 2048));
        share_out(2 + k % 3, k % 2 ? 0.1 : 0.5);
        for (int i = 0; i < OWNERS; i++) id[i] = block_of(&f, i, k % 4, 0);
        CHECK_INT(look(NULL), SP_OK);
        CHECK_INT(report.overlaps, 0);
        for (const sp_joint *j = scene.joint; j < scene.joint + scene.count.joints; j++) area[j->a][j->b] += (double)j->area;
        for (int a = 0; a < OWNERS; a++)
            for (int b = a + 1; b < OWNERS; b++)
                if (id[a] >= 0 && id[b] >= 0) CHECK_WITHIN(area[id[a]][id[b]], area_between(a, b), 1e-9);
    }
}

/* How deep a place lies in the cells of an owner: as far as their nearest square. Outside: less than 0, by as much. */
static double depth_in_cells(const double p[3], int owner)
{
    int32_t at[3] = { -1, -1, -1 };
    int c, side, beyond;
    double least2 = 1e9, x[4][3];
    for (int i = 0; i < 3; i++) while (at[i] < GRID && p[i] > cells.plane[i][at[i] + 1]) at[i]++;
    const int in = *owner_of(at) == owner;
    for (int32_t k = 0; square(k, at, &c, &side, &beyond); k++) {
        double far2 = 0;
        if (*owner_of(at) != owner || beyond == owner) continue;
        square_of(at, c, side, x);
        for (int i = 0; i < 3; i++) {
            const double lo = fmin(x[0][i], x[2][i]), hi = fmax(x[0][i], x[2][i]), d = fmax(lo - p[i], fmax(p[i] - hi, 0));
            far2 += d * d;
        }
        least2 = fmin(least2, far2);
    }
    return in ? sqrt(least2) : -sqrt(least2);
}

/* A small triangle, whose corners are in turn any of three about p. */
static int32_t probe(const frame *f, const double p[3], double size)
{
    double x[3][3];
    for (int v = 0; v < 3; v++)
        for (int i = 0; i < 3; i++) x[v][i] = p[i] + draw(-size, size);
    face(f, 3, x);
    return finish(SP_FIXED);
}

TEST(a_small_triangle_in_cells_lies_as_deep_as_their_nearest_square)
{
    enum { PROBES = 40 };
    const double size = 1e-5;
    int32_t deep = 0;
    draws = 12;
    for (int k = 0; k < 8; k++) {
        const frame f = k % 2 ? any_frame(3) : upright();
        double depth[PROBES + 1], p[3];
        NEED(open_scene(PROBES + 1, 8192));
        share_out(1, k % 3 ? 0.3 : 0.93);
        if (block_of(&f, 0, k % 4, 0) < 0) continue;
        for (int i = 1; i <= PROBES; i++) {
            for (int c = 0; c < 3; c++) p[c] = draw(-0.05, cells.plane[c][GRID] + 0.05);
            CHECK_INT(probe(&f, p, size), i);
            depth[i] = depth_in_cells(p, 0);
        }
        CHECK_INT(look(NULL), SP_OK);
        for (int32_t i = 1, o = 0; i <= PROBES; i++) {
            const int found = o < report.overlaps && seen[o].b == i;
            if (fabs(depth[i]) > 4 * size) CHECK_INT(found, depth[i] > 0);
            if (found) CHECK_WITHIN(seen[o++].depth, depth[i], 4 * size);
            deep += found;
        }
    }
    CHECK(deep > 60);
}

/* A cube with edges of 2 from (at, at, at) on, whose sides are n by n squares. */
static void cube_of_squares(const frame *f, double at, int n)
{
    for (int32_t k = 0; k < 6 * n * n; k++) {
        const int side = k % 2, c = k / 2 % 3, d = (c + 1) % 3, e = (c + 2) % 3;
        double x[4][3];
        for (int v = 0; v < 4; v++) {
            const int q = side ? v : 3 - v;
            x[v][c] = at + 2 * side;
            x[v][d] = at + 2.0 / n * (k / 6 % n + (q == 1 || q == 2));
            x[v][e] = at + 2.0 / n * (k / 6 / n + (q > 1));
        }
        four(f, x, 0);
    }
}

/* Two more cubes of the block to either side of all it is asked of: no shadow tells the depth. */
TEST(a_small_triangle_in_a_cube_of_squares_lies_as_deep_as_its_nearest_side)
{
    enum { PROBES = 40 };
    const double size = 1e-5;
    draws = 13;
    for (int k = 0; k < 2; k++) {
        const frame f = k == 1 ? any_frame(3) : upright();
        double depth[PROBES + 1], p[3];
        NEED(open_scene(PROBES + 1, 4096));
        for (int i = -1; i < 2; i++) cube_of_squares(&f, 9 * i, i ? 1 : 8 - 3 * k);
        (void)finish(0);
        for (int i = 1; i <= PROBES; i++) {
            depth[i] = 9;
            for (int c = 0; c < 3; c++) {
                p[c] = draw(0.01, 1.99);
                depth[i] = fmin(depth[i], fmin(p[c], 2 - p[c]));
            }
            CHECK_INT(probe(&f, p, size), i);
        }
        CHECK_INT(look(NULL), SP_OK);
        CHECK_INT(report.overlaps, PROBES);
        for (int i = 0; i < PROBES; i++) CHECK_WITHIN(seen[i].depth, depth[i + 1], 4 * size);
    }
}

/* ------------------------------------------------------------------------------------------------------ drawn blocks */

/* A block that is drawn, in a frame: boxes, prisms over outlines, cells, plates, and supports that are open or flat. */
enum { BOX, ELL, ROUND, CELLS, PLATE, FLAT, LID, SHAPES };

static void any_prism(const frame *f, int32_t n, double (*xy)[2], double high)
{
    const int fan = draw(0, 1) < 0.3 ? n / 2 : -1;
    prism(f, n, xy, 0, high, fan, draw_int(0, n), 0);
}

/* Sides of a box, but for the last `without`. */
static void sides(const frame *f, const double size[3], int without, int cut)
{
    for (int k = 0; k < 6 - without; k++) {
        const int c = k / 2, d = (c + 1) % 3, e = (c + 2) % 3;
        double x[4][3];
        for (int v = 0; v < 4; v++) {
            const int q = k % 2 ? v : 3 - v;
            x[v][c] = k % 2 ? size[c] : 0;
            x[v][d] = q == 1 || q == 2 ? size[d] : 0;
            x[v][e] = q > 1 ? size[e] : 0;
        }
        four(f, x, cut);
    }
}

static void any_block(const frame *f, int shape)
{
    double xy[20][2], size[3];
    for (int k = 0; k < 3; k++) size[k] = 0.5 * draw_int(1, 4);
    if (shape == BOX) sides(f, size, 0, draw_int(0, 2));
    if (shape == PLATE) { const double flat[3] = { 3, 3, 0.05 }; sides(f, flat, 0, draw_int(0, 2)); }
    if (shape == LID) { const int without = draw_int(1, 4); sides(f, size, without, draw_int(0, 2)); }
    if (shape == FLAT) sides(f, size, 5, draw_int(0, 2));
    if (shape == CELLS) { share_out(1, 0.5); *owner_of((const int32_t[3]){ 1, 1, 1 }) = 0; (void)block_of(f, 0, 3, 0); }
    if (shape == ELL) any_prism(f, 6, ell, size[2]);
    if (shape == ROUND) {
        const int32_t n = draw_int(5, 20);
        for (int32_t k = 0; k < n; k++) {
            xy[k][0] = cos(6.283185307179586 * k / n);
            xy[k][1] = sin(6.283185307179586 * k / n);
        }
        any_prism(f, n, xy, size[2]);
    }
    if (made.faces) finish(shape >= FLAT ? SP_FIXED : 0);
}

/* First that of f, then the other. */
static frame both(const frame *f, const frame *g)
{
    frame h = *g;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            h.r[i][j] = 0;
            for (int k = 0; k < 3; k++) h.r[i][j] += g->r[i][k] * f->r[k][j];
            h.shift[i] += g->r[i][j] * f->shift[j];
        }
    }
    return h;
}

/* `count` scenes of so many blocks at halves of up to `reach`, by quarters of a turn or, of turn 1, any way; each pushed and
 * tilted by up to `far`; all of them turned, and shifted by up to `away`. how: below. is: joints, points, overlaps; areas,
 * normals, places of corners, depths, pairs. */
typedef struct drawn { int seed, count, blocks; double reach, far, away; int turn, how; tally is; } drawn;

enum { PLAIN, NEARER, IN_METRES, ANGLE, RISE };

static sp_contact_settings settings_of(int how)
{
    sp_contact_settings set = sp_contact_settings_default();
    if (how == NEARER) set.distance = R(1e-3);
    if (how >= IN_METRES) { set.distance = R(2e-2); set.absolute = 1; }
    if (how == ANGLE) set.angle = R(0.3);
    if (how == RISE) set.angle = -8;
    return set;
}

static void draw_scene(const drawn *d)
{
    const frame all = any_frame(d->away);
    if (!open_scene(d->blocks, 300 * d->blocks)) return;
    for (int32_t b = 0; b < d->blocks; b++) {
        frame f = d->turn ? any_frame(0) : upright(), tilt = tilted(d->far, d->far);
        for (int k = d->turn ? 0 : draw_int(0, 3); k > 0; k--) { const frame q = turned(1, 0, 0, 1, 0, 1); f = both(&q, &f); }
        for (int k = 0; k < 3; k++) tilt.shift[k] += 0.5 * draw_int(0, (int)(2 * d->reach));
        f = both(&f, &tilt);
        f = both(&f, &all);
        const int shape = draw_int(0, SHAPES - 1);
        const uint32_t same = draws;
        any_block(&f, shape);
        if (draw(0, 1) > 0.1 || ++b == d->blocks) continue;
        draws = same;                                   /* the same once more */
        any_block(&f, shape);
    }
}

/* Sums over what was found; a sum of places as far away as the scene is. */
static void add_found(double found[TALLY_FOUND])
{
    for (int32_t j = 0; j < scene.count.joints; j++) {
        const sp_joint *o = &scene.joint[j];
        found[0] += (double)o->area;
        found[1] += (j + 1) * (double)(o->n[0] + 2 * o->n[1] + 3 * o->n[2]);
        for (int32_t v = o->point; v < o->point + o->points; v++)
            found[2] += (v + 1) * (double)(scene.point[v][0] + 2 * scene.point[v][1] + 3 * scene.point[v][2]);
    }
    for (int32_t k = 0; k < report.overlaps && k < SEEN; k++) {
        found[3] += (double)seen[k].depth;
        found[4] += (k + 1) * (seen[k].a + 10.0 * seen[k].b);
    }
}

static void compare(const drawn *rows, size_t n)
{
    for (size_t k = 0; k < n; k++) {
        const sp_contact_settings set = settings_of(rows[k].how);
        double found[TALLY_FOUND] = { 0 };
        sp_cost sum;
        memset(&sum, 0, sizeof sum);
        draws = (uint32_t)rows[k].seed;
        for (int i = 0; i < rows[k].count; i++) {
            draw_scene(&rows[k]);
            CHECK_INT(look(&set), SP_OK);
            add_found(found);
            sum.factorisations += report.joints;
            sum.iterations += report.points;
            sum.interior += report.overlaps;
        }
        tally_compare("places", k, &rows[k].is, 0, &sum, 0, found);
    }
}

TEST(drawn_blocks_touch_as_written_here)
{
    static const drawn rows[] = {
        { 21, 1, 10, 3, 0, 3, 0, PLAIN,
          { 0, 2, 9, 7, 0, 0, { 0.74747229, 7.1946985, 250.64485, 4.002203, 2184 } } },
        { 22, 2, 10, 3, 1e-9, 3, 0, PLAIN,
          { 0, 1, 4, 9, 0, 0, { 1, -2.2291522, 71.442943, 4.9222756, 1586 } } },
        { 23, 1, 10, 3, 1e-6, 3, 0, PLAIN,
          { 0, 10, 54, 4, 0, 0, { 4.6398962, 31.201865, -12619.943, 1.3004202, 803 } } },
        { 24, 2, 10, 3, 0, 1e4, 0, PLAIN,
          { 0, 4, 16, 18, 0, 0, { 2.0806619, 2.3521273, 1834288.1, 7.7182692, 6951 } } },
        { 25, 1, 10, 3, 0, 3, 1, PLAIN,
          { 0, 0, 0, 9, 0, 0, { 0, 0, 0, 2.5777012, 3469 } } }
    };
    compare(rows, sizeof rows / sizeof *rows);
}

TEST(drawn_blocks_touch_within_a_distance_as_written_here)
{
    static const drawn rows[] = {
        { 31, 2, 10, 3, 1e-4, 3, 0, NEARER,
          { 0, 7, 28, 10, 0, 0, { 2.5619757, -18.651597, -2438.3095, 3.8248887, 3995 } } },
        { 32, 2, 10, 3, 3e-4, 3, 0, IN_METRES,
          { 0, 10, 47, 10, 0, 0, { 3.3763127, -39.604898, 3333.0068, 4.3233591, 2548 } } },
        { 33, 1, 12, 3, 2e-2, 3, 0, ANGLE,
          { 0, 5, 20, 10, 0, 0, { 3.0224169, -15.956229, -810.21195, 0.52572633, 4871 } } },
        { 34, 2, 9, 3, 2e-2, 3, 0, RISE,
          { 0, 3, 12, 9, 0, 0, { 1.6369466, -2.2404691, -545.12477, 3.0690315, 1719 } } },
        { 35, 1, 12, 3, 1e-4, 1e3, 0, IN_METRES,
          { 0, 3, 16, 12, 0, 0, { 1.0695329, 3.4498802, -411698.15, 4.9118523, 5886 } } }
    };
    compare(rows, sizeof rows / sizeof *rows);
}

TEST(many_drawn_blocks_touch_as_written_here)
{
    static const drawn rows[] = {
        { 41, 1, 36, 4, 0, 3, 0, PLAIN,
          { 0, 11, 57, 27, 0, 0, { 7.19509, -14.768418, -20527.867, 12.45778, 103637 } } },
        { 42, 1, 30, 4, 3e-4, 3, 0, IN_METRES,
          { 0, 16, 67, 26, 0, 0, { 8.5423039, 25.978988, -2331.1272, 10.021629, 85852 } } }
    };
    compare(rows, sizeof rows / sizeof *rows);
}

/* ----------------------------------------------------------------------------------------------- all pairs, one by one */

/* The same block in another scene. */
static void copy_block(const sp_scene *from, int32_t block, sp_scene *to)
{
    const sp_block *k = &from->block[block];
    int32_t size[128], corner[512], n = 0;
    for (int32_t f = 0; f < k->faces; f++) {
        const sp_face *o = &from->face[k->face + f];
        size[f] = o->corners;
        for (int32_t c = 0; c < o->corners; c++) corner[n++] = from->corner[o->corner + c] - k->vertex;
    }
    const sp_mesh mesh = { k->vertices, k->faces, from->vertex[k->vertex], size, corner };
    CHECK_INT(sp_scene_block(to, &mesh, 2400, k->fixed, NULL), SP_OK);
}

/* Do the joints of a pair come next in the scene, to the bit? */
static int come_next(const sp_scene *pair, int32_t a, int32_t b, int32_t *next)
{
    for (int32_t j = 0; j < pair->count.joints; j++, (*next)++) {
        const sp_joint *p = &pair->joint[j], *q = &scene.joint[*next];
        if (*next >= scene.count.joints || q->a != a || q->b != b || p->points != q->points) return 0;
        if (memcmp(pair->point[p->point], scene.point[q->point], (size_t)p->points * sizeof *pair->point)) return 0;
    }
    return 1;
}

/* 39 cubes and boxes at halves, some of them twice, and a slab under all. */
static int crowd(double lean)
{
    const frame all = any_frame(2), slope = turned(1, lean, 0, 0, 0, 1);
    if (!open_scene(40, 40 * 48)) return 0;
    for (int32_t b = 0; b < 40; b++) {
        const double large[3] = { 9, 9, 0.5 };
        double size[3] = { 0, 0, 0.5 };
        for (int k = 0; k < 2; k++) size[k] = 0.5 * draw_int(1, 3);
        frame f = upright();
        for (int k = 0; k < 3; k++) f.shift[k] = b == 17 ? -0.5 : 0.5 * draw_int(0, 6);
        f = both(&f, &slope);
        f = both(&f, &all);
        sides(&f, b == 17 ? large : size, 0, draw_int(0, 2));
        (void)finish(b % 7 == 6 ? SP_FIXED : 0);
    }
    return 1;
}

TEST(all_blocks_find_what_each_pair_finds_alone)
{
    draws = 51;
    for (int k = 0; k < 2; k++) {
        int32_t next = 0, overlaps = 0;
        NEED(crowd(k));
        CHECK_INT(look(NULL), SP_OK);
        const sp_contact_report whole = report;
        const sp_arena mark = test_arena;
        for (int32_t a = 0; a < 40; a++)
            for (int32_t b = a + 1; b < 40; b++) {
                const sp_capacity room = { 2, 96, 24, 96, 20, 200, 0 };
                sp_contact_report one = { 0, 0, 0, 0, NULL };
                sp_scene pair;
                test_arena = mark;
                CHECK_INT(sp_scene_create(&pair, &room, &test_arena), SP_OK);
                copy_block(&scene, a, &pair);
                copy_block(&scene, b, &pair);
                CHECK_INT(sp_contacts_find(&pair, NULL, test_arena, &one), SP_OK);
                CHECK(come_next(&pair, a, b, &next));
                if (one.overlaps) CHECK(overlaps < whole.overlaps && seen[overlaps].a == a && seen[overlaps].b == b);
                overlaps += one.overlaps;
            }
        CHECK_INT(next, whole.joints);
        CHECK_INT(overlaps, whole.overlaps);
        CHECK(next > 40);
    }
}

/* ------------------------------------------------------------------------------------------------------ rare places */

/* A fixed triangle. */
static void triangle(const frame *f, const double *p, const double *q, const double *r)
{
    double x[3][3];
    memcpy(x[0], p, sizeof *x);
    memcpy(x[1], q, sizeof *x);
    memcpy(x[2], r, sizeof *x);
    face(f, 3, x);
    (void)finish(SP_FIXED);
}

/* A triangle beside a cube of 1 m, its corners in any order and way round: it is so deep inside. */
static void triangle_in_cube(const double x[3][3], double depth)
{
    const double one[3] = { 1, 1, 1 };
    draws = 61;
    for (int k = 0; k < 12; k++) {
        const frame f = any_frame(1);
        const int order = k % 3, other = k < 6 ? 1 : 2;
        NEED(open_scene(2, 64));
        sides(&f, one, 0, k % 3);
        (void)finish(0);
        triangle(&f, x[order], x[(order + other) % 3], x[(order + 2 * other) % 3]);
        CHECK_INT(look(NULL), SP_OK);
        CHECK_INT(report.overlaps, 1);
        CHECK_WITHIN(seen[0].depth, depth, 1e-9);
    }
}

TEST(each_corner_of_a_flat_support_may_be_the_one_inside)
{
    const double x[3][3] = { { 0.5, 0.5, 0.75 }, { 0.2, 0.4, 3 }, { 0.7, 0.9, 3 } };
    triangle_in_cube(x, 0.25);
}

/* One edge goes right through. It was seen only where its first vertex came first. */
TEST(each_edge_of_a_flat_support_may_be_the_one_inside)
{
    const double x[3][3] = { { -1, 0.5, 0.5 }, { 2, 0.5, 0.5 }, { 0.5, 0.5, 9 } };
    triangle_in_cube(x, 0.5);
}

/* A lid above a U with a stone between its legs, none of them inside another; the lid's first face looks up. */
TEST(a_stone_in_a_notch_is_not_inside_what_the_next_block_closes)
{
    double you[8][2] = { { 0, 0 }, { 3, 0 }, { 3, 3 }, { 2, 3 }, { 2, 1 }, { 1, 1 }, { 1, 3 }, { 0, 3 } };
    const double over[3] = { 9, 9, 0.5 };
    frame lie = { { { 1, 0, 0 }, { 0, 0, -1 }, { 0, 1, 0 } }, { 0, 0, 0 }, 1 }, up = upright();
    NEED(open_scene(3, 300));
    prism(&lie, 8, you, 0, 1, -1, 0, 0);
    up.shift[0] = up.shift[1] = -4;
    up.shift[2] = 4;
    double top[4][3] = { { 0, 0, 1 }, { 9, 0, 1 }, { 9, 9, 1 }, { 0, 9, 1 } };
    for (int v = 0; v < 4; v++) top[v][2] = over[2];
    four(&up, top, 0);
    sides(&up, over, 1, 0);
    (void)finish(0);
    box(&lie, 1.25, 1.25, 0.25, 1.75, 2, 0.75, 0);
    CHECK_INT(look(NULL), SP_OK);
    CHECK_INT(report.joints, 0);
    CHECK_INT(report.overlaps, 0);
}

/* Of two cubes of 1e-85 m what large ones share: squares of areas are below all numbers. */
TEST(very_small_blocks_touch_as_others_do)
{
    for (int k = 0; k < 2; k++) {
        frame f = turned(1, 0.2, 0.3, -0.1, 0, k ? 1e-85 : 1);
        NEED(open_scene(2, 96));
        box(&f, 0, 0, 0, 1, 1, 1, 0);
        box(&f, 0.25, 0.5, 1, 1.25, 1.5, 2, 0);
        CHECK_INT(look(NULL), SP_OK);
        CHECK_INT(report.joints, 1);
        CHECK_INT(report.points, 4);
        CHECK_NEAR(area_sum(), 0.375 * f.unit * f.unit, 1e-9);
    }
}

/* Narrower than the distance: found where faces are in one plane to 4e-9 diameters. */
TEST(a_narrow_contact_is_found_where_its_faces_are_in_one_plane)
{
    const double gap[] = { 0, 1e-9, 8e-9, 1e-7, 1e-6 };
    sp_contact_settings set = sp_contact_settings_default();
    set.distance = R(1e-3);
    set.absolute = 1;
    for (int k = 0; k < 5; k++) {
        const frame f = upright();
        NEED(open_scene(2, 96));
        box(&f, 0, 0, 0, 1, 1, 1, 0);
        box(&f, 1 - 3e-4, 0, 1 + gap[k], 2, 1, 2, 0);
        CHECK_INT(look(&set), SP_OK);
        CHECK_INT(report.joints, k < 2);
    }
}

TEST(an_angle_of_none_or_of_64_distances_is_allowed_and_no_more)
{
    const frame f = upright();
    sp_contact_settings set = sp_contact_settings_default();
    NEED(open_scene(2, 96));
    box(&f, 0, 0, 0, 1, 1, 1, 0);
    box(&f, 0, 0, 1, 1, 1, 2, 0);
    for (int k = 0; k < 2; k++) {
        set.angle = R(k ? 0 : -64);
        CHECK_INT(look(&set), SP_OK);
        CHECK_INT(report.joints, 1);
    }
    set.angle = R(-64.0001);
    CHECK_INT(look(&set), SP_E_RANGE);
}

/* At large distances: of unit cubes a quarter of volume over diameter squared, 1/12. */
TEST(cubes_overlap_beyond_a_twelfth_at_large_distances)
{
    sp_contact_settings set = sp_contact_settings_default();
    set.distance = R(0.5);
    set.absolute = 1;
    for (int k = 0; k < 2; k++) {
        const frame f = upright();
        const double low = 1 - 1.0 / 12 + (k ? 1e-6 : -1e-6);
        NEED(open_scene(2, 96));
        box(&f, 0, 0, 0, 1, 1, 1, 0);
        box(&f, 0.3, 0.3, low, 1.3, 1.3, low + 1, 0);
        CHECK_INT(look(&set), SP_OK);
        CHECK_INT(report.overlaps, 1 - k);
    }
}

/* A hole narrower than the distance, but wider than what is an edge at the default one: none at a distance above. */
TEST(a_hole_narrower_than_the_distance_is_filled)
{
    sp_contact_settings set = sp_contact_settings_default();
    set.absolute = 1;
    for (int k = 0; k < 2; k++) {
        const frame f = any_frame(1);
        set.distance = R(k ? 1e-6 : 1e-3);
        NEED(open_scene(2, 2048));
        share_out(1, 0);
        for (int c = 0; c < 3; c++)
            for (int i = 0; i <= GRID; i++) cells.plane[c][i] = i < 2 ? i : i - 1 + 4e-4;
        for (int32_t i = 0; i < GRID; i++) *owner_of((const int32_t[3]){ 1, 1, i }) = -1;
        (void)block_of(&f, 0, 0, 0);
        box(&f, -1, -1, -1, 3, 3, 0, 0);
        CHECK_INT(look(&set), SP_OK);
        CHECK_INT(report.joints, k ? 2 : 1);
        CHECK_NEAR(area_sum(), 2.0004 * 2.0004 - (k ? 16e-8 : 0), 1e-9);
    }
}

/* Two sheets of a support, a hair beside each other, give a block twice the same. */
TEST(equal_polygons_come_in_the_order_they_are_found)
{
    for (int k = 0; k < 4; k++) {
        const frame f = upright();
        NEED(open_scene(2, 96));
        box(&f, -1, -1, 0, 2, 2, 1, 0);
        for (int i = 0; i < 2; i++) {
            const double low = i ? -6e-7 : 0, more = (k & 1) == i ? 2e-8 : 0;
            double x[4][3] = { { 0, 0, low }, { 1, 0, low }, { 1 + more, 1 + more, low }, { 0, 1, low } };
            four(&f, x, k / 2);
        }
        (void)finish(SP_FIXED);
        CHECK_INT(look(NULL), SP_OK);
        NEED(CHECK_INT(report.joints, 2));
        CHECK(scene.joint[0].area > scene.joint[1].area);
    }
}

/* A flat support like an hourglass, its larger part face down and tilted a little: above it nothing is touched. */
TEST(a_face_that_crosses_itself_has_the_side_of_its_larger_part)
{
    sp_contact_settings set = sp_contact_settings_default();
    set.distance = R(1e-2);
    set.absolute = 1;
    for (int k = 0; k < 2; k++) {
        double x[4][3] = { { 0, 0, 0 }, { 4, 4, 0 }, { 4, 0, 0 }, { 0, 2, 0 } };
        const frame f = upright(), tilt = turned(1, 1e-4, 5e-5, 0, 0, 1);
        NEED(open_scene(2, 96));
        box(&f, -1, -1, k ? 0 : -1, 5, 5, k ? 1 : 0, 0);
        face(&tilt, 4, x);
        (void)finish(SP_FIXED);
        CHECK_INT(look(&set), SP_OK);
        CHECK_INT(report.joints, k == 0);
        CHECK_WITHIN(area_sum(), k ? 0 : 16.0 / 3, 1e-2);
    }
}

/* Two wedges tip to tip, a hair apart, one turned about the line through both by an angle a, and both turned together. Below
 * 1e-4 edges had no axis of their own, so that turned wedges were told to overlap by up to 5e-5 m. */
TEST(edges_that_are_nearly_parallel_and_a_hair_apart_do_not_overlap)
{
    static const double gap[] = { 1e-7, 1e-6, 1e-5 };
    double left[4][2] = { { -1, 0 }, { -0.5, -0.5 }, { 0, 0 }, { -0.5, 0.5 } };
    double right[4][2] = { { 0, 0 }, { 0.5, -0.5 }, { 1, 0 }, { 0.5, 0.5 } };
    draws = 71;
    for (int k = 0; k < 24; k++) {
        const double a = gap[k % 3] * (k % 8 < 4 ? 4 : 0.5);
        const frame f = k < 3 ? upright() : any_frame(1);
        frame g = turned(1, a / 2, 0, 0, 0, 1);
        g.shift[0] = gap[k % 3];
        g = both(&g, &f);
        NEED(open_scene(2, 96));
        prism(&f, 4, left, -1, 1, -1, 0, 0);
        prism(&g, 4, right, -1, 1, -1, 0, 0);
        CHECK_INT(look(NULL), SP_OK);
        CHECK_INT(report.overlaps, 0);
    }
}

/* Of two drums across each other, too large for axes along two edges: the deepest point told, less than the least way out. */
TEST(large_convex_blocks_lie_as_deep_as_the_deepest_of_their_points)
{
    double xy[64][2];
    frame g = turned(1, 0.6, 0.5, 0.2, 0, 1);
    const frame f = upright();
    for (int32_t k = 0; k < 64; k++) {
        xy[k][0] = cos(6.283185307179586 * k / 64);
        xy[k][1] = sin(6.283185307179586 * k / 64);
    }
    g.shift[0] = 1.6;
    NEED(open_scene(2, 900));
    prism(&f, 64, xy, -1, 1, -1, 0, 0);
    prism(&g, 64, xy, -1, 1, -1, 0, 0);
    CHECK_INT(look(NULL), SP_OK);
    CHECK_INT(report.overlaps, 1);
    CHECK_NEAR(seen[0].depth, 0.8018015, 1e-7);
}

#endif

TEST_LIST(places)
#if defined TALLY_ALL && COUNTED
    RUN(blocks_of_cells_touch_in_the_squares_between_them)
    RUN(a_small_triangle_in_cells_lies_as_deep_as_their_nearest_square)
    RUN(a_small_triangle_in_a_cube_of_squares_lies_as_deep_as_its_nearest_side)
    RUN(drawn_blocks_touch_as_written_here)
    RUN(drawn_blocks_touch_within_a_distance_as_written_here)
    RUN(many_drawn_blocks_touch_as_written_here)
    RUN(all_blocks_find_what_each_pair_finds_alone)
    RUN(each_corner_of_a_flat_support_may_be_the_one_inside)
    RUN(each_edge_of_a_flat_support_may_be_the_one_inside)
    RUN(a_stone_in_a_notch_is_not_inside_what_the_next_block_closes)
    RUN(very_small_blocks_touch_as_others_do)
    RUN(a_narrow_contact_is_found_where_its_faces_are_in_one_plane)
    RUN(an_angle_of_none_or_of_64_distances_is_allowed_and_no_more)
    RUN(cubes_overlap_beyond_a_twelfth_at_large_distances)
    RUN(a_hole_narrower_than_the_distance_is_filled)
    RUN(equal_polygons_come_in_the_order_they_are_found)
    RUN(a_face_that_crosses_itself_has_the_side_of_its_larger_part)
    RUN(edges_that_are_nearly_parallel_and_a_hair_apart_do_not_overlap)
    RUN(large_convex_blocks_lie_as_deep_as_the_deepest_of_their_points)
#endif
TEST_END
