#include "sil/simulation/run_batch.hpp"

namespace sil {

bool RunBatch::begin(std::size_t lane, InProcessRun& run, RunObserver& observer) {
    if (!run.loop().exchange(observer)) {
        return false;
    }
    vehicles_.enter(lane, run.plant().vehicle_to_step());
    members_[lane] = {&run, &observer};
    return true;
}

std::array<bool, RunBatch::lane_count> RunBatch::cycle() {
    for (int step = 0; step < ClosedLoop::steps_per_cycle; ++step) {
        // Sensors and observers see whole values at the end of a cycle.
        step_vehicles(step + 1 < ClosedLoop::steps_per_cycle ? VehicleBatch::TruthWanted::motion
                                                             : VehicleBatch::TruthWanted::all);
    }
    std::array<bool, lane_count> ended{};
    for (std::size_t lane = 0U; lane < lane_count; ++lane) {
        lane_at_work_ = lane;
        Member& one = members_[lane];
        if (one.run != nullptr && !one.run->loop().exchange(*one.observer)) {
            vehicles_.leave(lane);
            one = {};
            ended[lane] = true;
        }
    }
    return ended;
}

void RunBatch::step_vehicles(VehicleBatch::TruthWanted wanted) {
    for (std::size_t lane = 0U; lane < lane_count; ++lane) {
        lane_at_work_ = lane;
        if (members_[lane].run != nullptr) {
            inputs_[lane] = members_[lane].run->plant().next_input();
        }
    }
    vehicles_.step(inputs_, Vehicle::nominal_step_s, wanted);
    for (std::size_t lane = 0U; lane < lane_count; ++lane) {
        lane_at_work_ = lane;
        const Member& one = members_[lane];
        if (one.run != nullptr) {
            one.run->loop().see_step(*one.observer);
        }
    }
}

}  // namespace sil
