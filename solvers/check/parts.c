/* parts: islands: groups of free blocks that touch, each as a scene of its own */
#ifndef SP__CHECK_PARTS_C
#define SP__CHECK_PARTS_C

#include "../base/groups.c"
#include "../scene/scene.c"
#include "../scene/problem.c"
#include "../statics/mirror.c"

#if SP__WITH_LARGE

/* Free blocks that touch, or touch a third, form an island; supports join nothing, because they don't move. A contact's columns
 * of Aeq have rows in one island only, so Aeq is block diagonal by islands and so are Aeq Aeq', the bilateral force f0, the
 * cones and the caps. Hence f balances p if and only if its share in each island balances the loads there, and dq is a
 * mechanism if one of its shares is (p.dq - sum c_v |P_K(u_v)| and what it is compared with are sums over islands; of two
 * ratios the mediant is no less than the smaller). So each is solved as a scene of its own, in the memory of the largest; the
 * worst verdict is that of the whole, and the evidence, put together, is judged on the whole as ever. The same of a coupled check:
 * its conditions are of one vertex each, so triples of all islands are one of the whole, whose shares are triples; with eps and eta
 * of the whole. What refutes an island refutes the whole, and is judged on that island alone. */

typedef struct sp__islands {
    int32_t count;
    int32_t *label;                     /* per block: its island, by lowest block numbers; -1: a support */
    int32_t *rank, *row;                /* per block: number in its island's scene (0: the support there); row among free blocks */
    int32_t *block, *joint, *load;  /* of each island the first, -1: none */
    int32_t *next, *link, *hook;        /* the next block, joint, load of the same island, -1: none */
} sp__islands;

/* May islands be solved apart? Not on a budget, which the first of them might spend. */
static int sp__islands_apart(const sp_settings *set)
{
    return sp__plan_stages(set) && (!set || (set->effect[SP_EFFECT_TOGETHER] != SP_WITH && set->budget <= 0));
}

/* up: root of each free block's island.                                                      returns how many there are */
static int32_t sp__islands_join(const sp_scene *scene, int32_t *up)
{
    int32_t count = 0;
    for (int32_t i = 0; i < scene->count.blocks; i++) up[i] = i;
    for (int32_t k = 0; k < scene->count.joints; k++) {
        const sp_joint *f = &scene->joint[k];
        if (scene->block[f->a].fixed != SP_FIXED && scene->block[f->b].fixed != SP_FIXED) sp__join(up, f->a, f->b);
    }
    for (int32_t i = 0; i < scene->count.blocks; i++) count += scene->block[i].fixed != SP_FIXED && sp__root(up, i) == i;
    return count;
}

/* Islands that are told apart, 1 where they are not; the most contact vertices and free blocks of those that a proof may tell of. */
typedef struct sp__apart { int32_t islands, points, blocks; } sp__apart;

/* What each island has, by its root. */
SP__NOINLINE static void sp__islands_few(const sp_scene *scene, int32_t *up, int32_t *points, int32_t *blocks, sp__apart *o)
{
    const sp_capacity *n = &scene->count;
    o->points = o->blocks = 0;
    for (int32_t i = 0; i < n->blocks; i++) points[i] = blocks[i] = 0;
    for (int32_t k = 0; k < n->joints; k++) {
        const sp_joint *f = &scene->joint[k];
        if (sp__contact_counts(scene, f)) points[sp__root(up, scene->block[f->a].fixed != SP_FIXED ? f->a : f->b)] += f->points;
    }
    for (int32_t i = 0; i < n->blocks; i++) if (scene->block[i].fixed != SP_FIXED) blocks[sp__root(up, i)]++;
    for (int32_t i = 0; i < n->blocks; i++) {
        if (points[i] > SP_EXACT_POINTS || blocks[i] > SP_EXACT_POINTS) continue;
        if (points[i] > o->points) o->points = points[i];
        if (blocks[i] > o->blocks) o->blocks = blocks[i];
    }
}

/* How the blocks of a scene are solved.     returns SP_OK, SP_E_MEMORY: scratch too small */
static sp_status sp__islands_count(const sp_scene *scene, const sp_settings *set, sp_arena scratch, sp__apart *o)
{
    sp_problem pb;
    const size_t b = (size_t)scene->count.blocks;
    sp__problem_count(scene, &pb);
    o->islands = 1;
    o->points = sp__points_count(scene);
    o->blocks = pb.blocks;
    if (!sp__islands_apart(set)) return SP_OK;
    int32_t *up = sp__take(&scratch, b, sizeof *up), *points = sp__take(&scratch, b, sizeof *points);
    int32_t *blocks = sp__take(&scratch, b, sizeof *blocks);
    if (sp__failed(&scratch)) return SP_E_MEMORY;
    const int32_t count = sp__islands_join(scene, up);
    if (count < 2) return SP_OK;
    o->islands = count;
    sp__islands_few(scene, up, points, blocks, o);
    return SP_OK;
}

