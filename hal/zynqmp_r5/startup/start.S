/* Reset and exception vectors of the Cortex-R5F.
 *
 * The core has no vector base register: its vectors lie at address 0 (SCTLR.V = 0), in the ATCM on silicon. The
 * image keeps a copy of them beside its code and puts it there at every start, whatever has become of them. */
    .syntax unified
    .arm

    .equ mode_fiq, 0x11
    .equ mode_irq, 0x12
    .equ mode_supervisor, 0x13
    .equ mode_abort, 0x17
    .equ mode_undefined, 0x1B
    .equ mode_system, 0x1F

    .equ sctlr_mpu, (1 << 0)
    .equ running_mark, 0x52534952       @ "RSIR"
    .equ sctlr_off, (1 << 0) | (1 << 1) | (1 << 2) | (1 << 12) | (1 << 13) | (1 << 17) | (1 << 30)

/* The vectors load their targets from the words behind them, so that the block can be copied as it is. */
    .macro vector_table
    ldr pc, 1f
    ldr pc, 2f
    ldr pc, 3f
    ldr pc, 4f
    ldr pc, 5f
    ldr pc, 6f
    ldr pc, 7f
    ldr pc, 8f
1:  .word start
2:  .word on_undefined
3:  .word on_supervisor_call
4:  .word on_prefetch_abort
5:  .word on_data_abort
6:  .word on_reserved
7:  .word on_interrupt
8:  .word on_fast_interrupt
    .endm

    .section .vectors, "ax"
    .global vectors
    .type vectors, %object
vectors:
    vector_table
    .size vectors, . - vectors

/* For a loader that puts them to address 0 itself: on silicon the core's first fetch after its release is from there. */
    .section .boot_vectors, "ax"
    vector_table

/* The first instruction of the image, at its lowest address: the entry for the loader that releases the core. */
    .section .start, "ax"
    .weak zynqmp_r5_protect_memory
    .global start
    .type start, %function
start:
    /* A call of a null pointer comes here too, by the vector at 0, while the firmware runs. Two things together distinguish
     * it from a start after a reset: the MPU is on, which a reset switches off (a boot loader may have switched it on), and
     * the thread register holds the mark of a running firmware (which a reset need not clear). */
    mrs r2, cpsr
    cpsid aif
    mrc p15, 0, r0, c1, c0, 0           @ SCTLR
    mrc p15, 0, r1, c13, c0, 4          @ TPIDRPRW
    mov r3, #0
    mcr p15, 0, r3, c13, c0, 4          @ only once: this can be no endless loop of resets
    tst r0, #sctlr_mpu
    beq after_reset
    ldr r3, =running_mark
    cmp r1, r3
    bne after_reset
    sub r1, lr, #4
    mov r0, #8                          @ a kind of its own, of what zynqmp_r5_on_exception is told
    b report

after_reset:
    mrc p15, 0, r0, c1, c0, 0           @ SCTLR: MPU, caches, alignment check, high vectors, background region, Thumb
    ldr r1, =sctlr_off                  @ exceptions off, whatever ran before
    bic r0, r0, r1
    mcr p15, 0, r0, c1, c0, 0
    isb
    mov r0, #0
    mcr p15, 0, r0, c7, c5, 0           @ ICIALLU: instruction cache, all
    mcr p15, 0, r0, c15, c5, 0          @ data cache, all
    dsb
    isb

    /* Every exception ends in a reset, so they share one stack. */
    ldr r0, =fault_stack_top
    cps #mode_fiq
    mov sp, r0
    cps #mode_irq
    mov sp, r0
    cps #mode_supervisor
    mov sp, r0
    cps #mode_abort
    mov sp, r0
    cps #mode_undefined
    mov sp, r0
    cps #mode_system
    ldr sp, =main_stack_top

    mrc p15, 0, r0, c1, c0, 2           @ CPACR: full access to coprocessors 10 and 11
    orr r0, r0, #0x00F00000
    mcr p15, 0, r0, c1, c0, 2
    isb
    mov r0, #0x40000000                 @ FPEXC.EN
    vmsr fpexc, r0
    mov r0, #0                          @ FPSCR: round to nearest, subnormals kept, no traps
    vmsr fpscr, r0

    ldr r0, =vectors_start
    ldr r1, =vectors_load
    ldr r2, =vectors_end
    bl copy_words
    ldr r0, =data_start
    ldr r1, =data_load
    ldr r2, =data_end
    bl copy_words
    ldr r0, =bss_start
    ldr r1, =bss_end
    mov r2, #0
    bl fill_words
    ldr r0, =fault_stack_bottom
    ldr r1, =fault_stack_top
    ldr r2, =0x5A5A5A5A                 @ unused stack keeps this pattern, for a debugger
    bl fill_words
    ldr r0, =main_stack_bottom
    ldr r1, =main_stack_top
    bl fill_words

    ldr r0, =zynqmp_r5_protect_memory   @ a program without it runs unprotected
    cmp r0, #0
    blxne r0

    ldr r0, =running_mark
    mcr p15, 0, r0, c13, c0, 4          @ TPIDRPRW: see start
    cpsie a                             @ a write that the bus refuses later is a data abort too

    ldr r4, =init_array_start
    ldr r5, =init_array_end
construct:
    cmp r4, r5
    bhs constructed
    ldr r0, [r4], #4
    blx r0
    b construct
constructed:
    bl main
    udf #0                              @ main does not return
    .ltorg
    .size start, . - start

/* r0 to, r1 from, r2 end of `to`; all multiples of 4. */
    .type copy_words, %function
copy_words:
    cmp r0, r2
    ldrlo r3, [r1], #4
    strlo r3, [r0], #4
    blo copy_words
    bx lr
    .size copy_words, . - copy_words

/* r0 from, r1 end, r2 value. */
    .type fill_words, %function
fill_words:
    cmp r0, r1
    strlo r2, [r0], #4
    blo fill_words
    bx lr
    .size fill_words, . - fill_words

/* Every exception, and a start without reset, ends in zynqmp_r5_on_exception(kind, instruction, program status), which does not return. `lead` is how
 * far the link register is ahead of the instruction. An exception on the way there starts over on the same stack; the
 * handler notices that. */
    .macro exception name, kind, lead
    .type \name, %function
\name:
    sub r1, lr, #\lead
    mov r0, #\kind
    b report_exception
    .size \name, . - \name
    .endm

    exception on_undefined, 1, 4
    exception on_supervisor_call, 2, 4
    exception on_prefetch_abort, 3, 4
    exception on_data_abort, 4, 8
    exception on_reserved, 5, 0
    exception on_interrupt, 6, 4
    exception on_fast_interrupt, 7, 4

    .weak zynqmp_r5_on_exception
    .type report_exception, %function
report_exception:
    cpsid aif
    mrs r2, spsr
report:
    ldr sp, =fault_stack_top
    ldr r3, =zynqmp_r5_on_exception
    cmp r3, #0
    bxne r3
    b .                                 @ a program without handler stays here
    .ltorg
    .size report_exception, . - report_exception
