/* switches: a program that links every public call of a build and asks each question once; what a build leaves out it refuses.
 *
 * calls.h is made from the header of the same build: CALL(name) for each call it declares. Prints what went wrong.
 */
#include "stonepack.h"
#include <stdio.h>

#define CALL(name) (void (*)(void))name,
static void (*const every_call[])(void) = {
#include "calls.h"
    NULL
};
#undef CALL

static double memory[200000];
static int wrong;

static void expect(const char *what, long got, long want)
{
    if (got != want) wrong = 1, printf("%s: %ld, not %ld\n", what, got, want);
}

#ifdef SP_NO_CRA
#define COUPLED SP_E_UNSUPPORTED
#else
#define COUPLED SP_OK
#endif
#if defined SP_NO_ADMM || defined SP_NO_QP || defined SP_SMALL
#define ADMM SP_E_UNSUPPORTED
#else
#define ADMM SP_OK
#endif
#if defined SP_NO_PLAN || defined SP_SMALL
#define DEPTH SP_E_UNSUPPORTED
#else
#define DEPTH SP_OK
#endif
#ifdef SP_SMALL
#define LARGE SP_E_UNSUPPORTED
#else
#define LARGE SP_OK
#endif
#ifdef SP_NO_PLAN
#define PLAN SP_E_UNSUPPORTED
#else
#define PLAN SP_OK
#endif
#ifdef SP_NO_IPM
#define LIMIT SP_E_UNSUPPORTED
#else
#define LIMIT SP_OK
#endif
#ifdef SP_EXACT_ONLY
#define SEQUENCE SP_E_UNSUPPORTED
#else
#define SEQUENCE SP_OK
#endif

#ifndef SP_QP_ONLY

/* A cube of 1 m on another that is fixed, shifted by x: it overhangs, and falls beyond 0.5. Its joint is found. */
static sp_status cubes(sp_scene *scene, sp_arena *arena, sp_real x)
{
    static const int32_t size[6] = { 4, 4, 4, 4, 4, 4 };
    static const int32_t corner[24] = { 0, 3, 2, 1,  4, 5, 6, 7,  0, 1, 5, 4,  1, 2, 6, 5,  2, 3, 7, 6,  3, 0, 4, 7 };
    const sp_capacity room = { 2, 16, 12, 48, 1, 4, 1 };
    sp_contact_report report = { 0, 0, 0, 0, NULL };
    sp_status status = sp_arena_init(arena, memory, sizeof memory);
    if (!status) status = sp_scene_create(scene, &room, arena);
    for (int k = 0; k < 2 && !status; k++) {
        sp_real xyz[24];
        sp_mesh mesh = { 8, 6, NULL, NULL, NULL };
        for (int v = 0; v < 8; v++) {
            xyz[3 * v] = (sp_real)(v % 4 == 1 || v % 4 == 2) + (sp_real)k * x;
            xyz[3 * v + 1] = (sp_real)(v % 4 > 1);
            xyz[3 * v + 2] = (sp_real)(v / 4 + k);
        }
        mesh.xyz = xyz;
        mesh.size = size;
        mesh.corner = corner;
        status = sp_scene_block(scene, &mesh, 1000, k ? 0 : SP_FIXED, NULL);
    }
    return status ? status : sp_contacts_find(scene, NULL, *arena, &report);
}

static sp_status ask(const sp_settings *settings, sp_real x, sp_result *result)
{
    sp_arena arena;
    sp_scene scene;
    const sp_status status = cubes(&scene, &arena, x);
    expect("contacts", status, SP_OK);
    return status ? status : sp_check(&scene, settings, &arena, result);
}

static void check(void)
{
    sp_result result = { 0 };
    sp_settings settings = sp_settings_default();
    expect("check", ask(NULL, (sp_real)0.25, &result), SP_OK);
    expect("stable", result.verdict, SP_STABLE);
    expect("check", ask(NULL, (sp_real)0.75, &result), SP_OK);
    expect("unstable", result.verdict, SP_UNSTABLE);
    settings.coupled.asked = 1;
    expect("coupled", ask(&settings, (sp_real)0.25, &result), COUPLED);
    if (COUPLED == SP_OK) expect("coupled stable", result.verdict, SP_STABLE);
    settings = sp_settings_default();
    settings.effect[SP_EFFECT_DEPTH] = SP_WITHOUT;
    expect("without depth", ask(&settings, (sp_real)0.25, &result), DEPTH);
    settings = sp_settings_default();
    settings.faces = 8;
    expect("pyramid", ask(&settings, (sp_real)0.25, &result), LARGE);
    settings = sp_settings_default();
    settings.stage[1] = SP_STAGE_ADMM;
    expect("stage ADMM", ask(&settings, (sp_real)0.25, &result), ADMM);
    settings.stage[1] = SP_STAGE_POLISH;
    expect("stage polish", ask(&settings, (sp_real)0.25, &result), LARGE);
#if !defined SP_NO_QP && !defined SP_NO_ADMM
    settings = sp_settings_seed();
    expect("preset of the seed", ask(&settings, (sp_real)0.25, &result), LARGE);
#endif
}