/* Tables for up to `count` islands. `label` (may be NULL) lies elsewhere. */
SP__NOINLINE static void sp__islands_carve(sp__islands *t, const sp_scene *scene, int32_t count, int32_t *label, sp_arena *a)
{
    const size_t b = (size_t)scene->count.blocks, n = (size_t)count;
    t->count = count;
    t->label = label ? label : sp__take(a, b, sizeof *t->label);
    t->rank = sp__take(a, b, sizeof *t->rank);
    t->row = sp__take(a, b, sizeof *t->row);
    t->next = sp__take(a, b, sizeof *t->next);
    t->link = sp__take(a, (size_t)scene->count.joints, sizeof *t->link);
    t->hook = sp__take(a, (size_t)scene->count.loads, sizeof *t->hook);
    t->block = sp__take(a, n, sizeof *t->block);
    t->joint = sp__take(a, n, sizeof *t->joint);
    t->load = sp__take(a, n, sizeof *t->load);
}

/* Item `k` in front of its island's list; supports (-1) are in none. */
static void sp__islands_put(int32_t island, int32_t k, int32_t *first, int32_t *next)
{
    if (island < 0) return;
    next[k] = first[island];
    first[island] = k;
}

/* The island of a joint: that of its free block. */
static int32_t sp__islands_joint(const sp_scene *scene, const sp__islands *t, int32_t k)
{
    const int32_t a = t->label[scene->joint[k].a];
    return a >= 0 ? a : t->label[scene->joint[k].b];
}

/* Labels by lowest block, lists in ascending order. */
SP__NOINLINE static void sp__islands_fill(const sp_scene *scene, const sp__islands *t)
{
    const sp_capacity *n = &scene->count;
    int32_t count = 0, row = 0;
    sp__islands_join(scene, t->rank);
    for (int32_t i = 0; i < n->blocks; i++) {
        const int32_t root = scene->block[i].fixed == SP_FIXED ? -1 : sp__root(t->rank, i);     /* root <= i */
        t->label[i] = root < 0 ? -1 : root == i ? count++ : t->label[root];
        t->row[i] = root < 0 ? -1 : row++;
    }
    for (int32_t k = 0; k < t->count; k++) t->block[k] = t->joint[k] = t->load[k] = -1;
    for (int32_t i = n->blocks - 1; i >= 0; i--) sp__islands_put(t->label[i], i, t->block, t->next);
    for (int32_t k = n->joints - 1; k >= 0; k--) sp__islands_put(sp__islands_joint(scene, t, k), k, t->joint, t->link);
    for (int32_t k = n->loads - 1; k >= 0; k--) sp__islands_put(t->label[scene->load[k].block], k, t->load, t->hook);
    for (int32_t i = 0; i < n->blocks; i++) t->rank[i] = 0;
    for (int32_t k = 0; k < t->count; k++) {
        int32_t rank = 0;
        for (int32_t i = t->block[k]; i >= 0; i = t->next[i]) t->rank[i] = ++rank;
    }
}

/* What island k has, with one support for all it rests on. */
static void sp__island_size(const sp_scene *scene, const sp__islands *t, int32_t k, sp_capacity *n)
{
    memset(n, 0, sizeof *n);
    n->blocks = 1;
    for (int32_t i = t->block[k]; i >= 0; i = t->next[i]) n->blocks++;
    for (int32_t q = t->joint[k]; q >= 0; q = t->link[q]) {
        n->joints++;
        n->points += scene->joint[q].points;
    }
    for (int32_t q = t->load[k]; q >= 0; q = t->hook[q]) n->loads++;
}

/* Island k as a scene of its own in `a`: one support, then its blocks (without meshes), joints and loads in their order.
 *     returns NULL when it does not fit */
SP__NOINLINE static sp_scene *sp__island_scene(const sp_scene *scene, const sp__islands *t, int32_t k, sp_arena *a)
{
    sp_scene *s = sp__take(a, 1, sizeof *s);
    if (!s) return NULL;
    *s = *scene;
    sp__island_size(scene, t, k, &s->cap);
    sp__scene_carve(s, a);
    if (sp__failed(a)) return NULL;
    s->count = s->cap;
    int32_t n = 0, points = 0;
    s->block[0] = scene->block[t->block[k]];            /* a support near by */
    s->block[0].fixed = SP_FIXED;
    for (int32_t i = t->block[k]; i >= 0; i = t->next[i]) s->block[t->rank[i]] = scene->block[i];
    for (int32_t i = 0; i < s->count.blocks; i++)
        s->block[i].vertex = s->block[i].vertices = s->block[i].face = s->block[i].faces = 0;
    for (int32_t q = t->joint[k]; q >= 0; q = t->link[q]) {
        sp_joint *f = &s->joint[n++];
        *f = scene->joint[q];
        memcpy(s->point + points, scene->point + f->point, (size_t)f->points * sizeof *s->point);
        f->a = t->rank[f->a];
        f->b = t->rank[f->b];
        f->point = points;
        points += f->points;
    }
    n = 0;
    for (int32_t q = t->load[k]; q >= 0; q = t->hook[q]) {
        s->load[n] = scene->load[q];
        s->load[n].block = t->rank[s->load[n].block];
        n++;
    }
    return s;
}

#endif

#endif /* SP__CHECK_PARTS_C */
