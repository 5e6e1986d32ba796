/* The protocol: stones become bodies, fall, are tamped, and are read as poses, contacts and a few numbers.          [seed 5] */
#include "settle.h"
#include "body.h"
#include "pieces.h"
#include "touch.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define HISTORY 100                             /* [step] over which drift is told */
#define WALLS 5
#define PHASES 4                                 /* of the ramp, the last at full gravity                [seed 5] */

static const double pi = 3.14159265358979323846;

/* Friction of two stones, a <= b; `at`: place in the settings. */
typedef struct friction { int32_t a, b, at; double mu; } friction;

/* A part of the container. */
typedef struct wall { double xyz[24]; settle_mesh mesh; settle_stone stone; } wall;

/* Where a body was. */
typedef struct moment { double R[9], t[3]; } moment;

typedef struct simulation {
    const settle_settings *set;
    bullet *w;
    friction *pair;                             /* in order, each pair once */
    int32_t pairs;
    int32_t stones, bodies;                     /* bodies: the container's parts, too */
    const settle_stone **stone;                 /* of each body */
    settle_stone *own;                          /* settle_seat: stones all fixed but one */
    settle_pose *pose;                          /* of each body */
    double *radius, *mass;
    moment *history;                            /* of all bodies in the last steps, a ring */
    int32_t step, steps;
    wall wall[WALLS];
} simulation;

/* ----------------------------------------------------------------------------------------------------------- settings */

settle_settings settle_default(void)
{
    settle_settings s;
    memset(&s, 0, sizeof s);
    s.gravity[2] = -9.81;
    s.ramp[0] = 0.5, s.ramp[1] = 2, s.ramp[2] = 5;
    s.ramp_steps = 250;
    s.steps = 1500;
    s.tamps = 1;
    s.tamp = 3.5;
    s.tamp_steps = 200;
    s.rest_steps = 400;
    s.dt = 1.0 / 600;
    s.iterations = 80;
    s.friction = 0.85;
    s.container_friction = 0.9;
    s.mu = -1;
    s.damping = 0.4;
    s.margin = 0.0015;
    s.mass_floor = 1e-4;
    s.touch = 0.0005;
    s.wall = 0.05;
    s.lift = 0.06;
    s.lowest = -0.3;
    s.quiet = 100;
    s.moved = 0.02;
    s.turned = 8;
    s.reach = 0.35;
    return s;
}

settle_settings settle_confirm_default(void)
{
    settle_settings s = settle_default();
    s.ramp_steps = s.tamps = 0;
    s.steps = 700;
    s.friction = 0.7;
    s.lift = s.damping = 0;
    return s;
}

settle_settings settle_seat_default(void)
{
    settle_settings s = settle_default();
    s.ramp_steps = 60;
    s.steps = 160;
    s.iterations = 60;
    s.tamps = 0;
    s.friction = 0.8;
    s.lift = 0.003;
    return s;
}

static int within(double x, double low, double high) { return x >= low && x <= high; }

static settle_status check_pairs(const settle_settings *s, int32_t stones)
{
    if (s->pairs < 0 || (s->pairs > 0 && !s->pair)) return SETTLE_E_ARGUMENT;
    for (int32_t k = 0; k < s->pairs; k++) {
        if (!within(s->pair[k].a, -1, stones - 1) || !within(s->pair[k].b, -1, stones - 1)) return SETTLE_E_ARGUMENT;
        if (!pieces_finite(&s->pair[k].mu, 1) || s->pair[k].mu < 0) return SETTLE_E_SETTINGS;
    }
    return SETTLE_OK;
}

