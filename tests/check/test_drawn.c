/* Work of drawn scenes: sums over a few of a kind, counted as test_tally.c counts that of scenes with a name. Those stand
 * straight, mostly in a plane, of equal stones; these are frusta anywhere, stones wedged in by triangles, stacks, walls, rubble
 * and arches, as they are or turned about an axis that is none of the world's, some of them glued, or pushed to a hair from
 * where they fall. */
#include "../scenes/tally.h"

#ifdef TALLY_ALL
#include "../scenes/change.h"
#define sp_scene_from_bytes drawn_from_bytes            /* host/test_kit.c holds them, too */
#define sp_scene_to_bytes drawn_to_bytes
#define sp_scene_of_family drawn_of_family
#define sp_scene_at drawn_at
#include "../../port/fuzz/bytes.c"
#include "../../port/fuzz/families.c"

/* Any frusta; stones wedged in by triangles, and the same without friction; below these a family. */
enum { BYTES = SP_FUZZ_FAMILIES, WEDGED, SMOOTH };

/* `count` scenes of a kind from seed `first` on. turn: 1 turned, 2 in another order. glue: as tally_scene. live: times it is
 * pushed sideways by a gravity, a family < 0 in its plane. how: as each question takes it. is.kind: how many answers are the
 * first word of their kind, and ten times those that are the second, and so on. */
typedef struct drawn {
    int kind, first, count, turn, glue, how;
    double live;
    tally is;
} drawn;

/* What is summed. */
typedef struct sum {
    int kind;
    sp_cost cost;
    size_t bytes;
    double found[TALLY_FOUND];
} sum;

/* Frusta, mostly on each other: bytes of port/fuzz/bytes.c, each between two bounds. */
static sp_scene any_frusta(uint64_t seed)
{
    static const uint8_t stone[10][2] = { { 0, 255 }, { 4, 9 }, { 5, 12 }, { 4, 9 }, { 5, 12 }, { 0, 9 }, { 1, 8 },
                                          { 0, 228 }, { 0, 255 }, { 0, 203 } };
    static const uint8_t rest[12][2] = { { 0, 15 }, { 0, 239 }, { 0, 205 }, { 0, 4 }, { 0, 255 }, { 0, 1 }, { 108, 148 },
                                         { 0, 20 }, { 108, 148 }, { 0, 20 }, { 60, 128 }, { 0, 20 } };
    uint8_t byte[SP_FUZZ_BYTES] = { 0 };
    size_t n = 1;
    sp_scene s;
    byte[0] = (uint8_t)sp_family_int(&seed, 1, SP_FUZZ_BLOCKS - 2);
    for (int b = 0; b < byte[0] + 2; b++)
        for (int k = 0; k < 10; k++) byte[n++] = (uint8_t)sp_family_int(&seed, stone[k][0], stone[k][1]);
    for (int k = 0; k < 12; k++) byte[n++] = (uint8_t)sp_family_int(&seed, rest[k][0], rest[k][1]);
    CHECK_INT(sp_scene_from_bytes(byte, n, &test_arena, &s), SP_OK);
    return s;
}

/* One stone or two, 1.3 m from each other, between two triangles or three each of a fixed one, and one between the two. */
static sp_scene wedged(uint64_t seed, int smooth)
{
    static const sp_capacity cap = { 3, 0, 0, 0, 7, 21, 0 };
    const int stones = sp_family_int(&seed, 1, 2), each = sp_family_int(&seed, 2, 3);
    const sp_strength strength = sp_strength_friction(R(smooth ? 0 : sp_family_real(&seed, 0.3, 1.5)));
    sp_scene s;
    CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
    for (int k = 0; k <= stones; k++) {
        const sp_real at[3] = { R(k ? 1.3 * (k - 1) : -9), 0, 0 };
        CHECK_INT(sp_scene_body(&s, R(k ? 125 * k : 1000), at, k ? 0 : SP_FIXED, NULL), SP_OK);
    }
    for (int q = 0; q < stones * each + stones - 1; q++) {
        const int between = q == stones * each, stone = between ? 2 : 1 + q / each;
        double n[3] = { 1, 0, 0 }, e[2][3] = { { 0, 1, 0 }, { 0, 0, 1 } }, size = 0, across = 0;
        sp_real xyz[9];
        for (int k = 0; k < 3 && !between; k++) {
            n[k] = sp_family_real(&seed, -1, 1) + (k == 2 ? 0.5 : 0);
            e[0][k] = sp_family_real(&seed, -1, 1);
        }
        for (int k = 0; k < 3; k++) { size += n[k] * n[k]; across += n[k] * e[0][k]; }
        for (int k = 0; k < 3; k++) { e[0][k] -= across / size * n[k]; n[k] /= sqrt(size); }
        for (int k = 0; k < 3; k++) e[1][k] = n[(k + 1) % 3] * e[0][(k + 2) % 3] - n[(k + 2) % 3] * e[0][(k + 1) % 3];
        for (int v = 0; v < 3; v++) {                   /* anticlockwise about n, which points from A to the stone */
            const double a = (v == 0) - (v == 2), b = v == 1 ? 1 : -sp_family_real(&seed, 0.2, 0.8);
            const double r = sp_family_real(&seed, 0.1, 0.4), along = between ? 0.65 : 1.3 * (stone - 1);
            for (int k = 0; k < 3; k++)
                xyz[3 * v + k] = R((k ? 0 : along) - (between ? 0 : 0.5 * n[k]) + r * (a * e[0][k] + b * e[1][k]));
        }
        CHECK_INT(sp_scene_joint(&s, between ? 1 : 0, stone, 3, xyz, &strength, NULL), SP_OK);
    }
    return s;
}

/* About (2, 3, 4) by 159 degrees; or in another order, every other joint from its other side. */
static sp_scene turned(const sp_scene *s, int other)
{
    static const double q[3][3] = { { -20, 4, 22 }, { 20, -10, 20 }, { 10, 28, 4 } };
    int32_t place[MOST], name[MOST];
    change c = none();
    sp_scene t;
    c.permute = c.turn = c.swap = other;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3 && !other; j++) c.q[i][j] = q[i][j] / 30;
    copy(s, &c, &t, place, name);
    for (int i = 0; i < 3; i++) t.body[i] = R(c.q[i][0] * s->body[0] + c.q[i][1] * s->body[1] + c.q[i][2] * s->body[2]);
    t.live = s->live;
    return t;
}

static sp_scene drawn_scene(const drawn *d, int k)
{
    const uint64_t seed = (uint64_t)(d->first + k);
    sp_scene s;
    test_renew();
    if (d->kind >= BYTES) {
        s = d->kind == BYTES ? any_frusta(seed) : wedged(seed, d->kind == SMOOTH);
        if (d->live > 0) { s.body[0] = R(6); s.body[1] = R(-8); s.live = R(d->live); }
    } else {
        CHECK_INT(sp_scene_of_family((sp_fuzz_family)d->kind, seed, &test_arena, &s), SP_OK);
        s.live = R(fabs(d->live));
        if (d->live < 0) s.body[1] = 0;
    }
    if (d->turn) s = turned(&s, d->turn > 1);
    tally_glue(&s, d->glue);
    test_arena.peak = test_arena.used;
    return s;
}

static int answers(int word)
{
    int of = 1;
    while (word-- > 0) of *= 10;
    return of;
}

static void add(sum *t, int kind, const sp_cost *cost, size_t bytes, const double found[TALLY_FOUND])
{
    t->kind += kind;
    tally_add(&t->cost, cost);
    t->bytes += bytes;
    for (int e = 0; e < TALLY_FOUND; e++) t->found[e] += found[e];
}

typedef void question(const drawn *d, const sp_scene *s, sum *t);

static void compare(const drawn *rows, size_t n, question *ask)
{
    for (size_t k = 0; k < n; k++) {
        sum t;
        memset(&t, 0, sizeof t);
        for (int i = 0; i < rows[k].count; i++) {
            const sp_scene s = drawn_scene(&rows[k], i);
            ask(&rows[k], &s, &t);
        }
        tally_compare("drawn", k, &rows[k].is, t.kind, &t.cost, t.bytes, t.found);
    }
}

#define COMPARE(rows, ask) compare(rows, sizeof (rows) / sizeof *(rows), ask)

/* ----------------------------------------------------------------------------------------------------------------- checks */

enum { PLANNED, IN_SPACE, IN_8, COARSE, LEAST_SQUARES, DENSE, POLISH, BY_ADMM, NET,
       COUPLED, COUPLED_IN_SPACE, COUPLED_TIGHT, NO_NODES_IN_8, COUPLED_RIGID, COUPLED_BOX, ROUNDS, SEEDED };

