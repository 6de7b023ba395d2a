// Vehicle batch: whatever the company, each vehicle goes on as it does alone, to the bit.
#include "sil/world/vehicle/vehicle_batch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <memory>
#include <random>
#include <vector>

#include "scenario.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/manoeuvres/manoeuvre_run.hpp"
#include "sil/world/vehicle/lane_step.hpp"
#include "sil/world/vehicle/load.hpp"

namespace {

using Numbers = std::array<std::uint64_t, sizeof(sil::Truth) / sizeof(double)>;

// With every bit, so that zeros of either sign and NaN compare as what they are.
Numbers bits_of(const sil::Truth& truth) {
    static_assert(sizeof(Numbers) == sizeof(sil::Truth));
    Numbers bits;
    std::memcpy(bits.data(), &truth, sizeof(truth));
    return bits;
}

// Draws runs that differ in all that can differ.
class Mixture {
 public:
    explicit Mixture(unsigned seed) : random_{seed} {}

    std::unique_ptr<sil::ManoeuvreRun> next() {
        const std::vector<sil::Manoeuvre> manoeuvres = sil::all_manoeuvres();
        sil::VehicleParameters vehicle = scenario::large_suv();
        vehicle = sil::with_load(vehicle, between(0.0, 400.0), between(0.5, 1.9));
        vehicle = sil::with_friction(vehicle, between(0.7, 1.3));
        vehicle.steering.lag_s = random_() % 2U == 0U ? 0.0 : 0.05;
        if (random_() % 2U == 0U) {
            vehicle.rear_suspension.spring_damper.dry_friction = between(0.02, 0.08);
            vehicle.front_suspension.spring_damper.progression_pm2 = between(0.0, 100.0);
        }
        if (random_() % 2U == 0U) {
            vehicle = scenario::twisting(vehicle, between(10.0e3, 200.0e3));
        }
        sil::RunOptions options;
        options.mirrored = random_() % 2U == 0U;
        options.duration_s = between(0.3, 5.0);
        options.speed_factor = between(0.6, 1.3);
        options.steering_factor = between(0.3, 1.8);
        return std::make_unique<sil::ManoeuvreRun>(vehicle, manoeuvres[random_() % manoeuvres.size()],
                                                   options);
    }

    bool coin() { return random_() % 2U == 0U; }

 private:
    double between(double low, double high) {
        return std::uniform_real_distribution<double>{low, high}(random_);
    }

