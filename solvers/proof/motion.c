/* motion: a judged motion as a result has it */
#ifndef SP__PROOF_MOTION_C
#define SP__PROOF_MOTION_C

#include "statics.c"

/* The judge's motion into a result's dq: scaled so that no point of a block moves farther than the largest block reaches. */
static void sp__check_motion(const sp__judge *j, sp_real *dq)
{
    const sp_problem *pb = j->pb;
    sp_real largest = 0, block = 0;
    for (int32_t i = 0; i < pb->blocks; i++) {
        const sp_real *m = j->x + 6 * (size_t)i;
        block = sp__max(block, j->scale[i].arm);
        largest = sp__max(largest, sp__max(sp__norm3(m), sp__norm3(m + 3) * sp__judge_arm(j, i)));
    }
    const sp_real scale = largest > 0 ? (block > 0 ? block : 1) / largest : 0;
    memset(dq, 0, 6 * (size_t)pb->scene->count.blocks * sizeof *dq);
    for (int32_t i = 0; i < pb->blocks; i++)
        for (size_t k = 0; k < 6; k++) dq[6 * (size_t)pb->block[i] + k] = scale * j->x[6 * (size_t)i + k];
}

#endif /* SP__PROOF_MOTION_C */
