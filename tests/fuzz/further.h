/* further: what else can be asked of a scene than a check by default settings. */
#ifndef FURTHER_H
#define FURTHER_H

#include "otherwise.h"
#include "balance.h"

/* ------------------------------------------------------------------------------------------------------- other settings */

/* A pyramid; more faces inside the cone hold no less than fewer. */
static void in_a_pyramid(const sp_scene *s, const sp_result *r, sp_settings set, unsigned more)
{
    sp_result other;
    set.faces = 3 + (int32_t)(more % 62);
    set.inscribed = (int32_t)(more % 2);
    const sp_verdict p = check(s, &set, CHECK_OTHER, &other);
    if (!other.f) return;
    asked(PYRAMID);
    if (set.inscribed) HOLDS(!(p == SP_STABLE && r->verdict == SP_UNSTABLE), "in %d faces, not in the cone", (int)set.faces);
    else HOLDS(!(p == SP_UNSTABLE && r->verdict == SP_STABLE), "in the cone, not inside %d faces", (int)set.faces);
}

static void coupled(const sp_scene *s, const sp_result *r, sp_settings set, unsigned more)
{
    sp_result other;
    set.coupled.asked = 1;
    set.coupled.nodes = 100 + 4 * (int32_t)more;
    set.coupled.box = (int32_t)(more % 2);
    set.budget = 20000000;
    const sp_verdict v = check(s, &set, CHECK_OTHER, &other);
    if (!other.f) return;
    asked(COUPLED);
    HOLDS(!(v == SP_STABLE && r->verdict == SP_UNSTABLE), "coupled, not admissible");
    if (other.coupled.verdict == SP_COUPLING_COUPLED) triple(s, &other);
}

static void with_a_budget(const sp_scene *s, const sp_result *r, sp_settings set, unsigned more)
{
    sp_result other;
    set.budget = 1 + 40 * (int64_t)more * more;
    check(s, &set, CHECK_OTHER, &other);
    asked(BUDGET);
    HOLDS(!opposite(r->verdict, other.verdict), "with a budget: %d instead of %d", (int)other.verdict, (int)r->verdict);
    HOLDS(!other.f || other.spent.total.flops <= set.budget, "%lld flops", (long long)other.spent.total.flops);
}

static void by_stages(const sp_scene *s, const sp_result *r, sp_settings set, unsigned more)
{
    sp_result other;
    set.stage_count = 3;
    set.stage[0] = SP_STAGE_GATES;
    set.stage[1] = more % 2 ? SP_STAGE_LEAST_SQUARES : SP_STAGE_DENSE;
    set.stage[2] = more & 2 ? SP_STAGE_POLISH : SP_STAGE_ADMM;
    set.iterations = 200;
    check(s, &set, CHECK_OTHER, &other);
    asked(STAGES);
    HOLDS(!opposite(r->verdict, other.verdict), "by stages: %d instead of %d", (int)other.verdict, (int)r->verdict);
}

/* ------------------------------------------------------------------------------------------------------------- memory */

/* In a share of what it took it is refused, and nothing touched. */
static void short_of(const sp_scene *s, const sp_settings *set, size_t need, unsigned share)
{
    static unsigned char before[sizeof(sp_result)];
    sp_result other;
    sp_arena a = room_for(CHECK_OTHER, need > 64 ? share * (need - 1) / 255 : 0);
    memset(&other, 0x5a, sizeof other);
    memcpy(before, &other, sizeof other);
    const sp_status status = sp_check(s, set, &a, &other);
    HOLDS(status == SP_E_MEMORY && a.used == 0 && !memcmp(before, &other, sizeof other), "status %d", (int)status);
}

