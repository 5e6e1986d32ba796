/* check: checks by sp_check and the same problem by its peers, in turn in one process, one CSV row a scene and cone.
 *
 *     bench-check [--eps X] [--seconds X] [TEXT]      TEXT: only scenes whose group or words contain it
 *
 * Every scene is asked with the true cone and with the inscribed pyramid of 8 faces. `plan`: sp_check as it comes, with its
 * verification and, of what falls, where help is wanted; `full`: in 3D whatever the scene calls for, as the peers solve it.
 * Peers: setting up and solving, without making the matrices. Times are of the processor, medians of rounds in which all take
 * their turn, of 2 ms at least; the first round is dropped unless it alone takes twice --seconds.
 * A peer is right if its verdict is that of sp_check, which verified it, and if of what stands A x = b is missed by at most
 * 1e-4 of the largest load and no cone by more than 1e-3 of the largest force. One that is not right has a ? before its time
 * and no second turn; `best` is of those that are.
 *
 * Contents:  1 memory and order   2 scenes   3 the program   4 turns   5 a row   6 main
 */
#include "program.h"
#include "../../scenes/gen.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { PLAN, FULL, SCS, QOCO, ECOS, PIQP, OSQP, SOLVERS, ROUNDS = 41 };

static const char *const solver_name[SOLVERS] = { "plan", "full", "scs", "qoco", "ecos", "piqp", "osqp" };

/* 1 --------------------------------------------------------------------------------------------------- memory and order */

static void *kept[64];                                  /* memory of a row */
static size_t keeps;

static void *room(size_t bytes)
{
    void *p = keeps < sizeof kept / sizeof kept[0] ? calloc(bytes + 1, 1) : NULL;
    if (!p) { fprintf(stderr, "check: no memory\n"); exit(71); }
    return kept[keeps++] = p;
}

static void release(void) { while (keeps) free(kept[--keeps]); }

static void must(sp_status status, const char *what)
{
    if (status == SP_OK) return;
    fprintf(stderr, "check: %s: %s\n", what, sp_status_text(status));
    exit(70);
}

static sp_arena arena_of(size_t bytes)
{
    sp_arena a;
    must(sp_arena_init(&a, room(bytes + SP_ALIGN), bytes + SP_ALIGN), "arena");
    return a;
}

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* 2 ------------------------------------------------------------------------------------------------------------- scenes */

/* What `stonepack gen` is given. Out of plane: by 1.25 of the angle at which the wall overturns as one. */
static const struct { const char *group, *words; } scenes[] = {
    { "plain wall", "wall size=54 jitter=0.35" },
    { "plain wall", "wall size=147 jitter=0.35" },
    { "plain wall", "wall size=500 jitter=0.35" },
    { "plain wall", "wall size=2000 jitter=0.35" },
    { "plain wall", "wall size=10000 jitter=0.35" },
    { "near collapse in plane", "wall size=147 jitter=0.35 tilt=31.5" },
    { "near collapse in plane", "wall size=500 jitter=0.35 tilt=31.5" },
    { "near collapse in plane", "wall size=2000 jitter=0.35 tilt=31.5" },
    { "unstable out of plane", "wall size=54 jitter=0.35 tilt=17.545 azimuth=90" },
    { "unstable out of plane", "wall size=147 jitter=0.35 tilt=11.828 azimuth=90" },
    { "unstable out of plane", "wall size=500 jitter=0.35 tilt=6.493 azimuth=90" },
    { "unstable out of plane", "wall size=2000 jitter=0.35 tilt=3.2532 azimuth=90" },
    { "unstable out of plane", "wall size=10000 jitter=0.35 tilt=1.49186 azimuth=90" },
    { "stable arch", "arch n=11 t=0.12" },
    { "stable arch", "arch n=51 t=0.12" },
    { "stable arch", "arch n=200 t=0.12" },
    { "thin arch", "arch n=11 t=0.1" },
    { "thin arch", "arch n=51 t=0.1" },
    { "thin arch", "arch n=200 t=0.1" },
    { "stable dome or vault", "dome rings=6 segments=12 t=0.1" },
    { "stable dome or vault", "dome rings=12 segments=24 t=0.1" },
    { "stable dome or vault", "dome rings=20 segments=48 t=0.1" },
    { "stable dome or vault", "vault around=9 n=7 t=0.15 jitter=0.35" },
    { "stable dome or vault", "vault around=25 n=12 t=0.15 jitter=0.35" },
    { "thin dome or vault", "dome rings=6 segments=12 t=0.02" },
    { "thin dome or vault", "dome rings=12 segments=24 t=0.02" },
    { "thin dome or vault", "dome rings=20 segments=48 t=0.02" },
    { "thin dome or vault", "vault around=9 n=7 t=0.09 jitter=0.35" },
    { "thin dome or vault", "vault around=25 n=12 t=0.09 jitter=0.35" },
    { "2 to 20 blocks", "two-cubes" },
    { "2 to 20 blocks", "h-model" },
    { "2 to 20 blocks", "tower n=2" },
    { "2 to 20 blocks", "tower n=4" },
    { "2 to 20 blocks", "arch n=8 t=0.15" },
    { "2 to 20 blocks", "wall rows=2 bricks=3" },
    { "2 to 20 blocks", "wall rows=3 bricks=4" },
    { "2 to 20 blocks", "dome rings=2 segments=8" },
    { "2 to 20 blocks", "arch n=18 t=0.08" }
};

