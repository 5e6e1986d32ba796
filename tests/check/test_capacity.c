/* Every capacity from nothing to what a call needs, by the default settings and by others that take other memory: it refuses with
 * SP_E_MEMORY, touches neither result nor arena and no byte behind, until it has enough; from there on it answers. */
#include "../test.h"
#include "../scenes/gen.h"

#include <stdint.h>
#include <string.h>

enum { FENCE = 64, PAINT = 0x5a };

/* What is asked, with a scene, its result of an ordinary check, and a result that is painted before every call. */
typedef struct question {
    const sp_scene *scene;
    const sp_settings *set;                             /* NULL: the default ones */
    const sp_result *checked;
    sp_arena result;                                    /* of a check whose stages work elsewhere */
#ifndef SP_NO_IPM
    const sp_limit_result *limited;
#endif
#ifndef SP_NO_STRONG
    const sp_strong_result *strong;
#endif
#ifndef SP_NO_SLIDING
    const sp_sliding_result *slid;
#endif
    const sp_problem *problem;
    union {
        sp_result check;
        sp_evidence verify;
        int32_t held;
#ifndef SP_NO_PLAN
        sp_outlook plan;
#endif
        sp_contact_report report;
        sp_support support;
        sp_rest rest;
        sp_nbo reason;
        sp_triplets triplets;
        sp_csc columns;
        sp_scene made;
        sp_sequence *sequence;
        sp_problem problem;
        size_t bytes;
#ifndef SP_NO_IPM
        sp_limit_result limit;
#endif
#ifndef SP_NO_QP
        sp_qp_result qp;
        sp_qp_work *work;
#endif
#ifndef SP_NO_STRONG
        sp_strong_result strong;
        sp_strong_kind proved;
#endif
#ifndef SP_NO_SLIDING
        sp_sliding_result sliding;
        sp_sliding_evidence slid;
#endif
    } answer;
} question;

typedef sp_status (*call)(question *q, sp_arena *a);

static sp_status ask_check(question *q, sp_arena *a) { return sp_check(q->scene, q->set, a, &q->answer.check); }
static sp_status ask_verify(question *q, sp_arena *a) { return sp_verify(q->scene, q->set, q->checked, *a, &q->answer.verify); }
static sp_status ask_work_arena(question *q, sp_arena *a)
{
    sp_settings set = *q->set;
    sp_arena whole = q->result;
    set.work = a;
    const sp_status status = sp_check(q->scene, &set, &whole, &q->answer.check);
    CHECK(status == SP_OK || whole.used == 0);
    return status;
}
static sp_status ask_sequence(question *q, sp_arena *a) { return sp_sequence_open(q->scene, NULL, a, &q->answer.sequence); }
static sp_status ask_problem(question *q, sp_arena *a) { return sp_problem_build(q->scene, a, &q->answer.problem); }
static sp_status ask_memory(question *q, sp_arena *a) { return sp_memory(q->scene, SP_FOR_CHECK, NULL, *a, &q->answer.bytes); }
#ifndef SP_NO_IPM
static sp_status ask_limit(question *q, sp_arena *a) { return sp_limit(q->scene, NULL, a, &q->answer.limit); }
static sp_status ask_held(question *q, sp_arena *a)
{
    return sp_limit_verify(q->scene, NULL, q->limited, *a, &q->answer.held);
}
#endif
#ifndef SP_NO_STRONG
static sp_status ask_strong(question *q, sp_arena *a)
{
    const sp_strong_settings few = { 2, 0 };
    return sp_strong(q->scene, NULL, &few, q->checked->f, NULL, a, &q->answer.strong);
}
static sp_status ask_proved(question *q, sp_arena *a)
{
    return sp_strong_verify(q->scene, NULL, q->strong, *a, &q->answer.proved);
}
#endif
#ifndef SP_NO_SLIDING
static const sp_sliding_settings brief = { 1, 2, 1 };
static sp_status ask_sliding(question *q, sp_arena *a)
{
    return sp_sliding(q->scene, NULL, &brief, q->limited, a, &q->answer.sliding);
}
static sp_status ask_slid(question *q, sp_arena *a) { return sp_sliding_verify(q->scene, NULL, q->slid, *a, &q->answer.slid); }
#endif
#ifndef SP_NO_PLAN
static sp_status ask_plan(question *q, sp_arena *a) { return sp_plan(q->scene, NULL, *a, &q->answer.plan); }
#endif