/* One byte less than it took, and some share; with stages at work in another arena both sizes are told, the bits the same. */
static void less_memory(const sp_scene *s, const sp_result *r, sp_settings set, unsigned more)
{
    sp_result other;
    asked(LESS_MEMORY);
    short_of(s, &set, r->spent.peak_bytes, more);
    short_of(s, &set, r->spent.peak_bytes, 255);
    sp_arena work = arena(OTHER);
    set.work = &work;
    const size_t bytes = bytes_of(s, SP_FOR_CHECK, &set);
    work.capacity = bytes_of(s, SP_FOR_WORK, &set);
    if (!bytes || !check_in(s, &set, CHECK_OTHER, bytes, &other)) return;
    const size_t took = other.spent.peak_bytes;
    HOLDS(took <= bytes && work.peak <= work.capacity && !work.used, "%zu of %zu bytes", work.peak, work.capacity);
    if (takes_all(&set, &other)) HOLDS(took == bytes && work.peak == work.capacity, "%zu of %zu, %zu of %zu bytes", took, bytes,
                                       work.peak, work.capacity);
    HOLDS(other.verdict == r->verdict && !memcmp(other.f, r->f, 3 * (size_t)s->count.points * sizeof *r->f), "other bits");
}

/* ------------------------------------------------------------------------------------------------------------- limits */

static void limit_numbers(const sp_scene *s, const sp_limit_result *l)
{
    const sp_real number[5] = { l->multiplier, l->lower, l->upper, l->within, l->imbalance };
    for (int k = 0; k < 5; k++) HOLDS(!isnan(number[k]), "number %d", k);
    all_finite(l->f, 3 * s->count.points, "f");
    all_finite(l->ray, 3 * s->count.points, "ray");
    all_finite(l->dq, 6 * s->count.blocks, "dq");
    if (l->kind == SP_LIMIT_FOUND) HOLDS(l->lower <= l->upper, "%g .. %g", (double)l->lower, (double)l->upper);
}

/* The limit of live loads; its ends are verified.     returns the bytes that were told for it, 0: it was not asked */
static size_t limit_of(const sp_scene *s, sp_settings *set, sp_limit_result *l)
{
    int32_t held = -1;
    set->budget = 20000000;
    const size_t bytes = bytes_of(s, SP_FOR_LIMIT, set), verify = bytes_of(s, SP_FOR_LIMIT_VERIFY, set);
    if (!bytes || !verify) return 0;
    sp_arena a = room_for(OTHER, bytes);
    sp_status status = sp_limit(s, set, &a, l);
    HOLDS(status == SP_OK, "limit: status %d", (int)status);
    HOLDS(l->peak_bytes <= bytes, "%zu of %zu bytes", l->peak_bytes, bytes);
    limit_numbers(s, l);
    sp_settings same_as = *set;
    same_as.tol = l->tol;
    same_as.force_bound = l->force_bound;
    status = sp_limit_verify(s, &same_as, l, room_for(SCRATCH, verify), &held);
    HOLDS(status == SP_OK, "limit verify: status %d", (int)status);
    if (l->verified) HOLDS(held, "kind %d", (int)l->kind);
    return bytes;
}

static void limit(const sp_scene *s, const sp_result *r)
{
    sp_settings set = sp_settings_default();
    sp_limit_result l, again;
    const size_t bytes = limit_of(s, &set, &l);
    if (!bytes) return;
    asked(LIMIT);
    if (l.kind == SP_LIMIT_FOUND && l.cost.interior && r->effect[SP_EFFECT_DEPTH] == SP_WHY_MIRROR)
        HOLDS(l.peak_bytes == bytes, "%zu of %zu bytes", l.peak_bytes, bytes);
    sp_arena less = room_for(SEQUENCE, l.peak_bytes - 1);
    HOLDS(sp_limit(s, &set, &less, &again) == SP_E_MEMORY && !less.used, "limit in one byte less than it took");
    if (l.kind != SP_LIMIT_FOUND || s->live < 1 || s->live > 1) return;
    if (r->verdict == SP_STABLE) HOLDS(l.upper >= 1 - (sp_real)1e-6, "stands at 1, limit %g", (double)l.upper);
    if (r->verdict == SP_UNSTABLE && l.dead == SP_STABLE)
        HOLDS(l.lower <= 1 + (sp_real)1e-6, "falls at 1, limit %g", (double)l.lower);
}

/* The scene shaken along x, now and then along y; mostly. */
static sp_scene shaken_of(const sp_scene *s)
{
    sp_scene out = *s;
    if (draw(4)) out.body[0] = (sp_real)draw_real(-10, 10);
    if (!draw(4)) out.body[1] = (sp_real)draw_real(-10, 10);
    return out;
}

