// Access to the registers of peripherals. The drivers take it as a type, so that tests can put a model of the
// registers in its place.
#pragma once

#include <cstdint>

namespace rsi::hal::zynqmp_r5 {

// An address of the real-time unit's map; all peripherals lie below 4 GiB.
using RegisterAddress = std::uint32_t;

struct MemoryMappedRegisters {
    std::uint32_t read(RegisterAddress address) const noexcept {
        return *reinterpret_cast<const volatile std::uint32_t*>(address);
    }
    void write(RegisterAddress address, std::uint32_t value) const noexcept {
        *reinterpret_cast<volatile std::uint32_t*>(address) = value;
    }
};

}  // namespace rsi::hal::zynqmp_r5
