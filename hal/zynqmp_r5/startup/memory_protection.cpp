// Sets up the memory protection unit and the caches; start.S calls it before any constructor.
#include "hal/zynqmp_r5/memory_protection.hpp"

namespace {

using namespace rsi::hal::zynqmp_r5;

void set_region(std::uint32_t number, std::uint32_t start, std::uint32_t access, std::uint32_t size) {
    asm volatile("mcr p15, 0, %0, c6, c2, 0" : : "r"(number));
    asm volatile("mcr p15, 0, %0, c6, c1, 2" : : "r"(0U));  // off, while it is set
    asm volatile("mcr p15, 0, %0, c6, c1, 0" : : "r"(start));
    asm volatile("mcr p15, 0, %0, c6, c1, 4" : : "r"(access));
    asm volatile("mcr p15, 0, %0, c6, c1, 2" : : "r"(size));
}

}  // namespace

extern "C" void zynqmp_r5_protect_memory() {
    constexpr std::uint32_t region_count = 16U;
    static_assert(regions.size() <= region_count);
    for (std::uint32_t number = 0U; number < region_count; ++number) {
        if (number < regions.size()) {
            const Region& region = regions[number];
            set_region(number, region.start, static_cast<std::uint32_t>(region.access),
                       size_and_enable(region));
        } else {
            set_region(number, 0U, 0U, 0U);
        }
    }
    // SCTLR: protection unit (bit 0), data cache (2), instruction cache (12); start.S has invalidated the
    // caches and switched off the background region (17), so what no region holds is out of bounds.
    constexpr std::uint32_t on = (1U << 0U) | (1U << 2U) | (1U << 12U);
    std::uint32_t control = 0U;
    asm volatile("dsb" : : : "memory");
    asm volatile("mrc p15, 0, %0, c1, c0, 0" : "=r"(control));
    asm volatile("mcr p15, 0, %0, c1, c0, 0" : : "r"(control | on));
    asm volatile("dsb\n isb" : : : "memory");
}
