/* plane: a planar scene in 3 rows a block: corners that mirror each other as one, columns of their forces, rows in a band.
 *
 *   A f + p + lambda q = 0      A = (An, At): a corner's column (n, r x n) on its block B, opposite on A; rows Fx Fy M
 *   d = A' v                    dn, dt of a corner in the motion v, turns about the normal of the plane
 *
 * Forces are counted in the mean load of a block, lengths in the mean of the blocks' longest arms.
 */
#ifndef SP__SLIDING_PLANE_C
#define SP__SLIDING_PLANE_C

#include "../limit/limit.c"
#include "../statics/mirror.c"

#if SP__WITH_SLIDING

#define SP__SLIDING_BLOCKS 400          /* above so many free blocks no state is sought */
#define SP__SLAB_REST ((sp_real)1e5 * (sp_real)SP_EPSILON)  /* of the fastest block: as good as at rest */

typedef struct sp__slab_corner {
    int32_t contact, at, image;         /* its point, and that point's mirror image or itself */
    int32_t row[2];                     /* of B, of A, where its 3 rows begin; -1: a support */
    sp_real mu, n[6], t[6];             /* columns of pressure and of friction, B's rows, then A's */
    sp_real slip[2];                    /* direction of t in the joint's t1, t2 */
} sp__slab_corner;

typedef struct sp__slab {
    const sp_problem *pb;
    sp__reduction o;
    int32_t corners, rows, band;        /* rows: 3 a block; |i - j| <= band where two rows share a corner */
    sp__slab_corner *corner;
    int32_t *place, *queue;             /* b: of a block among the rows; work */
    sp_real *p, *q;                     /* rows */
    sp_real force, length;              /* units [N], [m] */
} sp__slab;

static void sp__slab_carve(sp__slab *w, const sp_problem *pb, sp_arena *a)
{
    const size_t b = (size_t)pb->blocks;
    w->pb = pb;
    w->o.image = sp__take(a, (size_t)pb->points, sizeof *w->o.image);
    w->corner = sp__take(a, (size_t)pb->points, sizeof *w->corner);
    w->place = sp__take(a, b, sizeof *w->place);
    w->queue = sp__take(a, b, sizeof *w->queue);
    w->p = sp__take(a, b, 3 * sizeof *w->p);
    w->q = sp__take(a, b, 3 * sizeof *w->q);
}

/* Have joints, dead and live loads one mirror? Then its normal is w->o.e[2].     b: its loads are set anew */
static int sp__slab_planar(sp__slab *w, sp__bracket *b)
{
    const sp_problem *pb = &b->pb;
    int planar = pb->blocks > 0 && pb->contacts > 0;
    w->o.mode = SP__PLANE;
    sp__bracket_load(b, 1, 1);
    planar = planar && sp__reduction_planar(pb, &b->set, w->o.e[2]);
    for (int live = 0; live < 2; live++) {
        sp__bracket_load(b, live ? 0 : 1, live ? 1 : 0);
        planar = planar && sp__mirror_loads(pb, &b->set, w->o.e[2], 0);
    }
    sp__bracket_load(b, 1, 0);
    return planar;
}

/* Blocks from `first` on, each followed by those it touches, from w->queue[n].     returns how many there are then */
static int32_t sp__slab_walk(sp__slab *w, int32_t first, int32_t n)
{
    const sp_problem *pb = w->pb;
    int32_t end = n + 1;
    w->queue[n] = first;
    w->place[first] = n;
    for (; n < end; n++)
        for (int32_t c = 0; c < pb->contacts; c++) {
            const int32_t a = pb->contact[c].a, b = pb->contact[c].b, i = w->queue[n];
            const int32_t next = a < 0 || b < 0 ? -1 : a == i ? b : b == i ? a : -1;
            if (next < 0 || w->place[next] >= 0) continue;
            w->place[next] = end;
            w->queue[end++] = next;
        }
    return end;
}

