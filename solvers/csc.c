/* csc: a sparse matrix by columns from its entries in any order.                                     [Davis 2006, ch. 2]
 *
 * Two stable counting sorts, by row and then by column, bring the entries into place; equal places are added in their order.
 */
#ifndef SP__CSC_C
#define SP__CSC_C

#include "real.c"

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

#endif /* SP__CSC_C */