static settle_status check_settings(const settle_settings *s, int32_t stones)
{
    const double number[] = { s->tamp, s->friction, s->container_friction, s->mu, s->restitution, s->damping, s->margin, s->touch,
                              s->mass_floor, s->wall, s->lift, s->lowest, s->energy, s->moved, s->turned, s->reach, s->dt };
    if (!pieces_finite(number, sizeof number / sizeof *number) || !pieces_finite(s->gravity, 3) || !pieces_finite(s->ramp, 3)
        || !pieces_finite(s->container, 3) || !pieces_finite(s->floor, 3)) return SETTLE_E_NUMBER;
    for (int k = 0; k < 3; k++)
        if (s->ramp[k] < 0 || s->container[k] < 0 || (s->container[k] > 0) != (s->container[0] > 0)) return SETTLE_E_SETTINGS;
    if (!within(s->ramp_steps, 0, 1e6) || !within(s->steps, 0, 1e7) || !within(s->tamps, 0, 1000) || !within(s->tamp_steps, 0, 1e5)
        || !within(s->rest_steps, 0, 1e5) || !within(s->iterations, 1, 10000) || s->quiet < 1) return SETTLE_E_SETTINGS;
    if (!within(s->dt, 1e-6, 0.1) || !within(s->tamp, 0, 100) || s->friction < 0 || s->container_friction < 0
        || !within(s->restitution, 0, 1) || !within(s->damping, 0, 1) || !(s->margin > 0) || s->touch < 0 || !(s->mass_floor > 0)
        || !(s->wall > 0) || s->lift < 0 || s->energy < 0 || s->moved < 0 || s->turned < 0 || s->reach < 0) return SETTLE_E_SETTINGS;
    return check_pairs(s, stones);
}

/* ----------------------------------------------------------------------------------------------------------- friction */

static int by_stones(const void *pa, const void *pb)
{
    const friction *a = pa, *b = pb;
    return a->a != b->a ? (a->a > b->a) - (a->a < b->a) : (a->b > b->b) - (a->b < b->b);
}

static int by_stones_then_place(const void *pa, const void *pb)
{
    const friction *a = pa, *b = pb;
    const int order = by_stones(a, b);
    return order ? order : (a->at > b->at) - (a->at < b->at);
}

/* Of the same two stones the last counts.                                                   returns 0: out of memory */
static int order_pairs(simulation *sim)
{
    const settle_settings *s = sim->set;
    friction *p = malloc(((size_t)s->pairs + 1) * sizeof *p);
    if (!p) return 0;
    for (int32_t k = 0; k < s->pairs; k++) {
        const settle_pair *q = &s->pair[k];
        const friction f = { q->a < q->b ? q->a : q->b, q->a < q->b ? q->b : q->a, k, q->mu };
        p[k] = f;
    }
    qsort(p, (size_t)s->pairs, sizeof *p, by_stones_then_place);
    for (int32_t k = 0; k < s->pairs; k++)
        if (k + 1 == s->pairs || by_stones(&p[k], &p[k + 1])) p[sim->pairs++] = p[k];
    sim->pair = p;
    return 1;
}

/* Friction of a contact. */
static double friction_of(const void *user, int32_t a, int32_t b)
{
    const simulation *sim = user;
    const settle_settings *s = sim->set;
    const friction key = { a < b ? a : b, a < b ? b : a, 0, 0 };
    const friction *own = bsearch(&key, sim->pair, (size_t)sim->pairs, sizeof key, by_stones);
    if (own) return own->mu;
    if (s->mu >= 0) return s->mu;
    return (a < 0 ? s->container_friction : s->friction) * (b < 0 ? s->container_friction : s->friction);
}

/* -------------------------------------------------------------------------------------------------------------- bodies */

static settle_status add(simulation *sim, const settle_stone *stone, int32_t id)
{
    bullet_body body;
    const int32_t k = sim->bodies;
    settle_status status = body_make(stone, id, sim->set, &body, &sim->radius[k]);
    if (!status && !bullet_add(sim->w, &body)) status = SETTLE_E_MEMORY;
    if (!status) {
        sim->stone[k] = stone;
        sim->mass[k] = body.mass;
        memcpy(sim->pose[k].c, body.centroid, sizeof body.centroid);
        sim->bodies++;
    }
    body_free(&body);
    return status;
}

