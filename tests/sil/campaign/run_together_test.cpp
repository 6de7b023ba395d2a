// Runs driven together: each row is that of the run alone, in any company.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "sil/simulation/run_batch.hpp"
#include "sil/studies/campaign/campaign_run.hpp"
#include "tests/sil/campaign/small_campaign.hpp"

namespace {

using testing_campaign::small_campaign;

// Every manoeuvre of the built-in campaign, for different times, some of them no more than a few cycles.
sil::CampaignSettings mixed_campaign() {
    sil::CampaignSettings settings = small_campaign(200U);
    settings.manoeuvres = sil::default_campaign().manoeuvres;
    double duration_s = 0.02;
    for (sil::CampaignManoeuvre& manoeuvre : settings.manoeuvres) {
        manoeuvre.duration_s = duration_s;
        duration_s = duration_s < 6.0 ? 1.7 * duration_s + 0.1 : 0.5;
    }
    return settings;
}

std::map<std::uint64_t, std::string> together(const sil::CampaignWorld& world,
                                              std::vector<std::uint64_t> numbers) {
    std::map<std::uint64_t, std::string> lines;
    std::reverse(numbers.begin(), numbers.end());
    world.run_together(
        [&numbers]() -> std::optional<std::uint64_t> {
            if (numbers.empty()) {
                return std::nullopt;
            }
            const std::uint64_t number = numbers.back();
            numbers.pop_back();
            return number;
        },
        [&lines](const sil::CampaignRow& row) {
            EXPECT_TRUE(lines.emplace(row.draw.number, sil::row_line(row)).second) << row.draw.number;
            return true;
        });
    return lines;
}

TEST(RunTogether, GivesTheRowsOfTheRunsAloneInAnyOrder) {
    const sil::CampaignWorld world{mixed_campaign()};
    std::vector<std::uint64_t> numbers;
    for (std::uint64_t number = 0U; number < 40U; ++number) {
        numbers.push_back(number * 7U % 40U);
    }
    const std::map<std::uint64_t, std::string> all = together(world, numbers);
    ASSERT_EQ(all.size(), numbers.size());
    for (const auto& [number, line] : all) {
        EXPECT_EQ(line, sil::row_line(world.run(number)));
    }
    std::reverse(numbers.begin(), numbers.end());
    numbers.resize(11U);
    for (const auto& [number, line] : together(world, numbers)) {
        EXPECT_EQ(line, all.at(number));
    }
    EXPECT_TRUE(together(world, {}).empty());
}

TEST(RunTogether, EndsAtOnceWhenNoMoreRowsAreWanted) {
    const sil::CampaignWorld world{small_campaign(20U)};
    std::uint64_t next = 0U;
    int taken = 0;
    world.run_together([&next] { return std::optional{next++}; },
                       [&taken](const sil::CampaignRow&) { return ++taken < 3; });
    EXPECT_EQ(taken, 3);
}

TEST(RunTogether, TellsWhichRunHasFailed) {
    sil::CampaignSettings settings = small_campaign(20U);
    settings.manoeuvres = {{"fishhook-1a", 1.0, {1.0, 1.0}, {1.0, 1.0}, 1.0}};
    settings.spread.friction_factor = {0.02, 0.02};  // no handwheel angle gives 0.3 g on ice
    const sil::CampaignWorld world{settings};
    try {
        together(world, {13U});
        FAIL() << "a run on ice did not fail";
    } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("run 13: "));
    }
}

// Throws when its run has come so far.
class Thrower final : public sil::RunObserver {
 public:
    explicit Thrower(double after_s) : after_s_{after_s} {}
    void step(const sil::Truth& truth) override {
        if (truth.time_s > after_s_) {
            throw std::runtime_error("enough");
        }
    }

 private:
    double after_s_;
};

TEST(RunTogether, KnowsTheLaneInWhichSomethingWasThrown) {
    const sil::CampaignWorld world{mixed_campaign()};
    const sil::DrawnRun drawn = world.prepare(0U);
    const sil::RunOptions options{drawn.options.mirrored, sil::Vehicle::nominal_step_s, 5.0};
    sil::InProcessRun patient{drawn.vehicle, drawn.manoeuvre, options, drawn.sensors, drawn.calibration};
    sil::InProcessRun short_of_it{drawn.vehicle, drawn.manoeuvre, options, drawn.sensors, drawn.calibration};
    Thrower never{100.0};
    Thrower soon{0.1};
    sil::RunBatch batch;
    ASSERT_TRUE(batch.begin(1U, patient, never));
    ASSERT_TRUE(batch.begin(6U, short_of_it, soon));
    EXPECT_THROW(
        {
            for (int cycle = 0; cycle < 20; ++cycle) {
                batch.cycle();
            }
        },
        std::runtime_error);
    EXPECT_EQ(batch.lane_at_work(), 6U);
}

}  // namespace
