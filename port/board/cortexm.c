/* cortexm: start-up of Cortex-M. */
#include "board.h"

#ifndef BOARD_MHZ
#define BOARD_MHZ 25                                    /* clock of SysTick on the simulated board */
#endif

#define REGISTER(address) (*(volatile uint32_t *)(address))
#define SYST_CSR REGISTER(0xe000e010)
#define SYST_RVR REGISTER(0xe000e014)
#define SYST_CVR REGISTER(0xe000e018)
#define ICSR     REGISTER(0xe000ed04)
#define CFSR     REGISTER(0xe000ed28)
#define CPACR    REGISTER(0xe000ed88)
#define RELOAD   0xffffffu

void board_reset(void);

static void fault(void) { board_fault("fault: CFSR", CFSR); }

static volatile uint32_t wraps;

static void tick(void) { wraps++; }

__attribute__((used, section(".vectors"))) static const union { void (*handler)(void); const void *stack; } vector[16] = {
    { .stack = board_stack }, { board_reset }, { fault }, { fault }, { fault }, { fault }, { fault }, { 0 },
    { 0 }, { 0 }, { 0 }, { fault }, { fault }, { 0 }, { fault }, { tick }
};

__attribute__((noreturn)) void board_reset(void)
{
    CPACR |= 0xf << 20;                                 /* the FPU, where there is one */
    __asm__ volatile ("dsb\n\tisb" ::: "memory");
    board_main();
}

long board_call(long operation, const void *block)
{
    register long r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = block;
    __asm__ volatile ("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

void board_count(void)
{
    SYST_RVR = RELOAD;
    SYST_CVR = 0;
    SYST_CSR = 7;                                       /* on, with its interrupt, processor clock */
    while (SYST_CVR == 0) { }
}

/* With -icount shift=0 an instruction takes 1 ns. */
uint64_t board_instructions(void)
{
    uint32_t before, value;
    do before = wraps, value = SYST_CVR; while (before != wraps);
    return ((uint64_t)before * (RELOAD + 1u) + (RELOAD - value)) * 1000u / BOARD_MHZ;
}
