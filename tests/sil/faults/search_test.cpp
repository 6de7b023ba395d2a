// The random search: every scenario by its number alone, in any process and order.
#include "sil/studies/faults/fault_search.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "sil/studies/faults/search_report.hpp"

namespace faults_test {
namespace {

using sil::FaultKind;
using sil::FaultPlace;
using sil::FindingKind;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

sil::CampaignSettings settings(std::uint64_t seed) {
    std::filesystem::current_path(RSI_SOURCE_DIR);  // the settings name files from there
    sil::CampaignSettings settings = sil::load_campaign("sil/studies/faults/search.toml");
    settings.seed = seed;
    return settings;
}

TEST(FaultSearch, DrawsAScenarioByItsNumber) {
    const sil::FaultSearch forwards{settings(1U)};
    const sil::FaultSearch backwards{settings(1U)};
    const sil::FaultSearch other{settings(2U)};
    std::vector<std::string> first;
    for (std::uint64_t number = 0U; number < 60U; number += 7U) {
        first.push_back(forwards.explain(number));
    }
    std::size_t index = first.size();
    for (std::uint64_t number = 63U; number > 0U;) {
        number -= 7U;
        EXPECT_EQ(backwards.explain(number), first[--index]);
        EXPECT_NE(other.explain(number), first[index]);
    }
    EXPECT_EQ(std::set<std::string>(first.begin(), first.end()).size(), first.size());
}

TEST(FaultSearch, ReachesFaultsPlacesAndStates) {
    const sil::FaultSearch search{settings(3U)};
    std::set<FaultKind> kinds;
    std::set<FaultPlace> places;
    int due = 0;
    int told = 0;
    std::string all;
    constexpr std::uint64_t scenarios = 160U;
    for (std::uint64_t number = 0U; number < scenarios; ++number) {
        const sil::SearchOutcome outcome = search.run(number);
        EXPECT_EQ(outcome.number, number);
        kinds.insert(outcome.fault);
        places.insert(outcome.place);
        due += outcome.due ? 1 : 0;
        told += outcome.told ? 1 : 0;
        all += number % sil::FaultSearch::scenarios_a_drive == 0U ? search.explain(number) : "";
    }
    EXPECT_GT(kinds.size(), 18U);
    EXPECT_GT(places.size(), 12U);
    EXPECT_GT(due, 30);
    EXPECT_GT(told, 60);
    EXPECT_THAT(all, HasSubstr("slow-turns"));
    EXPECT_THAT(all, HasSubstr("j-turn-110"));
    EXPECT_THAT(all, HasSubstr("van"));
}

class FaultSearchFolder : public testing::Test {
 protected:
    void SetUp() override { std::filesystem::remove_all(folder); }
    void TearDown() override { std::filesystem::remove_all(folder); }

    const std::filesystem::path folder{std::filesystem::temp_directory_path() / "rsi_fault_search_test"};
};

TEST_F(FaultSearchFolder, HoldsWhatEachScenarioCameTo) {
    sil::CampaignSettings some = settings(1U);
    some.runs = 50U;
    const sil::FaultSearch search{some};
    const std::atomic<bool> stop{false};
    sil::run_fault_search(search, folder, 2U, stop, {});
    const std::vector<sil::SearchOutcome> read = sil::load_search(folder);
    ASSERT_EQ(read.size(), 50U);
    for (const sil::SearchOutcome& outcome : read) {
        const sil::SearchOutcome again = search.run(outcome.number);
        EXPECT_EQ(outcome.fault, again.fault);
        EXPECT_EQ(outcome.place, again.place);
        EXPECT_EQ(outcome.visible, again.visible);
        EXPECT_EQ(outcome.due, again.due);
        EXPECT_EQ(outcome.told, again.told);
        EXPECT_EQ(outcome.findings, again.findings);
    }
}

sil::SearchOutcome outcome(std::uint64_t number, FaultKind fault, FaultPlace place,
                           const std::vector<FindingKind>& findings) {
    return {number, fault, place, true, true, false, findings};
}

TEST(SearchReport, CountsTheFindingsByClass) {
    constexpr FaultPlace lateral = FaultPlace::lateral_acceleration;
    const sil::SearchReport report = sil::report_on(
        {outcome(3U, FaultKind::clock_jump, FaultPlace::processor, {FindingKind::false_warning}),
         outcome(4U, FaultKind::gain, lateral, {FindingKind::missed_warning}),
         outcome(5U, FaultKind::lost, lateral, {}),
         outcome(6U, FaultKind::gain, lateral, {FindingKind::missed_warning})},
        7U);
    EXPECT_EQ(report.scenarios, 4U);
    EXPECT_EQ(report.due, 4U);
    ASSERT_EQ(report.found.size(), 2U);
    EXPECT_THAT(report.found[0].scenarios, ElementsAre(4U, 6U));
    EXPECT_THAT(report.found[1].scenarios, ElementsAre(3U));
    EXPECT_THAT(sil::search_section(report),
                HasSubstr("| missed warning | gain | lateral acceleration | 2 | 4, 6 |"));
    EXPECT_THAT(sil::search_section(report), HasSubstr("4 scenarios, seed 7"));
    EXPECT_THAT(sil::unknown_findings(report),
                ElementsAre("false warning, clock jump of processor: scenarios 3"));
}

TEST(SearchReport, NamesWhatIsKnownBySearchesAndNoLongerFound) {
    const std::vector<std::string> all = sil::vanished_findings({});
    for (const sil::KnownFinding& known : sil::known_findings()) {
        if (known.cells.empty()) {
            EXPECT_THAT(all, testing::Contains(describe(known.found)));
            sil::SearchReport report;
            report.found.push_back({known.found, {1U}});
            EXPECT_THAT(sil::vanished_findings({report}), Not(testing::Contains(describe(known.found))));
        } else {
            EXPECT_THAT(all, Not(testing::Contains(describe(known.found))));
        }
    }
}

}  // namespace
}  // namespace faults_test
