/* Frama-C Eva: what the smallest build alone has, of any numbers at all. */
#define SP_SMALL
#include "eva.h"
#include "../../solvers/base/words.c"
#include "../../solvers/linear/envelope.c"

enum { ROWS = 5 };

/* Rows from given columns on, and from the first on. */
void eva_envelope(void)
{
    static const int32_t row[ROWS] = { 0, 1, 2, 5, 7 };                 /* rows begin at columns 0, 0, 2, 1, 3 */
    static sp_real e[ROWS * (ROWS + 1) / 2], x[ROWS];
    for (int whole = 0; whole < 2; whole++) {
        any_numbers(e, ROWS * (ROWS + 1) / 2);
        any_numbers(x, ROWS);
        sp__envelope_factor(e, whole ? NULL : row, ROWS, any());
        sp__envelope_solve(e, whole ? NULL : row, ROWS, x);
    }
}
