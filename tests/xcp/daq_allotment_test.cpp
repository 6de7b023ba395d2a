// Lists of measurements: allotted, written, cleared and released within bounds.
#include "tests/xcp/lists.hpp"

namespace testing_xcp {
namespace {

TEST_F(Lists, AreAllottedInOrderAndWithinBounds) {
    EXPECT_EQ(allot_parts(0U, 1U), error(0x22));
    EXPECT_EQ(allot_lists(5U), error(0x30));
    EXPECT_EQ(allot_lists(2U), good);
    EXPECT_EQ(allot_lists(2U), error(0x29));
    EXPECT_EQ(bench.command({0xDA}), (Bytes{0xFF, 0x93, 2, 0, 2, 0, 0, 0}));
    EXPECT_EQ(allot_entries(0U, 0U, 1U), error(0x22));
    EXPECT_EQ(allot_parts(0U, 21U), error(0x30));
    EXPECT_EQ(allot_parts(0U, 15U), good);
    EXPECT_EQ(allot_parts(0U, 1U), error(0x29));
    EXPECT_EQ(allot_parts(1U, 6U), error(0x30));
    EXPECT_EQ(allot_parts(2U, 1U), error(0x22));
    EXPECT_EQ(allot_parts(1U, 5U), good);
    EXPECT_EQ(allot_entries(2U, 0U, 1U), error(0x22));
    EXPECT_EQ(allot_entries(1U, 5U, 1U), error(0x22));
    EXPECT_EQ(allot_entries(0U, 0U, 8U), error(0x30));
    for (std::uint8_t part = 0U; part < 9U; ++part) {
        EXPECT_EQ(allot_entries(0U, part, 7U), good);
    }
    EXPECT_EQ(allot_entries(0U, 9U, 2U), error(0x30));
    EXPECT_EQ(allot_entries(0U, 9U, 1U), good);
    EXPECT_EQ(allot_entries(0U, 9U, 1U), error(0x29));
    EXPECT_EQ(allot_parts(1U, 1U), error(0x29));
    EXPECT_EQ(bench.command({0xD6}), good);
    EXPECT_EQ(allot_lists(4U), good);
    EXPECT_EQ(allot_parts(3U, 20U), good);
}

// A second allotment of one list, part or entry alone is as wrong as of many.
TEST_F(Lists, AreAllottedOnceEach) {
    ASSERT_EQ(allot_lists(1U), good);
    EXPECT_EQ(allot_lists(1U), error(0x29));
    ASSERT_EQ(allot_parts(0U, 1U), good);
    EXPECT_EQ(allot_parts(0U, 1U), error(0x29));
    ASSERT_EQ(allot_entries(0U, 0U, 1U), good);
    EXPECT_EQ(allot_entries(0U, 0U, 1U), error(0x29));
}

// Any number of a master: one too many, the first that no memory is kept for, the largest.
TEST_F(Lists, ThatThereAreNotAreRefusedByEveryCommand) {
    two_lists();
    for (const auto& [low, high] : {std::pair{2, 0}, std::pair{4, 0}, std::pair{0xFF, 0xFF}}) {
        const auto about = [&, list = Bytes{static_cast<std::uint8_t>(low), static_cast<std::uint8_t>(high)}](
                               int code, int mode, const Bytes& rest) {
            Bytes bytes{static_cast<std::uint8_t>(code), static_cast<std::uint8_t>(mode)};
            bytes.insert(bytes.end(), list.begin(), list.end());
            bytes.insert(bytes.end(), rest.begin(), rest.end());
            return bench.command(bytes);
        };
        EXPECT_EQ(about(0xE3, 0, {}), error(0x22)) << low;            // CLEAR_DAQ_LIST
        EXPECT_EQ(about(0xE2, 0, {0, 0}), error(0x22)) << low;        // SET_DAQ_PTR
        EXPECT_EQ(about(0xE0, 0, {0, 0, 1, 0}), error(0x22)) << low;  // SET_DAQ_LIST_MODE
        EXPECT_EQ(about(0xDF, 0, {}), error(0x22)) << low;            // GET_DAQ_LIST_MODE
        for (const int mode : {0, 1, 2}) {
            EXPECT_EQ(about(0xDE, mode, {}), error(0x22)) << low;  // START_STOP_DAQ_LIST
        }
        EXPECT_EQ(about(0xD4, 0, {1}), error(0x22)) << low;     // ALLOC_ODT
        EXPECT_EQ(about(0xD3, 0, {0, 1}), error(0x22)) << low;  // ALLOC_ODT_ENTRY
    }
}

TEST_F(Lists, AreWrittenWithWhatMayBeRead) {
    two_lists();
    EXPECT_EQ(write(map::outputs_at, 4U), error(0x29));  // behind the last entry
    EXPECT_EQ(point_to(2U, 0U, 0U), error(0x22));
    EXPECT_EQ(point_to(0U, 1U, 0U), error(0x22));
    EXPECT_EQ(point_to(0U, 0U, 1U), error(0x22));
    EXPECT_EQ(point_to(0U, 0U, 0U), good);
    EXPECT_EQ(write(map::outputs_at, 0U), error(0x24));
    EXPECT_EQ(write(map::outputs_at, 8U), error(0x24));
    EXPECT_EQ(write(map::outputs_at - 1U, 1U), error(0x24));
    EXPECT_EQ(write(map::outputs_at | 0x01000000U, 4U), error(0x24));
    EXPECT_EQ(bench.command(Bench::with_word({0xE1, 0x00, 4, 0}, map::outputs_at)), error(0x22));
    EXPECT_EQ(bench.command(Bench::with_word({0xE1, 0xFF, 4, 1}, map::outputs_at)), error(0x22));
    EXPECT_EQ(write(map::outputs_at, 7U), good);
}

TEST_F(Lists, HaveNoMoreBytesInAPartThanAFrame) {
    ASSERT_EQ(allot_lists(1U), good);
    ASSERT_EQ(allot_parts(0U, 1U), good);
    ASSERT_EQ(allot_entries(0U, 0U, 2U), good);
    ASSERT_EQ(point_to(0U, 0U, 0U), good);
    EXPECT_EQ(write(map::outputs_at, 4U), good);
    EXPECT_EQ(write(map::outputs_at, 4U), error(0x2A));
    EXPECT_EQ(set_mode(0U, 0U), good);
    EXPECT_EQ(start(0U), error(0x2A));  // an entry is still empty
    EXPECT_EQ(write(map::outputs_at, 3U), good);
    EXPECT_EQ(set_mode(0U, with_time), good);
    EXPECT_EQ(start(0U), error(0x2A));  // no room for the time
    EXPECT_EQ(set_mode(0U, 0U), good);
    EXPECT_EQ(start(0U), (Bytes{0xFF, 0}));
}

// In a later part, whose bytes nothing counts at the start. Data that does not fit is not kept.
TEST_F(Lists, KeepNoEntryThatDoesNotFit) {
    ASSERT_EQ(allot_lists(1U), good);
    ASSERT_EQ(allot_parts(0U, 2U), good);
    ASSERT_EQ(allot_entries(0U, 0U, 1U), good);
    ASSERT_EQ(allot_entries(0U, 1U, 2U), good);
    ASSERT_EQ(point_to(0U, 0U, 0U), good);
    ASSERT_EQ(write(map::epk_at, 4U), good);
    ASSERT_EQ(point_to(0U, 1U, 0U), good);
    ASSERT_EQ(write(map::epk_at, 4U), good);
    EXPECT_EQ(write(map::epk_at, 4U), error(0x2A));
    EXPECT_EQ(start(0U), error(0x2A));
    EXPECT_EQ(write(map::epk_at + 4U, 3U), good);
    EXPECT_EQ(start(0U), (Bytes{0xFF, 0}));
    EXPECT_EQ(bench.samples.at(1U).size(), 8U);
}

// A pointer that is refused leaves the one before, with the bytes of its own part.
TEST_F(Lists, AreWrittenWhereTheLastGoodPointerWas) {
    ASSERT_EQ(allot_lists(1U), good);
    ASSERT_EQ(allot_parts(0U, 2U), good);
    ASSERT_EQ(allot_entries(0U, 0U, 2U), good);
    ASSERT_EQ(allot_entries(0U, 1U, 1U), good);
    ASSERT_EQ(point_to(0U, 0U, 0U), good);
    ASSERT_EQ(write(map::epk_at, 4U), good);
    EXPECT_EQ(point_to(0U, 1U, 1U), error(0x22));
    EXPECT_EQ(write(map::epk_at, 4U), error(0x2A));
    EXPECT_EQ(write(map::epk_at + 4U, 3U), good);
}

// Beside the time a first part has room for five bytes.
TEST_F(Lists, HaveRoomForFiveBytesBesideTheTime) {
    ASSERT_EQ(allot_lists(1U), good);
    ASSERT_EQ(allot_parts(0U, 1U), good);
    ASSERT_EQ(allot_entries(0U, 0U, 1U), good);
    ASSERT_EQ(set_mode(0U, with_time), good);
    ASSERT_EQ(point_to(0U, 0U, 0U), good);
    ASSERT_EQ(write(map::epk_at, 6U), good);
    EXPECT_EQ(start(0U), error(0x2A));
    ASSERT_EQ(point_to(0U, 0U, 0U), good);
    ASSERT_EQ(write(map::epk_at, 5U), good);
    EXPECT_EQ(start(0U), (Bytes{0xFF, 0}));
    const Bytes sample = bench.samples.at(0U);
    ASSERT_EQ(sample.size(), 8U);
    EXPECT_EQ((Bytes{sample.begin() + 3, sample.end()}), bench.upload(map::epk_at, 5U));
}

// The first of two entries is empty, and so is a whole part.
TEST_F(Lists, DoNotStartWithAnEmptyEntry) {
    ASSERT_EQ(allot_lists(1U), good);
    ASSERT_EQ(allot_parts(0U, 2U), good);
    ASSERT_EQ(allot_entries(0U, 0U, 2U), good);
    ASSERT_EQ(allot_entries(0U, 1U, 1U), good);
    // From the last to the first: those behind an empty one do not make up for it.
    for (const auto& [part, entry] : {std::pair{1, 0}, std::pair{0, 1}, std::pair{0, 0}}) {
        EXPECT_EQ(start(0U), error(0x2A)) << part << entry;
        ASSERT_EQ(point_to(0U, static_cast<std::uint8_t>(part), static_cast<std::uint8_t>(entry)), good);
        ASSERT_EQ(write(map::outputs_at, 1U), good);
    }
    EXPECT_EQ(start(0U), (Bytes{0xFF, 0}));
    EXPECT_EQ(bench.samples.size(), 2U);
}

// A master that starts a list while the pointer is within it writes no more into it.
TEST_F(Lists, AreNotWrittenOnceTheyRun) {
    ASSERT_EQ(allot_lists(1U), good);
    ASSERT_EQ(allot_parts(0U, 1U), good);
    ASSERT_EQ(allot_entries(0U, 0U, 2U), good);
    ASSERT_EQ(point_to(0U, 0U, 0U), good);
    ASSERT_EQ(write(map::epk_at, 1U), good);
    ASSERT_EQ(write(map::epk_at + 1U, 2U), good);
    ASSERT_EQ(point_to(0U, 0U, 1U), good);
    ASSERT_EQ(start(0U), (Bytes{0xFF, 0}));
    EXPECT_EQ(write(map::epk_at + 4U, 2U), error(0x29));
    EXPECT_EQ(bench.samples, std::vector<Bytes>{(Bytes{0, 'r', 's', 'i'})});
}

TEST_F(Lists, HaveAModeThatIsTold) {
    two_lists();
    EXPECT_EQ(set_mode(2U, 0U), error(0x22));
    EXPECT_EQ(set_mode(0U, 0U, 2U), error(0x22));
    EXPECT_EQ(set_mode(0U, 0U, 0U, 0U), error(0x22));
    EXPECT_EQ(set_mode(0U, 0x02U), error(0x27));  // stimulation
    EXPECT_EQ(set_mode(0U, 0x20U), error(0x27));  // without the part's number
    EXPECT_EQ(set_mode(1U, with_time, 1U, 3U), good);
    EXPECT_EQ(bench.command({0xDF, 0, 1, 0}), (Bytes{0xFF, 0x10, 0, 0, 1, 0, 3, 0}));
    EXPECT_EQ(select(1U), (Bytes{0xFF, 1}));
    EXPECT_EQ(bench.command({0xDF, 0, 1, 0}), (Bytes{0xFF, 0x11, 0, 0, 1, 0, 3, 0}));
    EXPECT_EQ(bench.command({0xDD, 1}), good);
    EXPECT_EQ(bench.command({0xDF, 0, 1, 0}), (Bytes{0xFF, 0x50, 0, 0, 1, 0, 3, 0}));
    EXPECT_EQ(bench.command({0xDF, 0, 2, 0}), error(0x22));
    EXPECT_EQ(set_mode(1U, 0U), error(0x11));
    EXPECT_EQ(point_to(1U, 0U, 0U), error(0x11));
    EXPECT_EQ(bench.command({0xFD}), (Bytes{0xFF, 0x40, 0, 0, 0, 0}));
}

TEST_F(Lists, AreClearedWhileTheyRun) {
    two_lists();
    ASSERT_EQ(start(0U), (Bytes{0xFF, 0}));
    EXPECT_EQ(bench.command({0xE3, 0, 2, 0}), error(0x22));
    EXPECT_EQ(bench.command({0xE3, 0, 0, 0}), good);
    EXPECT_TRUE(bench.samples.empty());
    EXPECT_EQ(start(0U), error(0x2A));
    ASSERT_EQ(point_to(0U, 0U, 0U), good);
    ASSERT_EQ(write(map::epk_at, 3U), good);
    ASSERT_EQ(start(0U), (Bytes{0xFF, 0}));
    EXPECT_EQ(bench.samples, std::vector<Bytes>{(Bytes{0, 'r', 's', 'i'})});
    // Nothing is written into a list that runs, wherever the pointer stood.
    EXPECT_EQ(write(map::outputs_at, 4U), error(0x29));
    EXPECT_EQ(start(0U), (Bytes{0xFF, 0}));  // once more: it goes on
    EXPECT_EQ(bench.samples.size(), 1U);
}

// Nothing of what was allotted, written or set is left.
TEST_F(Lists, AreReleasedWhole) {
    two_lists();
    ASSERT_EQ(set_mode(1U, with_time, 1U, 3U), good);
    select(1U);
    ASSERT_EQ(start(0U), (Bytes{0xFF, 0}));
    ASSERT_EQ(point_to(1U, 0U, 0U), good);
    ASSERT_EQ(bench.command({0xD6}), good);
    EXPECT_TRUE(bench.samples.empty());
    EXPECT_EQ(bench.command({0xFD}), (Bytes{0xFF, 0x00, 0, 0, 0, 0}));
    EXPECT_EQ(write(map::outputs_at, 4U), error(0x29));
    ASSERT_EQ(allot_lists(2U), good);
    EXPECT_EQ(bench.command({0xDF, 0, 1, 0}), (Bytes{0xFF, 0, 0, 0, 0, 0, 1, 0}));
    ASSERT_EQ(allot_parts(0U, 1U), good);
    ASSERT_EQ(allot_entries(0U, 0U, 1U), good);
    EXPECT_EQ(start(0U), error(0x2A));            // the entry is empty
    EXPECT_EQ(allot_parts(1U, 1U), error(0x29));  // behind entries
    // Nor where the very first entry would be written next.
    two_lists();
    ASSERT_EQ(point_to(0U, 0U, 0U), good);
    ASSERT_EQ(bench.command({0xD6}), good);
    EXPECT_EQ(write(map::outputs_at, 4U), error(0x29));
}

// Both parts with two entries each; the other list keeps its own.
TEST_F(Lists, AreClearedWholeAndAlone) {
    ASSERT_EQ(allot_lists(2U), good);
    ASSERT_EQ(allot_parts(0U, 2U), good);
    ASSERT_EQ(allot_parts(1U, 1U), good);
    for (const auto& [list, part] : {std::pair{0, 0}, std::pair{0, 1}, std::pair{1, 0}}) {
        ASSERT_EQ(allot_entries(static_cast<std::uint8_t>(list), static_cast<std::uint8_t>(part), 2U), good);
    }
    const auto fill = [&](std::uint8_t list, std::uint8_t part) {
        ASSERT_EQ(point_to(list, part, 0U), good);
        ASSERT_EQ(write(map::epk_at, 1U), good);
        ASSERT_EQ(write(map::epk_at + 1U, 2U), good);
    };
    fill(0U, 0U);
    fill(0U, 1U);
    fill(1U, 0U);
    select(0U);
    ASSERT_EQ(bench.command({0xE3, 0, 0, 0}), good);
    EXPECT_EQ(bench.command({0xDF, 0, 0, 0}).at(1U), 0U);  // selected no longer
    ASSERT_EQ(start(1U), (Bytes{0xFF, 2}));
    EXPECT_EQ(bench.samples, std::vector<Bytes>{(Bytes{2, 'r', 's', 'i'})});
    stop(1U);
    // Every entry is empty: filled one by one, the list starts with the last.
    for (const auto& [part, entry] : {std::pair{0, 0}, std::pair{0, 1}, std::pair{1, 0}, std::pair{1, 1}}) {
        EXPECT_EQ(start(0U), error(0x2A)) << part << entry;
        ASSERT_EQ(point_to(0U, static_cast<std::uint8_t>(part), static_cast<std::uint8_t>(entry)), good);
        ASSERT_EQ(write(map::epk_at, 1U), good);
    }
    EXPECT_EQ(start(0U), (Bytes{0xFF, 0}));
}

TEST_F(Lists, WithoutPartsDoNotStart) {
    ASSERT_EQ(allot_lists(1U), good);
    EXPECT_EQ(start(0U), error(0x2A));
}

}  // namespace
}  // namespace testing_xcp
