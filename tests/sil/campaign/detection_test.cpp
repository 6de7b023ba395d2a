// Detection: shares, leads and curves from rows made by hand.
#include "sil/studies/campaign/detection.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/sil/campaign/small_campaign.hpp"

namespace detection_test {
namespace {

using testing_campaign::HandMadeRun;
using testing_campaign::recorded;

void expect_share(const sil::Share& share, std::size_t count, std::size_t total) {
    EXPECT_EQ(share.count, count);
    EXPECT_EQ(share.total, total);
}

HandMadeRun lifted(std::optional<double> warning_time_s) {
    HandMadeRun run;
    run.lift_time_s = 3.0;
    run.warning_time_s = warning_time_s;
    return run;
}

HandMadeRun upright(double largest_ltr, std::optional<double> warning_time_s) {
    HandMadeRun run;
    run.largest_ltr = largest_ltr;
    run.warning_time_s = warning_time_s;
    return run;
}

TEST(Detection, RunsAreCalmBelowALoadTransferOfNineTenths) {
    EXPECT_EQ(sil::kind_of(recorded(upright(0.899, {}))), sil::RunKind::calm);
    EXPECT_EQ(sil::kind_of(recorded(upright(0.9, {}))), sil::RunKind::between);
    EXPECT_EQ(sil::kind_of(recorded(upright(1.0, {}))), sil::RunKind::between);
    EXPECT_EQ(sil::kind_of(recorded(lifted({}))), sil::RunKind::lifted);
}

TEST(Detection, CountsWarningsBeforeLiftOffAndAlarmsApart) {
    const std::vector<sil::RecordedCampaignRun> runs{
        recorded(lifted(2.5)),        // 0.5 s ahead
        recorded(lifted(2.9)),        // 0.1 s
        recorded(lifted(2.92)),       // 0.08 s
        recorded(lifted(3.0)),        // as it happens
        recorded(lifted(3.04)),       // too late
        recorded(lifted({})),         // never
        recorded(upright(0.5, 1.0)),  // false alarm
        recorded(upright(0.8, {})),  recorded(upright(0.85, {})), recorded(upright(0.95, 2.0)),  // in between
        recorded(upright(0.95, {})),
    };
    const sil::Detection detection = sil::detection_of_warning(runs);
    expect_share(detection.warned, 4U, 6U);
    expect_share(detection.warned_100ms, 2U, 6U);
    expect_share(detection.false_alarms, 1U, 3U);
    expect_share(detection.hard_false_alarms, 0U, 2U);
    expect_share(detection.alarms_between, 1U, 2U);
    EXPECT_THAT(detection.lead_times_s,
                testing::ElementsAre(testing::DoubleNear(0.5, 1e-9), testing::DoubleNear(0.1, 1e-9),
                                     testing::DoubleNear(0.08, 1e-9), testing::DoubleNear(0.0, 1e-9),
                                     testing::DoubleNear(-0.04, 1e-9)));
}

sil::RecordedCampaignRun with_peak(std::optional<double> lift_time_s, double ltr, double peak, double early) {
    HandMadeRun run;
    run.lift_time_s = lift_time_s;
    run.largest_ltr = ltr;
    run.peak = peak;
    run.peak_100ms_before = early;
    return recorded(run);
}

std::vector<sil::RecordedCampaignRun> five_peaks() {
    return {with_peak(3.0, 1.0, 1.4, 1.1), with_peak(3.0, 1.0, 1.2, 0.7), with_peak({}, 0.95, 1.3, 1.3),
            with_peak({}, 0.5, 1.1, 1.1), with_peak({}, 0.5, 0.6, 0.6)};
}

TEST(DetectionCurve, HasAPointForEachThresholdFromTheHighest) {
    const std::vector<sil::CurvePoint> curve = sil::detection_curve(five_peaks(), 0U);
    std::vector<double> thresholds;
    for (const sil::CurvePoint& point : curve) {
        thresholds.push_back(point.threshold);
    }
    EXPECT_THAT(thresholds, testing::ElementsAre(1.4, 1.3, 1.2, 1.1, 0.7, 0.6));
    expect_share(curve[0].warned, 1U, 2U);
    expect_share(curve[0].warned_100ms, 0U, 2U);
    expect_share(curve[0].false_alarms, 0U, 2U);
    expect_share(curve[1].alarms_between, 1U, 1U);
    expect_share(curve[2].warned, 2U, 2U);
    expect_share(curve[3].warned_100ms, 1U, 2U);
    expect_share(curve[3].false_alarms, 1U, 2U);
    expect_share(curve[5].warned_100ms, 2U, 2U);
    expect_share(curve[5].false_alarms, 2U, 2U);
}

TEST(DetectionCurve, BestIsTheMostDetectionWithinTheAllowedFalseAlarms) {
    const std::vector<sil::CurvePoint> curve = sil::detection_curve(five_peaks(), 0U);
    EXPECT_EQ(sil::best_at(curve, 0.01)->threshold, 1.2);
    EXPECT_EQ(sil::best_at(curve, 0.5)->threshold, 0.7);
    EXPECT_EQ(sil::best_at(curve, 1.0)->threshold, 0.7) << "0.6 has more false alarms and nothing else";
}

TEST(DetectionCurve, WithoutCalmRunsOrLiftOffsNothingIsBest) {
    EXPECT_FALSE(sil::best_at(sil::detection_curve({with_peak(3.0, 1.0, 1.4, 1.1)}, 0U), 0.01));
    EXPECT_FALSE(sil::best_at(sil::detection_curve({with_peak({}, 0.5, 1.4, 1.1)}, 0U), 0.01));
    EXPECT_FALSE(sil::best_at({}, 0.01));
}

TEST(DetectionCurve, AnIndexThatSaturatesHasNoThresholdForFewFalseAlarms) {
    EXPECT_FALSE(sil::best_at(
        sil::detection_curve({with_peak(3.0, 1.0, 1.0, 1.0), with_peak({}, 0.5, 1.0, 1.0)}, 0U), 0.01));
}

}  // namespace
}  // namespace detection_test
