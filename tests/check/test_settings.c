/* Settings and arguments that make no sense are refused and nothing is touched; those at the ends of their ranges are taken. */
#include "../scenes/stages.h"

/* --------------------------------------------------------------------------------------------------------------- refusals */

static void refused(const sp_scene *s, const sp_settings *set, sp_status want, const char *what)
{
    const sp_arena before = test_arena;
    size_t bytes = 7;
    sp_result r;
    memset(&r, 0x5a, sizeof r);
    if (!CHECK_INT(sp_check(s, set, &test_arena, &r), want) || !untouched(&r, &test_arena, &before)) TEST_PRINT("    %s\n", what);
    CHECK_INT(sp_memory(s, SP_FOR_CHECK, set, test_arena, &bytes), want);
    CHECK_INT(bytes, 7);
    sp_evidence e = { SP_STABLE, 1, 2, 3, SP_NONE, 0, 0 };
    memset(&r, 0, sizeof r);
    r.f = &s->point[0][0];                              /* numbers of the right count, whatever they say */
    r.dq = &s->point[0][0];
    CHECK_INT(sp_verify(s, set, &r, test_arena, &e), want);
    CHECK_INT(e.verdict, SP_STABLE);
}

TEST(settings_out_of_range_are_refused_and_nothing_is_touched)
{
    static const double no_tol[] = { 0, -1e-9, TOL(4e-16, 2e-7), 0.11, 1, NAN, INFINITY, -INFINITY };
    static const double no_bound[] = { -1, -1e-30, NAN, INFINITY, -INFINITY };
    static const double no_weight[] = { 0, -1, NAN, INFINITY, -INFINITY };
    static const int32_t no_faces[] = { -1, 1, 2, 65, INT32_MAX, INT32_MIN }, no_count[] = { -1, 0, 7, INT32_MAX, INT32_MIN };
    sp_scene s;
    sp_settings set;
    build("two-cubes", NULL, 0, &s);
#define REFUSE(list, field, number) \
    for (size_t k = 0; k < sizeof list / sizeof list[0]; k++) { \
        set = sp_settings_default(); \
        set.field = number(list[k]); \
        refused(&s, &set, SP_E_RANGE, #field); \
    }
    REFUSE(no_tol, tol, R)
    REFUSE(no_bound, force_bound, R)
    REFUSE(no_weight, penalty.gamma, R)
    REFUSE(no_weight, penalty.tau, R)
    REFUSE(no_faces, faces, (int32_t))
    REFUSE(no_count, stage_count, (int32_t))
#undef REFUSE
    set = sp_settings_default();
    set.iterations = -1;
    refused(&s, &set, SP_E_RANGE, "iterations");
}

TEST(stages_that_do_not_exist_are_refused)
{
    static const sp_stage no_run = { NULL, custom_need }, no_need = { custom_run, NULL };
    static const sp_qp_solver nothing = { NULL, NULL, NULL };
    static const int odd[] = { SP_STAGE_NONE, SP_STAGE_CUSTOM + 1, 1000, -1 };
    sp_scene s;
    sp_settings set;
    build("two-cubes", NULL, 0, &s);
    for (size_t k = 0; k < sizeof odd / sizeof odd[0]; k++)
        for (int place = 0; place < 2; place++) {
            set = sp_settings_default();
            set.stage[place] = (sp_stage_id)odd[k];
            refused(&s, &set, SP_E_ARGUMENT, "stage");
        }
    set = own(SP_STAGE_NONE);
    set.custom = NULL;
    refused(&s, &set, SP_E_ARGUMENT, "no custom stage");
    set.custom = &no_run;
    refused(&s, &set, SP_E_ARGUMENT, "no run");
    set.custom = &no_need;
    refused(&s, &set, SP_E_ARGUMENT, "no need");
    set = sp_settings_default();
    set.penalty.solver = &nothing;
    refused(&s, &set, SP_E_ARGUMENT, "no solve");
    set = sp_settings_default();
    set.stage[2] = (sp_stage_id)1000;                   /* beyond the count: not looked at */
    CHECK_INT(check(&s, &set).verdict, SP_STABLE);
}

TEST(settings_at_the_ends_of_their_ranges_are_taken)
{
    sp_scene s;
    build("two-cubes", NULL, 0, &s);
    for (int k = 0; k < 10; k++) {
        sp_settings set = sp_settings_default();
        if (k == 0) set.tol = 4 * SP_EPSILON;
        if (k == 1) set.tol = R(0.1);
        if (k == 2) set.faces = 3;
        if (k == 3) set.faces = 64;
        if (k == 4) set.iterations = INT32_MAX;
        if (k == 5) set.force_bound = R(TOL(1e300, 1e38));
        if (k == 6) set.penalty.gamma = set.penalty.tau = R(1e-6);
        if (k == 7) set.penalty.gamma = set.penalty.tau = R(1e6);
        if (k == 8) set.stage_count = SP_STAGES_MAX;
        for (int i = 0; k == 8 && i < SP_STAGES_MAX; i++) set.stage[i] = i < SP_STAGES_MAX - 1 ? SP_STAGE_GATES : SP_STAGE_EXACT;
        const size_t mark = test_arena.used;
        const sp_result r = check(&s, k == 9 ? NULL : &set);
        test_arena.used = mark;
        if (k) CHECK_INT(r.verdict, SP_STABLE);         /* 4 u is more than rounding may allow */
        else CHECK(r.verdict != SP_UNSTABLE);
    }
}

/* A joint may miss its balance by an eighth of its friction at most, but no check is finer than four roundings. */
TEST(little_friction_is_checked_more_finely)
{
    static const double factor[] = { 0.5, 1, 4, 8, 1e3 };
    const sp_real tol = sp_settings_default().tol;
    for (int k = 0; k < 7; k++) {
        sp_scene s;
        test_arena.used = 0;
        build("two-cubes", NULL, 0, &s);
        const sp_real mu = k < 5 ? R(factor[k]) * SP_EPSILON : k == 5 ? R(4) * tol : 8 * tol;
        s.joint[0].strength.mu = mu;
        const sp_result r = check(&s, NULL);
        const sp_real want = mu / 8 > 4 * SP_EPSILON ? mu / 8 : 4 * SP_EPSILON;
        CHECK_WITHIN(r.tol, want < tol ? want : tol, 0);
    }
}

TEST(arguments_that_are_missing_are_refused)
{
    sp_scene s, none;
    sp_arena empty = { NULL, 0, 0, 0 };
    sp_result r;
    size_t bytes = 7;
    const sp_capacity cap = { 1, 0, 0, 0, 0, 0, 0 };
    build("two-cubes", NULL, 0, &s);
    CHECK_INT(sp_scene_create(&none, &cap, &test_arena), SP_OK);
    memset(&r, 0x5a, sizeof r);
    const sp_arena before = test_arena;
    CHECK_INT(sp_check(NULL, NULL, &test_arena, &r), SP_E_ARGUMENT);
    CHECK_INT(sp_check(&s, NULL, NULL, &r), SP_E_ARGUMENT);
    CHECK_INT(sp_check(&s, NULL, &empty, &r), SP_E_ARGUMENT);
    CHECK_INT(sp_check(&s, NULL, &test_arena, NULL), SP_E_ARGUMENT);
    CHECK_INT(sp_check(&none, NULL, &test_arena, &r), SP_E_EMPTY);
    CHECK_INT(sp_memory(NULL, SP_FOR_CHECK, NULL, test_arena, &bytes), SP_E_ARGUMENT);
    CHECK_INT(sp_memory(&s, SP_FOR_CHECK, NULL, empty, &bytes), SP_E_ARGUMENT);
    CHECK_INT(sp_memory(&s, SP_FOR_CHECK, NULL, test_arena, NULL), SP_E_ARGUMENT);
    CHECK_INT(sp_memory(&none, SP_FOR_CHECK, NULL, test_arena, &bytes), SP_E_EMPTY);
    CHECK_INT(bytes, 7);
    s.gravity[0] = R(INFINITY);
    CHECK_INT(sp_check(&s, NULL, &test_arena, &r), SP_E_NOT_FINITE);
    s.gravity[0] = R(TOL(1e306, 1e36));                 /* the load overflows */
    CHECK_INT(sp_check(&s, NULL, &test_arena, &r), SP_E_NOT_FINITE);
    untouched(&r, &test_arena, &before);
}

TEST_LIST(settings)
    RUN(settings_out_of_range_are_refused_and_nothing_is_touched)
    RUN(stages_that_do_not_exist_are_refused)
    RUN(settings_at_the_ends_of_their_ranges_are_taken)
    RUN(little_friction_is_checked_more_finely)
    RUN(arguments_that_are_missing_are_refused)
TEST_END
