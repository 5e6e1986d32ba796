/* 8 ----------------------------------------------------------------------------------------------------------- problem */

/* A contact takes part if it touches a free block. */
static int sp__contact_counts(const sp_scene *scene, const sp_interface *f)
{
    return scene->block[f->a].fixed != SP_FIXED || scene->block[f->b].fixed != SP_FIXED;
}

static void sp__problem_count(const sp_scene *scene, sp_problem *problem)
{
    problem->scene = scene;
    problem->blocks = problem->contacts = 0;
    problem->points = scene->count.points;
    problem->loads = 1;
    for (int32_t k = 0; k < scene->count.blocks; k++)
        if (scene->block[k].fixed != SP_FIXED) problem->blocks++;
    for (int32_t k = 0; k < scene->count.interfaces; k++)
        if (sp__contact_counts(scene, &scene->interface[k])) problem->contacts++;
}

static void sp__problem_carve(sp_problem *problem, sp_arena *a)
{
    problem->block = sp__take(a, (size_t)problem->blocks, sizeof *problem->block);
    problem->contact = sp__take(a, (size_t)problem->contacts, sizeof *problem->contact);
    problem->local = sp__take(a, (size_t)problem->points, sizeof *problem->local);
    problem->p = sp__take(a, (size_t)problem->blocks * (size_t)problem->loads, 6 * sizeof *problem->p);
}

SP_API size_t sp_problem_memory(const sp_scene *scene)
{
    if (!scene) return 0;
    sp_problem problem;
    sp_arena dry = sp__arena_dry();
    sp__problem_count(scene, &problem);
    sp__problem_carve(&problem, &dry);
    return sp__failed(&dry) ? 0 : dry.used;
}

/* Row of a block of the scene among the free ones (their numbers ascend), -1: a support. */
static int32_t sp__problem_row(const sp_problem *problem, int32_t block)
{
    int32_t lo = 0, hi = problem->blocks;
    while (lo < hi) {
        const int32_t mid = lo + (hi - lo) / 2;
        if (problem->block[mid] < block) lo = mid + 1; else hi = mid;
    }
    return lo < problem->blocks && problem->block[lo] == block ? lo : -1;
}

/* Points of a contact from their mean, in its frame; the mean goes to `mean`, seen from the first point. Differences are taken
 * of neighbouring places only, so coordinates far from the origin lose nothing. */
static void sp__contact_local(const sp_problem *problem, const sp_interface *f, sp_real mean[3])
{
    const sp_real (*point)[3] = (const sp_real (*)[3])problem->scene->point + f->point;
    sp_real x[3];
    mean[0] = mean[1] = mean[2] = 0;
    for (int32_t k = 1; k < f->points; k++) {
        sp__sub3(point[k], point[0], x);
        for (int c = 0; c < 3; c++) mean[c] += x[c];
    }
    sp__scale3((sp_real)1 / (sp_real)f->points, mean, mean);
    for (int32_t k = 0; k < f->points; k++) {
        sp_real *local = problem->local[f->point + k];
        sp__sub3(point[k], point[0], x);
        sp__sub3(x, mean, x);
        local[0] = sp__dot3(x, f->n);
        local[1] = sp__dot3(x, f->t1);
        local[2] = sp__dot3(x, f->t2);
    }
}

/* One contact: rows, frame, arms (first point - centroid) + (mean - first point). */
static void sp__contact_build(const sp_problem *problem, int32_t id, sp_contact *contact)
{
    const sp_scene *scene = problem->scene;
    const sp_interface *f = &scene->interface[id];
    contact->id = id;
    contact->a = sp__problem_row(problem, f->a);
    contact->b = sp__problem_row(problem, f->b);
    contact->point = f->point;
    contact->points = f->points;
    contact->joint = f;
    sp__contact_local(problem, f, contact->ra);
    const sp_real *first = scene->point[f->point], *ca = scene->block[f->a].centroid, *cb = scene->block[f->b].centroid;
    for (int c = 0; c < 3; c++) {
        contact->rb[c] = (first[c] - cb[c]) + contact->ra[c];
        contact->ra[c] = (first[c] - ca[c]) + contact->ra[c];
    }
}

