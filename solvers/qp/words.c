/* words: text of a status of a quadratic program */
#ifndef SP__QP_WORDS_C
#define SP__QP_WORDS_C

#include "../base/words.c"

#ifndef SP_NO_QP
SP_API const char *sp_qp_status_text(sp_qp_status status)
{
    const int k = (int)status;
    return sp__word("solved\0" "inaccurate\0" "primal infeasible\0" "dual infeasible\0" "iteration limit\0" "budget\0" "numerical\0"
                    "unknown", k >= 0 && k <= 6 ? k : 7);
}
#endif

#endif /* SP__QP_WORDS_C */
