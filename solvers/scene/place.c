/* place: where a stone may be placed, by geometry and its centre of mass alone: support clearance and cost, seats, resting
 * faces, next-best-object gate.                                                                            [seed 6.1, 6.2] */
#ifndef SP__SCENE_PLACE_C
#define SP__SCENE_PLACE_C

#include "../geometry/hull.c"
#include "joint.c"

SP_API size_t sp_support_memory(int32_t points)
{
    if (points < 0) return 0;
    sp__hull h;
    sp_arena dry = sp__arena_dry();
    sp__hull_carve(&h, points, &dry);
    return dry.used;
}

/* Coordinates of x across `up`, seen from o. */
static void sp__plane_coordinates(const sp_real up[3], const sp_real o[3], const sp_real x[3], sp_real xy[2])
{
    sp_real s[3], t[3], d[3];
    sp__across3(up, s);
    sp__cross3(up, s, t);
    sp__sub3(x, o, d);
    xy[0] = sp__dot3(s, d);
    xy[1] = sp__dot3(t, d);
}

/* Clearance and direction from a hull whose origin is the centre of mass.     returns SP_E_NOT_FINITE: its square overflows */
static sp_status sp__support_read(sp__hull *h, sp_support *support)
{
    const sp_real com[2] = { 0, 0 };
    sp_real size = 0, g[3] = { 0, 0, 0 };
    const sp_support none = { (sp_real)-1, 0, (sp_real)1e9 };
    for (int32_t i = 0; i < h->points; i++) size = sp__max(size, sp__max(sp__abs(h->p[i][0]), sp__abs(h->p[i][1])));
    if (!sp__finite(size * size)) return SP_E_NOT_FINITE;
    sp__hull_run(h);
    *support = none;
    if (h->corners < 3) return SP_OK;
    const sp_real area = sp__hull_area(h, g);
    if (!(area > (sp_real)64 * SP_EPSILON * size * size)) return SP_OK;
    support->area = area;
    support->clearance = sp__hull_clearance(h, com);
    support->offset = sp__norm3(g);
    return SP_OK;
}

SP_API sp_status sp_support_clearance(const sp_real *xyz, int32_t points, const sp_real com[3], const sp_real gravity[3],
                                      sp_arena scratch, sp_support *support)
{
    if ((!xyz && points) || points < 0 || !com || !gravity || !support || !scratch.base) return SP_E_ARGUMENT;
    if (!sp__finite3(com) || !sp__finite3(gravity)) return SP_E_NOT_FINITE;
    if (!sp__all_finite(xyz, 3 * (size_t)points)) return SP_E_NOT_FINITE;
    if (!(sp__norm3(gravity) > 0)) return SP_E_RANGE;
    sp_real up[3];
    sp__hull h;
    sp__hull_carve(&h, points, &scratch);
    if (sp__failed(&scratch)) return SP_E_MEMORY;
    sp__unit3(gravity, up);
    sp__scale3((sp_real)-1, up, up);
    for (int32_t i = 0; i < points; i++) sp__plane_coordinates(up, com, xyz + 3 * (size_t)i, h.p[i]);
    return sp__support_read(&h, support);
}

SP_API sp_seat_weights sp_seat_weights_default(void)
{
    const sp_seat_weights w = { (sp_real)1, (sp_real)1, (sp_real)1, (sp_real)0.5 };
    return w;
}

static sp_status sp__seat_check(const sp_seat *s, const sp_seat_weights *w)
{
    sp_real x[sizeof *s / sizeof s->seat], y[sizeof *w / sizeof w->seat];           /* they are nothing but numbers */
    memcpy(x, s, sizeof x);
    memcpy(y, w, sizeof y);
    if (!sp__all_finite(x, sizeof x / sizeof *x) || !sp__all_finite(y, sizeof y / sizeof *y)) return SP_E_NOT_FINITE;
    if (!(s->footprint > 0 && s->height > 0 && s->width > 0 && s->trapped >= 0)) return SP_E_RANGE;
    return w->area >= 0 && w->offset >= 0 && w->trapped >= 0 && w->seat >= 0 ? SP_OK : SP_E_RANGE;
}

