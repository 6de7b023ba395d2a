@ Functions of Arm instructions, as common.s.
    .include "common.s"

begin conditional  @ 5
    cmp r0, #0
    moveq r0, #1
    bxne lr
    adds r0, r0, #1
    bx lr
finish conditional

begin table  @ 2 + 3: the higher ones leave by the branch behind the jump
    cmp r0, #2
    ldrls pc, [pc, r0, lsl #2]
    b 3f
    .word 3f, 2f, 1f
1:  adds r0, r0, #1
2:  adds r0, r0, #2
3:  bx lr
finish table

begin table_without_a_test
    ldr pc, [pc, r0, lsl #2]
    nop
    .word 1f, 1f
1:  bx lr
finish table_without_a_test

begin table_of_another_test
    cmp r0, #1
    cmp r1, #1
    ldrls pc, [pc, r0, lsl #2]
    bx lr
    .word 1f, 1f
1:  bx lr
finish table_of_another_test

begin table_of_the_higher_ones
    cmp r0, #1
    bhi 2f
    bx lr
2:  ldr pc, [pc, r0, lsl #2]
    nop
    .word 1f, 1f
1:  bx lr
finish table_of_the_higher_ones

begin table_without_a_guard
    cmp r0, #1
    ldr pc, [pc, r0, lsl #2]
    nop
    .word 1f, 1f
1:  bx lr
finish table_without_a_guard

begin table_past_its_test
    cmp r1, #0
    beq 5f
    cmp r0, #2
5:  ldrls pc, [pc, r0, lsl #2]
    b 1f
    .word 1f, 1f, 1f
1:  bx lr
finish table_past_its_test
