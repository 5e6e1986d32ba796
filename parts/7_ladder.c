/* 8 ---------------------------------------------------------------------------------------------------------- penalty form
 *
 * min 1/2 sum (fp^2 + gamma fm^2 + tau |ft|^2), Aeq f + p = 0, |ft| <= mu fp: tension at a price, so it always has a solution
 * and shows where help is wanted. It does not decide: a finite gamma buys a little tension even where none is needed.
 *                                                                                            [seed 1.5; Kao 2022, Eq. 14] */

static void sp__penalty_demand(sp__dual *w, sp_demand *demand)
{
    for (int32_t c = 0; c < w->pb->contacts; c++) {
        const sp_contact *t = &w->pb->contact[c];
        sp_demand *o = &demand[t->id];
        sp_real V[3], W[3];
        sp__dual_twist(w, t, w->y, V, W);
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            sp_real u[3], f[3];
            sp__dual_rate(w, V, W, w->pb->local[v], u);
            sp__dual_force(w, c, u, f);
            const sp_real slip = SP_SQRT(f[1] * f[1] + f[2] * f[2]) - t->joint->joint.mu * sp__max(0, f[0]);
            o->tension = sp__max(o->tension, -f[0] * w->unit);
            o->friction = sp__max(o->friction, slip * w->unit);
        }
    }
}

static sp_status sp__penalty_run(const sp_problem *pb, const sp_settings *set, sp_state *state, sp_arena *arena, sp_demand *demand)
{
    sp__newton n = { 0, 0, 0, SP__HUGE, sp__max(set->tol, 16 * SP__SCALE_TOL), 40, 1 };   /* proved: no proofs are sought */
    sp__dual *w = sp__dual_open(pb, set, SP__PENALTY, &state->cost, arena);
    if (!w) return SP_E_MEMORY;
    sp__dual_bilateral(w);
    sp__dual_sizes(w, w->y);
    if (sp__dual_metric(w)) sp__dual_bilateral(w);
    sp__newton_look(w, &n, state);
    n.shift = SP__SHIFT;
    while (n.left > 0 && n.omega > n.goal) sp__newton_step(w, &n, state);
    sp__penalty_demand(w, demand);
    return SP_OK;
}

/* 9 ---------------------------------------------------------------------------------------------------------- ladder */

SP_API sp_settings sp_settings_default(void)
{
    sp_settings s;
    memset(&s, 0, sizeof s);
#ifdef SP_REAL_FLOAT
    s.tol = (sp_real)1e-4;
#else
    s.tol = (sp_real)1e-9;
#endif
    s.inscribed = 1;
    s.gamma = 1000;
    s.tau = 1;
    s.localise = 1;
    s.iterations = 300;
    s.stage_count = 2;
    s.stage[0] = SP_STAGE_GATES;
    s.stage[1] = SP_STAGE_EXACT;
    return s;
}

/* The caller's settings, checked and with the automatic values filled in. */
static sp_status sp__settings_resolve(const sp_settings *in, sp_settings *out)
{
    *out = in ? *in : sp_settings_default();
    if (!(out->tol >= 4 * (sp_real)SP_EPSILON && out->tol <= (sp_real)0.1)) return SP_E_RANGE;
    if (!sp__finite(out->force_bound) || out->force_bound < 0) return SP_E_RANGE;
    if (out->faces && (out->faces < 3 || out->faces > 64)) return SP_E_RANGE;
    if (!(out->gamma > 0) || !(out->tau > 0) || !sp__finite(out->gamma) || !sp__finite(out->tau)) return SP_E_RANGE;
    if (out->iterations < 0 || out->stage_count < 1 || out->stage_count > SP_STAGES_MAX) return SP_E_RANGE;
    for (int32_t k = 0; k < out->stage_count; k++) {
        if (out->stage[k] <= SP_STAGE_NONE || out->stage[k] > SP_STAGE_CUSTOM) return SP_E_ARGUMENT;
        if (out->stage[k] == SP_STAGE_CUSTOM && (!out->custom || !out->custom->run || !out->custom->need)) return SP_E_ARGUMENT;
    }
    const sp_real most = out->tol / (10 * (sp_real)SP_EPSILON);
    if (!(out->force_bound > 0)) out->force_bound = most < (sp_real)1e6 ? most : (sp_real)1e6;
    return SP_OK;
}