static void gen_words(gen_scene *g, const char *words)
{
    char text[160], *word;
    snprintf(text, sizeof text, "%s", words);
    word = strtok(text, " ");
    if (!word || !gen_open(g, word)) must(SP_E_ARGUMENT, words);
    while ((word = strtok(NULL, " ")) != NULL) {
        char *equals = strchr(word, '=');
        *equals = 0;
        if (gen_set(g, word, atof(equals + 1)) != 1) must(SP_E_ARGUMENT, words);
    }
}

/* 3 -------------------------------------------------------------------------------------------------------- the program */

/* One scene with one cone, and what everybody says of it. */
typedef struct bench {
    sp_scene scene;
    sp_settings set[2];                                 /* PLAN, FULL */
    sp_arena arena[2];
    sp_result result[2];
    peer_program program;
    sp_csc A, G;
    sp_qp qp;                                           /* the same for PIQP: P = 1, [A; G] */
    peer_run run[SOLVERS];
    int asked[SOLVERS], right[SOLVERS], rounds;
    double seconds[SOLVERS][ROUNDS], clock;
} bench;

static sp_csc columns(const sp_triplets *t, sp_arena *a)
{
    sp_csc m;
    must(sp_csc_from(t, a, &m), "columns");
    return m;
}

/* -(mu fn, ft1, ft2) of every corner */
static sp_csc cones(const sp_problem *p, sp_arena *a)
{
    const size_t n = 3 * (size_t)p->points;
    sp_triplets t = { (int32_t)n, (int32_t)n, (int32_t)n, room(n * sizeof *t.i), room(n * sizeof *t.j), room(n * sizeof *t.x) };
    for (int32_t c = 0; c < p->contacts; c++)
        for (int32_t k = 3 * p->contact[c].point; k < 3 * (p->contact[c].point + p->contact[c].points); k++) {
            t.i[k] = t.j[k] = k;
            t.x[k] = k % 3 ? -1 : -p->contact[c].joint->strength.mu;
        }
    return columns(&t, a);
}

/* P = 1, l <= [A; G] x <= u */
static void stack(bench *b)
{
    const sp_csc *M[2] = { &b->A, &b->G };
    const size_t n = (size_t)b->A.cols, m = (size_t)(b->A.rows + b->G.rows);
    const size_t entries = (size_t)b->A.p[n] + (size_t)b->G.p[n] + n;
    int32_t *Ap = room((2 * n + 2 + entries) * sizeof *Ap), *Pp = Ap + n + 1, *Ai = Pp + n + 1, *Pi;
    sp_real *x = room((entries + 2 * m) * sizeof *x), *l = x + entries, *u = l + m, *Px;
    int32_t k = 0;
    for (size_t j = 0; j < n; j++)
        for (int w = 0; w < 2; w++) {
            for (int32_t e = M[w]->p[j]; e < M[w]->p[j + 1]; e++, k++) {
                Ai[k] = M[w]->i[e] + (w ? b->A.rows : 0);
                x[k] = M[w]->x[e];
            }
            Ap[j + 1] = k;
        }
    Pi = Ai + k;
    Px = x + k;
    for (size_t j = 0; j < n; j++) { Pi[j] = (int32_t)j; Px[j] = 1; Pp[j + 1] = (int32_t)j + 1; }
    for (size_t i = 0; i < m; i++) {
        u[i] = i < (size_t)b->A.rows ? (sp_real)b->program.b[i] : 0;
        l[i] = i < (size_t)b->A.rows ? u[i] : -SP_QP_INFINITY;
    }
    const sp_qp qp = { (int32_t)n, (int32_t)m, Pp, Pi, Px, NULL, Ap, Ai, x, l, u };
    b->qp = qp;
}