/* Weights and everything relative to them; a held direction keeps its row, whoever solves masks it. */
static sp_status sp__problem_fill(sp_problem *problem)
{
    const sp_scene *scene = problem->scene;
    int32_t row = 0, contact = 0;
    for (int32_t k = 0; k < scene->count.blocks; k++) {
        if (scene->block[k].fixed == SP_FIXED) continue;
        sp_real *p = problem->p + 6 * (size_t)row;
        sp__scale3(scene->block[k].mass, scene->gravity, p);
        p[3] = p[4] = p[5] = 0;
        if (!sp__finite(sp__dot3(p, p))) return SP_E_NOT_FINITE;
        problem->block[row++] = k;
    }
    memset(problem->local, 0, (size_t)problem->points * sizeof *problem->local);
    for (int32_t k = 0; k < scene->count.interfaces; k++) {
        if (!sp__contact_counts(scene, &scene->interface[k])) continue;
        sp_contact *c = &problem->contact[contact++];
        sp__contact_build(problem, k, c);
        sp_real size = sp__dot3(c->ra, c->ra) + sp__dot3(c->rb, c->rb);
        for (int32_t v = 0; v < c->points; v++) size += sp__dot3(problem->local[c->point + v], problem->local[c->point + v]);
        if (!sp__finite(size)) return SP_E_NOT_FINITE;
    }
    return SP_OK;
}

SP_API sp_status sp_problem_build(const sp_scene *scene, sp_arena *arena, sp_problem *problem)
{
    if (!scene || !arena || !arena->base || !problem) return SP_E_ARGUMENT;
    if (scene->count.blocks == 0) return SP_E_EMPTY;
    sp_arena a = *arena;
    sp_problem made;
    sp__problem_count(scene, &made);
    sp__problem_carve(&made, &a);
    if (sp__failed(&a)) return SP_E_MEMORY;
    const sp_status status = sp__problem_fill(&made);
    if (status) return status;
    *arena = a;
    *problem = made;
    return SP_OK;
}

/* 9 ---------------------------------------------------------------------------------------------------------- matrices */

static void sp__triplets_carve(sp_triplets *t, int32_t count, sp_arena *a)
{
    t->i = sp__take(a, (size_t)count, sizeof *t->i);
    t->j = sp__take(a, (size_t)count, sizeof *t->j);
    t->x = sp__take(a, (size_t)count, sizeof *t->x);
}

/* An entry, unless it is 0; without room (x NULL) it is only counted. */
static void sp__triplets_put(sp_triplets *t, int32_t i, int32_t j, sp_real x)
{
    if (!(sp__abs(x) > 0)) return;
    if (t->x) { t->i[t->count] = i; t->j[t->count] = j; t->x[t->count] = x; }
    t->count++;
}

/* The column of force s e at arm r on the rows of one block:  [ s e ; s r x e ]. */
static void sp__aeq_column(sp_triplets *t, int32_t row, int32_t column, sp_real s, const sp_real r[3], const sp_real e[3])
{
    sp_real m[3];
    sp__cross3(r, e, m);
    for (int32_t c = 0; c < 3; c++) sp__triplets_put(t, 6 * row + c, column, s * e[c]);
    for (int32_t c = 0; c < 3; c++) sp__triplets_put(t, 6 * row + 3 + c, column, s * m[c]);
}

/* All columns of one contact vertex: f on B with arm r - c_B, -f on A with arm r - c_A. */
static void sp__aeq_vertex(sp_triplets *t, const sp_problem *problem, const sp_contact *contact, int32_t v, int32_t columns)
{
    const sp_scene *scene = problem->scene;
    const sp_interface *f = &scene->interface[contact->id];
    const int32_t extra = columns - 3;                  /* 1: fm after fp */
    sp_real ra[3], rb[3];
    sp__sub3(scene->point[v], scene->block[f->a].centroid, ra);
    sp__sub3(scene->point[v], scene->block[f->b].centroid, rb);
    for (int32_t c = 0; c < columns; c++) {
        const sp_real *e = c <= extra ? contact->joint->n : c - extra == 1 ? contact->joint->t1 : contact->joint->t2;
        const sp_real s = c == 1 && extra ? (sp_real)-1 : (sp_real)1;
        if (contact->b >= 0) sp__aeq_column(t, contact->b, columns * v + c, s, rb, e);
        if (contact->a >= 0) sp__aeq_column(t, contact->a, columns * v + c, -s, ra, e);
    }
}