/* Contacts of the scene's blocks, where there is room for none: counted is enough. */
static sp_status ask_contacts(question *q, sp_arena *a)
{
    sp_scene s = *q->scene;
    s.count.joints = s.count.points = s.capacity.joints = s.capacity.points = 0;
    const sp_status status = sp_contacts_find(&s, NULL, *a, &q->answer.report);
    return status == SP_E_CAPACITY ? SP_OK : status;
}

static sp_status ask_created(question *q, sp_arena *a) { return sp_scene_create(&q->answer.made, &q->scene->count, a); }
static sp_status ask_rows(question *q, sp_arena *a) { return sp_matrix_aeq(q->problem, 4, a, &q->answer.triplets); }
static sp_status ask_cones(question *q, sp_arena *a)
{
    sp_settings set = sp_settings_default();
    set.faces = 4;
    return sp_matrix_afr(q->problem, &set, 3, a, &q->answer.triplets);
}
static sp_status ask_columns(question *q, sp_arena *a)
{
    static int32_t i[3] = { 0, 1, 0 }, j[3] = { 1, 0, 1 };
    static sp_real x[3] = { 1, 2, 3 };
    const sp_triplets t = { 2, 2, 3, i, j, x };
    return sp_csc_from(&t, a, &q->answer.columns);
}

/* Where a stone is set. */
static const sp_real square[12] = { 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0 }, down[3] = { 0, 0, -1 }, middle[3] = { R(0.5), R(0.5), 1 };
static sp_status ask_support(question *q, sp_arena *a)
{
    return sp_support_clearance(square, 4, middle, down, *a, &q->answer.support);
}
static sp_status ask_laid(question *q, sp_arena *a)
{
    const sp_laid laid = { square, 4, { R(0.5), R(0.5), 1 }, { 0, 0, -1 }, 1, 1 };
    return sp_nbo_gate(&laid, down, NULL, *a, &q->answer.reason, NULL);
}
static sp_status ask_rest(question *q, sp_arena *a)
{
    static const sp_real corner[12] = { 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1 };
    static const int32_t size[4] = { 3, 3, 3, 3 }, face[12] = { 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3 };
    const sp_mesh mesh = { 4, 4, corner, size, face };
    int32_t count;
    const sp_status status = sp_rest_faces(&mesh, *a, &q->answer.rest, 1, &count);
    return status == SP_E_CAPACITY ? SP_OK : status;
}

#ifdef SP_NO_QP
static sp_status ask_qp(question *q, sp_arena *a) { (void)q; (void)a; return SP_OK; }
#else
static sp_qp program(void)
{
    static const sp_real x[2] = { 1, 1 }, c[2] = { -1, 2 }, l[1] = { 0 }, u[1] = { 1 };
    static const int32_t start[3] = { 0, 1, 2 }, rows[2] = { 0, 0 }, first[3] = { 0, 1, 1 }, diagonal[1] = { 0 };
    static const sp_real p[1] = { 1 };
    const sp_qp qp = { 2, 1, first, diagonal, p, c, start, rows, x, l, u };
    return qp;
}
static sp_status ask_qp(question *q, sp_arena *a)
{
    const sp_qp qp = program();
    return sp_qp_solve(&qp, NULL, a, NULL, NULL, &q->answer.qp);
}
static sp_status solve_by(sp_qp_method method, sp_qp_backend backend, question *q, sp_arena *a)
{
    const sp_qp qp = program();
    sp_qp_settings set = sp_qp_default();
    set.method = method;
    set.backend = backend;
    return sp_qp_solve(&qp, &set, a, NULL, NULL, &q->answer.qp);
}
static sp_status ask_qp_admm(question *q, sp_arena *a) { return solve_by(SP_QP_ADMM, SP_QP_SPARSE, q, a); }
static sp_status ask_qp_dense(question *q, sp_arena *a) { return solve_by(SP_QP_ADMM, SP_QP_DENSE, q, a); }
#ifndef SP_QP_NO_INTERIOR
static sp_status ask_qp_interior(question *q, sp_arena *a) { return solve_by(SP_QP_INTERIOR, SP_QP_SPARSE, q, a); }
#endif
static sp_status ask_work(question *q, sp_arena *a)
{
    const sp_qp qp = program();
    return sp_qp_setup(&qp, NULL, a, &q->answer.work);
}
static sp_status ask_qp_memory(question *q, sp_arena *a)
{
    const sp_qp qp = program();
    return sp_qp_memory(&qp, NULL, *a, &q->answer.bytes);
}
#endif

