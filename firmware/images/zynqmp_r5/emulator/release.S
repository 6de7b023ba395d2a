/* Emulator only: the supervisor, a program on the first A53 core of QEMU's xlnx-zcu102
 * (-device loader,file=release-r5.elf,cpu-num=0). It stands in for three parts of the silicon: the boot loader, which
 * releases the R5 core; the watchdog, and the platform management unit, which resets.
 *
 * A word in memory (RSI_SUPERVISOR_COUNTDOWN) counts down every RSI_SUPERVISOR_PERIOD_MS while it is not zero, and the
 * machine is reset when it comes to zero. (Every millisecond would cost the emulator too much.) hal/zynqmp_r5/emulator/supervisor.hpp is the R5's side. */
#include "hal/zynqmp_r5/emulator/supervisor_words.h"

    .equ psci_cpu_on, 0xC4000003
    .equ psci_system_reset, 0x84000009
    .equ distributor, 0xF9010000        // interrupt controller of the A53 cores
    .equ cpu_interface, 0xF9020000
    .equ virtual_timer_interrupt, 27

    .global _start
_start:
    ldr x20, =RSI_SUPERVISOR_COUNTDOWN
    str wzr, [x20]                      // content of an earlier run does not count

    ldr x0, =psci_cpu_on
    mov x1, #4                          // the first R5 core, after four A53
    ldr x2, =RSI_CODE_START             // entry of the image
    mov x3, #0
    smc #0

    /* The virtual timer wakes the core from wfi; its interrupt stays masked, so no handler is needed. */
    ldr x1, =distributor
    mov w2, #1
    str w2, [x1]
    mov w2, #(1 << virtual_timer_interrupt)
    str w2, [x1, #0x100]
    ldr x1, =cpu_interface
    mov w2, #0xFF
    str w2, [x1, #4]
    mov w2, #1
    str w2, [x1]

    mrs x21, cntfrq_el0
    mov x2, #(1000 / RSI_SUPERVISOR_PERIOD_MS)
    udiv x21, x21, x2                   // timer periods of one count
    mov x2, #1
    msr cntv_tval_el0, x21
    msr cntv_ctl_el0, x2

wait:
    wfi
    mrs x2, cntv_ctl_el0
    tbz x2, #2, wait                    // not yet
    msr cntv_tval_el0, x21
    isb
    /* Exclusively: the R5 feeds it or asks for a reset at any time, and neither may be overwritten. */
count_down:
    ldxr w2, [x20]
    cbz w2, wait
    sub w2, w2, #1
    stxr w3, w2, [x20]
    cbnz w3, count_down
    cbnz w2, wait

    ldr x0, =psci_system_reset
    smc #0
    b wait
