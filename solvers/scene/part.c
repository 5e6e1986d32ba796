/* part: some of a scene's free blocks with the joints and loads on them; a scene's islands.
 *
 * A part is a view: lists of numbers in the scene. A problem is made of it straight from the scene, its blocks, contacts and
 * vertices numbered compactly; what is found about it is written at the scene's numbers. Whatever else its blocks touch is a
 * support, because only free blocks have rows.
 */
#ifndef SP__SCENE_PART_C
#define SP__SCENE_PART_C

#include "../base/groups.c"
#include "problem.c"

#if SP__WITH_LARGE

typedef struct sp__part {
    int32_t block, joint, load;                             /* the first of each in the scene, -1: none */
    const int32_t *block_next, *joint_next, *load_next;     /* after each the next, -1: none */
    const int32_t *row;                                     /* per block of the scene: row in the part, -1: it has none */
} sp__part;

/* Counts a part's blocks, contacts and vertices into pb; takes no memory. */
static void sp__part_count(const sp_scene *scene, const sp__part *part, sp_problem *pb)
{
    memset(pb, 0, sizeof *pb);
    pb->scene = scene;
    for (int32_t i = part->block; i >= 0; i = part->block_next[i]) pb->blocks++;
    for (int32_t k = part->joint; k >= 0; k = part->joint_next[k]) {
        pb->contacts++;
        pb->points += scene->joint[k].points;
    }
}

/* Room for what was counted.     live: do some of its loads count scene.live times? */
static void sp__part_carve(sp_problem *pb, int live, sp_arena *a)
{
    sp__problem_carve(pb, live, a);
    pb->point = sp__take(a, (size_t)pb->points, sizeof *pb->point);
}

/* Has the part live loads, or the scene an acceleration that is one? */
static int sp__part_live(const sp_scene *scene, const sp__part *part)
{
    int live = 0;
    for (int k = 0; k < 3; k++) live |= scene->body[k] < 0 || scene->body[k] > 0;
    for (int32_t k = part->load; k >= 0; k = part->load_next[k]) live |= scene->load[k].live != 0;
    return live;
}

/* Its contacts, vertices copied so that they stand one after the other. */
static sp_status sp__part_contacts(const sp__part *part, const sp_problem *pb)
{
    sp_contact *t = pb->contact;
    int32_t points = 0;
    for (int32_t k = part->joint; k >= 0; k = part->joint_next[k], t++) {
        const sp_joint *f = &pb->scene->joint[k];
        memcpy(pb->point + points, pb->scene->point + f->point, (size_t)f->points * sizeof *pb->point);
        t->a = part->row[f->a];
        t->b = part->row[f->b];
        t->point = points;
        points += f->points;
        const sp_status status = sp__contact_build(pb, k, t);
        if (status) return status;
    }
    return SP_OK;
}

/* The problem of a part.     returns SP_OK, SP_E_NOT_FINITE, SP_E_MEMORY */
SP__NOINLINE static sp_status sp__part_build(const sp_scene *scene, const sp__part *part, sp_arena *a, sp_problem *pb)
{
    int32_t row = 0;
    sp__part_count(scene, part, pb);
    sp__part_carve(pb, sp__part_live(scene, part), a);
    if (sp__failed(a)) return SP_E_MEMORY;
    for (int32_t i = part->block; i >= 0; i = part->block_next[i]) pb->block[row++] = i;
    const sp__load_list loads = { part->load, part->load_next, part->row };
    const sp_status status = sp__problem_loads(pb, &loads);
    return status ? status : sp__part_contacts(part, pb);
}

/* Bytes of a part's problem that is built, or was. */
static size_t sp__part_bytes(const sp_problem *pb)
{
    sp_problem count = *pb;
    sp_arena dry = sp__arena_dry();
    sp__part_carve(&count, pb->live != NULL, &dry);
    return dry.used;
}

/* Contact vertices of a problem; pb.points of a whole scene counts those between supports, too. */
static int32_t sp__problem_points(const sp_problem *pb)
{
    int32_t n = 0;
    for (int32_t c = 0; c < pb->contacts; c++) n += pb->contact[c].points;
    return n;
}

/* `width` numbers of each vertex of a problem to where the scene has them. */
static void sp__points_write(const sp_problem *pb, size_t width, const sp_real *of, sp_real *scene)
{
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        memmove(scene + width * (size_t)t->joint->point, of + width * (size_t)t->point, width * (size_t)t->points * sizeof *of);
    }
}

