// A component with a learnt load: all that reckons with the sprung body computes what it would, had it been
// calibrated for the loaded one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "rsi/adaptation/load_split.hpp"
#include "rsi/component.hpp"
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

float difference(float rsi_outputs::* output) {
    rsi::Component learnt;
    rsi::Component calibrated;
    EXPECT_EQ(learnt.init(calibrated_empty(1.0F)).accepted, 1);
    EXPECT_EQ(calibrated.init(calibrated_loaded()).accepted, 1);
    EXPECT_TRUE(learnt.restore_load({moment_factor - 1.0F, 0.03F, 0.0F}, false));
    rsi_test::RandomManoeuvre drive(calibrated_loaded(), 73U, false);
    Difference result{output};
    for (int k = 0; k < 300; ++k) {
        const rsi_inputs inputs = drive.next();
        rsi_outputs of_learnt{};
        rsi_outputs of_calibrated{};
        learnt.step(inputs, of_learnt);
        calibrated.step(inputs, of_calibrated);
        result.take(of_learnt, of_calibrated);
    }
    return result.share();
}

// Whoever of them went on with the empty body would be off by 9 to 37 %.
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
    rsi::Component learnt;
    rsi::Component calibrated;
    ASSERT_EQ(learnt.init(calibrated_empty(1.0F)).accepted, 1);
    ASSERT_EQ(calibrated.init(calibrated_loaded()).accepted, 1);
    ASSERT_TRUE(learnt.restore_load({moment_factor - 1.0F, 0.03F, 0.0F}, false));
    rsi_inputs inputs = rsi_test::RandomManoeuvre(calibrated_loaded(), 73U, false).next();
    inputs.lateral_specific_force_mps2 = 3.0F;
    inputs.roll_angle_rad = 0.05F;
    rsi_outputs of_learnt{};
    rsi_outputs of_calibrated{};
    learnt.step(inputs, of_learnt);
    calibrated.step(inputs, of_calibrated);
    EXPECT_FLOAT_EQ(of_learnt.load_transfer_ratio, of_calibrated.load_transfer_ratio);
}

}  // namespace
}  // namespace loaded_component_test
