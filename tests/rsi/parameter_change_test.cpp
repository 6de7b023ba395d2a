// Other parameters for a component that is running: nothing is lost that they do not ask for.
#include "rsi/parameter_change.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "rsi/component.hpp"
#include "rsi/output_table.hpp"
#include "rsi/parameters.hpp"
#include "tests/rsi/support/nominal.hpp"
#include "tests/rsi/support/random_manoeuvre.hpp"

namespace parameter_change_test {
namespace {

constexpr int cycles_for_a_vehicle = 200;

bool same_bits(const rsi_outputs& one, const rsi_outputs& other) {
    return std::memcmp(&one, &other, sizeof one) == 0;
}

// How many cycles it took.
int prepared_in(rsi::ParameterChange& change) {
    int cycles = 1;
    while (!change.prepare()) {
        ++cycles;
    }
    return cycles;
}

rsi::ParameterChange ready_change(const rsi_parameters& from, const rsi_parameters& to) {
    rsi::ParameterChange change;
    const rsi_validation answer = change.begin(from, to);
    EXPECT_EQ(answer.accepted, 1) << answer.field << ' ' << answer.reason;
    prepared_in(change);
    return change;
}

// Two components on the same random drive.
class Pair {
 public:
    explicit Pair(const rsi_parameters& parameters) : drive_{parameters, 5U, false} {
        EXPECT_EQ(changed.init(parameters).accepted, 1);
        EXPECT_EQ(other.init(parameters).accepted, 1);
    }
    void step() {
        const rsi_inputs inputs = drive_.next();
        changed.step(inputs, changed_outputs);
        other.step(inputs, other_outputs);
    }
    void run(int samples) {
        for (int k = 0; k < samples; ++k) {
            step();
        }
    }
    rsi::Component changed{};
    rsi::Component other{};
    rsi_outputs changed_outputs{};
    rsi_outputs other_outputs{};

