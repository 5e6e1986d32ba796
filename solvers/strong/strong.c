/* strong: sp_strong: does friction hold a scene whatever it does, or by its history only? sp_strong_verify: is that so? */
#ifndef SP__STRONG_STRONG_C
#define SP__STRONG_STRONG_C

#include "../check/settings.c"
#include "../proof/shear.c"
#include "cases.c"
#include "starts.c"

#if SP__WITH_STRONG

/* What sp_strong works on, in the arena. */
typedef struct sp__holds {
    sp_settings set;                    /* resolved */
    sp_problem pb;
    sp__starts starts;
    sp__lemke lemke;                    /* of starts */
    sp_strong_result r;
} sp__holds;

/* Bytes that telling cases apart takes, with `search`, or the check of a proof; 0: too many corners, a loop of joints. */
SP__NOINLINE static size_t sp__holds_cases_need(const sp_scene *scene, int search)
{
    sp_problem pb;
    sp__problem_count(scene, &pb);
    const int32_t points = sp__points_count(scene);
    const size_t pivots = search ? sp__lemke_need(points) : 0, even = sp__shear_need(pb.points, pb.contacts, pb.blocks);
    const size_t shear = even > pivots ? even : pivots;
    if (!sp__cases_allowed(scene, pb.blocks)) return shear;
    const size_t still = sp__still_need(points, pb.blocks), cases = search ? sp__cases_need(points, pb.blocks) : 0;
    const size_t check = still > shear ? still : shear;
    return check > cases ? check : cases;
}

/* Room for a proof by cases that the budget has work for; none where there are too many corners. */
SP__NOINLINE static sp_proof sp__holds_proof(const sp_scene *scene, const sp_settings *settings, sp_arena *a)
{
    sp_proof p;
    sp_problem pb;
    memset(&p, 0, sizeof p);
    sp__problem_count(scene, &pb);
    if (!sp__cases_allowed(scene, pb.blocks)) return p;
    const sp__cases_room room = sp__cases_room_for(sp__points_count(scene), pb.blocks, settings ? settings->budget : 0);
    sp__cases_proof(&p, &room, a);
    return p;
}

/* Can no joint spin? Then all its corners slip alike, and pressure anywhere in it is as good as at its corners. */
static int sp__holds_plates(const sp_problem *pb)
{
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        for (int side = 0; side < 2 && t->points > 1; side++)
            for (int k = 0; k < 3; k++) {
                const int32_t i = side ? t->a : t->b;
                if (i >= 0 && !sp__held(pb, i, 3 + k) && sp__abs(t->joint->n[k]) > 0) return 0;
            }
    }
    return 1;
}

/* What a proof by cases proves, where inertias are known: STRONG, at these corners or anywhere in the joints; else NONE. */
static sp_strong_kind sp__holds_by_cases(sp__holds *s, const sp_proof *proof, sp_arena a, sp_real *margin)
{
    *margin = sp__certify_still(&s->starts.j, s->starts.M, proof, &a);
    if (!(*margin > 0)) return SP_STRONG_NONE;
    return sp__holds_plates(&s->pb) ? SP_STRONG_STRONG : SP_STRONG_AT_CORNERS;
}

/* Bytes of what judges: also what sp_strong works on. */
SP__NOINLINE static size_t sp__holds_verify_memory(const sp_scene *scene)
{
    sp_arena dry = sp__arena_dry();
    sp__take(&dry, 1, sizeof(sp__holds));
    sp__take(&dry, 1, sp__problem_memory(scene));
    sp__take(&dry, 1, sp__starts_need(scene));
    sp__take(&dry, 1, sp__holds_cases_need(scene, 0));
    return sp__failed(&dry) ? 0 : dry.used;
}

SP__NOINLINE static size_t sp__holds_memory(const sp_scene *scene, const sp_settings *settings)
{
    sp_arena dry = sp__arena_dry();
    sp__take(&dry, (size_t)scene->count.points, 3 * sizeof(sp_real));
    sp__take(&dry, (size_t)scene->count.points, 3 * sizeof(sp_real));
    sp__take(&dry, (size_t)scene->count.blocks, 6 * sizeof(sp_real));
    sp__holds_proof(scene, settings, &dry);
    sp__take(&dry, 1, sizeof(sp__holds));
    sp__take(&dry, 1, sp__problem_memory(scene));
    sp__take(&dry, 1, sp__starts_need(scene));
    sp__take(&dry, 1, sp__holds_cases_need(scene, 1));
    return sp__failed(&dry) ? 0 : dry.used;
}

/* Does pressure alone balance the loads, by the normal forces of f? These then go into the result. */
static int sp__holds_by_pressure(sp__holds *s, const sp_real *f)
{
    sp_real *pressure = s->starts.sweep.f;
    const sp_real imbalance = sp__certify_pressure(&s->starts.j, f, pressure);
    if (!(imbalance <= s->set.tol)) return 0;
    memcpy(s->r.f, pressure, 3 * (size_t)s->pb.points * sizeof *pressure);
    s->r.kind = SP_STRONG_STRONG;
    s->r.reason = SP_STRONG_PRESSURE;
    s->r.plate = 1;
    s->r.residual = imbalance;
    return 1;
}

