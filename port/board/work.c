/* Built without what it counts for. */
#include "work.h"

void __sanitizer_cov_trace_pc(void);

jmp_buf work_too_much;
uint64_t work_steps, work_end;

void __sanitizer_cov_trace_pc(void)
{
    if (++work_steps != work_end) return;
    longjmp(work_too_much, 1);
}
