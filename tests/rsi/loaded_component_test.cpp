// A component with a learnt load: all that uses the sprung body computes what it would, had it been
// calibrated for the loaded one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "rsi/adaptation/load_split.hpp"
#include "rsi/component.hpp"
#include "tests/rsi/support/loaded_drive.hpp"
#include "tests/rsi/support/nominal.hpp"
#include "tests/rsi/support/random_manoeuvre.hpp"

namespace loaded_component_test {
namespace {

constexpr float moment_factor = 1.3F;

rsi_parameters calibrated_empty(float load_adaptation) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.load_adaptation = load_adaptation;
    return parameters;
}

rsi_parameters calibrated_loaded() {
    rsi_parameters parameters = calibrated_empty(0.0F);
    const rsi::SprungBody body = rsi::with_load(rsi::calibrated_body(parameters), moment_factor,
                                                rsi::assumed_mass_factor(moment_factor));
    parameters.sprung_mass_kg = body.mass_kg;
    parameters.sprung_cg_height_m = body.cg_height_m;
    parameters.roll_inertia_kgm2 = body.roll_inertia_kgm2;
    return parameters;
}

// The largest difference of an output between two components over the first seconds, which are too few to
// learn from, as a share of the largest value.
class Difference {
 public:
    explicit Difference(float rsi_outputs::* output) : output_{output} {}

    void take(const rsi_outputs& of_one, const rsi_outputs& of_other) {
        largest_ = std::max(largest_, std::abs(of_one.*output_));
        difference_ = std::max(difference_, std::abs(of_one.*output_ - of_other.*output_));
    }
    float share() const { return difference_ / largest_; }

 private:
    float rsi_outputs::* output_;
    float largest_{0.0F};
    float difference_{0.0F};
};

// One that has learnt the load and one that is calibrated for it, and what they make of the same inputs.
class Twins {
 public:
    Twins() {
        EXPECT_EQ(learnt_.init(calibrated_empty(1.0F)).accepted, 1);
        EXPECT_EQ(calibrated_.init(calibrated_loaded()).accepted, 1);
        EXPECT_TRUE(learnt_.restore_load({moment_factor - 1.0F, 0.03F, 0.0F}, false));
    }

    void step(const rsi_inputs& inputs) {
        learnt_.step(inputs, of_learnt);
        calibrated_.step(inputs, of_calibrated);
    }

    rsi_outputs of_learnt{};
    rsi_outputs of_calibrated{};