/* All capacities up to `most` by `step`, then on until it answers.     returns the least that is enough */
static size_t sweep(question *q, call ask, size_t most, size_t step)
{
    const size_t from = (test_arena.used + SP_ALIGN - 1) / SP_ALIGN * SP_ALIGN;
    unsigned char *base = test_arena.base + from, painted[sizeof q->answer];
    size_t enough = SIZE_MAX;
    memset(painted, PAINT, sizeof painted);
    for (size_t bytes = 0; bytes <= most; bytes += step) {
        sp_arena a = { base, bytes, 0, 0 };
        memset(base + bytes, PAINT, FENCE);
        memset(&q->answer, PAINT, sizeof q->answer);
        const sp_status status = ask(q, &a);
        for (int k = 0; k < FENCE; k++) if (!CHECK_INT(base[bytes + (size_t)k], PAINT)) return 0;
        if (status == SP_OK) { if (bytes < enough) enough = bytes; continue; }
        if (!CHECK_INT(status, SP_E_MEMORY) || !CHECK(enough == SIZE_MAX)) return 0;
        if (!CHECK(memcmp(&q->answer, painted, sizeof painted) == 0) || !CHECK_INT(a.used, 0)) return 0;
    }
    return enough;
}

/* Other settings than the default ones. What a coupled check takes is told at most: the arch, pushed by `body`, falls before. */
typedef void (*choice)(sp_settings *set);
static void as_it_is(sp_settings *set) { (void)set; }
static void eight_faces(sp_settings *set) { set->faces = 8; }
#ifndef SP_NO_CRA
static void coupled(sp_settings *set) { set->coupled.asked = 1; set->coupled.nodes = 20; }
static void coupled_without_tree(sp_settings *set) { set->coupled.asked = 1; set->coupled.nodes = 0; }
#endif
#if !defined(SP_NO_QP) && !defined(SP_NO_ADMM)
static void admm(sp_settings *set) { set->stage_count = 1; set->stage[0] = SP_STAGE_ADMM; }
#endif

static const struct { const char *what; call ask; sp_memory_for need; int exact; choice choose; } table[] = {
    { "check", ask_check, SP_FOR_CHECK, 1, NULL }, { "verify", ask_verify, SP_FOR_VERIFY, 0, NULL },
    { "check, 8 faces", ask_check, SP_FOR_CHECK, 1, eight_faces }, { "verify, 8 faces", ask_verify, SP_FOR_VERIFY, 0, eight_faces },
    { "work of a check", ask_work_arena, SP_FOR_WORK, 1, as_it_is },
    { "work of a check, 8 faces", ask_work_arena, SP_FOR_WORK, 1, eight_faces },
#ifndef SP_NO_CRA
    { "check, coupled", ask_check, SP_FOR_CHECK, 0, coupled },
    { "check, coupled, no tree", ask_check, SP_FOR_CHECK, 0, coupled_without_tree },
#endif
#if !defined(SP_NO_QP) && !defined(SP_NO_ADMM)
    { "check by ADMM", ask_check, SP_FOR_CHECK, 1, admm },
#endif
    { "problem", ask_problem, SP_FOR_PROBLEM, 1, NULL },
    { "sequence", ask_sequence, SP_FOR_SEQUENCE, 1, NULL },
#ifndef SP_NO_IPM
    { "limit", ask_limit, SP_FOR_LIMIT, 0, NULL }, { "limit_verify", ask_held, SP_FOR_LIMIT_VERIFY, 0, NULL },
#endif
#ifndef SP_NO_STRONG
    { "strong", ask_strong, SP_FOR_STRONG, 0, NULL }, { "strong_verify", ask_proved, SP_FOR_STRONG_VERIFY, 0, NULL },
#endif
#ifndef SP_NO_SLIDING
    { "sliding", ask_sliding, SP_FOR_SLIDING, 0, NULL }, { "sliding_verify", ask_slid, SP_FOR_SLIDING_VERIFY, 0, NULL },
#endif
#ifndef SP_NO_PLAN
    { "plan", ask_plan, SP_FOR_PLAN, 0, NULL },
#endif
    { "contacts", ask_contacts, SP_FOR_CONTACTS, 0, NULL },
};

