@ Functions for path_bound_test.py, for both kinds of instructions. Bounds in comments are counted by hand.
    .syntax unified
    .text
    .macro begin name
    .global \name
    .type \name, %function
\name:
    .endm
    .macro finish name
    .size \name, . - \name
    .endm

begin either_side  @ 6: the longer side
    cmp r0, #0
    beq 1f
    adds r0, r0, #1
    bx lr
1:  adds r0, r0, #2
    adds r0, r0, #3
    adds r0, r0, #4
    bx lr
finish either_side

begin counted_down  @ 2 + 5 * 3 + 1
    movs r3, #5
    movs r2, #0
1:  adds r2, r2, r3
    subs r3, r3, #1
    bne 1b
    bx lr
finish counted_down

begin tested_first  @ 1 + 5 * 2 + 4 * 2 + 1: the fifth test ends it
    movs r3, #5
1:  subs r3, r3, #1
    beq 2f
    adds r0, r0, #1
    b 1b
2:  bx lr
finish tested_first

begin to_an_address  @ 3 + 4 * 3 + 1
    mov r1, r0
    add r2, r1, #16
    mov r3, r0
1:  ldr r0, [r3], #4
    cmp r3, r2
    bne 1b
    bx lr
finish to_an_address

begin compared_before  @ 1 + 4 * 4 + 2 + 1: the fifth comparison ends it
    movs r3, #0
1:  cmp r3, #4
    beq 2f
    adds r3, r3, #1
    b 1b
2:  bx lr
finish compared_before

begin begins_at_either  @ 3 + 1 + 9 * 2 + 1
    movs r3, #5
    cmp r0, #0
    beq 1f
    movs r3, #9
1:  subs r3, r3, #1
    bne 1b
    bx lr
finish begins_at_either

begin two_counters  @ 2 + 5 * 4 + 1: the first ends it, but the other way out is as near
    movs r3, #5
    movs r2, #9
1:  subs r3, r3, #1
    beq 2f
    subs r2, r2, #1
    bne 1b
2:  bx lr
finish two_counters

begin two_ways_out  @ 1 + 3 * 10 + 9 + 1, with four turns by its entry
    movs r3, #4
1:  cmp r0, #0
    beq 3f
    subs r3, r3, #1
    bne 1b
2:  bx lr
3:  adds r0, r0, #1
    adds r0, r0, #2
    adds r0, r0, #3
    adds r0, r0, #4
    adds r0, r0, #5
    cmp r1, #0
    beq 2b
    b 1b
finish two_ways_out

begin nested  @ 1 + 2 * (1 + 3 * 3 + 2) + 1
    movs r1, #2
1:  movs r2, #3
2:  adds r0, r0, #1
    subs r2, r2, #1
    bne 2b
    subs r1, r1, #1
    bne 1b
    bx lr
finish nested

begin left_from_within  @ 1 + 9 * 4 + 2 + 4: nine whole turns, and out of the tenth by the longer way
    movs r3, #10
1:  cmp r0, r3
    beq 2f
    subs r3, r3, #1
    bne 1b
    bx lr
2:  adds r0, r0, #1
    adds r0, r0, #2
    adds r0, r0, #3
    bx lr
finish left_from_within

begin calls  @ 1 + 3 * (1 + 18 + 2) + 1
    push {r4, lr}
    movs r4, #3
1:  bl counted_down
    subs r4, r4, #1
    bne 1b
    pop {r4, pc}
finish calls

begin ends_with_a_jump  @ 2 + 18: the other returns in its place
    adds r0, r0, #1
    b counted_down
finish ends_with_a_jump

begin copy  @ 1 + 2 * r2
1:  subs r2, r2, #1
    bne 1b
    bx lr
finish copy

begin copies  @ 1 + 1 + 1 + 13 + 1 + 1 + 9 + 1
    push {r4, lr}
    movs r2, #6
    bl copy
    movs r2, #4
    bl copy
    pop {r4, pc}
finish copies

begin to_a_literal  @ 2 + 4 * 3 + 1
    ldr r3, =0x12345670
    ldr r2, =0x12345680
