/* The specification's alternation of forces and motion, and the memory of a coupled check. */
#include "coupled.h"

#include <string.h>

#if !defined(SP_NO_QP) && !defined(SP_NO_ADMM)
static sp_settings turns(double ratio)
{
    sp_settings set = sp_settings_seed();
    set.coupled.asked = 1;
    set.coupled.eps = R(1e-4);
    set.coupled.eta = R(1e-4 * ratio);
    return set;
}

static sp_coupling in_turns(const char *name, const char *param, double value, const sp_settings *set, sp_result *r)
{
    sp_scene s;
    test_arena.used = 0;
    build(name, param, value, &s);
    return answer(&s, set, r);
}

TEST(the_seeds_alternation_couples_what_stands_in_a_round)
{
    static const struct { const char *name, *param; double value; } scene[] = {
        { "two-cubes", "offset", 0.4 }, { "incline", "angle", 30 }, { "topple", "angle", 12 }, { "overhang", "factor", 0.9 },
        { "cantilever", "reach", 1.1 }, { "tower", "n", 6 }, { "wall", "rows", 2 }, { "arch", "n", 12 } };
    const sp_settings set = turns(100);
    for (size_t k = 0; k < sizeof scene / sizeof scene[0] - TOL(0, 1); k++) {           /* float does not find the arch's */
        sp_result r;
        const int coupled = CHECK_INT(in_turns(scene[k].name, scene[k].param, scene[k].value, &set, &r), SP_COUPLING_COUPLED);
        if (!coupled || !CHECK_INT(r.coupled.rounds, 1)) TEST_PRINT("    %s\n", scene[k].name);
    }
}

TEST(the_seeds_alternation_drops_what_no_motion_explains_and_refutes_nothing)
{
    static const double mu[] = { 0.45, 0.6, 0.84 };
    for (int k = 0; k < 3; k++)
        for (double ratio = 2; ratio < 3e3; ratio *= 10) {
            const sp_settings set = turns(ratio);
            sp_result r;
            CHECK_INT(in_turns("h-model", "mu", mu[k], &set, &r), SP_COUPLING_NOT_FOUND);
            CHECK(r.coupled.rounds >= 1 && r.coupled.rounds <= 12 && r.coupled.proof.nodes == 0);
        }
}

TEST(the_seeds_alternation_stops_after_the_rounds_asked_for)
{
    sp_settings set = turns(100);
    sp_result r;
    CHECK_INT(set.coupled.rounds, 12);
    CHECK_INT(sp_settings_default().coupled.rounds, 0);
    set.coupled.nodes = -1;                             /* what it leaves open may be decided after all */
    set.tol = TOL(R(1e-9), R(1e-4));
    CHECK_INT(in_turns("h-model", "mu", 0.6, &set, &r), TOL(SP_COUPLING_REFUTED, SP_COUPLING_NOT_FOUND));
    set = turns(100);
    set.coupled.rounds = 1;
    CHECK_INT(in_turns("h-model", "mu", 0.6, &set, &r), SP_COUPLING_NOT_FOUND);
    CHECK_INT(r.coupled.rounds, 1);
}
/* A solver that has its own memory, and no answer. */
static sp_status elsewhere(void *self, const sp_qp *qp, const sp_qp_settings *set, sp_arena *arena, const sp_real *x0,
                           const sp_real *y0, sp_qp_result *r)
{
    (void)self; (void)qp; (void)set; (void)arena; (void)x0; (void)y0;
    memset(r, 0, sizeof *r);
    r->status = SP_QP_NUMERICAL;
    return SP_OK;
}

static sp_status takes_nothing(void *self, const sp_qp *qp, const sp_qp_settings *set, sp_arena scratch, size_t *bytes)
{
    (void)self; (void)qp; (void)set; (void)scratch;
    *bytes = 0;
    return SP_OK;
}

/* The program was made in more memory than it keeps, which a solver of the library's hid: with OSQP a dome ran out of its own. */
TEST(a_solver_with_its_own_memory_leaves_enough_to_make_its_program)
{
    const sp_qp_solver solver = { NULL, elsewhere, takes_nothing };
    for (int rings = 3; rings <= 8; rings += 5) {
        sp_settings set = turns(100);
        sp_scene s;
        sp_result r;
        size_t bytes = 0;
        test_arena.used = 0;
        set.penalty.solver = &solver;
        build("dome", "rings", rings, &s);
        NEED(sp_memory(&s, SP_FOR_CHECK, &set, test_arena, &bytes) == SP_OK);
        sp_arena a = test_arena;
        a.used = (a.used + SP_ALIGN - 1) / SP_ALIGN * SP_ALIGN;
        NEED(bytes <= a.capacity - a.used);
        a.capacity = a.used + bytes;
        CHECK_INT(sp_check(&s, &set, &a, &r), SP_OK);
        CHECK_INT(r.coupled.verdict, SP_COUPLING_NOT_FOUND);
    }
}
#else
TEST(the_seeds_alternation_is_refused_where_it_is_left_out)
{
    sp_scene s;
    sp_result r;
    sp_settings set = asked(100, 0);
    set.coupled.rounds = 12;
    test_arena.used = 0;
    build("incline", "angle", 30, &s);
    CHECK_INT(sp_check(&s, &set, &test_arena, &r), SP_E_UNSUPPORTED);
}
#endif

TEST(the_coupled_check_takes_exactly_the_memory_it_says)
{
    for (int k = 0; k < 4; k++) {
        sp_settings set = asked(100, 0);
        sp_scene s;
        sp_result r;
        sp_arena a;
        size_t bytes = 0;
        if (k == 3) set.faces = 8;
#if !defined(SP_NO_QP) && !defined(SP_NO_ADMM)
        if (k == 2) set = turns(100);
#endif
        test_arena.used = 0;
        set.coupled.asked = k > 0;
        build("arch", "n", 8, &s);
        NEED(sp_memory_scratch(&s, SP_FOR_CHECK, &set) <= test_arena.capacity - test_arena.used);
        sp_arena scratch = test_arena;
        scratch.capacity = scratch.used + sp_memory_scratch(&s, SP_FOR_CHECK, &set) + SP_ALIGN;
        NEED(sp_memory(&s, SP_FOR_CHECK, &set, scratch, &bytes) == SP_OK);
        const size_t from = (test_arena.used + SP_ALIGN - 1) / SP_ALIGN * SP_ALIGN;
        NEED(sp_arena_init(&a, test_arena.base + from, test_arena.capacity - from) == SP_OK);
        NEED(bytes <= a.capacity);
        a.capacity = bytes;
        CHECK_INT(sp_check(&s, &set, &a, &r), SP_OK);
        CHECK_INT((int64_t)r.spent.peak_bytes, (int64_t)bytes);
        a.used = 0;
        a.capacity = bytes - 1;
        CHECK_INT(sp_check(&s, &set, &a, &r), SP_E_MEMORY);
    }
}

TEST_LIST(alternation)
#if !defined(SP_NO_QP) && !defined(SP_NO_ADMM)
    RUN(the_seeds_alternation_couples_what_stands_in_a_round)
    RUN(the_seeds_alternation_drops_what_no_motion_explains_and_refutes_nothing)
    RUN(the_seeds_alternation_stops_after_the_rounds_asked_for)
    RUN(a_solver_with_its_own_memory_leaves_enough_to_make_its_program)
#else
    RUN(the_seeds_alternation_is_refused_where_it_is_left_out)
#endif
    RUN(the_coupled_check_takes_exactly_the_memory_it_says)
TEST_END