/* Is there a motion with pressure anywhere in the joints? Their corners alone may hold what that does not. */
static int sp__holds_spins(sp__holds *s, const sp_strong_settings *how)
{
    sp_strong_result *r = &s->r;
    if (how->corners || sp__holds_plates(&s->pb)) return 0;
    s->starts.sweep.plates = 1;
    s->starts.pivoted = 0;                              /* its pairs are those of single corners */
    const int64_t before = s->starts.sweep.flops;
    sp__starts_run(&s->starts, how->starts, s->set.budget > 0 ? s->set.budget : SP__STARTS_FLOPS, r);
    r->starts = s->starts.tried;
    r->cost.flops += s->starts.sweep.flops - before;
    return r->kind == SP_STRONG_AMBIGUOUS;
}

/* Look for a motion, then tell cases apart. */
SP__NOINLINE static void sp__holds_move(sp__holds *s, const sp_strong_settings *how, sp_arena a)
{
    sp_strong_result *r = &s->r;
    r->kind = SP_STRONG_ADMISSIBLE;
    r->reason = SP_STRONG_NOT_ASKED;
    if (sp__scene_strong(s->pb.scene) || !sp__inertias(&s->pb, s->starts.arm, s->starts.M)) return;
    for (int32_t i = 0; i < s->pb.blocks; i++) r->balls += !s->starts.M[i].known;
    sp_arena shear = a;
    r->margin = sp__certify_shear(&s->starts.j, s->starts.M, r->f, NULL, &shear);
    if (r->margin > 0) {
        r->kind = SP_STRONG_STRONG;
        r->reason = SP_STRONG_EVEN;
        r->plate = 1;
        return;
    }
    r->reason = SP_STRONG_NOTHING_FOUND;
    sp__starts_pivot(&s->starts, &s->lemke, a);
    sp__starts_run(&s->starts, how->starts, s->set.budget > 0 ? s->set.budget : SP__STARTS_FLOPS, r);
    r->starts = s->starts.tried;
    r->cost.flops += s->starts.sweep.flops;
    if (r->kind == SP_STRONG_AMBIGUOUS || sp__holds_spins(s, how) || !r->proof.node) return;
    sp_strong_kind kind = SP_STRONG_NONE;
    if (sp__cases_decide(&s->pb, &s->starts.j, s->starts.M, s->set.budget, a, r))
        kind = sp__holds_by_cases(s, &r->proof, a, &r->margin);
    if (kind) {
        r->kind = kind;
        r->reason = SP_STRONG_CASES;
        r->plate = kind == SP_STRONG_STRONG;
    } else r->proof.nodes = r->proof.leaves = r->proof.entries = 0;
}

/* The question, its problem and what judges: shared by the search and sp_strong_verify. */
static sp_status sp__holds_open(sp__holds *s, const sp_scene *scene, const sp_settings *settings, sp_arena *a)
{
    memset(s, 0, sizeof *s);
    s->set = settings ? *settings : sp_settings_default();
    s->set.coupled.asked = 0;
    sp_status status = sp__settings_resolve(scene, &s->set, &s->set);
    if (!status && s->set.faces) status = SP_E_UNSUPPORTED;
    if (!status) status = sp_problem_build(scene, a, &s->pb);
    if (status) return status;
    sp__starts_carve(&s->starts, &s->pb, a);
    if (sp__failed(a)) return SP_E_MEMORY;
    sp__certifier_begin(&s->starts.j, &s->pb, &s->set, NULL, INT32_MAX);
    return SP_OK;
}

/* Pressure, of both forces; motion, where the first hold. */
static void sp__holds_decide(sp__holds *s, const sp_real *f, const sp_real *pressed, const sp_strong_settings *how, sp_arena a)
{
    const sp_real imbalance = sp__certify_forces(&s->starts.j, f, s->r.f);
    if (sp__holds_by_pressure(s, f) || (pressed && sp__holds_by_pressure(s, pressed))) return;
    if (!(imbalance <= s->set.tol)) memset(s->r.f, 0, 3 * (size_t)s->pb.points * sizeof *s->r.f);
    else sp__holds_move(s, how, a);
}

