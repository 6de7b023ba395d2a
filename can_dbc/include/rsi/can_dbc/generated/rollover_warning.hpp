// Codec of rollover_warning.dbc, written by can_dbc/generator/generate.py: change the DBC file, not this one.
// clang-format off
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "rsi/can_dbc/codec/integer_signal.hpp"
#include "rsi/can_dbc/codec/message.hpp"
#include "rsi/can_dbc/codec/physical_signal.hpp"

namespace rsi::can_dbc {

// Inertial measurement unit: lateral and vertical specific force and roll rate, body-fixed, axes of ISO 8855.
// From ImuSensor to RolloverEcu, every 10 ms.
struct Imu {
    static constexpr const char* name{"Imu"};
    static constexpr std::uint32_t identifier{0x120U};
    static constexpr bool extended{false};
    static constexpr bool flexible_data_rate{false};
    static constexpr std::uint8_t length{8U};
    static constexpr std::uint16_t cycle_time_ms{10U};
    static constexpr bool e2e_protected{true};
    static constexpr std::uint8_t e2e_profile{11U};
    static constexpr bool has_sources{false};
    static constexpr std::uint16_t e2e_data_id{0x3A7U};

    // Specific force along the body's y axis, positive to the left. m/s^2, -60 to 60.
    float lateral_acceleration_mps2{not_available};
    // Specific force along the body's z axis, positive upwards, +9.81 at rest on level ground. m/s^2, -60 to 60.
    float vertical_acceleration_mps2{not_available};
    // Angular velocity about the body's x axis, positive when the right side moves down. deg/s, -300 to 300.
    float roll_rate_deg_per_s{not_available};

    struct Status {
        SignalStatus lateral_acceleration_mps2{SignalStatus::not_available};
        SignalStatus vertical_acceleration_mps2{SignalStatus::not_available};
        SignalStatus roll_rate_deg_per_s{SignalStatus::not_available};

        constexpr bool all_valid() const {
            return lateral_acceleration_mps2 == SignalStatus::valid &&
                   vertical_acceleration_mps2 == SignalStatus::valid &&
                   roll_rate_deg_per_s == SignalStatus::valid;
        }
    };

    struct Signals {
        static constexpr PhysicalSignal<std::int32_t> lateral_acceleration_mps2{
            {ByteOrder::little_endian, 16U, 16U, true}, 1.0F, 0.0F, 500.0F, -60.0F, 60.0F,
            -30000, 30000, -32768, true};
        static constexpr PhysicalSignal<std::int32_t> vertical_acceleration_mps2{
            {ByteOrder::little_endian, 32U, 16U, true}, 1.0F, 0.0F, 500.0F, -60.0F, 60.0F,
            -30000, 30000, -32768, true};
        static constexpr PhysicalSignal<std::int32_t> roll_rate_deg_per_s{
            {ByteOrder::little_endian, 48U, 16U, true}, 1.0F, 0.0F, 100.0F, -300.0F, 300.0F,
            -30000, 30000, -32768, true};
    };

    // See rsi::can_dbc::encode and decode.
    constexpr std::array<std::uint8_t, length> encode() const {
        std::array<std::uint8_t, length> payload{};
        write_signal(Signals::lateral_acceleration_mps2, lateral_acceleration_mps2, payload.data());
        write_signal(Signals::vertical_acceleration_mps2, vertical_acceleration_mps2, payload.data());
        write_signal(Signals::roll_rate_deg_per_s, roll_rate_deg_per_s, payload.data());
        return payload;
    }

    static constexpr Decoded<Imu> decode(const std::uint8_t* payload);

    // Calls visitor(name, unit, member, status member) for each signal.
    template <typename Visitor>
    static constexpr void visit_signals(Visitor&& visitor) {
        visitor("LateralAcceleration", "m/s^2", &Imu::lateral_acceleration_mps2, &Status::lateral_acceleration_mps2);
        visitor("VerticalAcceleration", "m/s^2", &Imu::vertical_acceleration_mps2, &Status::vertical_acceleration_mps2);
        visitor("RollRate", "deg/s", &Imu::roll_rate_deg_per_s, &Status::roll_rate_deg_per_s);
    }
};

constexpr Decoded<Imu> Imu::decode(const std::uint8_t* payload) {
    Decoded<Imu> decoded{};
    read_signal(Signals::lateral_acceleration_mps2, payload, decoded.value.lateral_acceleration_mps2, decoded.status.lateral_acceleration_mps2);
    read_signal(Signals::vertical_acceleration_mps2, payload, decoded.value.vertical_acceleration_mps2, decoded.status.vertical_acceleration_mps2);
    read_signal(Signals::roll_rate_deg_per_s, payload, decoded.value.roll_rate_deg_per_s, decoded.status.roll_rate_deg_per_s);
    return decoded;
}

// Roll angle of the body, relative to the road or to the horizon, and bank angle of the road; big-endian.
// From RollAngleSensor to RolloverEcu, every 10 ms.
struct RollAngle {
    static constexpr const char* name{"RollAngle"};
    static constexpr std::uint32_t identifier{0x121U};
    static constexpr bool extended{false};
    static constexpr bool flexible_data_rate{false};
    static constexpr std::uint8_t length{8U};
    static constexpr std::uint16_t cycle_time_ms{10U};
    static constexpr bool e2e_protected{true};
    static constexpr std::uint8_t e2e_profile{11U};
    static constexpr bool has_sources{false};
    static constexpr std::uint16_t e2e_data_id{0x45CU};

    // Roll angle of the body, positive with the right side down: relative to the road or to the horizon, as the parameter roll_angle_reference of the receiver says. deg, -120 to 120.
    float roll_angle_deg{not_available};
    // Bank angle of the road, positive with the left side up. Not available where the vehicle cannot measure it. deg, -45 to 45.
    float bank_angle_deg{not_available};

    struct Status {
        SignalStatus roll_angle_deg{SignalStatus::not_available};
        SignalStatus bank_angle_deg{SignalStatus::not_available};

        constexpr bool all_valid() const {
            return roll_angle_deg == SignalStatus::valid &&
                   bank_angle_deg == SignalStatus::valid;
        }
    };

    struct Signals {
        static constexpr PhysicalSignal<std::int32_t> roll_angle_deg{
            {ByteOrder::big_endian, 23U, 16U, true}, 1.0F, 0.0F, 200.0F, -120.0F, 120.0F,
            -24000, 24000, -32768, true};
        static constexpr PhysicalSignal<std::int32_t> bank_angle_deg{
            {ByteOrder::big_endian, 39U, 16U, true}, 1.0F, 0.0F, 200.0F, -45.0F, 45.0F,
            -9000, 9000, -32768, true};
    };

    // See rsi::can_dbc::encode and decode.
    constexpr std::array<std::uint8_t, length> encode() const {
        std::array<std::uint8_t, length> payload{};
        write_signal(Signals::roll_angle_deg, roll_angle_deg, payload.data());
        write_signal(Signals::bank_angle_deg, bank_angle_deg, payload.data());
        return payload;
    }

    static constexpr Decoded<RollAngle> decode(const std::uint8_t* payload);

    // Calls visitor(name, unit, member, status member) for each signal.
    template <typename Visitor>
    static constexpr void visit_signals(Visitor&& visitor) {
        visitor("RollAngle", "deg", &RollAngle::roll_angle_deg, &Status::roll_angle_deg);
        visitor("BankAngle", "deg", &RollAngle::bank_angle_deg, &Status::bank_angle_deg);
    }
};

constexpr Decoded<RollAngle> RollAngle::decode(const std::uint8_t* payload) {
    Decoded<RollAngle> decoded{};
    read_signal(Signals::roll_angle_deg, payload, decoded.value.roll_angle_deg, decoded.status.roll_angle_deg);
    read_signal(Signals::bank_angle_deg, payload, decoded.value.bank_angle_deg, decoded.status.bank_angle_deg);
    return decoded;
}

// Motion of the vehicle as other control units know it: speed, yaw rate, steering-wheel angle.
// From VehicleGateway to RolloverEcu, every 10 ms.
struct VehicleMotion {
    static constexpr const char* name{"VehicleMotion"};
    static constexpr std::uint32_t identifier{0x122U};
    static constexpr bool extended{false};
    static constexpr bool flexible_data_rate{false};
    static constexpr std::uint8_t length{8U};
    static constexpr std::uint16_t cycle_time_ms{10U};
    static constexpr bool e2e_protected{true};
    static constexpr std::uint8_t e2e_profile{11U};
    static constexpr bool has_sources{false};
    static constexpr std::uint16_t e2e_data_id{0x5B1U};

    // Speed over ground along the vehicle's x axis. km/h, 0 to 400.
    float speed_kmh{not_available};
    // Angular velocity about the vehicle's z axis, positive in a left turn. deg/s, -300 to 300.
    float yaw_rate_deg_per_s{not_available};
    // Angle of the steering wheel, positive to the left. deg, -1200 to 1200.
    float steering_wheel_angle_deg{not_available};

    struct Status {
        SignalStatus speed_kmh{SignalStatus::not_available};
        SignalStatus yaw_rate_deg_per_s{SignalStatus::not_available};
        SignalStatus steering_wheel_angle_deg{SignalStatus::not_available};

        constexpr bool all_valid() const {
            return speed_kmh == SignalStatus::valid &&
                   yaw_rate_deg_per_s == SignalStatus::valid &&
                   steering_wheel_angle_deg == SignalStatus::valid;
        }
    };

    struct Signals {
        static constexpr PhysicalSignal<std::int32_t> speed_kmh{
            {ByteOrder::little_endian, 16U, 16U, false}, 1.0F, 0.0F, 100.0F, 0.0F, 400.0F,
            0, 40000, 65535, true};
        static constexpr PhysicalSignal<std::int32_t> yaw_rate_deg_per_s{
            {ByteOrder::little_endian, 32U, 16U, true}, 1.0F, 0.0F, 100.0F, -300.0F, 300.0F,
            -30000, 30000, -32768, true};
        static constexpr PhysicalSignal<std::int32_t> steering_wheel_angle_deg{
            {ByteOrder::little_endian, 48U, 16U, true}, 1.0F, 0.0F, 10.0F, -1200.0F, 1200.0F,
            -12000, 12000, -32768, true};
    };

    // See rsi::can_dbc::encode and decode.
    constexpr std::array<std::uint8_t, length> encode() const {
        std::array<std::uint8_t, length> payload{};
        write_signal(Signals::speed_kmh, speed_kmh, payload.data());
        write_signal(Signals::yaw_rate_deg_per_s, yaw_rate_deg_per_s, payload.data());
        write_signal(Signals::steering_wheel_angle_deg, steering_wheel_angle_deg, payload.data());
        return payload;
    }

    static constexpr Decoded<VehicleMotion> decode(const std::uint8_t* payload);

    // Calls visitor(name, unit, member, status member) for each signal.
    template <typename Visitor>
    static constexpr void visit_signals(Visitor&& visitor) {
        visitor("Speed", "km/h", &VehicleMotion::speed_kmh, &Status::speed_kmh);
        visitor("YawRate", "deg/s", &VehicleMotion::yaw_rate_deg_per_s, &Status::yaw_rate_deg_per_s);
        visitor("SteeringWheelAngle", "deg", &VehicleMotion::steering_wheel_angle_deg, &Status::steering_wheel_angle_deg);
    }
};

constexpr Decoded<VehicleMotion> VehicleMotion::decode(const std::uint8_t* payload) {
    Decoded<VehicleMotion> decoded{};
    read_signal(Signals::speed_kmh, payload, decoded.value.speed_kmh, decoded.status.speed_kmh);
    read_signal(Signals::yaw_rate_deg_per_s, payload, decoded.value.yaw_rate_deg_per_s, decoded.status.yaw_rate_deg_per_s);
    read_signal(Signals::steering_wheel_angle_deg, payload, decoded.value.steering_wheel_angle_deg, decoded.status.steering_wheel_angle_deg);
    return decoded;
}

// Mass of the vehicle as other control units know it: vehicle weight, or axle loads added up. Optional: nothing is missed where it does not come.
// From VehicleGateway to RolloverEcu, every 10 ms.
struct VehicleMass {
    static constexpr const char* name{"VehicleMass"};
    static constexpr std::uint32_t identifier{0x123U};
    static constexpr bool extended{false};
    static constexpr bool flexible_data_rate{false};
    static constexpr std::uint8_t length{8U};
    static constexpr std::uint16_t cycle_time_ms{10U};
    static constexpr bool e2e_protected{true};
    static constexpr std::uint8_t e2e_profile{11U};
    static constexpr bool has_sources{false};
    static constexpr std::uint16_t e2e_data_id{0xEA1U};

