// Campaign parts: the same rows whatever the partition, whole or not at all, and never mixed with another's.
#include "sil/studies/campaign/campaign_part.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sil/studies/campaign/campaign.hpp"
#include "sil/studies/campaign/campaign_folder.hpp"
#include "sil/studies/campaign/row_table.hpp"
#include "tests/sil/campaign/small_campaign.hpp"
#include "tests/support/scratch_folder.hpp"

namespace campaign_part_test {
namespace {

using test_support::ScratchFolder;
using test_support::text_of;
using test_support::write_text;
using testing::HasSubstr;
using testing_campaign::small_campaign;

constexpr std::uint64_t runs = 6U;
const std::atomic<bool> never{false};

sil::RowProgress make(const sil::CampaignSettings& settings, std::uint64_t first, std::uint64_t count,
                      const std::filesystem::path& part, const sil::RowListener& listener = {}) {
    return sil::make_part(sil::CampaignWorld{settings}, first, count, part, 2U, never, listener);
}

// Rows of one file, without parts; driven once for all tests.
const std::string& expected_rows() {
    static const std::string text = [] {
        const ScratchFolder folder;
        sil::run_campaign(sil::CampaignWorld{small_campaign(runs)}, folder.path(), 1U, never);
        return text_of(folder.path() / "runs.csv");
    }();
    return text;
}

// Text behind the head and, but for the first part, the names of the columns.
std::string rows_of(const std::filesystem::path& part, bool with_names) {
    std::string text = text_of(part);
    for (int line = 0; line < (with_names ? 1 : 2); ++line) {
        text.erase(0U, text.find('\n') + 1U);
    }
    return text;
}

template <typename Call>
void expect_refused(const Call& call, const std::string& why) {
    try {
        call();
        FAIL() << "was accepted";
    } catch (const sil::InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr(why));
    }
}

TEST(CampaignPart, OfAnyPartitionHasTheSameRows) {
    const ScratchFolder folder;
    make(small_campaign(runs), 4U, 2U, folder.path() / "last.csv");
    make(small_campaign(runs), 0U, 1U, folder.path() / "first.csv");
    make(small_campaign(runs), 1U, 3U, folder.path() / "middle.csv");
    EXPECT_EQ(rows_of(folder.path() / "first.csv", true) + rows_of(folder.path() / "middle.csv", false) +
                  rows_of(folder.path() / "last.csv", false),
              expected_rows());
    const sil::RowTable table = sil::load_campaign_rows(folder.path());
    ASSERT_EQ(table.runs.size(), runs);
    for (std::uint64_t number = 0U; number < runs; ++number) {
        EXPECT_EQ(table.runs[number].number, number);
    }
}

TEST(CampaignPart, ThatIsThereIsKept) {
    const ScratchFolder folder;
    const std::filesystem::path part = folder.path() / "part.csv";
    EXPECT_EQ(make(small_campaign(runs), 2U, 2U, part).begun_with, 0U);
    const auto written = std::filesystem::last_write_time(part);
    const sil::RowProgress again = make(small_campaign(runs), 2U, 2U, part,
                                        [](const sil::RowProgress&) { FAIL() << "a run was driven again"; });
    EXPECT_EQ(again.begun_with, 2U);
    EXPECT_EQ(again.finished, 2U);
    EXPECT_EQ(std::filesystem::last_write_time(part), written);
}

TEST(CampaignPart, ThatIsStoppedLeavesNoFile) {
    const ScratchFolder folder;
    std::atomic<bool> stop{false};
    const sil::RowProgress progress =
        sil::make_part(sil::CampaignWorld{small_campaign(runs)}, 0U, 4U, folder.path() / "part.csv", 1U, stop,
                       [&stop](const sil::RowProgress& now) { stop = now.finished == 2U; });
    EXPECT_EQ(progress.finished, 2U);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "part.csv"));
}

TEST(CampaignPart, IsNotMixedWithAnothers) {
    const ScratchFolder folder;
    const std::filesystem::path part = folder.path() / "part.csv";
    make(small_campaign(runs), 0U, 1U, part);
    const std::string before = text_of(part);
    expect_refused([&] { make(small_campaign(runs), 1U, 1U, part); }, "is another part: runs 0 to 0");
    sil::CampaignSettings other = small_campaign(runs);
    other.seed = 8U;
    expect_refused([&] { make(other, 1U, 1U, folder.path() / "other.csv"); },
                   "`seed = 7` where now there is");
    EXPECT_NE(sil::campaign_fingerprint(other), sil::campaign_fingerprint(small_campaign(runs)));
    EXPECT_EQ(sil::campaign_fingerprint(small_campaign(9U)), sil::campaign_fingerprint(small_campaign(runs)))
        << "a campaign may grow";
    EXPECT_EQ(text_of(part), before);

    const ScratchFolder elsewhere;
    make(other, 1U, 1U, elsewhere.path() / "other.csv");
    std::filesystem::copy_file(elsewhere.path() / "other.csv", folder.path() / "other.csv");
    expect_refused([&] { sil::load_campaign_rows(folder.path()); }, "other.csv is of another campaign");
}

