/* state: what a build order keeps: presence, forces and motion of each block, and whether its balance is proved. */
#ifndef SP__SEQUENCE_STATE_C
#define SP__SEQUENCE_STATE_C

#include "../check/memory.c"

#if SP__WITH_LARGE

/* The finished scene, some of its blocks absent. An island (free blocks that touch each other) is checked as a
 * part (scene/part.c): its blocks, the held ones and supports that they touch, the joints between.
 *
 * Before that the forces of the step before are tried. A block is called certified if its forces f pass sp_check's certificate
 * whatever f0 is, so that it can be seen from the block alone: sbar >= |load|, s >= 1.8 |load| (what balances a load is no
 * less than it, and f0 does to three digits, or counts as the load), and with tol' a little less than tol, for rounding,
 *
 *     |r| <= tol' 1.8 |load|,   |m| <= tol' (|couple| + min(sum |x_v x f_v|, lever |load|)),   |f_v| <= force_bound min |load|
 *
 * where lever |load| <= sum |x_v x f0_v| (sp__lever). An island of certified blocks stands. Where a step left some that are
 * not, they and what is below them are solved alone, loaded by the forces of their joints with all others, which stay.    */

#define SP__LOCAL_STEPS 4                /* factorisations for that */
#define SP__LOCAL_TOL ((sp_real)0.25)    /* of tol for that: its blocks bear the forces of others */
#define SP__CERTIFIED_TOL ((sp_real)0.9)    /* tol' of tol */
#define SP__BELOW ((sp_real)0.2)        /* cosine between gravity and a joint's normal from which on a block is below another */

typedef struct sp__block_state {
    sp_presence presence;
    sp_verdict verdict;                 /* of its island */
    sp_reason reason;
    int32_t final, certified, stale;
    sp_real imbalance, least;
} sp__block_state;

/* A search for what to hold (hold.c). */
typedef struct sp__hold {
    sp_sequence *q;
    int32_t *member, members;           /* the island */
    int64_t budget;
    int32_t worst;                      /* what moves most in the first group that falls */
    int32_t known;                      /* how many of the members must be held */
    int32_t count;                      /* held so far, in q->answer */
    sp_held_proof proof;                /* the weakest of all islands */
    int over;                           /* the budget is spent */
    int unsure;                         /* a set that did not stand was not shown to fall */
    sp_status status;
} sp__hold;

struct sp_sequence {
    const sp_scene *scene;
    sp_settings set;
    sp_problem pb;                      /* of the finished scene, all blocks there */
    sp__certifier certifier;            /* its units and cone */
    sp__part part;                      /* the blocks at hand, in the order of elimination, and their joints and loads */
    sp__block_state *state, *state_saved;      /* per block */
    int32_t *row, *order;               /* block's row in pb, -1: a support; blocks by elimination */
    int32_t *start, *joint;             /* contacts of pb at each block */
    sp_real *lever;                     /* per row [m] */
    int32_t *up, *mark, *number;        /* islands by union-find; who is meant; row in the part, -1 */
    int32_t *block_next, *joint_next, *load_next;   /* lists of the part */
    int32_t *list, *origin;             /* blocks to be solved, and above which block that began */
    int32_t *answer, *must, *was;       /* of the search for what to hold */
    sp_real *f, *f_saved, *dq, *dq_saved;
    sp_arena work;
    sp__hold hold;
    sp_cost cost;
    int32_t checked, again, local, tries;
};

