/* polygon: the polygons two blocks share: each pair of opposed, near patches is clipped in A's plane (geometry/clip.c), and
 * loops where B's plane is near become joints. Not in SP_SMALL: small_pair.c. */
#ifndef SP__CONTACTS_POLYGON_C
#define SP__CONTACTS_POLYGON_C

#include "overlap.c"
#include "pair.c"

#if !SP__WITH_SMALL

/* Give the boundary of a patch to the clipper: A's as it is, B's in A's plane, turned round. */
static void sp__pair_region(sp__touch *t, const sp__patch *plane, const sp__patch *p, int32_t side)
{
    for (int32_t e = p->edge; e < p->edge + p->edges; e++) {
        const int32_t u = t->all.bound[e][side], v = t->all.bound[e][1 - side];
        sp_real from[2], to[2];
        sp__pair_to_plane(t, plane, t->scene->vertex[u], from);
        sp__pair_to_plane(t, plane, t->scene->vertex[v], to);
        sp__clip_add(&t->clip, side, from, to, u, v);
    }
}

/* A corner of the result in space: on A's plane; a vertex that is there already stays what it is, to the bit. */
static void sp__pair_corner(const sp__touch *t, const sp__patch *p, int32_t corner, sp_real x[3])
{
    const int32_t name = t->clip.corner[corner].name;
    sp__pair_to_space(t, p, t->clip.corner[corner].x, x);
    if (name < 0) return;
    for (int c = 0; c < 3; c++) if (sp__abs(t->scene->vertex[name][c] - x[c]) > t->now.noise / 4) return;
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
    for (int32_t k = 1; k < size; k++) if (sp__place_order(p[k], p[first], t->now.snap) < 0) first = k;
    sp__reverse(p, 0, first);
    sp__reverse(p, first, size);
    sp__reverse(p, 0, size);
}

/* Is a loop of the clipper too narrow to be told from an edge: narrower than a distance above the default, of faces that are in
 * one plane by no more than that distance? Pieces cut at holes are of wider ones. */
static int sp__pair_is_edge(const sp__touch *t, const sp__patch *p, const sp__patch *q, sp_real (*point)[3], int32_t size)
{
    if (t->now.gap <= 8 * t->now.snap || t->clip.cut.opening) return 0;
    return sp__pair_narrow(t, p, point, size) && !sp__pair_exact(t, p, q, point, size);
}

/* Keep of loop l of the clipper what is near B's plane. */
static void sp__pair_add_loop(sp__touch *t, const sp__patch *p, const sp__patch *q, int32_t l)
{
    const int32_t from = t->clip.loop[l];
    int32_t size = t->clip.loop[l + 1] - from;
    sp_real (*point)[3] = t->pair.point + t->pair.points;
    if (size > t->pair.room - t->pair.points || t->pair.founds >= t->pair.room) { t->status = SP_E_MEMORY; return; }
    for (int32_t k = 0; k < size; k++) sp__pair_corner(t, p, from + k, point[k]);
    size = sp__pair_within(t, p, q, point, size);
    if (!size || sp__pair_is_edge(t, p, q, point, size)) return;
    sp__pair_between(t, p, q, point, size);
    sp__pair_canonical(t, point, size);
    t->pair.found[t->pair.founds].start = t->pair.points;
    t->pair.found[t->pair.founds].size = size;
    t->pair.points += size;
    t->pair.founds++;
}

/* Polygons of patch p of A and q of B, in the plane of p. */
static void sp__pair_clip(sp__touch *t, const sp__patch *p, const sp__patch *q)
{
    const sp_real usual = 8 * t->now.snap, thin = usual < t->now.gap ? usual : t->now.gap;
    sp__pair_plane(t, p);
    sp__pair_region(t, p, p, 0);
    sp__pair_region(t, p, q, 1);
    t->clip.slit = t->now.gap / t->now.unit;
    if (!sp__clip_run(&t->clip, t->now.snap / t->now.unit, thin / t->now.unit)) { t->status = SP_E_MEMORY; return; }
    for (int32_t l = 0; l < t->clip.loops && !t->status; l++) sp__pair_add_loop(t, p, q, l);
}