static sp_stage sp__stage(const sp_settings *set, sp_stage_id id)
{
    sp_stage s = { sp__exact_run, sp__sparse_need };
    if (id == SP_STAGE_GATES) { s.run = sp__gates_run; s.need = sp__gates_need; }
    if (id == SP_STAGE_LEAST_SQUARES) s.run = sp__least_squares_run;
    if (id == SP_STAGE_DENSE) { s.run = sp__dense_run; s.need = sp__dense_need; }
    if (id == SP_STAGE_POLISH) s.run = sp__polish_run;
    if (id == SP_STAGE_CUSTOM) s = *set->custom;
    return s;
}

/* What a check keeps: the result's arrays, which stay, then the problem and the state, which go. */
static void sp__result_carve(sp_result *r, const sp_scene *scene, int32_t free_blocks, sp_arena *a)
{
    r->f = sp__take(a, (size_t)scene->count.points, 3 * sizeof *r->f);
    r->dq = sp__take(a, (size_t)scene->count.blocks, 6 * sizeof *r->dq);
    r->y0 = sp__take(a, (size_t)free_blocks, 6 * sizeof *r->y0);
    r->demand = sp__take(a, (size_t)scene->count.interfaces, sizeof *r->demand);
}

static void sp__state_carve(sp_state *s, int32_t free_blocks, sp_arena *a)
{
    s->y = sp__take(a, (size_t)free_blocks, 6 * sizeof *s->y);
}

static size_t sp__judge_need(const sp_problem *pb, const sp_settings *set)
{
    sp__judge j;
    sp_arena dry = sp__arena_dry();
    sp__judge_carve(&j, pb, set->faces, &dry);
    return dry.peak;
}

/* What a check works on; lies in the arena, behind what it keeps, because it is too large for a small stack. */
typedef struct sp__check {
    sp_settings set;
    sp_problem pb;
    sp_state state;
    sp_result r;
} sp__check;

SP_API size_t sp_memory_scratch(const sp_scene *scene)
{
    if (!scene) return 0;
    sp_problem pb;
    sp__problem_count(scene, &pb);
    return sizeof(sp__check) + SP_ALIGN + sp_problem_memory(scene) + SP_ALIGN + sp__dual_scratch(&pb);
}

/* The largest need of the chosen stages and of what judges them, SIZE_MAX: scratch too small. */
static size_t sp__stages_need(const sp_problem *pb, const sp_settings *set, sp_arena scratch)
{
    size_t most = sp__judge_need(pb, set);
    for (int32_t k = 0; k <= set->stage_count && pb->blocks; k++) {
        if (k == set->stage_count && !set->localise) break;
        const size_t need = k < set->stage_count ? sp__stage(set, set->stage[k]).need(pb, set, scratch)
                                                 : sp__sparse_need(pb, set, scratch);
        if (need > most) most = need;
    }
    return most;
}

SP_API sp_status sp_memory(const sp_scene *scene, const sp_settings *settings, sp_arena scratch, size_t *bytes)
{
    if (!scene || !bytes || !scratch.base) return SP_E_ARGUMENT;
    if (scene->count.blocks < 1) return SP_E_EMPTY;
    sp__check *c = sp__take(&scratch, 1, sizeof *c);
    if (!c) return SP_E_MEMORY;
    sp_status status = sp__settings_resolve(settings, &c->set);
    if (!status) status = sp_problem_build(scene, &scratch, &c->pb);
    if (status) return status;
    const size_t most = sp__stages_need(&c->pb, &c->set, scratch);
    if (most == SIZE_MAX) return SP_E_MEMORY;
    sp_arena dry = sp__arena_dry();
    sp__result_carve(&c->r, scene, c->pb.blocks, &dry);
    sp__take(&dry, 1, sizeof *c);
    sp__take(&dry, 1, sp_problem_memory(scene));
    sp__state_carve(&c->state, c->pb.blocks, &dry);
    sp__take(&dry, 1, most);
    *bytes = dry.used;
    return SP_OK;
}

