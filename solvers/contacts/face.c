/* face: the plane of a face through the mean of its vertices, normal sum p x q over its edges; bounding boxes of edges.
 *                                                                                                  [Newell's normal] */
#ifndef SP__CONTACTS_FACE_C
#define SP__CONTACTS_FACE_C

#include "../scene/joint.c"
#include "touch.c"

/* Lexicographic order of places; 0: the same. */
static int sp__place_order(const sp_real p[3], const sp_real q[3], sp_real eps)
{
    for (int c = 0; c < 3; c++) {
        if (p[c] < q[c] - eps) return -1;
        if (p[c] > q[c] + eps) return 1;
    }
    return 0;
}

/* Plane of a face through its vertex mean; normal 0 without one.     returns twice the area */
SP__NOINLINE static sp_real sp__face_plane(const sp__touch *t, int32_t f, sp_real n[3], sp_real m[3])
{
    const sp_face *face = &t->scene->face[t->own.face0 + f];
    const int32_t *corner = t->scene->corner + face->corner;
    sp__local l;
    (void)sp__local_start(&l, t->scene->vertex[0], corner, face->corners);
    (void)sp__polygon_normal(&l, corner, face->corners, n);
    sp__local_mean(&l, corner, face->corners, m);
    const sp_real twice = sp__norm3(n);
    for (int c = 0; c < 3; c++) {
        n[c] = twice > 0 ? n[c] / twice : 0;
        m[c] = l.o[c] + l.s * m[c];
    }
    return twice * l.s * l.s;
}

#if SP__WITH_SMALL

/* Points nearer to a plane than this lie in it. */
static sp_real sp__plane_tolerance(const sp__touch *t, const sp__body *body)
{
    return sp__max(body->noise, (sp_real)1e-6 * t->scene->block[t->own.block].diameter / 8);
}

#else

/* Points nearer to a plane than this lie in it: an eighth of the distance up to 1e-6 diameters, and half of what is above. */
static sp_real sp__plane_tolerance(const sp__touch *t, const sp__body *body)
{
    const sp_real usual = (sp_real)1e-6 * t->scene->block[t->own.block].diameter;
    const sp_real fine = sp__max(body->noise, (body->reach < usual ? body->reach : usual) / 8);
    return sp__max(fine, (body->reach - 8 * fine) / 2);
}

#endif

/* Farthest corner of a face from a plane. */
static sp_real sp__face_distance(const sp__touch *t, int32_t f, const sp_real n[3], const sp_real o[3])
{
    const sp_face *face = &t->scene->face[t->own.face0 + f];
    sp_real most = 0;
    for (int32_t k = 0; k < face->corners; k++) {
        sp_real d[3];
        sp__sub3(t->scene->vertex[t->scene->corner[face->corner + k]], o, d);
        most = sp__max(most, sp__abs(sp__dot3(d, n)));
    }
    return most;
}

/* The box of one point. */
static void sp__box_start(sp_real lo[3], sp_real hi[3], const sp_real p[3])
{
    for (int c = 0; c < 3; c++) lo[c] = hi[c] = p[c];
}

/* The box of what it holds and p. */
static void sp__box_add(sp_real lo[3], sp_real hi[3], const sp_real p[3])
{
    for (int c = 0; c < 3; c++) {
        lo[c] = p[c] < lo[c] ? p[c] : lo[c];
        hi[c] = hi[c] < p[c] ? p[c] : hi[c];
    }
}

/* Box of boundary edges from..to-1. */
static void sp__bound_box(const sp__touch *t, int32_t from, int32_t to, sp_real lo[3], sp_real hi[3])
{
    for (int32_t e = from; e < to; e++) {
        const sp_real *x = t->scene->vertex[t->all.bound[e][0]];
        if (e == from) sp__box_start(lo, hi, x);
        sp__box_add(lo, hi, x);
    }
}

/* Do two boxes come nearer than d? */
static int sp__boxes_near(const sp_real lo[3], const sp_real hi[3], const sp_real lo2[3], const sp_real hi2[3], sp_real d)
{
    for (int c = 0; c < 3; c++) if (lo[c] > hi2[c] + d || lo2[c] > hi[c] + d) return 0;
    return 1;
}

#endif /* SP__CONTACTS_FACE_C */