/* Floor and walls are stones, too: fixed, of number -1. */
static settle_status add_container(simulation *sim)
{
    static const int32_t size[6] = { 4, 4, 4, 4, 4, 4 };
    static const int32_t corner[24] = { 0, 2, 3, 1,  4, 5, 7, 6,  0, 1, 5, 4,  2, 6, 7, 3,  0, 4, 6, 2,  1, 3, 7, 5 };
    const settle_settings *s = sim->set;
    const double x = s->container[0] / 2, y = s->container[1] / 2, z = s->container[2], t = 2 * s->wall;
    const double box[WALLS][6] = { { -x - t, -y - t, -t, x + t, y + t, 0 }, { -x - t, -y - t, 0, -x, y + t, z },
                                   { x, -y - t, 0, x + t, y + t, z }, { -x, -y - t, 0, x, -y, z }, { -x, y, 0, x, y + t, z } };
    settle_status status = SETTLE_OK;
    if (!(s->container[0] > 0)) return SETTLE_OK;
    for (int k = 0; k < WALLS && !status; k++) {
        wall *w = &sim->wall[k];
        const settle_mesh mesh = { 8, 6, w->xyz, size, corner };
        const settle_stone stone = { 1, &w->mesh, 1, 1 };
        for (int v = 0; v < 8; v++)
            for (int c = 0; c < 3; c++) w->xyz[3 * v + c] = s->floor[c] + box[k][v >> c & 1 ? 3 + c : c];
        w->mesh = mesh;
        w->stone = stone;
        status = add(sim, &w->stone, -1);
    }
    return status;
}

static settle_status start(simulation *sim, int32_t stones, const settle_settings *set)
{
    const size_t n = (size_t)stones + WALLS;
    memset(sim, 0, sizeof *sim);
    sim->set = set;
    sim->stones = stones;
    sim->steps = PHASES * set->ramp_steps + set->steps + set->tamps * (set->tamp_steps + set->rest_steps);
    sim->stone = calloc(n, sizeof *sim->stone);
    sim->own = calloc(n, sizeof *sim->own);
    sim->pose = calloc(n, sizeof *sim->pose);
    sim->radius = calloc(n, sizeof *sim->radius);
    sim->mass = calloc(n, sizeof *sim->mass);
    sim->history = calloc(n, HISTORY * sizeof *sim->history);
    sim->w = bullet_open(set->iterations, friction_of, sim);
    return sim->stone && sim->own && sim->pose && sim->radius && sim->mass && sim->history && sim->w && order_pairs(sim)
         ? SETTLE_OK : SETTLE_E_MEMORY;
}

static void end(simulation *sim)
{
    if (sim->w) bullet_close(sim->w);
    free(sim->stone);
    free(sim->own);
    free(sim->pose);
    free(sim->radius);
    free(sim->mass);
    free(sim->history);
    free(sim->pair);
}

/* --------------------------------------------------------------------------------------------------------------- steps */

static double energy(const simulation *sim)
{
    double sum = 0;
    for (int32_t k = 0; k < sim->bodies; k++)
        if (!sim->stone[k]->fixed) sum += bullet_energy(sim->w, k);
    return sum;
}

/* Angle of a rotation [degree]: sin from the antisymmetric part, cos from the trace. */
static double angle_of(const double R[9])
{
    const double x = R[7] - R[5], y = R[2] - R[6], z = R[3] - R[1];
    return atan2(0.5 * sqrt(x * x + y * y + z * z), 0.5 * (R[0] + R[4] + R[8] - 1)) * 180 / pi;
}

/* Against gravity; along z where there is none. */
static double height(const double g[3], const double t[3])
{
    const double full = sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
    return full > 0 ? -(g[0] / full * t[0] + g[1] / full * t[1] + g[2] / full * t[2]) : t[2];
}

static void read_poses(simulation *sim)
{
    static const double one[9] = { 1, 0, 0, 0, 1, 0, 0, 0, 1 };
    for (int32_t k = 0; k < sim->bodies; k++) {
        settle_pose *p = &sim->pose[k];
        const int fixed = sim->stone[k]->fixed;
        double moved = 0;
        bullet_where(sim->w, k, p->R, p->t);
        if (fixed) {
            memcpy(p->R, one, sizeof one);
            memcpy(p->t, p->c, sizeof p->c);
        }
        for (int c = 0; c < 3; c++) moved += (p->t[c] - p->c[c]) * (p->t[c] - p->c[c]);
        p->moved = sqrt(moved);
        p->turned = fixed ? 0 : angle_of(p->R);
        p->settled = fixed || height(sim->set->gravity, p->t) > sim->set->lowest;
    }
}

