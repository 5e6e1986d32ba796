/* joint: joints and loads into a scene: frame, flatness, area and strength of a joint; forces, couples, weights, pressures.
 *
 *   (n, t1, t2): n from the area vector sum p x q / 2, t1 along the first edge made orthogonal to n, t2 = n x t1   [Newell]
 *   |ft| <= C + mu fn,  -T <= fn <= N per vertex [N], C T N: stresses times area / vertices               [Mohr, Coulomb]
 */
#ifndef SP__SCENE_JOINT_C
#define SP__SCENE_JOINT_C

#include "mesh.c"

SP_API sp_strength sp_strength_friction(sp_real mu)
{
    const sp_strength strength = { mu, 0, 0, 0 };
    return strength;
}

static sp_status sp__strength_check(const sp_strength *strength)
{
    const sp_real rest[3] = { strength->cohesion, strength->tension, strength->crushing };
    if (!sp__finite(strength->mu) || !sp__finite3(rest)) return SP_E_NOT_FINITE;
    return strength->mu >= 0 && rest[0] >= 0 && rest[1] >= 0 && rest[2] >= 0 ? SP_OK : SP_E_RANGE;
}

/* Has a joint strength beyond friction, or less than any? */
SP__NOINLINE_SMALL static int sp__strength_beyond_friction(const sp_strength *strength)
{
    return strength->cohesion > 0 || strength->tension > 0 || strength->crushing > 0;
}

static int sp__scene_strong(const sp_scene *scene)
{
    for (int32_t k = 0; k < scene->count.joints; k++) if (sp__strength_beyond_friction(&scene->joint[k].strength)) return 1;
    return 0;
}

/* Limits of the force at one vertex of a joint [N]: its strength [Pa] times its share of the area, the same for every vertex.
 *   |ft| <= C + mu fn,  -T <= fn <= N,  T <= C / mu                                                       [Mohr, Coulomb]
 * ignore_strength: only friction is kept, as if the joint had no area: forces that may grow without end. */
typedef struct sp__vertex_limits { sp_real C, T, N; } sp__vertex_limits;

static sp__vertex_limits sp__vertex_strength(const sp_joint *f, int ignore_strength)
{
    const sp_real share = ignore_strength ? 0 : f->area / (sp_real)f->points;
    sp__vertex_limits k = { f->strength.cohesion * share, f->strength.tension * share,
                            f->strength.crushing > 0 ? f->strength.crushing * share : SP__HUGE };
    if (k.T * f->strength.mu > k.C) k.T = k.C / f->strength.mu;
    return k;
}

/* Is K_v of a contact more or less than a cone? */
static int sp__contact_strong(const sp_problem *pb, const sp_contact *t)
{
    return pb->ignore_strength ? t->joint->strength.crushing > 0 : sp__strength_beyond_friction(&t->joint->strength);
}

/* Twice the vector area of a polygon, sum p x q over its edges, and its perimeter; local.           [Newell's normal] */
static sp_real sp__polygon_normal(const sp__local *l, const int32_t *pick, int32_t points, sp_real n[3])
{
    sp_real p[3], q[3], perimeter = 0;
    n[0] = n[1] = n[2] = 0;
    sp__local_pick(l, pick, points - 1, p);
    for (int32_t k = 0; k < points; k++) {
        sp__local_pick(l, pick, k, q);
        sp__cross3_add(p, q, n);
        sp__sub3(q, p, p);
        perimeter += sp__norm3(p);
        for (int c = 0; c < 3; c++) p[c] = q[c];
    }
    return perimeter;
}

/* t1 along the first edge longer than 1e-9 of the perimeter, made orthogonal to n (unit); an edge that stands across the plane
 * by more than it lies in it (it can be that short) is passed over. */
static void sp__polygon_tangent(const sp__local *l, int32_t points, sp_real perimeter, const sp_real n[3], sp_real t[3])
{
    sp_real p[3], q[3];
    sp__local_get(l, 0, p);
    for (int32_t k = 1; k <= points; k++) {
        sp__local_get(l, k < points ? k : 0, q);
        sp__sub3(q, p, t);
        const sp_real length = sp__norm3(t), out = sp__dot3(t, n);
        sp__add3(t, -out, n);
        memcpy(p, q, sizeof p);
        const sp_real in = sp__norm3(t);
        if (length > (sp_real)1e-9 * perimeter && in > length / 2) {
            sp__unit3(t, t);
            return;
        }
    }
    sp__across3(n, t);
}

