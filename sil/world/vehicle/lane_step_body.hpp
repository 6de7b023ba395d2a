// Lane step for the processor that RSI_PROCESSOR names, with whose options the source is compiled that
// includes this. This file must leave no function to the linker that others could take for theirs;
// tests/sil/vehicle checks that.
#define EIGEN_DONT_VECTORIZE  // lanes are in vectors already, and its code for doubles would be the
                              // processor's
#include <cstring>
#include <new>

// Before the equations, which use what it declares.
#include "sil/world/vehicle/lanes.hpp"
//
#include "sil/world/vehicle/lane_step.hpp"

namespace sil {
namespace {

using RSI_PROCESSOR::LaneArray;
using RSI_PROCESSOR::Lanes;

using Numbers = SteppedNumbers<Lanes>;
static_assert(sizeof(Numbers) == stepped_number_count * lane_count * sizeof(double));
static_assert(alignof(Numbers) <= lane_alignment);
static_assert(Lanes::count == lane_count);

// The road under each lane; that of an empty lane is level.
class Roads {
 public:
    explicit Roads(const Road* const* roads) : roads_{roads} {}

    BasicRoadPoint<Lanes> at(const Lanes& x_m, const Lanes& y_m) const {
        const LaneArray x{x_m};
        const LaneArray y{y_m};
        LaneArray height{0.0};
        LaneArray normal[3]{LaneArray{0.0}, LaneArray{0.0}, LaneArray{1.0}};
        LaneArray friction{1.0};
        LaneArray beyond_kerb{0.0};
        LaneArray kerb_height{0.0};
        LaneArray softness{0.0};
        for (std::size_t lane = 0; lane < lane_count; ++lane) {
            if (roads_[lane] != nullptr) {
                const RoadPoint point = roads_[lane]->at(x.values[lane], y.values[lane]);
                height.values[lane] = point.height_m;
                for (int i = 0; i < 3; ++i) {
                    normal[i].values[lane] = point.normal[i];
                }
                friction.values[lane] = point.friction_factor;
                beyond_kerb.values[lane] = point.beyond_kerb_m;
                kerb_height.values[lane] = point.kerb_height_m;
                softness.values[lane] = point.softness;
            }
        }
        return {height.lanes(),      {normal[0].lanes(), normal[1].lanes(), normal[2].lanes()},
                friction.lanes(),    beyond_kerb.lanes(),
                kerb_height.lanes(), softness.lanes()};
    }

    Vector3Of<Lanes> mean_normal(const Lanes& x_m, const Lanes& y_m) const {
        const LaneArray x{x_m};
        const LaneArray y{y_m};
        LaneArray normal[3]{LaneArray{0.0}, LaneArray{0.0}, LaneArray{1.0}};
        for (std::size_t lane = 0; lane < lane_count; ++lane) {
            if (roads_[lane] != nullptr) {
                const Vector3 at = roads_[lane]->mean_normal(x.values[lane], y.values[lane]);
                for (int i = 0; i < 3; ++i) {
                    normal[i].values[lane] = at[i];
                }
            }
        }
        return {normal[0].lanes(), normal[1].lanes(), normal[2].lanes()};
    }

 private:
    const Road* const* roads_;
};

void make(double* numbers) {
    ::new (static_cast<void*>(numbers)) Numbers{};
}

void step(double* numbers, const Road* const* roads, double step_s, bool whole_truth) {
    Numbers& all = *std::launder(reinterpret_cast<Numbers*>(numbers));
    all.model.step(all.input, step_s, Roads{roads});
    all.truth = whole_truth ? all.model.truth() : all.model.motion();
}

Lanes lanes_at(const double* values) {
    Lanes::Register all;
    std::memcpy(&all, values, sizeof(all));
    return all;
}
void put(const Lanes& lanes, double* values) {
    std::memcpy(values, LaneArray{lanes}.values, sizeof(Lanes));
}

void atan(double* values) {
    put(number::atan(lanes_at(values)), values);
}
void sin(double* values) {
    put(number::sin(lanes_at(values)), values);
}
void sin_and_cos(double* values, double* cosines) {
    Lanes sine;
    Lanes cosine;
    number::sin_and_cos(lanes_at(values), sine, cosine);
    put(sine, values);
    put(cosine, cosines);
}

}  // namespace
