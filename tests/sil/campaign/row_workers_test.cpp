// Row workers: what is missing is made once, whatever the threads, the stops and the failures.
#include "sil/studies/campaign/row_workers.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <mutex>
#include <optional>
#include <stdexcept>
#include <thread>
#include <vector>

#include "tests/support/scratch_folder.hpp"

namespace row_workers_test {
namespace {

using test_support::text_of;
using testing::ElementsAre;
using testing::UnorderedElementsAre;

const std::atomic<bool> never{false};

sil::MadeRow row_of(std::uint64_t number) {
    return {std::to_string(number) + ",made", 0.5};
}

class RowWorkers : public testing::Test {
 protected:
    std::filesystem::path path() const { return folder_.path() / "rows.csv"; }
    void begin_with(const std::string& rows) const { test_support::write_text(path(), "row,value\n" + rows); }
    sil::RowProgress make(const sil::RowWork& work, const std::atomic<bool>& stop = never,
                          const sil::RowListener& listener = {}) const {
        sil::RowFile file{path(), "row,value"};
        return sil::make_rows(file, work, stop, listener);
    }

 private:
    test_support::ScratchFolder folder_;
};

TEST_F(RowWorkers, MakeWhatIsMissingAndSortTheFile) {
    begin_with("3,kept\n1,kept\n");
    std::mutex mutex;
    std::vector<std::uint64_t> made;
    const sil::RowProgress progress = make({5U, 3U, [&](std::uint64_t number) {
                                                const std::lock_guard<std::mutex> lock{mutex};
                                                made.push_back(number);
                                                return row_of(number);
                                            }});
    EXPECT_THAT(made, UnorderedElementsAre(0U, 2U, 4U));
    EXPECT_EQ(text_of(path()), "row,value\n0,made\n1,kept\n2,made\n3,kept\n4,made\n");
    EXPECT_EQ(progress.total, 5U);
    EXPECT_EQ(progress.begun_with, 2U);
    EXPECT_EQ(progress.finished, 5U);
    EXPECT_EQ(progress.simulated_s, 1.5);
    EXPECT_GT(progress.elapsed_s, 0.0);
}

TEST_F(RowWorkers, MakeLinesInTheirOrderWithoutAFile) {
    std::vector<std::string> lines;
    const sil::RowProgress progress = sil::make_lines(lines, 7U, {3U, 3U, row_of}, never, {});
    EXPECT_THAT(lines, ElementsAre("7,made", "8,made", "9,made"));
    EXPECT_EQ(progress.finished, 3U);
    EXPECT_EQ(progress.total, 3U);
    EXPECT_FALSE(std::filesystem::exists(path()));
    const std::atomic<bool> stopped{true};
    EXPECT_EQ(sil::make_lines(lines, 7U, {3U, 1U, row_of}, stopped, {}).finished, 0U);
    EXPECT_THAT(lines, ElementsAre("", "", ""));
}

TEST_F(RowWorkers, TellEachFinishedRow) {
    begin_with("1,kept\n");
    std::vector<std::uint64_t> finished;
    make({4U, 1U, row_of}, never,
         [&](const sil::RowProgress& progress) { finished.push_back(progress.finished); });
    EXPECT_THAT(finished, ElementsAre(2U, 3U, 4U));
}

TEST_F(RowWorkers, KeepWhatIsFinishedWhenTheyAreStopped) {
    begin_with("3,kept\n");
    std::atomic<bool> stop{false};
    const sil::RowProgress progress =
        make({9U, 1U, row_of}, stop, [&stop](const sil::RowProgress& now) { stop = now.finished == 3U; });
    EXPECT_EQ(progress.finished, 3U);
    EXPECT_EQ(text_of(path()), "row,value\n3,kept\n0,made\n1,made\n");
}

// Set when the thread that it is of has ended.
struct EndOfThread {
    std::atomic<bool>* has_come{nullptr};
    ~EndOfThread() {
        if (has_come != nullptr) {
            *has_come = true;
        }
    }
};

// The first row fails only when the thread of the second has ended after its failure.
TEST_F(RowWorkers, OfSeveralFailuresTheFirstIsToldAndNothingMoreIsBegun) {
    std::atomic<int> begun{0};
    std::atomic<bool> second_has_ended{false};
    const auto make_none = [&](std::uint64_t number) -> sil::MadeRow {
        ++begun;
        if (number == 1U) {
            thread_local EndOfThread end;
            end.has_come = &second_has_ended;
            throw std::runtime_error("the second");
        }
        while (!second_has_ended) {
            std::this_thread::yield();
        }
        throw std::runtime_error("another");
    };
    try {
        make({9U, 2U, make_none});
        FAIL() << "nothing failed";
    } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(), "the second");
    }
    EXPECT_EQ(begun, 2);
    EXPECT_EQ(text_of(path()), "row,value\n");
}

TEST_F(RowWorkers, KeepWhatIsFinishedBeforeAFailure) {
    EXPECT_THROW(make({9U, 1U,
                       [](std::uint64_t number) {
                           if (number == 2U) {
                               throw std::runtime_error("no");
                           }
                           return row_of(number);
                       }}),
                 std::runtime_error);
    EXPECT_EQ(text_of(path()), "row,value\n0,made\n1,made\n");
}

TEST_F(RowWorkers, MakeRowsTogetherOnceEach) {
    begin_with("1,kept\n");
    sil::RowWork work{6U, 2U};
    work.make_together = [](const sil::NextRow& next, const sil::RowTaker& take) {
        std::vector<std::uint64_t> numbers;
        while (const std::optional<std::uint64_t> number = next()) {
            numbers.push_back(*number);
        }
        for (const std::uint64_t number : numbers) {
            EXPECT_TRUE(take(number, row_of(number)));
        }
    };
    EXPECT_EQ(make(work).finished, 6U);
    EXPECT_EQ(text_of(path()), "row,value\n0,made\n1,kept\n2,made\n3,made\n4,made\n5,made\n");
}

TEST_F(RowWorkers, GiveNoMoreNumbersOnceTheyAreStoppedOrHaveFailed) {
    std::atomic<bool> stop{false};
    sil::RowWork work{9U, 1U};
    work.make_together = [&stop](const sil::NextRow& next, const sil::RowTaker& take) {
        const std::uint64_t first = next().value();
        stop = true;
        EXPECT_EQ(next(), std::nullopt);
        EXPECT_FALSE(take(first, row_of(first)));
        throw std::runtime_error("no");
    };
    EXPECT_THROW(make(work, stop), std::runtime_error);
    EXPECT_EQ(text_of(path()), "row,value\n0,made\n");
}

}  // namespace
}  // namespace row_workers_test