static sp_settings asked(int how)
{
    sp_settings set = how == SEEDED ? sp_settings_seed() : sp_settings_default();
    if (how == IN_SPACE || how == COUPLED_IN_SPACE) set.effect[SP_EFFECT_DEPTH] = set.effect[SP_EFFECT_FRICTION] = SP_WITH;
    if (how == IN_8 || how == NO_NODES_IN_8) set.faces = 8;
    if (how == COARSE) set.tol = R(1e-4);
    set.localise = 1;
    set.penalty.net = how == NET;
    if (how >= LEAST_SQUARES && how <= NET) {
        set.stage_count = 1;
        set.stage[0] = how == LEAST_SQUARES ? SP_STAGE_LEAST_SQUARES : how == DENSE ? SP_STAGE_DENSE
                     : how == POLISH ? SP_STAGE_POLISH : SP_STAGE_ADMM;
    }
    set.coupled.asked = how >= COUPLED;
    if (how == COUPLED_TIGHT) { set.coupled.eps = R(1e-4); set.coupled.eta = R(4e-4); }
    if (how == COUPLED_RIGID) set.coupled.eps = 0;
    if (how == NO_NODES_IN_8) set.coupled.nodes = 0;
    if (how == COUPLED_BOX) set.coupled.box = 1;
    if (how == ROUNDS) set.coupled.rounds = 3;
    return set;
}

/* Bytes that a call asks for, its verification, and to tell these; 0 where a build is without it. */
static size_t asks(const sp_scene *s, sp_memory_for what, sp_memory_for verify, const sp_settings *set)
{
    size_t bytes = 0, more = 0;
    if (sp_memory(s, what, set, test_arena, &bytes)) bytes = 0;
    if (sp_memory(s, verify, set, test_arena, &more)) more = 0;
    return bytes + more + sp_memory_scratch(s, what, set) + sp_memory_scratch(s, verify, set);
}

/* Why each effect was on or off, and why it is not coupled. */
static int why(const sp_result *r)
{
    int n = (int)r->coupled.reason;
    for (int k = 0; k < SP_EFFECTS; k++) n += (k + 1) * (int)r->effect[k];
    return 10000 * n;
}

static void check_it(const drawn *d, const sp_scene *s, sum *t)
{
    const sp_settings set = asked(d->how);
    const size_t bytes = asks(s, SP_FOR_PLAN, SP_FOR_VERIFY, &set) + asks(s, SP_FOR_WORK, SP_FOR_CHECK, &set);
    sp_result r;
    if (!CHECK_INT(sp_check(s, &set, &test_arena, &r), SP_OK)) return;
    double help = (double)r.coupled.tension_ratio;
    for (int32_t i = 0; i < s->count.joints; i++) help += (double)r.demand[i].tension + (double)r.demand[i].friction;
    const double found[] = { (double)r.imbalance, (double)r.least_imbalance, tally_size(r.f, 3 * (size_t)s->count.points),
                             tally_size(r.coupled.dq ? r.coupled.dq : r.dq, 6 * (size_t)s->count.blocks), help };
    add(t, answers(d->how < COUPLED ? (int)r.verdict : (int)r.coupled.verdict) + why(&r), &r.spent.total,
        r.spent.peak_bytes + bytes, found);
}

/* At loads 1e-3, 1e-5 and 1e-7 within each end of the limit and beyond it. */
static void near_it(const drawn *d, const sp_scene *s, sum *t)
{
    sp_limit_result x;
    sp_arena mark;
    CHECK_INT(sp_limit(s, NULL, &test_arena, &x), SP_OK);
    mark = test_arena;
    for (int k = 0; k < 12; k++) {
        static const double gap[6] = { -1e-3, -1e-5, -1e-7, 1e-7, 1e-5, 1e-3 };
        const double end = k < 6 ? (double)x.upper : (double)x.lowest;
        sp_scene u = *s;
        if (!(end > 0 && end < 1e3)) continue;
        u.live = R(end * (1 + gap[k % 6]));
        check_it(d, &u, t);
        test_arena = mark;
    }
}

static void limit_it(const drawn *d, const sp_scene *s, sum *t)
{
    const sp_settings set = asked(d->how);
    sp_limit_result x;
    memset(&x, 0, sizeof x);
    const size_t bytes = asks(s, SP_FOR_LIMIT, SP_FOR_LIMIT_VERIFY, &set);
    CHECK_INT(sp_limit(s, &set, &test_arena, &x), SP_OK);
    const double found[] = { (double)x.lower, (double)x.upper, (double)x.lowest, (double)x.within, (double)x.least_imbalance };
    add(t, answers((int)x.kind), &x.cost, x.peak_bytes + bytes, found);
}

static void strong_of(const drawn *d, const sp_scene *s, sum *t)
{
    sp_strong_settings how = sp_strong_settings_default();
    sp_strong_result x;
    sp_result r;
    const size_t bytes = asks(s, SP_FOR_STRONG, SP_FOR_STRONG_VERIFY, NULL);
    how.starts = 2 + 4 * d->how;
    CHECK_INT(sp_check(s, NULL, &test_arena, &r), SP_OK);
    CHECK_INT(sp_strong(s, NULL, &how, r.f, NULL, &test_arena, &x), SP_OK);
    const double found[] = { (double)x.residual, (double)x.moves, (double)x.margin,
                             tally_size(x.f, 3 * (size_t)s->count.points), tally_size(x.a, 6 * (size_t)s->count.blocks) };
    add(t, answers((int)x.kind), &x.cost, x.peak_bytes + bytes, found);
}

static void slide_it(const drawn *d, const sp_scene *s, sum *t)
{
    sp_sliding_settings how = sp_sliding_settings_default();
    sp_sliding_result x;
    sp_limit_result limit;
    const size_t bytes = asks(s, SP_FOR_SLIDING, SP_FOR_SLIDING_VERIFY, NULL);
    how.starts = 2 + 4 * d->how;
    CHECK_INT(sp_limit(s, NULL, &test_arena, &limit), SP_OK);
    CHECK_INT(sp_sliding(s, NULL, &how, &limit, &test_arena, &x), SP_OK);
    const double still = tally_size(x.resting, 3 * (size_t)s->count.points);
    const double found[] = { (double)x.lower, (double)x.lower_strong, (double)x.share + still,
                             tally_size(x.f, 3 * (size_t)s->count.points), tally_size(x.v, 6 * (size_t)s->count.blocks) };
    add(t, answers((int)x.kind), &x.cost, x.peak_bytes + bytes, found);
}

/* Up in the order of their numbers, held where it falls; every third is taken out and set again. how: the first step is all but
 * the last stone. */
static void build_it(const drawn *d, const sp_scene *s, sum *t)
{
    const int32_t n = s->count.blocks;
    sp_presence there[MOST];
    sp_sequence *q;
    sp_suggestion next;
    sp_step step;
    for (int32_t b = 0; b < n; b++) there[b] = b < n - 1 ? SP_PRESENT : SP_ABSENT;
    CHECK_INT(sp_sequence_open(s, NULL, &test_arena, &q), SP_OK);
    if (d->how) CHECK_INT(sp_sequence_fill(q, there, &step), SP_OK);
    for (int32_t i = 0; i < 2 * n; i++) {
        const int32_t b = i / 2;
        double found[TALLY_FOUND] = { 0 };
        sp_held held;
        if (i % 2 && b % 3) continue;
        CHECK_INT(sp_sequence_set(q, b, d->how == i % 2 ? SP_PRESENT : i % 4 ? SP_HELD : SP_ABSENT, &step), SP_OK);
        found[0] = (double)step.imbalance;
        found[1] = (double)step.least_imbalance;
        found[2] = tally_size(step.f, 3 * (size_t)s->count.points);
        found[3] = tally_size(step.dq, 6 * (size_t)n);
        found[4] = step.again + 100.0 * step.local + 1e4 * step.islands + 1e6 * step.block;
        add(t, answers((int)step.verdict), &step.cost, 0, found);
        if (step.verdict == SP_STABLE) continue;
        CHECK_INT(sp_sequence_hold(q, 0, &held), SP_OK);
        tally_add(&t->cost, &held.cost);
        t->found[4] += (int)held.proof + 10 * held.checks;
        for (int32_t h = 0; h < held.count; h++) t->found[4] += 100 * held.block[h] + 1e4 * held.must[h];
    }
    for (int32_t way = 0; way < 2; way++) {
        CHECK_INT(sp_sequence_suggest(q, way, 0, &next), SP_OK);
        tally_add(&t->cost, &next.cost);
        t->found[4] += next.block;
    }
    t->bytes += test_arena.peak;
}