/* Bytes are told of every call there is; of what is left out it is said that it is. */
static void bytes(void)
{
    static const struct { sp_memory_for what; const char *name; sp_status status; } all[] = {
        { SP_FOR_CHECK, "bytes of a check", SP_OK }, { SP_FOR_WORK, "bytes of its work", SP_OK },
        { SP_FOR_VERIFY, "bytes of sp_verify", SP_OK }, { SP_FOR_CONTACTS, "bytes of contacts", SP_OK },
        { SP_FOR_PLAN, "bytes of a plan", PLAN }, { SP_FOR_LIMIT, "bytes of a limit", LIMIT },
        { SP_FOR_LIMIT_VERIFY, "bytes of its verification", LIMIT }, { SP_FOR_SEQUENCE, "bytes of a sequence", SEQUENCE },
        { SP_FOR_PROBLEM, "bytes of a problem", SP_OK }
    };
    sp_arena arena;
    sp_scene scene;
    expect("scene", cubes(&scene, &arena, (sp_real)0.25), SP_OK);
    for (unsigned k = 0; k < sizeof all / sizeof *all; k++) {
        size_t told = 0;
        expect(all[k].name, sp_memory(&scene, all[k].what, NULL, arena, &told), all[k].status);
        expect(all[k].name, told > 0, all[k].status == SP_OK);
        expect(all[k].name, sp_memory_scratch(&scene, all[k].what, NULL) > 0, 1);
    }
}

static void others(void)
{
    sp_arena arena;
    sp_scene scene;
    expect("scene", cubes(&scene, &arena, (sp_real)0.25), SP_OK);
#ifndef SP_NO_IPM
    sp_limit_result limit;
    scene.body[0] = 1;
    expect("limit", sp_limit(&scene, NULL, &arena, &limit), SP_OK);
    expect("limit found", limit.kind, SP_LIMIT_FOUND);
    expect("scene", cubes(&scene, &arena, (sp_real)0.25), SP_OK);
#endif
#ifndef SP_NO_PLAN
    sp_outlook outlook;
    expect("plan", sp_plan(&scene, NULL, arena, &outlook), SP_OK);
#endif
#ifndef SP_EXACT_ONLY
    sp_sequence *sequence;
    sp_step step;
    expect("sequence", sp_sequence_open(&scene, NULL, &arena, &sequence), SP_OK);
    expect("sequence set", sp_sequence_set(sequence, 1, SP_PRESENT, &step), SP_OK);
    expect("sequence stable", step.verdict, SP_STABLE);
#endif
}
#endif

#ifndef SP_NO_QP
/* Least x^2 / 2 + x within 0 <= x <= 1. */
static void program(void)
{
    static const int32_t p[2] = { 0, 1 }, i[1] = { 0 };
    static const sp_real one[1] = { 1 }, none[1] = { 0 };
    sp_arena arena;
    sp_qp qp = { 0 };
    sp_qp_result result;
    sp_qp_settings settings = sp_qp_default();
    int polish = SP_OK, cg = SP_OK, interior = SP_OK;
    qp.n = qp.m = 1;
    qp.Pp = qp.Ap = p;
    qp.Pi = qp.Ai = i;
    qp.Px = qp.Ax = qp.q = qp.u = one;
    qp.l = none;
#if defined SP_QP_NO_INTERIOR && !defined SP_SMALL
    interior = SP_E_UNSUPPORTED;
#endif
#ifdef SP_QP_NO_POLISH
    polish = SP_E_UNSUPPORTED;
#endif
#if defined SP_QP_NO_CG && !defined SP_SMALL
    cg = SP_E_UNSUPPORTED;
#endif
    expect("arena", sp_arena_init(&arena, memory, sizeof memory), SP_OK);
    expect("program", sp_qp_solve(&qp, NULL, &arena, NULL, NULL, &result), SP_OK);
    expect("program solved", result.status, SP_QP_SOLVED);
    settings.polish = 1;
    expect("polish", sp_qp_solve(&qp, &settings, &arena, NULL, NULL, &result), polish);
    settings = sp_qp_default();
    settings.method = SP_QP_INTERIOR;
    expect("interior points", sp_qp_solve(&qp, &settings, &arena, NULL, NULL, &result), interior);
    settings = sp_qp_default();
    settings.backend = SP_QP_CG;
    expect("matrix-free", sp_qp_solve(&qp, &settings, &arena, NULL, NULL, &result), cg);
}
#endif

int main(void)
{
    for (size_t k = 0; k + 1 < sizeof every_call / sizeof *every_call; k++) expect("call", every_call[k] != NULL, 1);
    expect("calls", sizeof every_call / sizeof *every_call > 10, 1);
#ifndef SP_QP_ONLY
    check();
    bytes();
    others();
#endif
#ifndef SP_NO_QP
    program();
#endif
    return wrong;
}