/* Elimination order: level by level from an end of the structure, which a first walk finds.        [Cuthill, McKee 1969] */
SP__NOINLINE static void sp__slab_order(sp__slab *w)
{
    const sp_problem *pb = w->pb;
    int32_t n = 0;
    for (int32_t i = 0; i < pb->blocks; i++) w->place[i] = -1;
    for (int32_t i = 0; i < pb->blocks; i++) {
        if (w->place[i] >= 0) continue;
        const int32_t end = sp__slab_walk(w, i, n), last = w->queue[end - 1];
        for (int32_t k = n; k < end; k++) w->place[w->queue[k]] = -1;
        n = sp__slab_walk(w, last, n);
    }
    w->band = 2;
    for (int32_t c = 0; c < pb->contacts; c++) {
        const int32_t a = pb->contact[c].a, b = pb->contact[c].b;
        if (a < 0 || b < 0) continue;
        const int32_t apart = w->place[a] < w->place[b] ? w->place[b] - w->place[a] : w->place[a] - w->place[b];
        if (3 * apart + 2 > w->band) w->band = 3 * apart + 2;
    }
}

/* Mean load of a block, dead and live together, and mean of the longest arms. */
static void sp__slab_units(sp__slab *w, const sp__bracket *b)
{
    const sp_problem *pb = w->pb;
    sp_real force = 0, length = 0;
    for (int32_t i = 0; i < pb->blocks; i++) force += sp__norm3(b->dead + 6 * (size_t)i) + sp__norm3(b->live + 6 * (size_t)i);
    for (int32_t c = 0; c < pb->contacts; c++) {
        sp_real r[3];
        sp__arm(pb, pb->contact[c].b >= 0 ? pb->contact[c].b : pb->contact[c].a, pb->contact[c].point, r);
        sp__add3(r, -sp__dot3(r, w->o.e[2]), w->o.e[2]);
        length += sp__norm3(r);
    }
    w->force = force > 0 ? force / (sp_real)pb->blocks : 1;
    w->length = length > 0 ? length / (sp_real)pb->contacts : 1;
}

/* Rows of the loads in the plane. */
static void sp__slab_loads(sp__slab *w, const sp_real *load, sp_real *rows)
{
    for (int32_t i = 0; i < w->pb->blocks; i++) {
        const sp_real *x = load + 6 * (size_t)i;
        sp_real *to = rows + 3 * (size_t)w->place[i];
        to[0] = sp__dot3(x, w->o.e[0]) / w->force;
        to[1] = sp__dot3(x, w->o.e[1]) / w->force;
        to[2] = sp__dot3(x + 3, w->o.e[2]) / (w->force * w->length);
    }
}

/* Column of a unit force along (x, y) at a corner. */
static void sp__slab_column(const sp__slab *w, const sp__slab_corner *k, sp_real x, sp_real y, sp_real to[6])
{
    const sp_contact *t = &w->pb->contact[k->contact];
    for (int side = 0; side < 2; side++) {
        const int32_t i = side ? t->a : t->b;
        const sp_real sign = side ? (sp_real)-1 : (sp_real)1;
        sp_real r[3];
        sp__arm(w->pb, i, k->at, r);
        to[3 * side] = sign * x;
        to[3 * side + 1] = sign * y;
        to[3 * side + 2] = sign * (sp__dot3(r, w->o.e[0]) * y - sp__dot3(r, w->o.e[1]) * x) / w->length;
    }
}

static void sp__slab_corner_make(const sp__slab *w, int32_t contact, int32_t v, sp__slab_corner *k)
{
    const sp_contact *t = &w->pb->contact[contact];
    const sp_real x = sp__dot3(t->joint->n, w->o.e[0]), y = sp__dot3(t->joint->n, w->o.e[1]);
    sp_real slip[3];
    for (int q = 0; q < 3; q++) slip[q] = x * w->o.e[1][q] - y * w->o.e[0][q];
    k->contact = contact;
    k->at = v;
    k->image = w->o.image[v];
    k->mu = t->joint->strength.mu;
    k->row[0] = t->b < 0 ? -1 : 3 * w->place[t->b];
    k->row[1] = t->a < 0 ? -1 : 3 * w->place[t->a];
    k->slip[0] = sp__dot3(slip, t->joint->t1);
    k->slip[1] = sp__dot3(slip, t->joint->t2);
    sp__slab_column(w, k, x, y, k->n);
    sp__slab_column(w, k, -y, x, k->t);
}