/* Normal, tangents and area of a contact polygon; plane to 1e-6 of its diameter and what its coordinates are good for. */
static sp_status sp__polygon_frame(int32_t points, const sp_real *xyz, sp_joint *f)
{
    sp__local l;
    sp_real m[3], reach;
    if (sp__local_start(&l, xyz, NULL, points)) return SP_E_NOT_FINITE;
    const sp_real perimeter = sp__polygon_normal(&l, NULL, points, f->n), twice = sp__norm3(f->n);
    const sp_real noise = 4 * (l.coarse + SP_EPSILON * l.d);
    if (!(twice > noise * perimeter)) return SP_E_AREA;
    f->area = twice / 2 * l.s * l.s;
    if (!sp__finite(f->area)) return SP_E_NOT_FINITE;
    if (!(f->area > 0)) return SP_E_AREA;               /* underflow */
    sp__unit3(f->n, f->n);
    sp__local_mean(&l, NULL, points, m);
    if (sp__local_warp(&l, NULL, points, m, f->n, &reach) > (sp_real)1e-6 * l.d + noise) return SP_E_PLANE;
    sp__polygon_tangent(&l, points, perimeter, f->n, f->t1);
    sp__cross3(f->n, f->t1, f->t2);
    return SP_OK;
}

/* Frame of points that share a given normal, which may have any length. */
static sp_status sp__points_frame(const sp_real n[3], sp_joint *f)
{
    const sp_real most = sp__max(sp__abs(n[0]), sp__max(sp__abs(n[1]), sp__abs(n[2])));
    if (!sp__finite3(n)) return SP_E_NOT_FINITE;
    if (!(most > 0)) return SP_E_AREA;
    const sp_real s = sp__power_of_two(most);
    for (int c = 0; c < 3; c++) f->n[c] = n[c] / s;
    sp__unit3(f->n, f->n);
    sp__across3(f->n, f->t1);
    sp__cross3(f->n, f->t1, f->t2);
    f->area = 0;
    return SP_OK;
}

/* The part that polygons and points share. The new joint is made in the scene's next free place, which belongs to nobody until
 * sp__joint_add counts it. */
static sp_status sp__joint_start(sp_scene *scene, int32_t a, int32_t b, int32_t points, const sp_real *xyz,
                                     const sp_strength *strength)
{
    if (!scene || !xyz || !strength || points < 0) return SP_E_ARGUMENT;
    if (a < 0 || b < 0 || a >= scene->count.blocks || b >= scene->count.blocks) return SP_E_INDEX;
    if (a == b) return SP_E_SELF;
    const sp_status status = sp__strength_check(strength);
    if (status) return status;
    if (!sp__all_finite(xyz, 3 * (size_t)points)) return SP_E_NOT_FINITE;
    const sp_capacity *n = &scene->count;
    if (n->joints >= scene->capacity.joints || points > scene->capacity.points - n->points) return SP_E_CAPACITY;
    sp_joint *f = &scene->joint[n->joints];
    f->a = a; f->b = b;
    f->point = n->points;
    f->points = points;
    f->strength = *strength;
    return SP_OK;
}

/* The joint written at the end of the list, and its vertices, count from now on. */
static void sp__joint_add(sp_scene *scene, int32_t points, const sp_real *xyz, int32_t *id)
{
    memcpy(scene->point + scene->count.points, xyz, (size_t)points * sizeof *scene->point);
    if (id) *id = scene->count.joints;
    scene->count.joints++;
    scene->count.points += points;
}

SP_API sp_status sp_scene_joint(sp_scene *scene, int32_t a, int32_t b, int32_t points, const sp_real *xyz,
                                    const sp_strength *strength, int32_t *id)
{
    sp_status status = sp__joint_start(scene, a, b, points, xyz, strength);
    if (!status) status = points < 3 ? SP_E_AREA : sp__polygon_frame(points, xyz, &scene->joint[scene->count.joints]);
    if (!status) sp__joint_add(scene, points, xyz, id);
    return status;
}

