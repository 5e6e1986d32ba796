/* words: what the enumerators of stonepack.h are called, one after the other without a table of pointers */
#ifndef SP__BASE_WORDS_C
#define SP__BASE_WORDS_C

#include "config.c"

#ifdef SP_SMALL
#define SP__LONG_TEXT(text) ""                          /* left to other builds, most of it names what this one does without */
#else
#define SP__LONG_TEXT(text) text
#endif

#define SP__WORDS_STATUS "no error\0" \
    "bad argument" SP__LONG_TEXT(": a null pointer, a negative count or an unknown choice") "\0" \
    "not enough memory" SP__LONG_TEXT(" in the arena") "\0" \
    "the scene is full\0" \
    SP__LONG_TEXT("a number is ") "infinite" SP__LONG_TEXT(", not a number, or too large to be squared") "\0" \
    SP__LONG_TEXT("a block, vertex or joint of ") "that number is missing\0" \
    SP__LONG_TEXT("a number is ") "outside its range\0" \
    "the mesh is open" SP__LONG_TEXT(": an edge lacks its opposite") "\0" \
    SP__LONG_TEXT("the mesh is inside out: ") "its faces look inward\0" \
    "the mesh encloses no volume" SP__LONG_TEXT(", or a face has fewer than three corners") "\0" \
    "a face is out of plane\0" \
    "the joint" SP__LONG_TEXT(" polygon") " is out of plane\0" \
    "the joint has no area" SP__LONG_TEXT(", or its normal no length") "\0" \
    SP__LONG_TEXT("a joint ") "between a block and itself\0" \
    SP__LONG_TEXT("the scene has ") "no block\0" \
    "not supported here" SP__LONG_TEXT(": strength of joints with the coupled check, or a part this build leaves out") "\0" \
    "P" SP__LONG_TEXT(" of the quadratic program") " is not positive semidefinite\0" \
    "unknown status"
#define SP__WORDS_QP_STATUS \
    "solved\0" "inaccurate\0" "primal infeasible\0" "dual infeasible\0" "iteration limit\0" "budget\0" "numerical\0" "unknown"
#define SP__WORDS_VERDICT "undecided\0" "stable\0" "unstable\0" "unknown"
#define SP__WORDS_LEVEL "none\0" "admissible\0" "coupled\0" "unknown"
#define SP__WORDS_REASON \
    "forces\0" "nothing to carry\0" "no contact\0" "no support\0" "mechanism\0" "limit\0" "budget\0" "stages\0" \
    SP__LONG_TEXT("no consistent motion") "\0" SP__LONG_TEXT("no coupled certificate") "\0" "tension\0" "unverified\0" \
    SP__LONG_TEXT("effect left out") "\0" "unknown"
#define SP__WORDS_STAGE \
    "none\0" "gates\0" SP__LONG_TEXT("least squares") "\0" SP__LONG_TEXT("dense") "\0" SP__LONG_TEXT("polish") "\0" "exact\0" \
    SP__LONG_TEXT("ADMM") "\0" SP__LONG_TEXT("custom") "\0" "unknown"
#define SP__WORDS_EFFECT "friction\0" "depth\0" "together\0" "strength\0" "loads\0" "live\0" "coupled\0" "dynamics\0" "unknown"
#define SP__WORDS_EFFECT_WHY \
    "the scene calls for it\0" "the caller asks for it\0" SP__LONG_TEXT("left out by the caller") "\0" "not in this scene\0" \
    "not asked for\0" "statics asks for none\0" SP__LONG_TEXT("they share no free block; ") "each is solved alone\0" \
    SP__LONG_TEXT("stages or a budget that a plan leaves alone") "\0" \
    SP__LONG_TEXT("everything has one mirror plane: 3 rows a block") "\0" \
    SP__LONG_TEXT("joints at right angles to the loads: pressure alone comes first") "\0" \
    SP__LONG_TEXT("contacts form a forest, or nothing need move: no search") "\0" "unknown"
#define SP__WORDS_COUPLING \
    "not asked\0" SP__LONG_TEXT("coupled") "\0" SP__LONG_TEXT("refuted") "\0" SP__LONG_TEXT("not found") "\0" "unknown"
