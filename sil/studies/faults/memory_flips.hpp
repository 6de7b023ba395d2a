// Memory flips: single bits of the ECU's object that change in the middle of a drive, and what becomes of the
// warning.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "rsi/types.hpp"
#include "sil/studies/faults/flip_effect.hpp"
#include "sil/studies/faults/memory_map.hpp"
#include "sil/world/vehicle/parameters.hpp"

namespace sil {

struct Flip {
    std::size_t drive{0U};
    std::size_t cycle{0U};  // the bit changes before it
    std::size_t byte{0U};   // of the ECU's object
    unsigned bit{0U};
    FlipEffect effect{};
};

struct MemoryFlips {
    std::vector<std::string> drives{};
    std::vector<MemoryPart> parts{};
    std::vector<Flip> flips{};
};

// `count` flips, drawn by `seed`: drive, moment, byte and bit, all equally likely; addresses of other objects
// are left out. Throws std::invalid_argument when the calibration is refused.
MemoryFlips run_memory_flips(const VehicleParameters& vehicle, const rsi::Parameters& calibration,
                             std::size_t count, std::uint64_t seed);

using FlipCount = std::array<std::size_t, flip_effect_count>;

// Counts of one part, of the component within the ECU, and of all.
FlipCount count_flips(const MemoryFlips& result, const MemoryPart& part);
FlipCount count_component_flips(const MemoryFlips& result);
FlipCount count_flips(const MemoryFlips& result);
std::size_t total(const FlipCount& count);
std::size_t silent(const FlipCount& count);

// One row a part, one of the component and one of all.
std::string memory_flips_table(const MemoryFlips& result);

// One line for each silent flip.
std::string silent_flips(const MemoryFlips& result);

}  // namespace sil