SP_API sp_status sp_scene_points(sp_scene *scene, int32_t a, int32_t b, const sp_real n[3], int32_t points,
                                 const sp_real *xyz, const sp_strength *strength, int32_t *id)
{
    if (!n) return SP_E_ARGUMENT;
    sp_status status = sp__joint_start(scene, a, b, points, xyz, strength);
    if (!status) status = points < 1 ? SP_E_RANGE : sp__points_frame(n, &scene->joint[scene->count.joints]);
    if (!status && sp__strength_beyond_friction(strength)) status = SP_E_AREA; /* strength is per area */
    if (!status) sp__joint_add(scene, points, xyz, id);
    return status;
}

SP_API sp_status sp_scene_friction(sp_scene *scene, sp_real mu)
{
    if (!scene) return SP_E_ARGUMENT;
    if (!sp__finite(mu)) return SP_E_NOT_FINITE;
    if (mu < 0) return SP_E_RANGE;
    for (int32_t k = 0; k < scene->count.joints; k++) scene->joint[k].strength.mu = mu;
    return SP_OK;
}

SP_API sp_status sp_scene_load(sp_scene *scene, const sp_load *load, int32_t *id)
{
    if (!scene || !load) return SP_E_ARGUMENT;
    if (load->block < 0 || load->block >= scene->count.blocks) return SP_E_INDEX;
    if (!sp__finite3(load->point) || !sp__finite3(load->force) || !sp__finite3(load->couple) || !sp__finite(load->mass))
        return SP_E_NOT_FINITE;
    if (load->mass < 0) return SP_E_RANGE;
    if (scene->count.loads == scene->capacity.loads) return SP_E_CAPACITY;
    if (id) *id = scene->count.loads;
    scene->load[scene->count.loads++] = *load;
    return SP_OK;
}

/* Area vector of a face and its centroid seen from its first corner o, both by triangles (o, b, c) of area vector t:
 *   sum t,  sum (t . n)(b + c) / (3 sum t . n)                                                      returns 0: no area */
static int sp__face_area(const sp_scene *scene, const sp_face *face, sp_real area[3], sp_real centroid[3])
{
    const int32_t *corner = scene->corner + face->corner;
    const sp_real *o = scene->vertex[corner[0]];
    sp_real sum = 0, unit = 1;                          /* |area|: products of four lengths underflow */
    for (int q = 0; q < 3; q++) area[q] = centroid[q] = 0;
    for (int pass = 0; pass < 2; pass++) {
        if (pass) unit = sp__norm3(area);
        for (int32_t k = 1; k + 1 < face->corners; k++) {
            sp_real b[3], c[3], t[3];
            sp__sub3(scene->vertex[corner[k]], o, b);
            sp__sub3(scene->vertex[corner[k + 1]], o, c);
            sp__cross3(b, c, t);
            sp__add3(b, 1, c);
            if (!pass) { sp__add3(area, (sp_real)0.5, t); continue; }
            sp__scale3(1 / unit, t, t);
            const sp_real weight = sp__dot3(t, area);
            sp__add3(centroid, weight, b);
            sum += weight;
        }
    }
    for (int q = 0; q < 3; q++) centroid[q] = o[q] + centroid[q] / ((sp_real)3 * sum);
    return sum > 0 && sp__finite3(centroid);
}

SP_API sp_status sp_scene_pressure(sp_scene *scene, int32_t block, int32_t face, sp_real pressure, int32_t live, int32_t *id)
{
    if (!scene) return SP_E_ARGUMENT;
    if (block < 0 || block >= scene->count.blocks || face < 0 || face >= scene->block[block].faces) return SP_E_INDEX;
    sp_load load;
    sp_real area[3];
    memset(&load, 0, sizeof load);
    load.block = block;
    load.live = live;
    if (!sp__face_area(scene, &scene->face[scene->block[block].face + face], area, load.point)) return SP_E_AREA;
    sp__scale3(-pressure, area, load.force);
    return sp_scene_load(scene, &load, id);
}

#endif /* SP__SCENE_JOINT_C */