/* The scene of some words, and settings and memory of ours, with so many faces. */
static void scene_make(bench *b, const char *words, int faces)
{
    gen_scene g;
    sp_capacity cap;
    gen_words(&g, words);
    must(gen_capacity(&g, &cap), words);
    sp_arena a = arena_of(sp_scene_memory(&cap));
    must(gen_build(&g, &a, &b->scene), words);
    for (int k = PLAN; k <= FULL; k++) {
        size_t bytes = 0;
        b->set[k] = sp_settings_default();
        b->set[k].faces = faces;
        for (int e = 0; k == FULL && e < SP_EFFECTS_FORCED; e++) b->set[k].effect[e] = SP_WITH;
        must(sp_memory(&b->scene, SP_FOR_CHECK, &b->set[k], arena_of(sp_memory_scratch(&b->scene, SP_FOR_CHECK, &b->set[k])),
                       &bytes), "sp_memory");
        b->arena[k] = arena_of(bytes);
    }
}

/* Loads in units of the largest, Aeq and the cones or Afr. */
static void program_make(bench *b, int faces)
{
    sp_problem problem;
    sp_triplets t;
    size_t bytes = 0;
    const sp_arena none = { NULL, 0, 0, 0 };
    must(sp_memory(&b->scene, SP_FOR_PROBLEM, NULL, none, &bytes), "sp_memory");
    sp_arena a = arena_of(bytes + 6000 * (size_t)b->scene.count.points + 65536);
    must(sp_problem_build(&b->scene, &a, &problem), "problem");
    must(sp_matrix_aeq(&problem, 3, &a, &t), "Aeq");
    b->A = columns(&t, &a);
    if (faces) must(sp_matrix_afr(&problem, &b->set[FULL], 3, &a, &t), "Afr");
    b->G = faces ? columns(&t, &a) : cones(&problem, &a);
    double unit = 0, *rhs = room((size_t)b->A.rows * sizeof *rhs);
    for (int32_t i = 0; i < b->A.rows; i++) unit = fmax(unit, fabs((double)problem.p[i]));
    for (int32_t i = 0; i < b->A.rows; i++) rhs[i] = -(double)problem.p[i] / unit;
    const peer_program p = { b->A.cols, b->A.rows, b->G.rows, faces ? 0 : problem.points, &b->A, &b->G, rhs };
    b->program = p;
    stack(b);
}

/* 4 -------------------------------------------------------------------------------------------------------------- turns */

static int ours(bench *b, int k)
{
    const double start = peer_clock();
    b->arena[k].used = 0;
    must(sp_check(&b->scene, &b->set[k], &b->arena[k], &b->result[k]), "sp_check");
    b->run[k].seconds = peer_clock() - start;
    const sp_verdict v = b->result[k].verified ? b->result[k].verdict : SP_UNDECIDED;
    b->run[k].solved = v == SP_STABLE ? 1 : v == SP_UNSTABLE ? -1 : 0;
    return 1;
}

static int call(bench *b, int who, double eps)
{
    peer_run *const run = b->run + who;
    (void)eps;
    (void)run;
    switch (who) {
    case PLAN: case FULL: return ours(b, who);
#ifdef WITH_SCS
    case SCS:  return peer_scs(&b->program, eps, run);
#endif
#ifdef WITH_QOCO
    case QOCO: return peer_qoco(&b->program, eps, run);
#endif
#ifdef WITH_ECOS
    case ECOS: return peer_ecos(&b->program, eps, run);
#endif
#ifdef WITH_PIQP
    case PIQP: return !b->program.cones && peer_piqp(&b->qp, b->qp.m, eps, run);
#endif
#ifdef WITH_OSQP
    case OSQP: return !b->program.cones && peer_osqp(&b->program, eps, run);
#endif
    default: return 0;                          /* not linked */
    }
}

/* What two readings of the clock take at least, which is in every time: a third of our check of two cubes. */
static double clock_cost(void)
{
    double cost = 1;
    for (int k = 0; k < 1000; k++) {
        const double start = peer_clock();
        cost = fmin(cost, peer_clock() - start);
    }
    return cost;
}

/* Again and again for 2 ms, so that neither the clock nor what others left in the caches counts.     returns 0: not asked */
static int turn(bench *b, int who, double eps)
{
    double sum = 0;
    int calls = 0;
    do {
        if (!call(b, who, eps)) return 0;
        sum += fmax(0, b->run[who].seconds - b->clock);
        calls++;
    } while (sum < 2e-3);
    b->run[who].seconds = sum / calls;
    return 1;
}

