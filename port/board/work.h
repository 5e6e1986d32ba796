/* work: counts the steps, pieces of code without a jump, that a program built with -fsanitize-coverage=trace-pc goes through:
 * the same number on every run. Of a test that takes more than WORK_MOST of them nothing more is asked. */
#ifndef WORK_H
#define WORK_H

#include <setjmp.h>
#include <stdint.h>

#ifndef WORK_MOST
#define WORK_MOST 100000000
#endif

extern jmp_buf work_too_much;
extern uint64_t work_steps, work_end;

/* 0: go on; 1: the test that was started so has taken WORK_MOST steps. */
#define WORK_START() (work_end = work_steps + WORK_MOST, setjmp(work_too_much))

#endif /* WORK_H */
