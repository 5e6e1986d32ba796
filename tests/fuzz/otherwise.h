/* otherwise: a scene written again: in another order, turned and moved, in other units, or with more or less of something. */
#ifndef OTHERWISE_H
#define OTHERWISE_H

#include "ask.h"

enum { JOINTS = 40 };

/* x' = length Q x + shift; masses times `mass`, accelerations times `pull`. Blocks, joints and loads in these orders; joints
 * marked in `swap` are given from their other side. Friction becomes mu times + plus, but of joints with tension, for which
 * more friction is not more strength. held, freed: a block; without: a joint; -1: none. */
typedef struct writing {
    int32_t block[SP_FUZZ_BLOCKS], joint[JOINTS], load[SP_FUZZ_LOADS];
    int partly;                                         /* some block is held in some directions: quarter turns alone */
    uint64_t swap;
    double q[3][3], shift[3], length, mass, pull, times, plus;
    int32_t held, freed, without;
    const uint8_t *contact;                             /* eleven bytes of one more contact, NULL: none */
    sp_presence there[SP_FUZZ_BLOCKS];
    int32_t place[SP_FUZZ_BLOCKS], name[JOINTS];        /* out: new number of each block, of each joint; -1: none */
} writing;

static writing as_it_is(const sp_scene *s)
{
    writing w;
    memset(&w, 0, sizeof w);
    for (int32_t k = 0; k < s->count.blocks; k++) w.block[k] = k;
    for (int32_t k = 0; k < s->count.joints; k++) w.joint[k] = k;
    for (int32_t k = 0; k < s->count.loads; k++) w.load[k] = k;
    for (int32_t k = 0; k < s->count.blocks; k++) w.there[k] = SP_PRESENT;
    for (int k = 0; k < 3; k++) w.q[k][k] = 1;
    w.length = w.mass = w.pull = w.times = 1;
    w.held = w.freed = w.without = -1;
    return w;
}

static void shuffle(int32_t *p, int32_t n)              /* [Fisher, Yates] */
{
    for (int32_t i = n - 1; i > 0; i--) {
        const int32_t j = (int32_t)draw((uint32_t)i + 1), t = p[i];
        p[i] = p[j];
        p[j] = t;
    }
}

static writing in_order(const sp_scene *s)
{
    writing w = as_it_is(s);
    shuffle(w.block, s->count.blocks);
    shuffle(w.joint, s->count.joints);
    shuffle(w.load, s->count.loads);
    w.swap = (uint64_t)draw(1u << 20) << 20 | draw(1u << 20);
    return w;
}

/* About a drawn axis by a drawn angle, from a unit quaternion. */
static void any_turn(double q[3][3])
{
    double w[4], size = 0;
    for (int k = 0; k < 4; k++) w[k] = draw_real(-1, 1), size += w[k] * w[k];
    if (size < 0.01) { w[0] = 1; w[1] = w[2] = w[3] = 0; size = 1; }
    const double a = w[0], v[3] = { w[1], w[2], w[3] };
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            const int k = 3 - i - j;
            const double across = i == j ? 0 : (j == (i + 1) % 3 ? -a * v[k] : a * v[k]);
            q[i][j] = (i == j) * (2 * a * a / size - 1) + 2 * (v[i] * v[j] + across) / size;
        }
}

/* One of the 24 turns of a cube, which leave held directions directions. */
static void quarter_turn(double q[3][3])
{
    const uint32_t first = draw(3), back = draw(2);
    const double sign[2] = { draw(2) ? 1 : -1, draw(2) ? 1 : -1 };
    memset(q, 0, 9 * sizeof(double));
    for (uint32_t k = 0; k < 3; k++)
        q[k][(first + (back ? 2 * k : k)) % 3] = k < 2 ? sign[k] : (back ? -1 : 1) * sign[0] * sign[1];
}

static writing turned(const sp_scene *s)
{
    writing w = as_it_is(s);
    for (int32_t b = 0; b < s->count.blocks; b++) {
        const uint32_t force = s->block[b].fixed & 7, moment = s->block[b].fixed >> 3;
        if ((force && force != 7) || (moment && moment != 7)) w.partly = 1;
    }
    if (w.partly) quarter_turn(w.q);
    else any_turn(w.q);
    for (int k = 0; k < 3; k++) w.shift[k] = draw_real(-5, 5);
    return w;
}

/* Feet, inches, millimetres, furlongs, any; pounds, slugs, grams, any; other seconds. */
static writing in_units(const sp_scene *s)
{
    const double length[5] = { 1 / 0.3048, 1 / 0.0254, 1000, 1 / 201.168, draw_real(0.3, 3) };
    const double mass[5] = { 2.2046226218, 1 / 14.593903, 1000, 1, draw_real(0.3, 3) };
    writing w = as_it_is(s);
    w.length = length[draw(5)];
    w.mass = mass[draw(5)];
    w.pull = w.length * (draw(2) ? 1 : draw_real(0.3, 3));
    return w;
}

