/* Linker script of the image; the C preprocessor puts the memory map in. */
#include "hal/zynqmp_r5/memory_map.h"

ENTRY(start)

MEMORY
{
    VECTORS    (rx) : ORIGIN = RSI_VECTORS_START, LENGTH = RSI_VECTORS_SIZE
    CODE       (rx) : ORIGIN = RSI_CODE_START, LENGTH = RSI_CODE_SIZE
    PARAMETERS (r)  : ORIGIN = RSI_PARAMETERS_START, LENGTH = RSI_PARAMETERS_SIZE
    DATA       (rw) : ORIGIN = RSI_DATA_START, LENGTH = RSI_DATA_SIZE
    RETAINED   (rw) : ORIGIN = RSI_RETAINED_START, LENGTH = RSI_RETAINED_SIZE
}

/* Data cleared at every start, or kept over it, belong to no segment: nothing of it is loaded. */
PHDRS
{
    vectors PT_LOAD FLAGS(5);
    code PT_LOAD FLAGS(5);
    parameters PT_LOAD FLAGS(4);
    data PT_LOAD FLAGS(6);
}

SECTIONS
{
    .boot_vectors :
    {
        KEEP(*(.boot_vectors))
    } > VECTORS :vectors

    .code :
    {
        KEEP(*(.start))
        *(.text .text.*)
        *(.rodata .rodata.*)
        . = ALIGN(4);
        init_array_start = .;
        KEEP(*(SORT_BY_INIT_PRIORITY(.init_array.*)))
        KEEP(*(.init_array))
        init_array_end = .;
    } > CODE :code

    /* Apart from the code, behind which the linker puts what leads from short instructions to long ones. */
    .vectors_load :
    {
        vectors_load = .;
        KEEP(*(.vectors))
        . = ALIGN(4);
        vectors_load_end = .;
    } > CODE :code
    vectors_start = RSI_VECTORS_START;
    vectors_end = vectors_start + (vectors_load_end - vectors_load);

    /* Filled with what erased flash memory holds. */
    .parameters : 
    {
        parameters_start = .;
        KEEP(*(.parameters))
        FILL(0xFFFFFFFF)
        . = RSI_PARAMETERS_SIZE;
        parameters_end = .;
    } > PARAMETERS :parameters

    .data :
    {
        data_start = .;
        *(.data .data.*)
        . = ALIGN(4);
        data_end = .;
    } > DATA AT > CODE :data
    data_load = LOADADDR(.data);

    .bss (NOLOAD) :
    {
        bss_start = .;
        *(.bss .bss.* COMMON)
        . = ALIGN(4);
        bss_end = .;
    } > DATA :NONE

    .retained (NOLOAD) :
    {
        KEEP(*(.retained))
        retained_end = .;
    } > RETAINED :NONE

    fault_stack_bottom = RSI_FAULT_STACK_BOTTOM;
    fault_stack_top = RSI_FAULT_STACK_TOP;
    main_stack_bottom = RSI_MAIN_STACK_BOTTOM;
    main_stack_top = RSI_MAIN_STACK_TOP;

    /* Nothing unwinds: there are no exceptions. */
    /DISCARD/ : { *(.ARM.exidx* .ARM.extab* .eh_frame*) }
}

ASSERT(start == RSI_CODE_START, "image.ld: the entry is not at the start of the code")
ASSERT(data_load + SIZEOF(.data) <= RSI_CODE_START + RSI_CODE_SIZE, "image.ld: code and initial data exceed RSI_CODE_SIZE")
ASSERT(vectors_end <= RSI_VECTORS_START + RSI_VECTORS_SIZE, "image.ld: the vectors exceed RSI_VECTORS_SIZE")
ASSERT(bss_end <= RSI_DATA_START + RSI_DATA_SIZE, "image.ld: the data exceeds RSI_DATA_SIZE")
ASSERT(SIZEOF(.parameters) == RSI_PARAMETERS_SIZE, "image.ld: the parameters exceed their page")
ASSERT(retained_end <= RSI_RETAINED_FREE, "image.ld: the retained data reaches RSI_RETAINED_FREE")
ASSERT(RSI_CODE_START + RSI_CODE_SIZE <= RSI_PARAMETERS_START, "image.ld: code and parameters overlap")
ASSERT(RSI_PARAMETERS_START + RSI_PARAMETERS_SIZE <= RSI_DATA_START, "image.ld: parameters and data overlap")
ASSERT(RSI_DATA_START + RSI_DATA_SIZE <= RSI_STACKS_START, "image.ld: data and stacks overlap")
ASSERT(RSI_STACKS_START + RSI_STACKS_SIZE <= RSI_RETAINED_START, "image.ld: stacks and retained data overlap")