/* The distance that a block's body leaves of one across n: a quarter of its width there, for what is farther lies beyond it.
 * An open block has no inside; a closed one is wider than its volume over its diameter squared, which most often decides. */
static sp_real sp__body_limit(const sp__touch *t, int32_t block, const sp_real n[3], sp_real gap)
{
    const sp_block *k = &t->scene->block[block];
    if (!(k->volume > 0) || 4 * gap <= k->volume / k->diameter / k->diameter) return gap;
    const sp__span s = sp__span_body(t, n, block);
    const sp_real most = (s.hi - s.lo) / 4;
    return most < gap ? most : gap;
}

/* The distance that counts between patch p of A and one of B: what both leave of the settings', not below the default. */
static void sp__pair_limit(sp__touch *t, const sp__patch *p)
{
    const sp_real usual = 8 * t->now.snap;
    if (t->now.asked <= usual) return;
    t->now.gap = sp__body_limit(t, t->now.b, p->n, sp__body_limit(t, t->now.a, p->n, t->now.asked));
    t->now.gap = sp__max(t->now.gap, usual);
}

/* Patches of one block near the box of another. Returns how many. */
static int32_t sp__pair_near(const sp__touch *t, const sp__body *own, const sp__body *other, int32_t *list)
{
    int32_t n = 0;
    for (int32_t k = own->patch; k < own->patch + own->patches; k++) {
        const sp__patch *p = &t->all.patch[k];
        if (p->edges && sp__boxes_near(p->lo, p->hi, other->lo, other->hi, t->now.gap)) list[n++] = k;
    }
    return n;
}

/* Order of polygons by their corners, one after the other; of equal ones the shorter first, then the one found first. */
static int sp__polygon_before(const void *what, int32_t i, int32_t j)
{
    const sp__touch *t = what;
    const sp__polygon *f = &t->pair.found[i], *g = &t->pair.found[j];
    for (int32_t k = 0; k < f->size && k < g->size; k++) {
        const int o = sp__place_order(t->pair.point[f->start + k], t->pair.point[g->start + k], t->now.snap);
        if (o) return o < 0;
    }
    return f->size != g->size ? f->size < g->size : i < j;
}

/* Append what was found to the scene, in the order of corners; where there is no room, count. */
static void sp__pair_append(sp__touch *t)
{
    for (int32_t k = 0; k < t->pair.founds; k++) t->pair.rank[k] = k;
    sp__sort(t->pair.rank, t->pair.founds, sp__polygon_before, t);
    for (int32_t k = 0; k < t->pair.founds; k++) {
        const sp__polygon *f = &t->pair.found[t->pair.rank[k]];
        sp__pair_add(t, f->size, t->pair.point + f->start);
    }
}

/* All contacts of one pair, and their overlap. */
static void sp__touch_pair(sp__touch *t, int32_t b)
{
    const sp__body *p = &t->all.body[t->now.a], *q = &t->all.body[b];
    if (t->scene->block[t->now.a].fixed == SP_FIXED && t->scene->block[b].fixed == SP_FIXED) return;
    sp__pair_start(t, b);
    t->now.asked = t->now.gap;
    t->pair.points = t->pair.founds = 0;
    const int32_t n = sp__pair_near(t, p, q, t->pair.near_a), m = sp__pair_near(t, q, p, t->pair.near_b);
    for (int32_t i = 0; i < n; i++)
        for (int32_t j = 0; j < m && !t->status; j++) {
            const sp__patch *u = &t->all.patch[t->pair.near_a[i]], *v = &t->all.patch[t->pair.near_b[j]];
            if (!sp__pair_opposed(t, u, v)) continue;
            sp__pair_limit(t, u);
            sp__pair_clip(t, u, v);
            t->now.gap = t->now.asked;
        }
    if (t->status) return;
    sp__pair_append(t);
    if (!t->status) sp__pair_overlap(t);
}

#endif

#endif /* SP__CONTACTS_POLYGON_C */
