/* riscv: start-up of RISC-V, machine mode. */
#include "board.h"

/* Control registers are named only here, so that -march needs no _zicsr (which would choose the wrong libgcc). */
#define CSR(text) ".option push\n\t.option arch, +zicsr\n\t" text "\n\t.option pop"

__attribute__((used)) static void fault(void)
{
    unsigned long cause;
    __asm__ volatile (CSR("csrr %0, mcause") : "=r"(cause));
    board_fault("fault: mcause", cause);
}

__attribute__((naked, noreturn, section(".vectors"))) void board_reset(void)
{
    __asm__ volatile (CSR("la sp, board_stack\n\t"
                          "la t0, fault\n\t"
                          "csrw mtvec, t0\n\t"
                          "li t0, 0x2000\n\t"           /* mstatus.FS: the FPU, where there is one */
                          "csrs mstatus, t0\n\t"
                          "j board_main"));
}

long board_call(long operation, const void *block)
{
    register long a0 __asm__("a0") = operation;
    register const void *a1 __asm__("a1") = block;
    __asm__ volatile (".option push\n\t.option norvc\n\t.balign 16\n\t"
                      "slli x0, x0, 0x1f\n\tebreak\n\tsrai x0, x0, 7\n\t.option pop" : "+r"(a0) : "r"(a1) : "memory");
    return a0;
}

void board_count(void) { }

uint64_t board_instructions(void)
{
#if __riscv_xlen == 32
    uint32_t low, high, again;
    do __asm__ volatile (CSR("csrr %0, minstreth\n\tcsrr %1, minstret\n\tcsrr %2, minstreth") : "=r"(high), "=r"(low), "=r"(again));
    while (high != again);
    return ((uint64_t)high << 32) + low;
#else
    uint64_t n;
    __asm__ volatile (CSR("csrr %0, minstret") : "=r"(n));
    return n;
#endif
}
