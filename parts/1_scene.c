/* 1 ------------------------------------------------------------------------------------------------------------ numbers */

static sp_real sp__abs(sp_real x) { return x < 0 ? -x : x; }
static sp_real sp__max(sp_real x, sp_real y) { return x < y ? y : x; }

/* x - x is 0 for a number, NaN for an infinity or a NaN. */
static int sp__finite(sp_real x) { return x - x >= 0; }

static sp_real sp__dot3(const sp_real a[3], const sp_real b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/* |a|, also where its square would over- or underflow. */
static sp_real sp__norm3(const sp_real a[3])
{
#ifdef SP_REAL_FLOAT
    const sp_real low = (sp_real)1e-12, high = (sp_real)1e12;
#else
    const sp_real low = (sp_real)1e-140, high = (sp_real)1e140;
#endif
    const sp_real x = sp__abs(a[0]), y = sp__abs(a[1]), z = sp__abs(a[2]), m = sp__max(x, sp__max(y, z));
    if (m > low && m < high) return SP_SQRT(sp__dot3(a, a));
    if (!(m > 0) || !(m - m >= 0)) return m;
    const sp_real p = x / m, q = y / m, r = z / m;
    return m * SP_SQRT(p * p + q * q + r * r);
}

static int sp__finite3(const sp_real a[3]) { return sp__finite(a[0]) && sp__finite(a[1]) && sp__finite(a[2]); }

/* c = a - b, c = s a, c = a x b; c may be a, in the first two also b. */
static void sp__sub3(const sp_real a[3], const sp_real b[3], sp_real c[3])
{
    for (int k = 0; k < 3; k++) c[k] = a[k] - b[k];
}

static void sp__scale3(sp_real s, const sp_real a[3], sp_real c[3])
{
    for (int k = 0; k < 3; k++) c[k] = s * a[k];
}

static void sp__cross3(const sp_real a[3], const sp_real b[3], sp_real c[3])
{
    const sp_real x = a[1] * b[2] - a[2] * b[1], y = a[2] * b[0] - a[0] * b[2], z = a[0] * b[1] - a[1] * b[0];
    c[0] = x; c[1] = y; c[2] = z;
}

/* a b and what rounding took from it; exact for |a|, |b| far from over- and underflow.                  [Dekker 1971] */
static sp_real sp__product(sp_real a, sp_real b, sp_real *rest)
{
#ifdef SP_REAL_FLOAT
    const sp_real half = (sp_real)4097;                 /* 2^12 + 1: cuts 24 bits into 12 + 12 */
#else
    const sp_real half = (sp_real)134217729;            /* 2^27 + 1: cuts 53 bits into 26 + 26 and a sign */
#endif
    const sp_real ca = half * a, ah = ca - (ca - a), al = a - ah;
    const sp_real cb = half * b, bh = cb - (cb - b), bl = b - bh;
    const sp_real p = a * b;
    *rest = ((ah * bh - p) + ah * bl + al * bh) + al * bl;
    return p;
}

/* a d - b c, right to an ulp or two: the cross product of two long vectors that are nearly parallel (slivers) keeps its
 * direction, so errors in volume and area go with the body's surface and not with the square of its length. */
static sp_real sp__minor(sp_real a, sp_real b, sp_real c, sp_real d)
{
    sp_real e, f;
    const sp_real p = sp__product(a, d, &e), q = sp__product(b, c, &f);
    return (p - q) + (e - f);
}

/* c += a x b, each component by sp__minor. */
static void sp__cross3_add(const sp_real a[3], const sp_real b[3], sp_real c[3])
{
    c[0] += sp__minor(a[1], a[2], b[1], b[2]);
    c[1] += sp__minor(a[2], a[0], b[2], b[0]);
    c[2] += sp__minor(a[0], a[1], b[0], b[1]);
}

/* b = a / |a|, b may be a; divided, not multiplied by 1 / |a|: what lies along an axis becomes exactly 0 and +-1. */
static void sp__unit3(const sp_real a[3], sp_real b[3])
{
    const sp_real length = sp__norm3(a);
    for (int k = 0; k < 3; k++) b[k] = a[k] / length;
}

/* Unit vector across n (unit): the world axis least aligned with n, the first of equals, made orthogonal to it. */
static void sp__across3(const sp_real n[3], sp_real t[3])
{
    int k = 0;
    if (sp__abs(n[1]) < sp__abs(n[k])) k = 1;
    if (sp__abs(n[2]) < sp__abs(n[k])) k = 2;
    sp__scale3(-n[k], n, t);
    t[k] += (sp_real)1;
    sp__unit3(t, t);
}

/* 2 -------------------------------------------------------------------------------------------------------------- words */

/* The k-th of zero-terminated words that follow each other: no table of pointers, so nothing to relocate. */
static const char *sp__word(const char *words, int k)
{
    for (; k > 0; k--) {
        while (*words) words++;
        words++;
    }
    return words;
}

/* In the order of the enumerators of stonepack.h. */
SP_API const char *sp_status_text(sp_status status)
{
    const int k = -(int)status;
    return sp__word("no error\0"
                    "bad argument: a null pointer, a negative count or an unknown choice\0"
                    "not enough memory in the arena\0"
                    "the scene is full\0"
                    "a number is infinite, not a number, or too large to be squared\0"
                    "a block, vertex or interface of that number does not exist\0"
                    "a number is outside its range\0"
                    "the mesh is open: an edge lacks its opposite\0"
                    "the mesh is inside out: its faces look inward\0"
                    "the mesh encloses no volume, or a face has fewer than three corners\0"
                    "a face is out of plane\0"
                    "the interface polygon is out of plane\0"
                    "the interface has no area, or its normal no length\0"
                    "an interface between a block and itself\0"
                    "the scene has no block\0"
                    "cohesion, tension and crushing of joints are not supported yet\0"
                    "unknown status", k >= 0 && k <= 15 ? k : 16);
}

SP_API const char *sp_verdict_text(sp_verdict verdict)
{
    const int k = (int)verdict;
    return sp__word("undecided\0" "stable\0" "unstable\0" "unknown", k >= 0 && k <= 2 ? k : 3);
}

SP_API const char *sp_level_text(sp_level level)
{
    const int k = (int)level;
    return sp__word("none\0" "admissible\0" "coupled\0" "unknown", k >= 0 && k <= 2 ? k : 3);
}

SP_API const char *sp_reason_text(sp_reason reason)
{
    const int k = (int)reason;
    return sp__word("forces\0" "nothing to carry\0" "no contact\0" "no support\0" "mechanism\0" "limit\0" "budget\0" "stages\0"
                    "unknown", k >= 0 && k <= 7 ? k : 8);
}

SP_API const char *sp_stage_text(sp_stage_id stage)
{
    const int k = (int)stage;
    return sp__word("none\0" "gates\0" "least squares\0" "dense\0" "polish\0" "exact\0" "custom\0" "unknown",
                    k >= 0 && k <= 6 ? k : 7);
}

/* 3 -------------------------------------------------------------------------------------------------------- scene, empty */

static void sp__scene_carve(sp_scene *scene, sp_arena *a)
{
    const sp_capacity *c = &scene->cap;
    scene->block = sp__take(a, (size_t)c->blocks, sizeof *scene->block);
    scene->vertex = sp__take(a, (size_t)c->vertices, sizeof *scene->vertex);
    scene->face = sp__take(a, (size_t)c->faces, sizeof *scene->face);
    scene->corner = sp__take(a, (size_t)c->corners, sizeof *scene->corner);
    scene->interface = sp__take(a, (size_t)c->interfaces, sizeof *scene->interface);
    scene->point = sp__take(a, (size_t)c->points, sizeof *scene->point);
}

static int sp__capacity_valid(const sp_capacity *c)
{
    return c && c->blocks >= 0 && c->vertices >= 0 && c->faces >= 0 && c->corners >= 0 && c->interfaces >= 0 && c->points >= 0;
}

SP_API size_t sp_scene_memory(const sp_capacity *cap)
{
    if (!sp__capacity_valid(cap)) return 0;
    sp_scene scene;
    sp_arena dry = sp__arena_dry();
    scene.cap = *cap;
    sp__scene_carve(&scene, &dry);
    return sp__failed(&dry) ? 0 : dry.used;
}

SP_API sp_status sp_scene_create(sp_scene *scene, const sp_capacity *cap, sp_arena *arena)
{
    if (!scene || !sp__capacity_valid(cap) || !arena || !arena->base) return SP_E_ARGUMENT;
    sp_arena a = *arena;
    sp_scene s;
    memset(&s, 0, sizeof s);
    s.gravity[2] = (sp_real)-9.80665;
    s.cap = *cap;
    sp__scene_carve(&s, &a);
    if (sp__failed(&a)) return SP_E_MEMORY;
    *arena = a;
    *scene = s;
    return SP_OK;
}

/* 4 --------------------------------------------------------------------------------------------------- local coordinates */

/* Points seen from the first of them, in units of a power of two: far or odd-sized coordinates lose nothing, and squares and
 * cubes of what is left can neither over- nor underflow. */
typedef struct sp__local {
    const sp_real *xyz;
    sp_real o[3], s;            /* origin and unit [m] */
    sp_real d;                  /* diagonal of the bounding box, 1 .. 2 sqrt(3), or 0                     [s] */
    sp_real coarse;             /* u (largest |coordinate|): what the coordinates themselves are good for [s] */
} sp__local;

static void sp__local_get(const sp__local *l, int32_t k, sp_real p[3])
{
    for (int c = 0; c < 3; c++) p[c] = (l->xyz[3 * (size_t)k + (size_t)c] - l->o[c]) / l->s;
}

/* Largest power of two not above x, x finite and > 0. */
static sp_real sp__power_of_two(sp_real x)
{
    sp_real s = (sp_real)1;
    while (s <= x / 2) s *= 2;
    while (s > x) s /= 2;
    return s;
}

/* Of the `count` >= 1 points pick[0], pick[1] ... (pick NULL: 0, 1 ...). SP_E_NOT_FINITE: they are too far apart. */
static sp_status sp__local_start(sp__local *l, const sp_real *xyz, const int32_t *pick, int32_t count)
{
    sp_real extent[3], far = 0;
    l->xyz = xyz;
    l->s = (sp_real)1;
    for (int c = 0; c < 3; c++) {
        sp_real lo = xyz[3 * (size_t)(pick ? pick[0] : 0) + (size_t)c], hi = lo;
        l->o[c] = lo;
        for (int32_t k = 1; k < count; k++) {
            const sp_real x = xyz[3 * (size_t)(pick ? pick[k] : k) + (size_t)c];
            if (x < lo) lo = x;
            if (x > hi) hi = x;
        }
        extent[c] = hi - lo;
        far = sp__max(far, sp__max(sp__abs(lo), sp__abs(hi)));
    }
    const sp_real most = sp__max(extent[0], sp__max(extent[1], extent[2]));
    if (!sp__finite(2 * most)) return SP_E_NOT_FINITE;
    if (most > 0) l->s = sp__power_of_two(most);
    for (int c = 0; c < 3; c++) extent[c] /= l->s;
    l->d = sp__norm3(extent);
    l->coarse = SP_EPSILON * (far / l->s);
    return SP_OK;
}

/* 5 ------------------------------------------------------------------------------------------------------- mesh and mass */

static sp_status sp__finite_points(const sp_real *xyz, int32_t points)
{
    for (size_t k = 0; k < 3 * (size_t)points; k++)
        if (!sp__finite(xyz[k])) return SP_E_NOT_FINITE;
    return SP_OK;
}

/* What is asked of every mesh, supports too: numbers are numbers, faces have corners, corners exist. */
static sp_status sp__mesh_check(const sp_mesh *mesh, int32_t *corners)
{
    if (!mesh || mesh->vertices < 0 || mesh->faces < 0 || (mesh->vertices > 0 && !mesh->xyz)) return SP_E_ARGUMENT;
    if (mesh->faces > 0 && (!mesh->size || !mesh->corner)) return SP_E_ARGUMENT;
    if (sp__finite_points(mesh->xyz, mesh->vertices)) return SP_E_NOT_FINITE;
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
static uint64_t sp__mix(uint64_t h)
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
        uint32_t bits;
#else
        uint64_t bits;
#endif
        memcpy(&bits, &v, sizeof bits);
        h = sp__mix(h + UINT64_C(0x9e3779b97f4a7c15) + bits);
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
            sum += sp__mix(p + sp__mix(q)) - sp__mix(q + sp__mix(p));
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
        sp__local_get(l, pick ? pick[k] : k, p);
        for (int c = 0; c < 3; c++) m[c] += p[c];
    }
    sp__scale3((sp_real)1 / (sp_real)count, m, m);
}

