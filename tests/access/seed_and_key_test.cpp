// Seed and key: the key unlocks once, wrong ones cost more and more time, and nothing gives an attempt back.
#include "rsi/ecu/access/seed_and_key.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <set>

#include "hal/software_keys/software_keys.hpp"
#include "rsi/ecu/access/same_code.hpp"
#include "rsi/ecu/access/stored_count.hpp"
#include "tests/access/cut_storage.hpp"

namespace testing_access {
namespace {

using rsi::access::Block;
using rsi::access::KeyAnswer;
using rsi::access::SeedAndKey;
using rsi_test::CutStorage;

// Other numbers each time, as far as a test can tell.
class CountingRandom final : public rsi::hal::RandomSource {
 public:
    bool fill(std::uint8_t* bytes, std::size_t length) noexcept override {
        ++calls_;
        std::fill_n(bytes, length, static_cast<std::uint8_t>(calls_ & 0xFFU));
        return !is_empty;
    }
    bool is_empty{false};

 private:
    unsigned calls_{0U};
};

class SilentKeys final : public rsi::hal::KeyStore {
 public:
    bool authenticate(rsi::hal::KeySlot, const std::uint8_t*, std::size_t,
                      rsi::hal::AuthenticationCode& code) noexcept override {
        code.fill(0U);
        return false;
    }
    bool has_test_keys() const noexcept override { return false; }
};

// Wrong keys in a row and the cycles of 10 ms until the next seed: 10 s after the third, then twice as long.
constexpr int delays[]{0, 0, 0, 1000, 2000, 4000, 8000, 16000, 32000, 64000, 64000, 64000};
constexpr int longest_delay = 64000;

class Access : public ::testing::Test {
 protected:
    Access() { restart(); }

    void restart() {
        lock_.emplace(keys_, rsi::hal::KeySlot::diagnosis, random_, storage_);
        lock_->start();
    }
    Block seed() {
        Block seed{};
        EXPECT_TRUE(lock_->give_seed(seed));
        return seed;
    }
    Block key_for(const Block& seed, rsi::hal::KeySlot slot = rsi::hal::KeySlot::diagnosis) {
        Block key{};
        EXPECT_TRUE(keys_.authenticate(slot, seed.data(), seed.size(), key));
        return key;
    }
    KeyAnswer give_wrong_key() {
        Block key = key_for(seed());
        key[15] ^= 1U;
        return lock_->take_key(key);
    }
    KeyAnswer give_good_key() { return lock_->take_key(key_for(seed())); }
    // Lets the delay pass; its length in cycles.
    int wait_for_seed() {
        Block seed{};
        int cycles = 0;
        while (!lock_->give_seed(seed) && cycles <= longest_delay) {
            lock_->end_cycle();
            ++cycles;
        }
        return cycles;
    }

