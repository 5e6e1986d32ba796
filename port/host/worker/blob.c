/* Messages of the worker. Every record is listed once: one function both writes and reads it, so the two can't disagree. */
#include "blob.h"

#include <stdlib.h>
#include <string.h>

#define MAGIC 0x4b505453u
#define VERSION 2
#define FLAGS (sizeof(sp_real) == 4 ? 1u : 0u)
#define REAL sizeof(sp_real)

#ifdef SP_REAL_FLOAT
typedef uint32_t real_bits;
#else
typedef uint64_t real_bits;
#endif

/* ------------------------------------------------------------------------------------------------------------- messages */

int blob_grow(blob *b, size_t more)
{
    const size_t most = (size_t)BLOB_CAP + BLOB_HEADER + 4;
    size_t room = b->room ? b->room : 4096;
    unsigned char *data;
    if (b->failed || more > most - b->length) return !(b->failed = 1);
    while (room < b->length + more) room = room > most / 2 ? most : 2 * room;
    if (room == b->room) return 1;
    data = realloc(b->data, room);
    if (!data) return !(b->failed = 1);
    b->data = data;
    b->room = room;
    return 1;
}

void blob_free(blob *b)
{
    const blob none = { NULL, 0, 0, 0 };
    free(b->data);
    *b = none;
}

/* n bytes of a number, the lowest first. */
static void put_bytes(unsigned char *p, uint64_t x, int n)
{
    for (int k = 0; k < n; k++) p[k] = (unsigned char)(x >> 8 * k & 255);
}

static uint64_t get_bytes(const unsigned char *p, int n)
{
    uint64_t x = 0;
    for (int k = n; k-- > 0;) x = x << 8 | p[k];
    return x;
}

/* Reflected 0x04c11db7, four bits at a time.                                                                [IEEE 802.3] */
static uint32_t crc32_of(const unsigned char *p, size_t n)
{
    static const uint32_t table[16] = { 0x00000000, 0x1db71064, 0x3b6e20c8, 0x26d930ac, 0x76dc4190, 0x6b6b51f4, 0x4db26158,
        0x5005713c, 0xedb88320, 0xf00f9344, 0xd6d6a3e8, 0xcb61b38c, 0x9b64c2b0, 0x86d3d2d4, 0xa00ae278, 0xbdbdf21c };
    uint32_t c = 0xffffffffu;
    for (size_t k = 0; k < n; k++) {
        c ^= p[k];
        c = c >> 4 ^ table[c & 15];
        c = c >> 4 ^ table[c & 15];
    }
    return ~c;
}

sp_status blob_header(const unsigned char header[BLOB_HEADER], blob_kind *kind, size_t *length)
{
    const uint64_t k = get_bytes(header + 6, 2), body = get_bytes(header + 12, 4);
    if (get_bytes(header, 4) != MAGIC || k < BLOB_REQUEST || k > BLOB_ERROR) return SP_E_ARGUMENT;
    if (get_bytes(header + 4, 2) != VERSION || get_bytes(header + 8, 4) != FLAGS) return SP_E_UNSUPPORTED;
    if (body > BLOB_CAP) return SP_E_CAPACITY;
    *kind = (blob_kind)k;
    *length = BLOB_HEADER + (size_t)body + 4;
    return SP_OK;
}

sp_status blob_whole(const blob *b, blob_kind kind)
{
    blob_kind got;
    size_t length;
    sp_status status;
    if (b->length < BLOB_HEADER + 4) return SP_E_ARGUMENT;
    status = blob_header(b->data, &got, &length);
    if (status) return status;
    if (got != kind || length != b->length) return SP_E_ARGUMENT;
    return get_bytes(b->data + length - 4, 4) == crc32_of(b->data, length - 4) ? SP_OK : SP_E_ARGUMENT;
}

/* --------------------------------------------------------------------------------------------- fields, in either direction */

/* Where the next field goes or comes from. */
typedef struct io {
    blob *out;                  /* NULL: reading */
    const unsigned char *p;     /* what is left to read */
    size_t left;
    int bad;                    /* read past the end, or a value out of range */
} io;

static uint64_t io_bits(io *s, uint64_t x, int n)
{
    if (s->out) {
        if (!blob_grow(s->out, (size_t)n)) return 0;
        put_bytes(s->out->data + s->out->length, x, n);
        s->out->length += (size_t)n;
        return x;
    }
    if (s->left < (size_t)n) {
        s->bad = 1;
        return 0;
    }
    x = get_bytes(s->p, n);
    s->p += n;
    s->left -= (size_t)n;
    return x;
}