/* All at once but every how-th; what must be held; and what more when those are held one after the other. */
static void hold_it(const drawn *d, const sp_scene *s, sum *t)
{
    sp_presence there[MOST];
    sp_sequence *q;
    sp_step step;
    sp_held held;
    for (int32_t b = 0; b < s->count.blocks; b++) there[b] = d->how && b % d->how == d->how - 1 ? SP_ABSENT : SP_PRESENT;
    CHECK_INT(sp_sequence_open(s, NULL, &test_arena, &q), SP_OK);
    CHECK_INT(sp_sequence_fill(q, there, &step), SP_OK);
    for (int round = 0; round < 3; round++) {
        double found[TALLY_FOUND] = { 0 };
        int32_t first = SP_NONE;
        CHECK_INT(sp_sequence_hold(q, 0, &held), SP_OK);
        for (int32_t k = 0; k < held.count; k++) {
            found[0] += held.block[k] + 1;
            found[1] += held.must[k];
            if (!k) first = held.block[k];
        }
        found[2] = held.count;
        found[3] = held.checks;
        found[4] = (double)step.imbalance;
        add(t, answers((int)held.proof), &held.cost, 0, found);
        if (first == SP_NONE) return;
        CHECK_INT(sp_sequence_set(q, first, SP_HELD, &step), SP_OK);
    }
}

/* The same blocks, four-sided faces cut into triangles, each moved by up to `far` [m]. */
static sp_scene cut(const sp_scene *s, uint64_t seed, double far)
{
    sp_capacity room = s->capacity;
    sp_scene t;
    room.faces *= 2;
    room.corners *= 2;
    CHECK_INT(sp_scene_create(&t, &room, &test_arena), SP_OK);
    for (int32_t k = 0; k < s->count.blocks; k++) {
        const sp_block *b = &s->block[k];
        int32_t size[12], corner[36], n = 0;
        sp_real xyz[24], by[3];
        for (int i = 0; i < 3; i++) by[i] = sp_family_real(&seed, -far, far);
        for (int32_t v = 0; v < 8; v++)
            for (int i = 0; i < 3; i++) xyz[3 * v + i] = s->vertex[b->vertex + v][i] + by[i];
        for (int32_t f = 0; f < 6; f++) {
            const int32_t *c = s->corner + s->face[b->face + f].corner, from = sp_family_int(&seed, 0, 3);
            for (int32_t i = 0; i < 6; i++) corner[n++] = c[(from + (i > 2 ? (i - 1) % 4 : i)) % 4] - b->vertex;
            size[2 * f] = size[2 * f + 1] = 3;
        }
        const sp_mesh mesh = { 8, 12, xyz, size, corner };
        CHECK_INT(sp_scene_block(&t, &mesh, b->density, b->fixed, NULL), SP_OK);
    }
    return t;
}

/* Contacts of what touches nearly. how: 1 within a centimetre and a tenth, 2 where faces rise four distances at most. */
static void touch_it(const drawn *d, const sp_scene *s, sum *t)
{
    const double far = d->how ? 2e-3 : 1e-7;
    sp_contact_settings how = sp_contact_settings_default();
    sp_overlap within[64];
    sp_contact_report report = { 0, 0, 0, 64, within };
    double found[TALLY_FOUND] = { 0 };
    sp_cost none;
    sp_scene u = cut(s, (uint64_t)s->count.vertices, far);
    memset(&none, 0, sizeof none);
    if (d->how) { how.distance = R(1e-2); how.absolute = 1; how.angle = R(d->how == 1 ? 0.1 : -4); }
    test_arena.peak = test_arena.used;
    CHECK_INT(sp_contacts_find(&u, &how, test_arena, &report), SP_OK);
    for (int32_t j = 0; j < u.count.joints; j++) {
        const sp_joint *o = &u.joint[j];
        found[0] += (double)o->area;
        found[1] += (j + 1) * (double)(o->n[0] + 2 * o->n[1] + 3 * o->n[2]);
        for (int32_t v = o->point; v < o->point + o->points; v++)
            found[2] += (v + 1) * (double)(u.point[v][0] + 2 * u.point[v][1] + 3 * u.point[v][2]);
    }
    for (int32_t k = 0; k < report.overlaps; k++) {
        found[3] += (double)within[k].depth;
        found[4] += (k + 1) * (within[k].a + 10.0 * within[k].b);
    }
    none.factorisations = report.joints;
    none.iterations = report.points;
    none.interior = report.overlaps;
    add(t, 0, &none, 0, found);
}

TEST(drawn_checks_take_the_work_written_here)
{
    static const drawn rows[] = {
        { BYTES, 0, 40, 0, 0, PLANNED, 0, { 47303100, 258, 159, 1, 2112911, 2213384,
          { 15.265798, 2.6189373, 3040276.9, 47.257567, 662556.27 } } },
        { BYTES, 40, 40, 1, 0, PLANNED, 0.2, { 43612470, 390, 304, 6, 5373637, 2344260,
          { 15.751994, 2.9920245, 2855963.2, 33.366786, 7952644.9 } } },
        { BYTES, 80, 40, 1, 0, IN_SPACE, 0, { 51442470, 236, 158, 6, 2878724, 2285132,
          { 17.727346, 3.1284088, 2504250.9, 32.962861, 590300.69 } } },
        { BYTES, 120, 40, 0, 0, IN_8, 0, { 47642650, 294, 194, 5, 2699525, 2230376,
          { 16.096547, 2.2261849, 2603287.8, 38.291254, 514312.96 } } },
        { BYTES, 160, 40, 0, 0, IN_SPACE, 0.2, { 41932740, 625, 547, 9, 5806643, 2124324,
          { 14.799076, 2.2541463, 2484145.9, 38.292037, 477318.84 } } }
    };
    COMPARE(rows, check_it);
}

TEST(drawn_checks_of_families_take_the_work_written_here)
{
    static const drawn rows[] = {
        { SP_FUZZ_STACK, 0, 12, 1, 0, PLANNED, 0.1, { 11400210, 27, 15, 0, 754001, 1161092,
          { 0.081262699, 0.0056246228, 518859.57, 1.732678, 13089.445 } } },
        { SP_FUZZ_STACK, 20, 12, 0, 0, PLANNED, 0.3, { 11400390, 52, 40, 4, 1380125, 1066320,
          { 0.44246306, 0.020200773, 396199.89, 4.1261683, 46805.414 } } },
        { SP_FUZZ_RUBBLE, 0, 6, 0, 0, PLANNED, 0.2, { 5700060, 26, 20, 0, 2827512, 1088828,
          { 7.2574242e-14, 0, 207016.81, 0, -6 } } },
        { SP_FUZZ_RUBBLE, 6, 6, 1, 0, PLANNED, 0.3, { 5700330, 41, 35, 0, 4079261, 1070024,
          { 0.27584272, 0.015699117, 179932.6, 9.671593, 17410.482 } } },
        { SP_FUZZ_RUBBLE, 12, 6, 0, 0, PLANNED, -0.3, { 6660060, 24, 18, 0, 850266, 1320704,
          { 1.0102068e-13, 0, 160791.67, 0, -6 } } },
        { SP_FUZZ_ARCH, 0, 6, 1, 0, IN_8, 0.1, { 5700060, 23, 17, 0, 1011637, 943296,
          { 4.6655215e-14, 0, 354354.24, 0, -6 } } },
        { SP_FUZZ_ARCH, 8, 6, 0, 0, PLANNED, -0.2, { 6660150, 37, 30, 4, 553257, 861280,
          { 0.13385587, 0.00050735135, 337189.95, 1.6896534, 1110.6261 } } },
        { SP_FUZZ_WALL, 0, 5, 0, 0, PLANNED, -0.4, { 5550140, 35, 29, 0, 696170, 783900,
          { 0.051864935, 0.019320389, 1002192.4, 1.4873858, 1329.6509 } } },
        { SP_FUZZ_WALL, 5, 3, 1, 0, IN_SPACE, 0.2, { 2940030, 20, 17, 0, 1611112, 514304,
          { 2.1539616e-14, 0, 744964.34, 0, -3 } } }
    };
    COMPARE(rows, check_it);
}

TEST(drawn_checks_with_strength_take_the_work_written_here)
{
    static const drawn rows[] = {
        { BYTES, 200, 30, 1, 7, PLANNED, 0, { 34131200, 136, 83, 3, 2094728, 1781280,
          { 5.7556584, 1.8015329, 1711869.3, 16.692567, 62015.976 } } },
        { BYTES, 230, 30, 0, 5, COARSE, 0.2, { 26102370, 259, 203, 3, 4166472, 1735836,
          { 9.5146431, 2.0079939, 2478123.5, 36.081901, 331759.18 } } },
        { BYTES, 260, 30, 1, 6, IN_8, 0, { 33941830, 382, 322, 0, 8762813, 1786756,
          { 10.436422, 1.7467969, 1832495, 25.760768, 96627.38 } } },
        { SP_FUZZ_STACK, 5, 12, 0, 4, PLANNED, 0.2, { 9960660, 157, 145, 0, 9648586, 1261784,
          { 0.70207938, 0.065988838, 555498.32, 9.389247, 21393.39 } } },
        { SP_FUZZ_RUBBLE, 0, 4, 1, 3, PLANNED, 0.9, { 3320400, 27, 23, 0, 3637956, 843600,
          { 0.42213547, 0.063847699, 281898.77, 15.776864, 103873.36 } } },
        { SP_FUZZ_ARCH, 3, 4, 1, 7, PLANNED, 0.5, { 3320400, 38, 34, 4, 3044790, 638664,
          { 0.34502858, 0.025032556, 318983.31, 7.4278701, 19613.497 } } }
    };
    COMPARE(rows, check_it);
}