static void moved(const writing *w, const sp_real x[3], double size, int place, sp_real y[3])
{
    for (int i = 0; i < 3; i++) {
        double sum = 0;
        for (int j = 0; j < 3; j++) sum += w->q[i][j] * (double)x[j];
        y[i] = (sp_real)(size * sum + (place ? w->shift[i] : 0));
    }
}

static uint32_t held_turned(const writing *w, uint32_t fixed)
{
    uint32_t out = 0;
    if (!w->partly) return fixed;                       /* all forces or none, all moments or none */
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) if (fabs(w->q[i][j]) > 0.5) out |= (fixed >> j & 9u) << i;
    return out;
}

/* One to three points with friction between any two blocks, about the middle between them, as eleven bytes say.
 *     returns 0: refused */
static int one_more_contact(sp_scene *s, const uint8_t byte[11])
{
    const int32_t n = s->count.blocks, a = byte[0] % n, b = (a + 1 + byte[1] % (n - 1)) % n, points = 1 + byte[2] % 3;
    const sp_strength strength = sp_strength_friction((sp_real)(byte[3] / 64.0));
    sp_real normal[3], x[9];
    for (int c = 0; c < 3; c++) normal[c] = (sp_real)((byte[4 + c] % 16 - 8) + (c == 2 ? 0.5 : 0));     /* never 0 */
    for (int k = 0; k < 9; k++) {
        const sp_real middle = (s->block[a].centroid[k % 3] + s->block[b].centroid[k % 3]) / 2;
        x[k] = middle + (sp_real)((byte[7 + (k + k / 3) % 4] - 128) / 64.0);
    }
    return !sp_scene_points(s, a, b, normal, points, x, &strength, NULL);
}

/* Blocks by mass and centroid. */
static int blocks_written(const sp_scene *in, writing *w, sp_scene *out)
{
    for (int32_t b = 0; b < in->count.blocks; b++) w->place[b] = -1;
    for (int32_t k = 0; k < in->count.blocks; k++) {
        const int32_t b = w->block[k];
        const sp_block *o = &in->block[b];
        const int held = b == w->held || w->there[b] == SP_HELD;
        const uint32_t fixed = held ? SP_FIXED : b == w->freed ? 0 : held_turned(w, o->fixed);
        sp_real y[3];
        if (w->there[b] == SP_ABSENT) continue;
        moved(w, o->centroid, w->length, 1, y);
        if (sp_scene_body(out, (sp_real)((double)o->mass * w->mass), y, fixed, &w->place[b])) return 0;
    }
    return 1;
}

/* Joints by their corners. */
static int joints_written(const sp_scene *in, writing *w, sp_scene *out)
{
    const double pressure = w->mass * w->pull / (w->length * w->length);
    for (int32_t q = 0; q < in->count.joints; q++) w->name[q] = -1;
    for (int32_t k = 0; k < in->count.joints; k++) {
        const int32_t q = w->joint[k];
        const sp_joint *j = &in->joint[q];
        const int back = (int)(w->swap >> q & 1);
        const int32_t a = w->place[back ? j->b : j->a], b = w->place[back ? j->a : j->b];
        sp_strength strength = j->strength;
        sp_real y[3 * VERTICES];
        if (a < 0 || b < 0 || q == w->without) continue;
        if (!(strength.tension > 0)) strength.mu = (sp_real)((double)strength.mu * w->times + w->plus);
        strength.cohesion = (sp_real)((double)strength.cohesion * pressure);
        strength.tension = (sp_real)((double)strength.tension * pressure);
        strength.crushing = (sp_real)((double)strength.crushing * pressure);
        for (int32_t v = 0; v < j->points; v++)
            moved(w, in->point[j->point + (back ? j->points - 1 - v : v)], w->length, 1, y + 3 * v);
        if (sp_scene_joint(out, a, b, j->points, y, &strength, &w->name[q])) return 0;
    }
    return 1;
}

static int loads_written(const sp_scene *in, const writing *w, sp_scene *out)
{
    const double force = w->mass * w->pull;
    for (int32_t k = 0; k < in->count.loads; k++) {
        const sp_load *from = &in->load[w->load[k]];
        sp_load load = *from;
        load.block = w->place[from->block];
        load.mass = (sp_real)((double)from->mass * w->mass);
        moved(w, from->force, force, 0, load.force);
        moved(w, from->couple, force * w->length, 0, load.couple);
        moved(w, from->point, w->length, 1, load.point);
        if (load.block >= 0 && sp_scene_load(out, &load, NULL)) return 0;
    }
    return 1;
}

