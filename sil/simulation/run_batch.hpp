// Run batch: several in-process runs driven together, their vehicles computed in one vector.
#pragma once

#include <array>
#include <cstddef>

#include "sil/simulation/in_process_run.hpp"
#include "sil/world/vehicle/vehicle_batch.hpp"

namespace sil {

// Each run has a lane of its own and goes on as InProcessRun::run() would drive it, to the bit, independent
// of the other lanes. All must step by Vehicle::nominal_step_s. Within a cycle, drivers and
// RunObserver::step() see of the truth what VehicleBatch calls motion.
class RunBatch {
 public:
    static constexpr std::size_t lane_count = VehicleBatch::lane_count;

    // The first cycle of a new run; it goes on in this lane, which must be empty. Both
    // must stay where they are until the run has ended. False when it already has. Throws what run() throws.
    bool begin(std::size_t lane, InProcessRun& run, RunObserver& observer);

    // The next cycle of every run; true for the lanes that are empty by it, their run having ended. Throws
    // the same; the runs are then not to be driven on.
    std::array<bool, lane_count> cycle();

    // The lane in which cycle() has thrown.
    std::size_t lane_at_work() const { return lane_at_work_; }

 private:
    struct Member {
        InProcessRun* run{nullptr};
        RunObserver* observer{nullptr};
    };

    void step_vehicles(VehicleBatch::TruthWanted wanted);

    VehicleBatch vehicles_{};
    std::array<Member, lane_count> members_{};
    std::array<DriverInput, lane_count> inputs_{};
    std::size_t lane_at_work_{0U};
};

}  // namespace sil
