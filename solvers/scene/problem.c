/* problem: the equilibrium Aeq f + p = 0 of a scene's free blocks: rows (F, M about the centroid), contacts with frame and
 * lever arms, loads p. */
#ifndef SP__SCENE_PROBLEM_C
#define SP__SCENE_PROBLEM_C

#include "../base/vec3.c"

/* How exactly the bilateral force is solved for where it serves as a scale, by the search and by the certificate check. */
#ifdef SP_REAL_FLOAT
#define SP__SCALE_TOL ((sp_real)1e-4)
#else
#define SP__SCALE_TOL ((sp_real)1e-9)
#endif

/* A contact takes part if it touches a free block. */
static int sp__contact_counts(const sp_scene *scene, const sp_joint *f)
{
    return scene->block[f->a].fixed != SP_FIXED || scene->block[f->b].fixed != SP_FIXED;
}

/* Is there anything that counts scene.live times? */
static int sp__scene_live(const sp_scene *scene)
{
    for (int32_t k = 0; k < scene->count.loads; k++) if (scene->load[k].live) return 1;
    for (int k = 0; k < 3; k++) if (scene->body[k] < 0 || scene->body[k] > 0) return 1;
    return 0;
}

/* A vector of a joint's frame (n, t1, t2) in space, and back. */
static inline void sp__joint_force(const sp_joint *t, const sp_real f[3], sp_real F[3])
{
    sp__scale3(f[0], t->n, F);
    sp__add3(F, f[1], t->t1);
    sp__add3(F, f[2], t->t2);
}

/* d = (u.n, u.t1, u.t2); d may be u. */
static void sp__joint_frame(const sp_joint *t, const sp_real u[3], sp_real d[3])
{
    const sp_real x = sp__dot3(u, t->n), y = sp__dot3(u, t->t1), z = sp__dot3(u, t->t2);
    d[0] = x; d[1] = y; d[2] = z;
}

/* Contact vertices that take part. */
static int32_t sp__points_count(const sp_scene *scene)
{
    int32_t n = 0;
    for (int32_t k = 0; k < scene->count.joints; k++)
        if (sp__contact_counts(scene, &scene->joint[k])) n += scene->joint[k].points;
    return n;
}

/* Free blocks and contacts of a scene. */
static void sp__problem_count(const sp_scene *scene, sp_problem *problem)
{
    problem->scene = scene;
    problem->blocks = problem->contacts = 0;
    problem->points = scene->count.points;
    problem->point = scene->point;
    problem->keep_order = problem->ignore_strength = 0;
    for (int32_t k = 0; k < scene->count.blocks; k++)
        if (scene->block[k].fixed != SP_FIXED) problem->blocks++;
    for (int32_t k = 0; k < scene->count.joints; k++)
        if (sp__contact_counts(scene, &scene->joint[k])) problem->contacts++;
}

/* live: do some loads count scene.live times? */
static void sp__problem_carve(sp_problem *problem, int live, sp_arena *a)
{
    problem->block = sp__take(a, (size_t)problem->blocks, sizeof *problem->block);
    problem->contact = sp__take(a, (size_t)problem->contacts, sizeof *problem->contact);
    problem->local = sp__take(a, (size_t)problem->points, sizeof *problem->local);
    problem->p = sp__take(a, (size_t)problem->blocks, 6 * sizeof *problem->p);
    problem->live = NULL;
    if (live) problem->live = sp__take(a, (size_t)problem->blocks, 6 * sizeof *problem->live);
}

static size_t sp__problem_memory(const sp_scene *scene)
{
    sp_problem problem;
    sp_arena dry = sp__arena_dry();
    sp__problem_count(scene, &problem);
    sp__problem_carve(&problem, sp__scene_live(scene), &dry);
    return sp__failed(&dry) ? 0 : dry.used;
}

/* Row of a block of the scene among the free ones (their numbers ascend), -1: a support. */
static int32_t sp__problem_row(const sp_problem *problem, int32_t block)
{
    int32_t lo = 0, hi = problem->blocks;
    while (lo < hi) {
        const int32_t mid = lo + (hi - lo) / 2;
        if (problem->block[mid] < block) lo = mid + 1; else hi = mid;
    }
    return lo < problem->blocks && problem->block[lo] == block ? lo : -1;
}

/* Points of a contact from their mean, in its frame; the mean goes to `mean`, seen from the first point. Differences are taken
 * of neighbouring places only, so coordinates far from the origin lose nothing. */