 private:
    rsi_test::RandomManoeuvre drive_;
};

// Every field a little off, where that is admitted.
std::vector<rsi_parameters> neighbours(const rsi_parameters& parameters) {
    std::vector<rsi_parameters> all;
    for (const rsi::ParameterField& field : rsi::parameter_fields) {
        for (const float factor : {1.02F, 0.98F}) {
            rsi_parameters moved = parameters;
            const float value = moved.*field.member;
            moved.*field.member = (std::abs(value) > 0.0F)
                                      ? factor * value
                                      : field.minimum + 0.1F * (field.maximum - field.minimum);
            if (rsi::validate(moved).accepted == 1) {
                all.push_back(moved);
                break;
            }
        }
    }
    for (const rsi::SelectionField& field : rsi::selection_fields) {
        rsi_parameters moved = parameters;
        moved.*field.member = (moved.*field.member + 1) % field.choice_count;
        if (rsi::validate(moved).accepted == 1) {
            all.push_back(moved);
        }
    }
    return all;
}

TEST(ParameterChange, ToTheSameParametersChangesNoBit) {
    for (const std::int32_t reference : {RSI_ROLL_AGAINST_ROAD, RSI_ROLL_AGAINST_HORIZON}) {
        rsi_parameters adaptive = rsi_test::large_suv();
        adaptive.load_adaptation = 1.0F;
        adaptive.roll_angle_reference = reference;
        Pair pair{adaptive};
        for (int k = 0; k < 4000; ++k) {
            pair.step();
            ASSERT_TRUE(same_bits(pair.changed_outputs, pair.other_outputs)) << "sample " << k;
            if (k % 97 == 0) {
                pair.changed.change(ready_change(adaptive, adaptive));
            }
        }
        EXPECT_NE(pair.changed.learnt_load().excess, 0.0F);
    }
}

TEST(ParameterChange, OfTheWarningsThresholdMovesTheWarningAlone) {
    rsi_parameters earlier = rsi_test::large_suv();
    earlier.warning_on = 0.9F * earlier.warning_on;
    earlier.warning_off = 0.9F * earlier.warning_off;
    earlier.advisory_on = 0.9F * earlier.advisory_on;
    earlier.advisory_off = 0.9F * earlier.advisory_off;
    Pair pair{rsi_test::large_suv()};
    pair.run(300);
    pair.changed.change(ready_change(rsi_test::large_suv(), earlier));
    int first_difference = 0;
    for (int k = 0; k < 3000; ++k) {
        pair.step();
        if (first_difference == 0) {
            first_difference = pair.changed_outputs.state - pair.other_outputs.state;
        }
        pair.other_outputs.state = pair.changed_outputs.state;
        pair.other_outputs.side = pair.changed_outputs.side;
        ASSERT_TRUE(same_bits(pair.changed_outputs, pair.other_outputs)) << "sample " << k;
    }
    EXPECT_GT(first_difference, 0);
}

// A component changed before its first sample equals one started with the new parameters: no constant
// was forgotten.
TEST(ParameterChange, TakesOverEveryField) {
    const std::vector<rsi_parameters> all = neighbours(rsi_test::large_suv());
    ASSERT_GE(all.size(), rsi::parameter_fields.size());
    for (const rsi_parameters& parameters : all) {
        Pair pair{rsi_test::large_suv()};
        pair.changed.change(ready_change(rsi_test::large_suv(), parameters));
        ASSERT_EQ(pair.other.init(parameters).accepted, 1);
        for (int k = 0; k < 300; ++k) {
            pair.step();
            ASSERT_TRUE(same_bits(pair.changed_outputs, pair.other_outputs)) << "sample " << k;
        }
    }
}

// No field that is moved by two hundredths takes the statement away or throws a number about.
TEST(ParameterChange, NeverTakesTheStatementAway) {
    for (const rsi_parameters& parameters : neighbours(rsi_test::large_suv())) {
        Pair pair{rsi_test::large_suv()};
        pair.run(400);
        ASSERT_NE(pair.changed_outputs.state, RSI_STATE_UNAVAILABLE);
        pair.changed.change(ready_change(rsi_test::large_suv(), parameters));
        for (int k = 0; k < 100; ++k) {
            pair.step();
            ASSERT_NE(pair.changed_outputs.state, RSI_STATE_UNAVAILABLE);
            ASSERT_TRUE(rsi::are_codes_known_and_numbers_finite(pair.changed_outputs));
        }
    }
}

TEST(ParameterChange, KeepsTheLearntLoadUnlessTheVehicleIsAnother) {
    rsi_parameters wide_awake = rsi_test::large_suv();
    wide_awake.prediction_horizon_s = 0.9F * wide_awake.prediction_horizon_s;
    rsi_parameters heavier = rsi_test::large_suv();
    heavier.sprung_mass_kg = 1.01F * heavier.sprung_mass_kg;
    Pair pair{rsi_test::large_suv()};
    pair.run(6000);
    const rsi_learnt_load learnt = pair.changed.learnt_load();
    ASSERT_LT(learnt.excess_deviation, 0.2F);
    pair.changed.change(ready_change(rsi_test::large_suv(), wide_awake));
    EXPECT_EQ(pair.changed.learnt_load().excess, learnt.excess);
    EXPECT_EQ(pair.changed.learnt_load().excess_deviation, learnt.excess_deviation);
    pair.changed.change(ready_change(wide_awake, heavier));
    EXPECT_EQ(pair.changed.learnt_load().excess, 0.0F);
}

// To another vehicle and back: what is other afterwards is what was forgotten of the first.
class ToAnotherVehicleAndBack {
 public:
    explicit ToAnotherVehicleAndBack(int samples) {
        rsi_parameters heavier = first_;
        heavier.sprung_mass_kg = 1.01F * heavier.sprung_mass_kg;
        pair.run(samples);
        pair.changed.change(ready_change(first_, heavier));
        pair.changed.change(ready_change(heavier, first_));
        pair.step();
    }

