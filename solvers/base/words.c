/* words: what the enumerators of stonepack.h are called, one after the other without a table of pointers, each ended by a 0 */
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
    "P" SP__LONG_TEXT(" of the quadratic program") " is not positive semidefinite\0"
#define SP__WORDS_QP_STATUS \
    "solved\0" "inaccurate\0" "primal infeasible\0" "dual infeasible\0" "iteration limit\0" "budget\0" "numerical\0"
#define SP__WORDS_VERDICT "undecided\0" "stable\0" "unstable\0"
#define SP__WORDS_LEVEL "none\0" "admissible\0" SP__LONG_TEXT("coupled") "\0"
#define SP__WORDS_REASON \
    "forces\0" "nothing to carry\0" "no contact\0" "no support\0" "mechanism\0" "limit\0" "budget\0" \
    SP__LONG_TEXT("stages") "\0" SP__LONG_TEXT("no consistent motion") "\0" SP__LONG_TEXT("no coupled certificate") "\0" \
    SP__LONG_TEXT("tension") "\0" SP__LONG_TEXT("unverified") "\0" \
    SP__LONG_TEXT("effect left out") "\0"
#define SP__WORDS_STAGE \
    "none\0" "gates\0" SP__LONG_TEXT("least squares") "\0" SP__LONG_TEXT("dense") "\0" SP__LONG_TEXT("polish") "\0" "exact\0" \
    SP__LONG_TEXT("ADMM") "\0" SP__LONG_TEXT("custom") "\0"
#define SP__WORDS_EFFECT "friction\0" "depth\0" "together\0" "strength\0" "loads\0" "live\0" "coupled\0" "dynamics\0"
#define SP__WORDS_EFFECT_WHY \
    "the scene calls for it\0" SP__LONG_TEXT("the caller asks for it") "\0" SP__LONG_TEXT("left out by the caller") "\0" \
    "not in this scene\0" "not asked for\0" "statics asks for none\0" \
    SP__LONG_TEXT("they share no free block; each is solved alone") "\0" \
    SP__LONG_TEXT("stages or a budget that a plan leaves alone") "\0" \
    SP__LONG_TEXT("everything has one mirror plane: 3 rows a block") "\0" \
    SP__LONG_TEXT("joints at right angles to the loads: pressure alone comes first") "\0" \
    SP__LONG_TEXT("contacts form a forest, or nothing need move: no search") "\0"
#define SP__WORDS_COUPLING \
    "not asked\0" SP__LONG_TEXT("coupled") "\0" SP__LONG_TEXT("refuted") "\0" SP__LONG_TEXT("not found") "\0"
#define SP__WORDS_COUPLING_REASON \
    "not asked\0" SP__LONG_TEXT("motion") "\0" SP__LONG_TEXT("statics") "\0" SP__LONG_TEXT("no consistent motion") "\0" \
    SP__LONG_TEXT("limit") "\0" SP__LONG_TEXT("budget") "\0"
#define SP__WORDS_PRESENCE "absent\0" "present\0" "held\0"
#define SP__WORDS_HELD_PROOF "minimal\0" "irreducible\0" "enough\0"
#define SP__WORDS_LIMIT "undecided\0" "found\0" "none\0" "unbounded\0"
#define SP__WORDS_JOINT "rigid\0" "hinge\0" "sliding\0" "open\0"
#define SP__WORDS_NBO \
    "accepted\0" SP__LONG_TEXT("centre of mass ") "outside its support\0" "too shallow" SP__LONG_TEXT(" for its height") "\0" \
    "resting face tilted\0" "too near the edge" SP__LONG_TEXT(" of its support") "\0"

#define SP__WORDS_STRONG "none\0" "admissible\0" "ambiguous\0" "strong at these corners\0" "strong\0"
#define SP__WORDS_STRONG_REASON "does not stand\0" "pressure\0" "motion\0" "nothing found\0" "not asked\0" "cases\0" \
                                "even friction\0"

/* All words of all enumerations in the order of sp_words, and how many each has: no pointers, so nothing to relocate. */
static const char sp__words[] = SP__WORDS_STATUS SP__WORDS_QP_STATUS
#if SP__WITH_STONES
    SP__WORDS_VERDICT SP__WORDS_LEVEL SP__WORDS_REASON SP__WORDS_STAGE SP__WORDS_EFFECT SP__WORDS_EFFECT_WHY SP__WORDS_COUPLING
    SP__WORDS_COUPLING_REASON SP__WORDS_PRESENCE SP__WORDS_HELD_PROOF SP__WORDS_LIMIT SP__WORDS_JOINT SP__WORDS_NBO
#if SP__WITH_STRONG
    SP__WORDS_STRONG SP__WORDS_STRONG_REASON
#endif
#endif
    ;

static const uint8_t sp__word_counts[] = {
    17, 7,
#if SP__WITH_STONES
    3, 3, 13, 8, 8, 11, 4, 6, 3, 3, 4, 4, 5,
#if SP__WITH_STRONG
    5, 7
#endif
#endif
};

SP_API const char *sp_text(sp_words of, int32_t value)
{
    const char *word = sp__words;
    int32_t k = of == SP_WORDS_STATUS && value > -100 ? -value : value;
    if ((uint32_t)of >= sizeof sp__word_counts || k < 0 || k >= sp__word_counts[of]) return "unknown";
    for (int i = 0; i < (int)of; i++) k += sp__word_counts[i];
    for (; k > 0; k--) {
        while (*word) word++;
        word++;
    }
    return word;
}

#endif /* SP__BASE_WORDS_C */