 private:
    rsi::Component learnt_{};
    rsi::Component calibrated_{};
};

float difference(float rsi_outputs::* output) {
    Twins twins;
    rsi_test::RandomManoeuvre drive(calibrated_loaded(), 73U, false);
    Difference result{output};
    for (int k = 0; k < 300; ++k) {
        twins.step(drive.next());
        result.take(twins.of_learnt, twins.of_calibrated);
    }
    return result.share();
}

// Any of them with the empty body would be off by 9 to 37 %.
TEST(ALoadedComponent, ComputesWhatOneThatIsCalibratedForTheLoadDoes) {
    EXPECT_LT(difference(&rsi_outputs::fixed_model_roll_angle_rad), 0.001F);
    EXPECT_LT(difference(&rsi_outputs::roll_centre_vertical_m), 0.001F);
    EXPECT_LT(difference(&rsi_outputs::lateral_acceleration_threshold_mps2), 0.001F);
    EXPECT_LT(difference(&rsi_outputs::load_transfer_ratio), 0.001F);
    EXPECT_LT(difference(&rsi_outputs::rsi_extended), 0.001F);
    EXPECT_LT(difference(&rsi_outputs::predicted_load_transfer_ratio), 0.008F);
}

// From the first step on, before anything else is learnt.
TEST(ALoadedComponent, BeginsWithTheRestoredLoad) {
    Twins twins;
    rsi_inputs inputs = rsi_test::RandomManoeuvre(calibrated_loaded(), 73U, false).next();
    inputs.lateral_specific_force_mps2 = 3.0F;
    inputs.roll_angle_rad = 0.05F;
    twins.step(inputs);
    EXPECT_FLOAT_EQ(twins.of_learnt.load_transfer_ratio, twins.of_calibrated.load_transfer_ratio);
}

// By the filter that tells the one from the other, in half a minute of ordinary driving.
TEST(ALoadedComponent, TakesALoadThatItKnowsForNoMovementOfTheRollCentre) {
    const auto largest_movement_m = [](float load_adaptation) {
        rsi_parameters parameters = calibrated_empty(load_adaptation);
        parameters.estimator = RSI_ESTIMATOR_CONSIDER_KALMAN;
        rsi::Component component;
        EXPECT_EQ(component.init(parameters).accepted, 1);
        EXPECT_TRUE(component.restore_load({moment_factor - 1.0F, 0.03F, 0.0F}, false));
        rsi_test::LoadedVehicle vehicle;
        vehicle.excess = 0.3;
        rsi_test::LoadedDrive course(rsi_test::large_suv(), vehicle);
        float largest = 0.0F;
        for (int k = 0; k < 3000; ++k) {
            course.advance();
            rsi_outputs outputs{};
            component.step(course.inputs(20.0), outputs);
            largest = std::max(largest, std::abs(outputs.roll_centre_vertical_m));
        }
        return largest;
    };
    EXPECT_GT(largest_movement_m(0.0F), 0.08F);
    EXPECT_LT(largest_movement_m(1.0F), 0.04F);
}

// A body of twice the mass rolls twice as far: only the mass on the bus excuses a sensor that shows it, not
// what the sensor itself has taught.
TEST(ALoadedComponent, AcceptsItsRollSensorWhereTheMassIsKnown) {
    const rsi_parameters parameters = calibrated_empty(1.0F);
    const auto disagrees = [&parameters](float mass_kg) {
        rsi::Component component;
        EXPECT_EQ(component.init(parameters).accepted, 1);
        rsi_inputs inputs = rsi_test::at_rest();
        inputs.speed_mps = 20.0F;
        inputs.lateral_specific_force_mps2 = 6.0F;
        inputs.yaw_rate_radps = 0.3F;
        inputs.vehicle_mass_kg = mass_kg;
        rsi_outputs outputs{};
        for (int k = 0; k < 400; ++k) {
            component.step(inputs, outputs);
            const float observed_rad = outputs.observed_roll_angle_rad;  // not known at first
            inputs.roll_angle_rad = std::isfinite(observed_rad) ? 2.0F * observed_rad : 0.0F;
        }
        return outputs.roll_sensor_disagrees != 0;
    };
    EXPECT_TRUE(disagrees(std::numeric_limits<float>::quiet_NaN()));
    EXPECT_TRUE(disagrees(parameters.sprung_mass_kg + parameters.unsprung_mass_kg));
    EXPECT_FALSE(disagrees(2.0F * parameters.sprung_mass_kg + parameters.unsprung_mass_kg));
}

// As long as nothing is learnt, by its largest share: a tenth.
TEST(ALoadedComponent, WarnsTheSoonerTheLessIsKnownOfTheLoad) {
    rsi_parameters parameters = calibrated_empty(1.0F);
    const auto outputs_with_margin = [&parameters](float margin) {
        parameters.load_margin = margin;
        rsi::Component component;
        EXPECT_EQ(component.init(parameters).accepted, 1);
        rsi_inputs inputs = rsi_test::at_rest();
        inputs.lateral_specific_force_mps2 = 7.75F;
        inputs.roll_angle_rad = 0.1F;
        rsi_outputs outputs{};
        for (int k = 0; k < 50; ++k) {
            component.step(inputs, outputs);
        }
        return outputs;
    };
    const rsi_outputs without = outputs_with_margin(0.0F);
    EXPECT_NEAR(without.warning_level, 0.95F, 0.03F);
    EXPECT_EQ(without.state, RSI_STATE_ADVISORY);
    EXPECT_EQ(outputs_with_margin(1.0F).state, RSI_STATE_WARNING);
}

}  // namespace
}  // namespace loaded_component_test
