@ Functions of Thumb instructions, as common.s.
    .include "common.s"

begin conditional  @ 6: all count, and the second return is the last
    cmp r0, #0
    ite eq
    moveq r0, #1
    bxne lr
    adds r0, r0, #1
    bx lr
finish conditional

begin table  @ 3 + 3
    cmp r0, #2
    bhi 3f
    tbb [pc, r0]
4:  .byte (3f - 4b) / 2, (2f - 4b) / 2, (1f - 4b) / 2
    .align 1
1:  adds r0, r0, #1
2:  adds r0, r0, #2
3:  bx lr
finish table

begin table_without_a_test
    tbb [pc, r0]
4:  .byte (1f - 4b) / 2, (1f - 4b) / 2
1:  bx lr
finish table_without_a_test

begin table_without_a_guard
    cmp r0, #1
    tbb [pc, r0]
4:  .byte (1f - 4b) / 2, (1f - 4b) / 2
1:  bx lr
finish table_without_a_guard

begin table_of_another_test
    cmp r0, #1
    cmp r1, #1
    bhi 1f
    tbb [pc, r0]
4:  .byte (1f - 4b) / 2, (1f - 4b) / 2
1:  bx lr
finish table_of_another_test

begin table_of_the_higher_ones
    cmp r0, #1
    bhi 2f
    bx lr
2:  tbb [pc, r0]
4:  .byte (1f - 4b) / 2, (1f - 4b) / 2
1:  bx lr
finish table_of_the_higher_ones

begin table_past_its_test
    cmp r1, #0
    beq 5f
    cmp r0, #2
    bhi 1f
5:  tbb [pc, r0]
4:  .byte (1f - 4b) / 2, (1f - 4b) / 2, (1f - 4b) / 2
    .align 1
1:  bx lr
finish table_past_its_test