/* Corners, rows, units.     returns 0: the scene is not planar */
SP__NOINLINE static int sp__slab_make(sp__slab *w, sp__bracket *b)
{
    const sp_problem *pb = w->pb;
    if (!sp__slab_planar(w, b)) return 0;
    sp__reduction_axes(&w->o);
    sp__reduction_images(&w->o, pb, &b->set);
    sp__slab_order(w);
    sp__slab_units(w, b);
    w->rows = 3 * pb->blocks;
    sp__slab_loads(w, b->dead, w->p);
    sp__slab_loads(w, b->live, w->q);
    w->corners = 0;
    for (int32_t c = 0; c < pb->contacts; c++)
        for (int32_t v = pb->contact[c].point; v < pb->contact[c].point + pb->contact[c].points; v++)
            if (w->o.image[v] >= v) sp__slab_corner_make(w, c, v, &w->corner[w->corners++]);
    return 1;
}

/* c . v of a corner's column. */
static sp_real sp__slab_rate(const sp__slab_corner *k, const sp_real *c, const sp_real *v)
{
    sp_real d = 0;
    for (int side = 0; side < 2; side++)
        for (int q = 0; q < 3 && k->row[side] >= 0; q++) d += c[3 * side + q] * v[k->row[side] + q];
    return d;
}

/* r += f c */
static void sp__slab_push(const sp__slab_corner *k, const sp_real *c, sp_real f, sp_real *r)
{
    for (int side = 0; side < 2; side++)
        for (int q = 0; q < 3 && k->row[side] >= 0; q++) r[k->row[side] + q] += f * c[3 * side + q];
}

/* Forces fn, ft of the corners as 3 numbers of every point; a corner off the mirror shares its force with its image. */
static void sp__slab_forces(const sp__slab *w, const sp_real *fn, const sp_real *ft, sp_real *f)
{
    for (int32_t v = 0; v < w->corners; v++) {
        const sp__slab_corner *k = &w->corner[v];
        const sp_real share = w->force / (k->image == k->at ? 1 : 2);
        sp_real *to = f + 3 * (size_t)k->at;
        to[0] = share * fn[v];
        to[1] = share * ft[v] * k->slip[0];
        to[2] = share * ft[v] * k->slip[1];
        memcpy(f + 3 * (size_t)k->image, to, 3 * sizeof *to);
    }
}

/* How much a block moves: its centroid or a mean arm. */
static sp_real sp__slab_speed(const sp_real x[3]) { return SP_SQRT(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]); }

/* A motion as 6 numbers of every free block, the fastest by a mean arm [m]; what moves less than rounding is at rest. */
static void sp__slab_motion(const sp__slab *w, const sp_real *v, sp_real *m)
{
    sp_real most = 0;
    for (int32_t i = 0; i < w->pb->blocks; i++) most = sp__max(most, sp__slab_speed(v + 3 * (size_t)i));
    for (int32_t i = 0; i < w->pb->blocks; i++) {
        const sp_real *x = v + 3 * (size_t)w->place[i];
        const sp_real scale = sp__slab_speed(x) > SP__SLAB_REST * most ? 1 / most : 0;
        for (int k = 0; k < 3; k++) {
            m[6 * (size_t)i + (size_t)k] = scale * w->length * (x[0] * w->o.e[0][k] + x[1] * w->o.e[1][k]);
            m[6 * (size_t)i + 3 + (size_t)k] = scale * x[2] * w->o.e[2][k];
        }
    }
}

#endif

#endif /* SP__SLIDING_PLANE_C */
