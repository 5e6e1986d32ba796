/* Which multiples are asked, and what is made of the answers: Newton's method, the lowest multiple, the upper end and checks
 * between both ends, each alone, in worlds that answer by formulas: it stands from `low` to `high`, without rounding. */
#define SP_API static
#include "../scenes/tally.h"
#include "../base/fence.h"
#include "../../solvers/base/words.c"
#include "../../solvers/scene/scene.c"
#include "../../solvers/scene/block.c"
#include "../../solvers/limit/exact.c"

#if SP__WITH_INTERIOR

/* Multiples are in ref. open: how near to low and high questions stay open. share: a motion found beyond has its balance so far
 * on the way back, 1: at low or high. free: live loads alone are balanced. idle: they do nothing in the motion, 2: that falls
 * above 0 alone. lies: what is open is said to fall. rough: work, over
 * ref, that a proof takes. */
typedef struct world {
    double low, high, open, share;
    int free, idle, lies;
    double rough;
} world;

enum { ASKED = 8 };
static world here;
static double heard[ASKED];
static int questions, checks, proofs;
static double proved;                                   /* where a proof was asked last */
static int failing;                                     /* proofs are none, though they write what moves */

static void note(double a) { if (questions < ASKED) heard[questions] = a; questions++; }

/* The motion whose work is that of (a - balance) live, for the loads of cast. */
static void motion(sp__bracket *b, double balance, double side, double ref)
{
    memset(b->dq, 0, 6 * (size_t)b->pb.blocks * sizeof *b->dq);
    b->dq[0] = R(here.idle ? 1 : balance * ref * side);
    b->dq[7] = R(here.idle ? 0 : side);
    b->resist = 0;
}

static sp_verdict answer(sp__bracket *b, double a, double ref)
{
    const double d = here.open;
    if (a > here.low + d && a < here.high - d) return SP_STABLE;
    if (a > here.high + d) motion(b, a + (here.high - a) * here.share, 1, ref);
    else if (a < here.low - d) motion(b, a + (here.low - a) * here.share, -1, ref);
    else if (here.lies) memset(b->dq, 0, 12 * sizeof *b->dq);
    else return SP_UNDECIDED;
    return SP_UNSTABLE;
}

static double ref_now;                                  /* ref of the limit at hand */

static sp_verdict world_ask(sp__engine *g, sp__bracket *b, sp_real d, sp_real l, sp_real *f)
{
    g->n.left--;
    note(d > 0 ? (double)l / ref_now : -(double)l / ref_now);
    b->imbalance = R(questions);
    f[0] = R(questions);
    if (d > 0) return answer(b, (double)l / ref_now, ref_now);
    if (here.free) return SP_STABLE;
    return answer(b, 1e9, ref_now);
}

static int world_check(sp__engine *g, sp__bracket *b, sp_real l, int all, sp_real *f)
{
    (void)g;
    if (!all) note((double)l / ref_now);
    checks++;
    b->imbalance = f[0] = R(questions);
    memset(b->dq, 0, 6 * (size_t)b->pb.blocks * sizeof *b->dq);
    return all && answer(b, (double)l / ref_now, ref_now) == SP_STABLE;       /* the first of both never */
}

/* What a result keeps of the motion at hand; a proof that is not one writes it, too. */
static void world_write(const sp__bracket *b, sp_real *all)
{
    if (!all) return;
    memset(all, 0, 18 * sizeof *all);
    for (int k = 0; k < 12; k++) all[6 * b->pb.block[k / 6] + k % 6] = b->dq[k];
}

/* Does the motion at hand fall there? Work: -dq0 + l dq7 - resist. */
static int world_falls(sp__bracket *b, sp_real lambda, int beyond, sp_real *all)
{
    const double work = -(double)b->dq[0] + (double)lambda * (double)b->dq[7] - (double)b->resist;
    const double least = (here.rough > 0 ? here.rough : 1e-12) * ref_now;
    proofs++;
    proved = (double)lambda / ref_now;
    if (here.idle && (!(b->dq[0] > 0) || (here.idle > 1 && !(lambda > 0)))) return 0;
    if (!here.idle && !(work > least)) return 0;
    world_write(b, all);
    if (failing || (beyond && b->dq[7] < 0)) return 0;
    b->least = R(work);
    b->final = 1;
    return 1;
}

static int world_engine_falls(sp__bracket *b, sp_real lambda, int *beyond)
{
    *beyond = world_falls(b, lambda, 1, NULL);
    return *beyond || world_falls(b, lambda, 0, NULL);
}

/* Counts as a hundred proofs; of the motion twice as much is as good. */
static int world_resists(sp__bracket *b, sp_real lambda)
{
    for (int k = 0; k < 12; k++) b->dq[k] *= 2;
    proofs += 100;
    proved = (double)lambda / ref_now;
    return 1;
}

