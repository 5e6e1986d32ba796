/* board: what a simulated board gives a program: text out, bytes in, an exit status, a count of instructions, the depth of its
 * stack. All of it by semihosting and the processor's own counters; no C library. */
#ifndef BOARD_H
#define BOARD_H

#include <stdint.h>

/* printf without locale or rounding finesse: d i u x c s g e f %, l ll, width, precision, - and 0. */
int board_print(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* A file of the simulating machine, to be read: its handle, -1 where there is none. */
long board_open(const char *name);

/* A line of it into text (cap bytes, always terminated, without its end). Returns its length, -1 at the end. */
int board_line(long from, char *text, int cap);

void board_exit(int status) __attribute__((noreturn));

/* Instructions since the start: exact on RISC-V and AArch64, to within one tick (40 or 50 of them) on Cortex-M. Counts truly
 * only under `qemu -icount shift=0`. */
uint64_t board_instructions(void);

/* Stack: paint what is free below the caller; how deep it has been since, in bytes below the caller of board_paint. */
void board_paint(void);
unsigned board_depth(void);

/* Of the start-up code, one per architecture. */
long board_call(long operation, const void *block);     /* semihosting */
extern char board_bss[], board_bss_end[], board_data[], board_data_end[], board_data_from[], board_stack[];
void board_main(void) __attribute__((noreturn));        /* called with a stack; data and bss not yet set */
void board_fault(const char *what, unsigned long why) __attribute__((noreturn));
void board_count(void);                                 /* start the counter of instructions */

#endif /* BOARD_H */
