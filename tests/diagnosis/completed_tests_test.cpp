// Tests of ISO 14229-1 that the control unit completes in an operation cycle: each check by itself, when what
// it needs is there.
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "rsi/ecu/diagnosis/trouble_memory.hpp"
#include "tests/application/bench.hpp"
#include "tests/application/roll_plane_vehicle.hpp"

namespace testing_diagnosis {
namespace {

using rsi::monitoring::DiagnosticCode;
using testing_application::Bench;
using testing_application::large_suv;
using testing_application::Motion;
using testing_application::RollPlaneVehicle;
using testing_application::Sensor;
using Codes = std::set<DiagnosticCode>;

const Codes of_roll_angle{DiagnosticCode::roll_angle_lost,        DiagnosticCode::roll_angle_damaged,
                          DiagnosticCode::roll_angle_two_senders, DiagnosticCode::roll_angle_invalid,
                          DiagnosticCode::roll_angle_jump,        DiagnosticCode::roll_angle_stuck};
const Codes of_motion{DiagnosticCode::vehicle_motion_lost,
                      DiagnosticCode::vehicle_motion_damaged,
                      DiagnosticCode::vehicle_motion_two_senders,
                      DiagnosticCode::yaw_rate_invalid,
                      DiagnosticCode::yaw_rate_jump,
                      DiagnosticCode::yaw_rate_stuck,
                      DiagnosticCode::speed_invalid,
                      DiagnosticCode::speed_jump,
                      DiagnosticCode::speed_stuck,
                      DiagnosticCode::steering_invalid,
                      DiagnosticCode::steering_jump,
                      DiagnosticCode::steering_stuck};
// This vehicle has no bank sensor and sends no mass, and the bench has no place for a section.
const Codes never{DiagnosticCode::bank_angle_invalid, DiagnosticCode::stored_parameters_refused,
                  DiagnosticCode::vehicle_mass_invalid, DiagnosticCode::vehicle_mass_jump,
                  DiagnosticCode::vehicle_mass_contradicts_load};
// The road is level.
const Codes needs_a_bank{DiagnosticCode::roll_angle_reference_wrong};

Codes both(Codes one, const Codes& other) {
    one.insert(other.begin(), other.end());
    return one;
}

// An operation cycle of the bench, with its trouble memory.
class OperationCycle {
 public:
    explicit OperationCycle(Bench& bench) : bench_{bench} { troubles_.start(true); }

    void run(double seconds) {
        for (int cycle = 0; cycle < static_cast<int>(100.0 * seconds); ++cycle) {
            bench_.run_cycles(1);
            const rsi::monitoring::DiagnosticMemory& memory = bench_.diagnostic_memory();
            troubles_.update({memory.confirmed_codes(), memory.active_codes(), memory.tested_codes()},
                             memory.snapshot(), 0U);
        }
    }
    bool is_open(DiagnosticCode code) const {
        return (status(code) & rsi::diagnosis::status::not_completed_this_cycle) != 0U;
    }
    bool fails(DiagnosticCode code) const {
        return (status(code) & rsi::diagnosis::status::test_failed) != 0U;
    }
    // Codes that are neither good nor failed yet.
    Codes open() const {
        Codes codes;
        for (const rsi::diagnosis::TroubleCode& each : rsi::diagnosis::trouble_codes) {
            if (is_open(each.code)) {
                codes.insert(each.code);
            }
        }
        return codes;
    }
    void begin_another() { troubles_.start(true); }
    const rsi::diagnosis::TroubleMemory& troubles() const { return troubles_; }

 private:
    std::uint8_t status(DiagnosticCode code) const {
        return troubles_.state(static_cast<std::size_t>(code) - 1U).status;
    }