static void sp__contact_local(const sp_problem *problem, const sp_contact *contact, sp_real mean[3])
{
    const sp_joint *f = contact->joint;
    const sp_real (*point)[3] = (const sp_real (*)[3])problem->point + contact->point;
    sp_real x[3];
    mean[0] = mean[1] = mean[2] = 0;
    for (int32_t k = 1; k < f->points; k++) {
        sp__sub3(point[k], point[0], x);
        sp__add3(mean, 1, x);
    }
    sp__scale3((sp_real)1 / (sp_real)f->points, mean, mean);
    for (int32_t k = 0; k < f->points; k++) {
        sp_real *local = problem->local[contact->point + k];
        sp__sub3(point[k], point[0], x);
        sp__sub3(x, mean, x);
        sp__joint_frame(f, x, local);
    }
}

/* The contact of a joint, its rows and vertices known: frame, arms (first point - centroid) + (mean - first point). */
static sp_status sp__contact_build(const sp_problem *problem, int32_t id, sp_contact *contact)
{
    const sp_scene *scene = problem->scene;
    const sp_joint *f = &scene->joint[id];
    contact->id = id;
    contact->points = f->points;
    contact->joint = f;
    sp_real mean[3];
    sp__contact_local(problem, contact, mean);
    const sp_real *first = scene->point[f->point], *ca = scene->block[f->a].centroid, *cb = scene->block[f->b].centroid;
    sp__sub3(first, ca, contact->ra);
    sp__add3(contact->ra, 1, mean);
    sp__sub3(first, cb, contact->rb);
    sp__add3(contact->rb, 1, mean);
    sp_real size = sp__dot3(contact->ra, contact->ra) + sp__dot3(contact->rb, contact->rb);
    for (int32_t v = contact->point; v < contact->point + contact->points; v++)
        size += sp__dot3(problem->local[v], problem->local[v]);
    return sp__finite(size) ? SP_OK : SP_E_NOT_FINITE;
}

/* p += (F, r x F), F = times x f at r from the centroid. */
static void sp__load_add(sp_real *p, sp_real times, const sp_real f[3], const sp_real r[3])
{
    sp_real F[3];
    sp__scale3(times, f, F);
    sp__cross3_add(r, F, p + 3);
    sp__add3(p, 1, F);
}

/* One load: what always acts goes to p, what counts scene.live times to problem.live. */
static void sp__problem_load(const sp_problem *problem, const sp_load *load, int32_t row)
{
    const sp_scene *scene = problem->scene;
    sp_real *p = problem->p + 6 * (size_t)row, *live = problem->live ? problem->live + 6 * (size_t)row : p;
    sp_real *own = load->live ? live : p, r[3];
    sp__sub3(load->point, scene->block[load->block].centroid, r);
    sp__load_add(own, 1, load->force, r);
    sp__load_add(own, load->mass, scene->gravity, r);
    sp__load_add(live, load->mass, scene->body, r);
    sp__add3(own + 3, 1, load->couple);
}

/* Clear q = (F, M) of a block where its terms cancel but for rounding: its weight, `share` times this load, and others. Each
 * component of the force is compared with its own terms, for a push sideways hides no weight. Nor does a load so large that the
 * weight is less than its rounding: then what is left may be the weight. A point is known no better than its place.
 *   g: what the load's mass weighs by, `share` times [m/s^2]
 *   own: acceleration of the block and of all masses on it [m/s^2] */
static void sp__load_clear_rounding(sp_real *q, const sp_load *load, sp_real share, const sp_real g[3], const sp_real own[3],
                                    const sp_block *block)
{
    const sp_real noise = 16 * (sp_real)SP_EPSILON, reach = (sp__norm3(load->point) + sp__norm3(block->centroid)) / 4;
    sp_real F[3];
    for (int k = 0; k < 3; k++) {
        const sp_real weight = sp__abs(own[k]) * block->mass;
        F[k] = share * (sp__abs(load->force[k]) + sp__abs(g[k]) * load->mass) + sp__abs(own[k]) * load->mass + weight;
        if (sp__abs(q[k]) > noise * F[k] || (weight > 0 && weight <= noise * F[k])) return;
    }
    memset(q, 0, 3 * sizeof *q);
    if (sp__norm3(q + 3) <= noise * (share * sp__norm3(load->couple) + sp__norm3(F) * reach)) memset(q + 3, 0, 3 * sizeof *q);
}

/* Apply sp__load_clear_rounding to every sum that this load is part of. SP_SMALL ignores live accelerations here, and live
 * loads that cancel each other. */