    // Mass of the whole vehicle with what it carries, without a trailer. kg, 0 to 100000.
    float mass_kg{not_available};

    struct Status {
        SignalStatus mass_kg{SignalStatus::not_available};

        constexpr bool all_valid() const {
            return mass_kg == SignalStatus::valid;
        }
    };

    struct Signals {
        static constexpr PhysicalSignal<std::int32_t> mass_kg{
            {ByteOrder::little_endian, 16U, 16U, false}, 10.0F, 0.0F, 1.0F, 0.0F, 100000.0F,
            0, 10000, 65535, true};
    };

    // See rsi::can_dbc::encode and decode.
    constexpr std::array<std::uint8_t, length> encode() const {
        std::array<std::uint8_t, length> payload{};
        write_signal(Signals::mass_kg, mass_kg, payload.data());
        return payload;
    }

    static constexpr Decoded<VehicleMass> decode(const std::uint8_t* payload);

    // Calls visitor(name, unit, member, status member) for each signal.
    template <typename Visitor>
    static constexpr void visit_signals(Visitor&& visitor) {
        visitor("Mass", "kg", &VehicleMass::mass_kg, &Status::mass_kg);
    }
};

constexpr Decoded<VehicleMass> VehicleMass::decode(const std::uint8_t* payload) {
    Decoded<VehicleMass> decoded{};
    read_signal(Signals::mass_kg, payload, decoded.value.mass_kg, decoded.status.mass_kg);
    return decoded;
}

// Rollover warning: state, side, reason of refused parameters, warning level, lateral acceleration and its threshold.
// From RolloverEcu to VehicleGateway, every 10 ms.
struct RolloverWarning {
    // Warning state.
    enum class State : std::uint8_t {
        unavailable = 0,
        ready = 1,
        advisory = 2,
        warning = 3,
    };

    // Side towards which the vehicle would fall; none too where the state is only held and the load has gone to the other side.
    enum class Side : std::uint8_t {
        none = 0,
        left = 1,
        right = 2,
    };

    // Why the vehicle parameters were refused.
    enum class ParametersRefusal : std::uint8_t {
        none = 0,
        missing = 1,
        version = 2,
        layout = 3,
        length = 4,
        checksum = 5,
        value = 6,
        unauthentic = 7,
    };

    static constexpr const char* name{"RolloverWarning"};
    static constexpr std::uint32_t identifier{0x0D0U};
    static constexpr bool extended{false};
    static constexpr bool flexible_data_rate{false};
    static constexpr std::uint8_t length{8U};
    static constexpr std::uint16_t cycle_time_ms{10U};
    static constexpr bool e2e_protected{true};
    static constexpr std::uint8_t e2e_profile{11U};
    static constexpr bool has_sources{true};
    static constexpr std::uint16_t e2e_data_id{0x61EU};

    // Warning state.
    State state{State::unavailable};
    // Side towards which the vehicle would fall; none too where the state is only held and the load has gone to the other side.
    Side side{Side::none};
    // Why the vehicle parameters were refused.
    ParametersRefusal parameters_refusal{ParametersRefusal::none};
    // Level of the index that drives the warning: 0 without risk, 1 at the rollover threshold. Dimensionless, 0 to 2.
    float warning_level{not_available};
    // Lateral acceleration that was compared with the threshold, positive to the left. m/s^2, -40 to 40.
    float lateral_acceleration_mps2{not_available};
    // Lateral acceleration at which the vehicle would roll over, with the sign of the turn's side. m/s^2, -40 to 40.
    float lateral_acceleration_threshold_mps2{not_available};

    struct Status {
        SignalStatus state{SignalStatus::not_available};
        SignalStatus side{SignalStatus::not_available};
        SignalStatus parameters_refusal{SignalStatus::not_available};
        SignalStatus warning_level{SignalStatus::not_available};
        SignalStatus lateral_acceleration_mps2{SignalStatus::not_available};
        SignalStatus lateral_acceleration_threshold_mps2{SignalStatus::not_available};

        constexpr bool all_valid() const {
            return state == SignalStatus::valid &&
                   side == SignalStatus::valid &&
                   parameters_refusal == SignalStatus::valid &&
                   warning_level == SignalStatus::valid &&
                   lateral_acceleration_mps2 == SignalStatus::valid &&
                   lateral_acceleration_threshold_mps2 == SignalStatus::valid;
        }
    };

    struct Signals {
        static constexpr EnumerationSignal state{
            {ByteOrder::little_endian, 16U, 3U, false}, 0, false, 0};
        static constexpr EnumerationSignal side{
            {ByteOrder::little_endian, 19U, 2U, false}, 0, false, 0};
        static constexpr EnumerationSignal parameters_refusal{
            {ByteOrder::little_endian, 21U, 3U, false}, 0, false, 0};
        static constexpr PhysicalSignal<std::int32_t> warning_level{
            {ByteOrder::little_endian, 24U, 12U, false}, 1.0F, 0.0F, 2000.0F, 0.0F, 2.0F,
            0, 4000, 4095, true};
        static constexpr PhysicalSignal<std::int32_t> lateral_acceleration_mps2{
            {ByteOrder::little_endian, 36U, 14U, true}, 1.0F, 0.0F, 200.0F, -40.0F, 40.0F,
            -8000, 8000, -8192, true};
        static constexpr PhysicalSignal<std::int32_t> lateral_acceleration_threshold_mps2{
            {ByteOrder::little_endian, 50U, 14U, true}, 1.0F, 0.0F, 200.0F, -40.0F, 40.0F,
            -8000, 8000, -8192, true};
    };

    static constexpr bool is_known(State value) {
        switch (value) {
            case State::unavailable:
            case State::ready:
            case State::advisory:
            case State::warning:
                return true;
        }
        return false;
    }

    // The value's name in the DBC file, or "unknown".
    static constexpr const char* name_of(State value) {
        switch (value) {
            case State::unavailable:
                return "unavailable";
            case State::ready:
                return "ready";
            case State::advisory:
                return "advisory";
            case State::warning:
                return "warning";
        }
        return "unknown";
    }

    static constexpr bool is_known(Side value) {
        switch (value) {
            case Side::none:
            case Side::left:
            case Side::right:
                return true;
        }
        return false;
    }

    // The value's name in the DBC file, or "unknown".
    static constexpr const char* name_of(Side value) {
        switch (value) {
            case Side::none:
                return "none";
            case Side::left:
                return "left";
            case Side::right:
                return "right";
        }
        return "unknown";
    }

    static constexpr bool is_known(ParametersRefusal value) {
        switch (value) {
            case ParametersRefusal::none:
            case ParametersRefusal::missing:
            case ParametersRefusal::version:
            case ParametersRefusal::layout:
            case ParametersRefusal::length:
            case ParametersRefusal::checksum:
            case ParametersRefusal::value:
            case ParametersRefusal::unauthentic:
                return true;
        }
        return false;
    }

    // The value's name in the DBC file, or "unknown".
    static constexpr const char* name_of(ParametersRefusal value) {
        switch (value) {
            case ParametersRefusal::none:
                return "none";
            case ParametersRefusal::missing:
                return "missing";
            case ParametersRefusal::version:
                return "version";
            case ParametersRefusal::layout:
                return "layout";
            case ParametersRefusal::length:
                return "length";
            case ParametersRefusal::checksum:
                return "checksum";
            case ParametersRefusal::value:
                return "value";
            case ParametersRefusal::unauthentic:
                return "unauthentic";
        }
        return "unknown";
    }

    // See rsi::can_dbc::encode and decode.
    constexpr std::array<std::uint8_t, length> encode() const {
        std::array<std::uint8_t, length> payload{};
        write_enumeration(Signals::state, &RolloverWarning::is_known, state, payload.data());
        write_enumeration(Signals::side, &RolloverWarning::is_known, side, payload.data());
        write_enumeration(Signals::parameters_refusal, &RolloverWarning::is_known, parameters_refusal, payload.data());
        write_signal(Signals::warning_level, warning_level, payload.data());
        write_signal(Signals::lateral_acceleration_mps2, lateral_acceleration_mps2, payload.data());
        write_signal(Signals::lateral_acceleration_threshold_mps2, lateral_acceleration_threshold_mps2, payload.data());
        return payload;
    }

    static constexpr Decoded<RolloverWarning> decode(const std::uint8_t* payload);

    // Takes from a structure of the sender what the attribute Source names.
    template <typename Source>
    constexpr void take(const Source& source) {
        state = static_cast<State>(source.state);
        side = static_cast<Side>(source.side);
        warning_level = source.warning_level;
        lateral_acceleration_mps2 = source.lateral_acceleration_mps2;
        lateral_acceleration_threshold_mps2 = source.lateral_acceleration_threshold_mps2;
    }

    // Calls visitor(field's name, source's name, member) for each of these signals.
    template <typename Visitor>
    static constexpr void visit_sources(Visitor&& visitor) {
        visitor("state", "state", &RolloverWarning::state);
        visitor("side", "side", &RolloverWarning::side);
        visitor("warning_level", "warning_level", &RolloverWarning::warning_level);
        visitor("lateral_acceleration_mps2", "lateral_acceleration_mps2", &RolloverWarning::lateral_acceleration_mps2);
        visitor("lateral_acceleration_threshold_mps2", "lateral_acceleration_threshold_mps2", &RolloverWarning::lateral_acceleration_threshold_mps2);
    }

    // Calls visitor(name, unit, member, status member) for each signal.
    template <typename Visitor>
    static constexpr void visit_signals(Visitor&& visitor) {
        visitor("State", "-", &RolloverWarning::state, &Status::state);
        visitor("Side", "-", &RolloverWarning::side, &Status::side);
        visitor("ParametersRefusal", "-", &RolloverWarning::parameters_refusal, &Status::parameters_refusal);
        visitor("WarningLevel", "-", &RolloverWarning::warning_level, &Status::warning_level);
        visitor("LateralAcceleration", "m/s^2", &RolloverWarning::lateral_acceleration_mps2, &Status::lateral_acceleration_mps2);
        visitor("LateralAccelerationThreshold", "m/s^2", &RolloverWarning::lateral_acceleration_threshold_mps2, &Status::lateral_acceleration_threshold_mps2);
    }
};

constexpr Decoded<RolloverWarning> RolloverWarning::decode(const std::uint8_t* payload) {
    Decoded<RolloverWarning> decoded{};
    read_enumeration(Signals::state, &RolloverWarning::is_known, payload, decoded.value.state, decoded.status.state);
    read_enumeration(Signals::side, &RolloverWarning::is_known, payload, decoded.value.side, decoded.status.side);
    read_enumeration(Signals::parameters_refusal, &RolloverWarning::is_known, payload, decoded.value.parameters_refusal, decoded.status.parameters_refusal);
    read_signal(Signals::warning_level, payload, decoded.value.warning_level, decoded.status.warning_level);
    read_signal(Signals::lateral_acceleration_mps2, payload, decoded.value.lateral_acceleration_mps2, decoded.status.lateral_acceleration_mps2);
    read_signal(Signals::lateral_acceleration_threshold_mps2, payload, decoded.value.lateral_acceleration_threshold_mps2, decoded.status.lateral_acceleration_threshold_mps2);
    return decoded;
}

// Suspension as the estimator has learnt it: movement of the roll centre, deviations of roll stiffness and damping.
// From RolloverEcu to VehicleGateway, every 10 ms.
struct RollCentreEstimate {
    static constexpr const char* name{"RollCentreEstimate"};
    static constexpr std::uint32_t identifier{0x230U};
    static constexpr bool extended{false};
    static constexpr bool flexible_data_rate{false};
    static constexpr std::uint8_t length{8U};
    static constexpr std::uint16_t cycle_time_ms{10U};
    static constexpr bool e2e_protected{true};
    static constexpr std::uint8_t e2e_profile{11U};
    static constexpr bool has_sources{true};
    static constexpr std::uint16_t e2e_data_id{0x7D4U};

