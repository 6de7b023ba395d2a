/* Layout of rsi.h by a C compiler, once with and once without -fshort-enums. */
#ifndef TESTS_UNIT_ENUM_LAYOUT_H
#define TESTS_UNIT_ENUM_LAYOUT_H

#ifdef __cplusplus
extern "C" {
#endif

/* Writes the offset of each field of rsi_outputs, the sizes of all structures and, at the place that it
 * returns, the size of an enumeration; fewer than 100 numbers. */
unsigned layout_with_short_enums(unsigned* numbers);
unsigned layout_without_short_enums(unsigned* numbers);

#ifdef __cplusplus
}
#endif

#endif
