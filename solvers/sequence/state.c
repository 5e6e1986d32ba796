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
    int32_t must_members;               /* how many of the members must be held */
    int32_t count;                      /* held so far, in q->found.held */
    sp_held_proof proof;                /* the weakest of all islands */
    int stop;                           /* the budget is spent, or a check failed */
    int unsure;                         /* a set that did not stand was not shown to fall */
    sp_status status;
} sp__hold;

/* The finished scene as a graph of its blocks. */
typedef struct sp__sequence_graph {
    int32_t *row, *order;               /* block's row in pb, -1: a support; blocks by elimination */
    int32_t *start, *joint;             /* joint[start[b] .. start[b + 1] - 1]: contacts of pb at block b */
    sp_real *lever;                     /* per row [m] */
} sp__sequence_graph;

/* What is known of every block and joint, at the scene's numbers. */
typedef struct sp__sequence_known {
    sp__block_state *state;             /* per block */
    sp_real *f, *dq;                    /* 3 per vertex [N]; 6 per block [m, 1] */
} sp__sequence_known;

/* The blocks at hand as a part, in the order of elimination, with their joints and loads. */
typedef struct sp__sequence_chosen {
    sp__part part;
    int32_t *mark;                      /* per block, 1: chosen */
    int32_t *number;                    /* per block: row in the part, -1 */
    int32_t *block_next, *joint_next, *load_next;       /* lists of the part */
} sp__sequence_chosen;

/* A list as long as there are blocks, which has one use at a time. */
typedef union sp__sequence_list {
    int32_t *solve;                     /* local.c: blocks to be solved alone */
    int32_t *member;                    /* hold.c: the island at hand */
    int32_t *reported;                  /* hold.c, at its end: of each block of the answer, must it be held? */
} sp__sequence_list;

/* What a call finds out block by block; the next call may use it for what it finds. */
typedef union sp__sequence_found {
    int32_t *held;                      /* sp_sequence_hold: the blocks to be held */
    int32_t *tried;                     /* sp_sequence_suggest, per block, 1: it has been tried, or may not be */
} sp__sequence_found;

/* What the call at hand has taken: islands looked at, blocks solved again, islands solved by local.c, sets tried. */
typedef struct sp__sequence_spent {
    sp_cost cost;
    int32_t checked, again, local, tries;
} sp__sequence_spent;

struct sp_sequence {
    const sp_scene *scene;
    sp_settings set;
    sp_problem pb;                      /* of the finished scene, all blocks there */
    sp__certifier certifier;            /* its units and cone */
    sp__sequence_graph graph;
    sp__sequence_known now, saved;      /* saved: while a step is tried */
    sp__sequence_chosen chosen;
    sp__sequence_list list;
    int32_t *origin;                    /* of each in list.solve: above which block that began */
    sp__sequence_found found;
    int32_t *must, *held_last;          /* hold.c, per block: must it be held? was it in the last answer? */
    int32_t *island;                    /* per block, by union-find */
    sp_arena work;
    sp__hold hold;
    sp__sequence_spent spent;
};