/* The state's evidence into the result, as the judge sees it.     returns whether it proves the claim */
static int sp__check_judge(sp__judge *j, sp_state *state, sp_verdict claim, sp_result *r)
{
    const sp_problem *pb = j->pb;
    int32_t final = 0;
    r->omega = sp__judge_forces(j, state->f, state->f);
    if (claim == SP_STABLE) return r->omega <= r->tol;
    if (claim != SP_UNSTABLE) return 0;
    const sp_real proof = sp__judge_mechanism(j, state->dq, &final);
    if (!(proof > r->tol)) return 0;
    sp_real largest = 0, block = 0;
    for (int32_t i = 0; i < pb->blocks; i++) block = sp__max(block, j->scale[i].arm);
    if (!(block > 0)) block = 1;
    for (int32_t i = 0; i < pb->blocks; i++) {
        const sp_real *m = j->x + 6 * (size_t)i;
        largest = sp__max(largest, sp__max(sp__norm3(m) / block, sp__norm3(m + 3) * j->scale[i].arm / block));
    }
    memset(r->dq, 0, 6 * (size_t)pb->scene->count.blocks * sizeof *r->dq);
    for (int32_t i = 0; i < pb->blocks; i++)
        for (size_t k = 0; k < 6; k++) r->dq[6 * (size_t)pb->block[i] + k] = j->x[6 * (size_t)i + k] / largest;
    r->least_imbalance = proof;
    r->final = final;
    return 1;
}

static void sp__cost_add(sp_cost *to, const sp_cost *c)
{
    to->flops += c->flops;
    to->factorisations += c->factorisations;
    to->iterations += c->iterations;
}

/* One stage and the judgement of what it found.     *done: the check is decided */
static sp_status sp__check_stage(const sp_problem *pb, const sp_settings *set, int32_t k, sp_state *state, sp_arena *a,
                                 sp_result *r, int *done)
{
    sp_verdict claim = SP_UNDECIDED;
    const size_t mark = a->used;
    memset(&state->cost, 0, sizeof state->cost);
    const sp_status status = sp__stage(set, set->stage[k]).run(pb, set, state, a, &claim);
    if (status) return status;
    a->used = mark;
    const int last = k + 1 == set->stage_count;
    if (claim || last) {
        sp__judge j;
        const int settled = sp__judge_open(&j, pb, set, state->has_y0 ? state->y0 : NULL, a);
        if (sp__failed(a)) return SP_E_MEMORY;
        *done = sp__check_judge(&j, state, claim, r) && settled;
        a->used = mark;
        state->cost.flops += 90 * (int64_t)j.sweeps * pb->points;
        r->verdict = *done ? claim : SP_UNDECIDED;
        if (*done) {
            r->stage = set->stage[k];
            r->reason = claim == SP_STABLE && state->reason != SP_REASON_NOTHING ? SP_REASON_FORCES : state->reason;
            r->verified = 1;
        }
        if (!*done && last) r->reason = set->stage[k] == SP_STAGE_EXACT && claim ? SP_REASON_LIMIT : state->reason;
    }
    r->by_stage[k] = state->cost;
    sp__cost_add(&r->cost, &state->cost);
    return SP_OK;
}

/* 9 --------------------------------------------------------------------------------------------------- reading a result */

SP_API sp_status sp_interface_resultant(const sp_scene *scene, const sp_result *result, int32_t interface,
                                        sp_interface_force *out)
{
    if (!scene || !result || !result->f || !out) return SP_E_ARGUMENT;
    if (interface < 0 || interface >= scene->count.interfaces) return SP_E_INDEX;
    const sp_interface *t = &scene->interface[interface];
    sp_interface_force o;
    sp_real sum[3] = { 0, 0, 0 };
    memset(&o, 0, sizeof o);
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        const sp_real *f = result->f + 3 * (size_t)v;
        const int first = v == t->point;
        for (int k = 0; k < 3; k++) sum[k] += f[k];
        if (first || f[0] < o.min_fn) o.min_fn = f[0];
        if (first || f[0] > o.max_fn) o.max_fn = f[0];
    }
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        const sp_real share = sum[0] > 0 ? result->f[3 * (size_t)v] / sum[0] : 1 / (sp_real)t->points;
        for (int k = 0; k < 3; k++) o.point[k] += share * (scene->point[v][k] - scene->point[t->point][k]);
    }
    for (int k = 0; k < 3; k++) {
        o.point[k] += scene->point[t->point][k];
        o.force[k] = sum[0] * t->n[k] + sum[1] * t->t1[k] + sum[2] * t->t2[k];
    }
    const sp_real slip = SP_SQRT(sum[1] * sum[1] + sum[2] * sum[2]);
    o.utilisation = slip > 0 ? sp__ratio(slip, t->joint.mu * sum[0]) : 0;
    *out = o;
    return SP_OK;
}

