// Vehicle batch: several vehicles that step together, computed in the lanes of the processor's vector
// registers.
#pragma once

#include <array>
#include <cstddef>
#include <memory>

#include "sil/world/vehicle/driver_input.hpp"
#include "sil/world/vehicle/lane_count.hpp"

namespace sil {

class Vehicle;
struct LaneStep;

// The vehicles are those of their owners, of any parameters, on any roads and at any times; each goes on as
// if it were alone, to the bit. No heap use and no exception after construction.
class VehicleBatch {
 public:
    static constexpr std::size_t lane_count = sil::lane_count;

    VehicleBatch();  // by the best of this machine
    explicit VehicleBatch(const LaneStep& step);
    ~VehicleBatch();
    VehicleBatch(const VehicleBatch&) = delete;
    VehicleBatch& operator=(const VehicleBatch&) = delete;

    // From now on the vehicle steps in this lane, which must be empty, and not by its own step(). It must
    // stay where it is until it has left.
    void enter(std::size_t lane, Vehicle& vehicle);

    // Gives the vehicle in this lane its state, so that it may go on alone.
    void leave(std::size_t lane);

    // As Vehicle::step(), for every vehicle that is in; inputs of empty lanes do not matter. The truth's
    // attitude but for roll and yaw, suspension, wheel gaps, lateral tyre force and roll centres cost a tenth
    // of a step: NaN unless they are `wanted`.
    enum class TruthWanted { motion, all };
    void step(const std::array<DriverInput, lane_count>& inputs, double step_s, TruthWanted wanted);

 private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace sil