SP_API sp_status sp_strong(const sp_scene *scene, const sp_settings *settings, const sp_strong_settings *how, const sp_real *f,
                           const sp_real *pressed, sp_arena *arena, sp_strong_result *result)
{
    const sp_strong_settings plain = sp_strong_settings_default();
    if (!scene || !f || !arena || !arena->base || !result) return SP_E_ARGUMENT;
    if (scene->count.blocks < 1) return SP_E_EMPTY;
    const size_t points = 3 * (size_t)scene->count.points;
    if (!sp__all_finite(f, points) || (pressed && !sp__all_finite(pressed, points))) return SP_E_NOT_FINITE;
    if (how && (how->starts < 0 || how->corners < 0 || how->corners > 1)) return SP_E_RANGE;
    sp_arena a = *arena;
    sp_real *at[3];
    at[0] = sp__take(&a, points, sizeof *f);
    at[1] = sp__take(&a, points, sizeof *f);
    at[2] = sp__take(&a, (size_t)scene->count.blocks, 6 * sizeof *f);
    const size_t kept = a.used;
    const sp_proof proof = sp__holds_proof(scene, settings, &a);
    const size_t with_proof = a.used;
    sp__holds *s = sp__take(&a, 1, sizeof *s);
    if (!s) return SP_E_MEMORY;
    const sp_status status = sp__holds_open(s, scene, settings, &a);
    if (status) return status;
    sp_arena cases = a;
    sp__take(&a, 1, sp__holds_cases_need(scene, 1));
    if (sp__failed(&a)) return SP_E_MEMORY;
    for (int k = 0; k < 3; k++) memset(at[k], 0, (k < 2 ? points : 6 * (size_t)scene->count.blocks) * sizeof *f);
    s->r.f = at[0]; s->r.moving = at[1]; s->r.a = at[2];
    s->r.proof = proof;
    sp__holds_decide(s, f, pressed, how ? how : &plain, cases);
    if (!s->r.proof.nodes) memset(&s->r.proof, 0, sizeof s->r.proof);
    s->r.cost.flops += SP__FLOPS_CERTIFICATE * (int64_t)s->starts.j.sweeps * s->pb.points;
    s->r.tol = s->set.tol;
    s->r.peak_bytes = arena->peak = a.peak;
    arena->used = s->r.proof.nodes ? with_proof : kept;
    *result = s->r;
    return SP_OK;
}

/* What a claim proves, whatever it says: STRONG by pressure or by cases, AMBIGUOUS by forces at rest and a pair that moves. */
static sp_strong_kind sp__holds_judge(sp__holds *s, const sp_strong_result *claim, sp_arena a)
{
    sp__certifier *j = &s->starts.j;
    sp_real moves;
    if (sp__certify_pressure(j, claim->f, s->starts.sweep.f) <= s->set.tol) return SP_STRONG_STRONG;
    if (!(sp__certify_forces(j, claim->f, NULL) <= s->set.tol)) return SP_STRONG_NONE;
    if (sp__scene_strong(s->pb.scene) || !sp__inertias(&s->pb, s->starts.arm, s->starts.M)) return SP_STRONG_ADMISSIBLE;
    sp_arena shear = a;
    if (sp__certify_shear(j, s->starts.M, claim->f, NULL, &shear) > 0) return SP_STRONG_STRONG;
    if (claim->proof.nodes > 0) {
        const sp_strong_kind kind = sp__holds_by_cases(s, &claim->proof, a, &moves);
        return kind ? kind : SP_STRONG_ADMISSIBLE;
    }
    sp__motion_read(&s->pb, claim->a, s->starts.sweep.a);
    const sp_real residual = sp__certify_moving(j, s->starts.M, claim->moving, s->starts.sweep.a, 1, &moves);
    return residual <= s->set.tol && moves >= SP__MOVES ? SP_STRONG_AMBIGUOUS : SP_STRONG_ADMISSIBLE;
}

SP_API sp_status sp_strong_verify(const sp_scene *scene, const sp_settings *settings, const sp_strong_result *claim,
                                  sp_arena scratch, sp_strong_kind *proved)
{
    if (!scene || !claim || !claim->f || !claim->moving || !claim->a || !proved || !scratch.base) return SP_E_ARGUMENT;
    if (scene->count.blocks < 1) return SP_E_EMPTY;
    if (!sp__all_finite(claim->f, 3 * (size_t)scene->count.points)) return SP_E_NOT_FINITE;
    if (!sp__all_finite(claim->moving, 3 * (size_t)scene->count.points)) return SP_E_NOT_FINITE;
    if (!sp__all_finite(claim->a, 6 * (size_t)scene->count.blocks)) return SP_E_NOT_FINITE;
    sp__holds *s = sp__take(&scratch, 1, sizeof *s);
    if (!s) return SP_E_MEMORY;
    const sp_status status = sp__holds_open(s, scene, settings, &scratch);
    if (status) return status;
    sp_arena cases = scratch;
    sp__take(&scratch, 1, sp__holds_cases_need(scene, 0));
    if (sp__failed(&scratch)) return SP_E_MEMORY;
    *proved = sp__holds_judge(s, claim, cases);
    return SP_OK;
}

#elif SP__WITH_STONES

static size_t sp__holds_verify_memory(const sp_scene *scene) { return (void)scene, 0; }
static size_t sp__holds_memory(const sp_scene *scene, const sp_settings *settings) { return (void)scene, (void)settings, 0; }

#endif

#endif /* SP__STRONG_STRONG_C */