#if SP__WITH_COUPLED
/* `width` numbers of each vertex of a problem from where the scene has them. */
static void sp__points_read(const sp_problem *pb, size_t width, const sp_real *scene, sp_real *of)
{
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        memmove(of + width * (size_t)t->point, scene + width * (size_t)t->joint->point, width * (size_t)t->points * sizeof *of);
    }
}
#endif

/* Free blocks that touch, or touch a third, form an island; supports join nothing, because they don't move. A contact's columns
 * of Aeq have rows in one island only, so Aeq is block diagonal by islands and so are Aeq Aeq', the bilateral force f0, the
 * cones and the caps. Hence f balances p if and only if its share in each island balances the loads there, and dq is a
 * mechanism if one of its shares is (p.dq - sum c_v |P_K(u_v)| and what it is compared with are sums over islands; of two
 * ratios the mediant is no less than the smaller). So each is solved and certified as a part, in the memory of the largest, and
 * the worst verdict is that of the whole. The evidence, put together, is certified once more on the whole; only forces that
 * balance every island within 0.999 tol are not, because the sums of the whole are theirs (check/islands.c).
 *
 * The same holds for a coupled check. Its conditions are of one vertex each, so triples of all islands are a triple of the
 * whole and its shares are triples of the islands, with eps and eta of the whole. What refutes an island refutes the whole, and
 * is certified on that island alone. */

typedef struct sp__islands {
    int32_t count;
    int32_t *label;                             /* per block: its island, by lowest block numbers; -1: a support */
    int32_t *row, *rank;                        /* per block: row in its island, row among all free blocks, -1: a support */
    int32_t *block, *joint, *load;              /* of each island the first, -1: none */
    int32_t *block_next, *joint_next, *load_next;   /* the next one of the same island, -1: none */
} sp__islands;

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

/* How many islands a scene is solved in; the most vertices and blocks of those small enough for a proof of no triple. */
typedef struct sp__island_counts { int32_t islands, points, blocks; } sp__island_counts;

/* The most that a proof may have to deal with; `up` labels islands, `points` and `blocks` are scratch, a number per block. */
SP__NOINLINE static void sp__islands_proof_size(const sp_scene *scene, int32_t *up, int32_t *points, int32_t *blocks,
                                                sp__island_counts *o)
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

/* Tables for up to `count` islands. `label` (may be NULL) is memory of the caller. */
SP__NOINLINE static void sp__islands_carve(sp__islands *t, const sp_scene *scene, int32_t count, int32_t *label, sp_arena *a)
{
    const size_t b = (size_t)scene->count.blocks, n = (size_t)count;
    t->count = count;
    t->label = label ? label : sp__take(a, b, sizeof *t->label);
    t->row = sp__take(a, b, sizeof *t->row);
    t->rank = sp__take(a, b, sizeof *t->rank);
    t->block_next = sp__take(a, b, sizeof *t->block_next);
    t->joint_next = sp__take(a, (size_t)scene->count.joints, sizeof *t->joint_next);
    t->load_next = sp__take(a, (size_t)scene->count.loads, sizeof *t->load_next);
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
    int32_t count = 0, rank = 0;
    sp__islands_join(scene, t->row);
    for (int32_t i = 0; i < n->blocks; i++) {
        const int32_t root = scene->block[i].fixed == SP_FIXED ? -1 : sp__root(t->row, i);      /* root <= i */
        t->label[i] = root < 0 ? -1 : root == i ? count++ : t->label[root];
        t->rank[i] = root < 0 ? -1 : rank++;
    }
    for (int32_t k = 0; k < t->count; k++) t->block[k] = t->joint[k] = t->load[k] = -1;
    for (int32_t i = n->blocks - 1; i >= 0; i--) sp__islands_put(t->label[i], i, t->block, t->block_next);
    for (int32_t k = n->joints - 1; k >= 0; k--) sp__islands_put(sp__islands_joint(scene, t, k), k, t->joint, t->joint_next);
    for (int32_t k = n->loads - 1; k >= 0; k--) sp__islands_put(t->label[scene->load[k].block], k, t->load, t->load_next);
    for (int32_t i = 0; i < n->blocks; i++) t->row[i] = -1;
    for (int32_t k = 0; k < t->count; k++) {
        int32_t row = 0;
        for (int32_t i = t->block[k]; i >= 0; i = t->block_next[i]) t->row[i] = row++;
    }
}

/* Island k as a part. */
static sp__part sp__islands_part(const sp__islands *t, int32_t k)
{
    const sp__part part = { t->block[k], t->joint[k], t->load[k], t->block_next, t->joint_next, t->load_next, t->row };
    return part;
}

#endif

#endif /* SP__SCENE_PART_C */
