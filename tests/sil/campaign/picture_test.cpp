// Pictures: the drawing script on rows made by hand, and what it says when there is nothing to draw.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "sil/page/study_page.hpp"
#include "sil/studies/campaign/report.hpp"
#include "tests/sil/campaign/small_campaign.hpp"
#include "tests/support/scratch_folder.hpp"

namespace {

using test_support::ScratchFolder;
using test_support::text_of;
using testing_campaign::HandMadeRun;
using testing_campaign::recorded;

int draw(const std::filesystem::path& folder) {
    const std::string command = testing_campaign::project_file("sil/studies/campaign/draw") + " '" +
                                folder.string() + "' > '" + (folder / "messages").string() + "' 2>&1";
    return std::system(command.c_str());
}

sil::RowTable table() {
    const HandMadeRun lifted{3.0, 1.0, 0.5, 1U, 1.4, 1.1, 0.9, 0.6};
    const HandMadeRun calm{{}, 0.5, {}, 0U, 0.4, 0.4, 0.4, {}};
    return {{"a_level"}, {recorded(lifted), recorded(calm)}};
}

TEST(CampaignPicture, DetectionAndLeadsAreDrawn) {
    const ScratchFolder folder;
    sil::write_report(sil::make_report(table(), 2U), folder.path());
    ASSERT_EQ(draw(folder.path()), 0) << text_of(folder.path() / "messages");
    EXPECT_EQ(text_of(folder.path() / "messages"), "");
    for (const std::string picture : {"detection", "leads"}) {
        EXPECT_EQ(text_of(folder.path() / (picture + ".png")).substr(0, 8), "\x89PNG\r\n\x1a\n");
        EXPECT_THAT(text_of(folder.path() / (picture + ".svg")), testing::HasSubstr("a_level"));
    }
}

// Places of `part` in `text`.
std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0U;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1U)) {
        ++count;
    }
    return count;
}

TEST(CampaignPicture, ShowsTheFirmwaresWarningHoweverManyAlarmsItGives) {
    const ScratchFolder folder;
    sil::RowTable rows = table();
    const HandMadeRun alarmed{{}, 0.8, {}, 1U, 0.4, 0.4, 0.4, {}};
    rows.runs.push_back(recorded(alarmed));
    sil::write_report(sil::make_report(rows, 3U), folder.path());
    ASSERT_EQ(draw(folder.path()), 0) << text_of(folder.path() / "messages");
    // Half of the calm runs: once in the key, and in each of three panels.
    EXPECT_EQ(count_of(text_of(folder.path() / "detection.svg"), "<use xlink:href='#gpPt5' transform"), 4U);
}

TEST(CampaignPicture, HasTheColoursOfThePage) {
    const ScratchFolder folder;
    sil::RowTable rows = table();
    rows.index_names = {"published"};
    sil::write_report(sil::make_report(rows, 2U), folder.path());
    ASSERT_EQ(draw(folder.path()), 0) << text_of(folder.path() / "messages");
    EXPECT_EQ(sil::index_line("published").colour, "--purple");
    for (const std::string picture : {"detection", "leads"}) {
        EXPECT_THAT(text_of(folder.path() / (picture + ".svg")), testing::HasSubstr("rgb(204, 121, 167)"))
            << picture;
    }
}

TEST(CampaignPicture, WithoutLiftOffThereIsNothingToDraw) {
    const ScratchFolder folder;
    sil::RowTable calm = table();
    calm.runs.erase(calm.runs.begin());
    sil::write_report(sil::make_report(calm, 1U), folder.path());
    EXPECT_NE(draw(folder.path()), 0);
    EXPECT_THAT(text_of(folder.path() / "messages"), testing::HasSubstr("nothing to compare"));
}

TEST(CampaignPicture, AMissingReportIsNamed) {
    const ScratchFolder folder;
    EXPECT_NE(draw(folder.path()), 0);
    EXPECT_THAT(text_of(folder.path() / "messages"), testing::HasSubstr("curves.csv is missing"));
}

}  // namespace
