// The generated codec of rollover_warning.dbc: limits, rounding, saturation, missing values, independence of
// signals.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "rsi/can_dbc/generated/rollover_warning.hpp"
#include "sil/simulation/simulation.hpp"

namespace codec_test {
namespace {

using rsi::can_dbc::decode;
using rsi::can_dbc::Decoded;
using rsi::can_dbc::encode;
using rsi::can_dbc::Imu;
using rsi::can_dbc::RollAngle;
using rsi::can_dbc::RollCentreEstimate;
using rsi::can_dbc::RolloverStatus;
using rsi::can_dbc::RolloverWarning;
using rsi::can_dbc::SignalStatus;
using rsi::can_dbc::VehicleMotion;
using simulation_dbc::SimulationSync;

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float quiet_nan = std::numeric_limits<float>::quiet_NaN();

Imu imu_with_lateral_acceleration(float value) {
    Imu imu;
    imu.lateral_acceleration_mps2 = value;
    return imu;
}

std::uint16_t raw_of(float lateral_acceleration_mps2) {
    const auto payload = encode(imu_with_lateral_acceleration(lateral_acceleration_mps2));
    return static_cast<std::uint16_t>(payload[2] | (payload[3] << 8U));
}

Decoded<Imu> imu_from_raw(unsigned raw) {
    std::array<std::uint8_t, 8> payload{};
    payload[2] = static_cast<std::uint8_t>(raw & 0xFFU);
    payload[3] = static_cast<std::uint8_t>(raw >> 8U);
    return decode<Imu>(payload);
}

constexpr RolloverWarning some_warning() {
    RolloverWarning warning;
    warning.state = RolloverWarning::State::warning;
    warning.side = RolloverWarning::Side::right;
    warning.warning_level = 1.5F;
    warning.lateral_acceleration_mps2 = -8.0F;
    warning.lateral_acceleration_threshold_mps2 = -7.5F;
    return warning;
}

TEST(Codec, WorksAtCompileTime) {
    constexpr auto payload = encode(some_warning());
    constexpr auto decoded = decode<RolloverWarning>(payload);
    static_assert(decoded.status.all_valid());
    static_assert(decoded.value.state == RolloverWarning::State::warning);
    static_assert(decoded.value.lateral_acceleration_mps2 == -8.0F);
    constexpr auto saturated = encode(VehicleMotion{1.0e38F, -infinity, quiet_nan});
    static_assert(saturated[2] == 0x40U && saturated[3] == 0x9CU);  // 400 km/h is 40000
    EXPECT_TRUE(decoded.status.all_valid());
}

TEST(Codec, LaysOutTheWarningFrameAsTheDbcFileSays) {
    // state 3 | side 2 << 3 | indicator 3000 << 8 | acceleration -1600 << 20 | threshold -1500 << 34, all
    // from bit 16 on
    const std::uint64_t bits =
        3ULL | (2ULL << 3U) | (3000ULL << 8U) | ((16384ULL - 1600ULL) << 20U) | ((16384ULL - 1500ULL) << 34U);
    const auto payload = encode(some_warning());
    EXPECT_EQ(payload[0], 0U);
    EXPECT_EQ(payload[1], 0U);
    for (unsigned byte = 2U; byte < 8U; ++byte) {
        EXPECT_EQ(payload[byte], (bits >> (8U * (byte - 2U))) & 0xFFU) << "byte " << byte;
    }
}

TEST(Codec, SendsTheRollAngleInMotorolaOrder) {
    RollAngle roll_angle;
    roll_angle.roll_angle_deg = 5.0F;   // 1000 = 0x03E8
    roll_angle.bank_angle_deg = -1.0F;  // -200 = 0xFF38
    EXPECT_EQ(encode(roll_angle), (std::array<std::uint8_t, 8>{0U, 0U, 0x03U, 0xE8U, 0xFFU, 0x38U, 0U, 0U}));
}

TEST(Codec, RoundsToTheNearestCodeAndHalvesAwayFromZero) {
    EXPECT_EQ(raw_of(0.0029F), 1U);
    EXPECT_EQ(raw_of(0.0031F), 2U);
    EXPECT_EQ(raw_of(-0.0031F), 0xFFFEU);
    RollCentreEstimate estimate;  // 50 N m/rad a code: halves are exact in float
    for (const auto& [value, raw] :
         {std::pair{25.0F, 1}, {24.999F, 0}, {75.0F, 2}, {-25.0F, -1}, {-24.999F, 0}, {-75.0F, -2}}) {
        estimate.roll_stiffness_deviation_nmprad = value;
        const auto payload = encode(estimate);
        EXPECT_EQ((payload[5] | (payload[6] << 8U)) & 0xFFF, raw & 0xFFF) << value;
    }
}

TEST(Codec, SaturatesWhateverIsBeyondTheRange) {
    for (const float value : {60.0F, 60.0001F, 65.6F, 1.0e30F, std::numeric_limits<float>::max(), infinity}) {
        EXPECT_EQ(raw_of(value), 30000U) << value;
        EXPECT_EQ(raw_of(-value), 65536U - 30000U) << -value;
    }
    VehicleMotion motion;
    motion.speed_kmh = -3.0F;
    EXPECT_EQ(decode<VehicleMotion>(encode(motion)).value.speed_kmh, 0.0F);
}

TEST(Codec, SendsNanAsNotAvailable) {
    EXPECT_EQ(raw_of(quiet_nan), 0x8000U);
    EXPECT_EQ(raw_of(-quiet_nan), 0x8000U);
    const auto decoded = imu_from_raw(0x8000U);
    EXPECT_EQ(decoded.status.lateral_acceleration_mps2, SignalStatus::not_available);
    EXPECT_TRUE(std::isnan(decoded.value.lateral_acceleration_mps2));
}

TEST(Codec, SendsBothZerosAndTheSmallestNumbersAsZero) {
    for (const float value :
         {0.0F, -0.0F, std::numeric_limits<float>::denorm_min(), -std::numeric_limits<float>::min()}) {
        EXPECT_EQ(raw_of(value), 0U);
    }
    EXPECT_FALSE(std::signbit(imu_from_raw(0U).value.lateral_acceleration_mps2));
}

TEST(Codec, MarksEveryCodeOutsideTheRangeAndGivesNoValueForIt) {
    for (unsigned raw = 0U; raw < 0x10000U; ++raw) {
        const int signed_raw = raw < 0x8000U ? static_cast<int>(raw) : static_cast<int>(raw) - 0x10000;
        const auto decoded = imu_from_raw(raw);
        const float value = decoded.value.lateral_acceleration_mps2;
        if (raw == 0x8000U) {
            EXPECT_EQ(decoded.status.lateral_acceleration_mps2, SignalStatus::not_available);
        } else if (signed_raw < -30000 || signed_raw > 30000) {
            EXPECT_EQ(decoded.status.lateral_acceleration_mps2, SignalStatus::out_of_range) << raw;
            EXPECT_TRUE(std::isnan(value));
        } else {
            EXPECT_EQ(decoded.status.lateral_acceleration_mps2, SignalStatus::valid) << raw;
            EXPECT_EQ(value, static_cast<float>(0.002 * signed_raw)) << raw;
            EXPECT_EQ(raw_of(value), raw);
        }
    }
}

TEST(Codec, MarksAnUnknownEnumerationValue) {
    std::array<std::uint8_t, 8> payload{};
    payload[2] = 0x1CU;  // state 4, side 3
    const auto decoded = decode<RolloverWarning>(payload);
    EXPECT_EQ(decoded.status.state, SignalStatus::out_of_range);
    EXPECT_EQ(decoded.value.state, RolloverWarning::State::unavailable);
    EXPECT_EQ(decoded.status.side, SignalStatus::out_of_range);
    EXPECT_EQ(decoded.value.side, RolloverWarning::Side::none);
    RolloverWarning warning;
    warning.state = static_cast<RolloverWarning::State>(5);
    EXPECT_EQ(encode(warning)[2] & 7U, 0U);
}

TEST(Codec, StartsWithNothingAvailable) {
    const auto imu = decode<Imu>(encode(Imu{}));
    EXPECT_EQ(imu.status.lateral_acceleration_mps2, SignalStatus::not_available);
    EXPECT_EQ(imu.status.vertical_acceleration_mps2, SignalStatus::not_available);
    EXPECT_EQ(imu.status.roll_rate_deg_per_s, SignalStatus::not_available);
    EXPECT_FALSE(imu.status.all_valid());
    EXPECT_EQ(RolloverWarning{}.state, RolloverWarning::State::unavailable);
}

TEST(Codec, CarriesEveryBitOfTheCycleNumber) {
    for (const std::uint32_t number : {0U, 1U, 0x80U, 0x12345678U, 0x80000000U, 0xFFFFFFFFU}) {
        SimulationSync sync;
        sync.cycle_number = number;
        const auto payload = encode(sync);
        EXPECT_EQ(payload.size(), 4U);
        EXPECT_EQ(decode<SimulationSync>(payload).value.cycle_number, number);
    }
}

TEST(Codec, TakesTheSignalsOfAMessageFromTheirSources) {
    struct {
        float observed_roll_angle_rad{0.5F};
        float observed_bank_angle_rad{-0.25F};
        float roll_centre_deviation_m{0.125F};
        std::int32_t roll_source{2};
        std::int32_t roll_sensor_disagrees{1};
        std::int32_t estimate_frozen{0};
    } source;
    rsi::can_dbc::RollObserver message;
    message.reset_reason = rsi::can_dbc::RollObserver::ResetReason::interrupt;
    message.take(source);
    EXPECT_FLOAT_EQ(message.observed_roll_angle_deg, 28.64789F);
    EXPECT_FLOAT_EQ(message.observed_bank_angle_deg, -14.323945F);
    EXPECT_EQ(message.roll_centre_deviation_m, 0.125F);
    EXPECT_EQ(message.roll_source, rsi::can_dbc::RollObserver::RollSource::observer);
    EXPECT_TRUE(message.roll_sensor_disagrees);
    EXPECT_FALSE(message.estimate_frozen);
    EXPECT_EQ(message.reset_reason, rsi::can_dbc::RollObserver::ResetReason::interrupt);  // has no source
}

TEST(Codec, ListsWhatANodeSendsInTheFilesOrder) {
    std::vector<std::string> names;
    rsi::can_dbc::MessagesFromRolloverEcu::visit(
        [&names](auto type) { names.emplace_back(decltype(type)::Type::name); });
    EXPECT_EQ(names.size(), rsi::can_dbc::MessagesFromRolloverEcu::size);
    EXPECT_EQ(names.front(), "RolloverWarning");  // it matters most
    EXPECT_EQ(names.back(), "RolloverStatus");    // with it the cycle is complete
    EXPECT_EQ(std::count(names.begin(), names.end(), "Imu"), 0);
}

TEST(Codec, DecodesFromALargerBuffer) {
    std::array<std::uint8_t, 64> data{};
    const auto payload = encode(imu_with_lateral_acceleration(3.0F));
    std::copy(payload.begin(), payload.end(), data.begin());
    EXPECT_EQ(decode<Imu>(data).value.lateral_acceleration_mps2, 3.0F);
}

TEST(Codec, NamesTheEnumeratorsAsTheDbcFileDoes) {
    EXPECT_STREQ(RolloverWarning::name_of(RolloverWarning::State::advisory), "advisory");
    EXPECT_STREQ(RolloverWarning::name_of(static_cast<RolloverWarning::State>(7)), "unknown");
}

TEST(Codec, KeepsDistinctIdentifiersAndDataIdentifiers) {
    std::vector<std::uint32_t> identifiers;
    std::vector<std::uint16_t> low_bytes_of_data_ids;
    rsi::can_dbc::visit_messages([&](auto message) {
        using Message = typename decltype(message)::Type;
        EXPECT_EQ(std::count(identifiers.begin(), identifiers.end(), Message::identifier), 0);
        identifiers.push_back(Message::identifier);
        EXPECT_TRUE(Message::e2e_protected);
        EXPECT_NE(Message::identifier, SimulationSync::identifier);
        if (Message::e2e_protected) {
            const std::uint16_t low_byte = Message::e2e_data_id & 0xFFU;
            EXPECT_EQ(std::count(low_bytes_of_data_ids.begin(), low_bytes_of_data_ids.end(), low_byte), 0);
            low_bytes_of_data_ids.push_back(low_byte);
        }
    });
    EXPECT_EQ(identifiers.size(), 12U);
}

}  // namespace
}  // namespace codec_test
