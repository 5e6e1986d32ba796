/* verify: what does a stored result prove? Its forces and mechanism are taken; its verdict is not, nor its question. */
#include "../files/text.h"
#include "../tilt.h"
#include "commands.h"
#include "../files/json_in.h"
#include "../files/json_out.h"
#include "report.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A result being read, and the scene it is about. */
typedef struct reading {
    const char *path;
    json_tree tree;
    const json_value *all;
    const host_scene *scene;
    failure *error;
} reading;

static int fail(const reading *r, const json_value *at, const char *message)
{
    return fail_with(r->error, EXIT_SCENE, r->path, at ? at->line : 1, "%s", message);
}

/* n numbers of an array; 0 if it is not so. */
static int read_reals(const reading *r, const json_value *array, int32_t n, sp_real *x)
{
    int32_t k = 0;
    if (!array || array->kind != JSON_ARRAY) return 0;
    for (int32_t i = array->first; i >= 0; i = r->tree.value[i].next, k++) {
        if (k == n || r->tree.value[i].kind != JSON_NUMBER) return 0;
        x[k] = (sp_real)r->tree.value[i].as.number;
    }
    return k == n;
}

/* The question as the result says it was put: cone, friction, gravity. The one that is judged is the caller's; this is told. */
static int read_asked(const reading *r, options *o, sp_real gravity[3])
{
    const json_value *asked = json_member(&r->tree, r->all, "asked");
    const json_value *cone = json_member(&r->tree, asked, "cone"), *mu = json_member(&r->tree, asked, "mu");

    if (!asked) return fail(r, r->all, "no forces in this result: make it with check --json --forces");
    if (!cone || cone->kind != JSON_STRING || !options_cone(cone->as.string, &o->settings)) return fail(r, asked, "bad cone");
    snprintf(o->cone, sizeof o->cone, "%s", cone->as.string);
    if (!mu || (mu->kind != JSON_NULL && (mu->kind != JSON_NUMBER || mu->as.number < 0))) return fail(r, asked, "bad mu");
    o->scene.mu = mu->kind == JSON_NUMBER ? (sp_real)mu->as.number : -1;
    return read_reals(r, json_member(&r->tree, asked, "gravity"), 3, gravity) ? 0 : fail(r, asked, "bad gravity");
}

static int read_number(const reading *r, const char *key, sp_real *x)
{
    const json_value *v = json_member(&r->tree, r->all, key);
    if (!v || v->kind != JSON_NUMBER) return fail_with(r->error, EXIT_SCENE, r->path, r->all->line, "no number '%s'", key);
    *x = (sp_real)v->as.number;
    return 0;
}

/* A tolerance that a check would have refused proves nothing. */
static int read_accuracy(const reading *r, sp_result *claim)
{
    int status = read_number(r, "tol", &claim->tol);
    if (!status) status = read_number(r, "force_bound", &claim->force_bound);
    if (status) return status;
    if (!(claim->tol >= 4 * SP_EPSILON && claim->tol <= (sp_real)0.1) || !(claim->force_bound > 0))
        return fail(r, r->all, "tol or force_bound outside its range");
    return 0;
}

static int read_forces(const reading *r, sp_real *f)
{
    const json_value *forces = json_member(&r->tree, r->all, "forces");
    const int32_t points = r->scene->scene.count.points;
    int32_t k = 0, i;

    if (!forces || forces->kind != JSON_ARRAY)
        return fail(r, r->all, "no forces in this result: make it with check --json --forces");
    for (i = forces->first; i >= 0; i = r->tree.value[i].next, k++)
        if (k == points || !read_reals(r, &r->tree.value[i], 3, f + 3 * (size_t)k)) break;
    if (k == points && i < 0) return 0;
    return fail_with(r->error, EXIT_SCENE, r->path, forces->line, "the forces are not those of this scene's %ld contact "
                     "vertices", (long)points);
}

/* A name as json_out writes it and json_in reads it: bytes that are no UTF-8 are Latin-1. */
static int same_name(const char *json, const char *name)
{
    while (*name) {
        const unsigned char c = (unsigned char)*name;
        const int n = json_utf8(name);
        if (n) {
            if (strncmp(json, name, (size_t)n)) return 0;
            json += n;
            name += n;
        } else {
            if ((unsigned char)json[0] != (0xc0 | c >> 6) || (unsigned char)json[1] != (0x80 | (c & 63))) return 0;
            json += 2;
            name++;
        }
    }
    return *json == 0;
}