static void sp__sequence_carve(sp_sequence *q, const sp_scene *scene, const sp_problem *count, size_t work, sp_arena *a)
{
    const size_t n = (size_t)scene->count.blocks, c = (size_t)count->contacts, v = (size_t)scene->count.points;
    q->row = sp__take(a, n, sizeof *q->row);
    q->order = sp__take(a, n, sizeof *q->order);
    q->up = sp__take(a, n, sizeof *q->up);
    q->mark = sp__take(a, n, sizeof *q->mark);
    q->number = sp__take(a, n, sizeof *q->number);
    q->block_next = sp__take(a, n, sizeof *q->block_next);
    q->list = sp__take(a, n, sizeof *q->list);
    q->origin = sp__take(a, n, sizeof *q->origin);
    q->answer = sp__take(a, n, sizeof *q->answer);
    q->must = sp__take(a, n, sizeof *q->must);
    q->was = sp__take(a, n, sizeof *q->was);
    q->start = sp__take(a, n + 1, sizeof *q->start);
    q->joint = sp__take(a, c, 2 * sizeof *q->joint);
    q->joint_next = sp__take(a, (size_t)scene->count.joints, sizeof *q->joint_next);
    q->load_next = sp__take(a, (size_t)scene->count.loads, sizeof *q->load_next);
    q->state = sp__take(a, n, sizeof *q->state);
    q->state_saved = sp__take(a, n, sizeof *q->state_saved);
    q->lever = sp__take(a, (size_t)count->blocks, sizeof *q->lever);
    q->f = sp__take(a, v, 3 * sizeof *q->f);
    q->f_saved = sp__take(a, v, 3 * sizeof *q->f_saved);
    q->dq = sp__take(a, n, 6 * sizeof *q->dq);
    q->dq_saved = sp__take(a, n, 6 * sizeof *q->dq_saved);
    q->certifier.direction = sp__take(a, 64, sizeof *q->certifier.direction);
    const sp__part part = { -1, -1, -1, q->block_next, q->joint_next, q->load_next, q->number };
    q->part = part;
    q->work.base = sp__take(a, work, 1);
    q->work.cap = work;
    q->work.used = q->work.peak = 0;
}

/* The caller's settings, as far as they can be followed step by step: what a check of a part needs must be no more than what
 * one of the whole does. */
static sp_status sp__sequence_settings(const sp_scene *scene, const sp_settings *in, sp_settings *out)
{
    const sp_status status = sp__settings_resolve(scene, in, out);
    if (status) return status;
    if (out->coupled.asked) return SP_E_UNSUPPORTED;
    for (int32_t k = 0; k < out->stage_count; k++)
        if (out->stage[k] == SP_STAGE_ADMM || out->stage[k] == SP_STAGE_CUSTOM) return SP_E_UNSUPPORTED;
    out->localise = 0;
    out->effect[SP_EFFECT_TOGETHER] = SP_WITH;          /* a part is one island */
    out->work = NULL;
    return SP_OK;
}

static size_t sp__sequence_scratch(const sp_scene *scene, const sp_settings *settings)
{
    const size_t most = sp__check_scratch(scene, settings);
    return most ? sizeof(sp_sequence) + SP_ALIGN + most : 0;
}

/* Bytes of a check of the whole, and of its symbolic step: a part in the same order of elimination fills no more. */
SP__NOINLINE static sp_status sp__sequence_work(const sp_scene *scene, const sp_settings *settings, sp_arena scratch,
                                                size_t *work)
{
    sp_sequence *q = sp__take(&scratch, 1, sizeof *q);
    if (!q) return SP_E_MEMORY;
    sp_status status = sp__sequence_settings(scene, settings, &q->set);
    if (!status) status = sp__memory(scene, &q->set, NULL, scratch, work);
    if (status) return status;
    const size_t symbolic = sp__check_scratch(scene, &q->set);
    *work += SP_ALIGN + (size_t)scene->count.points * sizeof *scene->point;         /* a part's vertices are its own */
    if (symbolic > *work) *work = symbolic;
    return symbolic ? SP_OK : SP_E_MEMORY;
}