    // Vertical movement of the roll centre from its nominal place, positive upwards. m, -1 to 1.
    float roll_centre_vertical_m{not_available};
    // Lateral movement of the roll centre from its nominal place, positive to the left. m, -1 to 1.
    float roll_centre_lateral_m{not_available};
    // Deviation of the roll stiffness from its nominal value. N m/rad, -100000 to 100000.
    float roll_stiffness_deviation_nmprad{not_available};
    // Deviation of the roll damping from its nominal value. N m s/rad, -20000 to 20000.
    float roll_damping_deviation_nmsprad{not_available};

    struct Status {
        SignalStatus roll_centre_vertical_m{SignalStatus::not_available};
        SignalStatus roll_centre_lateral_m{SignalStatus::not_available};
        SignalStatus roll_stiffness_deviation_nmprad{SignalStatus::not_available};
        SignalStatus roll_damping_deviation_nmsprad{SignalStatus::not_available};

        constexpr bool all_valid() const {
            return roll_centre_vertical_m == SignalStatus::valid &&
                   roll_centre_lateral_m == SignalStatus::valid &&
                   roll_stiffness_deviation_nmprad == SignalStatus::valid &&
                   roll_damping_deviation_nmsprad == SignalStatus::valid;
        }
    };

    struct Signals {
        static constexpr PhysicalSignal<std::int32_t> roll_centre_vertical_m{
            {ByteOrder::little_endian, 16U, 12U, true}, 1.0F, 0.0F, 2000.0F, -1.0F, 1.0F,
            -2000, 2000, -2048, true};
        static constexpr PhysicalSignal<std::int32_t> roll_centre_lateral_m{
            {ByteOrder::little_endian, 28U, 12U, true}, 1.0F, 0.0F, 2000.0F, -1.0F, 1.0F,
            -2000, 2000, -2048, true};
        static constexpr PhysicalSignal<std::int32_t> roll_stiffness_deviation_nmprad{
            {ByteOrder::little_endian, 40U, 12U, true}, 50.0F, 0.0F, 1.0F, -100000.0F, 100000.0F,
            -2000, 2000, -2048, true};
        static constexpr PhysicalSignal<std::int32_t> roll_damping_deviation_nmsprad{
            {ByteOrder::little_endian, 52U, 12U, true}, 10.0F, 0.0F, 1.0F, -20000.0F, 20000.0F,
            -2000, 2000, -2048, true};
    };

    // See rsi::can_dbc::encode and decode.
    constexpr std::array<std::uint8_t, length> encode() const {
        std::array<std::uint8_t, length> payload{};
        write_signal(Signals::roll_centre_vertical_m, roll_centre_vertical_m, payload.data());
        write_signal(Signals::roll_centre_lateral_m, roll_centre_lateral_m, payload.data());
        write_signal(Signals::roll_stiffness_deviation_nmprad, roll_stiffness_deviation_nmprad, payload.data());
        write_signal(Signals::roll_damping_deviation_nmsprad, roll_damping_deviation_nmsprad, payload.data());
        return payload;
    }

    static constexpr Decoded<RollCentreEstimate> decode(const std::uint8_t* payload);

    // Takes from a structure of the sender what the attribute Source names.
    template <typename Source>
    constexpr void take(const Source& source) {
        roll_centre_vertical_m = source.roll_centre_vertical_m;
        roll_centre_lateral_m = source.roll_centre_lateral_m;
        roll_stiffness_deviation_nmprad = source.roll_stiffness_deviation_nmprad;
        roll_damping_deviation_nmsprad = source.roll_damping_deviation_nmsprad;
    }

    // Calls visitor(field's name, source's name, member) for each of these signals.
    template <typename Visitor>
    static constexpr void visit_sources(Visitor&& visitor) {
        visitor("roll_centre_vertical_m", "roll_centre_vertical_m", &RollCentreEstimate::roll_centre_vertical_m);
        visitor("roll_centre_lateral_m", "roll_centre_lateral_m", &RollCentreEstimate::roll_centre_lateral_m);
        visitor("roll_stiffness_deviation_nmprad", "roll_stiffness_deviation_nmprad", &RollCentreEstimate::roll_stiffness_deviation_nmprad);
        visitor("roll_damping_deviation_nmsprad", "roll_damping_deviation_nmsprad", &RollCentreEstimate::roll_damping_deviation_nmsprad);
    }

    // Calls visitor(name, unit, member, status member) for each signal.
    template <typename Visitor>
    static constexpr void visit_signals(Visitor&& visitor) {
        visitor("RollCentreVertical", "m", &RollCentreEstimate::roll_centre_vertical_m, &Status::roll_centre_vertical_m);
        visitor("RollCentreLateral", "m", &RollCentreEstimate::roll_centre_lateral_m, &Status::roll_centre_lateral_m);
        visitor("RollStiffnessDeviation", "N m/rad", &RollCentreEstimate::roll_stiffness_deviation_nmprad, &Status::roll_stiffness_deviation_nmprad);
        visitor("RollDampingDeviation", "N m s/rad", &RollCentreEstimate::roll_damping_deviation_nmsprad, &Status::roll_damping_deviation_nmsprad);
    }
};

constexpr Decoded<RollCentreEstimate> RollCentreEstimate::decode(const std::uint8_t* payload) {
    Decoded<RollCentreEstimate> decoded{};
    read_signal(Signals::roll_centre_vertical_m, payload, decoded.value.roll_centre_vertical_m, decoded.status.roll_centre_vertical_m);
    read_signal(Signals::roll_centre_lateral_m, payload, decoded.value.roll_centre_lateral_m, decoded.status.roll_centre_lateral_m);
    read_signal(Signals::roll_stiffness_deviation_nmprad, payload, decoded.value.roll_stiffness_deviation_nmprad, decoded.status.roll_stiffness_deviation_nmprad);
    read_signal(Signals::roll_damping_deviation_nmsprad, payload, decoded.value.roll_damping_deviation_nmsprad, decoded.status.roll_damping_deviation_nmsprad);
    return decoded;
}

// Indices that look ahead, and the present ones that they come from: predicted and present load-transfer ratio, predicted and extended RSI.
// From RolloverEcu to VehicleGateway, every 10 ms.
struct RollIndicesAhead {
    static constexpr const char* name{"RollIndicesAhead"};
    static constexpr std::uint32_t identifier{0x232U};
    static constexpr bool extended{false};
    static constexpr bool flexible_data_rate{false};
    static constexpr std::uint8_t length{8U};
    static constexpr std::uint16_t cycle_time_ms{10U};
    static constexpr bool e2e_protected{true};
    static constexpr std::uint8_t e2e_profile{11U};
    static constexpr bool has_sources{true};
    static constexpr std::uint16_t e2e_data_id{0x9A6U};

    // Load-transfer ratio that the roll state, the trend of the lateral acceleration and the steering lead to within the prediction horizon; largest magnitude, positive in a left turn. Dimensionless, -2 to 2.
    float predicted_load_transfer_ratio{not_available};
    // Extended roll stability indicator, largest within the prediction horizon. Dimensionless, 0 to 2.
    float predicted_rsi{not_available};
    // Load-transfer ratio computed from the roll state, positive in a left turn. Dimensionless, -2 to 2.
    float load_transfer_ratio{not_available};
    // Roll stability indicator with unsprung mass and roll inertia. Dimensionless, 0 to 2.
    float extended_rsi{not_available};

    struct Status {
        SignalStatus predicted_load_transfer_ratio{SignalStatus::not_available};
        SignalStatus predicted_rsi{SignalStatus::not_available};
        SignalStatus load_transfer_ratio{SignalStatus::not_available};
        SignalStatus extended_rsi{SignalStatus::not_available};

        constexpr bool all_valid() const {
            return predicted_load_transfer_ratio == SignalStatus::valid &&
                   predicted_rsi == SignalStatus::valid &&
                   load_transfer_ratio == SignalStatus::valid &&
                   extended_rsi == SignalStatus::valid;
        }
    };

    struct Signals {
        static constexpr PhysicalSignal<std::int32_t> predicted_load_transfer_ratio{
            {ByteOrder::little_endian, 16U, 12U, true}, 1.0F, 0.0F, 1000.0F, -2.0F, 2.0F,
            -2000, 2000, -2048, true};
        static constexpr PhysicalSignal<std::int32_t> predicted_rsi{
            {ByteOrder::little_endian, 28U, 12U, false}, 1.0F, 0.0F, 2000.0F, 0.0F, 2.0F,
            0, 4000, 4095, true};
        static constexpr PhysicalSignal<std::int32_t> load_transfer_ratio{
            {ByteOrder::little_endian, 40U, 12U, true}, 1.0F, 0.0F, 1000.0F, -2.0F, 2.0F,
            -2000, 2000, -2048, true};
        static constexpr PhysicalSignal<std::int32_t> extended_rsi{
            {ByteOrder::little_endian, 52U, 12U, false}, 1.0F, 0.0F, 2000.0F, 0.0F, 2.0F,
            0, 4000, 4095, true};
    };

    // See rsi::can_dbc::encode and decode.
    constexpr std::array<std::uint8_t, length> encode() const {
        std::array<std::uint8_t, length> payload{};
        write_signal(Signals::predicted_load_transfer_ratio, predicted_load_transfer_ratio, payload.data());
        write_signal(Signals::predicted_rsi, predicted_rsi, payload.data());
        write_signal(Signals::load_transfer_ratio, load_transfer_ratio, payload.data());
        write_signal(Signals::extended_rsi, extended_rsi, payload.data());
        return payload;
    }

    static constexpr Decoded<RollIndicesAhead> decode(const std::uint8_t* payload);

    // Takes from a structure of the sender what the attribute Source names.
    template <typename Source>
    constexpr void take(const Source& source) {
        predicted_load_transfer_ratio = source.predicted_load_transfer_ratio;
        predicted_rsi = source.predicted_rsi;
        load_transfer_ratio = source.load_transfer_ratio;
        extended_rsi = source.rsi_extended;
    }

    // Calls visitor(field's name, source's name, member) for each of these signals.
    template <typename Visitor>
    static constexpr void visit_sources(Visitor&& visitor) {
        visitor("predicted_load_transfer_ratio", "predicted_load_transfer_ratio", &RollIndicesAhead::predicted_load_transfer_ratio);
        visitor("predicted_rsi", "predicted_rsi", &RollIndicesAhead::predicted_rsi);
        visitor("load_transfer_ratio", "load_transfer_ratio", &RollIndicesAhead::load_transfer_ratio);
        visitor("extended_rsi", "rsi_extended", &RollIndicesAhead::extended_rsi);
    }

