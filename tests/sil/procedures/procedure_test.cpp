// Procedures: criteria on both sides of their limits, outcomes, texts, files, and series to both sides.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "sil/studies/procedures/procedure_files.hpp"
#include "sil/studies/procedures/procedure_text.hpp"
#include "tests/sil/procedures/shipped_world.hpp"

namespace {

using testing::HasSubstr;
using testing_procedures::criterion;
using testing_procedures::shipped;
using testing_procedures::symmetric;

TEST(Criterion, IsMetAtItsLimitUnlessTheValueMustStayBelow) {
    EXPECT_TRUE(criterion(sil::Bound::at_most, 35.0, 35.0).met());
    EXPECT_FALSE(criterion(sil::Bound::at_most, 35.0, 35.001).met());
    EXPECT_TRUE(criterion(sil::Bound::at_least, 1.83, 1.83).met());
    EXPECT_FALSE(criterion(sil::Bound::at_least, 1.83, 1.829).met());
    EXPECT_TRUE(criterion(sil::Bound::below, 50.8, 50.799).met());
    EXPECT_FALSE(criterion(sil::Bound::below, 50.8, 50.8).met());
}

TEST(Criterion, WithoutAValueIsNotMet) {
    for (const sil::Bound bound : {sil::Bound::at_most, sil::Bound::below, sil::Bound::at_least}) {
        EXPECT_FALSE(criterion(bound, 0.0, std::nullopt).met());
    }
}

TEST(ProcedureOutcome, NeedsEveryCriterionThatIsAsked) {
    sil::ProcedureStep good;
    good.criteria = {criterion(sil::Bound::at_most, 1.0, 1.0)};
    sil::ProcedureStep bad = good;
    bad.criteria.push_back(criterion(sil::Bound::at_most, 1.0, 2.0));
    EXPECT_EQ(sil::outcome_of({good, good}), sil::ProcedureOutcome::met);
    EXPECT_EQ(sil::outcome_of({good, bad}), sil::ProcedureOutcome::not_met);
    bad.criteria.back().asked = false;
    EXPECT_EQ(sil::outcome_of({good, bad}), sil::ProcedureOutcome::met);
}

TEST(WarningText, SaysLeadAndSideOrWhatWasSaidInstead) {
    sil::WarningBeside warning;
    EXPECT_EQ(sil::warning_text(warning), "nothing");
    warning.first_advisory_s = 2.0;
    EXPECT_EQ(sil::warning_text(warning), "advisory");
    warning.first_warning_s = 2.1;
    warning.first_warning_side = sil::WarningSide::left;
    EXPECT_EQ(sil::warning_text(warning), "warning left, no two wheels lift");
    warning.lifted = true;
    warning.falling_side = sil::WarningSide::right;
    warning.side_at_lift_off = sil::WarningSide::left;
    warning.state_at_lift_off = sil::WarningState::warning;
    EXPECT_EQ(sil::warning_text(warning), "NOT warned: warning left as the vehicle falls to the right");
    warning.lead_s = 0.42;
    EXPECT_EQ(sil::warning_text(warning), "warning right, 0.42 s before lift-off");
}

TEST(ProcedureFiles, HoldEveryStepWithItsCriteria) {
    sil::ProcedureStep step;
    step.series = "left";
    step.name = "35 mph";
    step.figures = {{"speed_kmh", "speed", "km/h", 1, 56.3},
                    {"peak_degps", "peak", "deg/s", 1, std::nullopt}};
    step.criteria = {criterion(sil::Bound::below, 50.8, 60.0), criterion(sil::Bound::at_most, 35.0, 1.0)};
    step.criteria[0].measured.key = "height_mm";
    step.criteria[1].measured.key = "share_pc";
    step.criteria[1].asked = false;
    step.warning.lifted = true;
    step.warning.lift_off_s = 2.5;
    step.warning.falling_side = sil::WarningSide::right;
    step.warning.state_at_lift_off = sil::WarningState::advisory;
    sil::ProcedureResult result;
    result.steps = {step};
    result.outcome = sil::outcome_of(result.steps);
    result.verdict = "the words";
    EXPECT_EQ(
        sil::steps_csv(result),
        "series,step,speed_kmh,peak_degps,height_mm,height_mm_limit,height_mm_met,share_pc,share_pc_limit,"
        "share_pc_met,two_wheel_lift_time_s,falling_side,ecu_state_at_lift_off,ecu_lead_time_s,"
        "ecu_advisory_time_s,ecu_warning_time_s,ecu_warning_side\n"
        "left,35 mph,56.300000,,60.000000,50.800000,0,1.000000,35.000000,,2.500,right,advisory,,,,\n");
    const auto json =
        nlohmann::json::parse(sil::result_json(sil::find_procedure("fishhook-1a"), "a car", result));
    EXPECT_EQ(json["procedure"], "fishhook-1a");
    EXPECT_EQ(json["outcome"], "not met");
    EXPECT_EQ(json["steps"][0]["criteria"][0]["met"], false);
    EXPECT_TRUE(json["steps"][0]["criteria"][1]["met"].is_null());
    EXPECT_TRUE(json["steps"][0]["figures"][1]["value"].is_null());
    EXPECT_EQ(json["steps"][0]["ecu"]["state_at_lift_off"], "advisory");
    EXPECT_TRUE(json["steps"][0]["ecu"]["lead_time_s"].is_null());
}

TEST(Catalogue, RefusesAnUnknownNameWithAllThatThereAre) {
    try {
        sil::find_procedure("moose");
        FAIL() << "no error";
    } catch (const sil::UnknownProcedure& error) {
        EXPECT_THAT(error.what(), HasSubstr("no procedure 'moose'"));
        for (const sil::Procedure& procedure : sil::all_procedures()) {
            EXPECT_THAT(error.what(), HasSubstr(procedure.name));
            EXPECT_FALSE(procedure.sources.empty()) << procedure.name;
        }
    }
}

TEST(Procedures, ThatNeedTheAngleOfThreeTenthsSayThatAVehicleDoesNotReachThem) {
    sil::ProcedureWorld world = shipped("van");
    world.vehicle.tyre.friction *= 0.1;
    for (const char* name : {"sine-with-dwell", "fishhook-1a", "fishhook-1b", "j-turn", "steady-circle"}) {
        try {
            sil::find_procedure(name).run(world);
            FAIL() << name << ": no error";
        } catch (const std::runtime_error& error) {
            EXPECT_THAT(error.what(), HasSubstr("does not reach 0.3 g")) << name;
        }
    }
}

sil::WarningSide other(sil::WarningSide side) {
    return side == sil::WarningSide::left
               ? sil::WarningSide::right
               : (side == sil::WarningSide::right ? sil::WarningSide::left : sil::WarningSide::none);
}

void expect_mirrored(const sil::ProcedureStep& left, const sil::ProcedureStep& right,
                     const std::string& name) {
    EXPECT_NE(left.series, right.series) << name;
    for (std::size_t i = 0U; i < left.figures.size(); ++i) {
        ASSERT_EQ(left.figures[i].value.has_value(), right.figures[i].value.has_value()) << name;
        if (left.figures[i].value) {
            EXPECT_NEAR(*left.figures[i].value, *right.figures[i].value, 0.01) << name << left.figures[i].key;
        }
    }
    for (std::size_t i = 0U; i < left.criteria.size(); ++i) {
        EXPECT_EQ(left.criteria[i].met(), right.criteria[i].met()) << name;
    }
    EXPECT_EQ(left.warning.lifted, right.warning.lifted) << name;
    EXPECT_EQ(left.warning.falling_side, other(right.warning.falling_side)) << name;
    EXPECT_EQ(left.warning.first_warning_side, other(right.warning.first_warning_side)) << name;
    EXPECT_EQ(left.warning.first_warning_s, right.warning.first_warning_s) << name;
}

TEST(Procedures, GiveTheMirroredResultToTheOtherSideOfASymmetricVehicle) {
    const sil::ProcedureWorld world = symmetric(shipped("van"));
    for (const sil::Procedure& procedure : sil::all_procedures()) {
        const std::vector<sil::ProcedureStep> steps = procedure.run(world).steps;
        ASSERT_EQ(steps.size() % 2U, 0U) << procedure.name;
        for (std::size_t i = 0U; i < steps.size() / 2U; ++i) {
            expect_mirrored(steps[i], steps[steps.size() / 2U + i],
                            procedure.name + " " + steps[i].name + " ");
        }
    }
}

TEST(Procedures, TellEachStepAsItIsFinishedAndGiveTheSameAgain) {
    sil::ProcedureWorld world = shipped("large_suv");
    std::size_t told = 0U;
    world.finished_step = [&told](const sil::ProcedureStep&) { ++told; };
    const sil::Procedure procedure = sil::find_procedure("fishhook-1b");
    const sil::ProcedureResult first = procedure.run(world);
    EXPECT_EQ(told, first.steps.size());
    EXPECT_EQ(sil::steps_csv(first), sil::steps_csv(procedure.run(world)));
}

}  // namespace