/* A whole number in low..high. */
static void io_int(io *s, int32_t *x, int32_t low, int32_t high)
{
    const uint32_t bits = (uint32_t)io_bits(s, (uint32_t)*x, 4);
    memcpy(x, &bits, sizeof bits);
    if (!s->out && (s->bad || *x < low || *x > high)) {
        s->bad = 1;
        *x = low;
    }
}

static void io_long(io *s, int64_t *x)
{
    const uint64_t bits = io_bits(s, (uint64_t)*x, 8);
    memcpy(x, &bits, sizeof bits);
}

static void io_size(io *s, size_t *x) { *x = (size_t)io_bits(s, *x, 8); }

static void io_double(io *s, double *x)
{
    uint64_t bits;
    memcpy(&bits, x, sizeof bits);
    bits = io_bits(s, bits, 8);
    memcpy(x, &bits, sizeof bits);
}

static void io_reals(io *s, sp_real *x, size_t n)
{
    for (size_t k = 0; k < n; k++) {
        real_bits bits;
        memcpy(&bits, x + k, sizeof bits);
        bits = (real_bits)io_bits(s, bits, (int)sizeof bits);
        memcpy(x + k, &bits, sizeof bits);
    }
}

static void io_real(io *s, sp_real *x) { io_reals(s, x, 1); }

/* An enumerator 0..high. */
#define IO_ENUM(s, x, type, high)               \
    do {                                        \
        int32_t io_k = (int32_t)(x);            \
        io_int(s, &io_k, 0, (int32_t)(high));   \
        (x) = (type)io_k;                       \
    } while (0)

static io start_message(blob *b, blob_kind kind)
{
    io s = { b, NULL, 0, 0 };
    b->length = 0;
    b->failed = 0;
    io_bits(&s, MAGIC, 4);
    io_bits(&s, VERSION, 2);
    io_bits(&s, (uint64_t)kind, 2);
    io_bits(&s, FLAGS, 4);
    io_bits(&s, 0, 4);
    return s;
}

static sp_status finish_message(io *s)
{
    blob *b = s->out;
    const int full = b->length > BLOB_CAP;
    if (b->failed || full || !blob_grow(b, 4)) return full ? SP_E_CAPACITY : SP_E_MEMORY;
    put_bytes(b->data + 12, b->length - BLOB_HEADER, 4);
    io_bits(s, crc32_of(b->data, b->length), 4);
    return SP_OK;
}

static sp_status open_message(const blob *b, blob_kind kind, io *s)
{
    const io body = { NULL, b->data + BLOB_HEADER, b->length - BLOB_HEADER - 4, 0 };
    const sp_status status = blob_whole(b, kind);
    if (!status) *s = body;
    return status;
}

/* -------------------------------------------------------------------------------------------------------------- requests */

static void io_counts(io *s, sp_capacity *n)
{
    io_int(s, &n->blocks, 1, INT32_MAX);
    io_int(s, &n->vertices, 0, INT32_MAX);
    io_int(s, &n->faces, 0, INT32_MAX);
    io_int(s, &n->corners, 0, INT32_MAX);
    io_int(s, &n->joints, 0, INT32_MAX);
    io_int(s, &n->points, 0, INT32_MAX);
    io_int(s, &n->loads, 0, INT32_MAX);
}

static void io_world(io *s, sp_scene *scene)
{
    io_reals(s, scene->gravity, 3);
    io_real(s, &scene->live);
    io_reals(s, scene->body, 3);
}

