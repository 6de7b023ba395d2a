// How well the component knows roll and bank without a roll sensor, in every manoeuvre of the catalogue, and
// what it says of a roll sensor that fails. Prints the table of docs/theory.md.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <optional>
#include <string>

#include "rsi/component.hpp"
#include "sil/files/calibration_file.hpp"
#include "sil/simulation/component_inputs.hpp"
#include "sil/simulation/mounted_sensors.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/manoeuvres/manoeuvre_run.hpp"
#include "sil/world/sensors/sensor_suite.hpp"
#include "sil/world/vehicle/parameter_file.hpp"

namespace rsi_test {
namespace observer_accuracy_test {
namespace {

constexpr double degrees_per_radian = 57.295779513082321;
constexpr double bias_g = 0.005;

struct Setting {
    std::string vehicle;
    double stiffness_factor{1.0};  // of the calibration: K is not known exactly
    double damping_nmsprad{0.0};   // 0: the calibration's
    std::uint64_t seed{7U};
};

using RollSensor = std::function<float(float)>;

float intact(float roll_angle_rad) {
    return roll_angle_rad;
}
float absent(float) {
    return std::numeric_limits<float>::quiet_NaN();
}

struct Result {
    double roll_rms_deg{0.0};  // before the first wheel lifts
    double bank_rms_deg{0.0};
    int samples{0};
    int disagreements{0};                  // cycles with the flag, before the first wheel lifts
    std::optional<double> flagged_s{};     // when the flag first came
    std::optional<double> warned_s{};      // when the warning first came
    std::optional<double> two_wheels_s{};  // when both wheels of a side had lifted
    int unavailable{0};                    // cycles after the first second
    rsi::Outputs last{};
};

std::string source(const std::string& path) {
    return std::string{RSI_SOURCE_DIR} + path;
}

rsi::Inputs inputs_of(const sil::SensorSample& sample, const RollSensor& roll_sensor) {
    rsi::Inputs inputs = sil::to_inputs(sample);
    inputs.roll_angle_rad = roll_sensor(inputs.roll_angle_rad);
    return inputs;
}

// The calibration file's values, with the CG as high as the manoeuvre puts it.
rsi::Parameters calibration(const Setting& setting, double raised_m) {
    rsi::Parameters parameters =
        sil::load_calibration(source("/firmware/calibrations/" + setting.vehicle + ".toml"));
    const auto factor = static_cast<float>(setting.stiffness_factor);
    parameters.roll_stiffness_nmprad *= factor;
    parameters.roll_stiffness_cubic_nmprad3 *= factor;
    parameters.roll_stiffness_quintic_nmprad5 *= factor;
    parameters.sprung_cg_height_m += static_cast<float>(raised_m);
    if (setting.damping_nmsprad > 0.0) {
        parameters.roll_damping_nmsprad = static_cast<float>(setting.damping_nmsprad);
    }
    return parameters;
}

class Judge {
 public:
    void see(const sil::Truth& truth, const rsi::Outputs& outputs) {
        one_lifted_ = one_lifted_ || has_lifted(truth, sil::front_left) ||
                      has_lifted(truth, sil::rear_left) || has_lifted(truth, sil::front_right) ||
                      has_lifted(truth, sil::rear_right);
        note(two_wheels_have_lifted(truth), truth.time_s, result_.two_wheels_s);
        note(outputs.roll_sensor_disagrees != 0, truth.time_s, result_.flagged_s);
        note(outputs.state == RSI_STATE_WARNING, truth.time_s, result_.warned_s);
        result_.unavailable += (truth.time_s > 1.0 && outputs.state == RSI_STATE_UNAVAILABLE) ? 1 : 0;
        if (!one_lifted_) {
            result_.disagreements += outputs.roll_sensor_disagrees;
            compare(truth, outputs);
        }
        result_.last = outputs;
    }

    Result result() const {
        Result result = result_;
        result.roll_rms_deg = degrees_per_radian * std::sqrt(roll_square_ / result.samples);
        result.bank_rms_deg = degrees_per_radian * std::sqrt(bank_square_ / result.samples);
        return result;
    }

 private:
    static void note(bool happens, double time_s, std::optional<double>& first) {
        if (happens && !first.has_value()) {
            first = time_s;
        }
    }

    void compare(const sil::Truth& truth, const rsi::Outputs& outputs) {
        const double roll_error = static_cast<double>(outputs.observed_roll_angle_rad) - truth.roll_angle_rad;
        const double bank_error = static_cast<double>(outputs.observed_bank_angle_rad) - truth.bank_angle_rad;
        if (std::isfinite(roll_error) && std::isfinite(bank_error)) {
            roll_square_ += roll_error * roll_error;
            bank_square_ += bank_error * bank_error;
            ++result_.samples;
        }
    }