/* The coupled check's question as the result says it was put, where it was: lengths and kind of bound. */
static int read_coupled(const reading *r, sp_coupled_settings *told)
{
    const json_value *c = json_member(&r->tree, r->all, "coupled"), *box = json_member(&r->tree, c, "box");
    const json_value *eps = json_member(&r->tree, c, "eps"), *eta = json_member(&r->tree, c, "eta");

    if (!c) return 0;
    if (!box || box->kind != JSON_BOOL || !eps || eps->kind != JSON_NUMBER || eps->as.number < 0
        || !eta || eta->kind != JSON_NUMBER || !(eta->as.number > 0))
        return fail(r, c, "bad eps, eta or box of the coupled check");
    told->asked = 1;
    told->box = box->as.number > 0;
    told->eps = (sp_real)eps->as.number;
    told->eta = (sp_real)eta->as.number;
    return 0;
}

/* Its motion and alpha. */
static int read_triple(const reading *r, sp_real *dq, sp_real *alpha)
{
    const json_value *c = json_member(&r->tree, r->all, "coupled"), *motion = json_member(&r->tree, c, "motion");
    const int32_t blocks = r->scene->scene.count.blocks;
    int32_t k = 0;

    if (!motion || motion->kind != JSON_ARRAY)
        return fail(r, c, "no motion in the coupled check: make it with check --json --forces");
    for (int32_t i = motion->first; i >= 0; i = r->tree.value[i].next, k++)
        if (k == blocks || !read_reals(r, &r->tree.value[i], 6, dq + 6 * (size_t)k))
            return fail(r, motion, "bad motion of the coupled check");
    if (k != blocks || !read_reals(r, json_member(&r->tree, c, "alpha"), r->scene->scene.count.points, alpha))
        return fail(r, motion, "motion or alpha of the coupled check are not of this scene");
    return 0;
}

static int32_t count_of(const reading *r, const json_value *array)
{
    int32_t n = 0;
    if (array && array->kind == JSON_ARRAY) for (int32_t i = array->first; i >= 0; i = r->tree.value[i].next) n++;
    return n;
}

/* Whole numbers from low to high of an array; 0 if it is not so. */
static int read_wholes(const reading *r, const json_value *array, double low, double high, int32_t *node, uint16_t *row)
{
    int32_t k = 0;
    for (int32_t i = array->first; i >= 0; i = r->tree.value[i].next, k++) {
        const double x = r->tree.value[i].as.number;
        if (r->tree.value[i].kind != JSON_NUMBER || !(x >= low && x <= high)) return 0;
        if (x < (double)(int32_t)x || x > (double)(int32_t)x) return 0;
        if (node) node[k] = (int32_t)x;
        else row[k] = (uint16_t)x;
    }
    return 1;
}

/* A proof by cases into memory of its own (free p->y), where there is one; `whose` names it. */
static int read_proof(const reading *r, const json_value *proof, const char *whose, sp_proof *p)
{
    const json_value *node = json_member(&r->tree, proof, "node"), *row = json_member(&r->tree, proof, "row");
    const json_value *y = json_member(&r->tree, proof, "y"), *island = json_member(&r->tree, proof, "island");

    if (!proof) return 0;
    if (island) {                                       /* results before there were any have none */
        if (island->kind != JSON_NUMBER || !(island->as.number >= 0 && island->as.number <= INT32_MAX))
            return fail(r, proof, "bad island of a proof");
        p->island = (int32_t)island->as.number;
    }
    p->nodes = count_of(r, node);
    p->entries = count_of(r, row);
    if (!p->nodes || !p->entries || count_of(r, y) != p->entries)
        return fail_with(r->error, EXIT_SCENE, r->path, proof->line, "no proof in %s: make it with check --json --forces",
                         whose);
    p->y = malloc((size_t)p->entries * (sizeof *p->y + sizeof *p->row) + (size_t)p->nodes * sizeof *p->node);
    if (!p->y) return fail_status(r->error, SP_E_MEMORY, r->path, 0, "");
    p->node = (int32_t *)(p->y + p->entries);
    p->row = (uint16_t *)(p->node + p->nodes);
    if (!read_reals(r, y, p->entries, p->y) || !read_wholes(r, node, -INT32_MAX, INT32_MAX, p->node, NULL) ||
        !read_wholes(r, row, 0, UINT16_MAX, NULL, p->row))
        return fail_with(r->error, EXIT_SCENE, r->path, proof->line, "bad proof of %s", whose);
    return 0;
}

