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

    // First cycle of a new run in `lane`, which must be empty. `run` and `observer` must outlive the run.
    // False when the run has already ended. Throws as run() does.
    bool begin(std::size_t lane, InProcessRun& run, RunObserver& observer);

    // Next cycle of every run; true for the lanes whose run has ended, which are then empty. Throws as run()
    // does; after that no run may be continued.
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