    // Calls visitor(name, unit, member, status member) for each signal.
    template <typename Visitor>
    static constexpr void visit_signals(Visitor&& visitor) {
        visitor("PredictedLoadTransferRatio", "-", &RollIndicesAhead::predicted_load_transfer_ratio, &Status::predicted_load_transfer_ratio);
        visitor("PredictedRsi", "-", &RollIndicesAhead::predicted_rsi, &Status::predicted_rsi);
        visitor("LoadTransferRatio", "-", &RollIndicesAhead::load_transfer_ratio, &Status::load_transfer_ratio);
        visitor("ExtendedRsi", "-", &RollIndicesAhead::extended_rsi, &Status::extended_rsi);
    }
};

constexpr Decoded<RollIndicesAhead> RollIndicesAhead::decode(const std::uint8_t* payload) {
    Decoded<RollIndicesAhead> decoded{};
    read_signal(Signals::predicted_load_transfer_ratio, payload, decoded.value.predicted_load_transfer_ratio, decoded.status.predicted_load_transfer_ratio);
    read_signal(Signals::predicted_rsi, payload, decoded.value.predicted_rsi, decoded.status.predicted_rsi);
    read_signal(Signals::load_transfer_ratio, payload, decoded.value.load_transfer_ratio, decoded.status.load_transfer_ratio);
    read_signal(Signals::extended_rsi, payload, decoded.value.extended_rsi, decoded.status.extended_rsi);
    return decoded;
}

// Indices of the paper: RSI, bank-free RSI, DSI, energy margin, rollover index, time to rollover.
// From RolloverEcu to VehicleGateway, every 10 ms.
struct RollIndicesClassic {
    static constexpr const char* name{"RollIndicesClassic"};
    static constexpr std::uint32_t identifier{0x233U};
    static constexpr bool extended{false};
    static constexpr bool flexible_data_rate{false};
    static constexpr std::uint8_t length{8U};
    static constexpr std::uint16_t cycle_time_ms{10U};
    static constexpr bool e2e_protected{true};
    static constexpr std::uint8_t e2e_profile{11U};
    static constexpr bool has_sources{true};
    static constexpr std::uint16_t e2e_data_id{0xAC3U};

    // Roll stability indicator (RSI) as published. Dimensionless, 0 to 1.2.
    float rsi{not_available};
    // Roll stability indicator without bank angle. Dimensionless, 0 to 2.
    float bank_free_rsi{not_available};
    // Dynamic stability index with the physical sign, in g, positive in a left turn. Dimensionless, -2 to 2.
    float dynamic_stability_index{not_available};
    // Energy measure: 1 at rest, 0 at the critical energy. Dimensionless, -1 to 1.
    float energy_margin{not_available};
    // Rollover index. Dimensionless, 0 to 2.
    float rollover_index{not_available};
    // Time to rollover; 10 while the vehicle does not roll outwards. s, 0 to 10.
    float time_to_rollover_s{not_available};

    struct Status {
        SignalStatus rsi{SignalStatus::not_available};
        SignalStatus bank_free_rsi{SignalStatus::not_available};
        SignalStatus dynamic_stability_index{SignalStatus::not_available};
        SignalStatus energy_margin{SignalStatus::not_available};
        SignalStatus rollover_index{SignalStatus::not_available};
        SignalStatus time_to_rollover_s{SignalStatus::not_available};

        constexpr bool all_valid() const {
            return rsi == SignalStatus::valid &&
                   bank_free_rsi == SignalStatus::valid &&
                   dynamic_stability_index == SignalStatus::valid &&
                   energy_margin == SignalStatus::valid &&
                   rollover_index == SignalStatus::valid &&
                   time_to_rollover_s == SignalStatus::valid;
        }
    };

    struct Signals {
        static constexpr PhysicalSignal<std::int32_t> rsi{
            {ByteOrder::little_endian, 16U, 8U, false}, 1.0F, 0.0F, 200.0F, 0.0F, 1.2F,
            0, 240, 255, true};
        static constexpr PhysicalSignal<std::int32_t> bank_free_rsi{
            {ByteOrder::little_endian, 24U, 8U, false}, 1.0F, 0.0F, 100.0F, 0.0F, 2.0F,
            0, 200, 255, true};
        static constexpr PhysicalSignal<std::int32_t> dynamic_stability_index{
            {ByteOrder::little_endian, 32U, 9U, true}, 1.0F, 0.0F, 100.0F, -2.0F, 2.0F,
            -200, 200, -256, true};
        static constexpr PhysicalSignal<std::int32_t> energy_margin{
            {ByteOrder::little_endian, 41U, 8U, true}, 1.0F, 0.0F, 100.0F, -1.0F, 1.0F,
            -100, 100, -128, true};
        static constexpr PhysicalSignal<std::int32_t> rollover_index{
            {ByteOrder::little_endian, 49U, 7U, false}, 1.0F, 0.0F, 50.0F, 0.0F, 2.0F,
            0, 100, 127, true};
        static constexpr PhysicalSignal<std::int32_t> time_to_rollover_s{
            {ByteOrder::little_endian, 56U, 8U, false}, 1.0F, 0.0F, 25.0F, 0.0F, 10.0F,
            0, 250, 255, true};
    };

    // See rsi::can_dbc::encode and decode.
    constexpr std::array<std::uint8_t, length> encode() const {
        std::array<std::uint8_t, length> payload{};
        write_signal(Signals::rsi, rsi, payload.data());
        write_signal(Signals::bank_free_rsi, bank_free_rsi, payload.data());
        write_signal(Signals::dynamic_stability_index, dynamic_stability_index, payload.data());
        write_signal(Signals::energy_margin, energy_margin, payload.data());
        write_signal(Signals::rollover_index, rollover_index, payload.data());
        write_signal(Signals::time_to_rollover_s, time_to_rollover_s, payload.data());
        return payload;
    }

    static constexpr Decoded<RollIndicesClassic> decode(const std::uint8_t* payload);

    // Takes from a structure of the sender what the attribute Source names.
    template <typename Source>
    constexpr void take(const Source& source) {
        rsi = source.rsi;
        bank_free_rsi = source.rsi_bank_free;
        dynamic_stability_index = source.dynamic_stability_index;
        energy_margin = source.energy_margin;
        rollover_index = source.rollover_index;
        time_to_rollover_s = source.time_to_rollover_s;
    }

    // Calls visitor(field's name, source's name, member) for each of these signals.
    template <typename Visitor>
    static constexpr void visit_sources(Visitor&& visitor) {
        visitor("rsi", "rsi", &RollIndicesClassic::rsi);
        visitor("bank_free_rsi", "rsi_bank_free", &RollIndicesClassic::bank_free_rsi);
        visitor("dynamic_stability_index", "dynamic_stability_index", &RollIndicesClassic::dynamic_stability_index);
        visitor("energy_margin", "energy_margin", &RollIndicesClassic::energy_margin);
        visitor("rollover_index", "rollover_index", &RollIndicesClassic::rollover_index);
        visitor("time_to_rollover_s", "time_to_rollover_s", &RollIndicesClassic::time_to_rollover_s);
    }

    // Calls visitor(name, unit, member, status member) for each signal.
    template <typename Visitor>
    static constexpr void visit_signals(Visitor&& visitor) {
        visitor("Rsi", "-", &RollIndicesClassic::rsi, &Status::rsi);
        visitor("BankFreeRsi", "-", &RollIndicesClassic::bank_free_rsi, &Status::bank_free_rsi);
        visitor("DynamicStabilityIndex", "-", &RollIndicesClassic::dynamic_stability_index, &Status::dynamic_stability_index);
        visitor("EnergyMargin", "-", &RollIndicesClassic::energy_margin, &Status::energy_margin);
        visitor("RolloverIndex", "-", &RollIndicesClassic::rollover_index, &Status::rollover_index);
        visitor("TimeToRollover", "s", &RollIndicesClassic::time_to_rollover_s, &Status::time_to_rollover_s);
    }
};

constexpr Decoded<RollIndicesClassic> RollIndicesClassic::decode(const std::uint8_t* payload) {
    Decoded<RollIndicesClassic> decoded{};
    read_signal(Signals::rsi, payload, decoded.value.rsi, decoded.status.rsi);
    read_signal(Signals::bank_free_rsi, payload, decoded.value.bank_free_rsi, decoded.status.bank_free_rsi);
    read_signal(Signals::dynamic_stability_index, payload, decoded.value.dynamic_stability_index, decoded.status.dynamic_stability_index);
    read_signal(Signals::energy_margin, payload, decoded.value.energy_margin, decoded.status.energy_margin);
    read_signal(Signals::rollover_index, payload, decoded.value.rollover_index, decoded.status.rollover_index);
    read_signal(Signals::time_to_rollover_s, payload, decoded.value.time_to_rollover_s, decoded.status.time_to_rollover_s);
    return decoded;
}

// Observer of roll angle and bank, source of the roll angle in use, quality of the roll-centre estimate, reason of the last reset, protection.
// From RolloverEcu to VehicleGateway, every 10 ms.
struct RollObserver {
    // Where the roll angle in use comes from.
    enum class RollSource : std::uint8_t {
        none = 0,
        sensor = 1,
        observer = 2,
    };

    // Why the control unit last started.
    enum class ResetReason : std::uint8_t {
        power_on = 0,
        outside = 1,
        undefined_instruction = 2,
        supervisor_call = 3,
        prefetch_abort = 4,
        data_abort = 5,
        stack_overflow = 6,
        interrupt = 7,
        start_without_reset = 8,
    };

    // Whether the control unit takes parameters without a seal, and whether everybody knows its keys.
    enum class Protection : std::uint8_t {
        unsealed = 0,
        unsealed_test_keys = 1,
        sealed_test_keys = 2,
        sealed = 3,
    };

    static constexpr const char* name{"RollObserver"};
    static constexpr std::uint32_t identifier{0x234U};
    static constexpr bool extended{false};
    static constexpr bool flexible_data_rate{false};
    static constexpr std::uint8_t length{8U};
    static constexpr std::uint16_t cycle_time_ms{10U};
    static constexpr bool e2e_protected{true};
    static constexpr std::uint8_t e2e_profile{11U};
    static constexpr bool has_sources{true};
    static constexpr std::uint16_t e2e_data_id{0xBE8U};

    // Roll angle relative to the road as the observer has it without the roll sensor. deg, -60 to 60.
    float observed_roll_angle_deg{not_available};
    // Bank angle of the road as the observer has it, positive with the left side up. deg, -45 to 45.
    float observed_bank_angle_deg{not_available};
    // Standard deviation of the vertical movement of the roll centre. m, 0 to 0.5.
    float roll_centre_deviation_m{not_available};
    // Where the roll angle in use comes from.
    RollSource roll_source{RollSource::none};
    // Roll sensor and observer contradict each other.
    bool roll_sensor_disagrees{false};
    // The estimator of the roll centre learns nothing at present.
    bool estimate_frozen{false};
    // Why the control unit last started.
    ResetReason reset_reason{ResetReason::power_on};
    // Whether the control unit takes parameters without a seal, and whether everybody knows its keys.
    Protection protection{Protection::unsealed};

    struct Status {
        SignalStatus observed_roll_angle_deg{SignalStatus::not_available};
        SignalStatus observed_bank_angle_deg{SignalStatus::not_available};
        SignalStatus roll_centre_deviation_m{SignalStatus::not_available};
        SignalStatus roll_source{SignalStatus::not_available};
        SignalStatus roll_sensor_disagrees{SignalStatus::not_available};
        SignalStatus estimate_frozen{SignalStatus::not_available};
        SignalStatus reset_reason{SignalStatus::not_available};
        SignalStatus protection{SignalStatus::not_available};

        constexpr bool all_valid() const {
            return observed_roll_angle_deg == SignalStatus::valid &&
                   observed_bank_angle_deg == SignalStatus::valid &&
                   roll_centre_deviation_m == SignalStatus::valid &&
                   roll_source == SignalStatus::valid &&
                   roll_sensor_disagrees == SignalStatus::valid &&
                   estimate_frozen == SignalStatus::valid &&
                   reset_reason == SignalStatus::valid &&
                   protection == SignalStatus::valid;
        }
    };

