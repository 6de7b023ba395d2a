// Detection: shares, leads and curves from rows made by hand.
#include "sil/studies/campaign/run_list.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/sil/campaign/small_campaign.hpp"

namespace detection_test {
namespace {

using testing_campaign::HandMadeRun;
using testing_campaign::recorded;

// `runs` must live on: a temporary does until the end of the expression.
sil::RunList list(const std::vector<sil::RecordedCampaignRun>& runs) {
    std::vector<const sil::RecordedCampaignRun*> pointers;
    for (const sil::RecordedCampaignRun& run : runs) {
        pointers.push_back(&run);
    }
    return sil::RunList{pointers};
}

void expect_share(const sil::Share& share, std::size_t count, std::size_t total) {
    EXPECT_EQ(share.count, count);
    EXPECT_EQ(share.total, total);
}

HandMadeRun lifted(std::optional<double> lead_s) {
    HandMadeRun run;
    run.lift_time_s = 3.0;
    run.lead_s = lead_s;
    run.warnings = 1U;  // that it began is not enough
    return run;
}

HandMadeRun upright(double largest_ltr, bool alarm) {
    HandMadeRun run;
    run.largest_ltr = largest_ltr;
    run.warnings = alarm ? 1U : 0U;
    return run;
}

TEST(Detection, RunsAreCalmBelowALoadTransferOfNineTenths) {
    EXPECT_TRUE(sil::is_calm(recorded(upright(0.899, false))));
    EXPECT_FALSE(sil::is_calm(recorded(upright(0.9, false))));
    EXPECT_FALSE(sil::is_calm(recorded(lifted({}))));
    sil::RecordedCampaignRun lifted_by_a_bump = recorded(lifted({}));
    lifted_by_a_bump.largest_ltr = 0.5;
    EXPECT_FALSE(sil::is_calm(lifted_by_a_bump));
    EXPECT_TRUE(sil::is_lifted(recorded(lifted({}))));
    EXPECT_FALSE(sil::is_lifted(recorded(upright(1.0, false))));
}

TEST(Detection, CountsLeadsOfLiftOffsAndAlarmsByBand) {
    const std::vector<sil::RecordedCampaignRun> runs{
        recorded(lifted(0.5)),          recorded(lifted(0.2)),         recorded(lifted(0.19)),
        recorded(lifted(0.1)),          recorded(lifted(0.09)),        recorded(lifted(0.0)),
        recorded(lifted({})),           recorded(upright(0.5, true)),  recorded(upright(0.6, false)),
        recorded(upright(0.7, true)),   recorded(upright(0.8, false)), recorded(upright(0.85, true)),
        recorded(upright(0.89, false)), recorded(upright(0.95, true)),
    };
    const sil::Detection detection = sil::detection_of_warning(list(runs));
    expect_share(detection.warned, 6U, 7U);
    expect_share(detection.warned_100ms, 4U, 7U);
    expect_share(detection.warned_200ms, 2U, 7U);
    expect_share(detection.false_alarms, 3U, 6U);
    expect_share(detection.alarms[0], 1U, 2U);
    expect_share(detection.alarms[1], 1U, 1U);
    expect_share(detection.alarms[2], 1U, 3U);
    expect_share(detection.alarms[3], 1U, 1U);
    EXPECT_THAT(detection.lead_times_s, testing::ElementsAre(0.5, 0.2, 0.19, 0.1, 0.09, 0.0, 0.0));
    EXPECT_EQ(detection.median_lead_s, 0.1);
    EXPECT_EQ(detection.tenth_lead_s, 0.0);
    EXPECT_FALSE(sil::detection_of_warning(list({recorded(upright(0.5, true))})).median_lead_s);
}

sil::RecordedCampaignRun with(std::optional<double> lift_time_s, double ltr, double threshold, double early,
                              double very_early, std::optional<double> lead_s = {}) {
    HandMadeRun run;
    run.lift_time_s = lift_time_s;
    run.largest_ltr = ltr;
    run.threshold = threshold;
    run.threshold_100ms = early;
    run.threshold_200ms = very_early;
    run.index_lead_s = lead_s;
    return recorded(run);
}

std::vector<sil::RecordedCampaignRun> five_runs() {
    return {with(3.0, 1.0, 1.4, 1.1, 0.6, 0.12), with(3.0, 1.0, 1.2, 0.7, 0.0, 0.01),
            with({}, 0.95, 1.3, 1.3, 1.3), with({}, 0.5, 1.1, 1.1, 1.1), with({}, 0.5, 0.6, 0.6, 0.6)};
}

TEST(Detection, OfAnIndexIsThatAtOne) {
    const sil::Detection detection = sil::IndexOverRuns(list(five_runs()), 0U).at_one();
    expect_share(detection.warned, 2U, 2U);
    expect_share(detection.warned_100ms, 1U, 2U);
    expect_share(detection.false_alarms, 1U, 2U);
    expect_share(detection.alarms[3], 1U, 1U);
    EXPECT_THAT(detection.lead_times_s, testing::ElementsAre(0.12, 0.01));
    const std::vector<sil::RecordedCampaignRun> at_limit{with({}, 0.5, 1.0, 1.0, 1.0),
                                                         with({}, 0.5, 0.99, 0.99, 0.99)};
    expect_share(sil::IndexOverRuns(list(at_limit), 0U).at_one().false_alarms, 1U, 2U);
}

TEST(Detection, OfAnIndexAtAnotherThreshold) {
    const sil::Detection detection = sil::IndexOverRuns(list(five_runs()), 0U).at(0.6);
    expect_share(detection.warned, 2U, 2U);
    expect_share(detection.warned_100ms, 2U, 2U);
    expect_share(detection.warned_200ms, 1U, 2U);
    expect_share(detection.false_alarms, 2U, 2U);
    const sil::Detection at_limits = sil::IndexOverRuns(list({with(3.0, 1.0, 0.6, 0.6, 0.6)}), 0U).at(0.6);
    expect_share(at_limits.warned, 1U, 1U);
    expect_share(at_limits.warned_100ms, 1U, 1U);
    expect_share(at_limits.warned_200ms, 1U, 1U);
    const sil::Detection above = sil::IndexOverRuns(list({with(3.0, 1.0, 0.6, 0.6, 0.6)}), 0U).at(0.61);
    expect_share(above.warned, 0U, 1U);
    expect_share(above.warned_100ms, 0U, 1U);
    expect_share(above.warned_200ms, 0U, 1U);
    expect_share(sil::IndexOverRuns(list(five_runs()), 0U).at(1.3).alarms[3], 1U, 1U);
    expect_share(sil::IndexOverRuns(list(five_runs()), 0U).at(1.31).alarms[3], 0U, 1U);
}

TEST(DetectionCurve, HasAPointForEachThresholdFromTheHighest) {
    const std::vector<sil::CurvePoint> curve = sil::IndexOverRuns(list(five_runs()), 0U).curve();
    std::vector<double> thresholds;
    for (const sil::CurvePoint& point : curve) {
        thresholds.push_back(point.threshold);
    }
    EXPECT_THAT(thresholds, testing::ElementsAre(1.4, 1.3, 1.2, 1.1, 0.7, 0.6));
    expect_share(curve[0].warned, 1U, 2U);
    expect_share(curve[0].warned_100ms, 0U, 2U);
    expect_share(curve[0].false_alarms, 0U, 2U);
    expect_share(curve[1].alarms[3], 1U, 1U);
    expect_share(curve[2].warned, 2U, 2U);
    expect_share(curve[3].warned_100ms, 1U, 2U);
    expect_share(curve[3].false_alarms, 1U, 2U);
    expect_share(curve[3].alarms[0], 1U, 2U);
    expect_share(curve[5].warned_100ms, 2U, 2U);
    expect_share(curve[5].warned_200ms, 1U, 2U);
    expect_share(curve[5].false_alarms, 2U, 2U);
}

TEST(DetectionCurve, HasNoPointWhereNothingWarnsOfAnyRun) {
    EXPECT_TRUE(sil::IndexOverRuns(list({}), 0U).curve().empty());
    EXPECT_TRUE(sil::IndexOverRuns(list({with(3.0, 1.0, 0.0, 0.0, 0.0), with({}, 0.5, 0.0, 0.0, 0.0)}), 0U)
                    .curve()
                    .empty());
}

TEST(DetectionCurve, BestIsTheMostDetectionWithinTheAllowedFalseAlarms) {
    const std::vector<sil::CurvePoint> curve = sil::IndexOverRuns(list(five_runs()), 0U).curve();
    EXPECT_EQ(sil::best_at(curve, 0.01)->threshold, 1.2);
    EXPECT_EQ(sil::best_at(curve, 0.5)->threshold, 0.7);
    EXPECT_EQ(sil::best_at(curve, 1.0)->threshold, 0.6);
    std::vector<sil::RecordedCampaignRun> never_200ms = five_runs();
    never_200ms[0].indices[0].threshold_200ms = 0.0;
    EXPECT_EQ(sil::best_at(sil::IndexOverRuns(list(never_200ms), 0U).curve(), 1.0)->threshold, 0.7)
        << "0.6 has more false alarms and nothing else";
}

TEST(DetectionCurve, WithoutCalmRunsOrLiftOffsNothingIsBest) {
    const sil::RecordedCampaignRun lifted_one = with(3.0, 1.0, 1.4, 1.1, 0.6);
    const sil::RecordedCampaignRun calm_one = with({}, 0.5, 0.4, 0.4, 0.4);
    EXPECT_FALSE(sil::best_at(sil::IndexOverRuns(list({lifted_one}), 0U).curve(), 1.0));
    EXPECT_FALSE(sil::best_at(sil::IndexOverRuns(list({calm_one}), 0U).curve(), 1.0));
    EXPECT_FALSE(sil::best_at({}, 1.0));
    EXPECT_EQ(sil::best_at(sil::IndexOverRuns(list({lifted_one, calm_one}), 0U).curve(), 0.0)->threshold,
              0.6);
}

TEST(DetectionCurve, AnIndexThatSaturatesHasNoThresholdForFewFalseAlarms) {
    EXPECT_FALSE(sil::best_at(
        sil::IndexOverRuns(list({with(3.0, 1.0, 1.0, 1.0, 1.0), with({}, 0.5, 1.0, 1.0, 1.0)}), 0U).curve(),
        0.01));
}

}  // namespace
}  // namespace detection_test