SP_API sp_status sp_support_cost(const sp_seat *seat, const sp_seat_weights *weights, sp_real *J)
{
    const sp_seat_weights w = weights ? *weights : sp_seat_weights_default();
    if (!seat || !J) return SP_E_ARGUMENT;
    const sp_status status = sp__seat_check(seat, &w);
    if (status) return status;
    const sp_real cost = w.area * ((sp_real)1 - seat->support.area / seat->footprint)
                       + w.offset * seat->support.offset / seat->width
                       + w.trapped * (seat->trapped / seat->footprint) / seat->height + w.seat * seat->seat / seat->width;
    if (!sp__finite(cost)) return SP_E_NOT_FINITE;
    *J = cost;
    return SP_OK;
}

typedef struct sp__seats { const sp_seat *seat; const sp_real *J; sp_real margin; } sp__seats;

static int sp__seat_before(const void *what, int32_t i, int32_t j)
{
    const sp__seats *s = what;
    const int p = s->seat[i].support.clearance >= s->margin, q = s->seat[j].support.clearance >= s->margin;
    if (p != q) return p;
    if (s->J[i] < s->J[j] || s->J[i] > s->J[j]) return s->J[i] < s->J[j];
    return i < j;
}

SP_API sp_status sp_support_rank(const sp_seat *seats, int32_t count, sp_real margin, const sp_seat_weights *weights,
                                 sp_real *J, int32_t *order, int32_t *stable)
{
    if (count < 0 || (count && (!seats || !J || !order))) return SP_E_ARGUMENT;
    if (!sp__finite(margin)) return SP_E_NOT_FINITE;
    const sp__seats s = { seats, J, margin };
    int32_t enough = 0;
    for (int32_t i = 0; i < count; i++) {
        const sp_status status = sp_support_cost(&seats[i], weights, &J[i]);
        if (status) return status;
        order[i] = i;
        enough += seats[i].support.clearance >= margin;
    }
    sp__sort(order, count, sp__seat_before, &s);
    if (stable) *stable = enough;
    return SP_OK;
}

/* How far x lies outside the plane through o with normal n, seen from o. */
static sp_real sp__plane_distance(const sp_real n[3], const sp_real o[3], const sp_real x[3])
{
    sp_real d[3];
    sp__sub3(x, o, d);
    return sp__dot3(n, d);
}

/* Unit normal of a face.     returns 0 where it has no area */
static int sp__face_normal(const sp_mesh *mesh, const int32_t *corner, int32_t size, sp_real n[3])
{
    sp__local l;
    if (sp__local_start(&l, mesh->xyz, corner, size)) return 0;
    (void)sp__polygon_normal(&l, corner, size, n);
    if (!(sp__norm3(n) > 0)) return 0;
    sp__unit3(n, n);
    return 1;
}

/* Does the whole stone lie behind the plane through o with normal n? */
static int sp__rest_behind(const sp_mesh *mesh, const sp_real n[3], const sp_real o[3], sp_real eps)
{
    for (int32_t v = 0; v < mesh->vertices; v++) if (sp__plane_distance(n, o, mesh->xyz + 3 * (size_t)v) > eps) return 0;
    return 1;
}

/* Does no corner of a face lie deeper than eps behind the plane through o with normal n? */
static int sp__rest_in(const sp_mesh *mesh, const int32_t *corner, int32_t size, const sp_real n[3], const sp_real o[3],
                       sp_real eps)
{
    for (int32_t k = 0; k < size; k++) if (sp__plane_distance(n, o, mesh->xyz + 3 * (size_t)corner[k]) < -eps) return 0;
    return 1;
}

/* Is the face with corners `own` and normal n the first of its plane? So each plane is counted once. An earlier one has the
 * whole stone behind it, and each lies in the other's plane: a sliver at an edge lies in both planes there. */
static int sp__rest_first(const sp_mesh *mesh, int32_t face, const int32_t *own, const sp_real n[3], sp_real eps)
{
    const int32_t *corner = mesh->corner;
    const sp_real *o = mesh->xyz + 3 * (size_t)own[0];
    for (int32_t f = 0; f < face; corner += mesh->size[f++]) {
        const sp_real *at = mesh->xyz + 3 * (size_t)corner[0];
        sp_real m[3];
        if (sp__rest_in(mesh, corner, mesh->size[f], n, o, eps) && sp__face_normal(mesh, corner, mesh->size[f], m)
            && sp__rest_behind(mesh, m, at, eps) && sp__rest_in(mesh, own, mesh->size[face], m, at, eps)) return 0;
    }
    return 1;
}