    struct Signals {
        static constexpr PhysicalSignal<std::int32_t> observed_roll_angle_deg{
            {ByteOrder::little_endian, 16U, 13U, true}, 1.0F, 0.0F, 50.0F, -60.0F, 60.0F,
            -3000, 3000, -4096, true};
        static constexpr PhysicalSignal<std::int32_t> observed_bank_angle_deg{
            {ByteOrder::little_endian, 29U, 12U, true}, 1.0F, 0.0F, 40.0F, -45.0F, 45.0F,
            -1800, 1800, -2048, true};
        static constexpr PhysicalSignal<std::int32_t> roll_centre_deviation_m{
            {ByteOrder::little_endian, 41U, 10U, false}, 1.0F, 0.0F, 2000.0F, 0.0F, 0.5F,
            0, 1000, 1023, true};
        static constexpr EnumerationSignal roll_source{
            {ByteOrder::little_endian, 51U, 2U, false}, 0, false, 0};
        static constexpr IntegerSignal roll_sensor_disagrees{
            {ByteOrder::little_endian, 53U, 1U, false}, 0, 1, 0};
        static constexpr IntegerSignal estimate_frozen{
            {ByteOrder::little_endian, 54U, 1U, false}, 0, 1, 0};
        static constexpr EnumerationSignal reset_reason{
            {ByteOrder::little_endian, 55U, 4U, false}, 0, false, 0};
        static constexpr EnumerationSignal protection{
            {ByteOrder::little_endian, 59U, 2U, false}, 0, false, 0};
    };

    static constexpr bool is_known(RollSource value) {
        switch (value) {
            case RollSource::none:
            case RollSource::sensor:
            case RollSource::observer:
                return true;
        }
        return false;
    }

    // The value's name in the DBC file, or "unknown".
    static constexpr const char* name_of(RollSource value) {
        switch (value) {
            case RollSource::none:
                return "none";
            case RollSource::sensor:
                return "sensor";
            case RollSource::observer:
                return "observer";
        }
        return "unknown";
    }

    static constexpr bool is_known(ResetReason value) {
        switch (value) {
            case ResetReason::power_on:
            case ResetReason::outside:
            case ResetReason::undefined_instruction:
            case ResetReason::supervisor_call:
            case ResetReason::prefetch_abort:
            case ResetReason::data_abort:
            case ResetReason::stack_overflow:
            case ResetReason::interrupt:
            case ResetReason::start_without_reset:
                return true;
        }
        return false;
    }

    // The value's name in the DBC file, or "unknown".
    static constexpr const char* name_of(ResetReason value) {
        switch (value) {
            case ResetReason::power_on:
                return "power on";
            case ResetReason::outside:
                return "outside";
            case ResetReason::undefined_instruction:
                return "undefined instruction";
            case ResetReason::supervisor_call:
                return "supervisor call";
            case ResetReason::prefetch_abort:
                return "prefetch abort";
            case ResetReason::data_abort:
                return "data abort";
            case ResetReason::stack_overflow:
                return "stack overflow";
            case ResetReason::interrupt:
                return "interrupt";
            case ResetReason::start_without_reset:
                return "start without reset";
        }
        return "unknown";
    }

    static constexpr bool is_known(Protection value) {
        switch (value) {
            case Protection::unsealed:
            case Protection::unsealed_test_keys:
            case Protection::sealed_test_keys:
            case Protection::sealed:
                return true;
        }
        return false;
    }

    // The value's name in the DBC file, or "unknown".
    static constexpr const char* name_of(Protection value) {
        switch (value) {
            case Protection::unsealed:
                return "unsealed";
            case Protection::unsealed_test_keys:
                return "unsealed test keys";
            case Protection::sealed_test_keys:
                return "sealed test keys";
            case Protection::sealed:
                return "sealed";
        }
        return "unknown";
    }

    // See rsi::can_dbc::encode and decode.
    constexpr std::array<std::uint8_t, length> encode() const {
        std::array<std::uint8_t, length> payload{};
        write_signal(Signals::observed_roll_angle_deg, observed_roll_angle_deg, payload.data());
        write_signal(Signals::observed_bank_angle_deg, observed_bank_angle_deg, payload.data());
        write_signal(Signals::roll_centre_deviation_m, roll_centre_deviation_m, payload.data());
        write_enumeration(Signals::roll_source, &RollObserver::is_known, roll_source, payload.data());
        write_signal(Signals::roll_sensor_disagrees, roll_sensor_disagrees, payload.data());
        write_signal(Signals::estimate_frozen, estimate_frozen, payload.data());
        write_enumeration(Signals::reset_reason, &RollObserver::is_known, reset_reason, payload.data());
        write_enumeration(Signals::protection, &RollObserver::is_known, protection, payload.data());
        return payload;
    }

    static constexpr Decoded<RollObserver> decode(const std::uint8_t* payload);

    // Takes from a structure of the sender what the attribute Source names.
    template <typename Source>
    constexpr void take(const Source& source) {
        observed_roll_angle_deg = source.observed_roll_angle_rad * 57.295780F;
        observed_bank_angle_deg = source.observed_bank_angle_rad * 57.295780F;
        roll_centre_deviation_m = source.roll_centre_deviation_m;
        roll_source = static_cast<RollSource>(source.roll_source);
        roll_sensor_disagrees = (source.roll_sensor_disagrees != 0);
        estimate_frozen = (source.estimate_frozen != 0);
    }

    // Calls visitor(field's name, source's name, member) for each of these signals.
    template <typename Visitor>
    static constexpr void visit_sources(Visitor&& visitor) {
        visitor("observed_roll_angle_deg", "observed_roll_angle_rad", &RollObserver::observed_roll_angle_deg);
        visitor("observed_bank_angle_deg", "observed_bank_angle_rad", &RollObserver::observed_bank_angle_deg);
        visitor("roll_centre_deviation_m", "roll_centre_deviation_m", &RollObserver::roll_centre_deviation_m);
        visitor("roll_source", "roll_source", &RollObserver::roll_source);
        visitor("roll_sensor_disagrees", "roll_sensor_disagrees", &RollObserver::roll_sensor_disagrees);
        visitor("estimate_frozen", "estimate_frozen", &RollObserver::estimate_frozen);
    }

    // Calls visitor(name, unit, member, status member) for each signal.
    template <typename Visitor>
    static constexpr void visit_signals(Visitor&& visitor) {
        visitor("ObservedRollAngle", "deg", &RollObserver::observed_roll_angle_deg, &Status::observed_roll_angle_deg);
        visitor("ObservedBankAngle", "deg", &RollObserver::observed_bank_angle_deg, &Status::observed_bank_angle_deg);
        visitor("RollCentreDeviation", "m", &RollObserver::roll_centre_deviation_m, &Status::roll_centre_deviation_m);
        visitor("RollSource", "-", &RollObserver::roll_source, &Status::roll_source);
        visitor("RollSensorDisagrees", "-", &RollObserver::roll_sensor_disagrees, &Status::roll_sensor_disagrees);
        visitor("EstimateFrozen", "-", &RollObserver::estimate_frozen, &Status::estimate_frozen);
        visitor("ResetReason", "-", &RollObserver::reset_reason, &Status::reset_reason);
        visitor("Protection", "-", &RollObserver::protection, &Status::protection);
    }
};

constexpr Decoded<RollObserver> RollObserver::decode(const std::uint8_t* payload) {
    Decoded<RollObserver> decoded{};
    read_signal(Signals::observed_roll_angle_deg, payload, decoded.value.observed_roll_angle_deg, decoded.status.observed_roll_angle_deg);
    read_signal(Signals::observed_bank_angle_deg, payload, decoded.value.observed_bank_angle_deg, decoded.status.observed_bank_angle_deg);
    read_signal(Signals::roll_centre_deviation_m, payload, decoded.value.roll_centre_deviation_m, decoded.status.roll_centre_deviation_m);
    read_enumeration(Signals::roll_source, &RollObserver::is_known, payload, decoded.value.roll_source, decoded.status.roll_source);
    read_signal(Signals::roll_sensor_disagrees, payload, decoded.value.roll_sensor_disagrees, decoded.status.roll_sensor_disagrees);
    read_signal(Signals::estimate_frozen, payload, decoded.value.estimate_frozen, decoded.status.estimate_frozen);
    read_enumeration(Signals::reset_reason, &RollObserver::is_known, payload, decoded.value.reset_reason, decoded.status.reset_reason);
    read_enumeration(Signals::protection, &RollObserver::is_known, payload, decoded.value.protection, decoded.status.protection);
    return decoded;
}

// Degradation, and the diagnostic memory, one code a cycle: status, occurrences, values at its first confirmation.
// From RolloverEcu to VehicleGateway, every 10 ms.
struct RolloverDiagnosis {
    // What the component can still do with the inputs that it has.
    enum class Degradation : std::uint8_t {
        unavailable = 0,
        full = 1,
        roll_sensor_lost = 2,
        motion_lost = 3,
        internal_fault = 4,
        mass_lost = 5,
    };

    // The diagnostic code that this frame tells of; each cycle the next one in the memory.
    enum class Code : std::uint8_t {
        none = 0,
        imu_lost = 1,
        imu_damaged = 2,
        roll_angle_lost = 3,
        roll_angle_damaged = 4,
        vehicle_motion_lost = 5,
        vehicle_motion_damaged = 6,
        lateral_acceleration_invalid = 7,
        lateral_acceleration_jump = 8,
        lateral_acceleration_stuck = 9,
        vertical_acceleration_invalid = 10,
        vertical_acceleration_jump = 11,
        vertical_acceleration_stuck = 12,
        vertical_acceleration_offset = 13,
        roll_rate_invalid = 14,
        roll_rate_jump = 15,
        roll_rate_stuck = 16,
        roll_angle_invalid = 17,
        roll_angle_jump = 18,
        roll_angle_stuck = 19,
        bank_angle_invalid = 20,
        yaw_rate_invalid = 21,
        yaw_rate_jump = 22,
        yaw_rate_stuck = 23,
        speed_invalid = 24,
        speed_jump = 25,
        speed_stuck = 26,
        steering_invalid = 27,
        steering_jump = 28,
        steering_stuck = 29,
        roll_rate_contradicts_roll_angle = 30,
        roll_rate_offset = 31,
        lateral_acceleration_contradicts_yaw_rate = 32,
        roll_sensor_contradicts_observer = 33,
        yaw_rate_contradicts_lateral_acceleration = 34,
        parameters_refused = 35,
        parameters_damaged = 36,
        estimate_out_of_range = 37,
        output_not_finite = 38,
        cycle_overrun = 39,
        cycle_stall = 40,
        clock_jump = 41,
        bus_error = 42,
        receive_overflow = 43,
        roll_angle_reference_wrong = 44,
        lateral_acceleration_gain = 45,
        memory_restored = 46,
        imu_two_senders = 47,
        roll_angle_two_senders = 48,
        vehicle_motion_two_senders = 49,
        own_identifier_received = 50,
        imu_held_back = 51,
        stored_parameters_refused = 52,
        storage_failed = 53,
        vehicle_mass_invalid = 54,
        vehicle_mass_jump = 55,
        vehicle_mass_contradicts_load = 56,
    };

    // How far that code has come.
    enum class CodeStatus : std::uint8_t {
        none = 0,
        set = 1,
        confirmed = 2,
        healed = 3,
    };

    static constexpr const char* name{"RolloverDiagnosis"};
    static constexpr std::uint32_t identifier{0x235U};
    static constexpr bool extended{false};
    static constexpr bool flexible_data_rate{false};
    static constexpr std::uint8_t length{8U};
    static constexpr std::uint16_t cycle_time_ms{10U};
    static constexpr bool e2e_protected{true};
    static constexpr std::uint8_t e2e_profile{11U};
    static constexpr bool has_sources{false};
    static constexpr std::uint16_t e2e_data_id{0xCD3U};

