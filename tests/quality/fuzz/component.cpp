// The component's step over any sequence of inputs, with any calibration: whatever comes, every output is
// defined, the state is one that the warning's rules allow, and without the necessary inputs it is
// "unavailable". Some inputs run a twin beside it: one in storage that held other data (through the C
// interface), or one that sees the mirrored drive.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <optional>

#include "rsi/component.hpp"
#include "rsi/parameters.hpp"
#include "tests/quality/fuzz/support/byte_reader.hpp"
#include "tests/quality/fuzz/support/require.hpp"
#include "tests/rsi/support/output_fields.hpp"
#include "tests/support/large_suv.h"

namespace {

using fuzz::ByteReader;
using fuzz::require;

// So many that an input is soon done; holds and recovery of a second are drawn to zero in half of them.
constexpr int most_steps = 128;

struct InputField {
    float rsi_inputs::* member;
    float limit;  // beyond it a value is not available
    bool turns_with_the_mirror;
};

constexpr InputField input_fields[] = {
    {&rsi_inputs::lateral_specific_force_mps2, 60.0F, true},
    {&rsi_inputs::vertical_specific_force_mps2, 60.0F, false},
    {&rsi_inputs::roll_rate_radps, 10.0F, true},
    {&rsi_inputs::roll_angle_rad, 2.2F, true},
    {&rsi_inputs::yaw_rate_radps, 10.0F, true},
    {&rsi_inputs::bank_angle_rad, 0.8F, true},
    {&rsi_inputs::speed_mps, 150.0F, false},
    {&rsi_inputs::steering_wheel_angle_rad, 30.0F, true},
};
constexpr unsigned input_count = sizeof input_fields / sizeof input_fields[0];

bool is_available(float value, float limit) {
    return std::isfinite(value) && std::fabs(value) <= limit;
}

// A large SUV with a few values anywhere between their limits; not all of it will be accepted.
rsi_parameters any_calibration(ByteReader& bytes) {
    rsi_parameters parameters = rsi_test_large_suv();
    parameters.imu_x_m = 1.0F;
    parameters.imu_y_m = -0.5F;
    parameters.imu_z_m = 0.5F;
    const unsigned choices = bytes.below(4U);  // one byte for both, as the committed inputs have it
    parameters.estimator = static_cast<std::int32_t>(choices % 2U);
    parameters.roll_angle_reference = static_cast<std::int32_t>(choices / 2U);
    parameters.warning_indicator = static_cast<std::int32_t>(bytes.below(13U));
    if (bytes.one_in(2U)) {
        parameters.recovery_s = parameters.advisory_hold_s = parameters.warning_hold_s = 0.0F;
    }
    for (unsigned changes = bytes.below(8U); changes > 0U; --changes) {
        const rsi::ParameterField& field = rsi::parameter_fields[bytes.below(rsi::parameter_fields.size())];
        const float share = static_cast<float>(bytes.take<std::uint16_t>()) / 65535.0F;
        parameters.*field.member = field.minimum + share * (field.maximum - field.minimum);
    }
    if (bytes.one_in(16U)) {
        parameters.*rsi::parameter_fields[bytes.below(rsi::parameter_fields.size())].member =
            bytes.take<float>();
    }
    return parameters;
}

// A value of the scale of its range, a little beyond it at both ends.
void set_scaled(rsi_inputs& inputs, const InputField& field, ByteReader& bytes) {
    inputs.*field.member = static_cast<float>(bytes.take<std::int16_t>()) / 32000.0F * field.limit;
}

// Changes the inputs as the bytes say; returns how many steps to make with them.
int next_inputs(rsi_inputs& inputs, ByteReader& bytes) {
    const unsigned control = bytes.take<std::uint8_t>();
    const InputField& field = input_fields[(control >> 3U) % input_count];
    switch (control % 8U) {
        case 0U:
            inputs.*field.member = bytes.take<float>();  // any bits: NaN, infinite, subnormal
            break;
        case 1U:
            inputs.*field.member = rsi::not_available;
            break;
        case 2U:
            for (const InputField& each : input_fields) {
                set_scaled(inputs, each, bytes);
            }
            break;
        case 3U:
            return 1 + static_cast<int>(bytes.below(32U));
        default:
            set_scaled(inputs, field, bytes);
            break;
    }
    return static_cast<int>(control >> 6U);
}

// What the outputs must be at each step, given the inputs so far.
class Judge {
 public:
    Judge(const rsi_parameters& parameters, bool accepted) : parameters_{parameters}, accepted_{accepted} {}

