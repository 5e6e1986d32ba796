/* even: which multiples of live loads does friction in proportion to pressure carry, along a tree of joints (proof/shear.c)? */
#ifndef SP__SLIDING_EVEN_C
#define SP__SLIDING_EVEN_C

#include "../proof/shear.c"
#include "descend.c"

#if SP__WITH_SLIDING

#if SP__WITH_STRONG

/* What judges, in memory of its own. */
typedef struct sp__even {
    sp_arena room;
    sp__inertia *M;                     /* b; NULL: unknown */
} sp__even;

static void sp__even_carve(sp__even *e, const sp_problem *pb, sp_arena *a)
{
    const size_t need = sp__shear_need(pb->points, pb->contacts, pb->blocks);
    e->M = sp__take(a, (size_t)pb->blocks, sizeof *e->M);
    e->room.base = sp__take(a, 1, need);
    e->room.capacity = need ? need : 1;
    e->room.used = e->room.peak = 0;
}

/* Masses and inertias, by arms of so many blocks. */
static void sp__even_make(sp__even *e, const sp_problem *pb, sp_real *arm) { if (!sp__inertias(pb, arm, e->M)) e->M = NULL; }

/* May it be so? */
static int sp__even_asked(const sp_problem *pb) { return sp__shear_open(pb); }

/* Do the forces f, made even, balance what j has to tol, and is there no state below? */
static int sp__even_carries(const sp__even *e, sp__certifier *j, const sp_real *f, const sp_real *live)
{
    sp_arena a = e->room;
    return e->room.base && sp__certify_even(j, f, live, &a) <= j->set->tol;
}

/* Does nothing move from rest, either? */
static int sp__even_holds(const sp__even *e, sp__certifier *j, const sp_real *f, const sp_real *live)
{
    sp_arena a = e->room;
    return e->room.base && e->M && sp__certify_shear(j, e->M, f, live, &a) > 0;
}

#else                                   /* without strong verdicts pressure alone is asked */

typedef struct sp__even { int32_t none; } sp__even;

static void sp__even_carve(sp__even *e, const sp_problem *pb, sp_arena *a) { (void)pb, (void)a, e->none = 1; }
static void sp__even_make(sp__even *e, const sp_problem *pb, sp_real *arm) { (void)e, (void)pb, (void)arm; }
static int sp__even_asked(const sp_problem *pb) { return (void)pb, 0; }
static int sp__even_carries(const sp__even *e, sp__certifier *j, const sp_real *f, const sp_real *live)
{
    return (void)e, (void)j, (void)f, (void)live, 0;
}
static int sp__even_holds(const sp__even *e, sp__certifier *j, const sp_real *f, const sp_real *live)
{
    return (void)e, (void)j, (void)f, (void)live, 0;
}

#endif

#endif

#endif /* SP__SLIDING_EVEN_C */