    // What the component can still do with the inputs that it has.
    Degradation degradation{Degradation::unavailable};
    // The diagnostic code that this frame tells of; each cycle the next one in the memory.
    Code code{Code::none};
    // How far that code has come.
    CodeStatus code_status{CodeStatus::none};
    // How often that code was confirmed since the start; stays at 31. 0 to 31.
    std::uint8_t occurrences{0U};
    // Lateral acceleration when that code was confirmed for the first time. m/s^2, -30 to 30.
    float first_lateral_acceleration_mps2{not_available};
    // Roll rate when that code was confirmed for the first time. deg/s, -250 to 250.
    float first_roll_rate_deg_per_s{not_available};
    // Roll angle when that code was confirmed for the first time. deg, -60 to 60.
    float first_roll_angle_deg{not_available};
    // Speed when that code was confirmed for the first time. km/h, 0 to 250.
    float first_speed_kmh{not_available};

    struct Status {
        SignalStatus degradation{SignalStatus::not_available};
        SignalStatus code{SignalStatus::not_available};
        SignalStatus code_status{SignalStatus::not_available};
        SignalStatus occurrences{SignalStatus::not_available};
        SignalStatus first_lateral_acceleration_mps2{SignalStatus::not_available};
        SignalStatus first_roll_rate_deg_per_s{SignalStatus::not_available};
        SignalStatus first_roll_angle_deg{SignalStatus::not_available};
        SignalStatus first_speed_kmh{SignalStatus::not_available};

        constexpr bool all_valid() const {
            return degradation == SignalStatus::valid &&
                   code == SignalStatus::valid &&
                   code_status == SignalStatus::valid &&
                   occurrences == SignalStatus::valid &&
                   first_lateral_acceleration_mps2 == SignalStatus::valid &&
                   first_roll_rate_deg_per_s == SignalStatus::valid &&
                   first_roll_angle_deg == SignalStatus::valid &&
                   first_speed_kmh == SignalStatus::valid;
        }
    };

    struct Signals {
        static constexpr EnumerationSignal degradation{
            {ByteOrder::little_endian, 16U, 3U, false}, 0, false, 0};
        static constexpr EnumerationSignal code{
            {ByteOrder::little_endian, 19U, 6U, false}, 0, false, 0};
        static constexpr EnumerationSignal code_status{
            {ByteOrder::little_endian, 25U, 2U, false}, 0, false, 0};
        static constexpr IntegerSignal occurrences{
            {ByteOrder::little_endian, 27U, 5U, false}, 0, 31, 0};
        static constexpr PhysicalSignal<std::int32_t> first_lateral_acceleration_mps2{
            {ByteOrder::little_endian, 32U, 8U, true}, 1.0F, 0.0F, 4.0F, -30.0F, 30.0F,
            -120, 120, -128, true};
        static constexpr PhysicalSignal<std::int32_t> first_roll_rate_deg_per_s{
            {ByteOrder::little_endian, 40U, 8U, true}, 2.0F, 0.0F, 1.0F, -250.0F, 250.0F,
            -125, 125, -128, true};
        static constexpr PhysicalSignal<std::int32_t> first_roll_angle_deg{
            {ByteOrder::little_endian, 48U, 8U, true}, 1.0F, 0.0F, 2.0F, -60.0F, 60.0F,
            -120, 120, -128, true};
        static constexpr PhysicalSignal<std::int32_t> first_speed_kmh{
            {ByteOrder::little_endian, 56U, 8U, false}, 1.0F, 0.0F, 1.0F, 0.0F, 250.0F,
            0, 250, 255, true};
    };

    static constexpr bool is_known(Degradation value) {
        switch (value) {
            case Degradation::unavailable:
            case Degradation::full:
            case Degradation::roll_sensor_lost:
            case Degradation::motion_lost:
            case Degradation::internal_fault:
            case Degradation::mass_lost:
                return true;
        }
        return false;
    }

    // The value's name in the DBC file, or "unknown".
    static constexpr const char* name_of(Degradation value) {
        switch (value) {
            case Degradation::unavailable:
                return "unavailable";
            case Degradation::full:
                return "full";
            case Degradation::roll_sensor_lost:
                return "roll sensor lost";
            case Degradation::motion_lost:
                return "motion lost";
            case Degradation::internal_fault:
                return "internal fault";
            case Degradation::mass_lost:
                return "mass lost";
        }
        return "unknown";
    }

    static constexpr bool is_known(Code value) {
        switch (value) {
            case Code::none:
            case Code::imu_lost:
            case Code::imu_damaged:
            case Code::roll_angle_lost:
            case Code::roll_angle_damaged:
            case Code::vehicle_motion_lost:
            case Code::vehicle_motion_damaged:
            case Code::lateral_acceleration_invalid:
            case Code::lateral_acceleration_jump:
            case Code::lateral_acceleration_stuck:
            case Code::vertical_acceleration_invalid:
            case Code::vertical_acceleration_jump:
            case Code::vertical_acceleration_stuck:
            case Code::vertical_acceleration_offset:
            case Code::roll_rate_invalid:
            case Code::roll_rate_jump:
            case Code::roll_rate_stuck:
            case Code::roll_angle_invalid:
            case Code::roll_angle_jump:
            case Code::roll_angle_stuck:
            case Code::bank_angle_invalid:
            case Code::yaw_rate_invalid:
            case Code::yaw_rate_jump:
            case Code::yaw_rate_stuck:
            case Code::speed_invalid:
            case Code::speed_jump:
            case Code::speed_stuck:
            case Code::steering_invalid:
            case Code::steering_jump:
            case Code::steering_stuck:
            case Code::roll_rate_contradicts_roll_angle:
            case Code::roll_rate_offset:
            case Code::lateral_acceleration_contradicts_yaw_rate:
            case Code::roll_sensor_contradicts_observer:
            case Code::yaw_rate_contradicts_lateral_acceleration:
            case Code::parameters_refused:
            case Code::parameters_damaged:
            case Code::estimate_out_of_range:
            case Code::output_not_finite:
            case Code::cycle_overrun:
            case Code::cycle_stall:
            case Code::clock_jump:
            case Code::bus_error:
            case Code::receive_overflow:
            case Code::roll_angle_reference_wrong:
            case Code::lateral_acceleration_gain:
            case Code::memory_restored:
            case Code::imu_two_senders:
            case Code::roll_angle_two_senders:
            case Code::vehicle_motion_two_senders:
            case Code::own_identifier_received:
            case Code::imu_held_back:
            case Code::stored_parameters_refused:
            case Code::storage_failed:
            case Code::vehicle_mass_invalid:
            case Code::vehicle_mass_jump:
            case Code::vehicle_mass_contradicts_load:
                return true;
        }
        return false;
    }

    // The value's name in the DBC file, or "unknown".
    static constexpr const char* name_of(Code value) {
        switch (value) {
            case Code::none:
                return "none";
            case Code::imu_lost:
                return "imu lost";
            case Code::imu_damaged:
                return "imu damaged";
            case Code::roll_angle_lost:
                return "roll angle lost";
            case Code::roll_angle_damaged:
                return "roll angle damaged";
            case Code::vehicle_motion_lost:
                return "vehicle motion lost";
            case Code::vehicle_motion_damaged:
                return "vehicle motion damaged";
            case Code::lateral_acceleration_invalid:
                return "lateral acceleration invalid";
            case Code::lateral_acceleration_jump:
                return "lateral acceleration jump";
            case Code::lateral_acceleration_stuck:
                return "lateral acceleration stuck";
            case Code::vertical_acceleration_invalid:
                return "vertical acceleration invalid";
            case Code::vertical_acceleration_jump:
                return "vertical acceleration jump";
            case Code::vertical_acceleration_stuck:
                return "vertical acceleration stuck";
            case Code::vertical_acceleration_offset:
                return "vertical acceleration offset";
            case Code::roll_rate_invalid:
                return "roll rate invalid";
            case Code::roll_rate_jump:
                return "roll rate jump";
            case Code::roll_rate_stuck:
                return "roll rate stuck";
            case Code::roll_angle_invalid:
                return "roll angle invalid";
            case Code::roll_angle_jump:
                return "roll angle jump";
            case Code::roll_angle_stuck:
                return "roll angle stuck";
            case Code::bank_angle_invalid:
                return "bank angle invalid";
            case Code::yaw_rate_invalid:
                return "yaw rate invalid";
            case Code::yaw_rate_jump:
                return "yaw rate jump";
            case Code::yaw_rate_stuck:
                return "yaw rate stuck";
            case Code::speed_invalid:
                return "speed invalid";
            case Code::speed_jump:
                return "speed jump";
            case Code::speed_stuck:
                return "speed stuck";
            case Code::steering_invalid:
                return "steering invalid";
            case Code::steering_jump:
                return "steering jump";
            case Code::steering_stuck:
                return "steering stuck";
            case Code::roll_rate_contradicts_roll_angle:
                return "roll rate contradicts roll angle";
            case Code::roll_rate_offset:
                return "roll rate offset";
            case Code::lateral_acceleration_contradicts_yaw_rate:
                return "lateral acceleration contradicts yaw rate";
            case Code::roll_sensor_contradicts_observer:
                return "roll sensor contradicts observer";
            case Code::yaw_rate_contradicts_lateral_acceleration:
                return "yaw rate contradicts lateral acceleration";
            case Code::parameters_refused:
                return "parameters refused";
            case Code::parameters_damaged:
                return "parameters damaged";
            case Code::estimate_out_of_range:
                return "estimate out of range";
            case Code::output_not_finite:
                return "output not finite";
            case Code::cycle_overrun:
                return "cycle overrun";
            case Code::cycle_stall:
                return "cycle stall";
            case Code::clock_jump:
                return "clock jump";
            case Code::bus_error:
                return "bus error";
            case Code::receive_overflow:
                return "receive overflow";
            case Code::roll_angle_reference_wrong:
                return "roll angle reference wrong";
            case Code::lateral_acceleration_gain:
                return "lateral acceleration gain";
            case Code::memory_restored:
                return "memory restored";
            case Code::imu_two_senders:
                return "imu two senders";
            case Code::roll_angle_two_senders:
                return "roll angle two senders";
            case Code::vehicle_motion_two_senders:
                return "vehicle motion two senders";
            case Code::own_identifier_received:
                return "own identifier received";
            case Code::imu_held_back:
                return "imu held back";
            case Code::stored_parameters_refused:
                return "stored parameters refused";
            case Code::storage_failed:
                return "storage failed";
            case Code::vehicle_mass_invalid:
                return "vehicle mass invalid";
            case Code::vehicle_mass_jump:
                return "vehicle mass jump";
            case Code::vehicle_mass_contradicts_load:
                return "vehicle mass contradicts load";
        }
        return "unknown";
    }

    static constexpr bool is_known(CodeStatus value) {
        switch (value) {
            case CodeStatus::none:
            case CodeStatus::set:
            case CodeStatus::confirmed:
            case CodeStatus::healed:
                return true;
        }
        return false;
    }

    // The value's name in the DBC file, or "unknown".
    static constexpr const char* name_of(CodeStatus value) {
        switch (value) {
            case CodeStatus::none:
                return "none";
            case CodeStatus::set:
                return "set";
            case CodeStatus::confirmed:
                return "confirmed";
            case CodeStatus::healed:
                return "healed";
        }
        return "unknown";
    }