/* What follows from counts alone: the size that is told, 0 where none is, and then it is below `most`. */
static const struct { const char *what; call ask; size_t most; } alone[] = {
    { "matrix_aeq", ask_rows, 60000 }, { "matrix_afr", ask_cones, 60000 }, { "csc_from", ask_columns, 400 },
    { "support_clearance", ask_support, 0 }, { "nbo_gate", ask_laid, 0 }, { "rest_faces", ask_rest, 0 },
    { "scene_create", ask_created, 0 }, { "qp_solve", ask_qp, 8000 },
#ifndef SP_NO_QP
    { "qp_setup", ask_work, 8000 }, { "qp_memory", ask_qp_memory, 8000 },
    { "qp_solve by ADMM", ask_qp_admm, 8000 }, { "qp_solve, dense", ask_qp_dense, 8000 },
#ifndef SP_QP_NO_INTERIOR
    { "qp_solve by interior points", ask_qp_interior, 8000 },
#endif
#endif
};

static void counts_alone(question *q, const char *scene)
{
    const size_t told = sp_scene_memory(&q->scene->count);
    for (size_t k = 0; k < sizeof alone / sizeof alone[0]; k++) {
        const size_t need = alone[k].ask == ask_created ? told : alone[k].most ? alone[k].most : sp_support_memory(4);
        const size_t enough = sweep(q, alone[k].ask, need, alone[k].most > 8000 ? need / 400 | 1 : 1);
        if (enough == SIZE_MAX || !CHECK(alone[k].most ? enough < need : enough + SP_ALIGN > need))
            TEST_PRINT("    %s of %s: %ld of %ld bytes\n", alone[k].what, scene, (long)enough, (long)need);
        CHECK(enough < SIZE_MAX);
    }
}

/* Room for what a check keeps whose stages work elsewhere. */
static sp_status take_result(question *q, const sp_settings *settings)
{
    sp_settings set = *settings;
    sp_arena other = test_arena;
    size_t bytes = 0;
    set.work = &other;
    const sp_status status = sp_memory(q->scene, SP_FOR_CHECK, &set, test_arena, &bytes);
    const size_t from = (test_arena.used + SP_ALIGN - 1) / SP_ALIGN * SP_ALIGN;
    const sp_arena result = { test_arena.base + from, bytes, 0, 0 };
    q->result = result;
    test_arena.used = from + bytes;
    return status;
}

/* With every byte where the need is small, in steps of a word's length and one otherwise. */
TEST(every_capacity_is_refused_or_enough)
{
    static const char *const name[] = { "two-cubes", "arch" };
    for (int s = 0; s < SOME_OF(2, 1); s++) {
        sp_scene scene;
        sp_result r;
        test_arena.used = 0;
        NEED(gen_make(name[s], NULL, 0, &test_arena, &scene) == SP_OK);
        scene.body[0] = 1;
        NEED(sp_check(&scene, NULL, &test_arena, &r) == SP_OK);
        question q;
        memset(&q, 0, sizeof q);
        q.scene = &scene;
        q.checked = &r;
#ifndef SP_NO_IPM
        sp_limit_result limited;
        NEED(sp_limit(&scene, NULL, &test_arena, &limited) == SP_OK);
        q.limited = &limited;
#endif
        sp_problem pb;
        NEED(sp_problem_build(&scene, &test_arena, &pb) == SP_OK);
        q.problem = &pb;
#ifndef SP_NO_STRONG
        sp_strong_result strong;
        const sp_strong_settings few = { 2, 0 };
        NEED(sp_strong(&scene, NULL, &few, r.f, NULL, &test_arena, &strong) == SP_OK);
        q.strong = &strong;
#endif
#ifndef SP_NO_SLIDING
        sp_sliding_result slid;
        NEED(sp_sliding(&scene, NULL, &brief, &limited, &test_arena, &slid) == SP_OK);
        q.slid = &slid;
#endif
        for (size_t k = 0; k < sizeof table / sizeof table[0]; k++) {
            const sp_arena all = test_arena;
            sp_settings set = sp_settings_default();
            size_t need = 0;
            if (table[k].choose) table[k].choose(&set);
            q.set = table[k].choose ? &set : NULL;
            NEED(sp_memory(&scene, table[k].need, q.set, test_arena, &need) == SP_OK);
            if (table[k].need == SP_FOR_WORK) NEED(take_result(&q, &set) == SP_OK);
            const size_t step = need < 6000 ? 1 : need / SOME_OF(2000, 400) | 1;
            const size_t enough = sweep(&q, table[k].ask, need, step);
            if (enough == SIZE_MAX) {                   /* the last step ended before it */
                sp_arena a = { test_arena.base + (test_arena.used + SP_ALIGN - 1) / SP_ALIGN * SP_ALIGN, need, 0, 0 };
                if (!CHECK_INT(table[k].ask(&q, &a), SP_OK)) TEST_PRINT("    %s of %s\n", table[k].what, name[s]);
            } else if (!CHECK(enough > 0 && (!table[k].exact || enough + SP_ALIGN > need)))
                TEST_PRINT("    %s of %s: %ld of %ld bytes\n", table[k].what, name[s], (long)enough, (long)need);
            test_arena.used = all.used;
        }
        const size_t scratch = sweep(&q, ask_memory, sp_memory_scratch(&scene, SP_FOR_CHECK, NULL), 7);
        CHECK(scratch > 0);
        counts_alone(&q, name[s]);
    }
}