1:  ldr r0, [r3], #4
    cmp r3, r2
    bne 1b
    bx lr
    .ltorg
finish to_a_literal

begin copies_some
    push {r4, lr}
    bl copy
    pop {r4, pc}
finish copies_some

begin data_decides
1:  subs r0, r0, #1
    bne 1b
    bx lr
finish data_decides

begin grows_unevenly
    movs r3, #8
1:  cmp r0, #0
    beq 2f
    subs r3, r3, #1
2:  subs r3, r3, #1
    bne 1b
    bx lr
finish grows_unevenly

begin passes_its_end
    movs r3, #7
1:  subs r3, r3, #2
    cmp r3, #0
    bne 1b
    bx lr
finish passes_its_end

begin begins_at_either_by_then
    movs r3, #5
    cmp r0, #0
    beq 2f
    movs r3, #9
2:  adds r0, r0, #1
1:  subs r3, r3, #1
    bne 1b
    bx lr
finish begins_at_either_by_then

begin counts_at_times
    movs r3, #8
1:  cmp r0, #0
    beq 2f
    subs r3, r3, #1
2:  cmp r3, #0
    bne 1b
    bx lr
finish counts_at_times

begin counts_a_load_at_times
    mov r3, r0
    add r2, r0, #16
1:  cmp r1, #0
    it ne
    ldrne r1, [r3], #4
    cmp r3, r2
    bne 1b
    bx lr
finish counts_a_load_at_times

begin wraps
    movs r3, #0
1:  adds r3, r3, #1
    cmp r3, #0
    bne 1b
    bx lr
finish wraps

begin goes_on_if_equal
    movs r3, #3
1:  adds r3, r3, #1
    cmp r3, #4
    bne 2f
    adds r0, r0, #1
    bne 1b
2:  bx lr
finish goes_on_if_equal

begin tested_at_times
    movs r3, #8
1:  subs r3, r3, #1
    cmp r0, #0
    beq 2f
    cmp r3, #0
    beq 3f
2:  adds r0, r0, #1
    bne 1b
3:  bx lr
finish tested_at_times

begin counts_in_an_inner_loop
    movs r3, #9
1:  movs r2, #2
2:  subs r3, r3, #1
    subs r2, r2, #1
    bne 2b
    cmp r3, #0
    bne 1b
    bx lr
finish counts_in_an_inner_loop

begin end_moves
    movs r2, #4
    movs r3, #0
1:  adds r3, r3, #1
    adds r2, r2, #2
    cmp r3, r2
    bne 1b
    bx lr
finish end_moves

begin ends_elsewhere
    mov r3, r0
    add r2, r1, #16
1:  ldr r0, [r3], #4
    cmp r3, r2
    bne 1b
    bx lr
finish ends_elsewhere

begin counter_is_lost
    push {r4, lr}
    movs r3, #5
1:  bl counted_down
    subs r3, r3, #1
    bne 1b
    pop {r4, pc}
finish counter_is_lost

begin counter_is_lost_at_times
    push {r4, lr}
    movs r3, #5
1:  cmp r0, #0
    it ne
    blne counted_down
    subs r3, r3, #1
    bne 1b
    pop {r4, pc}
finish counter_is_lost_at_times

begin another_result_ends_it
    movs r3, #5
1:  subs r3, r3, #1
    cmp r3, #0
    it ne
    subsne r0, r0, r1, lsl #1
    bne 1b
    bx lr
finish another_result_ends_it

begin by_pointer
    push {r4, lr}
    blx r0
    pop {r4, pc}
finish by_pointer

begin anywhere
    adds r1, r1, #1
    bx r0
finish anywhere

begin calls_itself
    push {r4, lr}
    bl calls_itself
    pop {r4, pc}
finish calls_itself

begin two_entries
    cmp r0, #0
    beq 2f
1:  adds r0, r0, #1
2:  subs r0, r0, #3
    bne 1b
    bx lr
finish two_entries

begin forever
    b forever
finish forever

begin runs_on
    adds r0, r0, #1
finish runs_on

begin calls_the_system
    svc #0
    bx lr
finish calls_the_system