TEST(drawn_checks_by_stages_take_the_work_written_here)
{
    static const drawn rows[] = {
        { BYTES, 300, 30, 0, 0, LEAST_SQUARES, 0, { 43800084, 30, 0, 0, 412791, 1512300,
          { 9.790863, 0, 3058496.6, 0, -30 } } },
        { BYTES, 300, 30, 1, 0, DENSE, 0, { 46500093, 30, 0, 0, 538528, 1761804,
          { 10.030754, 0, 3036707.6, 0, -30 } } },
        { BYTES, 300, 30, 0, 0, POLISH, 0, { 43800120, 30, 8319, 0, 15213751, 1512300,
          { 8.3628592, 0, 3113590.7, 0, -30 } } },
        { BYTES, 330, 10, 1, 7, LEAST_SQUARES, 0, { 14300028, 10, 0, 0, 259040, 536640,
          { 4.8365473, 0, 517313.38, 0, -10 } } },
        { BYTES, 330, 10, 0, 5, DENSE, 0, { 13340010, 10, 0, 0, 302528, 574656,
          { 6.4328248, 0, 527728.64, 0, -10 } } },
        { BYTES, 330, 10, 1, 6, POLISH, 0, { 14300019, 10, 2141, 0, 3927600, 536640,
          { 5.5568321, 0, 527104.33, 0, -10 } } },
        { SP_FUZZ_ARCH, 0, 2, 0, 0, DENSE, 0.1, { 2740002, 2, 0, 0, 370128, 381240,
          { 0.11422747, 0, 106161.4, 0, -2 } } },
        { SP_FUZZ_ARCH, 2, 2, 1, 0, POLISH, 0.1, { 2740020, 2, 267, 0, 1998408, 295456,
          { 5.4294402e-10, 0, 122231.09, 0, -2 } } }
    };
    COMPARE(rows, check_it);
}

TEST(drawn_checks_by_programs_take_the_work_written_here)
{
    static const drawn rows[] = {
        { BYTES, 340, 3, 0, 0, BY_ADMM, 0, { 4320111, 105, 344, 0, 8637883, 1720872,
          { 1.8052709, 0.037203305, 158976.51, 3.5725513, 92421.388 } } },
        { BYTES, 343, 2, 1, 0, NET, 0, { 3100110, 88, 240, 0, 6861183, 1113904,
          { 1, 0.1098688, 58093.714, 1.0476909, -2 } } },
        { SP_FUZZ_STACK, 0, 2, 1, 0, BY_ADMM, 0.1, { 2740011, 18, 205, 0, 6279932, 1607920,
          { 0.00023055, 0, 117831.95, 0, 85.362172 } } }
    };
    COMPARE(rows, check_it);
}

TEST(drawn_coupled_checks_take_the_work_written_here)
{
    static const drawn rows[] = {
        { BYTES, 400, 12, 0, 0, COUPLED, 0, { 13800930, 3546, 3436, 0, 32350248, 103525708,
          { 6.784459, 1.2595498, 638475.8, 0.02766662, 73983.654 } } },
        { BYTES, 430, 8, 1, 0, COUPLED, 0.1, { 6230710, 46955, 46326, 5, 145300954, 75301124,
          { 2.240653, 0.63787221, 443169.98, 0.026976466, 999085.34 } } },
        { SP_FUZZ_STACK, 0, 6, 1, 0, COUPLED, 0.1, { 8280060, 12, 6, 0, 402509, 99917836,
          { 1.0937174e-13, 0, 262499.05, 0.0050247176, -6 } } }
    };
    COMPARE(rows, check_it);
}

TEST(drawn_coupled_checks_in_space_take_the_work_written_here)
{
    static const drawn rows[] = {
        { SP_FUZZ_STACK, 8, 6, 0, 0, COUPLED_IN_SPACE, 0.2, { 6390330, 4974, 4910, 0, 88214161, 117429276,
          { 0.12135728, 0.012603493, 293333.38, 0.014470499, 11102.7 } } },
        { SP_FUZZ_RUBBLE, 0, 2, 1, 0, COUPLED, 0.1, { 1360020, 42, 32, 0, 3378788, 473448,
          { 5.8036646e-12, 0, 75980.24, 0.0016213652, -2 } } },
        { BYTES, 450, 8, 1, 0, COUPLED_IN_SPACE, 0, { 8610710, 279, 228, 0, 2646297, 90185616,
          { 6.1681508, 1.2195461, 340007.01, 0.037499525, 118171.05 } } }
    };
    COMPARE(rows, check_it);
}

TEST(drawn_coupled_checks_in_a_plane_take_the_work_written_here)
{
    static const drawn rows[] = {
        { SP_FUZZ_RUBBLE, 10, 2, 0, 0, COUPLED, -0.1, { 1680020, 36, 26, 0, 1077878, 20802152,
          { 2.9663585e-16, 0, 43680.491, 0.00091802086, -2 } } },
        { SP_FUZZ_ARCH, 0, 2, 0, 0, COUPLED, -0.1, { 1680020, 47, 37, 0, 1056111, 20442680,
          { 3.2195784e-16, 0, 116910.14, 0.0042205529, -2 } } },
        { SP_FUZZ_RUBBLE, 2, 2, 1, 0, COUPLED, -0.2, { 1680020, 39, 29, 0, 1106526, 476616,
          { 8.2549829e-16, 0, 61658.882, 0.0021075757, -2 } } }
    };
    COMPARE(rows, check_it);
}

TEST(drawn_coupled_checks_of_other_lengths_take_the_work_written_here)
{
    static const drawn rows[] = {
        { BYTES, 480, 6, 0, 0, COUPLED_TIGHT, 0, { 7170420, 166, 127, 0, 943499, 42791100,
          { 2.6027984, 0.32019769, 409794.13, 0.0018513434, 46965.345 } } },
        { SP_FUZZ_STACK, 3, 6, 0, 0, COUPLED_RIGID, 0.2, { 7590150, 89, 74, 0, 2817889, 95456704,
          { 0.15107278, 0.013678101, 268250.58, 0.16401406, 40715.133 } } }
    };
    COMPARE(rows, check_it);
}

TEST(drawn_coupled_checks_without_nodes_take_the_work_written_here)
{
    static const drawn rows[] = {
        { BYTES, 100, 10, 1, 0, NO_NODES_IN_8, 0, { 12090820, 455, 364, 6, 2970654, 627364,
          { 6.1711671, 0.95768068, 500035.6, 0.033996007, 169663.39 } } },
        { SP_FUZZ_RUBBLE, 3, 2, 1, 0, NO_NODES_IN_8, 0.1, { 1360020, 42, 32, 0, 2836065, 435364,
          { 9.4721449e-16, 0, 61885.328, 0.0015695245, -2 } } }
    };
    COMPARE(rows, check_it);
}

TEST(drawn_coupled_boxes_and_rounds_take_the_work_written_here)
{
    static const drawn rows[] = {
        { BYTES, 500, 4, 0, 0, COUPLED_BOX, 0, { 3720400, 3389, 3328, 2, 7645283, 44512624,
          { 1.9732925, 0.29042782, 361017.13, 0.015766876, 142472.85 } } },
        { BYTES, 510, 3, 1, 0, ROUNDS, 0, { 2870210, 132, 136, 0, 2030734, 41250984,
          { 1.5589885, 0.35784838, 145982.04, 0.013029143, 80056.567 } } }
    };
    COMPARE(rows, check_it);
}

TEST(drawn_alternations_of_stacks_take_the_work_written_here)
{
    static const drawn rows[] = {
        { SP_FUZZ_STACK, 0, 4, 1, 0, SEEDED, 0.1, { 4482020, 1190, 215, 0, 28567746, 3220304,
          { 4.3697429e-07, 0, 218148.38, 0.0047114597, 9087.0372 } } },
        { SP_FUZZ_STACK, 6, 2, 0, 0, SEEDED, 0.2, { 2211010, 872, 1787, 0, 66037777, 1191760,
          { 0.1530047, 0, 121765.8, 0.019834153, 40719.133 } } }
    };
    COMPARE(rows, check_it);
}