TEST(CampaignPart, StaysWithinTheCampaignAndItsFolder) {
    const ScratchFolder folder;
    const std::filesystem::path part = folder.path() / "part.csv";
    expect_refused([&] { make(small_campaign(runs), 5U, 2U, part); },
                   "runs 5 to 6 are not all of the campaign's 6");
    expect_refused([&] { make(small_campaign(runs), 6U, 1U, part); }, "--runs N");
    expect_refused([&] { make(small_campaign(runs), 0U, 0U, part); }, "--runs N");
    write_text(part, "time_s,speed_kmh\n");
    expect_refused([&] { make(small_campaign(runs), 0U, 1U, part); }, "no part of a campaign");
    EXPECT_EQ(text_of(part), "time_s,speed_kmh\n");

    const ScratchFolder single;
    sil::run_campaign(sil::CampaignWorld{small_campaign(1U)}, single.path(), 1U, never);
    expect_refused([&] { make(small_campaign(1U), 0U, 1U, single.path() / "part.csv"); },
                   "in one file, runs.csv");
    const ScratchFolder parts;
    make(small_campaign(1U), 0U, 1U, parts.path() / "part.csv");
    expect_refused(
        [&] { sil::run_campaign(sil::CampaignWorld{small_campaign(1U)}, parts.path(), 1U, never); },
        "holds parts");
}

class DamagedParts : public testing::Test {
 protected:
    DamagedParts() { make(small_campaign(runs), 0U, 3U, path("a.csv")); }
    std::filesystem::path path(const char* name) const { return folder_.path() / name; }
    void expect_no_report(const std::string& why) const {
        expect_refused([this] { sil::load_campaign_rows(folder_.path()); }, why);
    }

 private:
    ScratchFolder folder_;
};

TEST_F(DamagedParts, OfTheSameRunsAreRefused) {
    make(small_campaign(runs), 2U, 1U, path("b.csv"));
    expect_no_report("a.csv and " + path("b.csv").string() + " have the same runs");
}

TEST_F(DamagedParts, WithoutAllTheirRowsAreRefused) {
    const std::string text = text_of(path("a.csv"));
    write_text(path("a.csv"), text.substr(0U, text.rfind('\n', text.size() - 2U) + 1U));
    expect_no_report("has not the rows that its first line tells");
    write_text(path("a.csv"), text.substr(0U, text.find('\n') + 1U));
    expect_no_report("there are no rows");
    // The row of run 1 in place of that of run 2.
    const std::size_t third = text.rfind('\n', text.size() - 2U) + 1U;
    const std::size_t second = text.rfind('\n', third - 2U) + 1U;
    write_text(path("a.csv"), text.substr(0U, third) + text.substr(second, third - second));
    expect_no_report("has not the rows that its first line tells");
}

TEST_F(DamagedParts, WithAnAlteredRowAreRefused) {
    std::string text = text_of(path("a.csv"));
    text.replace(text.rfind("\n2,") + 1U, 1U, "02");
    write_text(path("a.csv"), text);
    expect_no_report("is not the fingerprint of this row");
}

TEST(PartHead, IsReadAsItIsWritten) {
    const sil::PartHead head{30U, 12U, "0123456789abcdef"};
    const std::optional<sil::PartHead> read = sil::part_head(head.line());
    ASSERT_TRUE(read);
    EXPECT_EQ(read->first, 30U);
    EXPECT_EQ(read->count, 12U);
    EXPECT_EQ(read->fingerprint, "0123456789abcdef");
    for (const char* other :
         {"", "run,vehicle", "# part of a campaign by rsi-sil: first x, count 1, fingerprint y",
          "# part of a campaign by rsi-sil: first 1, count 0, fingerprint y",
          "# part of a campaign by rsi-sil: first 1, count 2, fingerprint "}) {
        EXPECT_FALSE(sil::part_head(other)) << other;
    }
}

}  // namespace
}  // namespace campaign_part_test
