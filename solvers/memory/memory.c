/* memory: sp_memory: the bytes any call takes, from a dry run of the same carving, before the call is made. */
#ifndef SP__MEMORY_MEMORY_C
#define SP__MEMORY_MEMORY_C

#include "../contacts/small_patch.c"
#include "../contacts/memory.c"
#include "../check/verify.c"
#include "../check/plan.c"
#include "../limit/limit.c"
#include "../strong/strong.c"
#include "../sliding/sliding.c"
#include "../sequence/calls.c"

/* Of a call whose memory follows from counts alone; 0: too large to count. */
static sp_status sp__memory_counted(size_t need, size_t *bytes)
{
    if (need) *bytes = need;
    return need ? SP_OK : SP_E_MEMORY;
}

SP_API size_t sp_memory_scratch(const sp_scene *scene, sp_memory_for what, const sp_settings *settings)
{
    if (what == SP_FOR_CHECK || what == SP_FOR_WORK) return sp__check_scratch(scene, settings);
    if (what == SP_FOR_LIMIT) return sp__limit_scratch(scene);
    if (what == SP_FOR_SEQUENCE) return sp__sequence_scratch(scene, settings);
    return scene ? SP_ALIGN : 0;
}

SP_API sp_status sp_memory(const sp_scene *scene, sp_memory_for what, const sp_settings *settings, sp_arena scratch,
                           size_t *bytes)
{
    if (!scene || !bytes) return SP_E_ARGUMENT;
    if (SP__WITH_STRONG && what == SP_FOR_STRONG) return sp__memory_counted(sp__holds_memory(scene, settings), bytes);
    if (SP__WITH_STRONG && what == SP_FOR_STRONG_VERIFY) return sp__memory_counted(sp__holds_verify_memory(scene), bytes);
    if (SP__WITH_SLIDING && (what == SP_FOR_SLIDING || what == SP_FOR_SLIDING_VERIFY))
        return sp__memory_counted(sp__sliding_bytes(scene, what == SP_FOR_SLIDING), bytes);
    switch (what) {
    case SP_FOR_CHECK: return sp__check_memory(scene, settings, scratch, bytes);
    case SP_FOR_WORK: return sp__work_memory(scene, settings, scratch, bytes);
    case SP_FOR_VERIFY: return sp__memory_counted(sp__verify_memory(scene), bytes);
    case SP_FOR_CONTACTS: return sp__memory_counted(sp__contacts_memory(scene), bytes);
    case SP_FOR_PLAN: return SP__WITH_PLAN ? sp__memory_counted(sp__plan_memory(scene, settings), bytes) : SP_E_UNSUPPORTED;
    case SP_FOR_LIMIT: return sp__limit_memory(scene, settings, scratch, bytes);
    case SP_FOR_LIMIT_VERIFY:
        return SP__WITH_LIMIT ? sp__memory_counted(sp__limit_verify_memory(scene), bytes) : SP_E_UNSUPPORTED;
    case SP_FOR_SEQUENCE: return sp__sequence_memory(scene, settings, scratch, bytes);
    case SP_FOR_PROBLEM: return scene->count.blocks < 1 ? SP_E_EMPTY : sp__memory_counted(sp__problem_memory(scene), bytes);
    case SP_FOR_STRONG: case SP_FOR_STRONG_VERIFY: case SP_FOR_SLIDING: case SP_FOR_SLIDING_VERIFY: break;
    }
    return SP_E_ARGUMENT;
}

#endif /* SP__MEMORY_MEMORY_C */