static void io_settings(io *s, sp_settings *set)
{
    sp_coupled_settings *c = &set->coupled;
    int32_t seed = set->seed != NULL;
    io_int(s, &set->faces, 0, 64);
    io_int(s, &set->inscribed, 0, 1);
    io_int(s, &set->penalty.net, 0, 1);
    io_int(s, &set->localise, 0, 1);
    io_int(s, &set->iterations, INT32_MIN, BLOB_STEPS);
    io_long(s, &set->budget);
    io_int(s, &set->stage_count, 0, SP_STAGES_MAX);
    for (int k = 0; k < SP_STAGES_MAX; k++) IO_ENUM(s, set->stage[k], sp_stage_id, SP_STAGE_ADMM);
    io_int(s, &seed, 0, 1);
    io_int(s, &c->asked, 0, 1);
    io_int(s, &c->box, 0, 1);
    io_int(s, &c->rounds, INT32_MIN, BLOB_STEPS);
    io_int(s, &c->nodes, INT32_MIN, BLOB_NODES);
    io_real(s, &set->tol);
    io_real(s, &set->force_bound);
    io_real(s, &set->penalty.gamma);
    io_real(s, &set->penalty.tau);
    io_real(s, &c->eps);
    io_real(s, &c->eta);
    for (int k = 0; k < SP_EFFECTS_FORCED; k++) IO_ENUM(s, set->effect[k], sp_choice, SP_WITHOUT);
    if (!s->out && seed) set->seed = sp_seed_table();
}

static void io_block(io *s, sp_block *b)
{
    int32_t fixed = (int32_t)b->fixed;
    io_int(s, &fixed, 0, (int32_t)SP_FIXED);
    b->fixed = (uint32_t)fixed;
    io_int(s, &b->vertices, 0, INT32_MAX);
    io_int(s, &b->faces, 0, INT32_MAX);
    io_real(s, &b->density);
    io_real(s, &b->mass);
    io_reals(s, b->centroid, 3);
}

static void io_joint(io *s, sp_joint *f)
{
    int32_t polygon = f->area > 0;
    io_int(s, &f->a, 0, INT32_MAX);
    io_int(s, &f->b, 0, INT32_MAX);
    io_int(s, &f->points, 0, INT32_MAX);
    io_int(s, &polygon, 0, 1);
    f->area = (sp_real)polygon;
    io_real(s, &f->strength.mu);
    io_real(s, &f->strength.cohesion);
    io_real(s, &f->strength.tension);
    io_real(s, &f->strength.crushing);
    io_reals(s, f->n, 3);
    io_reals(s, f->t1, 3);
    io_reals(s, f->t2, 3);
}

static void io_load(io *s, sp_load *l)
{
    io_int(s, &l->block, 0, INT32_MAX);
    io_int(s, &l->live, 0, 1);
    io_reals(s, l->point, 3);
    io_reals(s, l->force, 3);
    io_reals(s, l->couple, 3);
    io_real(s, &l->mass);
}

/* Bytes of all that comes after the settings. */
static uint64_t scene_bytes(const sp_capacity *n)
{
    return (uint64_t)n->blocks * (12 + 5 * REAL) + (uint64_t)n->vertices * 3 * REAL + (uint64_t)n->faces * 4
         + (uint64_t)n->corners * 4 + (uint64_t)n->joints * (16 + 13 * REAL) + (uint64_t)n->points * 3 * REAL
         + (uint64_t)n->loads * (8 + 10 * REAL);
}

sp_status blob_write_request(blob *b, const sp_scene *scene, const sp_settings *settings)
{
    sp_settings set = *settings;
    sp_scene s = *scene;
    io o = start_message(b, BLOB_REQUEST);
    if (set.custom || set.penalty.solver || set.work || set.watch) return SP_E_UNSUPPORTED;
    if (set.seed && set.seed != sp_seed_table()) return SP_E_UNSUPPORTED;
    io_counts(&o, &s.count);
    io_world(&o, &s);
    io_settings(&o, &set);
    for (int32_t k = 0; k < s.count.blocks; k++) { sp_block x = s.block[k]; io_block(&o, &x); }
    io_reals(&o, (sp_real *)s.vertex, 3 * (size_t)s.count.vertices);
    for (int32_t k = 0; k < s.count.faces; k++) io_bits(&o, (uint32_t)s.face[k].corners, 4);
    for (int32_t k = 0; k < s.count.blocks; k++)
        for (int32_t i = 0; i < s.block[k].faces; i++) {
            const sp_face f = s.face[s.block[k].face + i];
            for (int32_t c = 0; c < f.corners; c++) io_bits(&o, (uint32_t)(s.corner[f.corner + c] - s.block[k].vertex), 4);
        }
    for (int32_t k = 0; k < s.count.joints; k++) { sp_joint x = s.joint[k]; io_joint(&o, &x); }
    io_reals(&o, (sp_real *)s.point, 3 * (size_t)s.count.points);
    for (int32_t k = 0; k < s.count.loads; k++) { sp_load x = s.load[k]; io_load(&o, &x); }
    return finish_message(&o);
}

