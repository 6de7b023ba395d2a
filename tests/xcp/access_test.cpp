// Without the key nothing is changed and no list is sent.
#include <gtest/gtest.h>

#include "tests/xcp/bench.hpp"

namespace testing_xcp {
namespace {

const Bytes locked{0xFE, 0x25};

TEST(Key, IsWantedByEveryCommandThatChangesSomething) {
    Bench bench;
    bench.connect();
    for (const int code :
         {0xF0, 0xF9, 0xEB, 0xE6, 0xE4, 0xE3, 0xE2, 0xE1, 0xE0, 0xDE, 0xDD, 0xD6, 0xD5, 0xD4, 0xD3}) {
        EXPECT_EQ(bench.command({static_cast<std::uint8_t>(code), 0, 0, 0, 0, 0, 0, 0}), locked)
            << std::hex << code;
    }
    EXPECT_EQ(bench.command({0xFD}), (Bytes{0xFF, 0, 0x05, 0, 0, 0}));
}

TEST(Key, UnlocksBothResources) {
    Bench bench;
    bench.connect();
    EXPECT_EQ(bench.unlock(), (Bytes{0xFF, 0x00}));
    EXPECT_EQ(bench.command({0xFD}), (Bytes{0xFF, 0, 0x00, 0, 0, 0}));
    EXPECT_EQ(bench.command({0xF8, 0, 0x04}), (Bytes{0xFF, 0}));  // nothing is left to be unlocked
    EXPECT_TRUE(Bench::is_good(bench.command({0xD6})));
}

TEST(Key, ThatIsWrongEndsTheSession) {
    Bench bench;
    bench.connect();
    EXPECT_EQ(bench.unlock(false), locked);
    EXPECT_EQ(bench.command({0xFD}), Bytes{});
    bench.connect();
    EXPECT_EQ(bench.command({0xF0, 1, 0}), locked);
    EXPECT_EQ(bench.unlock(), (Bytes{0xFF, 0x00}));
}

// After wrong keys a delay; the cycles count the delay down without a connection, too.
TEST(Key, IsNotAskedForWhileTheDelayRuns) {
    Bench bench;
    for (int attempt = 0; attempt < 3; ++attempt) {
        bench.connect();
        ASSERT_EQ(bench.unlock(false), locked);
    }
    bench.connect();
    EXPECT_EQ(bench.command({0xF8, 0, 0x01}), (Bytes{0xFE, 0x33}));
    bench.command({0xFE});
    bench.cycles(1100);
    bench.connect();
    EXPECT_EQ(bench.unlock(), (Bytes{0xFF, 0x00}));
}

TEST(Key, NeedsRandomNumbers) {
    Bench bench;
    bench.random.is_empty = true;
    bench.connect();
    EXPECT_EQ(bench.command({0xF8, 0, 0x01}), (Bytes{0xFE, 0x33}));
}

TEST(Key, CannotBeGivenOutOfOrder) {
    Bench bench;
    bench.connect();
    EXPECT_EQ(bench.command({0xF8, 0, 0x10}), (Bytes{0xFE, 0x22}));
    EXPECT_EQ(bench.command({0xF8, 1, 0x01}), (Bytes{0xFE, 0x29}));
    EXPECT_EQ(bench.command({0xF7, 15, 0, 0, 0, 0, 0, 0}), (Bytes{0xFE, 0x29}));
    EXPECT_EQ(bench.command({0xF7, 16, 0, 0, 0, 0, 0}), (Bytes{0xFE, 0x29}));
    // Without a seed.
    EXPECT_EQ(bench.command({0xF7, 16, 0, 0, 0, 0, 0, 0}), (Bytes{0xFF, 0x05}));
    EXPECT_EQ(bench.command({0xF7, 10, 0, 0, 0, 0, 0, 0}), (Bytes{0xFF, 0x05}));
    EXPECT_EQ(bench.command({0xF7, 4, 0, 0, 0, 0}), (Bytes{0xFE, 0x29}));
    EXPECT_EQ(bench.unlock(), (Bytes{0xFF, 0x00})) << "and the connection is still there";
}

TEST(Key, BegunAndBrokenOffIsBegunAnew) {
    Bench bench;
    bench.connect();
    // By another length, by another seed, by another session.
    EXPECT_EQ(bench.command({0xF7, 16, 0, 0, 0, 0, 0, 0}), (Bytes{0xFF, 0x05}));
    EXPECT_EQ(bench.command({0xF7, 9, 0, 0, 0, 0, 0, 0}), (Bytes{0xFE, 0x29}));
    EXPECT_EQ(bench.command({0xF7, 10, 0, 0, 0, 0, 0, 0}), (Bytes{0xFE, 0x29}));
    EXPECT_EQ(bench.command({0xF7, 16, 0, 0, 0, 0, 0, 0}), (Bytes{0xFF, 0x05}));
    EXPECT_EQ(bench.unlock(), (Bytes{0xFF, 0x00}));
    bench.connect();
    EXPECT_EQ(bench.command({0xF7, 16, 0, 0, 0, 0, 0, 0}), (Bytes{0xFF, 0x05}));
    EXPECT_EQ(bench.command({0xF8, 0, 0x01}).at(1U), 16U);
    bench.connect();
    EXPECT_EQ(bench.command({0xF8, 1, 0x01}), (Bytes{0xFE, 0x29}));
    EXPECT_EQ(bench.command({0xF7, 10, 0, 0, 0, 0, 0, 0}), (Bytes{0xFE, 0x29}));
    EXPECT_EQ(bench.command({0xF7, 16, 0, 0, 0, 0, 0, 0}), (Bytes{0xFF, 0x05}));
    bench.connect();
    EXPECT_EQ(bench.command({0xF7, 10, 0, 0, 0, 0, 0, 0}), (Bytes{0xFE, 0x29}));
    EXPECT_EQ(bench.unlock(), (Bytes{0xFF, 0x00}));
}

// If none can be given, the rest of the one before is not given out either.
TEST(Key, HasNoSeedLeftWhenAnotherCannotBeHad) {
    Bench bench;
    bench.connect();
    ASSERT_EQ(bench.command({0xF8, 0, 0x01}).at(1U), 16U);
    bench.random.is_empty = true;
    EXPECT_EQ(bench.command({0xF8, 0, 0x01}), (Bytes{0xFE, 0x33}));
    EXPECT_EQ(bench.command({0xF8, 1, 0x01}), (Bytes{0xFE, 0x29}));
}

TEST(Key, WhoseSeedIsAskedForInUnlockedStateHasNone) {
    Bench bench;
    bench.connect();
    EXPECT_EQ(bench.command({0xF8, 0, 0x01}).at(1U), 16U);
    EXPECT_EQ(bench.unlock(), (Bytes{0xFF, 0x00}));
    EXPECT_EQ(bench.command({0xF8, 0, 0x01}), (Bytes{0xFF, 0}));
    EXPECT_EQ(bench.command({0xF8, 1, 0x01}), (Bytes{0xFE, 0x29}));
}

// A second one in the same session belongs to no seed.
TEST(Key, IsOfUseOnce) {
    Bench bench;
    bench.connect_and_unlock();
    EXPECT_EQ(bench.command({0xF7, 16, 0, 0, 0, 0, 0, 0}), (Bytes{0xFF, 0x00}));
    EXPECT_EQ(bench.command({0xF7, 10, 0, 0, 0, 0, 0, 0}), (Bytes{0xFF, 0x00}));
    EXPECT_EQ(bench.command({0xF7, 4, 0, 0, 0, 0}), (Bytes{0xFE, 0x29}));
}

TEST(Key, IsForgottenByAnotherSession) {
    Bench bench;
    bench.connect_and_unlock();
    bench.connect();
    EXPECT_EQ(bench.command({0xD6}), locked);
    bench.connect_and_unlock();
    bench.command({0xFE});
    bench.connect();
    EXPECT_EQ(bench.command({0xD6}), locked);
}

}  // namespace
}  // namespace testing_xcp
