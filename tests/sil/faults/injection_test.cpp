// Each fault does to the sensor frames what its name says, and nothing else.
#include <gtest/gtest.h>

#include <cmath>

#include "rsi/can_dbc/codec/message.hpp"
#include "rsi/can_dbc/e2e/profile_11.hpp"
#include "sil/simulation/sensor_frames.hpp"
#include "sil/studies/faults/faulty_bus.hpp"
#include "sil/studies/faults/sensor_signal.hpp"
#include "sil/studies/faults/signal_fault.hpp"
#include "tests/sil/faults/recorded_frames.hpp"

namespace faults_test {
namespace {

using rsi::can_dbc::e2e::CheckError;
using sil::Fault;
using sil::FaultKind;
using sil::FaultPlace;

// Any values; all differ.
sil::SensorSample sample_of(double scale) {
    sil::SensorSample sample;
    sample.lateral_acceleration_mps2 = 1.0 * scale;
    sample.vertical_acceleration_mps2 = 9.0 * scale;
    sample.roll_rate_radps = 0.1 * scale;
    sample.roll_angle_rad = 0.05 * scale;
    sample.bank_angle_rad = 0.02 * scale;
    sample.speed_mps = 20.0 * scale;
    sample.yaw_rate_radps = 0.2 * scale;
    sample.steering_wheel_angle_rad = 0.5 * scale;
    return sample;
}

std::vector<rsi::hal::CanFrame> of_identifier(const std::vector<rsi::hal::CanFrame>& frames,
                                              std::uint32_t identifier) {
    std::vector<rsi::hal::CanFrame> found;
    for (const rsi::hal::CanFrame& frame : frames) {
        if (frame.identifier == identifier) {
            found.push_back(frame);
        }
    }
    return found;
}

CheckError imu_error(const rsi::hal::CanFrame& frame) {
    return rsi::can_dbc::e2e::verify_profile_11(frame.data.data(), frame.length, rsi::can_dbc::Imu::length,
                                                rsi::can_dbc::Imu::e2e_data_id);
}

unsigned counter_of(const rsi::hal::CanFrame& frame) {
    return frame.data[1] & 0x0FU;
}

// The effect of a fault on some cycles of frames; it begins with the third cycle and ends before the ninth.
class Injection {
 public:
    explicit Injection(const Fault& fault) : bus_{recorded_, fault} {
        for (int cycle = 0; cycle < 12; ++cycle) {
            const bool active = cycle >= 2 && cycle < 8;
            bus_.begin_cycle(active);
            frames_.send(bus_, sample_of(1.0));
            counts_.push_back(recorded_.frames.size());
        }
    }

    // Those that went on the bus in this cycle.
    std::vector<rsi::hal::CanFrame> cycle(std::size_t number) const {
        const std::size_t begin = number == 0U ? 0U : counts_[number - 1U];
        return {recorded_.frames.begin() + static_cast<std::ptrdiff_t>(begin),
                recorded_.frames.begin() + static_cast<std::ptrdiff_t>(counts_[number])};
    }
    std::vector<rsi::hal::CanFrame> imu() const {
        return of_identifier(recorded_.frames, rsi::can_dbc::Imu::identifier);
    }