/* n rows of `width` numbers each of a member, into x.     returns 0 or an exit status */
static int read_rows(const reading *r, const json_value *in, const char *key, int32_t n, int32_t width, sp_real *x)
{
    const json_value *rows = json_member(&r->tree, in, key);
    int32_t k = 0;
    if (!rows || rows->kind != JSON_ARRAY) return fail(r, in, "forces or motion are missing");
    for (int32_t i = rows->first; i >= 0; i = r->tree.value[i].next, k++)
        if (k == n || !read_reals(r, &r->tree.value[i], width, x + (size_t)k * (size_t)width)) break;
    return k == n && count_of(r, rows) == n ? 0 : fail(r, rows, "forces or motion are not those of this scene");
}

/* What the evidence of --strong proves. */
static int judge_strong(const reading *r, const options *o, sp_strong_kind *proved)
{
    const json_value *strong = json_member(&r->tree, r->all, "strong"), *proof = json_member(&r->tree, strong, "proof");
    const sp_capacity *n = &r->scene->scene.count;
    sp_strong_result claim;
    sp_real *x;
    int status;

    if (!proof) return fail(r, strong, "no proof in `strong`: make it with check --json --forces --strong");
    x = calloc(6 * ((size_t)n->points + (size_t)n->blocks), sizeof *x);
    if (!x) return fail_status(r->error, SP_E_MEMORY, r->path, 0, "");
    memset(&claim, 0, sizeof claim);
    claim.f = x;
    claim.moving = x + 3 * (size_t)n->points;
    claim.a = x + 6 * (size_t)n->points;
    status = read_rows(r, proof, "forces", n->points, 3, claim.f);
    if (!status) status = read_rows(r, proof, "moving", n->points, 3, claim.moving);
    if (!status) status = read_rows(r, proof, "motion", n->blocks, 6, claim.a);
    if (!status) status = read_proof(r, json_member(&r->tree, proof, "cases"), "`strong`", &claim.proof);
    if (!status) {
        const sp_status made = run_strong_verify(&r->scene->scene, &o->settings, &claim, proved);
        if (made != SP_OK) status = fail_status(r->error, made, r->path, r->all->line, "");
    }
    free(claim.proof.y);
    free(x);
    return status;
}

/* A number of `sliding`, 0 where it is null. */
static int read_multiple(const reading *r, const json_value *in, const char *key, sp_real *x)
{
    const json_value *v = json_member(&r->tree, in, key);
    if (!v || (v->kind != JSON_NUMBER && v->kind != JSON_NULL)) return fail(r, in, "a multiple of `sliding` is missing");
    *x = v->kind == JSON_NUMBER ? (sp_real)v->as.number : 0;
    return 0;
}

/* State, pressure and multiples of `sliding`, into x: 9 numbers of a point, 6 of a block. */
static int read_sliding(const reading *r, sp_real *x, sp_sliding_result *claim)
{
    const json_value *sliding = json_member(&r->tree, r->all, "sliding"), *proof = json_member(&r->tree, sliding, "proof");
    const sp_capacity *n = &r->scene->scene.count;
    int status;

    if (!proof) return fail(r, sliding, "no proof in `sliding`: make it with limit --json --forces --sliding real");
    claim->f = x;
    claim->pressed = x + 3 * (size_t)n->points;
    claim->resting = x + 6 * (size_t)n->points;
    claim->v = x + 9 * (size_t)n->points;
    status = read_rows(r, proof, "forces", n->points, 3, claim->f);
    if (!status) status = read_rows(r, proof, "pressed", n->points, 3, claim->pressed);
    if (!status) status = read_rows(r, proof, "resting", n->points, 3, claim->resting);
    if (!status) status = read_rows(r, proof, "motion", n->blocks, 6, claim->v);
    if (!status) status = read_multiple(r, sliding, "upper", &claim->upper);
    if (!status) status = read_multiple(r, sliding, "lower", &claim->lower);
    return status ? status : read_multiple(r, sliding, "lower_strong", &claim->lower_strong);
}

