/* words: texts of verdicts, reasons, effects and the rest */
#ifndef SP__SCENE_WORDS_C
#define SP__SCENE_WORDS_C

#include "../base/words.c"

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
                    SP__LONG_TEXT("no consistent motion") "\0" SP__LONG_TEXT("no coupled certificate") "\0" "tension\0" "unverified\0"
                    SP__LONG_TEXT("effect left out") "\0" "unknown",
                    k >= 0 && k <= 12 ? k : 13);
}

SP_API const char *sp_coupling_text(sp_coupling coupling)
{
    const int k = (int)coupling;
    return sp__word("not asked\0" SP__LONG_TEXT("coupled") "\0" SP__LONG_TEXT("refuted") "\0" SP__LONG_TEXT("not found") "\0" "unknown", k >= 0 && k <= 3 ? k : 4);
}

SP_API const char *sp_coupling_reason_text(sp_coupling_reason reason)
{
    const int k = (int)reason;
    return sp__word("not asked\0" SP__LONG_TEXT("motion") "\0" SP__LONG_TEXT("statics") "\0" SP__LONG_TEXT("no consistent motion") "\0" SP__LONG_TEXT("limit") "\0"
                    SP__LONG_TEXT("budget") "\0" "unknown",
                    k >= 0 && k <= 5 ? k : 6);
}

SP_API const char *sp_stage_text(sp_stage_id stage)
{
    const int k = (int)stage;
    return sp__word("none\0" "gates\0" SP__LONG_TEXT("least squares") "\0" SP__LONG_TEXT("dense") "\0" SP__LONG_TEXT("polish") "\0" "exact\0"
                    SP__LONG_TEXT("ADMM") "\0" SP__LONG_TEXT("custom") "\0" "unknown",
                    k >= 0 && k <= 7 ? k : 8);
}

SP_API const char *sp_effect_text(sp_effect effect)
{
    const int k = (int)effect;
    return sp__word("friction\0" "depth\0" "together\0" "strength\0" "loads\0" "live\0" "coupled\0" "dynamics\0"
                    "unknown", k >= 0 && k < SP_EFFECTS ? k : SP_EFFECTS);
}

SP_API int sp_effect_on(sp_effect_why why) { return why == SP_WHY_CALLED || why == SP_WHY_ASKED || why == SP_WHY_STAGES; }

SP_API const char *sp_effect_why_text(sp_effect_why why)
{
    const int k = (int)why;
    return sp__word("the scene calls for it\0" "the caller asks for it\0" SP__LONG_TEXT("left out by the caller") "\0" "not in this scene\0"
                    "not asked for\0" "statics asks for none\0" SP__LONG_TEXT("they share no free block; ") "each is solved alone\0"
                    SP__LONG_TEXT("stages or a budget that a plan leaves alone") "\0"
                    SP__LONG_TEXT("everything has one mirror plane: 3 rows a block") "\0"
                    SP__LONG_TEXT("level joints under plumb loads: pressure alone comes first") "\0"
                    SP__LONG_TEXT("contacts form a forest, or nothing need move: no search") "\0"
                    "unknown", k >= 0 && k <= (int)SP_WHY_FOREST ? k : (int)SP_WHY_FOREST + 1);
}

#ifndef SP_EXACT_ONLY
SP_API const char *sp_presence_text(sp_presence presence)
{
    const int k = (int)presence;
    return sp__word("absent\0" "present\0" "held\0" "unknown", k >= 0 && k <= 2 ? k : 3);
}

SP_API const char *sp_held_proof_text(sp_held_proof proof)
{
    const int k = (int)proof;
    return sp__word("minimal\0" "irreducible\0" "enough\0" "unknown", k >= 0 && k <= 2 ? k : 3);
}
#endif

#endif /* SP__SCENE_WORDS_C */
