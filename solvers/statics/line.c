/* line: step lengths for Newton's method, and when a motion is a proof.
 *
 * Semismooth Newton on the dual with a line search, from the bilateral potential; where that stalls (collapse, or close to it),
 * the proximal path: minimise D(y) + prox |y|^2 / 2 for prox = 0.1, 0.001, ... Either the imbalance vanishes, or -y grows into
 * the mechanism.                                                                 [Qi, Sun 1993; Rockafellar 1976]
 */
#ifndef SP__STATICS_LINE_C
#define SP__STATICS_LINE_C

#include "gradient.c"

#if SP__WITH_LARGE

#ifdef SP_REAL_FLOAT
#define SP__ENOUGH ((sp_real)0.9)       /* of tol: the search's own imbalance that will do */
#define SP__MORE ((sp_real)1.1)         /* of tol: the search's own value of a proof that will do */
#else
#define SP__ENOUGH ((sp_real)0.999)
#define SP__MORE ((sp_real)1.001)
#endif
#define SP__FINE ((sp_real)(sizeof(sp_real) == 4 ? 1 : 1e-12))  /* imbalance from which forces are taken as they come */
#define SP__NEAR 1000                   /* an undecided search that came within so many tol is at the limit, else it gave up */

typedef struct sp__newton {
    sp_real prox;                       /* weight of |y|^2 / 2 */
    sp_real shift;                      /* on the diagonal of the Hessian, beyond prox */
    sp_real imbalance, best;                /* of the current y, of the best (kept in state->y) */
    sp_real goal;                       /* imbalance to reach */
    sp_real level;                      /* imbalance at the end of the last piece of the path, or before a step */
    int32_t left;                       /* factorisations */
    signed char proved;                 /* state->dq holds a proof, or of SP__PROVED_NEARER: found with the factor of f0 */
    signed char stalled;                /* level no longer falls with prox: something moves */
    signed char found;                  /* state->f holds forces that balance */
    signed char falls;                  /* the interior points came to a motion, be its proof within tol or beyond */
} sp__newton;

enum { SP__PROVED_NEARER = 2 };

/* Is there work left to spend? */
static int sp__newton_work_left(const sp__system *w, const sp__newton *n) { return n->left > 0 && !w->budget.spent; }

/* Is an imbalance within tol, and so small that more digits are not worth a solution? */
SP__NOINLINE static int sp__newton_close(const sp__system *w, sp_real imbalance)
{
    return imbalance <= SP__CLOSE && imbalance <= SP__CLOSE_TOL * w->set->tol;
}

/* Are there neither forces that balance nor a proof? */
static int sp__newton_unfinished(const sp__newton *n) { return n->imbalance > n->goal && !n->proved && !n->found; }

/* The search along d: slope(s) = d/ds [D(y + s d) + prox |y + s d|^2 / 2] = f(s) . d + yd + s dd. */
typedef struct sp__line { sp_real yd, dd, start, noise; } sp__line;

/* A slope so small ends it. */
static sp_real sp__line_enough(const sp__line *l) { return sp__max((sp_real)0.2 * sp__abs(l->start), l->noise); }

/* Step length that brings the slope below a fifth of its start; `f`: the slope at 1, known already. */
SP__NOINLINE static sp_real sp__newton_search(sp__system *w, const sp__line *l, sp_real f)
{
    sp_real lo = 0, flo = l->start, hi = 0, fhi = 0, s = 1, work = 0;
    for (int it = 0; it < 14; it++) {
        if (it == 1) work = sp__system_work(w, w->d);
        if (it) f = sp__system_slope(w, w->y, w->d, s) + work + l->yd + s * l->dd;
        if (sp__abs(f) <= sp__line_enough(l)) return s;
        if (f < 0) { lo = s; flo = f; }
        else { hi = s; fhi = f; }
        if (!(hi > 0)) {
            if (s > 1000) return s;
            s *= 4;
            continue;
        }
        s = lo + (hi - lo) * (-flo / (fhi - flo));
        const sp_real edge = (sp_real)0.1 * (hi - lo);          /* keep off the ends, or one of them never moves */
        if (s < lo + edge) s = lo + edge;
        if (s > hi - edge) s = hi - edge;
    }
    return lo > 0 ? lo : s;
}

/* Work of the load, resistance of the contacts at their caps (counted no further than the work), and what both are compared
 * with, for dq = -y, as the certificate check has them: sum c_v |P_K(u_v)| (with strength: the support function of K_v),
 * sum (sbar |v| + Sbar |w|). */
typedef struct sp__power { sp_real work, resist, scale; } sp__power;

/* Most that the vertices of contact c resist motion y with: sum of f.u over the f in K no longer than their cap that does most;
 * where K is a wedge that is the cap times |P_K(u)|. */
SP__NOINLINE static sp_real sp__newton_resist(const sp__system *w, int32_t c, const sp_real *y)
{
    const sp__view k = sp__view_of(w, c);
    const sp_real S = sp__system_scale(w, c), most = w->set->force_bound * sp__least_of_blocks(k.t, w->measure.size, 2) / S;
    sp__visit *s = sp__visit_of(w);
    sp_real *X = s->twist[0], *u = s->u[0], *f = s->f, sum = 0;
    sp__view_motion(w, &k, y, X);
    for (int32_t v = k.t->point; v < k.t->point + k.t->points; v++) {
        const sp_real times = sp__system_multiplicity(w, v);
        if (!(times > 0)) continue;
        sp__view_rates(w, &k, sp__view_place(w, &k, w->pb->local[v]), X, u);
        if (k.g) sp__view_wedge(w, &k, u, f);
        sum += times * (k.g ? sp__view_norm(&k, f) : sp__cone_support(&w->law.cone, w->law.yield, u, most));
    }
    return (k.g ? most : S) * sum;
}

/* Work and resistance of the motion dq = -y; contacts are asked until they resist all of the work. */
SP__NOINLINE static void sp__newton_power(sp__system *w, const sp_real *y, sp__power *o)
{
    const sp_problem *pb = w->pb;
    o->work = o->resist = o->scale = 0;
    if (!sp__system_sweep(w, 1, 1)) return;
    o->work = -sp__system_work(w, y);
    for (int32_t i = 0; i < pb->blocks; i++) {
        const sp_real *yi = y + 6 * (size_t)i, *s = w->measure.size + 2 * (size_t)i, *z = w->measure.weight + 2 * (size_t)i;
        o->scale += s[0] * z[0] * sp__norm3(yi) + s[1] * z[1] * sp__norm3(yi + 3);
    }
    for (int32_t c = 0; c < pb->contacts && o->resist < o->work; c++) o->resist += sp__newton_resist(w, c, y);
}

/* (work - resist) / scale */
static sp_real sp__newton_proof_margin(sp__system *w, const sp_real *y)
{
    sp__power o;
    sp__newton_power(w, y, &o);
    return o.work > o.resist ? sp__ratio(o.work - o.resist, o.scale) : 0;
}

/* Keep y as the mechanism if it is a proof. */
static void sp__newton_record_proof(sp__system *w, sp__newton *n, const sp_real *y, sp_state *state)
{
    if (n->proved || sp__newton_proof_margin(w, y) <= SP__MORE * w->set->tol) return;
    for (size_t k = 0; k < 6 * (size_t)w->pb->blocks; k++) state->dq[k] = -w->measure.weight[k / 3] * y[k];
    n->proved = 1;
}

#endif

#endif /* SP__STATICS_LINE_C */
