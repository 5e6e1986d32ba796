/* matrix: Aeq and Afr by entries for other solvers: columns [ s e ; s r x e ] of a force s e at arm r from the centroid, and
 * rows cos_k ft1 + sin_k ft2 - mu_eff fn of the friction pyramid.                                       [seed 1.1, 1.2, 1.4] */
#ifndef SP__SCENE_MATRIX_C
#define SP__SCENE_MATRIX_C

#include "../cone/pyramids.c"
#include "joint.c"

static void sp__triplets_carve(sp_triplets *t, int32_t count, sp_arena *a)
{
    t->i = sp__take(a, (size_t)count, sizeof *t->i);
    t->j = sp__take(a, (size_t)count, sizeof *t->j);
    t->x = sp__take(a, (size_t)count, sizeof *t->x);
}

/* An entry, unless it is 0; without room (x NULL) it is only counted, without j its column is known from the order. */
static void sp__triplets_put(sp_triplets *t, int32_t i, int32_t j, sp_real x)
{
    if (!(sp__abs(x) > 0)) return;
    if (t->j) t->j[t->count] = j;
    if (t->x) { t->i[t->count] = i; t->x[t->count] = x; }
    t->count++;
}

/* The column of force s e at arm r on the rows of one block:  [ s e ; s r x e ]. */
static void sp__aeq_column(sp_triplets *t, int32_t row, int32_t column, sp_real s, const sp_real r[3], const sp_real e[3])
{
    sp_real x[6];
    sp__scale3(s, e, x);
    sp__cross3(r, x, x + 3);
    for (int32_t c = 0; c < 6; c++) sp__triplets_put(t, 6 * row + c, column, x[c]);
}

/* Column c of one contact vertex, rows ascending: f on B with arm r - c_B, -f on A with arm r - c_A. */
static void sp__aeq_vertex(sp_triplets *t, const sp_problem *problem, const sp_contact *contact, int32_t v, int32_t columns,
                           int32_t c)
{
    const sp_scene *scene = problem->scene;
    const sp_joint *f = &scene->joint[contact->id];
    const int32_t extra = columns - 3;                  /* 1: fm after fp */
    const sp_real *e = c <= extra ? contact->joint->n : c - extra == 1 ? contact->joint->t1 : contact->joint->t2;
    const sp_real s = c == 1 && extra ? (sp_real)-1 : (sp_real)1;
    for (int side = 0; side < 2; side++) {
        const int onto_b = (contact->a < contact->b) == side;
        const int32_t row = onto_b ? contact->b : contact->a;
        sp_real r[3];
        if (row < 0) continue;
        sp__sub3(problem->point[v], scene->block[onto_b ? f->b : f->a].centroid, r);
        sp__aeq_column(t, row, columns * v + c, onto_b ? s : -s, r, e);
    }
}

/* All entries of Aeq, contact by contact. */
static void sp__aeq_entries(sp_triplets *t, const sp_problem *problem, int32_t columns)
{
    t->count = 0;
    for (int32_t k = 0; k < problem->contacts; k++) {
        const sp_contact *contact = &problem->contact[k];
        for (int32_t q = 0; q < columns * contact->points; q++)
            sp__aeq_vertex(t, problem, contact, contact->point + q / columns, columns, q % columns);
    }
}

SP_API sp_status sp_matrix_aeq(const sp_problem *problem, int32_t columns, sp_arena *arena, sp_triplets *out)
{
    if (!problem || !problem->scene || !arena || !arena->base || !out) return SP_E_ARGUMENT;
    if (columns != 3 && columns != 4) return SP_E_RANGE;
    if (problem->blocks > INT32_MAX / 6 || problem->points > INT32_MAX / (2 * 6 * columns)) return SP_E_MEMORY;
    sp_arena a = *arena;
    sp_triplets t = { 6 * problem->blocks, columns * problem->points, 0, NULL, NULL, NULL };
    sp__aeq_entries(&t, problem, columns);
    sp__triplets_carve(&t, t.count, &a);
    if (sp__failed(&a)) return SP_E_MEMORY;
    sp__aeq_entries(&t, problem, columns);
    *arena = a;
    *out = t;
    return SP_OK;
}

/* Rows of the friction pyramid. */
typedef struct sp__friction {
    int32_t faces, net, first;          /* first: row of vertex 0 */
    sp_real shrink;                     /* mu_eff / mu */
} sp__friction;

/* Faces, coefficient and first row of the pyramid. */
static void sp__friction_begin(sp__friction *r, int32_t faces, int32_t inscribed, int32_t net, int32_t first)
{
    sp_real tangent;
    r->faces = faces;
    r->net = net;
    r->first = first;
    sp__pyramid_half(faces, &r->shrink, &tangent);
    (void)tangent;
    if (!inscribed) r->shrink = (sp_real)1;
}

/* Column c of one contact vertex: cos_k ft1 + sin_k ft2 - mu_eff (fp or fp - fm). */
static void sp__afr_vertex(sp_triplets *t, const sp__friction *r, const sp_contact *contact, int32_t v, int32_t columns,
                           int32_t c)
{
    const sp_real mu = r->shrink * contact->joint->strength.mu;
    const int32_t tangent = c - (columns - 2);          /* 0, 1: ft1, ft2 */
    for (int32_t k = 0; k < r->faces; k++) {
        const int32_t row = r->first + r->faces * v + k;
        sp_real d[2];
        sp__pyramid_direction(r->faces, k, d);
        if (tangent >= 0) sp__triplets_put(t, row, columns * v + c, d[tangent]);
        else if (c == 0) sp__triplets_put(t, row, columns * v, -mu);
        else if (r->net) sp__triplets_put(t, row, columns * v + 1, mu);
    }
}

/* All entries of Afr, likewise. */
static void sp__afr_entries(sp_triplets *t, const sp_problem *problem, const sp_settings *settings, int32_t columns)
{
    sp__friction r;
    sp__friction_begin(&r, settings->faces, settings->inscribed, settings->penalty.net, 0);
    t->count = 0;
    for (int32_t k = 0; k < problem->contacts; k++) {
        const sp_contact *contact = &problem->contact[k];
        for (int32_t q = 0; q < columns * contact->points; q++)
            sp__afr_vertex(t, &r, contact, contact->point + q / columns, columns, q % columns);
    }
}

SP_API sp_status sp_matrix_afr(const sp_problem *problem, const sp_settings *settings, int32_t columns, sp_arena *arena,
                               sp_triplets *out)
{
    if (!problem || !problem->scene || !settings || !arena || !arena->base || !out) return SP_E_ARGUMENT;
    if ((columns != 3 && columns != 4) || settings->faces < SP__FACES_MIN || settings->faces > SP__FACES_MAX) return SP_E_RANGE;
    if (sp__scene_strong(problem->scene)) return SP_E_UNSUPPORTED;
    if (problem->points > INT32_MAX / (4 * settings->faces)) return SP_E_MEMORY;
    sp_arena a = *arena;
    sp_triplets t = { settings->faces * problem->points, columns * problem->points, 0, NULL, NULL, NULL };
    sp__afr_entries(&t, problem, settings, columns);
    sp__triplets_carve(&t, t.count, &a);
    if (sp__failed(&a)) return SP_E_MEMORY;
    sp__afr_entries(&t, problem, settings, columns);
    *arena = a;
    *out = t;
    return SP_OK;
}

#endif /* SP__SCENE_MATRIX_C */