static settle_status make_step(simulation *sim, double *e)
{
    moment *now = sim->history + (size_t)(sim->step % HISTORY) * (size_t)sim->bodies;
    if (!bullet_step(sim->w, sim->set->dt)) return SETTLE_E_MEMORY;
    for (int32_t k = 0; k < sim->bodies; k++) bullet_where(sim->w, k, now[k].R, now[k].t);
    sim->step++;
    *e = energy(sim);
    if (!(*e < 1e100)) return SETTLE_E_DIVERGED;
    if (!sim->set->watch) return SETTLE_OK;
    read_poses(sim);
    return sim->set->watch(sim->set->user, sim->step, sim->steps, *e, sim->pose) ? SETTLE_E_STOPPED : SETTLE_OK;
}

/* n steps at gravity times `pull`, fewer once all is quiet if that may end it. */
static settle_status make_steps(simulation *sim, int32_t n, double pull, int may_end)
{
    const settle_settings *s = sim->set;
    double mass = 0, g[3], e;
    int32_t quiet = 0;
    for (int c = 0; c < 3; c++) g[c] = s->gravity[c] * pull;
    for (int32_t k = 0; k < sim->bodies; k++) mass += sim->stone[k]->fixed ? 0 : sim->mass[k];
    bullet_gravity(sim->w, g);
    for (int32_t i = 0; i < n; i++) {
        const settle_status status = make_step(sim, &e);
        if (status) return status;
        quiet = e < s->energy * mass ? quiet + 1 : 0;
        if (may_end && s->energy > 0 && quiet >= s->quiet) break;
    }
    return SETTLE_OK;
}

/* Ramp, settle, tamp.                                                                                       [seed 5] */
static settle_status protocol(simulation *sim)
{
    const settle_settings *s = sim->set;
    const double *g = s->gravity, full = sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
    settle_status status = SETTLE_OK;
    read_poses(sim);
    if (s->watch && s->watch(s->user, 0, sim->steps, 0, sim->pose)) return SETTLE_E_STOPPED;
    for (int k = 0; k < PHASES && !status; k++)
        status = make_steps(sim, s->ramp_steps, k < PHASES - 1 && full > 0 ? fmin(s->ramp[k] / full, 1) : 1, 0);
    if (!status) status = make_steps(sim, s->steps, 1, 1);
    for (int32_t k = 0; k < s->tamps && !status; k++) {
        status = make_steps(sim, s->tamp_steps, s->tamp, 0);
        if (!status) status = make_steps(sim, s->rest_steps, 1, 1);
    }
    read_poses(sim);
    return status;
}

/* ------------------------------------------------------------------------------------------------------------- results */

/* How far the surface went since the oldest pose kept: |dc| + |2 sin(angle/2)| radius is a bound. */
static double drift(const simulation *sim)
{
    double most = 0;
    const moment *then = sim->history + (size_t)(sim->step < HISTORY ? 0 : sim->step % HISTORY) * (size_t)sim->bodies;
    const moment *now = sim->history + (size_t)((sim->step + HISTORY - 1) % HISTORY) * (size_t)sim->bodies;
    for (int32_t k = 0; k < sim->bodies && sim->step > 0; k++) {
        double R[9], gone = 0;
        for (int i = 0; i < 9; i++) {
            const double *a = now[k].R + i / 3 * 3, *b = then[k].R + i % 3 * 3;
            R[i] = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        }
        for (int c = 0; c < 3; c++) gone += (now[k].t[c] - then[k].t[c]) * (now[k].t[c] - then[k].t[c]);
        if (!sim->stone[k]->fixed) most = fmax(most, sqrt(gone) + 2 * sin(angle_of(R) * pi / 360) * sim->radius[k]);
    }
    return most;
}

/* Poses and contacts, malloc's.                                                             returns 0: out of memory */
static int hand_over(simulation *sim, settle_result *r)
{
    const touch_place at = { sim->stones, sim->bodies, sim->stone, sim->pose };
    bullet_touch *touch = NULL;
    int32_t touches = 0;
    int good = bullet_touches(sim->w, &touch, &touches);
    r->pose = malloc((size_t)sim->stones * sizeof *r->pose);
    r->contact = good ? malloc(((size_t)touches + 1) * sizeof *r->contact) : NULL;
    good = good && r->pose && r->contact && touch_contacts(&at, touch, touches, sim->set->touch, r->contact, &r->contacts);
    if (good) memcpy(r->pose, sim->pose, (size_t)sim->stones * sizeof *r->pose);
    else settle_result_free(r);
    free(touch);
    return good;
}

