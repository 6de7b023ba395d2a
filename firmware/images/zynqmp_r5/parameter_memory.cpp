#include "images/zynqmp_r5/ecu_image.hpp"

extern "C" const std::uint8_t parameters_start[];
extern "C" const std::uint8_t parameters_end[];

rsi::image::ParameterMemory rsi::image::parameter_memory() noexcept {
    return ParameterMemory{parameters_start, static_cast<std::size_t>(parameters_end - parameters_start)};
}
