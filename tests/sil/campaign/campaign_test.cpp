// Campaign: the same rows whatever the threads and interruptions, and no row lost.
#include "sil/studies/campaign/campaign.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>

#include "sil/files/calibration_file.hpp"
#include "sil/studies/campaign/row_table.hpp"
#include "tests/sil/campaign/small_campaign.hpp"
#include "tests/support/scratch_folder.hpp"

namespace {

using test_support::ScratchFolder;
using test_support::text_of;
using test_support::write_text;
using testing::HasSubstr;
using testing_campaign::small_campaign;

constexpr std::uint64_t runs = 8U;

sil::RowProgress run(const sil::CampaignSettings& settings, const std::filesystem::path& folder,
                     unsigned jobs = 2U, const sil::RowListener& listener = {}) {
    const std::atomic<bool> never{false};
    return sil::run_campaign(sil::CampaignWorld{settings}, folder, jobs, never, listener);
}

std::string rows(const ScratchFolder& folder) {
    return text_of(folder.path() / "runs.csv");
}

// Rows of one thread, without interruption; driven once for all tests.
const std::string& expected_rows() {
    static const std::string text = [] {
        const ScratchFolder folder;
        run(small_campaign(runs), folder.path(), 1U);
        return rows(folder);
    }();
    return text;
}

std::size_t line_count(const std::string& text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

TEST(Campaign, GivesARowARun) {
    EXPECT_EQ(line_count(expected_rows()), 1U + runs);
    EXPECT_THAT(expected_rows(), HasSubstr("\n0,"));
    EXPECT_THAT(expected_rows(), HasSubstr("\n7,"));
}

TEST(Campaign, GivesTheSameRowsWhateverTheThreads) {
    const ScratchFolder folder;
    const sil::RowProgress progress = run(small_campaign(runs), folder.path(), 4U);
    EXPECT_EQ(progress.finished, runs);
    EXPECT_EQ(rows(folder), expected_rows());
}

TEST(Campaign, GoesOnAfterAnInterruptionWithoutDoingAnythingAgain) {
    const ScratchFolder folder;
    std::atomic<bool> stop{false};
    const sil::RowProgress first =
        sil::run_campaign(sil::CampaignWorld{small_campaign(runs)}, folder.path(), 1U, stop,
                          [&stop](const sil::RowProgress& now) { stop = now.finished == 3U; });
    EXPECT_EQ(first.finished, 3U);
    EXPECT_EQ(line_count(rows(folder)), 4U);
    std::uint64_t done = 0U;
    const sil::RowProgress second =
        run(small_campaign(runs), folder.path(), 2U, [&done](const sil::RowProgress&) { ++done; });
    EXPECT_EQ(second.begun_with, 3U);
    EXPECT_EQ(done, runs - 3U);
    EXPECT_EQ(rows(folder), expected_rows());
}

TEST(Campaign, LosesNoFinishedRunWhenItIsKilled) {
    const ScratchFolder folder;
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        run(small_campaign(runs), folder.path(), 1U, [](const sil::RowProgress& now) {
            if (now.finished == 3U) {
                std::raise(SIGKILL);
            }
        });
        ::_exit(0);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(line_count(rows(folder)), 4U);
    EXPECT_EQ(run(small_campaign(runs), folder.path()).begun_with, 3U);
    EXPECT_EQ(rows(folder), expected_rows());
}

TEST(Campaign, DoesATruncatedLastRowAgain) {
    const ScratchFolder folder;
    run(small_campaign(runs), folder.path());
    write_text(folder.path() / "runs.csv", rows(folder).substr(0U, rows(folder).size() - 30U));
    EXPECT_EQ(run(small_campaign(runs), folder.path()).begun_with, runs - 1U);
    EXPECT_EQ(rows(folder), expected_rows());
}

TEST(Campaign, MayGrow) {
    const ScratchFolder folder;
    run(small_campaign(3U), folder.path());
    EXPECT_EQ(run(small_campaign(runs), folder.path()).begun_with, 3U);
    EXPECT_EQ(rows(folder), expected_rows());
}

void expect_refused(const sil::CampaignSettings& settings, const ScratchFolder& folder,
                    const std::string& why) {
    const std::string before = rows(folder);
    try {
        run(settings, folder.path());
        FAIL() << "was accepted";
    } catch (const sil::InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr(why));
    }
    EXPECT_EQ(rows(folder), before);
}

TEST(Campaign, RefusesAFolderWithOtherSettings) {
    const ScratchFolder folder;
    run(small_campaign(2U), folder.path());
    sil::CampaignSettings settings = small_campaign(2U);
    settings.seed = 8U;
    expect_refused(settings, folder, "`seed = 7` where now there is `seed = 8`");
    settings = small_campaign(2U);
    settings.spread.stiffness_error = 0.2;
    expect_refused(settings, folder, "`stiffness_error = 0.1` where now there is `stiffness_error = 0.2`");
    expect_refused(small_campaign(1U), folder, "can grow, not shrink");
}

TEST(Campaign, RefusesAFolderWhoseVehicleFileHasChanged) {
    const ScratchFolder folder;
    const ScratchFolder files;
    sil::CampaignSettings settings = small_campaign(1U);
    const std::string vehicle = text_of(settings.vehicles[0].parameters);
    settings.vehicles[0].parameters = (files.path() / "car.toml").string();
    write_text(settings.vehicles[0].parameters, vehicle);
    run(settings, folder.path());
    write_text(settings.vehicles[0].parameters, vehicle + "# a thought\n");
    expect_refused(settings, folder, "vehicle_1_parameters");
}

TEST(Campaign, RefusesRowsOfUnknownSettings) {
    const ScratchFolder folder;
    run(small_campaign(1U), folder.path());
    std::filesystem::remove(folder.path() / "campaign.toml");
    expect_refused(small_campaign(1U), folder, "no campaign.toml");
}

TEST(Campaign, RefusesAFolderThatAnotherIsWritingInto) {
    const ScratchFolder folder;
    std::string answer;
    run(small_campaign(1U), folder.path(), 1U, [&](const sil::RowProgress&) {
        try {
            run(small_campaign(1U), folder.path());
        } catch (const sil::InputError& error) {
            answer = error.what();
        }
    });
    EXPECT_THAT(answer, HasSubstr("another campaign is writing"));
}

// The index that drives the warning must reach its level exactly when the firmware warns.
TEST(Campaign, TheDrivingIndexReachesItsLevelWhenTheFirmwareWarns) {
    const ScratchFolder folder;
    write_text(folder.path() / "runs.csv", expected_rows());
    const sil::RowTable table = sil::load_rows(folder.path() / "runs.csv");
    const rsi::Parameters calibration =
        sil::load_calibration(testing_campaign::project_file("firmware/calibrations/large_suv.toml"));
    const auto driving = static_cast<std::size_t>(calibration.warning_indicator);
    const auto warning_on = static_cast<double>(calibration.warning_on);
    constexpr double step = 1.01;  // of the thresholds
    int warned = 0;
    int lifted = 0;
    for (const sil::RecordedCampaignRun& run : table.runs) {
        const bool by_firmware = run.two_wheel_lift_time_s ? run.lead_s.has_value() : run.warnings > 0U;
        const double threshold = run.indices[driving].threshold;
        EXPECT_TRUE(by_firmware ? threshold > warning_on / step : threshold < warning_on)
            << "run " << run.number << ": " << threshold;
        warned += by_firmware ? 1 : 0;
        lifted += run.two_wheel_lift_time_s ? 1 : 0;
    }
    EXPECT_GE(warned, 1);
    EXPECT_GE(lifted, 1);
    EXPECT_LT(warned, static_cast<int>(runs));
}

}  // namespace
