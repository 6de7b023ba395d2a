// Vehicle draw: one plausible vehicle of the population, from seed and number alone.
#pragma once

#include <cstdint>
#include <string>

#include "sil/studies/population/properties.hpp"
#include "sil/studies/population/vehicle_class.hpp"
#include "sil/world/vehicle/parameters.hpp"

namespace sil {

// Constants of the warning may be chosen on the first half, results are reported on the second.
enum class PopulationHalf { choose, report };

struct DrawnVehicle {
    std::uint64_t number{0U};
    std::string name{};      // of its files, such as "bus-0007"
    std::size_t in_class{};  // index into vehicle_classes()
    PopulationHalf half{PopulationHalf::choose};
    unsigned attempt{0U};  // how many draws were refused before this one
    bool rigid_front{false};
    bool rigid_rear{false};
    VehicleParameters parameters{};
    VehicleProperties properties{};
};

// Every quantity has a random number of its own, so that a vehicle does not depend on how many there are.
// Classes take turns, and the halves by whole turns. An implausible draw is done again, up to 200 times;
// throws std::runtime_error with the last reason when none is plausible.
DrawnVehicle draw_vehicle(std::uint64_t seed, std::uint64_t number);

const char* half_name(PopulationHalf half);

// Empty, or the rule that the vehicle breaks, in words.
std::string implausible(const VehicleParameters& vehicle, const VehicleClass& from);

}  // namespace sil