/* A little less than the limit stands, a little more falls, turned and in another order, too; by more than it may be off. */
static void near_the_limit(const sp_scene *of)
{
    const double distance[4] = { 1e-2, 1e-4, 1e-6, 1e-7 }, off = distance[draw(4)];
    const int above = (int)draw(2);
    sp_settings set = sp_settings_default();
    sp_limit_result l;
    sp_scene s = shaken_of(of), other;
    sp_result r, again;
    if (!limit_of(&s, &set, &l) || l.kind != SP_LIMIT_FOUND || l.dead != SP_STABLE || !(l.lower > (sp_real)1e-3)) return;
    if (off * (double)l.lower < 4 * (double)l.within + 1e-8 * (1 + (double)l.upper)) return;
    asked(NEAR_LIMIT);
    s.live = above ? l.upper * (sp_real)(1 + off) : l.lower * (sp_real)(1 - off);
    check_in(&s, &set, CHECK_OTHER, ROOM, &r);
    HOLDS(!opposite(r.verdict, above ? SP_UNSTABLE : SP_STABLE), "limit %.17g, at %.17g it is %d", (double)l.upper,
          (double)s.live, (int)r.verdict);
    writing w = turned(&s);
    const writing order = in_order(&s);
    memcpy(w.block, order.block, sizeof w.block);
    memcpy(w.joint, order.joint, sizeof w.joint);
    if (written(&s, &w, OTHER, &other) && check_other(&other, &again)) same(&r, &again, question_name[NEAR_LIMIT]);
}

/* Sliding: what is claimed is proved, and in order. */
static void sliding(const sp_scene *of)
{
    sp_scene shaken = shaken_of(of);
    sp_settings set = sp_settings_default();
    sp_sliding_settings how = sp_sliding_settings_default();
    sp_limit_result l;
    sp_sliding_result r;
    sp_sliding_evidence e;
    how.starts = 2;
    how.seed = draw(1000);
    if (!limit_of(&shaken, &set, &l)) return;
    const size_t bytes = bytes_of(&shaken, SP_FOR_SLIDING, &set), verify = bytes_of(&shaken, SP_FOR_SLIDING_VERIFY, &set);
    if (!bytes || !verify) return;
    sp_arena a = room_for(SEQUENCE, bytes - 1);
    HOLDS(sp_sliding(&shaken, &set, &how, &l, &a, &r) == SP_E_MEMORY && !a.used, "sliding in one byte less");
    a = room_for(SEQUENCE, bytes);
    HOLDS(sp_sliding(&shaken, &set, &how, &l, &a, &r) == SP_OK, "sliding");
    asked(SLIDING);
    HOLDS(r.peak_bytes == bytes, "%zu of %zu bytes", r.peak_bytes, bytes);
    const sp_real number[6] = { r.upper, r.associative, r.lower, r.lower_strong, r.residual, r.share };
    for (int k = 0; k < 6; k++) HOLDS(!isnan(number[k]), "number %d", k);
    all_finite(r.f, 3 * of->count.points, "f");
    all_finite(r.v, 6 * of->count.blocks, "v");
    HOLDS(sp_sliding_verify(&shaken, &set, &r, room_for(SCRATCH, verify), &e) == SP_OK, "sliding verify");
    HOLDS(e.state == (r.kind == SP_SLIDING_STATE), "state %d, kind %d", (int)e.state, (int)r.kind);
    HOLDS(e.lower >= r.lower && e.lower_strong >= r.lower_strong, "lower %g, %g; proved %g, %g", (double)r.lower,
          (double)r.lower_strong, (double)e.lower, (double)e.lower_strong);
    HOLDS(r.lower_strong <= r.lower, "lower %g, strong %g", (double)r.lower, (double)r.lower_strong);
    if (r.upper < 0) return;
    HOLDS(r.lower <= r.upper + (sp_real)1e-6 * (1 + r.upper), "%g .. %g", (double)r.lower, (double)r.upper);
    HOLDS(r.associative < 0 || r.upper <= r.associative, "%g of %g", (double)r.upper, (double)r.associative);
}