/* The problem of the finished scene, in a dry arena only counted, and all arrays. */
static sp_status sp__sequence_carve(sp_sequence *q, const sp_scene *scene, size_t work, sp_arena *a)
{
    if (a->base) {
        const sp_status status = sp_problem_build(scene, a, &q->pb);
        if (status) return status;
    } else {
        sp__problem_count(scene, &q->pb);
        sp__take(a, 1, sp__problem_memory(scene));
    }
    const size_t n = (size_t)scene->count.blocks, c = (size_t)q->pb.contacts, v = (size_t)scene->count.points;
    q->graph.row = sp__take(a, n, sizeof *q->graph.row);
    q->graph.order = sp__take(a, n, sizeof *q->graph.order);
    q->island = sp__take(a, n, sizeof *q->island);
    q->chosen.mark = sp__take(a, n, sizeof *q->chosen.mark);
    q->chosen.number = sp__take(a, n, sizeof *q->chosen.number);
    q->chosen.block_next = sp__take(a, n, sizeof *q->chosen.block_next);
    q->list.solve = sp__take(a, n, sizeof *q->list.solve);
    q->origin = sp__take(a, n, sizeof *q->origin);
    q->found.held = sp__take(a, n, sizeof *q->found.held);
    q->must = sp__take(a, n, sizeof *q->must);
    q->held_last = sp__take(a, n, sizeof *q->held_last);
    q->graph.start = sp__take(a, n + 1, sizeof *q->graph.start);
    q->graph.joint = sp__take(a, c, 2 * sizeof *q->graph.joint);
    q->chosen.joint_next = sp__take(a, (size_t)scene->count.joints, sizeof *q->chosen.joint_next);
    q->chosen.load_next = sp__take(a, (size_t)scene->count.loads, sizeof *q->chosen.load_next);
    q->now.state = sp__take(a, n, sizeof *q->now.state);
    q->saved.state = sp__take(a, n, sizeof *q->saved.state);
    q->graph.lever = sp__take(a, (size_t)q->pb.blocks, sizeof *q->graph.lever);
    q->now.f = sp__take(a, v, 3 * sizeof *q->now.f);
    q->saved.f = sp__take(a, v, 3 * sizeof *q->saved.f);
    q->now.dq = sp__take(a, n, 6 * sizeof *q->now.dq);
    q->saved.dq = sp__take(a, n, 6 * sizeof *q->saved.dq);
    q->certifier.direction = sp__take(a, 64, sizeof *q->certifier.direction);
    const sp__part part = { -1, -1, -1, q->chosen.block_next, q->chosen.joint_next, q->chosen.load_next, q->chosen.number };
    q->chosen.part = part;
    q->work.base = sp__take(a, work, 1);
    q->work.capacity = work;
    q->work.used = q->work.peak = 0;
    return sp__failed(a) ? SP_E_MEMORY : SP_OK;
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

/* Settings in force, and bytes of a check of the whole and of its symbolic step: a part in the same order of elimination fills
 * no more. */
SP__NOINLINE static sp_status sp__sequence_work(const sp_scene *scene, const sp_settings *settings, sp_arena scratch,
                                                sp_settings *set, size_t *work)
{
    sp_status status = sp__sequence_settings(scene, settings, set);
    if (!status) status = sp__memory(scene, set, NULL, scratch, work);
    if (status) return status;
    const size_t symbolic = sp__check_scratch(scene, set);
    *work += SP_ALIGN + (size_t)scene->count.points * sizeof *scene->point;         /* a part's vertices are its own */
    if (symbolic > *work) *work = symbolic;
    return symbolic ? SP_OK : SP_E_MEMORY;
}

/* A free block that is there and not held. */
static int sp__free_now(const sp_sequence *q, int32_t b)
{
    return q->graph.row[b] >= 0 && q->now.state[b].presence == SP_PRESENT;
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
    for (int32_t b = 0; b <= n; b++) q->graph.start[b] = 0;
    for (int32_t i = 0; i < q->pb.blocks; i++) q->graph.lever[i] = q->scene->block[q->pb.block[i]].fixed ? 0 : SP__HUGE;
    for (int32_t c = 0; c < q->pb.contacts; c++) {
        const sp_contact *t = &q->pb.contact[c];
        q->graph.start[t->joint->a]++;
        q->graph.start[t->joint->b]++;
        for (int side = 0; side < 2; side++) {
            const int32_t i = side ? t->b : t->a;
            if (i < 0) continue;
            const sp_real lever = sp__lever(&q->pb, t, i, w);
            if (lever < q->graph.lever[i]) q->graph.lever[i] = lever;
        }
    }
    for (int32_t b = 0; b < n; b++) q->graph.start[b + 1] += q->graph.start[b];
    for (int32_t c = q->pb.contacts - 1; c >= 0; c--) {
        q->graph.joint[--q->graph.start[q->pb.contact[c].joint->a]] = c;
        q->graph.joint[--q->graph.start[q->pb.contact[c].joint->b]] = c;
    }
    return SP_OK;
}

/* Blocks in the order of least fill of the finished scene. */
SP__NOINLINE static sp_status sp__sequence_order(sp_sequence *q)
{
    sp_arena a = q->work;
    sp__system *w = sp__take(&a, 1, sizeof *w);
    if (!w || sp__system_analyse(w, &q->pb, &a) < 0) return SP_E_MEMORY;
    for (int32_t k = 0; k < q->pb.blocks; k++) q->graph.order[k] = q->pb.block[w->L.perm[k]];
    return SP_OK;
}

/* Of the finished scene, carved: nothing but supports is there. */
SP__NOINLINE static sp_status sp__sequence_begin(sp_sequence *q)
{
    const size_t n = (size_t)q->scene->count.blocks;
    q->certifier.pb = &q->pb;
    sp__certifier_cone(&q->certifier, &q->pb, &q->set);
    memset(q->now.state, 0, n * sizeof *q->now.state);
    memset(q->held_last, 0, n * sizeof *q->held_last);
    memset(q->now.f, 0, 3 * (size_t)q->scene->count.points * sizeof *q->now.f);
    memset(q->now.dq, 0, 6 * n * sizeof *q->now.dq);
    for (int32_t b = 0; b < q->scene->count.blocks; b++) {
        q->graph.row[b] = sp__problem_row(&q->pb, b);
        q->chosen.number[b] = -1;
        q->island[b] = b;
        if (q->graph.row[b] < 0) q->now.state[b].presence = SP_PRESENT;
    }
    const sp_status status = sp__sequence_joints(q);
    return status ? status : sp__sequence_order(q);
}

#endif

#endif /* SP__SEQUENCE_STATE_C */
