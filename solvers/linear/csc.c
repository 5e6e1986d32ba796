/* csc: a sparse matrix by columns from its entries in any order.                                     [Davis 2006, ch. 2]
 *
 * They are sorted by column, row and their order; equal places are added as they follow each other.
 */
#ifndef SP__CSC_C
#define SP__CSC_C

#include "../base/real.c"
#include "../base/sort.c"

#if SP__WITH_STONES

static void sp__csc_carve(sp_csc *m, int32_t count, sp_arena *a)
{
    m->p = sp__take(a, (size_t)m->cols + 1, sizeof *m->p);
    m->i = sp__take(a, (size_t)count, sizeof *m->i);
    m->x = sp__take(a, (size_t)count, sizeof *m->x);
}

static int sp__csc_before(const void *what, int32_t k, int32_t q)
{
    const sp_triplets *t = what;
    if (t->j[k] != t->j[q]) return t->j[k] < t->j[q];
    return t->i[k] != t->i[q] ? t->i[k] < t->i[q] : k < q;
}

/* Entries in order to their places; p[j + 1] is where column j ends, or the column before it where it has none. */
static void sp__csc_fill(sp_csc *m, const sp_triplets *t, const int32_t *order)
{
    int32_t to = 0;
    memset(m->p, 0, ((size_t)m->cols + 1) * sizeof *m->p);
    for (int32_t q = 0; q < t->count; q++) {
        const int32_t k = order[q], i = t->i[k], j = t->j[k];
        if (m->p[j + 1] && m->i[to - 1] == i) { m->x[to - 1] += t->x[k]; continue; }
        m->i[to] = i;
        m->x[to++] = t->x[k];
        m->p[j + 1] = to;
    }
    for (int32_t j = 0; j < m->cols; j++) if (!m->p[j + 1]) m->p[j + 1] = m->p[j];
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
    if (sp__failed(&a)) return SP_E_MEMORY;
    for (int32_t k = 0; k < t->count; k++) order[k] = k;
    sp__sort(order, t->count, sp__csc_before, t);
    sp__csc_fill(&m, t, order);
    a.used = kept;                                      /* the rest was scratch */
    *arena = a;
    *out = m;
    return SP_OK;
}

#endif
#endif /* SP__CSC_C */