/* Farthest corner from the plane through m with normal n, times |n|; reach: the farthest from m. */
static sp_real sp__local_warp(const sp__local *l, const int32_t *pick, int32_t count, const sp_real m[3], const sp_real n[3],
                              sp_real *reach)
{
    sp_real most = 0, far = 0;
    for (int32_t k = 0; k < count; k++) {
        sp_real p[3];
        sp__local_get(l, pick ? pick[k] : k, p);
        sp__sub3(p, m, p);
        most = sp__max(most, sp__abs(sp__dot3(p, n)));
        far = sp__max(far, sp__dot3(p, p));
    }
    *reach = SP_SQRT(far);
    return most;
}

/* Sums over triangles, local: 6V in mass->volume, 24 V c in mass->centroid, 2A; n: twice the vector area of the running face. */
typedef struct sp__solid { sp_mass *mass; sp_real area, n[3]; } sp__solid;

/* Triangle of m and the corners i, j. */
static void sp__solid_triangle(sp__solid *t, const sp__local *l, const sp_real m[3], int32_t i, int32_t j)
{
    sp_real p[3], q[3], n[3] = { 0, 0, 0 };
    sp__local_get(l, i, p);
    sp__local_get(l, j, q);
    sp__cross3_add(p, q, n);
    const sp_real v = sp__dot3(m, n);                   /* m . (p x q) */
    t->mass->volume += v;
    for (int k = 0; k < 3; k++) t->mass->centroid[k] += v * (m[k] + p[k] + q[k]);
    sp__cross3_add(m, p, n);
    sp__cross3_add(q, m, n);                            /* m x p + p x q + q x m = (p - m) x (q - m) */
    t->area += sp__norm3(n);
    for (int k = 0; k < 3; k++) t->n[k] += n[k];
}

