/* falls: does a motion fall at a multiple, and at every larger one? */
#ifndef SP__LIMIT_FALLS_C
#define SP__LIMIT_FALLS_C

#include "bracket.c"

#if SP__WITH_INTERIOR

/* The motion just certified into b->dq, and what joints with strength take of it. */
static void sp__bracket_take_motion(sp__bracket *b)
{
    b->resist = sp__problem_strong(&b->pb) ? sp__in_newtons(b->certifier.unit, b->certifier.resist) : 0;
    memcpy(b->dq, b->certifier.dual.motion, 6 * (size_t)b->pb.blocks * sizeof *b->dq);
    sp__bracket_certify_end(b);
}

/* Most work that joints can do against b->dq at lambda.     returns 0: no budget, no memory */
SP__NOINLINE static int sp__bracket_resists(sp__bracket *b, sp_real lambda)
{
    int32_t final;
    if (!sp__bracket_certify_begin(b, 1, lambda)) return 0;
    sp__certify_motion(&b->certifier, b->dq, 0, 0, &final);
    sp__bracket_take_motion(b);
    return 1;
}

/* Does b->dq fall at lambda, with smaller motions held as sp__certify_mechanism may, and if `beyond` at every larger one, too?
 * What moves in that proof stays in b->dq, and in `all` (may be NULL) as a result has it. */
SP__NOINLINE static int sp__bracket_falls(sp__bracket *b, sp_real lambda, int beyond, sp_real *all)
{
    const size_t bytes = 6 * (size_t)b->pb.blocks * sizeof *b->dq;
    sp_real value[6] = { 0 };
    int32_t rank[6] = { 0 }, final;
    memcpy(b->whole, b->dq, bytes);
    for (int pass = 0; pass < 7; pass++) {
        sp__certifier *j = &b->certifier;
        int k = 0;
        if (!sp__bracket_certify_begin(b, 1, lambda)) return 0;
        if (pass == 0) {
            for (k = 0; k < 6; k++) {
                value[k] = sp__certify_motion(j, b->whole, sp__certify_rest[k], 0, &final);
                rank[k] = sp__certify_rank(j, value[k], final);
            }
            sp__bracket_certify_end(b);
            continue;
        }
        for (int q = 1; q < 6; q++)                     /* a final proof before others, then the best */
            if (rank[q] > rank[k] || (rank[q] == rank[k] && value[q] > value[k])) k = q;
        if (rank[k] < (b->slight ? 1 : 2)) break;
        b->least = sp__certify_motion(j, b->whole, sp__certify_rest[k], 0, &b->final);
        if (all) sp__motion_write(j, all);
        sp__bracket_take_motion(b);
        if (!beyond || sp__bracket_falls_beyond(b)) return 1;
        rank[k] = 0;
    }
    memcpy(b->dq, b->whole, bytes);
    return 0;
}

#endif

#endif /* SP__LIMIT_FALLS_C */