 private:
    RecordedFrames recorded_{};
    sil::FaultyBus bus_;
    sil::SensorFrames frames_{};
    std::vector<std::size_t> counts_{};
};

std::vector<Fault> signs_of(const std::vector<Fault>& faults) {
    std::vector<Fault> all;
    for (const Fault& fault : faults) {
        const std::vector<Fault> signs = in_each_sign(fault);
        all.insert(all.end(), signs.begin(), signs.end());
    }
    return all;
}

std::vector<Fault> all_signs() {
    return signs_of(sil::all_faults());
}

// With those of the matrix of states.
std::vector<Fault> all_and_further_signs() {
    std::vector<Fault> all = all_signs();
    const std::vector<Fault> further = signs_of(sil::further_faults());
    all.insert(all.end(), further.begin(), further.end());
    return all;
}

TEST(SignalFault, ChangesItsOwnSignalAloneAndOnlyWhileActive) {
    for (const Fault& fault : all_and_further_signs()) {
        if (!sil::is_signal_fault(fault.kind) || fault.kind == FaultKind::out_of_range) {
            continue;
        }
        SCOPED_TRACE(describe(fault) + " of " + to_string(fault.place));
        sil::SignalFault sensor{fault};
        sensor.apply(sample_of(1.0), true);
        const sil::SensorSample right = sample_of(2.0);
        const sil::SensorSample faulty = sensor.apply(right, true);
        for (const sil::SensorSignal& signal : sil::sensor_signals) {
            const bool same = faulty.*(signal.value) == right.*(signal.value);
            EXPECT_EQ(same, signal.place != fault.place) << to_string(signal.place);
        }
        const sil::SensorSample after = sensor.apply(right, false);
        EXPECT_EQ(after.*(sil::find_signal(fault.place)->value),
                  right.*(sil::find_signal(fault.place)->value));
        EXPECT_FALSE(sensor.is_visible());
    }
}

TEST(SignalFault, HasEitherSignWhereThereIsOne) {
    EXPECT_EQ(all_signs().size(), sil::all_faults().size() + 8U + 8U + 7U)
        << "offset, drift; saturated, but for the speed";
    const auto error = [](const Fault& fault) {
        sil::SignalFault sensor{fault};
        const sil::SensorSample right = sample_of(1.0);
        const auto value = sil::find_signal(fault.place)->value;
        return sensor.apply(right, true).*value - right.*value;
    };
    for (const Fault& fault : sil::all_faults()) {
        const std::vector<Fault> signs = in_each_sign(fault);
        if (signs.size() == 2U) {
            SCOPED_TRACE(describe_each_sign(fault) + " of " + to_string(fault.place));
            EXPECT_GT(error(signs[0]), 0.0);
            EXPECT_LT(error(signs[1]), 0.0);
        }
    }
}

TEST(SignalFault, LeavesASpeedAtZeroWhenItIsToBeNegative) {
    sil::SignalFault sensor{{FaultKind::offset, FaultPlace::speed, -30.0}};
    EXPECT_EQ(sensor.apply(sample_of(1.0), true).speed_mps, 0.0);
    EXPECT_TRUE(sensor.is_visible());
    EXPECT_EQ(sensor.apply(sample_of(0.0), true).speed_mps, 0.0);
    EXPECT_FALSE(sensor.is_visible()) << "at rest it is right";
}

TEST(SignalFault, IsVisibleFromTheSmallestErrorOn) {
    sil::SignalFault drift{{FaultKind::drift, FaultPlace::lateral_acceleration, 0.5}};
    for (int cycle = 0; cycle < 300; ++cycle) {
        drift.apply(sample_of(1.0), true);
        const double error = 0.005 * (cycle + 1);
        if (std::abs(error - 1.0) > 1.0e-6) {  // rounding decides the very cycle
            ASSERT_EQ(drift.is_visible(), error > 1.0) << cycle;
        }
    }
    sil::SignalFault frozen{{FaultKind::frozen, FaultPlace::roll_angle, 0.0}};
    frozen.apply(sample_of(1.0), true);
    EXPECT_FALSE(frozen.is_visible());
    frozen.apply(sample_of(2.0), true);
    EXPECT_TRUE(frozen.is_visible());
}

// A supply or a connector of the IMU: all its signals, and no other.
TEST(SignalFault, ChangesAllSignalsThatFailTogether) {
    sil::SignalFault supply{{FaultKind::gain, FaultPlace::inertial_signals, 0.5}};
    const sil::SensorSample halved = supply.apply(sample_of(1.0), true);
    EXPECT_EQ(halved.lateral_acceleration_mps2, 0.5);
    EXPECT_EQ(halved.vertical_acceleration_mps2, 4.5);
    EXPECT_EQ(halved.roll_rate_radps, 0.05);
    EXPECT_EQ(halved.roll_angle_rad, 0.05);
    EXPECT_EQ(halved.yaw_rate_radps, 0.2);
    EXPECT_TRUE(supply.is_visible());
    sil::SignalFault connector{{FaultKind::not_available, FaultPlace::motion_signals, 0.0}};
    const sil::SensorSample unplugged = connector.apply(sample_of(1.0), true);
    EXPECT_TRUE(std::isnan(unplugged.speed_mps));
    EXPECT_TRUE(std::isnan(unplugged.yaw_rate_radps));
    EXPECT_TRUE(std::isnan(unplugged.steering_wheel_angle_rad));
    EXPECT_EQ(unplugged.roll_rate_radps, 0.1);
    sil::SignalFault gateway{{FaultKind::frozen, FaultPlace::all_signals, 0.0}};
    EXPECT_EQ(gateway.apply(sample_of(1.0), true).speed_mps, 20.0);
    const sil::SensorSample later = gateway.apply(sample_of(2.0), true);
    EXPECT_EQ(later.speed_mps, 20.0);
    EXPECT_EQ(later.roll_angle_rad, 0.05);
    EXPECT_EQ(gateway.apply(sample_of(2.0), false).speed_mps, 40.0);
    EXPECT_EQ(sil::signals_at(FaultPlace::all_signals).size(), 7U);  // a bank sensor is rare
    EXPECT_EQ(sil::signals_at(FaultPlace::vehicle_mass).size(), 1U);
    EXPECT_TRUE(sil::signals_at(FaultPlace::bus).empty());
}

TEST(SignalFault, ScalesTheSignalOrLeavesItsNoiseAlone) {
    const auto reported = [](const Fault& fault) {
        sil::SignalFault sensor{fault};
        return sensor.apply(sample_of(2.0), true).lateral_acceleration_mps2;
    };
    EXPECT_EQ(reported({FaultKind::gain, FaultPlace::lateral_acceleration, 0.0}), 0.0);
    EXPECT_EQ(reported({FaultKind::gain, FaultPlace::lateral_acceleration, 1.25}), 2.5);
    sil::SignalFault dead{{FaultKind::noise_alone, FaultPlace::lateral_acceleration, 0.2}};
    double sum_of_squares = 0.0;
    constexpr int count = 10000;
    for (int cycle = 0; cycle < count; ++cycle) {
        const double value = dead.apply(sample_of(2.0), true).lateral_acceleration_mps2;
        sum_of_squares += value * value;
    }
    EXPECT_NEAR(std::sqrt(sum_of_squares / count), 0.2, 0.01) << "whatever the signal";
}

TEST(FaultyBus, LeavesEverythingAloneOutsideTheFault) {
    for (const Fault& fault : all_and_further_signs()) {
        SCOPED_TRACE(describe(fault) + " of " + to_string(fault.place));
        const Injection injection{fault};
        for (const std::size_t cycle : {0U, 1U, 9U, 11U}) {
            ASSERT_EQ(injection.cycle(cycle).size(), 3U);
            EXPECT_EQ(imu_error(injection.cycle(cycle)[0]), CheckError::none);
        }
    }
}

TEST(FaultyBus, LosesFrames) {
    const Injection injection{{FaultKind::lost, FaultPlace::imu_frame, 0.0}};
    EXPECT_EQ(injection.cycle(4U).size(), 2U);
    EXPECT_EQ(injection.imu().size(), 6U);
    const Injection all{{FaultKind::lost, FaultPlace::all_sensor_frames, 0.0}};
    EXPECT_TRUE(all.cycle(4U).empty());
}

TEST(FaultyBus, DelaysFramesAndLosesNone) {
    const Injection injection{{FaultKind::delayed, FaultPlace::imu_frame, 20.0}};
    EXPECT_EQ(injection.cycle(2U).size(), 2U);
    EXPECT_EQ(injection.cycle(3U).size(), 2U);
    EXPECT_EQ(injection.cycle(4U).size(), 3U);
    EXPECT_EQ(counter_of(of_identifier(injection.cycle(4U), rsi::can_dbc::Imu::identifier).at(0)), 2U);
    EXPECT_EQ(injection.cycle(8U).size(), 5U) << "what was held back arrives at the end";
    ASSERT_EQ(injection.imu().size(), 12U);
    for (std::size_t index = 0U; index < 12U; ++index) {
        EXPECT_EQ(counter_of(injection.imu()[index]), index);
    }
}

TEST(FaultyBus, DamagesTheCrc) {
    const Injection injection{{FaultKind::bad_crc, FaultPlace::imu_frame, 0.0}};
    EXPECT_EQ(imu_error(injection.cycle(4U).at(0)), CheckError::crc);
}

TEST(FaultyBus, ShortensFrames) {
    const Injection injection{{FaultKind::wrong_length, FaultPlace::imu_frame, 0.0}};
    EXPECT_EQ(imu_error(injection.cycle(4U).at(0)), CheckError::length);
}

TEST(FaultyBus, HoldsOrMovesTheCounterUnderARightCrc) {
    const Injection standing{{FaultKind::counter_stands, FaultPlace::imu_frame, 0.0}};
    const Injection jumping{{FaultKind::counter_jumps, FaultPlace::imu_frame, 0.0}};
    for (std::size_t cycle = 2U; cycle < 8U; ++cycle) {
        EXPECT_EQ(imu_error(standing.cycle(cycle).at(0)), CheckError::none);
        EXPECT_EQ(counter_of(standing.cycle(cycle).at(0)), 2U);
        EXPECT_EQ(imu_error(jumping.cycle(cycle).at(0)), CheckError::none);
        EXPECT_EQ(counter_of(jumping.cycle(cycle).at(0)), (2U + 6U * (cycle - 2U)) % 15U);
    }
}

TEST(FaultyBus, ExchangesIdentifiersWithTheNextFrame) {
    const Injection injection{{FaultKind::swapped, FaultPlace::imu_frame, 0.0}};
    const std::vector<rsi::hal::CanFrame> right = injection.cycle(1U);
    const std::vector<rsi::hal::CanFrame> faulty = injection.cycle(2U);
    ASSERT_EQ(faulty.size(), 3U);
    EXPECT_EQ(faulty[0].identifier, right[1].identifier);
    EXPECT_EQ(faulty[1].identifier, right[0].identifier);
    EXPECT_EQ(faulty[2].identifier, right[2].identifier);
    EXPECT_EQ(faulty[0].data[2], right[0].data[2]) << "the content stays";
}

TEST(FaultyBus, DoublesFrames) {
    const Injection injection{{FaultKind::doubled, FaultPlace::imu_frame, 0.0}};
    const std::vector<rsi::hal::CanFrame> twice =
        of_identifier(injection.cycle(4U), rsi::can_dbc::Imu::identifier);
    ASSERT_EQ(twice.size(), 2U);
    EXPECT_EQ(twice[0].data, twice[1].data);
}

// Imu frames of a second sender among them; the genuine one says 1 m/s^2.
TEST(FaultyBus, ASecondSenderComesBeforeOrAfterTheGenuineOneWithAGoodCounter) {
    const auto lateral = [](const rsi::hal::CanFrame& frame) {
        return rsi::can_dbc::decode<rsi::can_dbc::Imu>(frame.data).value.lateral_acceleration_mps2;
    };
    const auto in_cycle_4 = [](FaultKind kind, double content) {
        const Injection injection{{kind, FaultPlace::imu_frame, content}};
        EXPECT_EQ(injection.cycle(4U).size(), kind == FaultKind::sender_tenfold ? 13U : 4U);
        std::vector<rsi::hal::CanFrame> frames =
            of_identifier(injection.cycle(4U), rsi::can_dbc::Imu::identifier);
        for (const rsi::hal::CanFrame& frame : frames) {
            EXPECT_EQ(imu_error(frame), CheckError::none);
        }
        return frames;
    };
    const std::vector<rsi::hal::CanFrame> before = in_cycle_4(FaultKind::sender_before, 1.0);
    ASSERT_EQ(before.size(), 2U);
    EXPECT_NEAR(lateral(before[0]), 8.0F, 0.01F);
    EXPECT_NEAR(lateral(before[1]), 1.0F, 0.01F);
    EXPECT_EQ(counter_of(before[0]), 4U);
    EXPECT_EQ(counter_of(before[1]), 4U);
    const std::vector<rsi::hal::CanFrame> after = in_cycle_4(FaultKind::sender_after, -1.0);
    ASSERT_EQ(after.size(), 2U);
    EXPECT_NEAR(lateral(after[0]), 1.0F, 0.01F);
    EXPECT_NEAR(lateral(after[1]), 0.0F, 0.01F);
    EXPECT_EQ(counter_of(after[0]), 4U);
    EXPECT_EQ(counter_of(after[1]), 5U);
    const std::vector<rsi::hal::CanFrame> tenfold = in_cycle_4(FaultKind::sender_tenfold, 1.0);
    ASSERT_EQ(tenfold.size(), 11U);
    for (std::size_t index = 2U; index < tenfold.size(); ++index) {
        EXPECT_EQ(counter_of(tenfold[index]), (counter_of(tenfold[index - 1U]) + 1U) % 15U);
    }
}

TEST(FaultyBus, ASecondSenderSpeaksForTheOtherSensorsAndForTheEcu) {
    const auto frames = [](FaultPlace place, std::uint32_t identifier, double content) {
        const Injection injection{{FaultKind::sender_before, place, content}};
        return of_identifier(injection.cycle(4U), identifier);
    };
    for (const double content : {1.0, -1.0}) {
        const bool alarming = content > 0.0;
        const auto roll = frames(FaultPlace::roll_angle_frame, rsi::can_dbc::RollAngle::identifier, content);
        ASSERT_EQ(roll.size(), 2U);
        EXPECT_NEAR(rsi::can_dbc::decode<rsi::can_dbc::RollAngle>(roll[0].data).value.roll_angle_deg,
                    alarming ? 9.0F : 0.0F, 0.01F);
        const auto motion =
            frames(FaultPlace::vehicle_motion_frame, rsi::can_dbc::VehicleMotion::identifier, content);
        ASSERT_EQ(motion.size(), 2U);
        EXPECT_NEAR(
            rsi::can_dbc::decode<rsi::can_dbc::VehicleMotion>(motion[0].data).value.yaw_rate_deg_per_s,
            alarming ? 20.0F : 0.0F, 0.01F);
        const auto warning =
            frames(FaultPlace::warning_frame, rsi::can_dbc::RolloverWarning::identifier, content);
        ASSERT_EQ(warning.size(), 1U);
        using Warning = rsi::can_dbc::RolloverWarning;
        EXPECT_EQ(rsi::can_dbc::decode<Warning>(warning[0].data).value.state,
                  alarming ? Warning::State::warning : Warning::State::ready);
    }
    const Injection tenfold{{FaultKind::sender_tenfold, FaultPlace::warning_frame, 1.0}};
    EXPECT_EQ(of_identifier(tenfold.cycle(4U), rsi::can_dbc::RolloverWarning::identifier).size(), 10U);
}

TEST(FaultyBus, FloodsBeforeTheSensorFrames) {
    const Injection foreign{{FaultKind::flood_foreign, FaultPlace::bus, 40.0}};
    EXPECT_EQ(foreign.cycle(4U).size(), 43U);
    EXPECT_EQ(foreign.cycle(4U).back().identifier, rsi::can_dbc::VehicleMotion::identifier);
    const Injection own{{FaultKind::flood_own, FaultPlace::bus, 40.0}};
    EXPECT_EQ(of_identifier(own.cycle(4U), rsi::can_dbc::Imu::identifier).size(), 41U);
    EXPECT_EQ(imu_error(own.cycle(4U).at(0)), CheckError::crc);
}

TEST(FaultyBus, SendsACodeOutOfRangeUnderARightCrc) {
    for (const sil::SensorSignal& signal : sil::sensor_signals) {
        SCOPED_TRACE(to_string(signal.place));
        const Injection injection{{FaultKind::out_of_range, signal.place, 0.0}};
        int out_of_range = 0;
        for (const rsi::hal::CanFrame& frame : injection.cycle(4U)) {
            rsi::can_dbc::visit_messages([&](auto type) {
                using Message = typename decltype(type)::Type;
                if (frame.identifier != Message::identifier) {
                    return;
                }
                EXPECT_EQ(rsi::can_dbc::e2e::verify_profile_11(frame.data.data(), frame.length,
                                                               Message::length, Message::e2e_data_id),
                          CheckError::none);
                Message::visit_signals([&](const char*, const char*, auto, auto status) {
                    const auto decoded = rsi::can_dbc::decode<Message>(frame.data);
                    out_of_range +=
                        decoded.status.*status == rsi::can_dbc::SignalStatus::out_of_range ? 1 : 0;
                });
            });
        }
        EXPECT_EQ(out_of_range, 1);
    }
}

}  // namespace
}  // namespace faults_test
