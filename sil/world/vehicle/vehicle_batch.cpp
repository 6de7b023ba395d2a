#include "sil/world/vehicle/vehicle_batch.hpp"

#include <cstddef>
#include <cstring>

#include "sil/world/vehicle/lane_step.hpp"
#include "sil/world/vehicle/vehicle.hpp"

namespace sil {
namespace {

using OfOne = SteppedNumbers<double>;

// Offset of a part of the state among the numbers of one vehicle.
struct Part {
    std::size_t first;
    std::size_t count;
};
const Part model{offsetof(OfOne, model) / sizeof(double), sizeof(OfOne::model) / sizeof(double)};
const Part input{offsetof(OfOne, input) / sizeof(double), sizeof(OfOne::input) / sizeof(double)};
const Part truth{offsetof(OfOne, truth) / sizeof(double), sizeof(OfOne::truth) / sizeof(double)};

}  // namespace

std::vector<LaneStep> lane_steps() {
    std::vector<LaneStep> all;
#ifdef RSI_X86_LANE_STEPS
    const bool fused = __builtin_cpu_supports("fma");
    if (fused && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw")) {
        all.push_back(avx512_lane_step());
    }
    if (fused && __builtin_cpu_supports("avx2")) {
        all.push_back(avx2_lane_step());
    }
#endif
    all.push_back(portable_lane_step());
    return all;
}

struct VehicleBatch::State {
    LaneStep lane_step;
    alignas(lane_alignment) double numbers[stepped_number_count * lane_count];
    std::array<const Road*, lane_count> roads{};
    std::array<Vehicle*, lane_count> vehicles{};

    explicit State(const LaneStep& step) : lane_step{step} { lane_step.make(numbers); }

    void write(Part part, std::size_t lane, const void* one) {
        const auto* from = static_cast<const std::byte*>(one);
        double* to = numbers + part.first * lane_count + lane;
        for (std::size_t i = 0; i < part.count; ++i, to += lane_count, from += sizeof(double)) {
            std::memcpy(to, from, sizeof(double));
        }
    }
    void read(Part part, std::size_t lane, void* one) const {
        auto* to = static_cast<std::byte*>(one);
        const double* from = numbers + part.first * lane_count + lane;
        for (std::size_t i = 0; i < part.count; ++i, from += lane_count, to += sizeof(double)) {
            std::memcpy(to, from, sizeof(double));
        }
    }
};

VehicleBatch::VehicleBatch() : VehicleBatch{lane_steps().front()} {}
VehicleBatch::VehicleBatch(const LaneStep& step) : state_{std::make_unique<State>(step)} {}
VehicleBatch::~VehicleBatch() = default;

void VehicleBatch::enter(std::size_t lane, Vehicle& vehicle) {
    state_->write(model, lane, &vehicle.model_);
    state_->roads[lane] = &vehicle.road_;
    state_->vehicles[lane] = &vehicle;
}

void VehicleBatch::leave(std::size_t lane) {
    state_->read(model, lane, &state_->vehicles[lane]->model_);
    state_->roads[lane] = nullptr;
    state_->vehicles[lane] = nullptr;
}

void VehicleBatch::step(const std::array<DriverInput, lane_count>& inputs, double step_s,
                        TruthWanted wanted) {
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
        state_->write(input, lane, &inputs[lane]);
    }
    state_->lane_step.step(state_->numbers, state_->roads.data(), step_s, wanted == TruthWanted::all);
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
        if (state_->vehicles[lane] != nullptr) {
            state_->read(truth, lane, &state_->vehicles[lane]->truth_);
        }
    }
}

}  // namespace sil