static void strong(const sp_scene *s, const sp_real *f)
{
    const sp_strong_settings few = { 16, 0 };
    sp_settings set = sp_settings_default();
    sp_strong_result r;
    sp_strong_kind proved = SP_STRONG_NONE;
    set.budget = 5000000;
    const size_t bytes = bytes_of(s, SP_FOR_STRONG, &set), verify = bytes_of(s, SP_FOR_STRONG_VERIFY, &set);
    if (!bytes || !verify) return;
    sp_arena a = room_for(OTHER, bytes - 1);
    HOLDS(sp_strong(s, &set, &few, f, NULL, &a, &r) == SP_E_MEMORY && !a.used, "strong in one byte less");
    a = room_for(OTHER, bytes);
    const sp_status status = sp_strong(s, &set, &few, f, NULL, &a, &r);
    HOLDS(status == SP_OK, "strong: status %d", (int)status);
    asked(STRONG);
    HOLDS(r.peak_bytes == bytes, "%zu of %zu bytes", r.peak_bytes, bytes);
    HOLDS(r.kind != SP_STRONG_NONE, "forces of a stable check hold nothing");
    all_finite(r.f, 3 * s->count.points, "strong f");
    all_finite(r.a, 6 * s->count.blocks, "a");
    set.tol = r.tol;
    HOLDS(sp_strong_verify(s, &set, &r, room_for(SCRATCH, verify), &proved) == SP_OK, "strong verify");
    HOLDS(proved == r.kind, "said %d, proved %d", (int)r.kind, (int)proved);
}

/* --------------------------------------------------------------------------------------------------- what a check will do */

/* The plan tells the memory, the islands and the effects of the check that follows. */
static void planned(const sp_scene *s, const sp_result *r, const sp_settings *set)
{
    sp_outlook o;
    sp_settings full = *set;
    const size_t bytes = bytes_of(s, SP_FOR_PLAN, set);
    HOLDS(bytes > 0 && sp_plan(s, set, room_for(OTHER, bytes), &o) == SP_OK, "plan in %zu bytes", bytes);
    asked(PLAN);
    HOLDS(o.bytes == bytes_of(s, SP_FOR_CHECK, set), "%zu bytes, %zu told", bytes_of(s, SP_FOR_CHECK, set), o.bytes);
    full.effect[SP_EFFECT_TOGETHER] = SP_WITH;
    HOLDS(o.full_bytes == bytes_of(s, SP_FOR_CHECK, &full), "full %zu bytes", o.full_bytes);
    HOLDS(o.islands == r->islands.count, "%d islands, %d told", (int)r->islands.count, (int)o.islands);
    HOLDS(o.unknowns >= 0 && o.unknowns <= o.full_unknowns && o.flops >= 0 && o.full_flops >= 0, "%lld of %lld unknowns",
          (long long)o.unknowns, (long long)o.full_unknowns);
    for (int k = SP_EFFECT_STRENGTH; k < SP_EFFECTS; k++)
        HOLDS(o.effect[k].why == r->effect[k], "effect %d: planned %d, done %d", k, (int)o.effect[k].why, (int)r->effect[k]);
}

/* A scene's blocks with contacts of their own, none yet. */
static sp_scene without_contacts(const sp_scene *of)
{
    static sp_joint joint[JOINTS];
    static sp_real point[VERTICES][3];
    sp_scene s = *of;
    s.joint = joint;
    s.point = point;
    s.count.joints = s.count.points = 0;
    return s;
}

