/* Emulator only: what the first-stage boot loader does on silicon. The first A53 core of QEMU's xlnx-zcu102 starts
 * here (-device loader,...,cpu-num=0), releases the first R5 core at the image's entry by PSCI, and sleeps. */
    .global _start
_start:
    ldr x0, =0xC4000003                 // PSCI CPU_ON
    mov x1, #4                          // the first R5 core, after four A53
    mov x2, #0x00100000                 // entry of the image
    smc #0
sleep:
    wfi
    b sleep