    std::mt19937 random_;
};

struct Pair {
    std::unique_ptr<sil::ManoeuvreRun> together;
    std::unique_ptr<sil::ManoeuvreRun> alone;
};

class EachProcessor : public testing::TestWithParam<sil::LaneStep> {};

TEST_P(EachProcessor, StepsRandomMixturesAsEachVehicleAlone) {
    constexpr int runs = 32;
    Mixture mixture{11U};
    sil::VehicleBatch batch{GetParam()};
    std::array<Pair, sil::lane_count> lanes;
    std::array<sil::DriverInput, sil::lane_count> inputs{};
    int begun = 0;
    int ended = 0;
    int lifted = 0;
    while (ended < runs) {
        for (std::size_t lane = 0U; lane < lanes.size(); ++lane) {
            // Some lanes stay empty for a while.
            if (!lanes[lane].together && begun < runs && mixture.coin()) {
                lanes[lane].together = mixture.next();
                lanes[lane].alone = std::make_unique<sil::ManoeuvreRun>(*lanes[lane].together);
                batch.enter(lane, lanes[lane].together->vehicle_to_step());
                ++begun;
            }
            if (lanes[lane].together) {
                inputs[lane] = lanes[lane].together->next_input();
                lanes[lane].alone->step();
            }
        }
        batch.step(inputs, sil::Vehicle::nominal_step_s, sil::VehicleBatch::TruthWanted::all);
        for (std::size_t lane = 0U; lane < lanes.size(); ++lane) {
            if (!lanes[lane].together) {
                continue;
            }
            const sil::Truth& truth = lanes[lane].alone->truth();
            ASSERT_EQ(bits_of(lanes[lane].together->truth()), bits_of(truth)) << truth.time_s;
            lifted += sil::two_wheels_have_lifted(truth) ? 1 : 0;
            if (lanes[lane].together->finished()) {
                batch.leave(lane);
                // Alone from here on.
                lanes[lane].together->step();
                lanes[lane].alone->step();
                ASSERT_EQ(bits_of(lanes[lane].together->truth()), bits_of(lanes[lane].alone->truth()));
                lanes[lane] = {};
                ++ended;
            }
        }
    }
    EXPECT_GT(lifted, 100) << "no mixture of hard runs";
}

TEST_P(EachProcessor, LeavesOutOfMotionWhatIsNotOfIt) {
    Mixture mixture{3U};
    const std::unique_ptr<sil::ManoeuvreRun> run = mixture.next();
    sil::ManoeuvreRun alone{*run};
    sil::VehicleBatch batch{GetParam()};
    batch.enter(5U, run->vehicle_to_step());
    std::array<sil::DriverInput, sil::lane_count> inputs{};
    inputs[5] = run->next_input();
    alone.step();
    batch.step(inputs, sil::Vehicle::nominal_step_s, sil::VehicleBatch::TruthWanted::motion);
    const sil::Truth& motion = run->truth();
    EXPECT_TRUE(std::isnan(motion.pitch_angle_rad));
    EXPECT_TRUE(std::isnan(motion.bank_angle_rad));
    EXPECT_TRUE(std::isnan(motion.roll_to_horizon_rad));
    EXPECT_TRUE(std::isnan(motion.suspension_deflection_m[0]));
    EXPECT_TRUE(std::isnan(motion.wheel_gap_m[3]));
    EXPECT_TRUE(std::isnan(motion.lateral_tyre_force_n));
    EXPECT_EQ(motion.yaw_angle_rad, alone.truth().yaw_angle_rad);
    EXPECT_EQ(motion.roll_angle_rad, alone.truth().roll_angle_rad);
    EXPECT_EQ(motion.wheel_load_n, alone.truth().wheel_load_n);
    EXPECT_EQ(motion.specific_force_mps2, alone.truth().specific_force_mps2);
}

std::uint64_t bits_of(double value) {
    std::uint64_t bits = 0U;
    std::memcpy(&bits, &value, sizeof(bits));
    return bits;
}

// Values that no random number hits, and small and large ones of either sign.
std::vector<double> arguments() {
    std::vector<double> all{
        0.0, -0.0,   5.0e-324, -5.0e-324, 0x1p-6,       -0x1p-6, 0.5,    1.0,
        3.9, 0x1p10, HUGE_VAL, -HUGE_VAL, std::nan(""), 1.0e300, 1.0e-8, 3.14159265358979311};
    std::mt19937_64 random{5U};
    std::uniform_real_distribution<double> share{-1.0, 1.0};
    for (const double size : {1.0e-8, 1.0e-3, 0.03, 0.3, 1.0, 3.9, 30.0, 2000.0}) {
        for (int i = 0; i < 40000; ++i) {
            all.push_back(size * share(random));
        }
    }
    return all;
}

// The library's own; what the step computes instead must be no other double.
TEST_P(EachProcessor, HasTheLibrarysFunctionsToTheBit) {
    const std::vector<double> all = arguments();
    ASSERT_EQ(all.size() % sil::lane_count, 0U);
    for (std::size_t first = 0U; first < all.size(); first += sil::lane_count) {
        double arcs[sil::lane_count];
        double only_sines[sil::lane_count];
        double sines[sil::lane_count];
        double cosines[sil::lane_count];
        for (double* values : {arcs, only_sines, sines}) {
            std::memcpy(values, &all[first], sizeof(arcs));
        }
        GetParam().atan(arcs);
        GetParam().sin(only_sines);
        GetParam().sin_and_cos(sines, cosines);
        for (std::size_t lane = 0U; lane < sil::lane_count; ++lane) {
            const double x = all[first + lane];
            if (std::isnan(std::atan(x)) || std::isnan(std::sin(x))) {
                ASSERT_TRUE(std::isnan(only_sines[lane]) && std::isnan(sines[lane]) &&
                            std::isnan(cosines[lane]))
                    << x;
                continue;
            }
            ASSERT_EQ(bits_of(arcs[lane]), bits_of(std::atan(x))) << x;
            ASSERT_EQ(bits_of(only_sines[lane]), bits_of(std::sin(x))) << x;
            ASSERT_EQ(bits_of(sines[lane]), bits_of(std::sin(x))) << x;
            ASSERT_EQ(bits_of(cosines[lane]), bits_of(std::cos(x))) << x;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(VehicleBatch, EachProcessor, testing::ValuesIn(sil::lane_steps()),
                         [](const auto& step) { return "Lanes" + std::to_string(step.index); });

}  // namespace