/* Arrays of a request as they are read, before the library has seen them. */
typedef struct raw {
    sp_block *block;
    sp_real *vertex, *point;
    int32_t *size, *corner;
} raw;

static void raw_free(raw *r)
{
    free(r->block);
    free(r->vertex);
    free(r->point);
    free(r->size);
    free(r->corner);
}

static int raw_make(raw *r, const sp_capacity *n)
{
    r->block = calloc((size_t)n->blocks + 1, sizeof *r->block);
    r->vertex = calloc((size_t)n->vertices + 1, 3 * REAL);
    r->point = calloc((size_t)n->points + 1, 3 * REAL);
    r->size = calloc((size_t)n->faces + 1, sizeof *r->size);
    r->corner = calloc((size_t)n->corners + 1, sizeof *r->corner);
    return r->block && r->vertex && r->point && r->size && r->corner;
}

/* Block b of `raw` into the scene. */
static sp_status add_block(const raw *r, int32_t b, sp_scene *scene)
{
    const sp_block *x = &r->block[b];
    const sp_capacity *most = &scene->capacity, *n = &scene->count;
    const sp_mesh mesh = { x->vertices, x->faces, r->vertex + 3 * (size_t)n->vertices, r->size + n->faces,
                           r->corner + n->corners };
    int32_t room = most->corners - n->corners;
    if (x->vertices > most->vertices - n->vertices || x->faces > most->faces - n->faces) return SP_E_CAPACITY;
    if (!(x->density > 0) && (x->faces || x->vertices)) return SP_E_RANGE;
    if (!(x->density > 0)) return sp_scene_body(scene, x->mass, x->centroid, x->fixed, NULL);
    for (int32_t k = 0; k < x->faces; k++) {
        if (mesh.size[k] < 0 || mesh.size[k] > room) return SP_E_CAPACITY;
        room -= mesh.size[k];
    }
    return sp_scene_block(scene, &mesh, x->density, x->fixed, NULL);
}

/* A frame sent is the one the library made when the scene was built: a normal made unit twice may differ in its last bit. */
static int is_near(const sp_real *a, const sp_real *b)
{
    for (int k = 0; k < 3; k++) if (!(a[k] - b[k] <= 64 * SP_EPSILON && b[k] - a[k] <= 64 * SP_EPSILON)) return 0;
    return 1;
}

static sp_status add_interface(const raw *r, const sp_joint *x, sp_scene *scene)
{
    const sp_real *xyz = r->point + 3 * (size_t)scene->count.points;
    sp_joint *made = scene->joint + scene->count.joints;
    const sp_status status = x->points > scene->capacity.points - scene->count.points ? SP_E_CAPACITY
        : x->area > 0 ? sp_scene_joint(scene, x->a, x->b, x->points, xyz, &x->strength, NULL)
                      : sp_scene_points(scene, x->a, x->b, x->n, x->points, xyz, &x->strength, NULL);
    if (status) return status;
    if (!is_near(x->n, made->n) || !is_near(x->t1, made->t1) || !is_near(x->t2, made->t2)) return SP_E_RANGE;
    memcpy(made->n, x->n, sizeof made->n);
    memcpy(made->t1, x->t1, sizeof made->t1);
    memcpy(made->t2, x->t2, sizeof made->t2);
    return SP_OK;
}

/* The scene whose counts, checked, are scene->count. */
static sp_status read_scene(io *s, raw *r, const sp_capacity *n, sp_scene *scene)
{
    sp_status status = SP_OK;
    for (int32_t k = 0; k < n->blocks; k++) io_block(s, &r->block[k]);
    io_reals(s, r->vertex, 3 * (size_t)n->vertices);
    for (int32_t k = 0; k < n->faces; k++) io_int(s, &r->size[k], 0, INT32_MAX);
    for (int32_t k = 0; k < n->corners; k++) io_int(s, &r->corner[k], 0, INT32_MAX);
    for (int32_t k = 0; !s->bad && !status && k < n->blocks; k++) status = add_block(r, k, scene);
    if (status) return status;
    if (s->bad || scene->count.vertices != n->vertices || scene->count.faces != n->faces || scene->count.corners != n->corners)
        return SP_E_RANGE;

    const size_t joints = (size_t)n->joints * (16 + 13 * REAL);
    io points = { NULL, s->p + joints, s->left - joints, 0 };       /* they come after the joints */
    io_reals(&points, r->point, 3 * (size_t)n->points);
    for (int32_t k = 0; !status && k < n->joints; k++) {
        sp_joint x = { 0 };
        io_joint(s, &x);
        status = s->bad ? SP_E_RANGE : add_interface(r, &x, scene);
    }
    for (int32_t k = 0; !status && k < n->loads; k++) {
        sp_load x = { 0 };
        io_load(&points, &x);
        status = points.bad ? SP_E_RANGE : sp_scene_load(scene, &x, NULL);
    }
    return !status && scene->count.points != n->points ? SP_E_RANGE : status;
}

