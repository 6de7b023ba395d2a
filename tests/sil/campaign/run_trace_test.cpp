// Run trace: what a run of a campaign was in time, and that writing it changes nothing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "sil/files/calibration_file.hpp"
#include "sil/judge/warning_judgement.hpp"
#include "sil/studies/campaign/campaign.hpp"
#include "tests/sil/campaign/small_campaign.hpp"
#include "tests/support/scratch_folder.hpp"

namespace {

using test_support::ScratchFolder;
using test_support::text_of;
using testing::HasSubstr;
using testing::StartsWith;
using testing_campaign::small_campaign;

constexpr std::uint64_t runs = 8U;

sil::CampaignWorld& world() {
    static sil::CampaignWorld only{small_campaign(runs)};
    return only;
}

struct Traced {
    sil::CampaignRow row;
    std::vector<std::vector<std::string>> lines;  // without remarks; the first one has the names
    std::string text;
};

std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream stream{line};
    for (std::string cell; std::getline(stream, cell, ',');) {
        cells.push_back(cell);
    }
    return cells;
}

Traced traced(std::uint64_t number, const ScratchFolder& folder) {
    sil::RunTrace trace;
    Traced result;
    result.row = world().run(number, &trace);
    trace.write(folder.path(), result.row);
    result.text = text_of(sil::trace_file(folder.path(), number));
    std::istringstream stream{result.text};
    for (std::string line; std::getline(stream, line);) {
        if (line[0] != '#') {
            result.lines.push_back(cells_of(line));
        }
    }
    return result;
}

sil::WarningState state_of(const std::string& name) {
    return name == "warning" ? sil::WarningState::warning : sil::WarningState::ready;
}

sil::WarningSide side_of(const std::string& name) {
    return name == "left" ? sil::WarningSide::left
                          : (name == "right" ? sil::WarningSide::right : sil::WarningSide::none);
}

TEST(RunTrace, ChangesNothingInTheRow) {
    const ScratchFolder folder;
    for (std::uint64_t number = 0U; number < runs; ++number) {
        EXPECT_EQ(sil::row_line(traced(number, folder).row), sil::row_line(world().run(number)));
    }
}

TEST(RunTrace, HasALineForEachCycle) {
    const ScratchFolder folder;
    const Traced run = traced(0U, folder);
    const std::vector<std::string>& names = run.lines.front();
    EXPECT_EQ(names.front(), "time_s");
    EXPECT_EQ(names.back(), "side");
    for (std::size_t k = 1U; k < run.lines.size(); ++k) {
        ASSERT_EQ(run.lines[k].size(), names.size());
        EXPECT_NEAR(std::stod(run.lines[k][0]), 0.01 * static_cast<double>(k - 1U), 1.0e-6);
    }
    EXPECT_NEAR(std::stod(run.lines.back()[0]), run.row.outcome.end_time_s, 1.0e-6);
}

// The state and side of every cycle give the lead of the row.
TEST(RunTrace, HasTheWarningOfTheRow) {
    const ScratchFolder folder;
    int lifted = 0;
    int warned = 0;
    for (std::uint64_t number = 0U; number < runs; ++number) {
        const Traced run = traced(number, folder);
        if (!run.row.outcome.two_wheel_lift_time_s) {
            EXPECT_THAT(run.text, HasSubstr("# two_wheel_lift_time_s: none\n"));
            continue;
        }
        ++lifted;
        const double lift_s = *run.row.outcome.two_wheel_lift_time_s;
        sil::WarningInForce in_force;
        for (std::size_t k = 1U; k < run.lines.size() && std::stod(run.lines[k][0]) <= lift_s; ++k) {
            const std::vector<std::string>& cells = run.lines[k];
            in_force.observe(state_of(cells[cells.size() - 2U]), side_of(cells.back()), std::stod(cells[0]));
        }
        const auto lead_s = in_force.lead_s(lift_s, run.row.judgement.falling_side);
        ASSERT_EQ(lead_s.has_value(), run.row.judgement.lead_s.has_value()) << "run " << number;
        if (lead_s) {
            ++warned;
            EXPECT_NEAR(*lead_s, *run.row.judgement.lead_s, 1.0e-6) << "run " << number;
        }
    }
    EXPECT_GE(lifted, 1);
    EXPECT_GE(warned, 1);
}

TEST(RunTrace, HasTheCalibrationOfTheRunBeside) {
    const ScratchFolder folder;
    traced(3U, folder);
    const rsi::Parameters read = sil::load_calibration((folder.path() / "3.toml").string());
    EXPECT_EQ(read.sprung_cg_height_m, world().prepare(3U).calibration.sprung_cg_height_m);
    EXPECT_EQ(read.roll_stiffness_nmprad, world().prepare(3U).calibration.roll_stiffness_nmprad);
}

sil::RowProgress campaign(const ScratchFolder& folder, std::uint64_t count, bool with_traces) {
    const std::atomic<bool> never{false};
    return sil::run_campaign(sil::CampaignWorld{small_campaign(count)}, folder.path(), 2U, never, {},
                             with_traces);
}

TEST(RunTrace, IsLeftByEveryRunOfACampaignThatIsToldTo) {
    const ScratchFolder folder;
    campaign(folder, 2U, true);
    EXPECT_EQ(campaign(folder, 3U, true).begun_with, 2U);
    for (std::uint64_t number = 0U; number < 3U; ++number) {
        EXPECT_THAT(text_of(sil::trace_file(folder.path() / "traces", number)),
                    StartsWith("# one_wheel_lift_time_s: "));
    }
}

TEST(RunTrace, IsNotMixedWithRowsThatHaveNone) {
    const ScratchFolder folder;
    campaign(folder, 2U, false);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "traces"));
    EXPECT_THROW(campaign(folder, 3U, true), sil::InputError);
}

}  // namespace