/* A triangle as it is, a larger polygon fanned about its vertex mean m. Then each of its corners p has to be within 1e-2 of the
 * block's diameter from its plane. What rounding alone may do to (p - m) . n is allowed on top, so a face without area, which
 * has no plane, passes. */
static sp_status sp__solid_face(sp__solid *t, const sp__local *l, const int32_t *corner, int32_t corners)
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
 * that passes has its volume to a percent in double; float takes what can be told from flat at all, plates of 1e-6 among it. */
static sp_status sp__solid_judge(const sp__solid *t, const sp__local *l)
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
    if (sp__local_start(&l, mesh->xyz, corners ? mesh->corner : NULL, corners ? corners : mesh->vertices)) return SP_E_NOT_FINITE;
    mass->volume = mass->centroid[0] = mass->centroid[1] = mass->centroid[2] = 0;
    mass->diameter = l.d * l.s;
    if (!sp__finite(mass->diameter * mass->diameter * mass->diameter)) return SP_E_NOT_FINITE;
    const int32_t *corner = mesh->corner;
    for (int32_t k = 0; k < mesh->faces; corner += mesh->size[k++]) {
        const sp_status status = sp__solid_face(&t, &l, corner, mesh->size[k]);
        if (status) return status;
    }
    if (!sp__mesh_closed(mesh)) return SP_E_OPEN;
    const sp_status status = sp__solid_judge(&t, &l);
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

