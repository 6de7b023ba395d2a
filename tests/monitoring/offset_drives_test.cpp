// Twenty minutes on every kind of road that could pass for an offset of the lateral accelerometer, and with
// offsets that are some: monitoring and component together.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <ostream>
#include <vector>

#include "rsi/component.hpp"
#include "rsi/ecu/monitoring/input_monitor.hpp"
#include "tests/support/large_suv.h"

namespace monitoring_offset_drives_test {
namespace {

using rsi::monitoring::DiagnosticCode;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double gravity_mps2 = 9.80665;
constexpr double pi = 3.14159265358979;
constexpr double minute_s = 60.0;
constexpr double twenty_minutes_s = 20.0 * minute_s;

constexpr double degrees(double value) {
    return value * pi / 180.0;
}

// Yaw rate times speed, and the bank of the road, left side up.
struct Road {
    double turn_mps2{0.0};
    double bank_rad{0.0};
    double speed_mps{25.0};
    bool backwards{false};
};
using Course = std::function<Road(double time_s)>;

// Offsets of the sensors, and what the vehicle itself does; that of the accelerometer may drift.
struct Errors {
    std::function<double(double time_s)> lateral_mps2{[](double) { return 0.0; }};
    double yaw_rate_radps{0.0};
    double roll_angle_rad{0.0};
    double rolling_mps2{0.0};  // force that rolls the body: a load on one side, a wind
    double load_share{0.0};
};

struct Result {
    double corrected_mps2{0.0};
    double most_corrected_mps2{0.0};
    double first_corrected_s{0.0};  // 0: never
    double code_s{0.0};             // of the accelerometer; 0: never
    bool has_another_code{false};
};

// A body that rolls in a tenth of a second as its springs let it.
Result drive(const Course& course, const Errors& errors, double seconds = twenty_minutes_s) {
    const rsi::Parameters suv = rsi_test_large_suv();
    const auto arm_kgm = static_cast<double>(suv.sprung_mass_kg) *
                         static_cast<double>(suv.sprung_cg_height_m - suv.fixed_roll_centre_height_m);
    const auto stiffness_nmprad = static_cast<double>(suv.roll_stiffness_nmprad);
    rsi::Component component;
    EXPECT_EQ(component.init(suv).accepted, 1);
    rsi::monitoring::InputMonitor monitor;
    rsi::monitoring::DiagnosticMemory memory;
    monitor.start(suv);
    rsi::Outputs outputs{};
    std::uint32_t random = 1U;
    const auto noise = [&random](double most) {
        random = random * 1664525U + 1013904223U;
        return most * (static_cast<double>(random >> 8U) / 8388608.0 - 1.0);
    };
    const double laden_kgm = (1.0 + errors.load_share) * arm_kgm;
    double angle_rad = 0.0;
    double bank_rad = course(0.0).bank_rad;
    Result result;
    const auto cycles = static_cast<int>(seconds * 100.0);
    for (int cycle = 0; cycle < cycles; ++cycle) {
        const double time_s = 0.01 * cycle;
        const Road road = course(time_s);
        const double force_mps2 = road.turn_mps2 + gravity_mps2 * std::sin(road.bank_rad);
        const double held_rad =
            laden_kgm * (force_mps2 + errors.rolling_mps2) / (stiffness_nmprad - laden_kgm * gravity_mps2);
        const double roll_radps = (held_rad - angle_rad) / 0.1;
        const double bank_radps = (road.bank_rad - bank_rad) / 0.01;
        bank_rad = road.bank_rad;
        angle_rad += 0.01 * roll_radps;
        const double direction = road.backwards ? -1.0 : 1.0;
        rsi::Inputs inputs{};
        const double along_body_mps2 = force_mps2 * std::cos(angle_rad) + gravity_mps2 * std::sin(angle_rad);
        inputs.lateral_specific_force_mps2 =
            static_cast<float>(along_body_mps2 + errors.lateral_mps2(time_s) + noise(0.1));
        inputs.vertical_specific_force_mps2 = static_cast<float>(gravity_mps2 - force_mps2 * angle_rad -
                                                                 road.turn_mps2 * road.bank_rad + noise(0.1));
        inputs.roll_rate_radps = static_cast<float>(roll_radps - bank_radps + noise(0.005));
        inputs.roll_angle_rad = static_cast<float>(angle_rad + errors.roll_angle_rad + noise(0.003));
        inputs.yaw_rate_radps = static_cast<float>(direction * road.turn_mps2 / road.speed_mps +
                                                   errors.yaw_rate_radps + noise(0.005));
        inputs.speed_mps = static_cast<float>(road.speed_mps + noise(0.03));
        inputs.steering_wheel_angle_rad = static_cast<float>(0.2 * road.turn_mps2 + noise(0.002));
        inputs.bank_angle_rad = rsi::not_available;
        inputs.vehicle_mass_kg = rsi::not_available;
        const rsi::Inputs qualified =
            monitor.qualify(inputs, {true, !std::isnan(errors.roll_angle_rad), true}, outputs, memory);
        component.step(qualified, outputs);
        result.corrected_mps2 = static_cast<double>(monitor.lateral_offset().correction_mps2());
        result.most_corrected_mps2 = std::fmax(result.most_corrected_mps2, std::fabs(result.corrected_mps2));
        if (result.most_corrected_mps2 > 0.0 && result.first_corrected_s == 0.0) {
            result.first_corrected_s = time_s;
        }
        if (memory.confirmed(DiagnosticCode::lateral_acceleration_contradicts_yaw_rate) &&
            result.code_s == 0.0) {
            result.code_s = time_s;
        }
        const auto others =
            memory.confirmed_codes() &
            ~rsi::monitoring::set_of(DiagnosticCode::lateral_acceleration_contradicts_yaw_rate,
                                     DiagnosticCode::roll_angle_lost);
        result.has_another_code = result.has_another_code || others != 0U;
    }
    return result;
}

// A turn every 20 s, of that acceleration to alternating sides.
double turns_mps2(double time_s, double most_mps2) {
    const double swing = std::sin(2.0 * pi * time_s / 40.0);
    return most_mps2 * swing * swing * swing;
}

Road ordinary(double time_s) {
    return {turns_mps2(time_s, 2.5)};
}

// The lane's side of a road from whose middle it falls by 3 %.
Road crowned(double time_s) {
    return {turns_mps2(time_s, 2.0), std::atan(0.03)};
}

// Half of each minute in turns to the left of a 20 deg bank, else on straights that lean as well.
Road oval(double time_s) {
    const double share = 0.5 - 0.5 * std::cos(2.0 * pi * time_s / 60.0);
    return {8.0 * share * share, degrees(-9.0 - 11.0 * share), 60.0};
}

Road roundabouts_to_the_left(double time_s) {
    const double share = 0.5 - 0.5 * std::cos(2.0 * pi * time_s / 25.0);
    return {3.0 * share * share, 0.0, 9.0};
}

// A turn without end, just inside of what counts as straight.
Road large_circle_to_the_left(double) {
    return {1.4, 0.0, 20.0};
}

// Bends that lean inwards by 7 %.
Road mountain(double time_s) {
    const double turn_mps2 = turns_mps2(1.7 * time_s, 3.5);
    return {turn_mps2, -0.02 * turn_mps2, 15.0};
}

Road hillside(double) {
    return {0.0, degrees(6.0), 20.0};
}

// From a stop on.
Road reverse(double time_s) {
    const double share = std::fmin(std::fmax(0.0, 0.5 * time_s - 0.5), 1.0);
    return {1.2 * share, 0.0, 0.05 + 6.0 * share, true};
}

struct Honest {
    const char* name;
    Course course;
    Errors errors{};
};

std::vector<Honest> honest_drives() {
    Errors laden;
    laden.load_share = 0.3;
    Errors empty;
    empty.load_share = -0.3;
    Errors load_on_one_side;
    load_on_one_side.rolling_mps2 = 1.0;
    Errors wrong_zero;
    wrong_zero.roll_angle_rad = degrees(-1.0);
    Errors yaw_rate;
    yaw_rate.yaw_rate_radps = degrees(-0.5);
    Errors raw;
    raw.lateral_mps2 = [](double) { return 0.03 * gravity_mps2; };
    return {{"ordinary", ordinary},
            {"crowned road", crowned},
            {"oval", oval},
            {"roundabouts to the left", roundabouts_to_the_left},
            {"the same laden", roundabouts_to_the_left, laden},
            {"the same unladen", roundabouts_to_the_left, empty},
            {"circle", large_circle_to_the_left},
            {"circle, laden", large_circle_to_the_left, laden},
            {"mountain", mountain},
            {"hillside", hillside},
            {"reverse", reverse},
            {"load on one side, or a wind", ordinary, load_on_one_side},
            {"wrong zero of the roll angle", ordinary, wrong_zero},
            {"the same on a crowned road", crowned, wrong_zero},
            {"offset of the yaw rate", crowned, yaw_rate},
            {"accelerometer as delivered", ordinary, raw}};
}

TEST(AnAccelerometerThatIsGood, IsNotCorrectedOnAnyRoad) {
    for (const Honest& honest : honest_drives()) {
        const Result result = drive(honest.course, honest.errors);
        EXPECT_EQ(result.most_corrected_mps2, 0.0) << honest.name;
        EXPECT_EQ(result.code_s, 0.0) << honest.name;
        EXPECT_FALSE(result.has_another_code) << honest.name;
    }
}

// Then a bank is what the yaw rate says of it; that of a crown is tolerated.
TEST(AnAccelerometerThatIsGood, IsNotCorrectedOnACrownedRoadWithoutARollSensorEither) {
    Errors none;
    none.roll_angle_rad = nan;
    EXPECT_EQ(drive(crowned, none).most_corrected_mps2, 0.0);
    EXPECT_EQ(drive(roundabouts_to_the_left, none).most_corrected_mps2, 0.0);
}

// All that can be wrong with good sensors, on one side.
TEST(AnAccelerometerThatIsGood, IsCorrectedByLittleWhereAllElseIsWrongOnOneSide) {
    Errors all;
    all.yaw_rate_radps = degrees(-0.5);
    all.roll_angle_rad = degrees(-0.5);
    all.lateral_mps2 = [](double) { return 0.005 * gravity_mps2; };
    EXPECT_LT(drive(crowned, all).most_corrected_mps2, 0.5);
}

struct Wrong {
    double offset_mps2;
    bool has_roll_sensor;
};
// How a failing test shows it.
void PrintTo(const Wrong& wrong, std::ostream* out) {
    *out << wrong.offset_mps2 << (wrong.has_roll_sensor ? "WithRollSensor" : "WithoutRollSensor");
}
class AnAccelerometerThatIsOff : public ::testing::TestWithParam<Wrong> {};

TEST_P(AnAccelerometerThatIsOff, IsCorrectedOrFoundWithinTenMinutes) {
    const double offset_mps2 = GetParam().offset_mps2;
    Errors errors;
    errors.lateral_mps2 = [offset_mps2](double) { return offset_mps2; };
    errors.roll_angle_rad = GetParam().has_roll_sensor ? 0.0 : nan;
    const Result result = drive(ordinary, errors, 10.0 * minute_s);
    if (std::fabs(offset_mps2) > 1.3) {
        EXPECT_GT(result.code_s, 0.0);
        EXPECT_NEAR(std::fabs(result.corrected_mps2), 1.2, 0.001);
    } else {
        EXPECT_NEAR(offset_mps2 - result.corrected_mps2, 0.0, std::fabs(offset_mps2) < 0.8 ? 0.3 : 0.15);
        EXPECT_EQ(result.code_s, 0.0);
    }
    EXPECT_GT(result.first_corrected_s, 20.0) << "a road's bank may be as long";
    EXPECT_LT(result.first_corrected_s, 5.0 * minute_s);
}
INSTANTIATE_TEST_SUITE_P(Offsets, AnAccelerometerThatIsOff,
                         ::testing::Values(Wrong{0.6, true}, Wrong{-0.6, true}, Wrong{1.03, true},
                                           Wrong{-1.03, true}, Wrong{1.5, true}, Wrong{-1.5, true},
                                           Wrong{1.03, false}, Wrong{-1.5, false}));

// As a bank that comes slowly, for the checks of seconds.
TEST(AnAccelerometerThatDrifts, IsFound) {
    Errors errors;
    errors.lateral_mps2 = [](double time_s) { return std::fmin(1.5, time_s / 200.0); };
    const Result result = drive(ordinary, errors);
    EXPECT_GT(result.code_s, 0.0);
    EXPECT_LT(result.code_s, 15.0 * minute_s);
}

}  // namespace
}  // namespace monitoring_offset_drives_test
