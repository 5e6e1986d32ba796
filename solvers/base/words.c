/* words: texts of a status; words one after the other without a table of pointers */
#ifndef SP__BASE_WORDS_C
#define SP__BASE_WORDS_C

#include "config.c"

#ifdef SP_SMALL
#define SP__LONG_TEXT(text) ""                          /* left to other builds, most of it names what this one does without */
#else
#define SP__LONG_TEXT(text) text
#endif

/* The k-th of zero-terminated words that follow each other: no table of pointers, so nothing to relocate. */
static const char *sp__word(const char *words, int k)
{
    for (; k > 0; k--) {
        while (*words) words++;
        words++;
    }
    return words;
}

/* In the order of the enumerators of stonepack.h. */
SP_API const char *sp_status_text(sp_status status)
{
    const int k = -(int)status;
    return sp__word("no error\0"
                    "bad argument" SP__LONG_TEXT(": a null pointer, a negative count or an unknown choice") "\0"
                    "not enough memory" SP__LONG_TEXT(" in the arena") "\0"
                    "the scene is full\0"
                    SP__LONG_TEXT("a number is ") "infinite" SP__LONG_TEXT(", not a number, or too large to be squared") "\0"
                    SP__LONG_TEXT("a block, vertex or joint of ") "that number does not exist\0"
                    SP__LONG_TEXT("a number is ") "outside its range\0"
                    "the mesh is open" SP__LONG_TEXT(": an edge lacks its opposite") "\0"
                    SP__LONG_TEXT("the mesh is inside out: ") "its faces look inward\0"
                    "the mesh encloses no volume" SP__LONG_TEXT(", or a face has fewer than three corners") "\0"
                    "a face is out of plane\0"
                    "the joint" SP__LONG_TEXT(" polygon") " is out of plane\0"
                    "the joint has no area" SP__LONG_TEXT(", or its normal no length") "\0"
                    SP__LONG_TEXT("a joint ") "between a block and itself\0"
                    SP__LONG_TEXT("the scene has ") "no block\0"
                    "not supported here"
                    SP__LONG_TEXT(": strength of joints with the coupled check, or a part this build leaves out") "\0"
                    "P" SP__LONG_TEXT(" of the quadratic program") " is not positive semidefinite\0"
                    "unknown status", k >= 0 && k <= 16 ? k : 17);
}

#endif /* SP__BASE_WORDS_C */