    Bench& bench_;
    rsi::diagnosis::TroubleMemory troubles_{};
};

// Turns to both sides, and speed that goes up and down.
class Winding {
 public:
    Motion operator()(double time_s) {
        vehicle_.advance(3.5 * std::sin(1.2 * time_s));
        Motion motion = vehicle_.motion();
        const double speed_kmh = 80.0 + 4.0 * std::sin(0.7 * time_s);
        motion.vehicle_motion.speed_kmh = static_cast<float>(speed_kmh);
        const double yaw_rate = vehicle_.lateral_acceleration_mps2() * 3.6 / speed_kmh;
        motion.vehicle_motion.yaw_rate_deg_per_s = static_cast<float>(yaw_rate * 57.29578);
        motion.vehicle_motion.steering_wheel_angle_deg = static_cast<float>(40.0 * std::sin(1.2 * time_s));
        motion.imu.vertical_acceleration_mps2 += static_cast<float>(0.1 * std::sin(9.0 * time_s));
        return motion;
    }

 private:
    RollPlaneVehicle vehicle_{large_suv()};
};

std::string names(const Codes& codes) {
    std::string text;
    for (const DiagnosticCode code : codes) {
        text += std::to_string(static_cast<int>(code)) + ' ';
    }
    return text;
}

TEST(CompletedTests, OfEveryCodeInAnOrdinaryDrive) {
    Bench bench;
    bench.drive(Winding{});
    OperationCycle cycle{bench};
    cycle.run(60.0);
    EXPECT_EQ(names(cycle.open()), names(both(needs_a_bank, never)));
}

TEST(CompletedTests, AtRestAreThoseThatNeedNoMotion) {
    Motion still;
    still.vehicle_motion.speed_kmh = 0.0F;
    Bench bench;
    bench.drive(still);
    OperationCycle cycle{bench};
    cycle.run(60.0);
    EXPECT_FALSE(cycle.is_open(DiagnosticCode::imu_lost));
    EXPECT_FALSE(cycle.is_open(DiagnosticCode::lateral_acceleration_invalid));
    EXPECT_FALSE(cycle.is_open(DiagnosticCode::roll_sensor_contradicts_observer));
    for (const DiagnosticCode code : {DiagnosticCode::lateral_acceleration_stuck, DiagnosticCode::speed_stuck,
                                      DiagnosticCode::lateral_acceleration_gain,
                                      DiagnosticCode::yaw_rate_contradicts_lateral_acceleration,
                                      DiagnosticCode::lateral_acceleration_contradicts_yaw_rate}) {
        EXPECT_TRUE(cycle.is_open(code)) << static_cast<int>(code);
    }
}

// A fault that is there from the start leaves open what needs the sensor, and nothing else.
TEST(CompletedTests, AreOnlyOpenWhereTheirSensorIsMissing) {
    struct Case {
        Sensor silent;
        DiagnosticCode lost;
        Codes open;
    };
    const Codes turns{DiagnosticCode::lateral_acceleration_contradicts_yaw_rate,
                      DiagnosticCode::yaw_rate_contradicts_lateral_acceleration,
                      DiagnosticCode::lateral_acceleration_gain,
                      DiagnosticCode::roll_sensor_contradicts_observer};  // no observer without them
    const Codes rolls{
        DiagnosticCode::roll_rate_contradicts_roll_angle, DiagnosticCode::roll_rate_offset,
        DiagnosticCode::roll_sensor_contradicts_observer, DiagnosticCode::vertical_acceleration_offset,
        DiagnosticCode::lateral_acceleration_gain,        DiagnosticCode::imu_held_back};
    const std::vector<Case> cases{
        {Sensor::roll_angle, DiagnosticCode::roll_angle_lost, both(of_roll_angle, rolls)},
        {Sensor::vehicle_motion, DiagnosticCode::vehicle_motion_lost, both(of_motion, turns)},
    };
    for (const Case& each : cases) {
        Bench bench;
        bench.drive(Winding{});
        bench.stop(each.silent);
        OperationCycle cycle{bench};
        cycle.run(60.0);
        EXPECT_TRUE(cycle.fails(each.lost));
        Codes open = both(each.open, both(needs_a_bank, never));
        open.erase(each.lost);
        EXPECT_EQ(names(cycle.open()), names(open)) << testing_application::name_of(each.silent);
    }
}

TEST(CompletedTests, AreNeverThoseOfASensorThatTheVehicleDoesNotHave) {
    rsi::Parameters without = large_suv();
    without.roll_angle_sensor = RSI_ROLL_SENSOR_NOT_FITTED;
    Bench bench{without};
    bench.drive(Winding{});
    OperationCycle cycle{bench};
    cycle.run(60.0);
    for (const DiagnosticCode code : of_roll_angle) {
        EXPECT_TRUE(cycle.is_open(code)) << static_cast<int>(code);
        EXPECT_FALSE(cycle.fails(code)) << static_cast<int>(code);
    }
    EXPECT_TRUE(cycle.is_open(DiagnosticCode::imu_held_back)) << "it is known by the roll sensor's frames";
    EXPECT_FALSE(cycle.is_open(DiagnosticCode::roll_rate_stuck));
}

TEST(CompletedTests, OfTheBankNeedItsSensor) {
    Bench bench;
    Motion motion;
    motion.roll_angle.bank_angle_deg = 1.0F;
    bench.drive(motion);
    OperationCycle cycle{bench};
    cycle.run(1.0);
    EXPECT_FALSE(cycle.is_open(DiagnosticCode::bank_angle_invalid));
}

TEST(CompletedTests, OfReceptionNeedABusThatTakesFrames) {
    Bench bench;
    bench.set_bus_state(rsi::hal::BusState::error_passive);
    OperationCycle cycle{bench};
    cycle.run(10.0);
    EXPECT_TRUE(cycle.fails(DiagnosticCode::bus_error));
    EXPECT_TRUE(cycle.is_open(DiagnosticCode::receive_overflow));
    EXPECT_TRUE(cycle.is_open(DiagnosticCode::own_identifier_received));
    EXPECT_FALSE(cycle.is_open(DiagnosticCode::clock_jump));
}

TEST(CompletedTests, OfOutputsNeedThemComputed) {
    Bench bench;
    bench.stop(Sensor::imu);
    OperationCycle cycle{bench};
    cycle.run(10.0);
    EXPECT_TRUE(cycle.is_open(DiagnosticCode::estimate_out_of_range));
    EXPECT_TRUE(cycle.is_open(DiagnosticCode::output_not_finite));
    for (const DiagnosticCode code : {DiagnosticCode::imu_damaged, DiagnosticCode::imu_two_senders,
                                      DiagnosticCode::imu_held_back, DiagnosticCode::roll_rate_invalid}) {
        EXPECT_TRUE(cycle.is_open(code)) << static_cast<int>(code);
    }
    EXPECT_FALSE(cycle.is_open(DiagnosticCode::roll_angle_damaged));
}

TEST(CompletedTests, OfTheStoredSectionNeedAPlaceForIt) {
    for (const bool is_refused : {false, true}) {
        Bench bench;
        bench.report_stored_section(is_refused ? rsi::application::ParametersRefusal::checksum
                                               : rsi::application::ParametersRefusal::none);
        OperationCycle cycle{bench};
        cycle.run(1.0);
        EXPECT_FALSE(cycle.is_open(DiagnosticCode::stored_parameters_refused));
        EXPECT_EQ(cycle.fails(DiagnosticCode::stored_parameters_refused), is_refused);
    }
}

// The steering sensor stays lost, the accelerometer is repaired.
TEST(CompletedTests, LetARepairedCodeAgeBesideAFaultThatStays) {
    Bench bench;
    bench.drive([winding = Winding{}](double time_s) mutable {
        Motion motion = winding(time_s);
        if (time_s < 5.0) {
            motion.imu.lateral_acceleration_mps2 = rsi::can_dbc::not_available;
        }
        motion.vehicle_motion.steering_wheel_angle_deg = rsi::can_dbc::not_available;
        return motion;
    });
    OperationCycle cycle{bench};
    cycle.run(5.0);
    constexpr auto row = static_cast<std::size_t>(DiagnosticCode::lateral_acceleration_invalid) - 1U;
    EXPECT_TRUE(cycle.fails(DiagnosticCode::lateral_acceleration_invalid));
    for (unsigned journey = 0U; journey < 3U; ++journey) {
        cycle.run(5.0);
        EXPECT_TRUE(cycle.fails(DiagnosticCode::steering_invalid));
        cycle.begin_another();
        EXPECT_EQ(cycle.troubles().state(row).ageing, journey) << "not in the one in which it failed";
    }
}

}  // namespace
}  // namespace testing_diagnosis