#if !defined SP_NO_IPM && !defined SP_SMALL
/* Of joints with strength a search that had no memory counted as undecided, and so did the limit, from half of its bytes on. */
TEST(a_limit_that_lacked_memory_was_undecided)
{
    sp_scene scene;
    sp_limit_result whole;
    question q;
    size_t need = 0;
    test_arena.used = 0;
    NEED(gen_make("two-cubes", NULL, 0, &test_arena, &scene) == SP_OK);
    scene.body[0] = 1;
    scene.joint[0].strength.cohesion = 10000;
    scene.joint[0].strength.tension = 5000;
    memset(&q, 0, sizeof q);
    q.scene = &scene;
    NEED(sp_memory(&scene, SP_FOR_LIMIT, NULL, test_arena, &need) == SP_OK);
    const sp_arena mark = test_arena;
    NEED(sp_limit(&scene, NULL, &test_arena, &whole) == SP_OK && whole.kind == SP_LIMIT_FOUND);
    test_arena = mark;
    const size_t enough = sweep(&q, ask_limit, need, SP_ALIGN), from = (mark.used + SP_ALIGN - 1) / SP_ALIGN * SP_ALIGN;
    NEED(enough > 0 && enough <= need);
    sp_arena a = { mark.base + from, enough, 0, 0 };
    CHECK_INT(ask_limit(&q, &a), SP_OK);
    CHECK_INT(q.answer.limit.kind, SP_LIMIT_FOUND);
}
#endif

/* Counts near the largest: what a scene takes is told, or 0 where no size_t (of 32 bits on some boards) can tell it. */
TEST(counts_near_the_largest_wrap_no_size)
{
    static const int32_t near[] = { 1000, 30000000, 89478485, 178956970, 536870912, 1073741824, INT32_MAX - 1, INT32_MAX };
    const uint64_t bytes[7] = { sizeof(sp_block), 3 * sizeof(sp_real), sizeof(sp_face), sizeof(int32_t), sizeof(sp_joint),
                                3 * sizeof(sp_real), sizeof(sp_load) };
    for (size_t k = 0; k < sizeof near / sizeof near[0]; k++)
        for (int of = 0; of < 8; of++) {                /* one of them, or all */
            int32_t n[7];
            uint64_t all = 0;
            sp_scene s;
            for (int q = 0; q < 7; q++) n[q] = of == q || of == 7 ? near[k] : 1;
            for (int q = 0; q < 7; q++) all = (all + SP_ALIGN - 1) / SP_ALIGN * SP_ALIGN + bytes[q] * (uint64_t)n[q];
            const sp_capacity cap = { n[0], n[1], n[2], n[3], n[4], n[5], n[6] };
            if (all < SIZE_MAX - SP_ALIGN) CHECK(sp_scene_memory(&cap) == all);
            else CHECK(sp_scene_memory(&cap) == 0);
            if (all > test_arena.capacity) CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_E_MEMORY);
        }
    for (int32_t n = INT32_MAX; n > 1000; n /= 3) {     /* a hull takes 2 n + 2 numbers of so many bytes, or more */
        const size_t told = sp_support_memory(n);
        CHECK(told == 0 || told / sizeof(sp_real) >= (size_t)n);
    }
}

TEST_LIST(capacity)
    RUN_FULL(every_capacity_is_refused_or_enough)
#if !defined SP_NO_IPM && !defined SP_SMALL
    RUN(a_limit_that_lacked_memory_was_undecided)
#endif
    RUN(counts_near_the_largest_wrap_no_size)
TEST_END