static void sp__load_clear_sums(const sp_problem *problem, const sp_load *load, int32_t row)
{
    const sp_scene *scene = problem->scene;
    const sp_block *block = &scene->block[load->block];
    const sp_real times = sp__abs(scene->live);
    const sp_real *own = scene->gravity;
    sp_real both[3];
    if (SP__HAS_STRENGTH) {
        for (int k = 0; k < 3; k++) both[k] = sp__abs(own[k]) + times * sp__abs(scene->body[k]);
        own = both;
    }
    sp__load_clear_rounding(problem->p + 6 * (size_t)row, load, load->live ? times : 1, scene->gravity, own, block);
    if (SP__HAS_STRENGTH && problem->live && load->live)
        sp__load_clear_rounding(problem->live + 6 * (size_t)row, load, 1, scene->gravity, scene->body, block);
}

/* p = 0, and the live loads, before anything is added to them. */
static sp_status sp__problem_clear(const sp_problem *problem)
{
    const sp_scene *scene = problem->scene;
    if (!sp__finite(scene->live) || !sp__finite3(scene->gravity) || !sp__finite3(scene->body)) return SP_E_NOT_FINITE;
    memset(problem->p, 0, (size_t)problem->blocks * 6 * sizeof *problem->p);
    if (problem->live) memset(problem->live, 0, (size_t)problem->blocks * 6 * sizeof *problem->live);
    return SP_OK;
}

/* p += weight + live multiple x live loads, after the loads: what they sum to may be less than their rounding, and hides no
 * weight then. */
static sp_status sp__problem_sum(const sp_problem *problem)
{
    const sp_scene *scene = problem->scene;
    sp_real *p = problem->p, *live = problem->live;
    for (int32_t i = 0; i < problem->blocks; i++, p += 6) {
        const sp_real mass = scene->block[problem->block[i]].mass;
        sp__add3(p, mass, scene->gravity);
        if (live) {
            sp__add3(live, mass, scene->body);
            for (int k = 0; k < 6; k++) p[k] += scene->live * *live++;
        }
        for (int k = 0; k < 6; k++) if (!sp__finite(p[k] * p[k])) return SP_E_NOT_FINITE;
    }
    return SP_OK;
}

/* Some loads of the scene, one after the other, and where their blocks are: those of a part need not ascend. */
typedef struct sp__load_list {
    int32_t first;                      /* -1: none */
    const int32_t *next, *row;          /* after each load, -1: none; row of each block. NULL: all loads, blocks that ascend */
} sp__load_list;

static int32_t sp__load_after(const sp_problem *problem, const sp__load_list *list, int32_t k)
{
    return list->next ? list->next[k] : k + 1 < problem->scene->count.loads ? k + 1 : -1;
}

static int32_t sp__load_row(const sp_problem *problem, const sp__load_list *list, int32_t k)
{
    const int32_t block = problem->scene->load[k].block;
    return list->row ? list->row[block] : sp__problem_row(problem, block);
}

/* Add the loads, large ones first, those a thousandfold apart at most together: what is left where large ones cancel hides no
 * small one then. */
static void sp__loads_add(const sp_problem *problem, const sp__load_list *list)
{
    const sp_load *load = problem->scene->load;
    sp_real most = SP__HUGE, high = 0;                  /* 0: none is too large yet */
    while (most > 0) {
        const sp_real low = most / 1000;
        most = 0;
        for (int32_t k = list->first; k >= 0; k = sp__load_after(problem, list, k)) {
            const sp_real size = sp__norm3(load[k].force) + sp__norm3(load[k].couple) + load[k].mass;
            const int32_t row = sp__load_row(problem, list, k);
            if (row < 0) continue;
            if (size < low) most = sp__max(most, size);
            else if (!(high > 0) || size < high) sp__problem_load(problem, &load[k], row);
        }
        high = low;
    }
}

/* p = weight + loads + live multiple x live ones; a held direction keeps its row, whoever solves masks it. */
static sp_status sp__problem_loads(const sp_problem *problem, const sp__load_list *list)
{
    sp_status status = sp__problem_clear(problem);
    if (status) return status;
    sp__loads_add(problem, list);
    status = sp__problem_sum(problem);
    if (status) return status;
    for (int32_t k = list->first; k >= 0; k = sp__load_after(problem, list, k)) {
        const int32_t row = sp__load_row(problem, list, k);
        if (row >= 0) sp__load_clear_sums(problem, &problem->scene->load[k], row);
    }
    return SP_OK;
}