 private:
    // Parts whose body does not follow the learnt load.
    static rsi_parameters calibrated_body() {
        rsi_parameters parameters = rsi_test::large_suv();
        parameters.estimator = RSI_ESTIMATOR_CONSIDER_KALMAN;
        parameters.load_adaptation = 0.0F;
        return parameters;
    }
    rsi_parameters first_{calibrated_body()};

 public:
    Pair pair{first_};
};

TEST(ParameterChange, OfTheVehicleForgetsTheRollCentreOfTheFirst) {
    ToAnotherVehicleAndBack drive{6000};
    ASSERT_GT(std::abs(drive.pair.other_outputs.roll_centre_vertical_m), 0.05F);
    EXPECT_EQ(drive.pair.changed_outputs.roll_centre_vertical_m, 0.0F);
    EXPECT_GT(drive.pair.changed_outputs.roll_centre_deviation_m,
              drive.pair.other_outputs.roll_centre_deviation_m);
}

// By how much the first rolled otherwise than calibrated, from which the prediction starts.
TEST(ParameterChange, OfTheVehicleForgetsHowTheFirstRolled) {
    ToAnotherVehicleAndBack drive{2000};
    EXPECT_EQ(drive.pair.changed_outputs.load_transfer_ratio, drive.pair.other_outputs.load_transfer_ratio);
    EXPECT_NE(drive.pair.changed_outputs.predicted_load_transfer_ratio,
              drive.pair.other_outputs.predicted_load_transfer_ratio);
}

TEST(ParameterChange, OfAnotherVehicleTakesCyclesToPrepareAndOthersNone) {
    rsi_parameters stiffer = rsi_test::large_suv();
    stiffer.roll_stiffness_nmprad = 1.1F * stiffer.roll_stiffness_nmprad;
    rsi_parameters drifting = rsi_test::large_suv();
    drifting.observer_bank_drift_radps = 1.1F * drifting.observer_bank_drift_radps;
    rsi_parameters cautious = rsi_test::large_suv();
    cautious.warning_hold_s = 2.0F;
    rsi_parameters coarse = rsi_test::large_suv();
    coarse.speed_resolution_mps = 0.5F;
    rsi::ParameterChange change;
    ASSERT_EQ(change.begin(rsi_test::large_suv(), stiffer).accepted, 1);
    EXPECT_TRUE(change.is_another_vehicle());
    EXPECT_FALSE(change.has_other_sensors());
    EXPECT_EQ(prepared_in(change), cycles_for_a_vehicle);
    ASSERT_EQ(change.begin(rsi_test::large_suv(), drifting).accepted, 1);
    EXPECT_FALSE(change.is_another_vehicle());
    EXPECT_TRUE(change.has_gains());
    EXPECT_EQ(prepared_in(change), cycles_for_a_vehicle);
    ASSERT_EQ(change.begin(rsi_test::large_suv(), cautious).accepted, 1);
    EXPECT_FALSE(change.has_gains());
    EXPECT_FALSE(change.has_other_sensors());
    EXPECT_EQ(prepared_in(change), 1);
    ASSERT_EQ(change.begin(rsi_test::large_suv(), coarse).accepted, 1);
    EXPECT_TRUE(change.has_other_sensors());
}

// More or less of a value, and each selection of a sensor.
TEST(ParameterChange, TellsWhatIsOther) {
    struct Case {
        bool vehicle;
        bool sensors;
        bool units;
        bool gains;
        void (*move)(rsi_parameters&);
    };
    const Case cases[]{
        {false, false, false, false, [](rsi_parameters&) {}},
        {true, false, false, true, [](rsi_parameters& p) { p.sprung_mass_kg = 2050.0F; }},
        {true, false, false, true, [](rsi_parameters& p) { p.roll_stiffness_quintic_nmprad5 = 6.0e7F; }},
        {false, false, false, false, [](rsi_parameters& p) { p.wheelbase_m = 3.0F; }},
        {false, false, true, false, [](rsi_parameters& p) { p.regression_scale_nm = 440.0F; }},
        {false, false, true, false, [](rsi_parameters& p) { p.initial_damping_deviation_nmsprad = 2.0e3F; }},
        {false, false, false, false, [](rsi_parameters& p) { p.covariance_limit = 200.0F; }},
        {false, false, false, true, [](rsi_parameters& p) { p.observer_bank_drift_radps *= 0.9F; }},
        {false, true, false, false, [](rsi_parameters& p) { p.accelerometer_noise_mps2 = 0.5F; }},
        {false, true, false, false, [](rsi_parameters& p) { p.speed_resolution_mps = 0.5F; }},
        {false, true, false, false,
         [](rsi_parameters& p) { p.roll_angle_reference = RSI_ROLL_AGAINST_HORIZON; }},
        {false, true, false, false,
         [](rsi_parameters& p) { p.roll_angle_sensor = RSI_ROLL_SENSOR_NOT_FITTED; }},
        {false, true, false, false,
         [](rsi_parameters& p) { p.vehicle_motion_sensors = RSI_MOTION_NOT_FITTED; }},
        {false, false, false, false, [](rsi_parameters& p) { p.estimator = RSI_ESTIMATOR_PUBLISHED; }},
    };
    for (const Case& each : cases) {
        rsi_parameters moved = rsi_test::large_suv();
        each.move(moved);
        rsi::ParameterChange change;
        ASSERT_EQ(change.begin(rsi_test::large_suv(), moved).accepted, 1);
        const auto place = &each - cases;
        EXPECT_EQ(change.is_another_vehicle(), each.vehicle) << place;
        EXPECT_EQ(change.has_other_sensors(), each.sensors) << place;
        EXPECT_EQ(change.has_other_units(), each.units) << place;
        EXPECT_EQ(change.has_gains(), each.gains) << place;
    }
}

TEST(ParameterChange, OfTheUnitsForgetsThePublishedEstimateAlone) {
    rsi_parameters published = rsi_test::large_suv();
    published.estimator = RSI_ESTIMATOR_PUBLISHED;
    rsi_parameters scaled = published;
    scaled.regression_scale_nm = 2.0F * scaled.regression_scale_nm;
    Pair pair{published};
    pair.run(2000);
    ASSERT_NE(pair.changed_outputs.roll_centre_vertical_m, 0.0F);
    const rsi_learnt_load learnt = pair.changed.learnt_load();
    // To other units and back: what is other afterwards is what was forgotten.
    pair.changed.change(ready_change(published, scaled));
    pair.changed.change(ready_change(scaled, published));
    EXPECT_EQ(pair.changed.learnt_load().excess, learnt.excess);
    pair.step();
    EXPECT_LT(std::abs(pair.changed_outputs.roll_centre_vertical_m),
              0.1F * std::abs(pair.other_outputs.roll_centre_vertical_m));
}

// A bank of long ago would be taken off the sensor's angle.
TEST(ParameterChange, OfTheRollAnglesReferenceForgetsTheBank) {
    rsi_parameters horizon = rsi_test::large_suv();
    horizon.roll_angle_reference = RSI_ROLL_AGAINST_HORIZON;
    rsi_parameters road = horizon;
    road.roll_angle_reference = RSI_ROLL_AGAINST_ROAD;
    rsi::Component component;
    ASSERT_EQ(component.init(horizon).accepted, 1);
    rsi_inputs inputs = rsi_test::at_rest();
    inputs.speed_mps = 20.0F;
    inputs.bank_angle_rad = std::numeric_limits<float>::quiet_NaN();
    rsi_outputs outputs{};
    const auto drive = [&](int samples, float roll_angle_rad) {
        inputs.roll_angle_rad = roll_angle_rad;
        for (int k = 0; k < samples; ++k) {
            component.step(inputs, outputs);
        }
        return outputs.road_parallel_force_mps2;
    };
    EXPECT_NEAR(drive(500, 0.1F), 0.0F, 0.01F);  // all of it is bank
    component.change(ready_change(horizon, road));
    EXPECT_NEAR(drive(10, 0.0F), 0.0F, 0.01F);
    component.change(ready_change(road, horizon));
    EXPECT_NEAR(drive(1, 0.0F), 0.0F, 0.01F);
}

TEST(ParameterChange, ThatIsRefusedNamesTheFieldAndLeavesWhatWasPrepared) {
    rsi_parameters cautious = rsi_test::large_suv();
    cautious.warning_hold_s = 2.0F;
    rsi_parameters late = rsi_test::large_suv();
    late.warning_on = 1.3F;
    rsi::ParameterChange change;
    ASSERT_EQ(change.begin(rsi_test::large_suv(), cautious).accepted, 1);
    const rsi_validation answer = change.begin(rsi_test::large_suv(), late);
    EXPECT_EQ(answer.accepted, 0);
    EXPECT_STREQ(answer.field, "warning_on");
    EXPECT_EQ(change.parameters().warning_hold_s, 2.0F);
}

TEST(ParameterChange, ThatIsRefusedAsTheFirstAsksForNothing) {
    rsi_parameters late = rsi_test::large_suv();
    late.sprung_mass_kg = 1.01F * late.sprung_mass_kg;
    late.speed_resolution_mps = 0.5F;
    late.warning_on = 1.3F;
    rsi::ParameterChange change;
    ASSERT_EQ(change.begin(rsi_test::large_suv(), late).accepted, 0);
    EXPECT_FALSE(change.is_another_vehicle());
    EXPECT_FALSE(change.has_other_sensors());
    EXPECT_FALSE(change.has_other_units());
    EXPECT_FALSE(change.has_gains());
}

// Refused by init.
rsi_parameters out_of_range(rsi_parameters parameters) {
    parameters.warning_on = 1.3F;
    return parameters;
}

TEST(ParameterChange, BegunFromNothingStartsAComponentThatRefusedItsParametersAsInitDoes) {
    const rsi_parameters good = rsi_test::large_suv();
    Pair pair{good};
    ASSERT_EQ(pair.changed.init(out_of_range(good)).accepted, 0);
    pair.changed.change(ready_change(rsi_parameters{}, good));
    for (int k = 0; k < 1000; ++k) {
        pair.step();
        ASSERT_TRUE(same_bits(pair.changed_outputs, pair.other_outputs)) << "sample " << k;
    }
}

// It takes the gains as far as they have been prepared: no iteration runs within a cycle.
TEST(ParameterChange, StartsWithWhatWasPrepared) {
    const rsi_parameters good = rsi_test::large_suv();
    Pair pair{good};
    ASSERT_EQ(pair.changed.init(out_of_range(good)).accepted, 0);
    rsi::ParameterChange change;
    ASSERT_EQ(change.begin(rsi_parameters{}, good).accepted, 1);
    ASSERT_FALSE(change.prepare());
    pair.changed.change(change);
    pair.run(1000);
    EXPECT_NE(pair.changed_outputs.state, RSI_STATE_UNAVAILABLE);
    EXPECT_NE(pair.changed_outputs.observed_roll_angle_rad, pair.other_outputs.observed_roll_angle_rad);
}

TEST(ParameterChange, WithoutGainsDoesNothingToAComponentThatRefusedItsParameters) {
    rsi_parameters bad = rsi_test::large_suv();
    bad.warning_on = 1.3F;
    rsi::Component component;
    ASSERT_EQ(component.init(bad).accepted, 0);
    const rsi_learnt_load before = component.learnt_load();
    rsi_parameters earlier = rsi_test::large_suv();
    earlier.warning_on = 0.95F;
    component.change(ready_change(rsi_test::large_suv(), earlier));
    EXPECT_EQ(component.learnt_load().excess_deviation, before.excess_deviation);
    rsi_outputs outputs{};
    component.step(rsi_test::at_rest(), outputs);
    EXPECT_EQ(outputs.state, RSI_STATE_UNAVAILABLE);
}

}  // namespace
}  // namespace parameter_change_test
