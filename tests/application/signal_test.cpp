// Signals that carry no usable value: the "not available" code and raw values outside the range.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "tests/application/bench.hpp"
#include "tests/application/end_to_end.hpp"

namespace testing_application {
namespace {

using State = rsi::can_dbc::RolloverWarning::State;

// A signal as the DBC file places it; the codes here are read from there, not from the codec.
struct SignalCase {
    const char* name;
    Sensor sensor;
    std::uint16_t data_id;
    std::size_t first_byte;
    bool big_endian;
    std::vector<std::uint16_t> unusable;  // "not available" first, then the codes just beyond the range
    std::vector<std::uint16_t> limits;    // the outermost codes that are still good
    bool necessary;
    bool may_be_missing;  // "not available" raises no flag
    // Meaning of the outermost codes, [minimum|maximum] of the DBC file in its unit, and which of the two the
    // ECU may use: no vehicle gets to the others.
    std::vector<float> limit_values;
    std::vector<bool> limits_used;
    float (*decoded)(const rsi::hal::CanFrame& frame);
    float rsi::Inputs::* input;
};

template <typename Message, float Message::* field>
float decoded(const rsi::hal::CanFrame& frame) {
    return rsi::can_dbc::decode<Message>(frame.data).value.*field;
}

// How a failing test shows a signal.
void PrintTo(const SignalCase& signal, std::ostream* out) {
    *out << signal.name;
}

std::uint16_t code(int raw) {
    return static_cast<std::uint16_t>(raw);
}

std::vector<SignalCase> signal_cases() {
    const std::vector<std::uint16_t> beyond_30000{code(-32768), code(-32767), code(-30001), code(30001),
                                                  code(32767)};
    const std::vector<std::uint16_t> within_30000{code(-30000), code(30000)};
    const std::vector<std::uint16_t> beyond_24000{code(-32768), code(-24001), code(24001), code(32767)};
    const std::vector<std::uint16_t> beyond_9000{code(-32768), code(-9001), code(9001), code(32767)};
    const std::vector<std::uint16_t> beyond_12000{code(-32768), code(-12001), code(12001), code(32767)};
    const std::vector<std::uint16_t> beyond_speed{0xFFFFU, 40001U, 0xFFFEU};
    const std::vector<bool> never{false, false};
    using rsi::can_dbc::Imu;
    using rsi::can_dbc::RollAngle;
    using rsi::can_dbc::VehicleMotion;
    return {
        {"LateralAcceleration",
         Sensor::imu,
         0x3A7U,
         2U,
         false,
         beyond_30000,
         within_30000,
         true,
         false,
         {-60.0F, 60.0F},
         never,
         decoded<Imu, &Imu::lateral_acceleration_mps2>,
         &rsi::Inputs::lateral_specific_force_mps2},
        {"VerticalAcceleration",
         Sensor::imu,
         0x3A7U,
         4U,
         false,
         beyond_30000,
         within_30000,
         false,
         false,
         {-60.0F, 60.0F},
         never,
         decoded<Imu, &Imu::vertical_acceleration_mps2>,
         &rsi::Inputs::vertical_specific_force_mps2},
        {"RollRate",
         Sensor::imu,
         0x3A7U,
         6U,
         false,
         beyond_30000,
         within_30000,
         true,
         false,
         {-300.0F, 300.0F},
         never,
         decoded<Imu, &Imu::roll_rate_deg_per_s>,
         &rsi::Inputs::roll_rate_radps},
        {"RollAngle",
         Sensor::roll_angle,
         0x45CU,
         2U,
         true,
         beyond_24000,
         {code(-24000), code(24000)},
         false,  // the observer stands in
         false,
         {-120.0F, 120.0F},
         never,
         decoded<RollAngle, &RollAngle::roll_angle_deg>,
         &rsi::Inputs::roll_angle_rad},
        {"BankAngle",
         Sensor::roll_angle,
         0x45CU,
         4U,
         true,
         beyond_9000,
         {code(-9000), code(9000)},
         false,
         true,
         {-45.0F, 45.0F},
         never,
         decoded<RollAngle, &RollAngle::bank_angle_deg>,
         &rsi::Inputs::bank_angle_rad},
        {"Speed",
         Sensor::vehicle_motion,
         0x5B1U,
         2U,
         false,
         beyond_speed,
         {0U, 40000U},
         false,
         false,
         {0.0F, 400.0F},
         {true, false},
         decoded<VehicleMotion, &VehicleMotion::speed_kmh>,
         &rsi::Inputs::speed_mps},
        {"YawRate",
         Sensor::vehicle_motion,
         0x5B1U,
         4U,
         false,
         beyond_30000,
         within_30000,
         false,
         false,
         {-300.0F, 300.0F},
         never,
         decoded<VehicleMotion, &VehicleMotion::yaw_rate_deg_per_s>,
         &rsi::Inputs::yaw_rate_radps},
        {"SteeringWheelAngle",
         Sensor::vehicle_motion,
         0x5B1U,
         6U,
         false,
         beyond_12000,
         {code(-12000), code(12000)},
         false,
         false,
         {-1200.0F, 1200.0F},
         never,
         decoded<VehicleMotion, &VehicleMotion::steering_wheel_angle_deg>,
         &rsi::Inputs::steering_wheel_angle_rad},
    };
}

class Signal : public ::testing::TestWithParam<SignalCase> {
 protected:
    void SetUp() override {
        bench.run_for(0.5);  // the observer knows the roll angle, too
        ASSERT_EQ(bench.state(), State::ready);
    }

