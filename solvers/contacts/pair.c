/* pair: the contacts of two blocks */
#ifndef SP__CONTACTS_PAIR_C
#define SP__CONTACTS_PAIR_C

#include "sweep.c"

/* --------------------------------------------------------------------------------------------------------------- pair */

/* Coordinates of x in the plane of patch p, e1 and e2 from o, in units. */
static void sp__pair_flat(const sp__touch *t, const sp__patch *p, const sp_real x[3], sp_real xy[2])
{
    sp_real d[3];
    sp__sub3(x, p->o, d);
    xy[0] = sp__dot3(t->e1, d) / t->unit;
    xy[1] = sp__dot3(t->e2, d) / t->unit;
}

/* Give the boundary of a patch to the clipper: A's as it is, B's in A's plane, turned round. */
static void sp__pair_region(sp__touch *t, const sp__patch *plane, const sp__patch *p, int32_t side)
{
#ifdef SP_SMALL
    for (int32_t k = 0; k < p->edges; k++) {
        sp_real x[2];
        sp__pair_flat(t, plane, t->scene->vertex[t->all.bound[p->edge + (side ? p->edges - 1 - k : k)][0]], x);
        sp__clip_add(&t->clip, side, x);
    }
#else
    for (int32_t e = p->edge; e < p->edge + p->edges; e++) {
        const int32_t u = t->all.bound[e][side], v = t->all.bound[e][1 - side];
        sp_real from[2], to[2];
        sp__pair_flat(t, plane, t->scene->vertex[u], from);
        sp__pair_flat(t, plane, t->scene->vertex[v], to);
        sp__clip_add(&t->clip, side, from, to, u, v);
    }
#endif
}

/* A place in the plane of patch p in space. */
static void sp__pair_place(const sp__touch *t, const sp__patch *p, const sp_real xy[2], sp_real x[3])
{
    for (int c = 0; c < 3; c++) x[c] = p->o[c] + t->unit * (xy[0] * t->e1[c] + xy[1] * t->e2[c]);
}

#ifdef SP_SMALL
static void sp__pair_corner(const sp__touch *t, const sp__patch *p, int32_t corner, sp_real x[3])
{
    sp__pair_place(t, p, t->clip.corner[corner], x);
}
#else
/* A corner of the result in space: on A's plane; a vertex that is there already stays what it is, to the bit. */
static void sp__pair_corner(const sp__touch *t, const sp__patch *p, int32_t corner, sp_real x[3])
{
    const int32_t name = t->clip.corner[corner].name;
    sp__pair_place(t, p, t->clip.corner[corner].x, x);
    if (name < 0) return;
    for (int c = 0; c < 3; c++) if (sp__abs(t->scene->vertex[name][c] - x[c]) > t->noise / 4) return;
    memcpy(x, t->scene->vertex[name], 3 * sizeof *x);
}

static void sp__reverse(sp_real (*p)[3], int32_t from, int32_t to)
{
    for (to--; from < to; from++, to--)
        for (int c = 0; c < 3; c++) {
            const sp_real x = p[from][c];
            p[from][c] = p[to][c];
            p[to][c] = x;
        }
}

/* Start the polygon at its first corner in order of x, y, z. */
static void sp__pair_canonical(const sp__touch *t, sp_real (*p)[3], int32_t size)
{
    int32_t first = 0;
    for (int32_t k = 1; k < size; k++) if (sp__place_order(p[k], p[first], t->snap) < 0) first = k;
    sp__reverse(p, 0, first);
    sp__reverse(p, first, size);
    sp__reverse(p, 0, size);
}
#endif

/* Append a polygon to the scene; where there is no room, count. */
static void sp__pair_add(sp__touch *t, int32_t size, sp_real (*point)[3])
{
    const sp_status s = sp_scene_interface(t->scene, t->a, t->b, size, point[0], &t->set.joint, NULL);
    if (s != SP_OK && s != SP_E_CAPACITY) return;                   /* too small for its coordinates */
    t->full |= s == SP_E_CAPACITY;
    t->report.interfaces++;
    t->report.points += size;
}

#ifdef SP_SMALL
/* Append what was gathered in the plane of patch p, unless that is all and narrower than `near`. */
static void sp__pair_close(sp__touch *t, const sp__patch *p)
{
    const int32_t n = t->pair.corners;
    for (int32_t k = 0; k < n; k++) sp__pair_place(t, p, t->pair.hull.p[k], t->pair.point[k]);
    if (n && (t->pair.parts || sp__clip_wide(t->pair.hull.p, n, t->near / t->unit) > 0)) sp__pair_add(t, n, t->pair.point);
    t->pair.corners = 0;
}

/* Gather the clipper's polygon: the hull of it and what there is. Without room for that what there is goes by itself. */
static void sp__pair_gather(sp__touch *t, const sp__patch *p)
{
    sp__clip *c = &t->clip;
    sp__hull *h = &t->pair.hull;
    if (t->pair.corners + c->corners > c->cap) {
        t->pair.parts++;
        sp__pair_close(t, p);
    }
    h->points = t->pair.corners + c->corners;
    memcpy(h->p + t->pair.corners, c->corner, (size_t)c->corners * sizeof *h->p);
    sp__hull_run(h);
    c->corners = h->corners;
    for (int32_t k = 0; k < h->corners; k++) memcpy(c->corner[k], h->p[h->corner[k]], sizeof *h->p);
    sp__clip_straighten(c);
    t->pair.corners = c->corners;
    memcpy(h->p, c->corner, (size_t)c->corners * sizeof *h->p);
}
#endif

