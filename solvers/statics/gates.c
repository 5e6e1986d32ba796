/* gates: cases that need no search: no load, or a group of touching blocks without support.
 *
 * A group of touching free blocks that reaches no support, pulled by F: every joint inside it stays as it is when the group
 * moves along F, so that motion does work |F|^2 > 0 against nothing. Turned by M, with F = 0: likewise, about M. With no load
 * at all f = 0 is the answer.
 */
#ifndef SP__STATICS_GATES_C
#define SP__STATICS_GATES_C

#include "../base/vec3.c"
#include "../base/groups.c"

#if SP__WITH_LARGE

/* Has every stone a path to a support, as far as this reason tells? Without one no pull at a joint holds it. */
static int sp__has_paths(sp_reason reason) { return reason != SP_REASON_NO_SUPPORT && reason != SP_REASON_NO_CONTACT; }

/* Bytes of the stage: one number a block. */
static size_t sp__gates_need(const sp_problem *pb, const sp_settings *set, sp_arena scratch)
{
    (void)set; (void)scratch;
    sp_arena dry = sp__arena_dry();
    sp__take(&dry, (size_t)pb->blocks + 1, sizeof(int32_t));
    return dry.peak;
}

/* Centroid of free block k seen from that of free block i. */
static void sp__gates_arm(const sp_problem *pb, int32_t i, int32_t k, sp_real r[3])
{
    sp__sub3(pb->scene->block[pb->block[k]].centroid, pb->scene->block[pb->block[i]].centroid, r);
}

/* Force F on the group of block i, its moment M about that block's centroid.                returns how many blocks it has */
static int32_t sp__gates_group_load(const sp_problem *pb, int32_t *up, int32_t i, sp_real F[3], sp_real M[3])
{
    int32_t size = 0;
    sp__scale3(0, F, F);
    sp__scale3(0, M, M);
    for (int32_t k = i; k < pb->blocks; k++) {
        sp_real r[3];
        if (sp__root(up, k + 1) != i + 1) continue;
        sp__gates_arm(pb, i, k, r);
        sp__cross3_add(r, pb->p + 6 * (size_t)k, M);
        for (size_t q = 0; q < 3; q++) {
            F[q] += pb->p[6 * (size_t)k + q];
            M[q] += pb->p[6 * (size_t)k + 3 + q];
        }
        size++;
    }
    return size;
}

/* The first group without support that is pulled or turned moves: dq = F / |F|, or M / |M| about the first block, for its
 * blocks.                                                                                              returns its size */
static int32_t sp__gates_unsupported_motion(const sp_problem *pb, int32_t *up, sp_real *dq)
{
    for (int32_t i = 0; i < pb->blocks; i++) {
        if (up[i + 1] != i + 1) continue;
        sp_real F[3] = { 0, 0, 0 }, M[3] = { 0, 0, 0 };
        const int32_t size = sp__gates_group_load(pb, up, i, F, M);
        const int turn = !(sp__norm3(F) > 0);
        if (turn && !(sp__norm3(M) > 0)) continue;
        sp__unit3(turn ? M : F, F);
        for (int32_t k = i; k < pb->blocks; k++) {
            sp_real r[3], *to = dq + 6 * (size_t)k;
            if (sp__root(up, k + 1) != i + 1) continue;
            sp__gates_arm(pb, i, k, r);
            if (turn) sp__cross3(F, r, to); else memcpy(to, F, sizeof F);
            if (turn) memcpy(to + 3, F, sizeof F);
        }
        return size;
    }
    return 0;
}

/* The stage: STABLE without load, UNSTABLE where a group without support is loaded, else nothing. */
static sp_status sp__gates_run(const sp_problem *pb, const sp_settings *set, sp_state *state, sp_arena *arena,
                               sp_verdict *claim)
{
    (void)set;
    int32_t *up = sp__take(arena, (size_t)pb->blocks + 1, sizeof *up);
    if (sp__failed(arena)) return SP_E_MEMORY;
    state->reason = SP_REASON_BUDGET;
    if (state->left < 6 * (int64_t)pb->blocks) return SP_OK;
    state->reason = SP_REASON_STAGES;
    sp_real load = 0;
    memset(state->dq, 0, 6 * (size_t)pb->blocks * sizeof *state->dq);
    for (size_t k = 0; k < 6 * (size_t)pb->blocks; k++) load = sp__max(load, sp__abs(pb->p[k]));
    if (!(load > 0)) {
        *claim = SP_STABLE;
        state->reason = SP_REASON_NOTHING;
        return SP_OK;
    }
    for (int32_t i = 0; i <= pb->blocks; i++) up[i] = i;
    for (int32_t i = 0; i < pb->blocks; i++) if (pb->scene->block[pb->block[i]].fixed) sp__join(up, 0, i + 1);
    for (int32_t c = 0; c < pb->contacts; c++) sp__join(up, pb->contact[c].a + 1, pb->contact[c].b + 1);
    const int32_t size = sp__gates_unsupported_motion(pb, up, state->dq);
    if (size) {
        *claim = SP_UNSTABLE;
        state->reason = size > 1 ? SP_REASON_NO_SUPPORT : SP_REASON_NO_CONTACT;
    }
    state->cost.flops += 6 * (int64_t)pb->blocks;
    return SP_OK;
}

#endif

#endif /* SP__STATICS_GATES_C */
