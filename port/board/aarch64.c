/* aarch64: start-up of 64-bit Arm, in the exception level it wakes in (EL1), without an MMU: no unaligned access. */
#include "board.h"

__attribute__((used, noreturn)) static void fault(void)
{
    unsigned long why;
    __asm__ volatile ("mrs %0, esr_el1" : "=r"(why));
    board_fault("fault: ESR", why);
}

__asm__(".section .vectors, \"ax\"\n"
        ".global board_reset\n"
        "board_reset:\n\t"
        "ldr x0, =board_stack\n\tmov sp, x0\n\t"
        "mov x0, #0x300000\n\tmsr cpacr_el1, x0\n\t"    /* floating point */
        "ldr x0, =traps\n\tmsr vbar_el1, x0\n\tisb\n\t"
        "b board_main\n\t"
        ".balign 2048\n"
        "traps:\n"
        ".rept 16\n\tb fault\n\t.balign 128\n.endr\n"
        ".text\n");

long board_call(long operation, const void *block)
{
    register long x0 __asm__("x0") = operation;
    register const void *x1 __asm__("x1") = block;
    __asm__ volatile ("hlt #0xf000" : "+r"(x0) : "r"(x1) : "memory");
    return x0;
}

/* Event 8 of the performance counters: instructions. */
void board_count(void)
{
    __asm__ volatile ("msr pmevtyper0_el0, %0\n\tmsr pmcntenset_el0, %1\n\tmsr pmcr_el0, %1\n\tisb" :: "r"(8ul), "r"(1ul));
}

uint64_t board_instructions(void)
{
    uint64_t n;
    __asm__ volatile ("isb\n\tmrs %0, pmevcntr0_el0" : "=r"(n));
    return n;
}