/* The hull of all vertices in the plane, the centroid its origin. */
static sp_status sp__rest_support(const sp_mesh *mesh, const sp_mass *mass, const sp_real o[3], sp_real eps, sp_rest *r,
                                  sp_arena scratch)
{
    sp__hull h;
    sp_real up[3];
    sp__hull_carve(&h, mesh->vertices, &scratch);
    if (sp__failed(&scratch)) return SP_E_MEMORY;
    h.points = 0;
    sp__scale3((sp_real)-1, r->normal, up);
    for (int32_t v = 0; v < mesh->vertices; v++) {
        const sp_real *x = mesh->xyz + 3 * (size_t)v;
        if (sp__plane_distance(r->normal, o, x) >= -eps) sp__plane_coordinates(up, mass->centroid, x, h.p[h.points++]);
    }
    r->height = -sp__plane_distance(r->normal, o, mass->centroid);
    return sp__support_read(&h, &r->support);
}

SP_API sp_status sp_rest_faces(const sp_mesh *mesh, sp_arena scratch, sp_rest *rest, int32_t capacity, int32_t *count)
{
    if (!scratch.base || (capacity && !rest) || capacity < 0 || !count) return SP_E_ARGUMENT;
    sp_mass mass;
    sp_status status = sp_mesh_mass(mesh, &mass);
    if (status) return status;
    const sp_real eps = sp__max((sp_real)1e-6, (sp_real)32 * SP_EPSILON) * mass.diameter;
    const int32_t *corner = mesh->corner;
    int32_t found = 0;
    for (int32_t f = 0; f < mesh->faces && !status; corner += mesh->size[f++]) {
        const sp_real *o = mesh->xyz + 3 * (size_t)corner[0];
        sp_rest r = { f, { 0, 0, 0 }, 0, { 0, 0, 0 } };
        if (!sp__face_normal(mesh, corner, mesh->size[f], r.normal)) continue;
        if (!sp__rest_behind(mesh, r.normal, o, eps) || !sp__rest_first(mesh, f, corner, r.normal, eps)) continue;
        status = sp__rest_support(mesh, &mass, o, eps, &r, scratch);
        if (status || !(r.support.clearance > 0)) continue;
        if (found < capacity) rest[found] = r;
        found++;
    }
    if (!status) *count = found;
    return !status && found > capacity ? SP_E_CAPACITY : status;
}

SP_API sp_nbo_settings sp_nbo_settings_default(void)
{
    const sp_nbo_settings s = { 0, (sp_real)0.5, (sp_real)0.7 };
    return s;
}

SP_API sp_status sp_nbo_gate(const sp_laid *laid, const sp_real gravity[3], const sp_nbo_settings *settings, sp_arena scratch,
                             sp_nbo *reason, sp_real *margin)
{
    const sp_nbo_settings set = settings ? *settings : sp_nbo_settings_default();
    const sp_real wants[3] = { set.margin, set.slender, set.level };
    sp_support s;
    if (!laid || !reason) return SP_E_ARGUMENT;
    const sp_status status = sp_support_clearance(laid->xyz, laid->points, laid->com, gravity, scratch, &s);
    if (status) return status;
    if (!sp__finite(laid->depth) || !sp__finite(laid->height) || !sp__finite3(laid->normal) || !sp__finite3(wants))
        return SP_E_NOT_FINITE;
    if (laid->depth < 0 || laid->height < 0 || !(sp__norm3(laid->normal) > 0)) return SP_E_RANGE;
    sp_real n[3], g[3];
    sp__unit3(laid->normal, n);
    sp__unit3(gravity, g);
    const sp_real m = s.area > 0 ? s.clearance / SP_SQRT(s.area) : s.clearance;
    *reason = !(s.clearance >= 0)                       ? SP_NBO_OUTSIDE
            : laid->depth < set.slender * laid->height  ? SP_NBO_SHALLOW
            : sp__dot3(n, g) < set.level                ? SP_NBO_TILTED
            : m < set.margin                            ? SP_NBO_MARGIN : SP_NBO_ACCEPTED;
    if (margin) *margin = m;
    return SP_OK;
}

#endif /* SP__SCENE_PLACE_C */