/* What the evidence of limit --sliding real proves. */
static int judge_sliding(const reading *r, const options *o, sp_sliding_result *claim, sp_sliding_evidence *evidence)
{
    const sp_capacity *n = &r->scene->scene.count;
    sp_real *x = calloc(9 * (size_t)n->points + 6 * (size_t)n->blocks, sizeof *x);
    int status;

    if (!x) return fail_status(r->error, SP_E_MEMORY, r->path, 0, "");
    memset(claim, 0, sizeof *claim);
    status = read_sliding(r, x, claim);
    if (!status) {
        const sp_status made = run_sliding_verify(&r->scene->scene, &o->settings, claim, evidence);
        if (made != SP_OK) status = fail_status(r->error, made, r->path, r->all->line, "");
    }
    free(x);
    return status;
}

/* Blocks stand in the mechanism in the order of the scene; others are at rest. */
static int read_mechanism(const reading *r, sp_real *dq)
{
    const json_value *mechanism = json_member(&r->tree, r->all, "mechanism");
    int32_t b = 0;

    if (!mechanism || mechanism->kind != JSON_ARRAY) return fail(r, r->all, "no mechanism in this result");
    for (int32_t i = mechanism->first; i >= 0; i = r->tree.value[i].next) {
        const json_value *entry = &r->tree.value[i], *name = json_member(&r->tree, entry, "block");
        if (!name || name->kind != JSON_STRING) return fail(r, entry, "a block of the mechanism has no name");
        while (b < r->scene->scene.count.blocks && !same_name(name->as.string, r->scene->name[b])) b++;
        if (b == r->scene->scene.count.blocks)
            return fail_with(r->error, EXIT_SCENE, r->path, entry->line, "block '%.60s' of the mechanism is not in the scene, "
                             "or out of order", name->as.string);
        if (!read_reals(r, json_member(&r->tree, entry, "dq"), 6, dq + 6 * (size_t)b)) return fail(r, entry, "bad dq");
        b++;
    }
    return 0;
}

/* The forces, the mechanism and what the coupled check claims, into memory that `judge` gave. */
static int read_claim(const reading *r, const options *o, sp_result *claim)
{
    int status = read_accuracy(r, claim);
    if (!status) status = read_forces(r, claim->f);
    if (!status) status = read_mechanism(r, claim->dq);
    if (status || !o->settings.coupled.asked) return status;
    status = read_triple(r, claim->coupled.dq, claim->coupled.alpha);
    return status ? status : read_proof(r, json_member(&r->tree, json_member(&r->tree, r->all, "coupled"), "proof"),
                                        "the coupled check", &claim->coupled.proof);
}

/* Read what the result claims, and have it verified. */
static int judge_claim(const reading *r, const options *o, sp_real *tol, sp_real *force_bound, sp_evidence *evidence)
{
    const sp_capacity *n = &r->scene->scene.count;
    sp_real *f = calloc(4 * (size_t)n->points + 1, sizeof *f), *dq = calloc(12 * (size_t)n->blocks, sizeof *dq);
    sp_status made = SP_E_MEMORY;
    int status = 0;
    sp_result claim;

    memset(&claim, 0, sizeof claim);
    claim.f = f;
    claim.dq = dq;
    if (f && dq) {
        claim.coupled.alpha = o->settings.coupled.asked ? f + 3 * (size_t)n->points : NULL;
        claim.coupled.dq = o->settings.coupled.asked ? dq + 6 * (size_t)n->blocks : NULL;
        status = read_claim(r, o, &claim);
        if (!status) made = run_verify(&r->scene->scene, &o->settings, &claim, evidence);
    }
    if (!status && made != SP_OK) status = fail_status(r->error, made, r->path, f && dq ? r->all->line : 0, "");
    *tol = claim.tol;
    *force_bound = claim.force_bound;
    free(claim.coupled.proof.y);
    free(f);
    free(dq);
    return status;
}

/* A stored result read and judged. */
typedef struct verified {
    options o;                  /* the caller's question, the only one judged */
    options told;               /* that of the result: cone, friction, lengths of a coupled check */
    sp_real tol, force_bound, gravity[3];       /* and its tol, bound on forces and gravity */
    sp_real bound;              /* the caller's bound on forces: it follows from tol */
    sp_real turned[3];          /* and gravity */
    int other_reach;            /* the result's motion was bounded by another eta / eps than the caller's */
    int sliding;                /* the result is a limit's without dilatancy */
    sp_sliding_result slid;     /* its claim: multiples alone */
    sp_sliding_evidence slides;
    int strong;                 /* the result was asked whether friction holds it whatever it does */
    sp_strong_kind proved;
    int proof;                  /* the result has a proof that there is no triple */
    sp_evidence evidence;
    int32_t near, inside, across;       /* host_scene's */
} verified;