/* 6 ------------------------------------------------------------------------------------------------------- scene, blocks */

/* Copy a mesh into the scene; room was checked. */
static void sp__scene_copy(sp_scene *scene, const sp_mesh *mesh, int32_t corners)
{
    sp_capacity *n = &scene->count;
    if (mesh->vertices) memcpy(scene->vertex + n->vertices, mesh->xyz, (size_t)mesh->vertices * sizeof *scene->vertex);
    for (int32_t k = 0; k < corners; k++) scene->corner[n->corners + k] = n->vertices + mesh->corner[k];
    for (int32_t k = 0; k < mesh->faces; k++) {
        scene->face[n->faces + k].corner = n->corners;
        scene->face[n->faces + k].corners = mesh->size[k];
        n->corners += mesh->size[k];
    }
    n->vertices += mesh->vertices;
    n->faces += mesh->faces;
}

static int sp__scene_room(const sp_scene *scene, const sp_mesh *mesh, int32_t corners)
{
    const sp_capacity *cap = &scene->cap, *n = &scene->count;
    return n->blocks < cap->blocks && mesh->vertices <= cap->vertices - n->vertices
        && mesh->faces <= cap->faces - n->faces && corners <= cap->corners - n->corners;
}

SP_API sp_status sp_scene_block(sp_scene *scene, const sp_mesh *mesh, sp_real density, uint32_t fixed, int32_t *id)
{
    int32_t corners;
    sp_mass m;
    if (!scene) return SP_E_ARGUMENT;
    sp_status status = sp__mesh_check(mesh, &corners);
    if (status) return status;
    if (!sp__finite(density)) return SP_E_NOT_FINITE;
    if (!(density > 0) || fixed > SP_FIXED) return SP_E_RANGE;
    status = fixed == SP_FIXED ? sp__mesh_support(mesh, corners, &m) : sp__mesh_measure(mesh, corners, &m);
    if (status) return status;
    const sp_real mass = density * m.volume;
    if (!sp__finite(mass)) return SP_E_NOT_FINITE;
    if (!(mass > 0) && fixed != SP_FIXED) return SP_E_DEGENERATE;       /* underflow */
    if (!sp__scene_room(scene, mesh, corners)) return SP_E_CAPACITY;
    const sp_capacity n = scene->count;
    const sp_block block = { mass, { m.centroid[0], m.centroid[1], m.centroid[2] }, density, m.volume, m.diameter, fixed,
                             n.vertices, mesh->vertices, n.faces, mesh->faces };
    scene->block[n.blocks] = block;
    sp__scene_copy(scene, mesh, corners);
    if (id) *id = n.blocks;
    scene->count.blocks++;
    return SP_OK;
}

