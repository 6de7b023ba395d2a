// Lane keeping: a driver who holds speed and lane on a straight road along the x axis.
#pragma once

#include <functional>
#include <memory>

#include "sil/world/manoeuvres/manoeuvre.hpp"

namespace sil {

std::function<std::unique_ptr<Driver>(const VehicleParameters&)> lane_keeping();

}  // namespace sil