    CountingRandom random_;
    CutStorage storage_;
    rsi::hal::SoftwareKeys keys_{rsi::hal::test_keys};
    std::optional<SeedAndKey> lock_;
};

TEST_F(Access, IsLockedUntilTheKeyOfTheSeedComes) {
    EXPECT_FALSE(lock_->is_unlocked());
    EXPECT_EQ(give_good_key(), KeyAnswer::unlocked);
    EXPECT_TRUE(lock_->is_unlocked());
    lock_->lock();
    EXPECT_FALSE(lock_->is_unlocked());
}

TEST_F(Access, GivesNoSeedBeforeItsStart) {
    SeedAndKey fresh{keys_, rsi::hal::KeySlot::diagnosis, random_, storage_};
    Block seed{};
    EXPECT_FALSE(fresh.is_unlocked());
    EXPECT_EQ(fresh.take_key(key_for(seed)), KeyAnswer::no_seed);
    EXPECT_FALSE(fresh.give_seed(seed));
    EXPECT_EQ(fresh.take_key(key_for(seed)), KeyAnswer::no_seed);
    fresh.start();
    EXPECT_TRUE(fresh.give_seed(seed));
}

TEST_F(Access, UsesASeedOnce) {
    const Block first = seed();
    const Block key = key_for(first);
    EXPECT_EQ(lock_->take_key(key), KeyAnswer::unlocked);
    EXPECT_EQ(lock_->take_key(key), KeyAnswer::no_seed);
    EXPECT_TRUE(lock_->is_unlocked());  // no attempt was made
    EXPECT_NE(seed(), first);
    EXPECT_EQ(lock_->take_key(key), KeyAnswer::wrong_key);
    EXPECT_FALSE(lock_->is_unlocked());
    EXPECT_EQ(lock_->take_key(key), KeyAnswer::no_seed);
}

TEST_F(Access, ForgetsASeedForWhichAnotherWasGivenOrThatWasLocked) {
    const Block first = seed();
    const Block second = seed();
    EXPECT_NE(first, second);
    EXPECT_EQ(lock_->take_key(key_for(first)), KeyAnswer::wrong_key);
    const Block third = seed();
    lock_->lock();
    EXPECT_EQ(lock_->take_key(key_for(third)), KeyAnswer::no_seed);
}

TEST_F(Access, TakesNoKeyOfAnotherSlot) {
    EXPECT_EQ(lock_->take_key(key_for(seed(), rsi::hal::KeySlot::calibration)), KeyAnswer::wrong_key);
    EXPECT_EQ(lock_->take_key(key_for(seed(), rsi::hal::KeySlot::parameters)), KeyAnswer::wrong_key);
    EXPECT_FALSE(lock_->is_unlocked());
}

TEST_F(Access, RefusesAKeyWithAnyBitFlipped) {
    for (std::size_t bit = 0U; bit < 128U; ++bit) {
        storage_.record().clear();
        restart();
        Block key = key_for(seed());
        key[bit / 8U] = static_cast<std::uint8_t>(key[bit / 8U] ^ (1U << (bit % 8U)));
        EXPECT_EQ(lock_->take_key(key), KeyAnswer::wrong_key) << bit;
        EXPECT_FALSE(lock_->is_unlocked()) << bit;
    }
}

TEST_F(Access, GivesNoSeedWithoutRandomNumbersAndLeavesTheBytesAlone) {
    const Block given_before = seed();
    random_.is_empty = true;
    Block untouched{};
    untouched.fill(0x5AU);
    Block bytes = untouched;
    EXPECT_FALSE(lock_->give_seed(bytes));
    EXPECT_EQ(bytes, untouched);
    EXPECT_EQ(lock_->take_key(key_for(given_before)), KeyAnswer::no_seed);
    random_.is_empty = false;
    EXPECT_EQ(give_good_key(), KeyAnswer::unlocked);
}

TEST_F(Access, GivesNoSeedWhereTheAttemptCannotBeStored) {
    storage_.refuse(true);
    Block bytes{};
    EXPECT_FALSE(lock_->give_seed(bytes));
    EXPECT_EQ(bytes, Block{});
    storage_.refuse(false);
    EXPECT_EQ(give_good_key(), KeyAnswer::unlocked);
}

// A code of zeros comes with the refusal: it must not be taken for the right one.
TEST_F(Access, StaysLockedWhenTheKeyStoreDoesNotAnswer) {
    SilentKeys silent;
    SeedAndKey other{silent, rsi::hal::KeySlot::diagnosis, random_, storage_};
    other.start();
    Block bytes{};
    ASSERT_TRUE(other.give_seed(bytes));
    EXPECT_EQ(other.take_key(Block{}), KeyAnswer::wrong_key);
    EXPECT_FALSE(other.is_unlocked());
}

TEST_F(Access, MakesWrongKeysWaitLongerEachTime) {
    int wrong_keys = 0;
    for (const int delay : delays) {
        EXPECT_EQ(wait_for_seed(), delay) << wrong_keys;
        const bool is_delayed =
            delays[std::min<std::size_t>(static_cast<std::size_t>(wrong_keys) + 1U, 11U)] > 0;
        EXPECT_EQ(give_wrong_key(), is_delayed ? KeyAnswer::too_many_attempts : KeyAnswer::wrong_key);
        ++wrong_keys;
    }
}

TEST_F(Access, HasNoDelayHoweverManyCyclesPassWithoutAWrongKey) {
    for (int cycle = 0; cycle < 10; ++cycle) {
        lock_->end_cycle();
    }
    EXPECT_EQ(wait_for_seed(), 0);
}

TEST_F(Access, GivesNoSeedWhileTheDelayRunsAndTakesNoKeyEither) {
    for (int attempt = 0; attempt < 3; ++attempt) {
        give_wrong_key();
    }
    Block bytes{};
    for (int cycle = 0; cycle < delays[3]; ++cycle) {
        ASSERT_FALSE(lock_->give_seed(bytes)) << cycle;
        ASSERT_EQ(lock_->take_key(key_for(bytes)), KeyAnswer::no_seed);
        lock_->end_cycle();
    }
    EXPECT_EQ(give_good_key(), KeyAnswer::unlocked);
}

TEST_F(Access, ForgivesWrongKeysAfterAGoodOne) {
    give_wrong_key();
    give_wrong_key();
    EXPECT_EQ(give_good_key(), KeyAnswer::unlocked);
    EXPECT_EQ(give_wrong_key(), KeyAnswer::wrong_key);
    EXPECT_EQ(give_wrong_key(), KeyAnswer::wrong_key);
    EXPECT_EQ(give_good_key(), KeyAnswer::unlocked);
    EXPECT_EQ(give_wrong_key(), KeyAnswer::wrong_key);
    restart();
    EXPECT_EQ(give_good_key(), KeyAnswer::unlocked);
    restart();
    EXPECT_EQ(give_wrong_key(), KeyAnswer::wrong_key);
    EXPECT_EQ(give_wrong_key(), KeyAnswer::wrong_key);
    EXPECT_EQ(give_wrong_key(), KeyAnswer::too_many_attempts);
}

TEST_F(Access, StartsItsDelayAnewAfterAReset) {
    for (std::size_t wrong_keys = 1U; wrong_keys < std::size(delays); ++wrong_keys) {
        give_wrong_key();
        for (int cycle = 0; cycle < delays[wrong_keys] / 2; ++cycle) {
            lock_->end_cycle();
        }
        restart();
        EXPECT_FALSE(lock_->is_unlocked());
        EXPECT_EQ(wait_for_seed(), delays[wrong_keys]);
    }
}

TEST_F(Access, IsStartedAnewWithNothingOfBefore) {
    give_wrong_key();
    EXPECT_EQ(give_good_key(), KeyAnswer::unlocked);
    give_wrong_key();
    give_wrong_key();
    EXPECT_EQ(give_wrong_key(), KeyAnswer::too_many_attempts);
    storage_.record().clear();  // another memory
    lock_->start();
    EXPECT_EQ(wait_for_seed(), 0);
    EXPECT_EQ(give_good_key(), KeyAnswer::unlocked);
    lock_->start();
    EXPECT_FALSE(lock_->is_unlocked());
}

TEST_F(Access, CountsAnAttemptThatAResetCutOff) {
    for (int attempt = 0; attempt < 3; ++attempt) {
        seed();
        restart();
    }
    EXPECT_EQ(wait_for_seed(), delays[3]);
}

// Seeds cost the memory nothing, so that requests for them do not wear it out.
TEST_F(Access, WritesOncePerAttempt) {
    for (int ask = 0; ask < 1000; ++ask) {
        seed();
    }
    EXPECT_EQ(storage_.writes(), 1);
    EXPECT_EQ(give_wrong_key(), KeyAnswer::wrong_key);
    EXPECT_EQ(storage_.writes(), 1);
    EXPECT_EQ(give_good_key(), KeyAnswer::unlocked);
    EXPECT_EQ(storage_.writes(), 3);
    EXPECT_EQ(give_good_key(), KeyAnswer::unlocked);
    EXPECT_EQ(storage_.writes(), 5);
}

TEST_F(Access, UnlocksAlsoWhereTheGoodKeyCannotBeStoredAndThenStaysStrict) {
    give_wrong_key();
    const Block key = key_for(seed());
    storage_.refuse(true);
    EXPECT_EQ(lock_->take_key(key), KeyAnswer::unlocked);
    EXPECT_TRUE(lock_->is_unlocked());
    storage_.refuse(false);
    restart();
    EXPECT_EQ(give_wrong_key(), KeyAnswer::too_many_attempts);  // the two before are still counted
}

// Each costs its storage two writes.
TEST_F(Access, IsUnlockedAHundredTimesInAStart) {
    for (std::uint32_t time = 0U; time < SeedAndKey::most_unlocks; ++time) {
        ASSERT_EQ(give_good_key(), KeyAnswer::unlocked) << time;
    }
    Block block{};
    EXPECT_FALSE(lock_->give_seed(block));
    EXPECT_FALSE(lock_->is_delayed());
    restart();
    EXPECT_EQ(give_good_key(), KeyAnswer::unlocked);
    lock_->start();
    EXPECT_EQ(give_good_key(), KeyAnswer::unlocked);
}

TEST_F(Access, TakesADamagedOrImpossibleCountForTheLargest) {
    give_wrong_key();
    storage_.record()[5] ^= 0x10U;
    restart();
    EXPECT_EQ(wait_for_seed(), longest_delay);
    for (const std::size_t length : {std::size_t{5U}, rsi::access::stored_count_length + 1U}) {
        storage_.record().resize(length);
        restart();
        EXPECT_EQ(wait_for_seed(), longest_delay) << length;
    }
    storage_.set_unreadable(true);
    restart();
    EXPECT_EQ(wait_for_seed(), longest_delay);
    storage_.set_unreadable(false);
    for (const std::uint32_t impossible : {10U, 0x80000000U, 0xFFFFFFFFU}) {
        ASSERT_TRUE(rsi::access::write_count(storage_, rsi::access::CountOf::wrong_keys, impossible));
        restart();
        EXPECT_EQ(wait_for_seed(), longest_delay);
    }
    EXPECT_EQ(give_good_key(), KeyAnswer::unlocked);
    restart();
    EXPECT_EQ(wait_for_seed(), 0);
}

// An attacker that guesses and cuts the power at any write, however much of it is done by then, finds after
// the start at least as many wrong keys counted as he has seen answered.
TEST_F(Access, GivesNoAttemptBackWhenThePowerGoesAtAnyWrite) {
    std::set<int> cut_at;
    for (int wrong_before = 0; wrong_before < 4; ++wrong_before) {
        for (int at_write = 1; at_write <= 4; ++at_write) {
            for (std::size_t bytes = 0U; bytes <= rsi::access::stored_count_length; ++bytes) {
                storage_.cut_power_at({0, 0U});
                storage_.record().clear();
                restart();
                storage_.cut_power_at({at_write, bytes});
                std::size_t answered = 0U;
                for (int attempt = 0; attempt < 4 && storage_.has_power(); ++attempt) {
                    wait_for_seed();
                    if (!storage_.has_power()) {
                        break;
                    }
                    const KeyAnswer answer = give_wrong_key();
                    answered += storage_.has_power() && answer != KeyAnswer::unlocked ? 1U : 0U;
                }
                cut_at.insert(storage_.has_power() ? 0 : at_write);
                storage_.cut_power_at({0, 0U});
                restart();
                ASSERT_GE(wait_for_seed(), delays[answered]) << at_write << ", " << bytes << " bytes";
            }
        }
    }
    EXPECT_EQ(cut_at, (std::set<int>{1, 2, 3, 4}));
}

TEST(CodesAreTheSame, OnlyWhenEachBitIs) {
    rsi::hal::AuthenticationCode code{};
    for (std::size_t byte = 0U; byte < code.size(); ++byte) {
        code[byte] = static_cast<std::uint8_t>(17U * byte + 3U);
    }
    EXPECT_TRUE(rsi::access::is_same_code(code, code));
    for (std::size_t bit = 0U; bit < 128U; ++bit) {
        rsi::hal::AuthenticationCode other = code;
        other[bit / 8U] = static_cast<std::uint8_t>(other[bit / 8U] ^ (1U << (bit % 8U)));
        EXPECT_FALSE(rsi::access::is_same_code(code, other)) << bit;
        EXPECT_FALSE(rsi::access::is_same_code(other, code)) << bit;
    }
}

}  // namespace
}  // namespace testing_access
