/* stages: the bilateral force offered as the answer, by a sparse factor or a dense one; the seed's gate for it. [seed 2.1] */
#ifndef SP__SEED_STAGES_C
#define SP__SEED_STAGES_C

#include "../statics/bilateral.c"

#if SP__WITH_LARGE

/* Conditions of the specification for the bilateral force to count as forces: no tension, no friction beyond the cone. */
typedef struct sp__gate { int tension, friction; } sp__gate;

/* Largest compression and tension of f, and friction beyond the cone, by f's own size.                  [seed 2.1] */
SP__NOINLINE static sp__gate sp__seed_gate(sp__system *w, const sp_seed *seed, const sp_real *f)
{
    sp_real press = 0, pull = 0, beyond = 0, size = 0;
    const sp__gate shut = { 0, 0 };
    if (!sp__system_count(w, SP__FLOPS_SWEEP, 0)) return shut;
    for (int32_t c = 0; c < w->pb->contacts; c++) {
        const sp_contact *t = &w->pb->contact[c];
        const sp__yield *yield = sp__system_yield(w, c);
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            const sp_real *g = f + 3 * (size_t)v;
            const sp_real flat[3] = { sp__max(0, g[0]), g[1], g[2] };
            sp__foot foot;
            sp__cone_foot(&w->law.cone, yield, yield->plain, flat, &foot);
            press = sp__max(press, g[0]);
            pull = sp__max(pull, -g[0]);
            size = sp__max(size, sp__norm3(g));
            beyond = sp__max(beyond, foot.a - yield->mu * (w->set->penalty.net ? g[0] : flat[0]));
        }
    }
    const sp__gate gate = { pull <= seed->tension * press, beyond <= seed->cone * size };
    return gate;
}

/* The bilateral force as the answer; with the seed's constants only where its gate lets it pass. */
static sp_status sp__bilateral_run(const sp_problem *pb, const sp_settings *set, sp__form form, sp_state *state,
                                   sp_arena *arena, sp_verdict *claim)
{
    sp__system *w = sp__system_make_full(pb, set, form, &state->cost, arena);
    if (!w) return SP_E_MEMORY;
    w->budget.limit = state->left;
    state->reason = SP_REASON_BUDGET;
    sp__system_bilateral(w);
    if (w->budget.spent) return SP_OK;
    if (form != SP__METRIC) sp__bilateral_write_y0(w, state);
    sp__system_forces(w, SP__BILATERAL, w->y, state);
    if (w->budget.spent) return SP_OK;
    state->reason = SP_REASON_STAGES;
    *claim = SP_STABLE;
    if (!set->seed) return SP_OK;
    const sp__gate gate = sp__seed_gate(w, set->seed, state->f);
    if (!gate.tension || !gate.friction
        || sp__system_norm(w, w->r) > set->seed->balance * w->measure.load) *claim = SP_UNDECIDED;
    return SP_OK;
}

/* The stage LEAST_SQUARES. */
static sp_status sp__least_squares_run(const sp_problem *pb, const sp_settings *set, sp_state *state, sp_arena *arena,
                                       sp_verdict *claim)
{
    return sp__bilateral_run(pb, set, set->seed ? SP__METRIC : SP__LEAST, state, arena, claim);
}

/* The stage DENSE: the same by a dense factor. */
static sp_status sp__dense_run(const sp_problem *pb, const sp_settings *set, sp_state *state, sp_arena *arena,
                               sp_verdict *claim)
{
    return sp__bilateral_run(pb, set, SP__LEAST_DENSE, state, arena, claim);
}

/* Bytes of each. */
static size_t sp__sparse_need(const sp_problem *pb, const sp_settings *set, sp_arena scratch)
{
    return sp__system_need(pb, set, SP__LEAST, scratch);
}

static size_t sp__dense_need(const sp_problem *pb, const sp_settings *set, sp_arena scratch)
{
    return sp__system_need(pb, set, SP__LEAST_DENSE, scratch);
}

#endif

#endif /* SP__SEED_STAGES_C */