static void sp__aeq_entries(sp_triplets *t, const sp_problem *problem, int32_t columns)
{
    t->count = 0;
    for (int32_t k = 0; k < problem->contacts; k++) {
        const sp_contact *contact = &problem->contact[k];
        for (int32_t q = 0; q < contact->points; q++) sp__aeq_vertex(t, problem, contact, contact->point + q, columns);
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

/* Rows of one contact vertex: cos_k ft1 + sin_k ft2 - mu_eff (fp or fp - fm). */
static void sp__afr_vertex(sp_triplets *t, int32_t K, int32_t v, int32_t columns, sp_real mu, int net)
{
    for (int32_t k = 0; k < K; k++) {
        const int32_t row = K * v + k, column = columns * v;
        sp_real d[2];
        sp__pyramid_direction(K, k, d);
        sp__triplets_put(t, row, column, -mu);
        if (columns == 4 && net) sp__triplets_put(t, row, column + 1, mu);
        sp__triplets_put(t, row, column + columns - 2, d[0]);
        sp__triplets_put(t, row, column + columns - 1, d[1]);
    }
}

static void sp__afr_entries(sp_triplets *t, const sp_problem *problem, const sp_settings *settings, int32_t columns)
{
    sp_real shrink, tangent;
    sp__pyramid_half(settings->faces, &shrink, &tangent);
    (void)tangent;
    if (!settings->inscribed) shrink = (sp_real)1;
    t->count = 0;
    for (int32_t k = 0; k < problem->contacts; k++) {
        const sp_contact *contact = &problem->contact[k];
        for (int32_t q = 0; q < contact->points; q++)
            sp__afr_vertex(t, settings->faces, contact->point + q, columns, shrink * contact->joint->joint.mu, settings->net);
    }
}

SP_API sp_status sp_matrix_afr(const sp_problem *problem, const sp_settings *settings, int32_t columns, sp_arena *arena,
                               sp_triplets *out)
{
    if (!problem || !problem->scene || !settings || !arena || !arena->base || !out) return SP_E_ARGUMENT;
    if ((columns != 3 && columns != 4) || settings->faces < SP__FACES_MIN || settings->faces > SP__FACES_MAX) return SP_E_RANGE;
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

/* 10 ------------------------------------------------------------------------------------------------------ by columns */

static void sp__csc_carve(sp_csc *m, int32_t count, sp_arena *a)
{
    m->p = sp__take(a, (size_t)m->cols + 1, sizeof *m->p);
    m->i = sp__take(a, (size_t)count, sizeof *m->i);
    m->x = sp__take(a, (size_t)count, sizeof *m->x);
}

/* order: the entries by ascending key, equal keys in their order; start: keys + 1 of scratch.        [counting sort] */
static void sp__counting_order(const int32_t *key, int32_t count, int32_t keys, int32_t *start, int32_t *order)
{
    memset(start, 0, ((size_t)keys + 1) * sizeof *start);
    for (int32_t k = 0; k < count; k++) start[key[k] + 1]++;
    for (int32_t k = 0; k < keys; k++) start[k + 1] += start[k];
    for (int32_t k = 0; k < count; k++) order[start[key[k]]++] = k;
}

/* Entries go to their columns in the order of their rows, so each column ends up sorted; p is cursor, then shifted back. */
static void sp__csc_fill(sp_csc *m, const sp_triplets *t, const int32_t *order)
{
    memset(m->p, 0, ((size_t)m->cols + 1) * sizeof *m->p);
    for (int32_t k = 0; k < t->count; k++) m->p[t->j[k] + 1]++;
    for (int32_t k = 0; k < m->cols; k++) m->p[k + 1] += m->p[k];
    for (int32_t q = 0; q < t->count; q++) {
        const int32_t k = order[q], to = m->p[t->j[k]]++;
        m->i[to] = t->i[k];
        m->x[to] = t->x[k];
    }
    for (int32_t k = m->cols; k > 0; k--) m->p[k] = m->p[k - 1];
    m->p[0] = 0;
}

/* Add up neighbours at the same place and close the gaps. */
static void sp__csc_merge(sp_csc *m)
{
    int32_t to = 0;
    for (int32_t j = 0, from = 0; j < m->cols; j++) {
        const int32_t first = to, end = m->p[j + 1];
        m->p[j] = first;
        for (; from < end; from++) {
            if (to > first && m->i[to - 1] == m->i[from]) { m->x[to - 1] += m->x[from]; continue; }
            m->i[to] = m->i[from];
            m->x[to++] = m->x[from];
        }
    }
    m->p[m->cols] = to;
}

SP_API sp_status sp_csc_from(const sp_triplets *t, sp_arena *arena, sp_csc *out)
{
    if (!t || !arena || !arena->base || !out || t->rows < 0 || t->cols < 0 || t->count < 0) return SP_E_ARGUMENT;
    if (t->count > 0 && (!t->i || !t->j || !t->x)) return SP_E_ARGUMENT;
    for (int32_t k = 0; k < t->count; k++)
        if (t->i[k] < 0 || t->i[k] >= t->rows || t->j[k] < 0 || t->j[k] >= t->cols) return SP_E_INDEX;
    sp_arena a = *arena;
    sp_csc m = { t->rows, t->cols, NULL, NULL, NULL };
    sp__csc_carve(&m, t->count, &a);
    const size_t kept = a.used;
    int32_t *order = sp__take(&a, (size_t)t->count, sizeof *order);
    int32_t *start = sp__take(&a, (size_t)t->rows + 1, sizeof *start);
    if (sp__failed(&a)) return SP_E_MEMORY;
    sp__counting_order(t->i, t->count, t->rows, start, order);
    sp__csc_fill(&m, t, order);
    sp__csc_merge(&m);
    a.used = kept;                                      /* the rest was scratch */
    *arena = a;
    *out = m;
    return SP_OK;
}
