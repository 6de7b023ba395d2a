// An index of a history that memory has changed: nothing beyond the history is read or written, and the check
// goes on.
#include <gtest/gtest.h>

#include <cstddef>

#include "rsi/ecu/monitoring/parameter_guard.hpp"
#include "rsi/ecu/monitoring/roll_consistency.hpp"
#include "tests/support/memory_damage.hpp"

namespace {

using rsi::monitoring::RollConsistency;

void update(RollConsistency& consistency, int samples) {
    for (int sample = 0; sample < samples; ++sample) {
        consistency.update(0.0F, 0.0F, 0.0F);
    }
}

// For any changed bit of it; if it is the index and now beyond the history, the history begins anew.
TEST(ADamagedIndex, OfTheRollConsistencyBeginsTheHistoryAnew) {
    constexpr int whole_history = 130;
    RollConsistency sound;
    update(sound, whole_history);
    std::size_t begun_anew = 0U;
    for (std::size_t byte = 0U; byte < sizeof sound; ++byte) {
        for (unsigned bit = 0U; bit < 8U; ++bit) {
            rsi_test::Fenced<RollConsistency> fenced;
            fenced.object = sound;
            rsi_test::flip(fenced.object, byte, bit);
            update(fenced.object, 1);
            begun_anew += fenced.object.known() ? 0U : 1U;
            update(fenced.object, whole_history);
            EXPECT_TRUE(fenced.is_whole()) << byte << ' ' << bit;
            EXPECT_TRUE(fenced.object.known());
            EXPECT_FALSE(fenced.object.contradicts(false));
        }
    }
    EXPECT_GT(begun_anew, 50U);
}

// For any changed bit of its sums or its place: it goes on, and finds a change of the parameters.
TEST(ADamagedIndex, OfTheParameterGuardIsAWrongSumAtMost) {
    constexpr int two_passes = 10;
    rsi::Parameters parameters{};
    rsi::monitoring::ParameterGuard sound;
    sound.start(parameters);
    constexpr std::size_t without_flag = sizeof sound - sizeof(std::size_t);
    for (std::size_t byte = 0U; byte < without_flag; ++byte) {
        for (unsigned bit = 0U; bit < 8U; ++bit) {
            rsi_test::Fenced<rsi::Parameters> fenced;
            rsi::monitoring::ParameterGuard guard = sound;
            rsi_test::flip(guard, byte, bit);
            rsi_test::flip(fenced.object, 5U, 3U);
            bool found = false;
            for (int cycle = 0; cycle < two_passes; ++cycle) {
                found = guard.is_damaged(fenced.object);
            }
            EXPECT_TRUE(found) << byte << ' ' << bit;
            EXPECT_TRUE(fenced.is_whole());
        }
    }
}

}  // namespace