/* Keep loop l of the clipper if B's plane is near in its middle: gap g along n_A, n_B . (o_B - m - g n_A) = 0. */
static void sp__pair_keep(sp__touch *t, const sp__patch *p, const sp__patch *q, int32_t l)
{
    const int32_t from = t->clip.loop[l], size = t->clip.loop[l + 1] - from;
    sp_real m[3] = { 0, 0, 0 }, (*point)[3] = t->pair.point;
#ifndef SP_SMALL
    if (size > t->pair.room - t->points || t->founds >= t->pair.room) { t->status = SP_E_MEMORY; return; }
    point += t->points;
#endif
    for (int32_t k = 0; k < size; k++) {
        sp_real d[3];
        sp__pair_corner(t, p, from + k, point[k]);
        sp__sub3(q->o, point[k], d);
        sp__add3(m, 1 / (sp_real)size, d);
    }
    if (sp__abs(sp__dot3(q->n, m) / sp__dot3(q->n, p->n)) > t->near) return;
#ifdef SP_SMALL
    sp__pair_gather(t, p);
#else
    sp__pair_canonical(t, point, size);
    t->pair.found[t->founds].start = t->points;
    t->pair.found[t->founds].size = size;
    t->points += size;
    t->founds++;
#endif
}

/* Can patches p and q touch: opposed to within the angle, boxes and planes near? Between planes at angle s the distance
 * changes by s times the way. */
static int sp__pair_opposed(const sp__touch *t, const sp__patch *p, const sp__patch *q)
{
    sp_real x[3], d[3];
    if (sp__dot3(p->n, q->n) >= 0 || !sp__boxes_near(p->lo, p->hi, q->lo, q->hi, t->near)) return 0;
    sp__cross3(p->n, q->n, x);
    const sp_real s = sp__norm3(x);
    if (s > t->set.angle) return 0;
    sp__sub3(q->o, p->o, d);
    return sp__abs(sp__dot3(d, p->n)) <= 2 * t->near + 2 * s * sp__norm3(d);
}

/* Polygons of two patches, u of A and q of B, in the plane of patch p: u, or of SP_SMALL the first in u's plane. */
static void sp__pair_clip(sp__touch *t, const sp__patch *p, const sp__patch *u, const sp__patch *q)
{
    sp__across3(p->n, t->e1);
    sp__cross3(p->n, t->e1, t->e2);
    sp__clip_clear(&t->clip);
    sp__pair_region(t, p, u, 0);
    sp__pair_region(t, p, q, 1);
    if (!sp__clip_run(&t->clip, t->snap / t->unit, t->near / t->unit)) { t->status = SP_E_MEMORY; return; }
#ifdef SP_SMALL
    if (t->clip.bent) { t->status = SP_E_UNSUPPORTED; return; }
#endif
    for (int32_t l = 0; l < t->clip.loops && !t->status; l++) sp__pair_keep(t, p, q, l);
}

#ifndef SP_SMALL
/* Patches of one block near the box of another. Returns how many. */
static int32_t sp__pair_near(const sp__touch *t, const sp__body *own, const sp__body *other, int32_t *list)
{
    int32_t n = 0;
    for (int32_t k = own->patch; k < own->patch + own->patches; k++) {
        const sp__patch *p = &t->all.patch[k];
        if (p->edges && sp__boxes_near(p->lo, p->hi, other->lo, other->hi, t->near)) list[n++] = k;
    }
    return n;
}

static int sp__found_before(const void *what, int32_t i, int32_t j)
{
    const sp__touch *t = what;
    const sp__found *f = &t->pair.found[i], *g = &t->pair.found[j];
    for (int32_t k = 0; k < f->size && k < g->size; k++) {
        const int o = sp__place_order(t->pair.point[f->start + k], t->pair.point[g->start + k], t->snap);
        if (o) return o < 0;
    }
    return f->size != g->size ? f->size < g->size : i < j;
}

/* Append what was found to the scene, in the order of corners; where there is no room, count. */
static void sp__pair_append(sp__touch *t)
{
    for (int32_t k = 0; k < t->founds; k++) t->pair.rank[k] = k;
    sp__sort(t->pair.rank, t->founds, sp__found_before, t);
    for (int32_t k = 0; k < t->founds; k++) {
        const sp__found *f = &t->pair.found[t->pair.rank[k]];
        sp__pair_add(t, f->size, t->pair.point + f->start);
    }
}
#endif

/* Tolerances of the pair. */
static void sp__pair_start(sp__touch *t, int32_t b)
{
    const sp__body *p = &t->all.body[t->a], *q = &t->all.body[b];
    const sp_real d = t->scene->block[t->a].diameter, e = t->scene->block[b].diameter, small = d < e ? d : e;
    t->b = b;
    t->noise = sp__max(p->noise, q->noise);
    t->near = sp__max(t->noise, p->reach < q->reach ? p->reach : q->reach);
    t->snap = (sp_real)1e-6 * small < t->near ? (sp_real)1e-6 * small : t->near;
    t->snap = sp__max(t->noise, t->snap / 8);
    t->unit = small > 0 ? sp__power_of_two(small) : (sp_real)1;
}

#endif /* SP__CONTACTS_PAIR_C */