/* Into arena k.     returns 0: refused */
static int written(const sp_scene *in, writing *w, int k, sp_scene *out)
{
    sp_arena a = arena(k);
    const sp_capacity cap = { in->count.blocks, 0, 0, 0, in->count.joints + 1, in->count.points + 3, in->count.loads };
    if (sp_scene_create(out, &cap, &a)) return 0;
    HOLDS(a.used == sp_scene_memory(&cap), "a scene takes %zu bytes", a.used);
    moved(w, in->gravity, w->pull, 0, out->gravity);
    moved(w, in->body, w->pull, 0, out->body);
    out->live = in->live;
    return blocks_written(in, w, out) && joints_written(in, w, out) && loads_written(in, w, out)
        && (!w->contact || one_more_contact(out, w->contact));
}

/* ---------------------------------------------------------------------------------------------------------- invariants */

/* Written otherwise and checked.     returns 0: the scene is refused so */
static int ask_other(const sp_scene *s, writing *w, sp_result *r)
{
    sp_scene other;
    if (!written(s, w, OTHER, &other)) { refused++; return 0; }
    check_other(&other, r);
    return r->f != NULL;
}

static void ask_same(const sp_scene *s, const sp_result *r, writing w, question q)
{
    sp_result other;
    if (!ask_other(s, &w, &other)) return;
    asked(q);
    same(r, &other, question_name[q]);
}

/* More of something: what stands may not fall. Less of it, `w`: what falls may not stand. */
static void ask_more(const sp_scene *s, const sp_result *r, writing w, question q)
{
    sp_result other;
    if (!r->verdict || !ask_other(s, &w, &other)) return;
    asked(q);
    not_opposite(r, &other, question_name[q]);
}

/* What stands with more friction, from 0, too; what falls with less, or none. */
static void other_friction(const sp_scene *s, const sp_result *r)
{
    writing w = as_it_is(s);
    if (r->verdict == SP_STABLE) {
        w.times = 1 + draw(256) / 64.0;
        w.plus = draw(2) ? draw(256) / 64.0 : 0;
    } else w.times = draw(4) ? draw(64) / 64.0 : 0;
    ask_more(s, r, w, FRICTION);
}

/* What stands with one more held, what falls with a held one let go. */
static void other_held(const sp_scene *s, const sp_result *r)
{
    writing w = as_it_is(s);
    const int32_t n = s->count.blocks, from = (int32_t)draw((uint32_t)n);
    for (int32_t k = 0; k < n; k++) {
        const int32_t b = (from + k) % n;
        const uint32_t fixed = s->block[b].fixed;
        if (r->verdict == SP_STABLE && fixed != SP_FIXED) w.held = b;
        if (r->verdict == SP_UNSTABLE && fixed) w.freed = b;
        if (w.held >= 0 || w.freed >= 0) break;
    }
    if (w.held >= 0 || w.freed >= 0) ask_more(s, r, w, HELD);
}

/* What stands with one more contact of drawn bytes, what falls without one of its joints. */
static void other_contact(const sp_scene *s, const sp_result *r)
{
    uint8_t byte[11];
    writing w = as_it_is(s);
    for (size_t k = 0; k < sizeof byte; k++) byte[k] = (uint8_t)draw(256);
    if (r->verdict == SP_STABLE) w.contact = byte;
    else if (s->count.joints) w.without = (int32_t)draw((uint32_t)s->count.joints);
    if (w.contact || w.without >= 0) ask_more(s, r, w, CONTACT);
}

/* The same scene with nothing left out. */
static void with_all_effects(const sp_scene *s, const sp_result *r)
{
    sp_result other;
    sp_settings set = sp_settings_default();
    for (int k = 0; k < SP_EFFECTS_FORCED; k++) set.effect[k] = SP_WITH;
    if (!check_in(s, &set, CHECK_OTHER, ROOM, &other)) return;
    asked(FULL);
    HOLDS(!opposite(r->verdict, other.verdict), "with all effects: %d instead of %d", (int)other.verdict, (int)r->verdict);
    same(r, &other, question_name[FULL]);
}

static void invariant(question q, const sp_scene *s, const sp_result *r)
{
    draws_anew(q);
    if (draw(3) && some) return;
    switch (q) {
    case IN_ORDER: ask_same(s, r, in_order(s), q); return;
    case TURNED: ask_same(s, r, turned(s), q); return;
    case IN_UNITS: ask_same(s, r, in_units(s), q); return;
    case FULL: with_all_effects(s, r); return;
    case FRICTION: other_friction(s, r); return;
    case HELD: other_held(s, r); return;
    default: other_contact(s, r); return;
    }
}

static void invariants(const sp_scene *s, const sp_result *r)
{
    for (int q = 0; q < INVARIANTS; q++) invariant((question)q, s, r);
}

#endif