static int world_unbounded(sp__bracket *b, sp_real *f, sp_real lambda, sp_real ref)
{
    (void)b; (void)f; (void)lambda; (void)ref;
    return here.free;
}

static int world_stands(sp__bracket *b, sp_real d, sp_real l, const sp_real *f, sp_real *admitted)
{
    (void)f; (void)d; (void)admitted;
    b->imbalance = R(0.5);
    return (double)l / ref_now > here.low && (double)l / ref_now < here.high;
}

#define sp__engine_ask world_ask
#define sp__engine_check world_check
#define sp__engine_falls world_engine_falls
#define sp__engine_unbounded world_unbounded
#define sp__bracket_falls world_falls
#define sp__bracket_resists world_resists
#define sp__bracket_stands world_stands
#include "parts.h"

static sp__limit *L;

/* Two cubes, one on the other. */
static void pile(int strong)
{
    const sp_capacity cap = { 3, 0, 0, 0, 2, 8, 0 };
    const sp_real foot[12] = { 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0 }, ground[3] = { R(0.5), R(0.5), R(-5) };
    const sp_strength joint = { R(0.5), strong ? 1000 : 0, 0, 0 };
    sp_real xyz[12];
    test_arena.used = 0;
    CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
    CHECK_INT(sp_scene_body(&s, 0, ground, SP_FIXED, NULL), SP_OK);
    for (int k = 0; k < 2; k++) {
        const sp_real middle[3] = { R(0.5), R(0.5), R(0.5 + k) };
        for (int e = 0; e < 12; e++) xyz[e] = foot[e] + (e % 3 == 2 ? (sp_real)k : 0);
        CHECK_INT(sp_scene_body(&s, R(1000), middle, 0, NULL), SP_OK);
        CHECK_INT(sp_scene_joint(&s, k, k + 1, 4, xyz, &joint, NULL), SP_OK);
    }
}

/* Its limit; dead loads are 1 on the first number of the lower cube, live loads 1 on the second of the upper one. */
static void cast(const world *w, double ref)
{
    set = sp_settings_default();
    const size_t numbers = sp__limit_room(&s), bytes = 12 * sizeof(sp_real);
    sp_real *number = fenced_take(&test_arena, numbers, sizeof *number);
    L = fenced_take(&test_arena, 1, sizeof *L);
    memset(number, 0, numbers * sizeof *number);
    memset(L, 0, sizeof *L);
    CHECK_INT(sp__limit_build(L, &s, &set, number, &test_arena), SP_OK);
    sp_real *clear[5] = { L->bracket.dead, L->bracket.live, L->bracket.dq, L->upper, L->lower };
    for (int k = 0; k < 5; k++) memset(clear[k], 0, bytes);
    L->bracket.dead[0] = -1;
    L->bracket.live[7] = 1;
    L->ref = R(ref);
    here = *w;
    ref_now = ref;
    questions = checks = proofs = 0;
    proved = 0;
    memset(heard, 0, sizeof heard);
}

/* is: what each test says; questions, checks, proofs: how many; forces: of which question those of the lower end are; ends in
 * ref; proved: where a proof was asked last; asked: the first of the multiples. */
typedef struct told {
    int is, questions, checks, proofs, forces;
    double lower, upper, least, proved, asked[ASKED];
} told;

/* best, lower, upper: known at first, in ref, -1: none. from: what each test says. strong: joints have strength. kind: of the
 * result at first. left: questions, 0: all. */
typedef struct search {
    world of;
    double ref, tol, best, lower, upper, from;
    int strong, kind, left;
    told is;
} search;

static int alike(double x, double y) { return fabs(x - y) <= 1e-9 * (1 + fabs(x)); }

static void compare(const char *what, size_t k, const told *want, int is, double upper, double least)
{
    const double lower = L->r.lower < 0 ? -1 : (double)L->r.lower / ref_now;
    const int forces = (int)L->r.f[0];
    int same = is == want->is && questions == want->questions && checks == want->checks && proofs == want->proofs
            && forces == want->forces && (forces == 0 || forces == (int)L->r.imbalance);
    same = same && alike(lower, want->lower) && alike(upper, want->upper) && alike(least, want->least)
        && alike(proved, want->proved);
    for (int e = 0; e < ASKED; e++) same = same && alike(heard[e], want->asked[e]);
    CHECK(here.high < 0 || !(lower > here.high));       /* the limit lies between both ends */
    CHECK(upper < 0 || here.idle || here.low > here.high || !(upper < here.high * (1 - 1e-6)));
    if (!COUNTED || CHECK(same)) return;
    TEST_PRINT("    %s, row %d: { %d, %d, %d, %d, %d, %.10g, %.10g, %.10g, %.10g, {", what, (int)k, is, questions, checks,
               proofs, forces, lower, upper, least, proved);
    for (int e = 0; e < ASKED && (!e || e < questions); e++) TEST_PRINT("%s%.10g", e ? ", " : " ", heard[e]);
    TEST_PRINT(" } }\n");
}