    // See rsi::can_dbc::encode and decode.
    constexpr std::array<std::uint8_t, length> encode() const {
        std::array<std::uint8_t, length> payload{};
        write_enumeration(Signals::degradation, &RolloverDiagnosis::is_known, degradation, payload.data());
        write_enumeration(Signals::code, &RolloverDiagnosis::is_known, code, payload.data());
        write_enumeration(Signals::code_status, &RolloverDiagnosis::is_known, code_status, payload.data());
        write_signal(Signals::occurrences, occurrences, payload.data());
        write_signal(Signals::first_lateral_acceleration_mps2, first_lateral_acceleration_mps2, payload.data());
        write_signal(Signals::first_roll_rate_deg_per_s, first_roll_rate_deg_per_s, payload.data());
        write_signal(Signals::first_roll_angle_deg, first_roll_angle_deg, payload.data());
        write_signal(Signals::first_speed_kmh, first_speed_kmh, payload.data());
        return payload;
    }

    static constexpr Decoded<RolloverDiagnosis> decode(const std::uint8_t* payload);

    // Calls visitor(name, unit, member, status member) for each signal.
    template <typename Visitor>
    static constexpr void visit_signals(Visitor&& visitor) {
        visitor("Degradation", "-", &RolloverDiagnosis::degradation, &Status::degradation);
        visitor("Code", "-", &RolloverDiagnosis::code, &Status::code);
        visitor("CodeStatus", "-", &RolloverDiagnosis::code_status, &Status::code_status);
        visitor("Occurrences", "-", &RolloverDiagnosis::occurrences, &Status::occurrences);
        visitor("FirstLateralAcceleration", "m/s^2", &RolloverDiagnosis::first_lateral_acceleration_mps2, &Status::first_lateral_acceleration_mps2);
        visitor("FirstRollRate", "deg/s", &RolloverDiagnosis::first_roll_rate_deg_per_s, &Status::first_roll_rate_deg_per_s);
        visitor("FirstRollAngle", "deg", &RolloverDiagnosis::first_roll_angle_deg, &Status::first_roll_angle_deg);
        visitor("FirstSpeed", "km/h", &RolloverDiagnosis::first_speed_kmh, &Status::first_speed_kmh);
    }
};

constexpr Decoded<RolloverDiagnosis> RolloverDiagnosis::decode(const std::uint8_t* payload) {
    Decoded<RolloverDiagnosis> decoded{};
    read_enumeration(Signals::degradation, &RolloverDiagnosis::is_known, payload, decoded.value.degradation, decoded.status.degradation);
    read_enumeration(Signals::code, &RolloverDiagnosis::is_known, payload, decoded.value.code, decoded.status.code);
    read_enumeration(Signals::code_status, &RolloverDiagnosis::is_known, payload, decoded.value.code_status, decoded.status.code_status);
    read_signal(Signals::occurrences, payload, decoded.value.occurrences, decoded.status.occurrences);
    read_signal(Signals::first_lateral_acceleration_mps2, payload, decoded.value.first_lateral_acceleration_mps2, decoded.status.first_lateral_acceleration_mps2);
    read_signal(Signals::first_roll_rate_deg_per_s, payload, decoded.value.first_roll_rate_deg_per_s, decoded.status.first_roll_rate_deg_per_s);
    read_signal(Signals::first_roll_angle_deg, payload, decoded.value.first_roll_angle_deg, decoded.status.first_roll_angle_deg);
    read_signal(Signals::first_speed_kmh, payload, decoded.value.first_speed_kmh, decoded.status.first_speed_kmh);
    return decoded;
}

// Load as driving has shown it, and its standard deviation.
// From RolloverEcu to VehicleGateway, every 10 ms.
struct LearntLoad {
    static constexpr const char* name{"LearntLoad"};
    static constexpr std::uint32_t identifier{0x236U};
    static constexpr bool extended{false};
    static constexpr bool flexible_data_rate{false};
    static constexpr std::uint8_t length{8U};
    static constexpr std::uint16_t cycle_time_ms{10U};
    static constexpr bool e2e_protected{true};
    static constexpr std::uint8_t e2e_profile{11U};
    static constexpr bool has_sources{true};
    static constexpr std::uint16_t e2e_data_id{0xDBDU};

    // By which share sprung mass times its height above the roll centre is larger than calibrated. Dimensionless, -0.6 to 1.5.
    float load_excess{not_available};
    // Standard deviation of the learnt load excess. Dimensionless, 0 to 0.5.
    float load_excess_deviation{not_available};

    struct Status {
        SignalStatus load_excess{SignalStatus::not_available};
        SignalStatus load_excess_deviation{SignalStatus::not_available};

        constexpr bool all_valid() const {
            return load_excess == SignalStatus::valid &&
                   load_excess_deviation == SignalStatus::valid;
        }
    };

    struct Signals {
        static constexpr PhysicalSignal<std::int32_t> load_excess{
            {ByteOrder::little_endian, 16U, 12U, true}, 1.0F, 0.0F, 1000.0F, -0.6F, 1.5F,
            -600, 1500, -2048, true};
        static constexpr PhysicalSignal<std::int32_t> load_excess_deviation{
            {ByteOrder::little_endian, 28U, 12U, false}, 1.0F, 0.0F, 5000.0F, 0.0F, 0.5F,
            0, 2500, 4095, true};
    };

    // See rsi::can_dbc::encode and decode.
    constexpr std::array<std::uint8_t, length> encode() const {
        std::array<std::uint8_t, length> payload{};
        write_signal(Signals::load_excess, load_excess, payload.data());
        write_signal(Signals::load_excess_deviation, load_excess_deviation, payload.data());
        return payload;
    }

    static constexpr Decoded<LearntLoad> decode(const std::uint8_t* payload);

    // Takes from a structure of the sender what the attribute Source names.
    template <typename Source>
    constexpr void take(const Source& source) {
        load_excess = source.load_excess;
        load_excess_deviation = source.load_excess_deviation;
    }

    // Calls visitor(field's name, source's name, member) for each of these signals.
    template <typename Visitor>
    static constexpr void visit_sources(Visitor&& visitor) {
        visitor("load_excess", "load_excess", &LearntLoad::load_excess);
        visitor("load_excess_deviation", "load_excess_deviation", &LearntLoad::load_excess_deviation);
    }

    // Calls visitor(name, unit, member, status member) for each signal.
    template <typename Visitor>
    static constexpr void visit_signals(Visitor&& visitor) {
        visitor("LoadExcess", "-", &LearntLoad::load_excess, &Status::load_excess);
        visitor("LoadExcessDeviation", "-", &LearntLoad::load_excess_deviation, &Status::load_excess_deviation);
    }
};

constexpr Decoded<LearntLoad> LearntLoad::decode(const std::uint8_t* payload) {
    Decoded<LearntLoad> decoded{};
    read_signal(Signals::load_excess, payload, decoded.value.load_excess, decoded.status.load_excess);
    read_signal(Signals::load_excess_deviation, payload, decoded.value.load_excess_deviation, decoded.status.load_excess_deviation);
    return decoded;
}

// Health of the rollover-warning component: diagnostic flags, counts, software version.
// From RolloverEcu to VehicleGateway, every 10 ms.
struct RolloverStatus {
    static constexpr const char* name{"RolloverStatus"};
    static constexpr std::uint32_t identifier{0x231U};
    static constexpr bool extended{false};
    static constexpr bool flexible_data_rate{false};
    static constexpr std::uint8_t length{8U};
    static constexpr std::uint16_t cycle_time_ms{10U};
    static constexpr bool e2e_protected{true};
    static constexpr std::uint8_t e2e_profile{11U};
    static constexpr bool has_sources{false};
    static constexpr std::uint16_t e2e_data_id{0x88BU};

    // No usable Imu frame within the time limit.
    bool imu_timeout{false};
    // An Imu frame failed its checksum, data identifier or length.
    bool imu_checksum_error{false};
    // The counter of Imu repeated or jumped.
    bool imu_counter_error{false};
    // A signal of Imu was not available or out of range.
    bool imu_signal_invalid{false};
    // No usable RollAngle frame within the time limit.
    bool roll_angle_timeout{false};
    // A RollAngle frame failed its checksum, data identifier or length.
    bool roll_angle_checksum_error{false};
    // The counter of RollAngle repeated or jumped.
    bool roll_angle_counter_error{false};
    // A signal of RollAngle was not available or out of range.
    bool roll_angle_signal_invalid{false};
    // No usable VehicleMotion frame within the time limit.
    bool vehicle_motion_timeout{false};
    // A VehicleMotion frame failed its checksum, data identifier or length.
    bool vehicle_motion_checksum_error{false};
    // The counter of VehicleMotion repeated or jumped.
    bool vehicle_motion_counter_error{false};
    // A signal of VehicleMotion was not available or out of range.
    bool vehicle_motion_signal_invalid{false};
    // Received frames were lost for want of room.
    bool receive_overflow{false};
    // The bus is not error-active, or it did not take a frame.
    bool bus_error{false};
    // The vehicle parameters were refused.
    bool parameters_invalid{false};
    // A cycle began late.
    bool cycle_overrun{false};
    // Cycles that began late since the start; stays at 255. 0 to 255.
    std::uint8_t cycle_overruns{0U};
    // Frames that the end-to-end check refused since the start; stays at 255. 0 to 255.
    std::uint8_t frames_rejected{0U};
    // Frames that the counters show as lost since the start; stays at 255. 0 to 255.
    std::uint8_t frames_lost{0U};
    // Version of the software: 16 times the major number plus the minor number. 0 to 255.
    std::uint8_t software_version{0U};

    struct Status {
        SignalStatus imu_timeout{SignalStatus::not_available};
        SignalStatus imu_checksum_error{SignalStatus::not_available};
        SignalStatus imu_counter_error{SignalStatus::not_available};
        SignalStatus imu_signal_invalid{SignalStatus::not_available};
        SignalStatus roll_angle_timeout{SignalStatus::not_available};
        SignalStatus roll_angle_checksum_error{SignalStatus::not_available};
        SignalStatus roll_angle_counter_error{SignalStatus::not_available};
        SignalStatus roll_angle_signal_invalid{SignalStatus::not_available};
        SignalStatus vehicle_motion_timeout{SignalStatus::not_available};
        SignalStatus vehicle_motion_checksum_error{SignalStatus::not_available};
        SignalStatus vehicle_motion_counter_error{SignalStatus::not_available};
        SignalStatus vehicle_motion_signal_invalid{SignalStatus::not_available};
        SignalStatus receive_overflow{SignalStatus::not_available};
        SignalStatus bus_error{SignalStatus::not_available};
        SignalStatus parameters_invalid{SignalStatus::not_available};
        SignalStatus cycle_overrun{SignalStatus::not_available};
        SignalStatus cycle_overruns{SignalStatus::not_available};
        SignalStatus frames_rejected{SignalStatus::not_available};
        SignalStatus frames_lost{SignalStatus::not_available};
        SignalStatus software_version{SignalStatus::not_available};

        constexpr bool all_valid() const {
            return imu_timeout == SignalStatus::valid &&
                   imu_checksum_error == SignalStatus::valid &&
                   imu_counter_error == SignalStatus::valid &&
                   imu_signal_invalid == SignalStatus::valid &&
                   roll_angle_timeout == SignalStatus::valid &&
                   roll_angle_checksum_error == SignalStatus::valid &&
                   roll_angle_counter_error == SignalStatus::valid &&
                   roll_angle_signal_invalid == SignalStatus::valid &&
                   vehicle_motion_timeout == SignalStatus::valid &&
                   vehicle_motion_checksum_error == SignalStatus::valid &&
                   vehicle_motion_counter_error == SignalStatus::valid &&
                   vehicle_motion_signal_invalid == SignalStatus::valid &&
                   receive_overflow == SignalStatus::valid &&
                   bus_error == SignalStatus::valid &&
                   parameters_invalid == SignalStatus::valid &&
                   cycle_overrun == SignalStatus::valid &&
                   cycle_overruns == SignalStatus::valid &&
                   frames_rejected == SignalStatus::valid &&
                   frames_lost == SignalStatus::valid &&
                   software_version == SignalStatus::valid;
        }
    };