/* Loads and contacts, everything relative to the centroids. */
static sp_status sp__problem_fill(sp_problem *problem)
{
    const sp_scene *scene = problem->scene;
    int32_t row = 0, contact = 0;
    for (int32_t k = 0; k < scene->count.blocks; k++) if (scene->block[k].fixed != SP_FIXED) problem->block[row++] = k;
    const sp__load_list all = { scene->count.loads ? 0 : -1, NULL, NULL };
    const sp_status status = sp__problem_loads(problem, &all);
    if (status) return status;
    memset(problem->local, 0, (size_t)problem->points * sizeof *problem->local);
    for (int32_t k = 0; k < scene->count.joints; k++) {
        if (!sp__contact_counts(scene, &scene->joint[k])) continue;
        sp_contact *c = &problem->contact[contact++];
        c->a = sp__problem_row(problem, scene->joint[k].a);
        c->b = sp__problem_row(problem, scene->joint[k].b);
        c->point = scene->joint[k].point;
        const sp_status contact_status = sp__contact_build(problem, k, c);
        if (contact_status) return contact_status;
    }
    return SP_OK;
}

SP_API sp_status sp_problem_build(const sp_scene *scene, sp_arena *arena, sp_problem *problem)
{
    if (!scene || !arena || !arena->base || !problem) return SP_E_ARGUMENT;
    if (scene->count.blocks == 0) return SP_E_EMPTY;
    sp_arena a = *arena;
    sp_problem made;
    sp__problem_count(scene, &made);
    sp__problem_carve(&made, sp__scene_live(scene), &a);
    if (sp__failed(&a)) return SP_E_MEMORY;
    const sp_status status = sp__problem_fill(&made);
    if (status) return status;
    *arena = a;
    *problem = made;
    return SP_OK;
}

/* A unit of force in which no square over- or underflows: the largest component of a load, of a couple where there are none. */
static sp_real sp__load_unit(const sp_problem *pb)
{
    sp_real force = 0, couple = 0;
    const sp_real *p = pb->p;
    for (int32_t i = 0; i < pb->blocks; i++, p += 3)
        for (int k = 0; k < 3; k++, p++) {
            force = sp__max(force, sp__abs(p[0]));
            couple = sp__max(couple, sp__abs(p[3]));
        }
    return force > 0 ? force : couple > 0 ? couple : 1;
}

/* Newtons (N m, N/m: whatever is in proportion to force) in units of force, x = f / unit, and back, f = x unit: one number, or
 * n of them, where x may be f. Nowhere else is a force multiplied or divided by a unit. A few places have always multiplied by
 * what one newton is in units; they still do, for the digits. */
static sp_real sp__in_units(sp_real unit, sp_real f) { return f / unit; }

static sp_real sp__in_newtons(sp_real unit, sp_real x) { return x * unit; }

static void sp__to_units(sp_real unit, size_t n, const sp_real *f, sp_real *x)
{
    for (size_t k = 0; k < n; k++) x[k] = sp__in_units(unit, f[k]);
}

static void sp__to_newtons(sp_real unit, size_t n, const sp_real *x, sp_real *f)
{
    for (size_t k = 0; k < n; k++) f[k] = sp__in_newtons(unit, x[k]);
}

/* The lesser of a number each free block has, of the one or two at a contact; stride: numbers per block in s. */
static sp_real sp__least_of_blocks(const sp_contact *t, const sp_real *s, size_t stride)
{
    if (t->a < 0) return s[stride * (size_t)t->b];
    if (t->b < 0) return s[stride * (size_t)t->a];
    const sp_real a = s[stride * (size_t)t->a], b = s[stride * (size_t)t->b];
    return a < b ? a : b;
}

/* Is free block i held in direction k? */
static int sp__held(const sp_problem *pb, int32_t i, int k)
{
    return (int)(pb->scene->block[pb->block[i]].fixed >> k & 1u);
}

/* Zero in a row of block i the directions in which it is held: forces there are the support's, motions none. */
static void sp__drop_held(const sp_problem *pb, int32_t i, sp_real row[6])
{
    for (uint32_t held = pb->scene->block[pb->block[i]].fixed & SP_FIXED; held; held >>= 1, row++) if (held & 1u) *row = 0;
}

/* r_v - c_i for a free block i, zero for a support. */
static inline void sp__arm(const sp_problem *pb, int32_t i, int32_t v, sp_real arm[3])
{
    arm[0] = arm[1] = arm[2] = 0;
    if (i >= 0) sp__sub3(pb->point[v], pb->scene->block[pb->block[i]].centroid, arm);
}

#endif /* SP__SCENE_PROBLEM_C */