static settle_status finish(simulation *sim, settle_result *out)
{
    settle_result r;
    memset(&r, 0, sizeof r);
    if (!hand_over(sim, &r)) return SETTLE_E_MEMORY;
    r.stones = sim->stones;
    r.held = 1;
    for (int32_t k = 0; k < sim->stones; k++) {
        const settle_pose *p = &r.pose[k];
        r.settled += p->settled;
        r.moved = fmax(r.moved, p->moved);
        r.turned = fmax(r.turned, p->turned);
        if (!(p->moved <= sim->set->moved && p->turned <= sim->set->turned)) r.held = 0;
    }
    r.steps = sim->step;
    r.energy = energy(sim);
    r.drift = drift(sim);
    for (int32_t k = 0; k < r.contacts; k++) r.penetration = fmax(r.penetration, r.contact[k].depth);
    *out = r;
    return SETTLE_OK;
}

void settle_result_free(settle_result *result)
{
    if (!result) return;
    free(result->pose);
    free(result->contact);
    result->pose = NULL;
    result->contact = NULL;
}

/* --------------------------------------------------------------------------------------------------------------- calls */

/* Gap between the boxes around two stones: no more than the distance of the stones. */
static double box_gap(const settle_stone *a, const settle_stone *b)
{
    double gap = 0;
    for (int c = 0; c < 3; c++) {
        double low[2] = { HUGE_VAL, HUGE_VAL }, high[2] = { -HUGE_VAL, -HUGE_VAL }, d;
        for (int i = 0; i < 2; i++) {
            const settle_stone *s = i ? b : a;
            for (int32_t p = 0; p < s->pieces; p++)
                for (int32_t k = 0; k < s->piece[p].vertices; k++) {
                    low[i] = fmin(low[i], s->piece[p].xyz[3 * k + c]);
                    high[i] = fmax(high[i], s->piece[p].xyz[3 * k + c]);
                }
        }
        d = fmax(fmax(low[0] - high[1], low[1] - high[0]), 0);
        gap += d * d;
    }
    return sqrt(gap);
}

/* Of `only` >= 0 all others are fixed, and those beyond its reach left out. */
static settle_status run(simulation *sim, const settle_stone *stone, int32_t only, settle_result *result)
{
    const int32_t n = sim->stones;
    settle_status status = SETTLE_OK;
    for (int32_t k = 0; k < n && !status; k++) {
        sim->own[k] = stone[k];
        if (only >= 0) sim->own[k].fixed = k != only;
        status = add(sim, &sim->own[k], k);
    }
    for (int32_t k = 0; k < n && !status && only >= 0; k++)
        if (k != only && box_gap(&stone[k], &stone[only]) > sim->set->reach) bullet_leave_out(sim->w, k);
    if (!status) status = add_container(sim);
    if (!status) status = protocol(sim);
    return status ? status : finish(sim, result);
}

static settle_status settle(int32_t stones, const settle_stone *stone, int32_t only, const settle_settings *settings, settle_result *result)
{
    simulation sim;
    settle_status status;
    if (stones < 1 || stones > SETTLE_STONES || !stone || !settings || !result) return SETTLE_E_ARGUMENT;
    status = check_settings(settings, stones);
    if (status) return status;
    status = start(&sim, stones, settings);
    if (!status) status = run(&sim, stone, only, result);
    end(&sim);
    return status;
}

settle_status settle_run(int32_t stones, const settle_stone *stone, const settle_settings *settings, settle_result *result)
{
    return settle(stones, stone, -1, settings, result);
}

settle_status settle_seat(int32_t stones, const settle_stone *stone, int32_t which, const settle_settings *settings,
                          settle_result *result)
{
    return which < 0 || which >= stones ? SETTLE_E_ARGUMENT : settle(stones, stone, which, settings, result);
}