SP_API sp_status sp_scene_body(sp_scene *scene, sp_real mass, const sp_real centroid[3], uint32_t fixed, int32_t *id)
{
    if (!scene || !centroid) return SP_E_ARGUMENT;
    if (!sp__finite(mass) || !sp__finite3(centroid)) return SP_E_NOT_FINITE;
    if (mass < 0 || (!(mass > 0) && fixed != SP_FIXED) || fixed > SP_FIXED) return SP_E_RANGE;
    const sp_capacity n = scene->count;
    if (n.blocks >= scene->cap.blocks) return SP_E_CAPACITY;
    const sp_block block = { mass, { centroid[0], centroid[1], centroid[2] }, 0, 0, 0, fixed, n.vertices, 0, n.faces, 0 };
    scene->block[n.blocks] = block;
    if (id) *id = n.blocks;
    scene->count.blocks++;
    return SP_OK;
}

/* 7 --------------------------------------------------------------------------------------------------- scene, interfaces */

SP_API sp_joint sp_joint_friction(sp_real mu)
{
    const sp_joint joint = { mu, 0, 0, 0 };
    return joint;
}

static sp_status sp__joint_check(const sp_joint *joint)
{
    const sp_real rest[3] = { joint->cohesion, joint->tension, joint->cap };
    if (!sp__finite(joint->mu) || !sp__finite3(rest)) return SP_E_NOT_FINITE;
    if (joint->mu < 0) return SP_E_RANGE;
    return sp__abs(rest[0]) + sp__abs(rest[1]) + sp__abs(rest[2]) > 0 ? SP_E_UNSUPPORTED : SP_OK;
}