static int is_finite(const sp_real *x, int n)
{
    for (int k = 0; k < n; k++) if (!(x[k] - x[k] <= 0)) return 0;
    return 1;
}

sp_status blob_read_request(const blob *b, sp_scene *scene, sp_settings *settings, void **memory)
{
    sp_settings set = sp_settings_default();
    sp_capacity n;
    sp_scene made, world;
    sp_arena arena;
    raw r = { NULL, NULL, NULL, NULL, NULL };
    io s;
    sp_status status = open_message(b, BLOB_REQUEST, &s);

    *memory = NULL;
    if (status) return status;
    memset(&n, 0, sizeof n);
    memset(&world, 0, sizeof world);
    io_counts(&s, &n);
    io_world(&s, &world);
    io_settings(&s, &set);
    if (s.bad || scene_bytes(&n) != s.left) return SP_E_RANGE;
    if (!is_finite(world.gravity, 3) || !is_finite(world.body, 3) || !is_finite(&world.live, 1)) return SP_E_NOT_FINITE;
    status = run_arena(sp_scene_memory(&n), &arena, memory);
    if (!status && !raw_make(&r, &n)) status = SP_E_MEMORY;
    if (!status) status = sp_scene_create(&made, &n, &arena);
    if (!status) {
        memcpy(made.gravity, world.gravity, sizeof made.gravity);
        memcpy(made.body, world.body, sizeof made.body);
        made.live = world.live;
        status = read_scene(&s, &r, &n, &made);
    }
    raw_free(&r);
    if (status) return status;
    *scene = made;
    *settings = set;
    return SP_OK;
}

/* --------------------------------------------------------------------------------------------------------------- results */

static void io_cost(io *s, sp_cost *c)
{
    io_long(s, &c->flops);
    io_int(s, &c->factorisations, INT32_MIN, INT32_MAX);
    io_int(s, &c->iterations, INT32_MIN, INT32_MAX);
    io_int(s, &c->interior, INT32_MIN, INT32_MAX);
}

/* Counts of the arrays that not only the scene tells. */
typedef struct extra { int32_t motion, alpha, penalty; } extra;

static void io_coupled(io *s, sp_coupled *c)
{
    IO_ENUM(s, c->verdict, sp_coupling, SP_COUPLING_NOT_FOUND);
    IO_ENUM(s, c->reason, sp_coupling_reason, SP_COUPLING_BUDGET);
    io_real(s, &c->residual);
    io_int(s, &c->rounds, INT32_MIN, INT32_MAX);
    io_real(s, &c->eps);
    io_real(s, &c->eta);
    io_real(s, &c->tension_ratio);
    io_int(s, &c->proof.nodes, 0, INT32_MAX);
    io_int(s, &c->proof.leaves, 0, INT32_MAX);
    io_int(s, &c->proof.entries, 0, INT32_MAX);
    io_int(s, &c->proof.island, 0, INT32_MAX);
    io_real(s, &c->margin);
    io_cost(s, &c->cost);
}