    void judge(const rsi_inputs& inputs, const rsi_outputs& outputs) {
        follow(inputs);
        require(outputs.state <= RSI_STATE_WARNING, "the state is one of four");
        require(outputs.side <= RSI_SIDE_RIGHT, "the side is one of three");
        require(outputs.roll_source <= RSI_ROLL_OBSERVER, "the roll angle has one of three sources");
        require((outputs.roll_sensor_disagrees | outputs.estimate_frozen | 1) == 1, "a flag is 0 or 1");
        require((outputs.state >= RSI_STATE_ADVISORY) || (outputs.side == RSI_SIDE_NONE),
                "only a risk has a side");
        if (outputs.state == RSI_STATE_UNAVAILABLE) {
            steps_at_warning_level_ = 0;
        }
        if (!possible_) {
            require(outputs.state == RSI_STATE_UNAVAILABLE, "unavailable without what is necessary");
            require(rsi_test::all_not_available(outputs), "no number without what is necessary");
            return;
        }
        if (outputs.state == RSI_STATE_UNAVAILABLE && rsi_test::all_not_available(outputs)) {
            return;
        }
        require(rsi_test::all_finite(outputs), "every number is finite");
        judge_optional(outputs);
        judge_ranges(outputs);
        judge_state(outputs);
    }

 private:
    void follow(const rsi_inputs& inputs) {
        const bool necessary = is_available(inputs.lateral_specific_force_mps2, 60.0F) &&
                               is_available(inputs.roll_rate_radps, 10.0F);
        const bool observable =
            is_available(inputs.yaw_rate_radps, 10.0F) && is_available(inputs.speed_mps, 150.0F);
        possible_ = accepted_ && necessary && (is_available(inputs.roll_angle_rad, 2.2F) || observable);
        possible_steps_ = possible_ ? possible_steps_ + 1 : 0;
    }

    static void judge_optional(const rsi_outputs& outputs) {
        for (const rsi::NumberOutput& field : rsi::number_outputs) {
            require(!std::isinf(outputs.*field.member), "no number is infinite");
        }
    }

    static bool within(float value, float lowest, float highest) {
        return std::isnan(value) || (value >= lowest && value <= highest);
    }

    void judge_ranges(const rsi_outputs& outputs) const {
        require(within(outputs.warning_level, 0.0F, 20.0F), "warning_level is 0 to 20");
        require(within(outputs.rsi, 0.0F, 1.0F), "rsi is 0 to 1");
        require(within(outputs.rsi_bank_free, 0.0F, 20.0F), "rsi_bank_free is 0 to 20");
        require(within(outputs.rsi_extended, 0.0F, 20.0F), "rsi_extended is 0 to 20");
        require(within(outputs.load_transfer_ratio, -20.0F, 20.0F), "load_transfer_ratio is -20 to 20");
        require(within(outputs.predicted_load_transfer_ratio, -20.0F, 20.0F),
                "predicted_load_transfer_ratio is -20 to 20");
        require(within(outputs.time_to_rollover_s, 0.0F, 10.0F), "time_to_rollover_s is 0 to 10");
        require(outputs.road_normal_force_mps2 > 0.9F, "the normal force never comes near zero");
        require(outputs.lateral_acceleration_threshold_mps2 != 0.0F, "the threshold is never zero");
        if (parameters_.estimator == RSI_ESTIMATOR_CONSIDER_KALMAN) {
            require(std::fabs(outputs.roll_centre_vertical_m) <= parameters_.roll_centre_limit_m,
                    "the roll centre's movement stays within its limit");
        }
    }

    void judge_state(const rsi_outputs& outputs) {
        const int recovery_steps = static_cast<int>(parameters_.recovery_s * 100.0F + 0.5F);
        require(possible_steps_ >= recovery_steps || outputs.state == RSI_STATE_UNAVAILABLE,
                "unavailable until the inputs were good for the recovery time");
        require(outputs.state == RSI_STATE_UNAVAILABLE || outputs.roll_source != RSI_ROLL_NONE,
                "no statement without a roll angle");
        if (outputs.state == RSI_STATE_UNAVAILABLE) {
            return;
        }
        require(outputs.state != RSI_STATE_READY || outputs.warning_level < parameters_.advisory_on,
                "never ready at a level that asks for an advisory");
        if (outputs.warning_level < parameters_.warning_on) {
            steps_at_warning_level_ = 0;
            return;
        }
        ++steps_at_warning_level_;
        const int confirmation_steps = static_cast<int>(parameters_.warning_confirmation_s * 100.0F + 0.5F);
        require(steps_at_warning_level_ < confirmation_steps || outputs.state == RSI_STATE_WARNING,
                "warned of a risk once it is confirmed");
    }