/* Contacts found again in the memory that is told are the same; with room for one joint less they are refused. */
static void contacts_again(const sp_scene *of, size_t bytes)
{
    sp_scene s = without_contacts(of);
    sp_contact_settings touch = sp_contact_settings_default();
    sp_contact_report report = { 0, 0, 0, 0, NULL };
    if (of->count.joints) touch.strength = of->joint[0].strength;
    HOLDS(sp_contacts_find(&s, &touch, room_for(OTHER, bytes), &report) == SP_OK, "contacts in %zu bytes", bytes);
    HOLDS(s.count.joints == of->count.joints && s.count.points == of->count.points && report.joints == s.count.joints,
          "%d joints, %d again", (int)of->count.joints, (int)s.count.joints);
    HOLDS(!memcmp(s.joint, of->joint, (size_t)s.count.joints * sizeof *s.joint) &&
          !memcmp(s.point, of->point, (size_t)s.count.points * sizeof *s.point), "other joints");
    s.capacity.joints = s.count.joints - 1;
    s.count.joints = s.count.points = 0;
    if (!report.joints) return;
    const sp_status status = sp_contacts_find(&s, &touch, room_for(OTHER, bytes), &report);
    HOLDS(status == SP_E_CAPACITY && !s.count.joints && report.joints == of->count.joints, "a joint less: status %d",
          (int)status);
}

/* Again, and by another distance and angle: what is found can be checked. */
static void contacts(const sp_scene *of, const sp_settings *set)
{
    const size_t bytes = bytes_of(of, SP_FOR_CONTACTS, NULL);
    sp_scene s = without_contacts(of);
    sp_contact_settings touch = sp_contact_settings_default();
    sp_contact_report report = { 0, 0, 0, 0, NULL };
    sp_result r;
    if (!bytes) return;
    asked(CONTACTS);
    contacts_again(of, bytes);
    touch.distance = (sp_real)draw_real(0, 0.1);
    touch.angle = draw(2) ? (sp_real)draw_real(0, 0.5) : -(sp_real)draw(65);
    touch.absolute = (int32_t)draw(2);
    const sp_status status = sp_contacts_find(&s, &touch, arena(OTHER), &report);
    HOLDS(status == SP_OK || status == SP_E_CAPACITY, "contacts within %g: status %d", (double)touch.distance, (int)status);
    if (!status) check(&s, set, CHECK_OTHER, &r);
}

/* Aeq f + p of the matrices is what forces and loads sum to. */
static void matrices(const sp_scene *s, const sp_result *r)
{
    static double sum[6 * SP_FUZZ_BLOCKS], size[6 * SP_FUZZ_BLOCKS];
    const size_t bytes = bytes_of(s, SP_FOR_PROBLEM, NULL);
    sp_arena a = room_for(OTHER, bytes), more = arena(SEQUENCE);
    sp_problem pb;
    sp_triplets t;
    sp_csc c;
    if (!bytes) return;
    HOLDS(sp_problem_build(s, &a, &pb) == SP_OK, "problem");
    HOLDS(a.peak == bytes, "a problem takes %zu of %zu bytes", a.peak, bytes);
    HOLDS(sp_matrix_aeq(&pb, 3, &more, &t) == SP_OK && sp_csc_from(&t, &more, &c) == SP_OK, "Aeq");
    asked(MATRIX);
    for (int32_t i = 0; i < 6 * pb.blocks; i++) { sum[i] = (double)pb.p[i]; size[i] = fabs(sum[i]); }
    for (int32_t k = 0; k < c.cols; k++)
        for (int32_t q = c.p[k]; q < c.p[k + 1]; q++) {
            HOLDS(c.i[q] >= 0 && c.i[q] < c.rows && (q == c.p[k] || c.i[q] > c.i[q - 1]), "row %d", (int)c.i[q]);
            sum[c.i[q]] += (double)c.x[q] * (double)r->f[k];
            size[c.i[q]] += fabs((double)c.x[q] * (double)r->f[k]);
        }
    for (int32_t i = 0; i < pb.blocks; i++) {
        const wrench f = contacts_on(s, r->f, pb.block[i]), p = loads_on(s, pb.block[i]);
        for (int k = 0; k < 6; k++) {
            const double all = k < 3 ? f.force[k] + p.force[k] : f.moment[k - 3] + p.moment[k - 3];
            const double rounding = 1e-10 * (k < 3 ? f.size + p.size : f.arm_size + p.arm_size + f.arm * (f.size + p.size));
            HOLDS(fabs(sum[6 * i + k] - all) <= rounding, "row %d of block %d: %g, summed %g", k, (int)i, sum[6 * i + k], all);
        }
    }
}

#endif
