/* work: counts the blocks of instructions a program built with -fsanitize-coverage=trace-pc went through, without stopping a
 * clock: the same number on every run. Itself built without. */
#include <stdint.h>

void __sanitizer_cov_trace_pc(void);
uint64_t board_instructions(void);

static uint64_t blocks;

void __sanitizer_cov_trace_pc(void) { blocks++; }

uint64_t board_instructions(void) { return blocks; }
