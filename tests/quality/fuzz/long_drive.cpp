// The component over minutes: what it learns, counts and accumulates reaches its ends, with any calibration.
// The body leans as the force asks for, so that there is something to learn; some sensors say something else.
// The properties are those of single steps.
#include <array>
#include <cmath>
#include <cstdint>

#include "rsi/component.hpp"
#include "tests/quality/fuzz/support/any_calibration.hpp"
#include "tests/quality/fuzz/support/byte_reader.hpp"
#include "tests/quality/fuzz/support/component_judge.hpp"
#include "tests/quality/fuzz/support/input_fields.hpp"

namespace {

using fuzz::ByteReader;
using fuzz::input_count;
using fuzz::input_fields;

// Ten minutes: several times what the slowest estimates take.
constexpr unsigned most_steps = 60000U;
constexpr double cycle_time_s = 0.01;
constexpr double gravity_mps2 = 9.80665;
constexpr double two_pi = 6.283185307179586;

// Distortion of a sensor's value.
struct Deviation {
    double gain{1.0};
    double offset{0.0};
};

Deviation any_deviation(float limit, ByteReader& bytes) {
    constexpr std::array<double, 8> gains = {0.0, 1.0, -1.0, 0.5, 2.0, 1e-38, 1e3, 1e38};
    const unsigned choice = bytes.below(16U);
    const double offset =
        static_cast<double>(bytes.take<std::int16_t>()) / 32000.0 * static_cast<double>(limit);
    if (choice < gains.size()) {
        return {gains[choice], 0.0};
    }
    return {(choice % 2U == 0U) ? 1.0 : 0.0, (choice == 15U) ? std::nan("") : offset};
}

// A stretch of the drive: turns of one frequency.
struct Segment {
    unsigned steps{1U};
    double amplitude_mps2{0.0};
    double frequency_hz{0.0};
    double speed_mps{0.0};
    double lean_rad_s2pm{0.0};  // steady roll angle per lateral acceleration
    std::array<Deviation, input_count> deviations{};
};

Segment next_segment(Segment segment, ByteReader& bytes) {
    constexpr std::array<double, 8> frequencies_hz = {0.0, 0.02, 0.1, 0.3, 1.0, 3.0, 12.5, 49.0};
    segment.steps = 1U + bytes.take<std::uint16_t>() % 12000U;
    segment.amplitude_mps2 = 0.1 * bytes.below(128U);
    segment.frequency_hz = frequencies_hz[bytes.below(frequencies_hz.size())];
    segment.speed_mps = 0.5 * bytes.below(120U);
    segment.lean_rad_s2pm = 5e-4 * bytes.below(100U);
    for (unsigned changes = bytes.below(4U); changes > 0U; --changes) {
        const unsigned field = bytes.below(input_count);
        segment.deviations[field] = any_deviation(input_fields[field].limit, bytes);
    }
    return segment;
}

rsi_inputs sensed(const Segment& segment, const rsi_parameters& calibration, double phase_rad) {
    const double force = segment.amplitude_mps2 * std::sin(phase_rad);
    const double change = segment.amplitude_mps2 * std::cos(phase_rad) * two_pi * segment.frequency_hz;
    rsi_inputs inputs{};
    inputs.lateral_specific_force_mps2 = static_cast<float>(force);
    inputs.vertical_specific_force_mps2 = static_cast<float>(gravity_mps2);
    inputs.roll_angle_rad = static_cast<float>(segment.lean_rad_s2pm * force);
    inputs.roll_rate_radps = static_cast<float>(segment.lean_rad_s2pm * change);
    inputs.speed_mps = static_cast<float>(segment.speed_mps);
    inputs.yaw_rate_radps = static_cast<float>(force / std::fmax(segment.speed_mps, 1.0));
    inputs.steering_wheel_angle_rad = static_cast<float>(0.3 * force);
    inputs.vehicle_mass_kg = 1.2F * calibration.sprung_mass_kg;
    for (unsigned k = 0U; k < input_count; ++k) {
        float& value = inputs.*input_fields[k].member;
        const Deviation& deviation = segment.deviations[k];
        value = static_cast<float>(deviation.gain * static_cast<double>(value) + deviation.offset);
    }
    return inputs;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    ByteReader bytes{data, size};
    const rsi_parameters parameters = fuzz::any_calibration(bytes);
    rsi::Component component;
    const bool accepted = component.init(parameters).accepted == 1;
    if (!accepted) {
        return 0;  // component.cpp holds that nothing comes of it
    }
    fuzz::ComponentJudge judge{parameters, accepted};
    Segment segment;
    double phase_rad = 0.0;
    for (unsigned step = 0U; step < most_steps && !bytes.empty();) {
        segment = next_segment(segment, bytes);
        for (unsigned left = segment.steps; left > 0U && step < most_steps; --left, ++step) {
            const rsi_inputs inputs = sensed(segment, parameters, phase_rad);
            phase_rad += two_pi * segment.frequency_hz * cycle_time_s;
            rsi_outputs outputs{};
            component.step(inputs, outputs);
            judge.judge(inputs, outputs);
        }
    }
    return 0;
}