    Result result_{};
    bool one_lifted_{false};
    double roll_square_{0.0};
    double bank_square_{0.0};
};

Result drive(const Setting& setting, const sil::Manoeuvre& manoeuvre, const RollSensor& roll_sensor) {
    const sil::VehicleParameters nominal =
        sil::load_vehicle(source("/sil/vehicles/" + setting.vehicle + ".toml"));
    const sil::VehicleParameters vehicle =
        manoeuvre.adapt_vehicle ? manoeuvre.adapt_vehicle(nominal) : nominal;
    sil::ManoeuvreRun run{nominal, manoeuvre, {}};
    sil::SensorSuite sensors{sil::mounted_sensors(vehicle, {true, setting.seed, bias_g})};
    rsi::Component component;
    EXPECT_EQ(
        component.init(calibration(setting, vehicle.geometry.cg_height_m - nominal.geometry.cg_height_m))
            .accepted,
        1);
    Judge judge;
    rsi::Outputs outputs{};
    sensors.observe(run.truth());
    for (int step = 1; !run.finished(); ++step) {
        run.step();
        sensors.observe(run.truth());
        if (step % 10 == 0) {
            component.step(inputs_of(sensors.report(run.truth()), roll_sensor), outputs);
            judge.see(run.truth(), outputs);
        }
    }
    return judge.result();
}

// Degrees. A rough road tilts under the wheels by one to two degrees, which the observer, who knows no mean
// plane, takes for roll. The raised vehicle of j-turn-banked has a suspension that its calibration does not
// describe. On the crown of a road the true roll refers to the plane below the CG, while wheels of one side
// stand on the other plane still.
double roll_limit_deg(const std::string& manoeuvre) {
    if (manoeuvre == "rough-road") {
        return 0.35;
    }
    return manoeuvre == "j-turn-banked" || manoeuvre == "crowned-road" ? 0.45 : 0.3;
}

class Observer : public testing::TestWithParam<std::string> {};

TEST_P(Observer, KnowsRollAndBankInEveryManoeuvreBeforeLiftOff) {
    const double measured_damping_nmsprad = (GetParam() == "large_suv") ? 6000.0 : 1900.0;
    std::printf("%-24s roll, bank: deg rms | K - 10 %%  | K + 10 %%  | c measured\n", GetParam().c_str());
    for (const sil::Manoeuvre& manoeuvre : sil::undisturbed_manoeuvres()) {
        const Result nominal = drive({GetParam()}, manoeuvre, intact);
        const Result soft = drive({GetParam(), 0.9}, manoeuvre, intact);
        const Result stiff = drive({GetParam(), 1.1}, manoeuvre, intact);
        const Result damped = drive({GetParam(), 1.0, measured_damping_nmsprad}, manoeuvre, intact);
        std::printf("%-24s %9.2f %9.2f | %.2f %.2f | %.2f %.2f | %.2f %.2f\n", manoeuvre.name.c_str(),
                    nominal.roll_rms_deg, nominal.bank_rms_deg, soft.roll_rms_deg, soft.bank_rms_deg,
                    stiff.roll_rms_deg, stiff.bank_rms_deg, damped.roll_rms_deg, damped.bank_rms_deg);

        SCOPED_TRACE(manoeuvre.name);
        EXPECT_GT(nominal.samples, 80);
        EXPECT_LE(nominal.roll_rms_deg, roll_limit_deg(manoeuvre.name) + 0.03);
        EXPECT_LE(nominal.bank_rms_deg, 1.0);
        EXPECT_LE(damped.roll_rms_deg, roll_limit_deg(manoeuvre.name) + 0.03);
        EXPECT_LE(damped.bank_rms_deg, 1.0);
        for (const Result& result : {soft, stiff}) {
            EXPECT_LE(result.roll_rms_deg, roll_limit_deg(manoeuvre.name) + 0.5);
            EXPECT_LE(result.bank_rms_deg, 1.5);
        }
        // A good sensor is never doubted.
        for (const Result& result : {nominal, soft, stiff, damped}) {
            EXPECT_EQ(result.disagreements, 0);
        }
    }
}

TEST_P(Observer, DoubtsASensorThatIsStuckOrShifted) {
    const sil::Manoeuvre j_turn = sil::find_manoeuvre("j-turn-45");
    const Result stuck = drive({GetParam()}, j_turn, [](float) { return 0.0F; });
    ASSERT_TRUE(stuck.flagged_s.has_value());
    EXPECT_LT(*stuck.flagged_s, 2.5);
    const Result shifted = drive({GetParam()}, j_turn, [](float roll) { return roll + 0.0873F; });
    ASSERT_TRUE(shifted.flagged_s.has_value());
    EXPECT_LT(*shifted.flagged_s, 1.0);
    EXPECT_EQ(shifted.last.roll_source, RSI_ROLL_SENSOR);
}

INSTANTIATE_TEST_SUITE_P(OfBothVehicles, Observer, testing::Values("large_suv", "ordinary_suv"),
                         [](const auto& tested) { return tested.param; });

TEST(WithoutRollSensor, TheWarningComesWhenItComesWithIt) {
    for (const char* name : {"j-turn-110", "fishhook-1a", "j-turn-banked"}) {
        SCOPED_TRACE(name);
        const sil::Manoeuvre manoeuvre = sil::find_manoeuvre(name);
        const Result with_sensor = drive({"large_suv"}, manoeuvre, intact);
        const Result without = drive({"large_suv"}, manoeuvre, absent);
        ASSERT_TRUE(with_sensor.warned_s.has_value());
        ASSERT_TRUE(without.warned_s.has_value());
        ASSERT_TRUE(without.two_wheels_s.has_value());
        EXPECT_LT(*without.warned_s, *without.two_wheels_s);
        EXPECT_NEAR(*without.warned_s, *with_sensor.warned_s, 0.1);
        // Also while it rolls over and lies on its side.
        EXPECT_EQ(without.unavailable, 0);
        EXPECT_EQ(without.last.state, RSI_STATE_WARNING);
        EXPECT_EQ(without.last.roll_source, RSI_ROLL_OBSERVER);
    }
}

}  // namespace
}  // namespace observer_accuracy_test
}  // namespace rsi_test
