// Registers of a fake device: what the drivers of hal/zynqmp_r5 get in place of the memory-mapped ones.
#pragma once

#include <cstdint>
#include <vector>

#include "hal/zynqmp_r5/registers.hpp"

namespace rsi::hal::zynqmp_r5::testing {

struct Write {
    RegisterAddress address;
    std::uint32_t value;
};

inline bool operator==(const Write& a, const Write& b) {
    return a.address == b.address && a.value == b.value;
}

// A device answers reads and acts on writes; every write is kept in its order.
class Device {
 public:
    virtual ~Device() = default;
    virtual std::uint32_t on_read(RegisterAddress address) = 0;
    virtual void on_write(RegisterAddress address, std::uint32_t value) = 0;

    std::vector<Write> writes;
    unsigned accesses{0U};
};

struct FakeRegisters {
    Device* device;

    std::uint32_t read(RegisterAddress address) const noexcept {
        ++device->accesses;
        return device->on_read(address);
    }
    void write(RegisterAddress address, std::uint32_t value) const noexcept {
        ++device->accesses;
        device->writes.push_back({address, value});
        device->on_write(address, value);
    }
};

}  // namespace rsi::hal::zynqmp_r5::testing