/* Bytes of all that a sequence keeps, its checks' work among them. */
SP__NOINLINE static sp_status sp__sequence_count(const sp_scene *scene, sp_arena *scratch, size_t work, size_t *bytes)
{
    sp_sequence *q = sp__take(scratch, 1, sizeof *q);
    sp_arena dry = sp__arena_dry();
    if (!q) return SP_E_MEMORY;
    sp__take(&dry, 1, sizeof *q);
    sp__take(&dry, 1, sp__problem_memory(scene));
    sp__problem_count(scene, &q->pb);
    sp__sequence_carve(q, scene, &q->pb, work, &dry);
    if (sp__failed(&dry)) return SP_E_MEMORY;
    *bytes = dry.used;
    return SP_OK;
}

SP__NOINLINE static sp_status sp__sequence_memory(const sp_scene *scene, const sp_settings *settings, sp_arena scratch,
                                                  size_t *bytes)
{
    if (!scene || !bytes || !scratch.base) return SP_E_ARGUMENT;
    if (scene->count.blocks < 1) return SP_E_EMPTY;
    size_t work = 0;
    const sp_status status = sp__sequence_work(scene, settings, scratch, &work);
    return status ? status : sp__sequence_count(scene, &scratch, work, bytes);
}

/* A free block that is there and not held. */
static int sp__free_now(const sp_sequence *q, int32_t b)
{
    return q->row[b] >= 0 && q->state[b].presence == SP_PRESENT;
}

static int32_t sp__neighbour(const sp_contact *t, int32_t b) { return t->joint->a == b ? t->joint->b : t->joint->a; }

typedef struct sp__lever_work { sp_real FF[21], GG[21], M[21]; } sp__lever_work;

/* F'F and G'G of a contact seen from block b, F = [1, -[x]], G = [x] F, x in units of the longest |x|: f = F (V, W) is a force
 * of the kind f0 has, x x f = G (V, W) its moment, [x]'[x] = |x|^2 - x x'. */
SP__NOINLINE static void sp__lever_matrices(const sp_problem *pb, const sp_contact *t, int32_t i, sp_real unit,
                                            sp__lever_work *w)
{
    for (int k = 0; k < 21; k++) w->FF[k] = w->GG[k] = 0;
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        sp_real x[3], F[6][3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
        sp__arm(pb, i, v, x);
        sp__scale3(1 / unit, x, x);
        const sp_real xx = sp__dot3(x, x);
        for (int k = 0; k < 3; k++) sp__cross3(F[k], x, F[3 + k]);
        for (int r = 0, e = 0; r < 6; r++)
            for (int c = 0; c <= r; c++, e++) {
                const sp_real f = sp__dot3(F[r], F[c]);
                w->FF[e] += f;
                w->GG[e] += xx * f - sp__dot3(F[r], x) * sp__dot3(F[c], x);
            }
    }
}

/* f0 = V + W x x over a contact, so sum |x x f0| >= lever sum |f0| with a lever of its shape alone: |G z|^2 >= share |F z|^2
 * for all z if G'G - share F'F is positive, and sums of norms are at least, at most sqrt(points) times, norms of all. A little
 * less, for what f0 may be out of balance and for rounding; 0 where points or an edge let f0 run through the centroid. */
SP__NOINLINE static sp_real sp__lever(const sp_problem *pb, const sp_contact *t, int32_t i, sp__lever_work *w)
{
    sp_real unit = 0, *M = w->M;
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        sp__arm(pb, i, v, M);
        unit = sp__max(unit, sp__norm3(M));
    }
    if (!(unit > 0)) return 0;
    sp__lever_matrices(pb, t, i, unit, w);
    for (sp_real share = (sp_real)0.5; share > (sp_real)1e-4; share /= 2) {
        int positive = 1;
        for (int k = 0; k < 21; k++) M[k] = w->GG[k] - share * w->FF[k];
        sp__chol_factor(M, 6, 1000 * (sp_real)SP_EPSILON);
        for (int k = 0; k < 6; k++) positive &= M[k * (k + 3) / 2] < SP__NEVER / 2;
        if (positive) return (sp_real)0.9 * SP_SQRT(share / (sp_real)t->points) * unit;
    }
    return 0;
}

