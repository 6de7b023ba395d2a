#include "tests/targets/budgets/dear_drive.hpp"

#include <cstddef>
#include <limits>

#include "tests/rsi/support/random_manoeuvre.hpp"

namespace budgets {
namespace {

constexpr float missing = std::numeric_limits<float>::quiet_NaN();

// Each bit of `absent` takes one input away.
rsi_inputs without(rsi_inputs inputs, unsigned absent) {
    float* const optional[] = {&inputs.vertical_specific_force_mps2, &inputs.roll_angle_rad,
                               &inputs.yaw_rate_radps, &inputs.bank_angle_rad,
                               &inputs.steering_wheel_angle_rad};
    for (std::size_t i = 0U; i < 5U; ++i) {
        if ((absent >> i) & 1U) {
            *optional[i] = missing;
        }
    }
    return inputs;
}

rsi_inputs mirrored(rsi_inputs inputs) {
    inputs.lateral_specific_force_mps2 *= -1.0F;
    inputs.roll_rate_radps *= -1.0F;
    inputs.roll_angle_rad *= -1.0F;
    inputs.yaw_rate_radps *= -1.0F;
    inputs.bank_angle_rad *= -1.0F;
    inputs.steering_wheel_angle_rad *= -1.0F;
    return inputs;
}

void add_alternatives(const rsi_inputs& inputs, std::vector<Record>& records) {
    const auto add = [&](const rsi_inputs& alternative) { records.push_back(Record{alternative, 1U}); };
    for (unsigned absent = 0U; absent < 32U; ++absent) {
        add(without(inputs, absent));
    }
    add(mirrored(inputs));
    for (const float angle_rad : {-2.0F, -0.5F, 0.5F, 2.0F}) {
        rsi_inputs other = inputs;
        other.roll_angle_rad = angle_rad;
        add(other);
    }
    for (const float force_mps2 : {-20.0F, -5.0F, 0.0F, 5.0F, 20.0F}) {
        rsi_inputs other = inputs;
        other.lateral_specific_force_mps2 = force_mps2;
        other.roll_rate_radps = 0.1F * force_mps2;
        add(other);
    }
    rsi_inputs braking = inputs;
    braking.speed_mps -= 10.0F;
    add(braking);
}

// Events of the sensors and the vehicle while time passes.
rsi_inputs with_faults(rsi_inputs inputs, int sample) {
    const int phase = sample % 500;
    if (phase < 3) {
        inputs.lateral_specific_force_mps2 = missing;  // a gap, then everything starts again
    } else if ((phase >= 150) && (phase < 220)) {
        inputs.roll_angle_rad = missing;  // the observer takes over
    } else if ((phase >= 300) && (phase < 340)) {
        inputs.roll_angle_rad += 0.3F;  // the sensor lies
    } else if ((phase >= 400) && (phase < 405)) {
        inputs.roll_angle_rad = 1.8F;  // on its side
    } else if ((phase >= 430) && (phase < 480)) {
        inputs.speed_mps -= 0.1F * static_cast<float>(phase - 430);  // hard braking
    }
    return inputs;
}

}  // namespace

std::vector<Record> dear_drive(const rsi::Parameters& parameters, const DearDriveOptions& options) {
    rsi_test::RandomManoeuvre drive(parameters, options.seed, true);
    std::vector<Record> records;
    for (int sample = 0; sample < options.samples; ++sample) {
        const rsi_inputs inputs = with_faults(drive.next(), sample);
        if (sample % options.alternatives_every == 0) {
            add_alternatives(inputs, records);
        }
        records.push_back(Record{inputs, 0U});
    }
    return records;
}

}  // namespace budgets
