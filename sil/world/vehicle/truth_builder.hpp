// Truth builder: states and forces of the vehicle as the quantities that others read.
#pragma once

#include "sil/world/vehicle/evaluation.hpp"
#include "sil/world/vehicle/parameters.hpp"
#include "sil/world/vehicle/state.hpp"
#include "sil/world/vehicle/suspension.hpp"
#include "sil/world/vehicle/truth.hpp"

namespace sil {

Truth build_truth(const VehicleParameters& parameters, const FrontWheelPath& front_path, const State& state,
                  const Evaluation& evaluation);

}  // namespace sil