TEST(drawn_alternations_take_the_work_written_here)
{
    static const drawn rows[] = {
        { BYTES, 40, 4, 0, 0, SEEDED, 0, { 4981030, 65, 719, 0, 9174906, 1377776,
          { 0.380899, 0, 134106.63, 0.003453871, 7892.3788 } } }
    };
    COMPARE(rows, check_it);
}

TEST(single_checks_take_the_work_written_here)
{
    static const drawn rows[] = {
        { BYTES, 5145, 1, 1, 0, PLANNED, 0, { 1220100, 7, 5, 0, 7843, 38356,
          { 0.26131449, 0.0402725, 14423.784, 1.0909355, 1444.2603 } } },
        { BYTES, 5645, 1, 1, 7, IN_8, 0.1, { 1040100, 20, 18, 0, 514368, 81732,
          { 0.20216727, 0.0091005125, 31185.085, 2.6324688, 3830.2975 } } },
        { BYTES, 5709, 1, 1, 7, IN_8, 0.1, { 1010100, 15, 13, 0, 266654, 71284,
          { 0.31971468, 0.056274617, 91969.439, 1.9422376, 1815.776 } } },
        { BYTES, 24042, 1, 0, 0, COUPLED, 0, { 1590010, 4, 2, 0, 41026, 17117972,
          { 1.351903e-15, 0, 74565.815, 0.00040910276, -1 } } },
        { BYTES, 24053, 1, 0, 0, COUPLED, 0, { 1590010, 3, 1, 0, 31999, 5145544,
          { 3.9141403e-15, 0, 98357.922, 0.00026482634, -1 } } },
        { BYTES, 24361, 1, 1, 0, COUPLED_BOX, 0.1, { 870100, 6520, 6454, 0, 13218116, 701616,
          { 0.29674943, 0.059069245, 19.672675, 0.001547121, 3.9847836 } } },
        { BYTES, 25010, 1, 1, 0, NO_NODES_IN_8, 0, { 1040010, 20, 12, 0, 468762, 79352,
          { 2.3101609e-16, 0, 13614.798, 0.00025484128, -1 } } },
        { WEDGED, 21803, 2, 1, 0, COUPLED, 0, { 1720020, 80, 70, 0, 882101, 22033300,
          { 3.4589727e-16, 0, 3562.8751, 0.0010096368, -2 } } },
        { WEDGED, 22468, 1, 0, 0, COUPLED_RIGID, 0, { 870100, 955, 924, 4, 9998651, 19767296,
          { 0.77607319, 0.072114401, 564.46734, 0.00140209, 7377.4312 } } }
    };
    COMPARE(rows, check_it);
}

TEST(single_checks_near_limits_take_the_work_written_here)
{
    static const drawn rows[] = {
        { SP_FUZZ_ARCH, 11024, 1, 0, 0, PLANNED, -1, { 6500420, 110, 99, 23, 4432892, 1126152,
          { 0.00055858275, 4.4972855e-06, 243335.2, 6.969328, 457.04269 } } },
        { SP_FUZZ_STACK, 11356, 1, 0, 0, PLANNED, -1, { 11400660, 103, 91, 10, 3560531, 1428240,
          { 0.0078464865, 7.312201e-05, 542840.37, 8.9800688, 85.344293 } } },
        { BYTES, 9799, 1, 1, 7, PLANNED, 1, { 4980330, 87, 66, 9, 1785384, 442608,
          { 0.00010142496, 2.2336831e-05, 382736.49, 7.0742845, 39.045329 } } }
    };
    COMPARE(rows, near_it);
}

TEST(single_limits_take_the_work_written_here)
{
    static const drawn rows[] = {
        { BYTES, 12067, 1, 1, 0, PLANNED, 1, { 10, 13, 10, 9, 198669, 43216,
          { 0, 1.0540898e-08, 0, 1.7568133e-08, 1.5e-09 } } },
        { BYTES, 12958, 1, 0, 2, PLANNED, 1, { 10, 16, 8, 0, 345726, 51476,
          { 0, 5.9424318e-09, 0, 1.0120787e-08, 1.3562126e-09 } } },
        { BYTES, 12955, 1, 0, 2, PLANNED, 1, { 10, 61, 52, 11, 2257948, 59144,
          { 0.40699122, 0.40699123, 0.17149126, 1.7128997e-08, 1.3687726e-09 } } }
    };
    COMPARE(rows, limit_it);
}

TEST(drawn_checks_of_wedged_stones_take_the_work_written_here)
{
    static const drawn rows[] = {
        { WEDGED, 2000, 40, 1, 0, PLANNED, 0, { 45201390, 341, 301, 20, 5076393, 1434984,
          { 5.4130163, 0.76539537, 68199.041, 12.435795, 7773.9411 } } },
        { SMOOTH, 2000, 40, 0, 0, IN_8, 0, { 46403370, 878, 838, 11, 11669495, 1471552,
          { 17.316293, 6.1891528, 282818.25, 25.470688, 37155.979 } } },
        { WEDGED, 2040, 30, 0, 5, PLANNED, 0, { 30300750, 136, 106, 0, 1912302, 1169016,
          { 1.6658072, 0.24479006, 31987.65, 5.6936491, 4544.1865 } } },
        { WEDGED, 2070, 30, 1, 7, IN_8, 0, { 30300300, 74, 44, 0, 930436, 1090908,
          { 2.1380769e-13, 0, 31064.923, 0, -30 } } },
        { SMOOTH, 2100, 20, 0, 6, PLANNED, 0, { 20801550, 491, 471, 2, 13240086, 780644,
          { 8.5568157, 3.2039834, 14949.417, 11.98003, 11699.123 } } },
        { SMOOTH, 2120, 20, 1, 3, IN_8, 0, { 20800380, 71, 51, 0, 1008824, 743332,
          { 0.38972473, 0.1286858, 24032.238, 2.3416259, 1418.817 } } }
    };
    COMPARE(rows, check_it);
}

TEST(drawn_checks_near_limits_take_the_work_written_here)
{
    static const drawn rows[] = {
        { BYTES, 1300, 24, 1, 0, PLANNED, 1, { 92764890, 1054, 878, 45, 6710493, 4908216,
          { 0.13475438, 0.0013043152, 4813142.1, 69.722973, 79897.226 } } },
        { SP_FUZZ_STACK, 110, 8, 0, 0, PLANNED, 1, { 45602640, 401, 353, 45, 7145711, 4553136,
          { 0.1240282, 0.00036204962, 1693221.8, 28.865353, 405.66773 } } },
        { SP_FUZZ_RUBBLE, 110, 1, 1, 0, PLANNED, 1, { 5700330, 36, 30, 0, 3700152, 1232232,
          { 0.014197973, 2.7165139e-05, 310464.9, 10.321629, 63.924112 } } },
        { SP_FUZZ_ARCH, 110, 3, 0, 0, PLANNED, -1, { 19661170, 261, 230, 47, 8744407, 2924904,
          { 0.0039292655, 4.9430347e-05, 1047757.3, 18.722173, 1746.0063 } } },
        { SP_FUZZ_WALL, 110, 2, 0, 0, IN_8, -1, { 13321200, 192, 168, 30, 6085748, 2272992,
          { 3.8803766, 0.11514763, 3617086.9, 20.219951, 71299.345 } } },
        { WEDGED, 2200, 10, 1, 0, PLANNED, 0.5, { 22801320, 493, 462, 136, 12247520, 943248,
          { 0.87032688, 0.00023277305, 137950.93, 14.696256, 1403.8933 } } },
        { BYTES, 1370, 10, 0, 0, IN_SPACE, 1, { 24781590, 476, 428, 77, 4523895, 1386792,
          { 1.2179124, 0.00021490164, 3293990.1, 21.897029, 1846.928 } } }
    };
    COMPARE(rows, near_it);
}

TEST(drawn_checks_near_limits_of_joints_with_strength_take_the_work_written_here)
{
    static const drawn rows[] = {
        { BYTES, 1330, 16, 1, 7, PLANNED, 1, { 74644191, 959, 824, 104, 14472665, 5688888,
          { 0.20659331, 0.00099487578, 5656233.1, 68.075905, 21538.642 } } },
        { SP_FUZZ_STACK, 130, 6, 0, 5, PLANNED, 1, { 29881980, 151, 115, 0, 2775306, 3282528,
          { 0.0017896023, 0.00038551084, 1129010, 23.934757, 218.20564 } } },
        { SP_FUZZ_ARCH, 111, 2, 0, 4, PLANNED, -1, { 11880660, 195, 174, 42, 6717117, 2133024,
          { 0.0031619469, 4.0988876e-05, 814842.14, 10.109148, 1133.8824 } } },
        { BYTES, 1350, 12, 0, 6, IN_8, 1, { 42543360, 1642, 1546, 0, 25555921, 3122592,
          { 0.79224515, 0.19638629, 5665875.3, 47.86018, 67821.591 } } }
    };
    COMPARE(rows, near_it);
}

