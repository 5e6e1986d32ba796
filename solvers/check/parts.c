/* parts: how many islands a check solves one by one; on a budget or where asked, all blocks are one part. */
#ifndef SP__CHECK_PARTS_C
#define SP__CHECK_PARTS_C

#include "../scene/part.c"
#include "../statics/mirror.c"

#if SP__WITH_LARGE

/* May islands be solved one by one? Not on a budget, which the first of them might spend. */
static int sp__islands_allowed(const sp_settings *set)
{
    return sp__plan_stages(set) && (!set || (set->effect[SP_EFFECT_TOGETHER] != SP_WITH && set->budget <= 0));
}

/* How the blocks of a scene are solved.     returns SP_OK, SP_E_MEMORY: scratch too small */
static sp_status sp__islands_count(const sp_scene *scene, const sp_settings *set, sp_arena scratch, sp__island_counts *o)
{
    sp_problem pb;
    const size_t b = (size_t)scene->count.blocks;
    sp__problem_count(scene, &pb);
    o->islands = 1;
    o->points = sp__points_count(scene);
    o->blocks = pb.blocks;
    if (!sp__islands_allowed(set)) return SP_OK;
    int32_t *up = sp__take(&scratch, b, sizeof *up), *points = sp__take(&scratch, b, sizeof *points);
    int32_t *blocks = sp__take(&scratch, b, sizeof *blocks);
    if (sp__failed(&scratch)) return SP_E_MEMORY;
    const int32_t count = sp__islands_join(scene, up);
    if (count < 2) return SP_OK;
    o->islands = count;
    sp__islands_proof_size(scene, up, points, blocks, o);
    return SP_OK;
}

#endif

#endif /* SP__CHECK_PARTS_C */