    rsi_parameters parameters_;
    bool accepted_;
    bool possible_{false};
    int possible_steps_{0};
    int steps_at_warning_level_{0};
};

// The same component through the C interface, in storage that held something else before.
class StorageTwin {
 public:
    explicit StorageTwin(const rsi_parameters& parameters) {
        std::memset(&storage_, 0xA5, sizeof storage_);
        static_cast<void>(rsi_init(&storage_, &parameters));
    }

    void step(const rsi_inputs& inputs, const rsi_outputs& expected) {
        rsi_outputs outputs;
        std::memset(&outputs, 0x5A, sizeof outputs);
        rsi_step(&storage_, &inputs, &outputs);
        bool same = outputs.state == expected.state && outputs.side == expected.side &&
                    outputs.roll_source == expected.roll_source &&
                    outputs.roll_sensor_disagrees == expected.roll_sensor_disagrees &&
                    outputs.estimate_frozen == expected.estimate_frozen;
        for (const rsi::NumberOutput& field : rsi::number_outputs) {
            same =
                same && rsi_test::bits_of(outputs.*field.member) == rsi_test::bits_of(expected.*field.member);
        }
        require(same, "the C interface gives the same bits, whatever its storage held");
    }

 private:
    rsi_component storage_;
};

// Sees every input from the other side.
class MirrorTwin {
 public:
    explicit MirrorTwin(rsi_parameters parameters) {
        parameters.imu_y_m = -parameters.imu_y_m;
        static_cast<void>(component_.init(parameters));
    }

    void step(const rsi_inputs& inputs, const rsi_outputs& expected) {
        rsi_inputs mirrored = inputs;
        for (const InputField& field : input_fields) {
            mirrored.*field.member = (field.turns_with_the_mirror ? -1.0F : 1.0F) * (inputs.*field.member);
        }
        rsi_outputs outputs{};
        component_.step(mirrored, outputs);
        // Where nothing pulls to either side the threshold must take one all the same, and what follows
        // differs.
        undecided_ = undecided_ || expected.road_parallel_force_mps2 == 0.0F;
        if (undecided_) {
            return;
        }
        for (const rsi::NumberOutput& field : rsi::number_outputs) {
            const float a = std::fabs(outputs.*field.member);
            const float b = std::fabs(expected.*field.member);
            if (a != b && !(std::isnan(a) && std::isnan(b))) {
                std::fprintf(stderr, "%s: %.9g and %.9g\n", field.name, static_cast<double>(a),
                             static_cast<double>(b));
                require(false, "left and right give the same magnitudes");
            }
        }
        require(outputs.state == expected.state, "left and right give the same state");
    }

 private:
    rsi::Component component_;
    bool undecided_{false};
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    ByteReader bytes{data, size};
    const unsigned twin = bytes.below(4U);
    const rsi_parameters parameters = any_calibration(bytes);
    rsi::Component component;
    const rsi_validation answer = component.init(parameters);
    require((answer.accepted == 1) == (std::strlen(answer.field) == 0U), "a refusal names the field");

    std::optional<StorageTwin> storage_twin;
    std::optional<MirrorTwin> mirror_twin;
    if (twin == 1U) {
        storage_twin.emplace(parameters);
    } else if (twin == 2U) {
        mirror_twin.emplace(parameters);
    }

    Judge judge{parameters, answer.accepted == 1};
    rsi_inputs inputs{};
    inputs.vertical_specific_force_mps2 = 9.80665F;
    for (int step = 0; step < most_steps && !bytes.empty();) {
        for (int left = next_inputs(inputs, bytes); left > 0 && step < most_steps; --left, ++step) {
            rsi_outputs outputs{};
            component.step(inputs, outputs);
            judge.judge(inputs, outputs);
            if (storage_twin) {
                storage_twin->step(inputs, outputs);
            }
            if (mirror_twin) {
                mirror_twin->step(inputs, outputs);
            }
        }
    }
    return 0;
}