SP_API sp_status sp_block_resultant(const sp_scene *scene, const sp_result *result, int32_t block, sp_real force[3],
                                    sp_real moment[3])
{
    if (!scene || !result || !result->f || !force || !moment) return SP_E_ARGUMENT;
    if (block < 0 || block >= scene->count.blocks) return SP_E_INDEX;
    for (int k = 0; k < 3; k++) force[k] = moment[k] = 0;
    for (int32_t k = 0; k < scene->count.interfaces; k++) {
        const sp_interface *t = &scene->interface[k];
        if (t->a != block && t->b != block) continue;
        const sp_real sign = t->b == block ? (sp_real)1 : (sp_real)-1;
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            const sp_real *f = result->f + 3 * (size_t)v;
            sp_real F[3], arm[3], m[3];
            for (int q = 0; q < 3; q++) F[q] = sign * (f[0] * t->n[q] + f[1] * t->t1[q] + f[2] * t->t2[q]);
            sp__sub3(scene->point[v], scene->block[block].centroid, arm);
            sp__cross3(arm, F, m);
            for (int q = 0; q < 3; q++) { force[q] += F[q]; moment[q] += m[q]; }
        }
    }
    return SP_OK;
}

/* Reading the force state: extremes over the interfaces, and the weakest of them. */
static void sp__check_read(const sp_scene *scene, sp_result *r)
{
    sp_real worst = -1;
    int tension = 0;
    r->weakest = -1;
    for (int32_t k = 0; k < scene->count.interfaces; k++) {
        sp_interface_force f;
        if (!sp__contact_counts(scene, &scene->interface[k])) continue;
        sp_interface_resultant(scene, r, k, &f);
        r->max_compression = sp__max(r->max_compression, f.max_fn);
        r->max_tension = sp__max(r->max_tension, r->demand[k].tension);
        r->max_utilisation = sp__max(r->max_utilisation, f.utilisation);
    }
    const sp_real dust = 16 * SP__SCALE_TOL * r->max_compression;
    for (int32_t k = 0; k < scene->count.interfaces; k++) {
        sp_interface_force f;
        if (!sp__contact_counts(scene, &scene->interface[k])) continue;
        sp_interface_resultant(scene, r, k, &f);
        const int pulls = r->demand[k].tension > dust;
        const sp_real score = pulls ? r->demand[k].tension : f.utilisation;
        if (pulls > tension || (pulls == tension && score > worst)) { tension = pulls; worst = score; r->weakest = k; }
    }
}

/* The ladder of stages on a built problem, then the localisation where it does not stand. */
static sp_status sp__check_run(const sp_problem *pb, const sp_settings *set, sp_state *state, sp_arena *a, sp_result *r)
{
    int done = 0;
    for (int32_t k = 0; k < set->stage_count && !done; k++) {
        const sp_status status = sp__check_stage(pb, set, k, state, a, r, &done);
        if (status) return status;
    }
    if (r->verdict == SP_STABLE || !set->localise) return SP_OK;
    const size_t mark = a->used;
    memset(&state->cost, 0, sizeof state->cost);
    const sp_status status = sp__penalty_run(pb, set, state, a, r->demand);
    sp__cost_add(&r->cost, &state->cost);
    a->used = mark;
    return status;
}

/* An empty result of this problem in c->r, its arrays zero; the state's arrays with it. */
static void sp__check_clear(const sp_scene *scene, sp__check *c)
{
    sp_result *r = &c->r;
    const size_t b = (size_t)c->pb.blocks;
    memset(r->f, 0, 3 * (size_t)scene->count.points * sizeof *r->f);
    memset(r->dq, 0, 6 * (size_t)scene->count.blocks * sizeof *r->dq);
    memset(r->y0, 0, 6 * b * sizeof *r->y0);
    memset(r->demand, 0, (size_t)scene->count.interfaces * sizeof *r->demand);
    memset(c->state.y, 0, 6 * b * sizeof *c->state.y);
    c->state.f = r->f;
    c->state.y0 = r->y0;
    c->state.dq = r->dq;                                /* free blocks first; spread over the scene's once it is a proof */
    r->tol = c->set.tol;
    r->force_bound = c->set.force_bound;
    r->free_blocks = c->pb.blocks;
    r->interfaces = c->pb.contacts;
    for (int32_t k = 0; k < c->pb.contacts; k++) r->points += c->pb.contact[k].points;
    r->verdict = b ? SP_UNDECIDED : SP_STABLE;
    r->reason = b ? SP_REASON_STAGES : SP_REASON_NOTHING;
    r->verified = !b;
}