/* Is A x = b within 1e-4 of the largest load, and every cone met within 1e-3 of the largest force? */
static int meets(const bench *b, const double *x)
{
    const peer_program *p = &b->program;
    double *r = calloc((size_t)b->qp.m + 1, sizeof *r), off = 0, out = 0, most = 0;
    if (!r) return 0;
    for (int32_t j = 0; j < p->n; j++) {
        most = fmax(most, fabs(x[j]));
        for (int32_t e = b->qp.Ap[j]; e < b->qp.Ap[j + 1]; e++) r[b->qp.Ai[e]] += (double)b->qp.Ax[e] * x[j];
    }
    const double *s = r + p->equations;
    for (int32_t i = 0; i < p->equations; i++) off = fmax(off, fabs(r[i] - p->b[i]));
    for (int32_t i = 0; i < p->rows; i += p->cones ? 3 : 1)
        out = fmax(out, s[i] + (p->cones ? sqrt(s[i + 1] * s[i + 1] + s[i + 2] * s[i + 2]) : 0));
    free(r);
    return off <= 1e-4 && out <= 1e-3 * most;
}

/* Rounds until the time is spent. */
static void rounds(bench *b, double eps, double patience)
{
    double spent = 0;
    for (int k = -1; k < ROUNDS && (k < 3 || spent < patience); k++) {
        for (int who = 0; who < SOLVERS; who++) {
            if (k < 0) b->asked[who] = turn(b, who, eps);
            else if (b->right[who]) turn(b, who, eps);
            if (k < 0) b->right[who] = b->asked[who] && b->run[who].solved && b->run[who].solved == b->run[PLAN].solved
                                       && (who <= FULL || b->run[who].solved < 0 || meets(b, b->run[who].x));
            if (b->right[who]) spent += b->seconds[who][k < 0 ? 0 : k] = b->run[who].seconds;
        }
        b->rounds = k < 0 ? 1 : k + 1;
        if (k < 0 && spent > 2 * patience) return;
        if (k < 0) spent = 0;
    }
}

/* 5 -------------------------------------------------------------------------------------------------------------- a row */

/* [ms] */
static double median(bench *b, int who)
{
    const int n = b->rounds;
    double *s = b->seconds[who];
    qsort(s, (size_t)n, sizeof *s, by_size);
    return 1e3 * (n % 2 ? s[n / 2] : 0.5 * (s[n / 2 - 1] + s[n / 2]));
}

static void tell(bench *b, const char *group, const char *words, int faces)
{
    double ms[SOLVERS] = { 0 };
    int best = -1;
    for (int who = 0; who < SOLVERS; who++) {
        if (b->right[who]) ms[who] = median(b, who);
        if (who > FULL && b->right[who] && (best < 0 || ms[who] < ms[best])) best = who;
    }
    printf("%s,%s,%ld,%s,%s,%d", group, words, (long)b->scene.count.joints, faces ? "pyramid" : "cone",
           b->right[PLAN] && b->right[FULL] ? sp_verdict_text(b->result[PLAN].verdict) : "not agreed", b->rounds);
    for (int k = PLAN; k <= FULL; k++)
        printf(",%ld,%.4g", (long)b->result[k].spent.total.factorisations, b->right[k] ? ms[k] : 1e3 * b->run[k].seconds);
    for (int who = SCS; who < SOLVERS; who++)
        if (!b->asked[who]) printf(",");
        else printf(",%s%.4g", b->right[who] ? "" : "?", b->right[who] ? ms[who] : 1e3 * b->run[who].seconds);
    if (best >= 0) printf(",%s,%.3g,%.3g\n", solver_name[best], ms[best] / ms[PLAN], ms[best] / ms[FULL]);
    else printf(",,,\n");
    fflush(stdout);
}

static void row(int k, int faces, double eps, double patience)
{
    static bench b;
    memset(&b, 0, sizeof b);
    b.clock = clock_cost();
    scene_make(&b, scenes[k].words, faces);
    program_make(&b, faces);
    for (int who = SCS; who < SOLVERS; who++) b.run[who].x = room((size_t)b.program.n * sizeof(double));
    rounds(&b, eps, patience);
    tell(&b, scenes[k].group, scenes[k].words, faces);
    release();
}

/* 6 --------------------------------------------------------------------------------------------------------------- main */

int main(int count, char **word)
{
    double eps = 1e-6, seconds = 2;
    const char *only = "";
    for (int k = 1; k < count; k++) {
        if (!strcmp(word[k], "--eps") && k + 1 < count) eps = atof(word[++k]);
        else if (!strcmp(word[k], "--seconds") && k + 1 < count) seconds = atof(word[++k]);
        else only = word[k];
    }
    printf("group,scene,joints,form,verdict,rounds,plan_factorisations,plan_ms,full_factorisations,full_ms,scs_ms,qoco_ms,"
           "ecos_ms,piqp_ms,osqp_ms,best,plan_ratio,full_ratio\n");
    for (size_t k = 0; k < sizeof scenes / sizeof scenes[0]; k++)
        for (int faces = 8; faces >= 0; faces -= 8)
            if (strstr(scenes[k].group, only) || strstr(scenes[k].words, only)) row((int)k, faces, eps, seconds);
    return 0;
}
