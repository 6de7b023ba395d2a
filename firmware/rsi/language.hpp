// The C++ headers and sources are C++17, and an older one is refused. Callers of rsi.h may have any.
#pragma once

#if __cplusplus < 201703L
#error "compile the component, and all that includes its C++ headers, as C++17 or newer: -std=c++17"
#endif