/* Twice the vector area of a polygon, sum p x q over its edges, and its perimeter; local.           [Newell's normal] */
static sp_real sp__polygon_normal(const sp__local *l, int32_t points, sp_real n[3])
{
    sp_real p[3], q[3], perimeter = 0;
    n[0] = n[1] = n[2] = 0;
    sp__local_get(l, points - 1, p);
    for (int32_t k = 0; k < points; k++) {
        sp__local_get(l, k, q);
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
        for (int c = 0; c < 3; c++) { t[c] -= out * n[c]; p[c] = q[c]; }
        const sp_real in = sp__norm3(t);
        if (length > (sp_real)1e-9 * perimeter && in > length / 2) {
            sp__unit3(t, t);
            return;
        }
    }
    sp__across3(n, t);
}

/* Normal, tangents and area of a contact polygon; plane to 1e-6 of its diameter and what its coordinates are good for. */
static sp_status sp__polygon_frame(int32_t points, const sp_real *xyz, sp_interface *f)
{
    sp__local l;
    sp_real m[3], reach;
    if (sp__local_start(&l, xyz, NULL, points)) return SP_E_NOT_FINITE;
    const sp_real perimeter = sp__polygon_normal(&l, points, f->n), twice = sp__norm3(f->n);
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

/* The same for points that share a given normal of any length. */
static sp_status sp__points_frame(const sp_real n[3], sp_interface *f)
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

/* What polygons and points have in common. The new interface is made in the scene's next free place, which is nobody's until
 * sp__interface_add counts it. */
static sp_status sp__interface_start(sp_scene *scene, int32_t a, int32_t b, int32_t points, const sp_real *xyz,
                                     const sp_joint *joint)
{
    if (!scene || !xyz || !joint || points < 0) return SP_E_ARGUMENT;
    if (a < 0 || b < 0 || a >= scene->count.blocks || b >= scene->count.blocks) return SP_E_INDEX;
    if (a == b) return SP_E_SELF;
    sp_status status = sp__joint_check(joint);
    if (!status) status = sp__finite_points(xyz, points);
    if (status) return status;
    const sp_capacity *n = &scene->count;
    if (n->interfaces >= scene->cap.interfaces || points > scene->cap.points - n->points) return SP_E_CAPACITY;
    sp_interface *f = &scene->interface[n->interfaces];
    f->a = a; f->b = b;
    f->point = n->points;
    f->points = points;
    f->joint = *joint;
    return SP_OK;
}

static void sp__interface_add(sp_scene *scene, int32_t points, const sp_real *xyz, int32_t *id)
{
    memcpy(scene->point + scene->count.points, xyz, (size_t)points * sizeof *scene->point);
    if (id) *id = scene->count.interfaces;
    scene->count.interfaces++;
    scene->count.points += points;
}

SP_API sp_status sp_scene_interface(sp_scene *scene, int32_t a, int32_t b, int32_t points, const sp_real *xyz,
                                    const sp_joint *joint, int32_t *id)
{
    sp_status status = sp__interface_start(scene, a, b, points, xyz, joint);
    if (!status) status = points < 3 ? SP_E_AREA : sp__polygon_frame(points, xyz, &scene->interface[scene->count.interfaces]);
    if (!status) sp__interface_add(scene, points, xyz, id);
    return status;
}

SP_API sp_status sp_scene_points(sp_scene *scene, int32_t a, int32_t b, const sp_real n[3], int32_t points,
                                 const sp_real *xyz, const sp_joint *joint, int32_t *id)
{
    if (!n) return SP_E_ARGUMENT;
    sp_status status = sp__interface_start(scene, a, b, points, xyz, joint);
    if (!status) status = points < 1 ? SP_E_RANGE : sp__points_frame(n, &scene->interface[scene->count.interfaces]);
    if (!status) sp__interface_add(scene, points, xyz, id);
    return status;
}

SP_API sp_status sp_scene_friction(sp_scene *scene, sp_real mu)
{
    if (!scene) return SP_E_ARGUMENT;
    if (!sp__finite(mu)) return SP_E_NOT_FINITE;
    if (mu < 0) return SP_E_RANGE;
    for (int32_t k = 0; k < scene->count.interfaces; k++) scene->interface[k].joint.mu = mu;
    return SP_OK;
}