static void io_head(io *s, const sp_scene *scene, sp_result *r, run_cost *cost, extra *x)
{
    IO_ENUM(s, r->verdict, sp_verdict, SP_UNSTABLE);
    IO_ENUM(s, r->level, sp_level, SP_COUPLED);
    IO_ENUM(s, r->reason, sp_reason, SP_REASON_EFFECT);
    io_int(s, &r->final, 0, 1);
    io_int(s, &r->verified, 0, 1);
    IO_ENUM(s, r->stage, sp_stage_id, SP_STAGE_CUSTOM);
    io_real(s, &r->tol);
    io_real(s, &r->force_bound);
    io_real(s, &r->imbalance);
    io_real(s, &r->least_imbalance);
    io_int(s, &r->counts.free_blocks, 0, scene->count.blocks);
    io_int(s, &r->counts.joints, 0, scene->count.joints);
    io_int(s, &r->counts.points, 0, scene->count.points);
    io_real(s, &r->extremes.compression);
    io_real(s, &r->extremes.tension);
    io_real(s, &r->extremes.utilisation);
    io_real(s, &r->extremes.corner_utilisation);
    io_real(s, &r->extremes.tension_ratio);
    io_int(s, &r->extremes.weakest, -1, scene->count.joints - 1);
    io_cost(s, &r->spent.total);
    for (int k = 0; k < SP_STAGES_MAX; k++) io_cost(s, &r->spent.by_stage[k]);
    io_coupled(s, &r->coupled);
    for (int k = 0; k < SP_EFFECTS; k++) IO_ENUM(s, r->effect[k], sp_effect_why, SP_WHY_FOREST);
    IO_ENUM(s, r->missing, sp_effect, SP_EFFECTS - 1);
    io_int(s, &r->islands.count, 0, scene->count.blocks);
    io_size(s, &r->spent.peak_bytes);
    io_size(s, &cost->bytes);
    io_double(s, &cost->seconds);
    io_int(s, &x->motion, 0, 1);
    io_int(s, &x->alpha, 0, 1);
    io_int(s, &x->penalty, 0, 1);
}

static void io_part(io *s, const sp_scene *scene, sp_island *p)
{
    IO_ENUM(s, p->verdict, sp_verdict, SP_UNSTABLE);
    IO_ENUM(s, p->reason, sp_reason, SP_REASON_EFFECT);
    IO_ENUM(s, p->stage, sp_stage_id, SP_STAGE_CUSTOM);
    IO_ENUM(s, p->coupling, sp_coupling, SP_COUPLING_NOT_FOUND);
    IO_ENUM(s, p->coupling_reason, sp_coupling_reason, SP_COUPLING_BUDGET);
    io_int(s, &p->block, 0, scene->count.blocks - 1);
    io_int(s, &p->blocks, 0, scene->count.blocks);
}

/* The arrays, whose pointers are set. */
static void io_arrays(io *s, const sp_scene *scene, sp_result *r, const extra *x)
{
    sp_proof *p = &r->coupled.proof;
    io_reals(s, r->f, 3 * (size_t)scene->count.points);
    io_reals(s, r->dq, 6 * (size_t)scene->count.blocks);
    io_reals(s, r->y0, 12 * (size_t)r->counts.free_blocks);
    for (int32_t k = 0; k < scene->count.joints; k++) {
        io_real(s, &r->demand[k].tension);
        io_real(s, &r->demand[k].friction);
    }
    if (x->motion) io_reals(s, r->coupled.dq, 6 * (size_t)scene->count.blocks);
    if (x->alpha) io_reals(s, r->coupled.alpha, (size_t)scene->count.points);
    if (x->penalty) io_reals(s, r->coupled.penalty, 4 * (size_t)scene->count.points);
    for (int32_t k = 0; k < p->nodes; k++) io_int(s, &p->node[k], INT32_MIN, INT32_MAX);
    for (int32_t k = 0; p->nodes && k < p->entries; k++) p->row[k] = (uint16_t)io_bits(s, p->row[k], 2);
    if (p->nodes) io_reals(s, p->y, (size_t)p->entries);
    const sp_islands *apart = &r->islands;
    for (int32_t k = 0; apart->count > 1 && k < scene->count.blocks; k++) io_int(s, &apart->of[k], -1, apart->count - 1);
    for (int32_t k = 0; apart->count > 1 && k < apart->count; k++) io_part(s, scene, &apart->each[k]);
}

sp_status blob_write_result(blob *b, const sp_scene *scene, const sp_result *result, const run_cost *cost)
{
    sp_result r = *result;
    run_cost c = *cost;
    extra x = { r.coupled.dq != NULL, r.coupled.alpha != NULL, r.coupled.penalty != NULL };
    io s = start_message(b, BLOB_RESULT);
    io_head(&s, scene, &r, &c, &x);
    io_arrays(&s, scene, &r, &x);
    return finish_message(&s);
}