TEST(drawn_coupled_checks_of_wedged_stones_take_the_work_written_here)
{
    static const drawn rows[] = {
        { WEDGED, 2045, 1, 0, 0, COUPLED, 0, { 860010, 1629, 1599, 0, 19874082, 7237588,
          { 7.0613028e-17, 0, 1769.661, 0.0021157522, -1 } } },
        { WEDGED, 2124, 1, 0, 0, COUPLED_TIGHT, 0, { 860010, 1055, 1030, 0, 7511279, 2185460,
          { 1.2666389e-16, 0, 805.82726, 0.00063059513, -1 } } },
        { WEDGED, 2132, 1, 1, 0, COUPLED_TIGHT, 0, { 860010, 1867, 1839, 0, 10686955, 2186020,
          { 3.2356966e-16, 0, 951.26267, 0.00037778586, -1 } } },
        { WEDGED, 2069, 1, 0, 0, COUPLED_TIGHT, 0, { 860010, 1667, 1640, 0, 10885871, 7237588,
          { 2.0468814e-16, 0, 853.29336, 0.00071238594, -1 } } },
        { WEDGED, 2085, 1, 0, 0, COUPLED_RIGID, 0, { 860010, 995, 984, 0, 7433816, 7237588,
          { 1.8781017e-16, 0, 1114.4939, 0.0015836198, -1 } } },
        { SMOOTH, 2104, 2, 0, 0, COUPLED, 0, { 1780020, 16, 6, 0, 120358, 14475176,
          { 4.0850971e-16, 0, 1120.5729, 0.00013687702, -2 } } }
    };
    COMPARE(rows, check_it);
}

TEST(drawn_rounds_of_wedged_stones_take_the_work_written_here)
{
    static const drawn rows[] = {
        { WEDGED, 2012, 1, 0, 0, ROUNDS, 0, { 860010, 132, 102, 0, 2712328, 2323080,
          { 3.3758426e-16, 0, 751.10975, 2.9716372e-05, -1 } } },
        { WEDGED, 2002, 1, 1, 0, ROUNDS, 0, { 860010, 100, 223, 0, 5407580, 2323640,
          { 8.9887473e-16, 0, 1392.555, 0.001472164, -1 } } },
        { WEDGED, 2119, 1, 0, 0, ROUNDS, 0, { 860010, 133, 103, 0, 4699843, 7432664,
          { 2.0584004e-14, 0, 818.47117, 8.5909993e-05, -1 } } },
        { WEDGED, 2020, 1, 0, 0, ROUNDS, 0, { 860010, 19, 283, 0, 2075356, 7432664,
          { 3.7829249e-16, 0, 657.7038, 4.8335295e-05, -1 } } },
        { WEDGED, 2109, 1, 0, 0, ROUNDS, 0, { 860010, 17, 173, 0, 2659025, 7432664,
          { 1.7630533e-16, 0, 632.65007, 3.9058039e-05, -1 } } },
        { SMOOTH, 2096, 1, 0, 0, ROUNDS, 0, { 890010, 52, 103, 0, 4394571, 20236088,
          { 6.2722718e-16, 0, 2096.1755, 0.00010560545, -1 } } },
        { SMOOTH, 2134, 1, 1, 0, ROUNDS, 0, { 890010, 48, 92, 0, 4114323, 20237736,
          { 5.9133884e-16, 0, 1943.3258, 0.00014459202, -1 } } },
        { SMOOTH, 2031, 1, 0, 0, ROUNDS, 0, { 890010, 64, 207, 2, 9167155, 20236088,
          { 2.3750954e-15, 0, 33818.352, 0.0016520363, -1 } } },
        { WEDGED, 22755, 1, 0, 0, ROUNDS, 0, { 860010, 97, 173, 0, 13129252, 7432664,
          { 1.9913413e-16, 0, 903.18271, 8.2641217e-05, -1 } } },
        { WEDGED, 22786, 1, 0, 0, ROUNDS, 0, { 860010, 102, 263, 0, 7515924, 7432664,
          { 3.1416919e-16, 0, 1099.8201, 0.0014088552, -1 } } },
        { WEDGED, 22773, 1, 0, 0, ROUNDS, 0, { 860010, 12, 53, 0, 409551, 7432664,
          { 1.6676264e-16, 0, 618.25958, 3.646028e-05, -1 } } }
    };
    COMPARE(rows, check_it);
}

TEST(drawn_alternations_of_wedged_stones_take_the_work_written_here)
{
    static const drawn rows[] = {
        { WEDGED, 2001, 1, 0, 0, SEEDED, 0, { 1321000, 36, 348, 0, 1429296, 191368,
          { 2.4628349e-07, 0, 1089.7908, 0.00047909125, 301.03327 } } },
        { WEDGED, 2105, 1, 1, 0, SEEDED, 0, { 1321000, 38, 262, 0, 1891728, 272776,
          { 2.2814048e-07, 0, 825.60681, 0.00043863822, 46.639003 } } },
        { WEDGED, 2109, 1, 0, 0, SEEDED, 0, { 1280010, 16, 252, 0, 1606368, 272008,
          { 8.5555655e-17, 0, 633.17207, 3.9058302e-05, -1 } } },
        { WEDGED, 2149, 1, 0, 0, SEEDED, 0, { 1321000, 43, 390, 0, 1854479, 191368,
          { 2.3264092e-07, 0, 1133.4315, 0.0011048621, 3561.2575 } } },
        { SMOOTH, 2102, 1, 0, 0, SEEDED, 0, { 1240010, 13, 1416, 0, 11487585, 611480,
          { 8.8010538e-17, 0, 1541.8291, 0.00021363252, -1 } } },
        { WEDGED, 23070, 3, 0, 0, SEEDED, 0, { 3881020, 568, 688, 0, 6042475, 816024,
          { 2.7426096e-07, 0, 1484.6226, 0.00013834147, -1.7581759 } } }
    };
    COMPARE(rows, check_it);
}

TEST(drawn_limits_take_the_work_written_here)
{
    static const drawn rows[] = {
        { SP_FUZZ_STACK, 0, 10, 1, 0, PLANNED, 0, { 100, 96, 76, 75, 3962694, 956328,
          { 3.2346866, 3.2346867, 0, 1.981341e-07, 1.5002531e-08 } } },
        { SP_FUZZ_STACK, 14, 6, 0, 0, IN_8, 0, { 240, 63, 51, 46, 2724346, 609348,
          { -0.61144592, 1.3885541, -1.6863065, 9.3790884e-08, 0.00054246137 } } },
        { BYTES, 520, 24, 0, 0, PLANNED, 1, { 1860, 141, 110, 107, 5727680, 1225780,
          { -15.313617, 2.6863828, -18, 1.122018e-07, 1.5604305 } } },
        { BYTES, 550, 24, 1, 0, IN_8, 1, { 1320, 252, 205, 174, 9014546, 1510988,
          { -9.4187146, 2.5812857, -12, 5.7629626e-07, 0.60786784 } } }
    };
    COMPARE(rows, limit_it);
}

TEST(drawn_limits_of_families_take_the_work_written_here)
{
    static const drawn rows[] = {
        { SP_FUZZ_RUBBLE, 0, 3, 0, 0, PLANNED, 0, { 30, 40, 34, 27, 7957889, 554044,
          { 1.3477561, 1.3477562, 0, 9.9567769e-08, 4.4999999e-09 } } },
        { SP_FUZZ_ARCH, 0, 3, 1, 0, PLANNED, 0, { 30, 38, 32, 29, 3475010, 457860,
          { 1.0613649, 1.061365, 0, 1.1691669e-07, 4.4999999e-09 } } },
        { SP_FUZZ_RUBBLE, 6, 2, 1, 0, IN_SPACE, 0, { 20, 24, 20, 15, 3633614, 319036,
          { 0.59001046, 0.59001048, 0, 3.303777e-08, 3e-09 } } },
        { SP_FUZZ_WALL, 0, 2, 0, 0, PLANNED, -1, { 20, 27, 23, 17, 993475, 248568,
          { 1.0421775, 1.0421775, 0, 2.7790812e-08, 3.0052767e-09 } } }
    };
    COMPARE(rows, limit_it);
}