/* eta / eps, by which alone lengths count, for a motion may be drawn to any scale; infinite where joints give nothing. */
static double reach(const sp_coupled_settings *c) { return c->eps > 0 ? (double)c->eta / (double)c->eps : HUGE_VAL; }

/* The caller's eta / eps, at the scale of the result's motion. */
static void set_lengths(verified *v, sp_coupled_settings asked)
{
    const sp_coupled_settings *told = &v->told.settings.coupled;
    const double same = sizeof(sp_real) == 4 ? 1e-5 : 1e-9, far = reach(&asked);
    sp_coupled_settings *judged = &v->o.settings.coupled;
    v->other_reach = !(reach(told) >= far * (1 - same) && reach(told) <= far * (1 + same));
    judged->eps = told->eps;
    judged->eta = told->eta;
    if (!v->other_reach) return;
    if (asked.eps > 0 && told->eps > 0) judged->eta = (sp_real)((double)told->eps * far);
    else judged->eps = asked.eps > 0 ? (sp_real)((double)told->eta / far) : 0;
}

/* What the caller's options come to on this scene, bound and lengths: a check that may do no work tells it. */
static int resolve(const reading *r, verified *v)
{
    sp_settings no_work = v->o.settings;
    sp_result x;
    run_cost cost;
    void *memory;
    no_work.budget = 1;
    no_work.coupled.nodes = 0;
    const sp_status made = run_check(&r->scene->scene, &no_work, &x, &cost, &memory);
    free(memory);
    if (made != SP_OK) return fail_status(r->error, made, r->path, r->all->line, "");
    const sp_coupled_settings asked = { .eps = x.coupled.eps, .eta = x.coupled.eta };
    v->bound = x.force_bound;
    if (v->o.settings.coupled.asked) set_lengths(v, asked);
    return 0;
}

static int verify(const char *scene_path, const char *path, verified *v, failure *error)
{
    host_scene s;
    reading r = { path, { NULL, NULL, 0, 0 }, NULL, &s, error };
    int status = json_read(path, &r.tree, error), read = 0;

    if (!status) {
        r.all = &r.tree.value[0];
        v->sliding = json_member(&r.tree, r.all, "sliding") != NULL;
        if (!v->sliding) status = read_asked(&r, &v->told, v->gravity);
        if (!status) status = read_coupled(&r, &v->told.settings.coupled);
        v->o.settings.coupled.asked = v->told.settings.coupled.asked;
    }
    if (!status) {
        status = scene_read(scene_path, &v->o.scene, &s, error);
        read = 1;
    }
    if (!status) {
        tilt_turn(v->o.tilt, v->o.azimuth, s.scene.gravity);
        memcpy(v->turned, s.scene.gravity, sizeof v->turned);
        v->near = s.near;
        v->inside = s.inside;
        v->across = s.across;
        scene_body(&s, v->o.body);
        if (v->sliding) status = judge_sliding(&r, &v->o, &v->slid, &v->slides);
        else status = resolve(&r, v);
        if (!v->sliding && !status) status = judge_claim(&r, &v->o, &v->tol, &v->force_bound, &v->evidence);
        v->strong = json_member(&r.tree, r.all, "strong") != NULL;
        if (!status && v->strong) status = judge_strong(&r, &v->o, &v->proved);
        v->proof = json_member(&r.tree, json_member(&r.tree, r.all, "coupled"), "proof") != NULL;
    }
    json_free(&r.tree);
    if (!status && !v->o.quiet) remarks_print(stderr, &s.remarks);     /* after the line of the verdict */
    if (read) scene_free(&s);
    return status;
}