static void begin(const search *r)
{
    pile(r->strong);
    cast(&r->of, r->ref);
    L->bracket.set.tol = L->r.tol = R(r->tol);
    if (r->best >= 0) L->best = R(r->best);
    L->r.lower = R(r->lower < 0 ? -1 : r->lower * r->ref);
    L->r.upper = R(r->upper < 0 ? -1 : r->upper * r->ref);
    L->r.kind = (sp_limit_kind)r->kind;
    if (r->left) L->engine.n.left = r->left;
    motion(&L->bracket, r->best >= 0 ? r->best : r->upper, 1, r->ref);
    world_falls(&L->bracket, R(r->upper * r->ref), 0, L->r.dq);
    proofs = 0;
}

static double found(sp_real x) { return sp__abs(x) < SP__HUGE ? (double)x : -9; }

#include "asked_rows.h"

/* Is the motion at hand that of this balance? */
static int of_balance(sp_real x) { return alike(found(sp__limit_balance(L)), found(x)); }

/* is: 1: the lower end is found, 10: nothing stands, 100: dead loads stand, 1000: the last collapse gained little, 10000: the
 * motion at hand is that of the best balance. */
TEST(newton_asks_the_multiples_written_here)
{
    for (size_t k = 0; k < sizeof newton_rows / sizeof *newton_rows; k++) {
        begin(&newton_rows[k]);
        const int done = sp__limit_newton(L);
        const int is = done + 10 * L->none + 100 * (int)L->r.dead + 1000 * L->slow + 10000 * of_balance(L->best);
        compare("newton", k, &newton_rows[k].is, is, found(L->best), found(L->least));
        whole();
    }
}

/* from: asked first. is: of the dead loads. */
TEST(the_lowest_multiple_is_asked_as_written_here)
{
    for (size_t k = 0; k < sizeof lowest_rows / sizeof *lowest_rows; k++) {
        begin(&lowest_rows[k]);
        sp__limit_lowest(L, R(lowest_rows[k].from));
        compare("lowest", k, &lowest_rows[k].is, (int)L->r.dead, (double)L->r.upper / ref_now, (double)L->r.lowest / ref_now);
        whole();
    }
}

/* from: the largest balance that live loads hinder. is: 1: questions are left, 10: nothing stands, 100: the motion at hand is
 * that of the upper end, 1000: there is one. */
TEST(checks_between_both_ends_are_asked_as_written_here)
{
    for (size_t k = 0; k < sizeof between_rows / sizeof *between_rows; k++) {
        begin(&between_rows[k]);
        L->least = R(between_rows[k].from);
        motion(&L->bracket, between_rows[k].from, -1, ref_now);
        memcpy(L->lower, L->bracket.dq, 12 * sizeof *L->lower);
        sp__limit_halve(L);
        const int is = L->engine.n.left + 10 * L->none + 100 * of_balance(L->best) + 1000 * (L->best < SP__HUGE);
        compare("halve", k, &between_rows[k].is, is, (double)L->r.upper / ref_now, (double)L->least);
        for (int e = 0; e < 18 && L->r.upper >= 0; e++) /* of the nearest upper end, in the scene's numbers */
            CHECK_WITHIN(2 * L->r.dq[e], L->none ? 2 * L->r.dq[e] : e < 6 ? 0 : L->upper[e - 6], 0);
        whole();
    }
}

/* Of live loads alone the multiple is asked where the motion before falls. */
TEST(live_loads_alone_are_asked_again_where_they_fall)
{
    static const world stands = { -1, 2, 0, 1, 0, 0, 0, 0 };
    pile(1);
    cast(&stands, 3);
    sp__limit_live_alone(L);
    CHECK_WITHIN(L->best, 2, TOL(1e-9, 1e-4));
    CHECK_WITHIN(proved, 2, TOL(1e-9, 1e-4));
    CHECK_INT(questions, 1);
    whole();
}

/* A collapse that live loads hinder less than another one gains nothing. */
TEST(a_collapse_that_gains_nothing_leaves_the_bound)
{
    static const world stands = { -1, 2, 0, 1, 0, 0, 0, 0 };
    sp_real a = R(0.2);
    pile(0);
    cast(&stands, 3);
    L->best = 4;
    L->least = 1;
    motion(&L->bracket, 0.5, -1, 3);
    CHECK_INT(sp__limit_bound_by_collapse(L, &a, R(0.25)), 1);
    CHECK_WITHIN(L->least, 1, 0);
    CHECK_WITHIN(a, 0.75, TOL(1e-12, 1e-6));
    whole();
}