TEST(drawn_limits_of_joints_with_strength_take_the_work_written_here)
{
    static const drawn rows[] = {
        { SP_FUZZ_STACK, 8, 6, 1, 3, PLANNED, 0, { 60, 191, 167, 4, 7926864, 615780,
          { 2.509689, 2.5096892, 0, 2.2804928e-07, 1.0471236e-08 } } },
        { SP_FUZZ_STACK, 15, 4, 0, 7, IN_SPACE, 0, { 40, 200, 180, 0, 9339493, 386612,
          { 1.551716, 1.5517161, 0.17886767, 9.7410528e-08, 5.9999999e-09 } } },
        { BYTES, 600, 20, 1, 5, PLANNED, 1, { 1100, 453, 379, 0, 16423467, 1135000,
          { 0.74339382, 10.743394, -9.0622776, 2.9529983e-07, 0.89554832 } } },
        { BYTES, 620, 20, 0, 6, PLANNED, 1, { 1460, 617, 533, 70, 20555137, 962508,
          { -10.865957, 3.1340436, -13.423788, 1.4824615e-07, 2.2875167 } } },
        { SP_FUZZ_ARCH, 0, 2, 0, 7, PLANNED, -1, { 20, 108, 100, 0, 4545276, 288968,
          { 5.760212, 5.7602123, 0, 4.7063037e-07, 3e-09 } } }
    };
    COMPARE(rows, limit_it);
}

TEST(drawn_strong_verdicts_take_the_work_written_here)
{
    static const drawn rows[] = {
        { SP_FUZZ_STACK, 0, 6, 1, 0, 0, 0.1, { 60000, 0, 0, 0, 460440, 131166720,
          { 0, 0, 5.9999955, 262286.2, 0 } } },
        { BYTES, 640, 10, 0, 0, 0, 0, { 40105, 0, 0, 0, 2843180, 302955232,
          { 2.1730509e-13, 0.024800341, 0, 375016.52, 0.38113105 } } },
        { BYTES, 660, 8, 1, 0, 1, 0, { 40004, 0, 0, 0, 339120, 220243296,
          { 8.9215477e-16, 0, 0, 211343.19, 0 } } }
    };
    COMPARE(rows, strong_of);
}

TEST(drawn_sliding_limits_take_the_work_written_here)
{
    static const drawn rows[] = {
        { SP_FUZZ_RUBBLE, 0, 3, 0, 0, 0, -1, { 30, 0, 0, 0, 46967108, 1963912,
          { 0, 0, 2.7896751, 149782.53, 4.1776406 } } },
        { SP_FUZZ_ARCH, 0, 2, 0, 0, 0, -1, { 20, 0, 0, 0, 7621576, 963248,
          { 0, 0, 1.8201196, 126139.01, 2.0170302 } } },
        { SP_FUZZ_WALL, 5, 1, 0, 0, 0, -1, { 10, 0, 0, 0, 9606970, 458496,
          { 0, 0, 1, 430801.01, 2.2605492 } } },
        { SP_FUZZ_STACK, 17060, 1, 0, 0, 0, -1, { 10, 0, 0, 0, 41342, 66120,
          { 0.87001423, 0.87001423, 3743.8893, 3867.1496, 0.64093341 } } },
        { SP_FUZZ_RUBBLE, 17363, 1, 0, 0, 0, -1, { 10, 0, 0, 0, 4244840, 334736,
          { 0, 0, 1, 46070.335, 1.6504751 } } },
        { SP_FUZZ_RUBBLE, 17370, 1, 0, 0, 0, -1, { 10, 0, 0, 0, 2196504, 216584,
          { 0, 0, 1, 19069.554, 1.5688909 } } },
        { SP_FUZZ_RUBBLE, 17376, 1, 0, 0, 0, -1, { 10, 0, 0, 0, 3223698, 316024,
          { 0, 0, 1, 15800.387, 1.0612529 } } }
    };
    COMPARE(rows, slide_it);
}

TEST(drawn_sliding_limits_with_more_histories_take_the_work_written_here)
{
    static const drawn rows[] = {
        { SP_FUZZ_RUBBLE, 10, 1, 1, 0, 1, -1, { 10, 0, 0, 0, 112106352, 965776,
          { 5.1417384e-16, 5.1417384e-16, 28854.893, 35629.728, 0.81439681 } } }
    };
    COMPARE(rows, slide_it);
}

TEST(drawn_contacts_take_the_work_written_here)
{
    static const drawn rows[] = {
        { BYTES, 800, 60, 0, 0, 0, 0, { 0, 212, 848, 141, 0, 0,
          { 156.05034, 1497, 27694.605, 62.53931, 16588 } } },
        { BYTES, 900, 60, 1, 0, 0, 0, { 0, 198, 792, 120, 0, 0,
          { 135.61803, 1065.6, 22863.249, 54.365929, 11369 } } },
        { BYTES, 1000, 40, 1, 0, 1, 0, { 0, 142, 568, 87, 0, 0,
          { 102.72837, 661.06667, 14908.459, 38.787444, 9417 } } },
        { BYTES, 1100, 40, 0, 0, 2, 0, { 0, 129, 516, 83, 0, 0,
          { 89.282755, 870, 13554.593, 33.865523, 7262 } } },
        { SP_FUZZ_RUBBLE, 100, 12, 1, 0, 0, 0, { 0, 239, 956, 0, 0, 0,
          { 72.264767, 6167.7333, 253907.11, 0, 0 } } },
        { SP_FUZZ_WALL, 100, 8, 1, 0, 0, 0, { 0, 225, 900, 0, 0, 0,
          { 257, 8527.3333, 1002538.7, 0, 0 } } },
        { SP_FUZZ_ARCH, 100, 8, 1, 0, 1, 0, { 0, 88, 352, 0, 0, 0,
          { 31.705597, 255.42694, 47551.311, 0, 0 } } },
        { SP_FUZZ_STACK, 100, 16, 1, 0, 2, 0, { 0, 75, 300, 0, 0, 0,
          { 37.907467, 609.26667, 23346.289, 0, 0 } } }
    };
    COMPARE(rows, touch_it);
}

TEST(drawn_buildings_take_the_work_written_here)
{
    static const drawn rows[] = {
        { SP_FUZZ_STACK, 0, 10, 1, 0, 0, 0.1, { 830, 68, 11, 0, 623359, 611104,
          { 3.1710046e-13, 0, 968873.61, 0, -82028570 } } },
        { SP_FUZZ_STACK, 16, 10, 1, 0, 1, 0.1, { 5500, 275, 85, 0, 2261500, 611296,
          { 50.228272, 25.05082, 573048.15, 66.014582, 1.094797e+08 } } },
        { SP_FUZZ_RUBBLE, 0, 4, 0, 0, 0, 0.1, { 650, 181, 124, 2, 5636489, 342768,
          { 2.6494519e-12, 0, 799521.86, 0, -64126427 } } },
        { SP_FUZZ_RUBBLE, 5, 4, 1, 0, 1, 0.3, { 1470, 441, 308, 5, 12464421, 380160,
          { 7.5914039, 3.7021077, 1823470.5, 29.821921, -2887362 } } },
        { SP_FUZZ_WALL, 0, 4, 0, 0, 1, 0.2, { 2000, 631, 474, 17, 18338401, 316384,
          { 8.7502927, 3.0911751, 6702092.9, 31.142319, 66905115 } } },
        { BYTES, 700, 30, 1, 0, 0, 0, { 7020, 590, 260, 21, 3398613, 901648,
          { 36.181387, 9.5375792, 5818389.1, 76.434584, -29276118 } } },
        { BYTES, 730, 30, 0, 0, 1, 0, { 10700, 716, 355, 26, 4215091, 821056,
          { 89.202976, 31.672041, 3608386.5, 125.56639, 1.1947538e+08 } } },
        { SP_FUZZ_ARCH, 0, 2, 1, 0, 1, 0.1, { 3300, 798, 563, 21, 10499385, 158944,
          { 32.629379, 13.674965, 2922176.1, 51.70398, 1.3848439e+08 } } }
    };
    COMPARE(rows, build_it);
}

TEST(drawn_sets_that_are_held_take_the_work_written_here)
{
    static const drawn rows[] = {
        { BYTES, 1400, 30, 1, 0, 0, 0.3, { 72, 574, 416, 38, 5127523, 0,
          { 323, 80, 83, 193, 27.585681 } } },
        { SP_FUZZ_STACK, 120, 10, 0, 0, 0, 0.6, { 18, 248, 195, 20, 2959839, 0,
          { 33, 5, 8, 47, 0.83046253 } } },
        { SP_FUZZ_RUBBLE, 120, 2, 0, 0, 5, 0.6, { 5, 198, 160, 30, 10145604, 0,
          { 48, 2, 4, 38, 0.80301492 } } },
        { SP_FUZZ_WALL, 120, 3, 0, 0, 0, 0.9, { 6, 136, 110, 8, 2782571, 0,
          { 26, 3, 3, 26, 1.0243933 } } },
        { SP_FUZZ_ARCH, 120, 1, 0, 0, 6, 0.1, { 3, 72, 50, 0, 670920, 0,
          { 52, 6, 6, 22, 2.806118 } } }
    };
    COMPARE(rows, hold_it);
}

