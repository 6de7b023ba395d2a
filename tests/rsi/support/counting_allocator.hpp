// Counts every use of the heap in this program: malloc and its kin are replaced, operator new calls them.
#pragma once

namespace rsi_test {

// Calls to malloc, calloc, realloc, aligned allocation and free of something since the program's start.
unsigned long heap_calls();

}  // namespace rsi_test
