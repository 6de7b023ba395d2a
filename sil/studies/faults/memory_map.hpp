// Memory map: which part of the ECU a byte of its object belongs to.
#pragma once

#include <cstddef>
#include <vector>

namespace sil {

// A member of the ECU, or of its component. `length` bytes from `begin`, counted from the ECU's first byte.
struct MemoryPart {
    const char* name;
    std::size_t begin;
    std::size_t length;
    bool is_address;  // of another object: no value that a flip makes of it can be followed here
};

// In the order of the memory, without a gap: what follows a member up to the next belongs to it.
std::vector<MemoryPart> memory_map();

// The component, of which some of the parts are.
MemoryPart component_memory();

}  // namespace sil