    // All further frames of the sensor carry this code, with a good checksum.
    void put(std::uint16_t raw) {
        const SignalCase& signal = GetParam();
        bench.tamper(signal.sensor, [&signal, raw](rsi::hal::CanFrame& frame) {
            const std::size_t high = signal.first_byte + (signal.big_endian ? 0U : 1U);
            const std::size_t low = signal.first_byte + (signal.big_endian ? 1U : 0U);
            frame.data[high] = static_cast<std::uint8_t>(raw >> 8U);
            frame.data[low] = static_cast<std::uint8_t>(raw & 0xFFU);
            protect(frame, signal.data_id, counter_of(frame));
        });
    }

    bool flag(Sensor sensor) const {
        const rsi::can_dbc::RolloverStatus& status = bench.status();
        const bool flags[] = {status.imu_signal_invalid, status.roll_angle_signal_invalid,
                              status.vehicle_motion_signal_invalid};
        return flags[static_cast<std::size_t>(sensor)];
    }

    Bench bench;
};

TEST_P(Signal, WithoutAUsableValueMakesTheEcuUnavailableExactlyWhenItIsNecessary) {
    const SignalCase& signal = GetParam();
    for (const std::uint16_t raw : signal.unusable) {
        SCOPED_TRACE("raw " + std::to_string(raw));
        put(raw);
        const std::size_t from = bench.cycles().size();
        bench.run_for(0.5);
        for (std::size_t index = from; index < bench.cycles().size(); ++index) {
            ASSERT_EQ(bench.cycles()[index].state(), signal.necessary ? State::unavailable : State::ready);
        }
        const bool excused = signal.may_be_missing && raw == signal.unusable.front();
        for (const Sensor sensor : all_sensors) {
            EXPECT_EQ(flag(sensor), sensor == signal.sensor && !excused) << name_of(sensor);
        }
        EXPECT_EQ(bench.status().frames_rejected, 0U);
        EXPECT_FALSE(bench.status().imu_timeout || bench.status().roll_angle_timeout);

        bench.tamper(signal.sensor, {});
        bench.run_for(0.2);
        EXPECT_EQ(bench.state(), State::ready);
        EXPECT_FALSE(flag(signal.sensor));
    }
}

// The ends of a sensor's range are what it says when it is saturated; no vehicle gets there.
TEST_P(Signal, AtTheEndsOfItsRangeIsSaturatedAndNotUsed) {
    const SignalCase& signal = GetParam();
    for (std::size_t end = 0U; end < 2U; ++end) {
        SCOPED_TRACE("raw " + std::to_string(signal.limits[end]));
        put(signal.limits[end]);
        bench.run_for(1.0);  // the step there is a jump, which has healed
        EXPECT_NEAR(signal.decoded(bench.last_frame(signal.sensor)), signal.limit_values[end], 1.0e-4F);
        EXPECT_FALSE(flag(signal.sensor)) << "the code itself is good";
        EXPECT_NE(std::isnan(bench.inputs().*signal.input), signal.limits_used[end]);
        EXPECT_EQ(bench.state(), signal.necessary ? State::unavailable : State::ready);
        bench.tamper(signal.sensor, {});
        bench.run_for(1.0);
        EXPECT_EQ(bench.state(), State::ready);
    }
}

// Then the frame is what is missing.
TEST_P(Signal, WithoutAUsableValueIsNoLongerReportedOnceItsFrameIsStale) {
    const SignalCase& signal = GetParam();
    put(signal.unusable.back());
    bench.run_cycles(1);
    ASSERT_TRUE(flag(signal.sensor));
    bench.stop(signal.sensor);
    bench.run_cycles(6);
    EXPECT_FALSE(flag(signal.sensor));
}

INSTANTIATE_TEST_SUITE_P(OfEachSensorFrame, Signal, ::testing::ValuesIn(signal_cases()),
                         [](const auto& tested) { return std::string{tested.param.name}; });

// A signal that is necessary for a statement must not be replaced by an old value either.
TEST(ANecessarySignal, ThatIsNotAvailableHidesEveryComputedNumber) {
    Bench bench;
    bench.run_until_ready();
    Motion motion;
    motion.imu.lateral_acceleration_mps2 = rsi::can_dbc::not_available;
    bench.drive(motion);
    bench.run_cycles(1);
    const auto& warning = bench.last().warning.status;
    EXPECT_EQ(warning.warning_level, rsi::can_dbc::SignalStatus::not_available);
    EXPECT_EQ(warning.lateral_acceleration_mps2, rsi::can_dbc::SignalStatus::not_available);
    EXPECT_EQ(warning.lateral_acceleration_threshold_mps2, rsi::can_dbc::SignalStatus::not_available);
    const auto& estimate = bench.last().estimate.status;
    EXPECT_EQ(estimate.roll_centre_vertical_m, rsi::can_dbc::SignalStatus::not_available);
    EXPECT_EQ(estimate.roll_centre_lateral_m, rsi::can_dbc::SignalStatus::not_available);
}

// Few vehicles send it: nothing is reported without it, and what is stale is not used.
TEST(TheVehiclesMass, ReachesTheComponentWhereItIsSent) {
    Bench bench;
    bench.run_until_ready();
    EXPECT_TRUE(std::isnan(bench.inputs().vehicle_mass_kg));
    Motion motion;
    motion.vehicle_mass.mass_kg = 2730.0F;
    bench.drive(motion);
    bench.run_cycles(1);
    EXPECT_EQ(bench.inputs().vehicle_mass_kg, 2730.0F);
    bench.drive(Motion{});
    bench.run_cycles(3);
    EXPECT_EQ(bench.inputs().vehicle_mass_kg, 2730.0F);
    bench.run_cycles(1);
    EXPECT_TRUE(std::isnan(bench.inputs().vehicle_mass_kg));
    EXPECT_EQ(bench.last().diagnosis.value.code, rsi::can_dbc::RolloverDiagnosis::Code::none);
    EXPECT_EQ(bench.state(), State::ready);
}

TEST(Signal, ReachesTheComponentInSiUnits) {
    constexpr float radians = 0.017453293F;
    Bench bench;
    Motion motion;
    motion.imu = rsi::can_dbc::Imu{1.5F, 9.75F, 2.0F};
    motion.roll_angle.roll_angle_deg = 3.0F;
    motion.vehicle_motion = rsi::can_dbc::VehicleMotion{72.0F, 4.0F, -90.0F};
    bench.drive(motion);
    bench.run_until_ready();
    const rsi::Inputs& inputs = bench.inputs();
    EXPECT_NEAR(inputs.lateral_specific_force_mps2, 1.5F, 1e-3F);
    EXPECT_NEAR(inputs.vertical_specific_force_mps2, 9.75F, 1e-3F);
    EXPECT_NEAR(inputs.roll_rate_radps, 2.0F * radians, 1e-4F);
    EXPECT_NEAR(inputs.roll_angle_rad, 3.0F * radians, 1e-4F);
    EXPECT_NEAR(inputs.speed_mps, 20.0F, 1e-2F);
    EXPECT_NEAR(inputs.yaw_rate_radps, 4.0F * radians, 1e-4F);
    EXPECT_TRUE(std::isnan(inputs.bank_angle_rad));
    bench.stop(Sensor::imu);
    bench.run_cycles(6);
    EXPECT_TRUE(std::isnan(bench.inputs().lateral_specific_force_mps2));
}

}  // namespace
}  // namespace testing_application