/* Numbers of the arrays in this order, then node, islands, row. */
static void result_carve(sp_result *r, const sp_scene *scene, const extra *x, void *memory)
{
    sp_proof *p = &r->coupled.proof;
    r->f = memory;
    r->dq = r->f + 3 * (size_t)scene->count.points;
    r->y0 = r->dq + 6 * (size_t)scene->count.blocks;
    r->demand = (sp_demand *)(r->y0 + 12 * (size_t)r->counts.free_blocks);
    r->coupled.dq = (sp_real *)(r->demand + scene->count.joints);
    r->coupled.alpha = r->coupled.dq + (x->motion ? 6 * (size_t)scene->count.blocks : 0);
    r->coupled.penalty = r->coupled.alpha + (x->alpha ? (size_t)scene->count.points : 0);
    p->y = r->coupled.penalty + (x->penalty ? 4 * (size_t)scene->count.points : 0);
    p->node = (int32_t *)(p->y + p->entries);
    r->islands.of = p->node + p->nodes;
    r->islands.each = (sp_island *)(r->islands.of + (r->islands.count > 1 ? scene->count.blocks : 0));
    p->row = (uint16_t *)(r->islands.each + (r->islands.count > 1 ? r->islands.count : 0));
    if (r->islands.count < 2) r->islands.of = NULL, r->islands.each = NULL;
    if (!x->motion) r->coupled.dq = NULL;
    if (!x->alpha) r->coupled.alpha = NULL;
    if (!x->penalty) r->coupled.penalty = NULL;
    if (!p->nodes) p->y = NULL, p->node = NULL, p->row = NULL;
}

sp_status blob_read_result(const blob *b, const sp_scene *scene, sp_result *result, run_cost *cost, void **memory)
{
    sp_result r;
    run_cost c = { 0, 0 };
    extra x = { 0, 0, 0 };
    uint64_t need;
    io s;
    const sp_status status = open_message(b, BLOB_RESULT, &s);

    *memory = NULL;
    if (status) return status;
    memset(&r, 0, sizeof r);
    io_head(&s, scene, &r, &c, &x);
    if (s.bad || (!r.coupled.proof.nodes && r.coupled.proof.entries)) return SP_E_RANGE;
    need = REAL * (3 * (uint64_t)scene->count.points + 6 * (uint64_t)scene->count.blocks + 12 * (uint64_t)r.counts.free_blocks
                   + 2 * (uint64_t)scene->count.joints + (x.motion ? 6 * (uint64_t)scene->count.blocks : 0)
                   + (x.alpha ? (uint64_t)scene->count.points : 0) + (x.penalty ? 4 * (uint64_t)scene->count.points : 0)
                   + (uint64_t)r.coupled.proof.entries)
         + 4 * (uint64_t)r.coupled.proof.nodes + 2 * (uint64_t)r.coupled.proof.entries
         + (r.islands.count > 1 ? 4 * (uint64_t)scene->count.blocks + sizeof *r.islands.each * (uint64_t)r.islands.count : 0);
    if (need != s.left) return SP_E_RANGE;
    *memory = calloc(s.left + 1, 1);
    if (!*memory) return SP_E_MEMORY;
    result_carve(&r, scene, &x, *memory);
    io_arrays(&s, scene, &r, &x);
    *result = r;
    *cost = c;
    return SP_OK;
}

/* ---------------------------------------------------------------------------------------------------------------- errors */

sp_status blob_write_error(blob *b, sp_status status, const char *message)
{
    io s = start_message(b, BLOB_ERROR);
    io_bits(&s, (uint32_t)(int32_t)status, 4);
    for (const char *c = message; *c; c++) io_bits(&s, (unsigned char)*c, 1);
    return finish_message(&s);
}

sp_status blob_read_error(const blob *b, char message[200])
{
    int32_t status = SP_E_ARGUMENT;
    size_t k = 0;
    io s;
    message[0] = 0;
    if (open_message(b, BLOB_ERROR, &s)) return SP_E_ARGUMENT;
    io_int(&s, &status, SP_E_INDEFINITE, -1);
    for (; k < 199 && s.left; k++) {
        const uint64_t c = io_bits(&s, 0, 1);
        message[k] = c < 32 || c > 126 ? '?' : (char)c;
    }
    message[k] = 0;
    return s.bad ? SP_E_ARGUMENT : (sp_status)status;
}
