/* mesh: volume and centroid of a mesh by tetrahedra from a point, 6V = sum a . (b x c); is it closed, does it face outwards?
 *                                                                                                          [seed 1.3] */
#ifndef SP__SCENE_MESH_C
#define SP__SCENE_MESH_C

#include "../geometry/local.c"

/* Every mesh is asked this, supports too: are its numbers finite, has each face three corners, does each corner exist? */
static sp_status sp__mesh_check(const sp_mesh *mesh, int32_t *corners)
{
    if (!mesh || mesh->vertices < 0 || mesh->faces < 0 || (mesh->vertices > 0 && !mesh->xyz)) return SP_E_ARGUMENT;
    if (mesh->faces > 0 && (!mesh->size || !mesh->corner)) return SP_E_ARGUMENT;
    if (!sp__all_finite(mesh->xyz, 3 * (size_t)mesh->vertices)) return SP_E_NOT_FINITE;
    int32_t sum = 0;
    for (int32_t k = 0; k < mesh->faces; k++) {
        if (mesh->size[k] < 3) return SP_E_DEGENERATE;
        if (mesh->size[k] > INT32_MAX - sum) return SP_E_ARGUMENT;
        sum += mesh->size[k];
    }
    for (int32_t k = 0; k < sum; k++)
        if (mesh->corner[k] < 0 || mesh->corner[k] >= mesh->vertices) return SP_E_INDEX;
    *corners = sum;
    return mesh->vertices > 0 ? SP_OK : SP_E_DEGENERATE;
}