/* Everything of a check in arena `a`, which may be used up.     *out: where the result is found on SP_OK, *kept: end of its arrays */
static sp_status sp__check_build(const sp_scene *scene, const sp_settings *settings, sp_arena *a, sp__check **out, size_t *kept)
{
    sp_problem count;
    sp_result arrays;
    sp__problem_count(scene, &count);
    memset(&arrays, 0, sizeof arrays);
    sp__result_carve(&arrays, scene, count.blocks, a);
    *kept = a->used;
    sp__check *c = sp__take(a, 1, sizeof *c);
    if (!c) return SP_E_MEMORY;
    memset(c, 0, sizeof *c);
    c->r = arrays;
    sp_status status = sp__settings_resolve(settings, &c->set);
    if (!status) status = sp_problem_build(scene, a, &c->pb);
    if (status) return status;
    sp__state_carve(&c->state, c->pb.blocks, a);
    if (sp__failed(a)) return SP_E_MEMORY;
    sp__check_clear(scene, c);
    *out = c;
    return SP_OK;
}

SP_API sp_status sp_check(const sp_scene *scene, const sp_settings *settings, sp_arena *arena, sp_result *result)
{
    if (!scene || !arena || !arena->base || !result) return SP_E_ARGUMENT;
    if (scene->count.blocks < 1) return SP_E_EMPTY;
    sp__check *c = NULL;
    size_t kept = 0;
    sp_arena a = *arena;
    sp_status status = sp__check_build(scene, settings, &a, &c, &kept);
    if (!status && c->pb.blocks) status = sp__check_run(&c->pb, &c->set, &c->state, &a, &c->r);
    if (status) return status;
    if (c->r.verdict != SP_UNSTABLE) memset(c->r.dq, 0, 6 * (size_t)scene->count.blocks * sizeof *c->r.dq);
    if (c->r.verdict == SP_STABLE) c->r.level = SP_ADMISSIBLE;
    sp__check_read(scene, &c->r);
    c->r.peak_bytes = a.peak;
    arena->used = kept;
    arena->peak = a.peak;
    *result = c->r;
    return SP_OK;
}

SP_API size_t sp_verify_memory(const sp_scene *scene)
{
    if (!scene) return 0;
    sp_problem pb;
    sp_settings set = sp_settings_default();
    set.faces = 64;
    sp__problem_count(scene, &pb);
    return sp_problem_memory(scene) + SP_ALIGN + sp__judge_need(&pb, &set) + 6 * (size_t)pb.blocks * sizeof(sp_real) + SP_ALIGN;
}

static int sp__all_finite(const sp_real *x, size_t n)
{
    for (size_t k = 0; k < n; k++) if (!sp__finite(x[k])) return 0;
    return 1;
}

SP_API sp_status sp_verify(const sp_scene *scene, const sp_settings *settings, const sp_result *claim, sp_arena scratch,
                           sp_evidence *evidence)
{
    if (!scene || !claim || !claim->f || !claim->dq || !evidence) return SP_E_ARGUMENT;
    sp_settings set;
    sp_problem pb;
    sp__judge j;
    sp_evidence e = { SP_UNDECIDED, 0, 0, 0 };
    sp_status status = sp__settings_resolve(settings, &set);
    if (status) return status;
    if (scene->count.blocks < 1) return SP_E_EMPTY;
    status = sp_problem_build(scene, &scratch, &pb);
    if (status) return status;
    sp_real *dq = sp__take(&scratch, (size_t)pb.blocks, 6 * sizeof *dq);
    if (sp__failed(&scratch)) return SP_E_MEMORY;
    if (!sp__all_finite(claim->f, 3 * (size_t)scene->count.points)) return SP_E_NOT_FINITE;
    if (!sp__all_finite(claim->dq, 6 * (size_t)scene->count.blocks)) return SP_E_NOT_FINITE;
    for (int32_t i = 0; i < pb.blocks; i++) memcpy(dq + 6 * (size_t)i, claim->dq + 6 * (size_t)pb.block[i], 6 * sizeof *dq);
    const int settled = sp__judge_open(&j, &pb, &set, claim->y0, &scratch);
    if (sp__failed(&scratch)) return SP_E_MEMORY;
    e.omega = sp__judge_forces(&j, claim->f, NULL);
    const sp_real proof = sp__judge_mechanism(&j, dq, &e.final);
    e.least_imbalance = sp__max(proof, 0);
    if (settled && e.omega <= set.tol) e.verdict = SP_STABLE;
    else if (settled && proof > set.tol) e.verdict = SP_UNSTABLE;
    if (e.verdict != SP_UNSTABLE) e.final = 0;
    *evidence = e;
    return SP_OK;
}