TEST(checks_in_another_order_take_the_work_written_here)
{
    static const drawn rows[] = {
        { BYTES, 1500, 30, 2, 0, PLANNED, 0.1, { 32042640, 690, 627, 9, 7631484, 1758024,
          { 12.308646, 2.055743, 1717080.4, 40.675451, 267777.12 } } },
        { SP_FUZZ_RUBBLE, 140, 4, 2, 0, PLANNED, -0.2, { 4440040, 13, 9, 0, 343058, 744932,
          { 3.7336194e-14, 0, 83304.723, 0, -4 } } },
        { SP_FUZZ_ARCH, 140, 3, 2, 0, PLANNED, -0.2, { 3330030, 8, 5, 0, 119324, 427756,
          { 6.547023e-14, 0, 131111.38, 0, -3 } } },
        { SP_FUZZ_WALL, 140, 2, 2, 0, IN_8, -0.3, { 2220020, 8, 6, 0, 362347, 546576,
          { 9.2320785e-15, 0, 462609.34, 0, -2 } } },
        { SP_FUZZ_STACK, 140, 8, 2, 0, COUPLED, -0.1, { 10510170, 3695, 3653, 0, 90467029, 96675324,
          { 0.046918195, 0.0049249938, 196888.61, 0.0074104322, 4102.4782 } } },
        { WEDGED, 2400, 20, 2, 0, PLANNED, 0, { 22600470, 135, 115, 5, 2041023, 704276,
          { 1.5934849, 0.26435746, 21571.094, 2.7488509, 2533.996 } } },
        { BYTES, 1530, 4, 2, 0, COUPLED, 0, { 4700220, 150, 117, 0, 1260548, 47481904,
          { 2, 0.56169231, 143744.46, 0.019937707, 34118.081 } } },
        { SP_FUZZ_STACK, 150, 10, 2, 4, PLANNED, 0.1, { 8300100, 13, 3, 0, 232348, 897624,
          { 3.8953783e-14, 0, 223081.75, 0, -10 } } }
    };
    COMPARE(rows, check_it);
}

TEST(limits_in_another_order_take_the_work_written_here)
{
    static const drawn rows[] = {
        { BYTES, 1540, 10, 2, 0, PLANNED, 1, { 370, 98, 79, 70, 2975198, 538096,
          { 0.69454939, 3.6945495, -3, 1.2732232e-07, 0.004392073 } } },
        { SP_FUZZ_ARCH, 145, 2, 2, 0, PLANNED, -1, { 20, 22, 18, 16, 619024, 261160,
          { 0.64681489, 0.64681495, 0, 8.6366713e-08, 3.0024959e-09 } } },
        { SP_FUZZ_STACK, 145, 6, 2, 7, PLANNED, 1, { 60, 232, 208, 0, 9806708, 547988,
          { 9.9137475, 9.9137476, 0, 1.9942632e-07, 9.0000031e-09 } } }
    };
    COMPARE(rows, limit_it);
}

TEST(sliding_in_another_order_takes_the_work_written_here)
{
    static const drawn rows[] = {
        { SP_FUZZ_RUBBLE, 150, 1, 2, 0, 0, -1, { 10, 0, 0, 0, 3146524, 322936,
          { 0, 0, 1, 5573.0642, 0.80022393 } } },
        { SP_FUZZ_STACK, 155, 6, 2, 0, 0, -1, { 33, 0, 0, 0, 129922, 674944,
          { 2.5102271, 2.5102271, 14724.27, 15655.339, 1.6345261 } } }
    };
    COMPARE(rows, slide_it);
}

TEST(buildings_in_another_order_take_the_work_written_here)
{
    static const drawn rows[] = {
        { BYTES, 1550, 12, 2, 0, 0, 0.2, { 5110, 206, 120, 15, 1599523, 359280,
          { 33.636286, 12.994294, 886837.43, 51.315942, 26469649 } } },
        { SP_FUZZ_RUBBLE, 155, 2, 2, 0, 1, 0.1, { 2600, 802, 594, 116, 24725079, 167360,
          { 19.760778, 3.8100622, 405159.27, 36.776195, 1.1382193e+08 } } }
    };
    COMPARE(rows, build_it);
}

/* What memory held before: nothing, no numbers, small numbers. */
static void paint(int with)
{
    static const int byte[3] = { 0, 255, 0x3d };
    memset(test_arena.base, byte[with], test_arena.capacity < (1 << 21) ? test_arena.capacity : 1 << 21);
}

static int same(const sum *x, const sum *y)
{
    return x->kind == y->kind && x->bytes == y->bytes && x->cost.flops == y->cost.flops
        && x->cost.iterations == y->cost.iterations && !memcmp(x->found, y->found, sizeof x->found);
}

TEST(no_answer_depends_on_what_memory_held)
{
    static const struct { question *ask; drawn of; } rows[] = {
        { check_it, { BYTES, 1200, 4, 1, 0, PLANNED, 0, { 0 } } },
        { check_it, { BYTES, 1210, 3, 0, 7, IN_8, 0.2, { 0 } } },
        { check_it, { BYTES, 1220, 2, 1, 0, COUPLED, 0, { 0 } } },
        { check_it, { SP_FUZZ_STACK, 50, 2, 1, 0, SEEDED, 0.1, { 0 } } },
        { limit_it, { BYTES, 1230, 3, 1, 0, PLANNED, 1, { 0 } } },
        { limit_it, { BYTES, 1240, 3, 1, 7, PLANNED, 1, { 0 } } },
        { strong_of, { BYTES, 1250, 3, 0, 0, 0, 0, { 0 } } },
        { slide_it, { SP_FUZZ_RUBBLE, 10, 2, 1, 0, 0, -1, { 0 } } },    /* its history never settles: it has no motion */
        { build_it, { BYTES, 1260, 4, 1, 0, 0, 0, { 0 } } },
        { touch_it, { BYTES, 1270, 4, 1, 0, 0, 0, { 0 } } }
    };
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++)
        for (int i = 0; i < rows[k].of.count; i++) {
            sum t[3];
            memset(t, 0, sizeof t);
            for (int with = 0; with < 3; with++) {
                paint(with);
                const sp_scene s = drawn_scene(&rows[k].of, i);
                rows[k].ask(&rows[k].of, &s, &t[with]);
            }
            CHECK(same(&t[0], &t[1]) && same(&t[0], &t[2]));
        }
}
#endif

TEST_LIST(drawn)
#ifdef TALLY_ALL
#if COUNTED
    RUN(drawn_checks_take_the_work_written_here)
    RUN(drawn_checks_of_families_take_the_work_written_here)
    RUN(drawn_checks_with_strength_take_the_work_written_here)
    RUN(drawn_checks_by_stages_take_the_work_written_here)
    RUN(drawn_checks_by_programs_take_the_work_written_here)
    RUN(drawn_coupled_checks_take_the_work_written_here)
    RUN(drawn_coupled_checks_in_space_take_the_work_written_here)
    RUN(drawn_coupled_checks_in_a_plane_take_the_work_written_here)
    RUN(drawn_coupled_checks_of_other_lengths_take_the_work_written_here)
    RUN(drawn_coupled_checks_without_nodes_take_the_work_written_here)
    RUN(drawn_coupled_boxes_and_rounds_take_the_work_written_here)
    RUN(drawn_alternations_of_stacks_take_the_work_written_here)
    RUN(drawn_alternations_take_the_work_written_here)
    RUN(single_checks_take_the_work_written_here)
    RUN(single_checks_near_limits_take_the_work_written_here)
    RUN(single_limits_take_the_work_written_here)
    RUN(drawn_checks_of_wedged_stones_take_the_work_written_here)
    RUN(drawn_checks_near_limits_take_the_work_written_here)
    RUN(drawn_checks_near_limits_of_joints_with_strength_take_the_work_written_here)
    RUN(drawn_coupled_checks_of_wedged_stones_take_the_work_written_here)
    RUN(drawn_rounds_of_wedged_stones_take_the_work_written_here)
    RUN(drawn_alternations_of_wedged_stones_take_the_work_written_here)
    RUN(drawn_limits_take_the_work_written_here)
    RUN(drawn_limits_of_families_take_the_work_written_here)
    RUN(drawn_limits_of_joints_with_strength_take_the_work_written_here)
    RUN(drawn_strong_verdicts_take_the_work_written_here)
    RUN(drawn_sliding_limits_take_the_work_written_here)
    RUN(drawn_sliding_limits_with_more_histories_take_the_work_written_here)
    RUN(drawn_contacts_take_the_work_written_here)
    RUN(drawn_buildings_take_the_work_written_here)
    RUN(drawn_sets_that_are_held_take_the_work_written_here)
    RUN(checks_in_another_order_take_the_work_written_here)
    RUN(limits_in_another_order_take_the_work_written_here)
    RUN(sliding_in_another_order_takes_the_work_written_here)
    RUN(buildings_in_another_order_take_the_work_written_here)
#endif
    RUN(no_answer_depends_on_what_memory_held)
#endif
TEST_END
