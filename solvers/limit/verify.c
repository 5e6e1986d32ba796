/* verify: sp_limit_verify: the certificate check of every end that a result claims. */
#ifndef SP__LIMIT_VERIFY_C
#define SP__LIMIT_VERIFY_C

#include "falls.c"
#include "small_engine.c"

#if SP__WITH_LIMIT

/* By how much the multiplier may be off. dq proves (upper - balance) live . dq = least scale, and forces within tol carry at
 * most tol scale / (live . dq) more than they should. */
static sp_real sp__bracket_within(const sp_limit_result *r, sp_real balance)
{
    return r->upper - r->lower + r->tol * sp__ratio(r->upper - balance, r->least_imbalance);
}

/* Every end that the claim has. */
SP__NOINLINE static int sp__bracket_verify(sp__bracket *b, const sp_limit_result *r)
{
    if (r->kind == SP_LIMIT_UNBOUNDED && !sp__bracket_stands(b, 0, 1, r->ray, NULL)) return 0;
    if (r->kind != SP_LIMIT_NONE && r->lower < 0) return 0;
    if (r->kind == SP_LIMIT_FOUND && !(r->lower <= r->upper)) return 0;
    if (r->kind != SP_LIMIT_NONE && !sp__bracket_stands(b, 1, r->lower, r->f, NULL)) return 0;
    if (r->kind == SP_LIMIT_UNBOUNDED) return 1;
    sp__motion_read(&b->pb, r->dq, b->dq);
    b->slight = 1;
    return sp__bracket_falls(b, r->kind == SP_LIMIT_NONE ? 0 : r->upper, 1, NULL);
}

SP__NOINLINE static size_t sp__limit_verify_memory(const sp_scene *scene)
{
    sp_problem pb;
    sp_real *at[5];
    sp__certifier j;
    sp_arena dry = sp__arena_dry();
    sp__problem_count(scene, &pb);
    sp__take(&dry, 1, sizeof(sp__bracket));
    sp__take(&dry, 1, sp__problem_memory(scene));
    sp__bracket_carve(at, pb.blocks, &dry);
    sp_arena certificate = sp__arena_dry();
    sp__certifier_carve(&j, &pb, SP__FACES_MAX, &certificate);
    sp__take(&dry, 1, certificate.peak);
    return sp__failed(&dry) ? 0 : dry.used;
}

SP_API sp_status sp_limit_verify(const sp_scene *scene, const sp_settings *settings, const sp_limit_result *claim,
                                 sp_arena scratch, int32_t *held)
{
    if (!scene || !claim || !claim->f || !claim->ray || !claim->dq || !held || !scratch.base) return SP_E_ARGUMENT;
    if (scene->count.blocks < 1) return SP_E_EMPTY;
    if (!sp__finite(claim->lower) || !sp__finite(claim->upper)) return SP_E_NOT_FINITE;
    if (!sp__all_finite(claim->f, 3 * (size_t)scene->count.points)) return SP_E_NOT_FINITE;
    if (!sp__all_finite(claim->ray, 3 * (size_t)scene->count.points)) return SP_E_NOT_FINITE;
    if (!sp__all_finite(claim->dq, 6 * (size_t)scene->count.blocks)) return SP_E_NOT_FINITE;
    sp__bracket *b = sp__take(&scratch, 1, sizeof *b);
    if (!b) return SP_E_MEMORY;
    const sp_status status = sp__bracket_build(scene, settings, b, &scratch);
    if (status) return status;
    b->y0 = claim->y0;
    sp_arena room = scratch;
    b->room = scratch;
    sp__take(&room, 1, sp__certifier_need(&b->pb, &b->set));
    if (sp__failed(&room)) return SP_E_MEMORY;
    *held = claim->kind != SP_LIMIT_UNDECIDED && sp__bracket_verify(b, claim);
    return SP_OK;
}

#elif SP__WITH_STONES

static size_t sp__limit_verify_memory(const sp_scene *scene) { return (void)scene, 0; }

#endif

#endif /* SP__LIMIT_VERIFY_C */