#define SP__WORDS_COUPLING_REASON \
    "not asked\0" SP__LONG_TEXT("motion") "\0" SP__LONG_TEXT("statics") "\0" SP__LONG_TEXT("no consistent motion") "\0" \
    SP__LONG_TEXT("limit") "\0" SP__LONG_TEXT("budget") "\0" "unknown"
#define SP__WORDS_PRESENCE "absent\0" "present\0" "held\0" "unknown"
#define SP__WORDS_HELD_PROOF "minimal\0" "irreducible\0" "enough\0" "unknown"
#define SP__WORDS_LIMIT "undecided\0" "found\0" "none\0" "unbounded\0" "unknown"
#define SP__WORDS_JOINT "rigid\0" "hinge\0" "sliding\0" "open\0" "unknown"
#define SP__WORDS_NBO \
    "accepted\0" SP__LONG_TEXT("centre of mass ") "outside its support\0" "too shallow" SP__LONG_TEXT(" for its height") "\0" \
    "resting face tilted\0" "too near the edge" SP__LONG_TEXT(" of its support") "\0" "unknown"

#define SP__WORDS_STRONG "none\0" "admissible\0" "ambiguous\0" "strong at these corners\0" "strong\0" "unknown"
#define SP__WORDS_STRONG_REASON "does not stand\0" "pressure\0" "motion\0" "nothing found\0" "not asked\0" "cases\0" \
                                "even friction\0" "unknown"

/* The k-th of `count` zero-terminated words that follow each other, of others the one behind the last. No table of pointers, so
 * nothing to relocate. */
static const char *sp__word(const char *words, int32_t k, int32_t count)
{
    if (k < 0 || k > count) k = count;
    for (; k > 0; k--) {
        while (*words) words++;
        words++;
    }
    return words;
}

SP_API const char *sp_text(sp_words of, int32_t value)
{
    if ((!SP__WITH_STONES && of > SP_WORDS_QP_STATUS) || (!SP__WITH_STRONG && of > SP_WORDS_NBO)) return "unknown";
    switch (of) {
    case SP_WORDS_STATUS: return sp__word(SP__WORDS_STATUS, -value, 17);
    case SP_WORDS_QP_STATUS: return sp__word(SP__WORDS_QP_STATUS, value, 7);
    case SP_WORDS_VERDICT: return sp__word(SP__WORDS_VERDICT, value, 3);
    case SP_WORDS_LEVEL: return sp__word(SP__WORDS_LEVEL, value, 3);
    case SP_WORDS_REASON: return sp__word(SP__WORDS_REASON, value, 13);
    case SP_WORDS_STAGE: return sp__word(SP__WORDS_STAGE, value, 8);
    case SP_WORDS_EFFECT: return sp__word(SP__WORDS_EFFECT, value, 8);
    case SP_WORDS_EFFECT_WHY: return sp__word(SP__WORDS_EFFECT_WHY, value, 11);
    case SP_WORDS_COUPLING: return sp__word(SP__WORDS_COUPLING, value, 4);
    case SP_WORDS_COUPLING_REASON: return sp__word(SP__WORDS_COUPLING_REASON, value, 6);
    case SP_WORDS_PRESENCE: return sp__word(SP__WORDS_PRESENCE, value, 3);
    case SP_WORDS_HELD_PROOF: return sp__word(SP__WORDS_HELD_PROOF, value, 3);
    case SP_WORDS_LIMIT: return sp__word(SP__WORDS_LIMIT, value, 4);
    case SP_WORDS_JOINT: return sp__word(SP__WORDS_JOINT, value, 4);
    case SP_WORDS_NBO: return sp__word(SP__WORDS_NBO, value, 5);
    case SP_WORDS_STRONG: return sp__word(SP__WORDS_STRONG, value, 5);
    case SP_WORDS_STRONG_REASON: return sp__word(SP__WORDS_STRONG_REASON, value, 7);
    }
    return "unknown";
}

#endif /* SP__BASE_WORDS_C */