/* It falls above 2: at 1.9 the motion proves nothing, and stays. */
TEST(a_motion_that_proves_no_upper_end_stays)
{
    static const world stands = { -1, 2, 0, 1, 0, 0, 0, 0 };
    for (int k = 0; k < 2; k++) {
        pile(0);
        cast(&stands, 3);
        motion(&L->bracket, 2, 1, 3);
        L->slack = 5;
        for (int e = 0; e < 12; e++) L->upper[e] = 7;
        CHECK_INT(sp__limit_upper_near(L, R(k ? 2.5 : 1.9) * 3), k);
        CHECK_WITHIN(L->slack, k ? 0 : 5, 0);
        CHECK_WITHIN(L->upper[7], k ? 1 : 7, 0);
        CHECK_INT(L->r.upper < 0, !k);
        whole();
    }
}

/* Proofs that fail write what moves, twice as much: at last it is that of the upper end again. */
TEST(a_result_keeps_the_motion_of_its_upper_end_where_others_prove_nothing)
{
    begin(&between_rows[0]);
    sp_real kept[18];
    memcpy(kept, L->r.dq, sizeof kept);
    L->least = 0;
    failing = 1;
    sp__limit_halve(L);
    failing = 0;
    CHECK(proofs > 100);
    for (int e = 0; e < 18; e++) CHECK_WITHIN(L->r.dq[e], kept[e], 0);
    for (int e = 0; e < 12; e++) CHECK_WITHIN(L->bracket.dq[e], 2 * kept[6 + e], 0);
    CHECK_WITHIN(L->r.upper, 12, 0);
    whole();
}

/* All of both cubes' motion. */
TEST(the_best_motion_is_proved_where_it_fell)
{
    static const world stands = { -1, 2, 0, 1, 0, 0, 0, 0 };
    pile(0);
    cast(&stands, 3);
    for (int e = 0; e < 12; e++) L->upper[e] = R(e + 1);
    L->fell = 2;
    CHECK_INT(sp__limit_upper_fell(L, 3), 1);
    for (int e = 0; e < 12; e++) CHECK_WITHIN(L->bracket.dq[e], e + 1, 0);
    CHECK_WITHIN(L->r.upper, 6, 0);
    whole();
}

/* from: 1: there is no end. is: 1: the verdict of dead loads, 10: the kind, 100: questions that are left. */
TEST(what_is_open_at_last_is_asked_as_written_here)
{
    for (size_t k = 0; k < sizeof open_rows / sizeof *open_rows; k++) {
        begin(&open_rows[k]);
        for (int e = 0; e < 12; e++) L->lower[e] = 7;
        sp__limit_last(L, open_rows[k].from > 0);
        for (int e = 0; e < 12 && checks && !(L->least > 0); e++) CHECK_WITHIN(L->lower[e], 0, 0);
        const int is = (int)L->r.dead + 10 * (int)L->r.kind + 100 * L->engine.n.left;
        compare("last", k, &open_rows[k].is, is, (double)L->r.upper / ref_now, (double)L->r.lowest / ref_now);
        whole();
    }
}

/* upper: where the best motion was proved to fall. from: slack. is: final. */
TEST(the_upper_end_is_asked_as_written_here)
{
    for (size_t k = 0; k < sizeof upper_rows / sizeof *upper_rows; k++) {
        begin(&upper_rows[k]);
        memcpy(L->upper, L->bracket.dq, 12 * sizeof *L->upper);
        if (upper_rows[k].from > 0) motion(&L->bracket, 1e6, 1, ref_now);        /* proves nothing near */
        if (upper_rows[k].upper >= 0) L->fell = R(upper_rows[k].upper);
        L->r.upper = -1;
        L->slack = R(upper_rows[k].from);
        sp__limit_upper(L);
        compare("upper", k, &upper_rows[k].is, (int)L->r.final, (double)L->r.upper / ref_now, (double)L->r.least_imbalance);
        whole();
    }
}

#endif

TEST_LIST(asked)
#if SP__WITH_INTERIOR
    RUN(newton_asks_the_multiples_written_here)
    RUN(the_lowest_multiple_is_asked_as_written_here)
    RUN(checks_between_both_ends_are_asked_as_written_here)
    RUN(what_is_open_at_last_is_asked_as_written_here)
    RUN(live_loads_alone_are_asked_again_where_they_fall)
    RUN(a_collapse_that_gains_nothing_leaves_the_bound)
    RUN(the_upper_end_is_asked_as_written_here)
    RUN(a_motion_that_proves_no_upper_end_stays)
    RUN(a_result_keeps_the_motion_of_its_upper_end_where_others_prove_nothing)
    RUN(the_best_motion_is_proved_where_it_fell)
#endif
TEST_END
