// Vehicle batch: the model of vehicle_model.hpp with Lanes for its numbers, compiled once for each kind of
// processor.
#include "sil/world/vehicle/vehicle_batch.hpp"

#include <cstring>
#include <new>

#include "sil/world/vehicle/lanes.hpp"  // before the equations, which use what it declares
#include "sil/world/vehicle/vehicle.hpp"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define RSI_X86_CLONES
#endif

namespace sil {
namespace {

// All that is here is nothing but numbers, and in the same order for one vehicle as for several: a lane is filled
// and read number by number.
template <template <typename> typename Numbers>
constexpr std::size_t number_count = [] {
    static_assert(sizeof(Numbers<Lanes>) == Lanes::count * sizeof(Numbers<double>));
    return sizeof(Numbers<double>) / sizeof(double);
}();

template <template <typename> typename Numbers>
void write_lane(Numbers<Lanes>& lanes, std::size_t lane, const Numbers<double>& one) {
    auto* const to = reinterpret_cast<std::byte*>(&lanes) + lane * sizeof(double);
    const auto* const from = reinterpret_cast<const std::byte*>(&one);
    for (std::size_t i = 0; i < number_count<Numbers>; ++i) {
        std::memcpy(to + i * sizeof(Lanes), from + i * sizeof(double), sizeof(double));
    }
}

template <template <typename> typename Numbers>
void read_lane(const Numbers<Lanes>& lanes, std::size_t lane, Numbers<double>& one) {
    const auto* const from = reinterpret_cast<const std::byte*>(&lanes) + lane * sizeof(double);
    auto* const to = reinterpret_cast<std::byte*>(&one);
    for (std::size_t i = 0; i < number_count<Numbers>; ++i) {
        std::memcpy(to + i * sizeof(double), from + i * sizeof(Lanes), sizeof(double));
    }
}

// The road under each lane; that of an empty lane is level.
class Roads {
 public:
    void set(std::size_t lane, const Road* road) { roads_[lane] = road; }

    BasicRoadPoint<Lanes> at(const Lanes& x_m, const Lanes& y_m) const {
        BasicRoadPoint<Lanes> points;
        for (std::size_t lane = 0; lane < Lanes::count; ++lane) {
            if (roads_[lane] != nullptr) {
                write_lane<BasicRoadPoint>(points, lane, roads_[lane]->at(x_m[lane], y_m[lane]));
            }
        }
        return points;
    }

    Vector3Of<Lanes> mean_normal(const Lanes& x_m, const Lanes& y_m) const {
        Vector3Of<Lanes> normals{0.0, 0.0, 1.0};
        for (std::size_t lane = 0; lane < Lanes::count; ++lane) {
            if (roads_[lane] != nullptr) {
                write_lane<Vector3Of>(normals, lane, roads_[lane]->mean_normal(x_m[lane], y_m[lane]));
            }
        }
        return normals;
    }

 private:
    std::array<const Road*, Lanes::count> roads_{};
};

}  // namespace

// How all lanes step, with everything taken in by `flatten`, so that all of it is compiled for the processor that
// is named. None of them fuses a*b+c, so all give the same bits.
struct VehicleBatch::State {
    using Step = void(State&, double, TruthWanted);

    VehicleModel<Lanes> model{BasicVehicleParameters<Lanes>{}};
    BasicDriverInput<Lanes> input{};
    BasicTruth<Lanes> truth{};
    Roads roads{};
    std::array<Vehicle*, lane_count> vehicles{};
    Step* step{fitting_step()};

    void step_all(double step_s, TruthWanted wanted) {
        model.step(input, step_s, roads);
        truth = wanted == TruthWanted::all ? model.truth() : model.motion();
    }
    [[gnu::flatten]] static void step_anywhere(State& state, double step_s, TruthWanted wanted) {
        state.step_all(step_s, wanted);
    }
#ifdef RSI_X86_CLONES
    [[gnu::flatten, gnu::target("avx2")]] static void step_avx2(State& state, double step_s, TruthWanted wanted) {
        state.step_all(step_s, wanted);
    }
    [[gnu::flatten, gnu::target("avx512f,avx512dq,avx512vl,avx512bw")]] static void step_avx512(
        State& state, double step_s, TruthWanted wanted) {
        state.step_all(step_s, wanted);
    }
#endif

    static Step* fitting_step() {
#ifdef RSI_X86_CLONES
        if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
            __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw")) {
            return step_avx512;
        }
        if (__builtin_cpu_supports("avx2")) {
            return step_avx2;
        }
#endif
        return step_anywhere;
    }
};

VehicleBatch::VehicleBatch() : state_{std::make_unique<State>()} {}
VehicleBatch::~VehicleBatch() = default;

void VehicleBatch::enter(std::size_t lane, Vehicle& vehicle) {
    write_lane<VehicleModel>(state_->model, lane, vehicle.model_);
    state_->roads.set(lane, &vehicle.road_);
    state_->vehicles[lane] = &vehicle;
}

void VehicleBatch::leave(std::size_t lane) {
    read_lane<VehicleModel>(state_->model, lane, state_->vehicles[lane]->model_);
    state_->roads.set(lane, nullptr);
    state_->vehicles[lane] = nullptr;
}

void VehicleBatch::step(const std::array<DriverInput, lane_count>& inputs, double step_s,
                        TruthWanted wanted) {
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
        write_lane<BasicDriverInput>(state_->input, lane, inputs[lane]);
    }
    state_->step(*state_, step_s, wanted);
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
        if (state_->vehicles[lane] != nullptr) {
            read_lane<BasicTruth>(state_->truth, lane, state_->vehicles[lane]->truth_);
        }
    }
}

}  // namespace sil
