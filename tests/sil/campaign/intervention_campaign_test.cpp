// Intervention in a campaign: an index demands it, and the rows say what came of it.
#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sil/studies/campaign/campaign_run.hpp"
#include "sil/studies/campaign/indices.hpp"
#include "tests/sil/campaign/small_campaign.hpp"

namespace intervention_campaign_test {
namespace {

using Rows = std::map<std::uint64_t, sil::CampaignRow>;

constexpr std::uint64_t count = 24U;
constexpr double always = 0.001;
constexpr double never = 100.0;

constexpr const char* own_index = "predicted_load_transfer";  // by which the shipped calibrations warn

// J-turns of a loaded vehicle, calm ones and hard ones.
sil::CampaignSettings campaign(const std::optional<sil::CampaignIntervention>& intervention) {
    sil::CampaignSettings settings = testing_campaign::small_campaign(count);
    settings.vehicles.resize(1U);
    settings.manoeuvres = {{"j-turn-110", 1.0, {0.3, 1.0}, {0.1, 1.2}, 4.0}};
    settings.spread.friction_factor = {1.0, 1.2};
    settings.spread.load_share = {0.05, 0.2};
    settings.spread.load_height_factor = {1.5, 1.9};
    settings.intervention = intervention;
    return settings;
}

Rows driven(const std::optional<sil::CampaignIntervention>& intervention) {
    const sil::CampaignWorld world{campaign(intervention)};
    Rows rows;
    std::uint64_t next = 0U;
    world.run_together([&next] { return next < count ? std::optional{next++} : std::nullopt; },
                       [&rows](const sil::CampaignRow& row) {
                           rows.emplace(row.draw.number, row);
                           return true;
                       });
    return rows;
}

// Driven once for all tests.
const Rows& without() {
    static const Rows rows = driven(std::nullopt);
    return rows;
}

sil::CampaignIntervention brake_at(double level, double delay_s = 0.0) {
    return {own_index, level, {sil::InterventionKind::brake, delay_s, 0.1, 6.0, 0.0}};
}

sil::CampaignIntervention brake_by_firmware() {
    sil::CampaignIntervention intervention = brake_at(1.0);
    intervention.index = sil::CampaignIntervention::firmware;
    return intervention;
}

std::vector<std::uint64_t> lifted(const Rows& rows) {
    std::vector<std::uint64_t> numbers;
    for (const auto& [number, row] : rows) {
        if (row.outcome.two_wheel_lift_time_s) {
            numbers.push_back(number);
        }
    }
    return numbers;
}

TEST(InterventionCampaign, OfADriverWhoAlwaysSteersBackPreventsEveryLiftOff) {
    ASSERT_GE(lifted(without()).size(), 5U);
    const sil::CampaignIntervention steer_back{
        own_index, always, {sil::InterventionKind::driver, 0.0, 0.0, 0.0, 1.0}};
    const Rows rows = driven(steer_back);
    EXPECT_EQ(rows.size(), count);
    EXPECT_TRUE(lifted(rows).empty());
    for (const auto& [number, row] : rows) {
        EXPECT_GT(row.intervention_s, 1.0) << number;
    }
}

TEST(InterventionCampaign, OfBrakesThatAlwaysActPreventsLiftOffsThatHappenWithout) {
    EXPECT_LT(2U * lifted(driven(brake_at(always))).size(), lifted(without()).size());
}

TEST(InterventionCampaign, AtALevelOutOfReachLeavesEveryRowAsItIs) {
    const Rows rows = driven(brake_at(never));
    ASSERT_EQ(rows.size(), without().size());
    for (const auto& [number, row] : rows) {
        EXPECT_EQ(sil::row_line(row), sil::row_line(without().at(number)));
    }
}

TEST(InterventionCampaign, ByTheFirmwarePreventsLiftOffs) {
    EXPECT_LT(lifted(driven(brake_by_firmware())).size(), lifted(without()).size());
}

// The study takes over the rows of such runs and does not drive them again.
TEST(InterventionCampaign, LeavesTheRowOfARunWhoseIndexStaysBelowTheLevelAsItIs) {
    const std::size_t place = sil::index_place(own_index).value();
    const Rows rows = driven(brake_at(1.0));
    std::size_t below = 0U;
    for (const auto& [number, row] : without()) {
        if (!row.outcome.two_wheel_lift_time_s && row.indices[place].threshold < 1.0) {
            EXPECT_EQ(sil::row_line(rows.at(number)), sil::row_line(row));
            ++below;
        }
    }
    EXPECT_GE(below, 5U);
}

TEST(InterventionCampaign, ByTheFirmwareActsInTheRunsInWhichItWarns) {
    std::size_t acted = 0U;
    for (const auto& [number, row] : driven(brake_by_firmware())) {
        const sil::CampaignRow& before = without().at(number);
        EXPECT_EQ(row.interventions > 0U, before.warning_time_s.has_value()) << number;
        EXPECT_EQ(row.interventions > 0U, row.intervention_s > 0.0) << number;
        if (row.interventions > 0U) {
            EXPECT_EQ(row.warning_time_s, before.warning_time_s) << number;
            EXPECT_LT(row.intervention_s, row.outcome.end_time_s - *row.warning_time_s + 0.011) << number;
            ++acted;
        }
    }
    EXPECT_GE(acted, 5U);
}

TEST(InterventionCampaign, ComesTooLateAfterALongDelay) {
    EXPECT_EQ(lifted(driven(brake_at(1.0, 5.0))), lifted(without()));
}

TEST(InterventionCampaign, GivesTheRowOfTheRunAlone) {
    const sil::CampaignWorld world{campaign(brake_at(0.5))};
    const Rows together = driven(brake_at(0.5));
    for (std::uint64_t number = 0U; number < 6U; ++number) {
        EXPECT_EQ(sil::row_line(world.run(number)), sil::row_line(together.at(number)));
    }
}

}  // namespace
}  // namespace intervention_campaign_test
