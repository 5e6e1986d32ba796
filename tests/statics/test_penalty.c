/* The penalty form: solved as far as a check does, it shows help where it shows it solved as far as it goes, for less work. */
#define SP_API static
#include "../test.h"
#include "../../solvers/base/words.c"
#include "../scenes/gen.h"
#include "../../solvers/statics/penalty.c"

#include <math.h>

enum { JOINTS = 600 };

typedef struct help { sp_demand of[JOINTS]; sp_cost cost; } help;

/* Help for a scene of which it is known that its admissible forces miss balance by `least`. */
static int ask(const sp_scene *scene, double least, help *h)
{
    sp_problem pb;
    sp_state state;
    sp_settings set;
    const size_t used = test_arena.used;
    memset(&set, 0, sizeof set);
    memset(&state, 0, sizeof state);
    memset(h, 0, sizeof *h);
    set.tol = TOL(SP_TOL_PRECISE, SP_TOL_STANDARD);
    set.penalty.gamma = 1000;
    set.penalty.tau = 1;
    set.iterations = SP__ITERATIONS;
    state.left = INT64_MAX / 4;
    if (!CHECK(scene->count.joints <= JOINTS) || !CHECK_INT(sp_problem_build(scene, &test_arena, &pb), SP_OK)) return 0;
    state.y = sp__take(&test_arena, (size_t)pb.blocks, 6 * sizeof *state.y);
    if (!CHECK(state.y != NULL)) return 0;
    const sp_status status = sp__penalty_run(&pb, &set, R(least), &state, &test_arena, h->of);
    h->cost = state.cost;
    test_arena.used = used;
    return CHECK_INT(status, SP_OK);
}

static double larger(double a, double b) { return a > b ? a : b; }

TEST(less_is_solved_and_shows_the_same_help)
{
    static const struct { const char *name, *number; double value, tilt; } fall[] = {
        { "wall", "size", 54, 20 }, { "arch", "t", 0.1, 0 }, { "dome", "t", 0.02, 0 }, { "vault", "t", 0.08, 0 }
    };
    static help whole, enough;
    int64_t spent[2] = { 0, 0 };
    for (size_t k = 0; k < sizeof fall / sizeof fall[0]; k++) {
        sp_scene s;
        test_arena.used = 0;
        NEED(gen_make(fall[k].name, fall[k].number, fall[k].value, &test_arena, &s) == SP_OK);
        if (fall[k].tilt > 0) gen_gravity(fall[k].tilt, 90, s.gravity);
        NEED(ask(&s, 0, &whole) && ask(&s, 1, &enough));
        double most = 0, off = 0;
        for (int32_t i = 0; i < s.count.joints; i++) {
            const sp_demand *a = &whole.of[i], *b = &enough.of[i];
            most = larger(most, larger((double)a->tension, (double)a->friction));
            off = larger(off, larger(fabs((double)(a->tension - b->tension)), fabs((double)(a->friction - b->friction))));
        }
        CHECK(most > 0);
        CHECK(off <= TOL(1e-3, 1e-2) * most);
        spent[0] += whole.cost.factorisations;
        spent[1] += enough.cost.factorisations;
    }
    CHECK(TOL(1, 0) ? spent[1] < spent[0] : spent[1] <= spent[0]);
}

TEST_LIST(penalty)
    RUN(less_is_solved_and_shows_the_same_help)
TEST_END