    struct Signals {
        static constexpr IntegerSignal imu_timeout{
            {ByteOrder::little_endian, 16U, 1U, false}, 0, 1, 0};
        static constexpr IntegerSignal imu_checksum_error{
            {ByteOrder::little_endian, 17U, 1U, false}, 0, 1, 0};
        static constexpr IntegerSignal imu_counter_error{
            {ByteOrder::little_endian, 18U, 1U, false}, 0, 1, 0};
        static constexpr IntegerSignal imu_signal_invalid{
            {ByteOrder::little_endian, 19U, 1U, false}, 0, 1, 0};
        static constexpr IntegerSignal roll_angle_timeout{
            {ByteOrder::little_endian, 20U, 1U, false}, 0, 1, 0};
        static constexpr IntegerSignal roll_angle_checksum_error{
            {ByteOrder::little_endian, 21U, 1U, false}, 0, 1, 0};
        static constexpr IntegerSignal roll_angle_counter_error{
            {ByteOrder::little_endian, 22U, 1U, false}, 0, 1, 0};
        static constexpr IntegerSignal roll_angle_signal_invalid{
            {ByteOrder::little_endian, 23U, 1U, false}, 0, 1, 0};
        static constexpr IntegerSignal vehicle_motion_timeout{
            {ByteOrder::little_endian, 24U, 1U, false}, 0, 1, 0};
        static constexpr IntegerSignal vehicle_motion_checksum_error{
            {ByteOrder::little_endian, 25U, 1U, false}, 0, 1, 0};
        static constexpr IntegerSignal vehicle_motion_counter_error{
            {ByteOrder::little_endian, 26U, 1U, false}, 0, 1, 0};
        static constexpr IntegerSignal vehicle_motion_signal_invalid{
            {ByteOrder::little_endian, 27U, 1U, false}, 0, 1, 0};
        static constexpr IntegerSignal receive_overflow{
            {ByteOrder::little_endian, 28U, 1U, false}, 0, 1, 0};
        static constexpr IntegerSignal bus_error{
            {ByteOrder::little_endian, 29U, 1U, false}, 0, 1, 0};
        static constexpr IntegerSignal parameters_invalid{
            {ByteOrder::little_endian, 30U, 1U, false}, 0, 1, 0};
        static constexpr IntegerSignal cycle_overrun{
            {ByteOrder::little_endian, 31U, 1U, false}, 0, 1, 0};
        static constexpr IntegerSignal cycle_overruns{
            {ByteOrder::little_endian, 32U, 8U, false}, 0, 255, 0};
        static constexpr IntegerSignal frames_rejected{
            {ByteOrder::little_endian, 40U, 8U, false}, 0, 255, 0};
        static constexpr IntegerSignal frames_lost{
            {ByteOrder::little_endian, 48U, 8U, false}, 0, 255, 0};
        static constexpr IntegerSignal software_version{
            {ByteOrder::little_endian, 56U, 8U, false}, 0, 255, 0};
    };

    // See rsi::can_dbc::encode and decode.
    constexpr std::array<std::uint8_t, length> encode() const {
        std::array<std::uint8_t, length> payload{};
        write_signal(Signals::imu_timeout, imu_timeout, payload.data());
        write_signal(Signals::imu_checksum_error, imu_checksum_error, payload.data());
        write_signal(Signals::imu_counter_error, imu_counter_error, payload.data());
        write_signal(Signals::imu_signal_invalid, imu_signal_invalid, payload.data());
        write_signal(Signals::roll_angle_timeout, roll_angle_timeout, payload.data());
        write_signal(Signals::roll_angle_checksum_error, roll_angle_checksum_error, payload.data());
        write_signal(Signals::roll_angle_counter_error, roll_angle_counter_error, payload.data());
        write_signal(Signals::roll_angle_signal_invalid, roll_angle_signal_invalid, payload.data());
        write_signal(Signals::vehicle_motion_timeout, vehicle_motion_timeout, payload.data());
        write_signal(Signals::vehicle_motion_checksum_error, vehicle_motion_checksum_error, payload.data());
        write_signal(Signals::vehicle_motion_counter_error, vehicle_motion_counter_error, payload.data());
        write_signal(Signals::vehicle_motion_signal_invalid, vehicle_motion_signal_invalid, payload.data());
        write_signal(Signals::receive_overflow, receive_overflow, payload.data());
        write_signal(Signals::bus_error, bus_error, payload.data());
        write_signal(Signals::parameters_invalid, parameters_invalid, payload.data());
        write_signal(Signals::cycle_overrun, cycle_overrun, payload.data());
        write_signal(Signals::cycle_overruns, cycle_overruns, payload.data());
        write_signal(Signals::frames_rejected, frames_rejected, payload.data());
        write_signal(Signals::frames_lost, frames_lost, payload.data());
        write_signal(Signals::software_version, software_version, payload.data());
        return payload;
    }

    static constexpr Decoded<RolloverStatus> decode(const std::uint8_t* payload);

    // Calls visitor(name, unit, member, status member) for each signal.
    template <typename Visitor>
    static constexpr void visit_signals(Visitor&& visitor) {
        visitor("ImuTimeout", "-", &RolloverStatus::imu_timeout, &Status::imu_timeout);
        visitor("ImuChecksumError", "-", &RolloverStatus::imu_checksum_error, &Status::imu_checksum_error);
        visitor("ImuCounterError", "-", &RolloverStatus::imu_counter_error, &Status::imu_counter_error);
        visitor("ImuSignalInvalid", "-", &RolloverStatus::imu_signal_invalid, &Status::imu_signal_invalid);
        visitor("RollAngleTimeout", "-", &RolloverStatus::roll_angle_timeout, &Status::roll_angle_timeout);
        visitor("RollAngleChecksumError", "-", &RolloverStatus::roll_angle_checksum_error, &Status::roll_angle_checksum_error);
        visitor("RollAngleCounterError", "-", &RolloverStatus::roll_angle_counter_error, &Status::roll_angle_counter_error);
        visitor("RollAngleSignalInvalid", "-", &RolloverStatus::roll_angle_signal_invalid, &Status::roll_angle_signal_invalid);
        visitor("VehicleMotionTimeout", "-", &RolloverStatus::vehicle_motion_timeout, &Status::vehicle_motion_timeout);
        visitor("VehicleMotionChecksumError", "-", &RolloverStatus::vehicle_motion_checksum_error, &Status::vehicle_motion_checksum_error);
        visitor("VehicleMotionCounterError", "-", &RolloverStatus::vehicle_motion_counter_error, &Status::vehicle_motion_counter_error);
        visitor("VehicleMotionSignalInvalid", "-", &RolloverStatus::vehicle_motion_signal_invalid, &Status::vehicle_motion_signal_invalid);
        visitor("ReceiveOverflow", "-", &RolloverStatus::receive_overflow, &Status::receive_overflow);
        visitor("BusError", "-", &RolloverStatus::bus_error, &Status::bus_error);
        visitor("ParametersInvalid", "-", &RolloverStatus::parameters_invalid, &Status::parameters_invalid);
        visitor("CycleOverrun", "-", &RolloverStatus::cycle_overrun, &Status::cycle_overrun);
        visitor("CycleOverruns", "-", &RolloverStatus::cycle_overruns, &Status::cycle_overruns);
        visitor("FramesRejected", "-", &RolloverStatus::frames_rejected, &Status::frames_rejected);
        visitor("FramesLost", "-", &RolloverStatus::frames_lost, &Status::frames_lost);
        visitor("SoftwareVersion", "-", &RolloverStatus::software_version, &Status::software_version);
    }
};

constexpr Decoded<RolloverStatus> RolloverStatus::decode(const std::uint8_t* payload) {
    Decoded<RolloverStatus> decoded{};
    read_signal(Signals::imu_timeout, payload, decoded.value.imu_timeout, decoded.status.imu_timeout);
    read_signal(Signals::imu_checksum_error, payload, decoded.value.imu_checksum_error, decoded.status.imu_checksum_error);
    read_signal(Signals::imu_counter_error, payload, decoded.value.imu_counter_error, decoded.status.imu_counter_error);
    read_signal(Signals::imu_signal_invalid, payload, decoded.value.imu_signal_invalid, decoded.status.imu_signal_invalid);
    read_signal(Signals::roll_angle_timeout, payload, decoded.value.roll_angle_timeout, decoded.status.roll_angle_timeout);
    read_signal(Signals::roll_angle_checksum_error, payload, decoded.value.roll_angle_checksum_error, decoded.status.roll_angle_checksum_error);
    read_signal(Signals::roll_angle_counter_error, payload, decoded.value.roll_angle_counter_error, decoded.status.roll_angle_counter_error);
    read_signal(Signals::roll_angle_signal_invalid, payload, decoded.value.roll_angle_signal_invalid, decoded.status.roll_angle_signal_invalid);
    read_signal(Signals::vehicle_motion_timeout, payload, decoded.value.vehicle_motion_timeout, decoded.status.vehicle_motion_timeout);
    read_signal(Signals::vehicle_motion_checksum_error, payload, decoded.value.vehicle_motion_checksum_error, decoded.status.vehicle_motion_checksum_error);
    read_signal(Signals::vehicle_motion_counter_error, payload, decoded.value.vehicle_motion_counter_error, decoded.status.vehicle_motion_counter_error);
    read_signal(Signals::vehicle_motion_signal_invalid, payload, decoded.value.vehicle_motion_signal_invalid, decoded.status.vehicle_motion_signal_invalid);
    read_signal(Signals::receive_overflow, payload, decoded.value.receive_overflow, decoded.status.receive_overflow);
    read_signal(Signals::bus_error, payload, decoded.value.bus_error, decoded.status.bus_error);
    read_signal(Signals::parameters_invalid, payload, decoded.value.parameters_invalid, decoded.status.parameters_invalid);
    read_signal(Signals::cycle_overrun, payload, decoded.value.cycle_overrun, decoded.status.cycle_overrun);
    read_signal(Signals::cycle_overruns, payload, decoded.value.cycle_overruns, decoded.status.cycle_overruns);
    read_signal(Signals::frames_rejected, payload, decoded.value.frames_rejected, decoded.status.frames_rejected);
    read_signal(Signals::frames_lost, payload, decoded.value.frames_lost, decoded.status.frames_lost);
    read_signal(Signals::software_version, payload, decoded.value.software_version, decoded.status.software_version);
    return decoded;
}

// Calls visitor(MessageType<Message>{}) for each message of the DBC file.
template <typename Visitor>
constexpr void visit_messages(Visitor&& visitor) {
    visitor(MessageType<Imu>{});
    visitor(MessageType<RollAngle>{});
    visitor(MessageType<VehicleMotion>{});
    visitor(MessageType<VehicleMass>{});
    visitor(MessageType<RolloverWarning>{});
    visitor(MessageType<RollCentreEstimate>{});
    visitor(MessageType<RollIndicesAhead>{});
    visitor(MessageType<RollIndicesClassic>{});
    visitor(MessageType<RollObserver>{});
    visitor(MessageType<RolloverDiagnosis>{});
    visitor(MessageType<LearntLoad>{});
    visitor(MessageType<RolloverStatus>{});
}

// Frames of ImuSensor, in the file's order.
using MessagesFromImuSensor = MessageList<Imu>;

// Frames of RollAngleSensor, in the file's order.
using MessagesFromRollAngleSensor = MessageList<RollAngle>;

// Frames of VehicleGateway, in the file's order.
using MessagesFromVehicleGateway = MessageList<VehicleMotion, VehicleMass>;

// Frames of RolloverEcu, in the file's order.
using MessagesFromRolloverEcu = MessageList<RolloverWarning, RollCentreEstimate, RollIndicesAhead, RollIndicesClassic, RollObserver, RolloverDiagnosis, LearntLoad, RolloverStatus>;

}  // namespace rsi::can_dbc
