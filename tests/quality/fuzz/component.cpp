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
#include "rsi/rsi.h"
#include "tests/quality/fuzz/support/any_calibration.hpp"
#include "tests/quality/fuzz/support/byte_reader.hpp"
#include "tests/quality/fuzz/support/component_judge.hpp"
#include "tests/quality/fuzz/support/input_fields.hpp"
#include "tests/quality/fuzz/support/require.hpp"
#include "tests/rsi/support/output_fields.hpp"

namespace {

using fuzz::ByteReader;
using fuzz::input_count;
using fuzz::input_fields;
using fuzz::InputField;
using fuzz::require;

// Few enough that an input is soon done; holds and recovery of a second are drawn to zero in half of them.
// long_drive.cpp covers minutes.
constexpr int most_steps = 128;

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
        // If nothing pulls to either side the threshold must take one all the same, and what follows
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
    const rsi_parameters parameters = fuzz::any_calibration(bytes);
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

    fuzz::ComponentJudge judge{parameters, answer.accepted == 1};
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