/* Scrambles 64 bits one to one.                                                        [Stafford 2011, variant 13] */
static uint64_t sp__hash_mix(uint64_t h)
{
    h = (h ^ (h >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    h = (h ^ (h >> 27)) * UINT64_C(0x94d049bb133111eb);
    return h ^ (h >> 31);
}

/* A number for a place. Equal coordinates give equal numbers, -0 counts as 0; taken from values, so byte order is no matter. */
static uint64_t sp__place_hash(const sp_real x[3])
{
    uint64_t h = 0;
    for (int c = 0; c < 3; c++) {
        const sp_real v = x[c] + (sp_real)0;            /* -0 + 0 = +0 */
#ifdef SP_REAL_FLOAT
        uint32_t bits[1];
#elif defined SP_REAL_QUAD
        uint64_t bits[2];                               /* of most numbers one half is 0 */
#else
        uint64_t bits[1];
#endif
        memcpy(bits, &v, sizeof bits);
        for (size_t k = 0; k < sizeof bits / sizeof *bits; k++) h = sp__hash_mix(h + UINT64_C(0x9e3779b97f4a7c15) + bits[k]);
    }
    return h;
}

/* Closed: every directed edge p -> q has its opposite. Give each edge g(p, q) = -g(q, p) = F(p, q) - F(q, p) with a scrambling
 * F of the end points' places; then opposite edges cancel, and anything left over leaves a sum that is 0 by accident once in
 * 2^64. It needs no memory, one pass, and takes vertices of equal coordinates for the same without welding them. */
static int sp__mesh_closed(const sp_mesh *mesh)
{
    uint64_t sum = 0;
    const int32_t *corner = mesh->corner;
    for (int32_t k = 0; k < mesh->faces; corner += mesh->size[k++]) {
        uint64_t p = sp__place_hash(mesh->xyz + 3 * (size_t)corner[mesh->size[k] - 1]);
        for (int32_t i = 0; i < mesh->size[k]; i++) {
            const uint64_t q = sp__place_hash(mesh->xyz + 3 * (size_t)corner[i]);
            sum += sp__hash_mix(p + sp__hash_mix(q)) - sp__hash_mix(q + sp__hash_mix(p));
            p = q;
        }
    }
    return sum == 0;
}

/* Mean of points, local. */
static void sp__local_mean(const sp__local *l, const int32_t *pick, int32_t count, sp_real m[3])
{
    m[0] = m[1] = m[2] = 0;
    for (int32_t k = 0; k < count; k++) {
        sp_real p[3];
        sp__local_pick(l, pick, k, p);
        sp__add3(m, 1, p);
    }
    sp__scale3((sp_real)1 / (sp_real)count, m, m);
}

/* Farthest corner from the plane through m with normal n, times |n|; reach: the farthest from m. */
static sp_real sp__local_warp(const sp__local *l, const int32_t *pick, int32_t count, const sp_real m[3], const sp_real n[3],
                              sp_real *reach)
{
    sp_real most = 0, farthest = 0;
    for (int32_t k = 0; k < count; k++) {
        sp_real p[3];
        sp__local_pick(l, pick, k, p);
        sp__sub3(p, m, p);
        most = sp__max(most, sp__abs(sp__dot3(p, n)));
        farthest = sp__max(farthest, sp__dot3(p, p));
    }
    *reach = SP_SQRT(farthest);
    return most;
}

/* Sums over triangles, local: 6V in mass->volume, 24 V c in mass->centroid, 2A. n: twice the vector area of this face. */
typedef struct sp__solid { sp_mass *mass; sp_real area, n[3]; } sp__solid;

/* Triangle of m and the corners i, j. */
SP__NOINLINE static void sp__solid_triangle(sp__solid *t, const sp__local *l, const sp_real m[3], int32_t i, int32_t j)
{
    sp_real p[3], q[3], n[3] = { 0, 0, 0 };
    sp__local_get(l, i, p);
    sp__local_get(l, j, q);
    sp__cross3_add(p, q, n);
    const sp_real v = sp__dot3(m, n);                   /* m . (p x q) */
    t->mass->volume += v;
    sp__cross3_add(m, p, n);
    sp__cross3_add(q, m, n);                            /* m x p + p x q + q x m = (p - m) x (q - m) */
    sp__add3(p, 1, m);
    sp__add3(p, 1, q);
    sp__add3(t->mass->centroid, v, p);
    t->area += sp__norm3(n);
    sp__add3(t->n, 1, n);
}

/* A triangle as it is, a larger polygon fanned about its vertex mean m. Then each of its corners p has to be within 1e-2 of the
 * block's diameter from its plane. What rounding alone may do to (p - m) . n is allowed on top, so a face without area, which
 * has no plane, passes. */
SP__NOINLINE static sp_status sp__solid_face(sp__solid *t, const sp__local *l, const int32_t *corner, int32_t corners)
{
    sp_real m[3], reach;
    if (corners == 3) {
        sp__local_get(l, corner[0], m);
        sp__solid_triangle(t, l, m, corner[1], corner[2]);
        return SP_OK;
    }
    sp__local_mean(l, corner, corners, m);
    t->n[0] = t->n[1] = t->n[2] = 0;
    for (int32_t k = 0; k < corners; k++) sp__solid_triangle(t, l, m, corner[k > 0 ? k - 1 : corners - 1], corner[k]);
    const sp_real out = sp__local_warp(l, corner, corners, m, t->n, &reach);
    const sp_real noise = 16 * (sp_real)corners * (l->coarse + SP_EPSILON * l->d) * l->d * reach;
    return out > (sp_real)1e-2 * l->d * sp__norm3(t->n) + noise ? SP_E_WARPED : SP_OK;
}

/* Is 6V more than error? Coordinates good to e leave the volume of a surface A uncertain by e A, and rounding here acts as if
 * the corners had moved by u d; measured on flat bodies of all shapes and places: `least` / `sure` at most. So a body
 * that passes has its volume to a percent in double; float takes whatever it can tell from flat, plates of 1e-6 among it. */
static sp_status sp__solid_status(const sp__solid *t, const sp__local *l)
{
#ifdef SP_REAL_FLOAT
    const sp_real sure = (sp_real)1;
#else
    const sp_real sure = (sp_real)50;
#endif
    const sp_real least = 3 * sure * (l->coarse + SP_EPSILON * l->d) * t->area;
    if (t->mass->volume > least) return SP_OK;
    return t->mass->volume < -least ? SP_E_INWARD : SP_E_DEGENERATE;
}

/* Volume, centroid and size of a checked mesh. The diameter is set whenever it is a number. */
static sp_status sp__mesh_measure(const sp_mesh *mesh, int32_t corners, sp_mass *mass)
{
    sp__local l;
    sp__solid t = { mass, 0, { 0, 0, 0 } };
    const int32_t count = corners ? corners : mesh->vertices;
    if (sp__local_start(&l, mesh->xyz, corners ? mesh->corner : NULL, count)) return SP_E_NOT_FINITE;
    mass->volume = mass->centroid[0] = mass->centroid[1] = mass->centroid[2] = 0;
    mass->diameter = l.d * l.s;
    if (!sp__finite(mass->diameter * mass->diameter * mass->diameter)) return SP_E_NOT_FINITE;
    const int32_t *corner = mesh->corner;
    for (int32_t k = 0; k < mesh->faces; corner += mesh->size[k++]) {
        const sp_status status = sp__solid_face(&t, &l, corner, mesh->size[k]);
        if (status) return status;
    }
    if (!sp__mesh_closed(mesh)) return SP_E_OPEN;
    const sp_status status = sp__solid_status(&t, &l);
    if (status) return status;
    for (int c = 0; c < 3; c++) mass->centroid[c] = l.o[c] + l.s * (mass->centroid[c] / (4 * mass->volume));
    mass->volume = mass->volume / 6 * l.s * l.s * l.s;
    return mass->volume > 0 ? SP_OK : SP_E_DEGENERATE;  /* underflow */
}

SP_API sp_status sp_mesh_mass(const sp_mesh *mesh, sp_mass *mass)
{
    int32_t corners;
    sp_mass found;
    if (!mass) return SP_E_ARGUMENT;
    sp_status status = sp__mesh_check(mesh, &corners);
    if (!status) status = sp__mesh_measure(mesh, corners, &found);
    if (!status) *mass = found;
    return status;
}

/* A support need not enclose anything: then it has no mass and sits at its vertex mean. */
static sp_status sp__mesh_support(const sp_mesh *mesh, int32_t corners, sp_mass *mass)
{
    const sp_status status = sp__mesh_measure(mesh, corners, mass);
    if (status != SP_E_OPEN && status != SP_E_INWARD && status != SP_E_DEGENERATE) return status;
    sp__local l;
    if (sp__local_start(&l, mesh->xyz, NULL, mesh->vertices)) return SP_E_NOT_FINITE;
    sp__local_mean(&l, NULL, mesh->vertices, mass->centroid);
    for (int c = 0; c < 3; c++) mass->centroid[c] = l.o[c] + l.s * mass->centroid[c];
    mass->volume = 0;
    return SP_OK;
}

#endif /* SP__SCENE_MESH_C */