/* Levers, and the contacts at each block. */
SP__NOINLINE static sp_status sp__sequence_joints(sp_sequence *q)
{
    const int32_t n = q->scene->count.blocks;
    sp_arena a = q->work;
    sp__lever_work *w = sp__take(&a, 1, sizeof *w);
    if (!w) return SP_E_MEMORY;
    for (int32_t b = 0; b <= n; b++) q->start[b] = 0;
    for (int32_t i = 0; i < q->pb.blocks; i++) q->lever[i] = q->scene->block[q->pb.block[i]].fixed ? 0 : SP__HUGE;
    for (int32_t c = 0; c < q->pb.contacts; c++) {
        const sp_contact *t = &q->pb.contact[c];
        q->start[t->joint->a]++;
        q->start[t->joint->b]++;
        for (int side = 0; side < 2; side++) {
            const int32_t i = side ? t->b : t->a;
            if (i < 0) continue;
            const sp_real lever = sp__lever(&q->pb, t, i, w);
            if (lever < q->lever[i]) q->lever[i] = lever;
        }
    }
    for (int32_t b = 0; b < n; b++) q->start[b + 1] += q->start[b];
    for (int32_t c = q->pb.contacts - 1; c >= 0; c--) {
        q->joint[--q->start[q->pb.contact[c].joint->a]] = c;
        q->joint[--q->start[q->pb.contact[c].joint->b]] = c;
    }
    return SP_OK;
}

/* Blocks in the order of least fill of the finished scene. */
SP__NOINLINE static sp_status sp__sequence_order(sp_sequence *q)
{
    sp_arena a = q->work;
    sp__system *w = sp__take(&a, 1, sizeof *w);
    if (!w || sp__system_analyse(w, &q->pb, &a) < 0) return SP_E_MEMORY;
    for (int32_t k = 0; k < q->pb.blocks; k++) q->order[k] = q->pb.block[w->L.perm[k]];
    return SP_OK;
}

SP_API sp_status sp_sequence_open(const sp_scene *scene, const sp_settings *settings, sp_arena *arena, sp_sequence **sequence)
{
    if (!scene || !arena || !arena->base || !sequence) return SP_E_ARGUMENT;
    if (scene->count.blocks < 1) return SP_E_EMPTY;
    size_t work = 0;
    sp_arena a = *arena;
    sp_status status = sp__sequence_work(scene, settings, a, &work);
    if (status) return status;
    sp_sequence *q = sp__take(&a, 1, sizeof *q);
    if (!q) return SP_E_MEMORY;
    memset(q, 0, sizeof *q);
    q->scene = scene;
    status = sp__sequence_settings(scene, settings, &q->set);
    if (!status) status = sp_problem_build(scene, &a, &q->pb);
    if (status) return status;
    sp__sequence_carve(q, scene, &q->pb, work, &a);
    if (sp__failed(&a)) return SP_E_MEMORY;
    q->certifier.pb = &q->pb;
    sp__certifier_cone(&q->certifier, &q->pb, &q->set);
    const size_t n = (size_t)scene->count.blocks;
    memset(q->state, 0, n * sizeof *q->state);
    memset(q->was, 0, n * sizeof *q->was);
    memset(q->f, 0, 3 * (size_t)scene->count.points * sizeof *q->f);
    memset(q->dq, 0, 6 * n * sizeof *q->dq);
    for (int32_t b = 0; b < scene->count.blocks; b++) {
        q->row[b] = sp__problem_row(&q->pb, b);
        q->number[b] = -1;
        q->up[b] = b;
        if (q->row[b] < 0) q->state[b].presence = SP_PRESENT;
    }
    status = sp__sequence_joints(q);
    if (!status) status = sp__sequence_order(q);
    if (status) return status;
    *arena = a;
    *sequence = q;
    return SP_OK;
}

#endif

#endif /* SP__SEQUENCE_STATE_C */
