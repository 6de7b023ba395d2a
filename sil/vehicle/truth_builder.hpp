// Truth builder: states and forces of the vehicle as the quantities that others read.
#pragma once

#include "sil/vehicle/evaluation.hpp"
#include "sil/vehicle/parameters.hpp"
#include "sil/vehicle/state.hpp"
#include "sil/vehicle/suspension.hpp"
#include "sil/vehicle/truth.hpp"

namespace sil {

Truth build_truth(const VehicleParameters& parameters, const FrontWheelPath& front_path, const State& state,
                  const Evaluation& evaluation);

}  // namespace sil