/* What the result was asked that the caller of verify did not ask. A tol that is finer is no other question. */
static void print_other_question(const verified *v)
{
    const options *o = &v->o, *t = &v->told;
    if (strcmp(o->cone, t->cone)) printf(", the result's cone is %s", t->cone);
    if (v->tol > o->settings.tol) printf(", the result's tol is %.2g", (double)v->tol);
    const sp_real mu = o->scene.mu, told = t->scene.mu;
    if (told >= 0 && (mu < told || mu > told)) printf(", the result's friction is %g", (double)told);
    if (told < 0 && mu >= 0) printf(", the result's friction is the scene's");
    if (memcmp(v->turned, v->gravity, sizeof v->turned))
        printf(", the result's gravity is %g %g %g", (double)v->gravity[0], (double)v->gravity[1], (double)v->gravity[2]);
    if (v->force_bound < v->bound || v->force_bound > v->bound)
        printf(", the result's bound on forces is %.2g", (double)v->force_bound);
    if (!o->settings.coupled.asked) return;
    const sp_coupled_settings *c = &t->settings.coupled;
    if (v->other_reach && c->eps > 0) printf(", the result's eta/eps is %.3g", reach(c));
    else if (v->other_reach) printf(", the result's eta/eps is unbounded");
    if (!c->box != !o->settings.coupled.box)
        printf(", the result's eta bounds %s", c->box ? "each component of the slip" : "the slip as a whole");
}

static void print_evidence(const char *scene_path, const char *path, const verified *v)
{
    const sp_evidence *e = &v->evidence;
    const options *o = &v->o;
    char imbalance[32], least[32];
    printf("%s: %s by %s, cone %s, tol %.2g", scene_path, sp_verdict_text(e->verdict), path, o->cone, (double)o->settings.tol);
    if (o->scene.mu >= 0) printf(", friction %g", (double)o->scene.mu);
    if (fabs(o->tilt) > 0) printf(", tilted by %g degrees", o->tilt);
    print_other_question(v);
    printf(": ");
    if (e->verdict == SP_UNSTABLE && !(e->margin > 0))
        printf("least imbalance %s%s, ", text_shortest(e->least_imbalance, least), e->final ? ", final" : "");
    printf("imbalance %s", text_shortest(e->imbalance, imbalance));
    if (e->margin > 0) printf(", refuted, margin %.2g", (double)e->margin);
    else if (v->proof) printf(", not refuted: the proof in it fails");
    else if (o->settings.coupled.asked)
        printf(", %s, residual %.2g", e->level == SP_COUPLED ? "coupled" : "not coupled", (double)e->residual);
    if (o->settings.coupled.asked)
        printf(", eps %.3g, eta %.3g m", (double)o->settings.coupled.eps, (double)o->settings.coupled.eta);
    if (v->strong) printf(", whatever friction does: %s", sp_strong_text(v->proved));
    report_near(stdout, e->verdict == SP_STABLE ? 0 : v->near, v->inside, v->across);
}

/* Is what the result says of its state proved, whatever else?     returns an exit status */
static int print_sliding(const char *scene_path, const char *path, const verified *v)
{
    const sp_sliding_evidence *e = &v->slides;
    printf("%s: ", scene_path);
    if (e->state) printf("a sliding state at %.9g by %s, residual %.2g", (double)v->slid.upper, path, (double)e->residual);
    else printf("no sliding state by %s", path);
    printf(", none below %.9g, strong up to %.9g, tol %.2g", (double)e->lower, (double)e->lower_strong,
           (double)v->o.settings.tol);
    report_near(stdout, v->near, v->inside, v->across);
    return e->state ? 0 : EXIT_UNDECIDED;
}

int command_verify(int argc, char **argv)
{
    failure error = { 0, "" };
    verified v;
    sp_evidence *e = &v.evidence;

    memset(&v, 0, sizeof v);
    options_read(argc, argv, " --tol --cone --tilt --body --cra-eps --cra-eta --cra-box" SCENE_OPTIONS, &v.o, &error);
    if (!error.status && v.o.files != 2)
        fail_with(&error, EXIT_USAGE, NULL, 0, "stonepack: verify needs a scene and a result");
    if (error.status || verify(v.o.file[0], v.o.file[1], &v, &error) != 0) {
        fprintf(stderr, "%s\n", error.line);
        return error.status;
    }
    if (v.sliding) return print_sliding(v.o.file[0], v.o.file[1], &v);
    if (v.o.settings.coupled.asked && e->verdict == SP_STABLE && e->level != SP_COUPLED) e->verdict = SP_UNDECIDED;
    print_evidence(v.o.file[0], v.o.file[1], &v);
    return report_exit(e->verdict);
}
